# Draws shaded heights or friction, isochrones and paths on a raster. terrain_routes calls it, with
# these variables:
#   picture                    the PNG file to write
#   background, columns, rows  the name of a file of colors, three bytes each, and their number
#   isochrones                 the name of a file of lines with x, y and cost
#   routes                     the name of a file of lines with x and y
#   largest                    the largest cost
#   x_min, x_max, y_min, y_max   the borders of the map
#   source                     where costs are from, or to
#   downward                   whether y grows from the first row to the last
#   ratio                      of the height of the map to its width
set terminal pngcairo size (ratio > 1 ? 1100 / ratio + 350 : 1450), \
             (ratio > 1 ? 1230 : 1100 * ratio + 130) font 'sans,15'
set output picture
set size ratio ratio
set xrange [x_min:x_max]
set yrange [(downward ? y_max : y_min):(downward ? y_min : y_max)]
set tics out nomirror
set format '%.7g'
x_tics = (x_max - x_min) / 4
y_tics = (y_max - y_min) / 4
set xtics x_min, x_tics
set ytics y_min, y_tics
unset key
set format cb '%g'
set cblabel 'cost '.source offset 1.5
set rmargin 4
set cbrange [0:(largest > 0 ? largest : 1)]
set palette defined (0 '#2a4bec', 0.25 '#1ab8e6', 0.5 '#5cd15c', 0.75 '#ffd62e', 1 '#e6291f')
x_step = (x_max - x_min) / columns
y_step = (y_max - y_min) / rows
plot background binary array=(columns, rows) format='%uchar%uchar%uchar' \
       origin=(x_min + x_step / 2, y_min + y_step / 2) dx=x_step dy=y_step using 1:2:3 with rgbimage, \
     isochrones using 1:2:3 with lines linewidth 2 linecolor palette, \
     routes using 1:2 with lines linewidth 7 linecolor rgb 'black', \
     routes using 1:2 with lines linewidth 4 linecolor rgb 'white'
