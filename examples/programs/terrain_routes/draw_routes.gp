# Draws shaded heights or friction, isochrones and paths on a raster. terrain_routes calls it, with
# these variables:
#   picture                    the PNG file to write
#   background, columns, rows  the name of a file of colors, three bytes each, and their number
#   isochrones                 the name of a file of lines with x, y and cost
#   routes                     the name of a file of lines with x and y
#   sources, targets           the names of files of points with x and y
#   has_isochrones, has_routes, has_targets   whether there are such lines and points
#   colors                     uniform or rainbow
#   largest                    the largest cost
#   x_min, x_max, y_min, y_max   the borders of the map
#   x_label, y_label, cost_label   what axes show
#   downward                   whether y grows from the first row to the last
#   ratio                      of the height of the map to its width
# Numbers without a decimal point are integers, and gnuplot would round their quotients.
x_min = real(x_min)
x_max = real(x_max)
y_min = real(y_min)
y_max = real(y_max)
ratio = real(ratio)
set terminal pngcairo size (ratio > 1 ? 1100 / ratio + 400 : 1500), \
             (ratio > 1 ? 1300 : 1100 * ratio + 200) font 'sans,15'
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
set xlabel x_label
set ylabel y_label
set key above horizontal samplen 2 opaque fillcolor rgb '#b8b8b8'
set format cb '%g'
set cblabel cost_label offset 1.5
set rmargin (ratio > 1 ? 4 : 16)
set cbrange [0:(largest > 0 ? largest : 1)]
# blue to yellow through green: equal steps in OKLab, from dark to light
if(colors eq 'rainbow') {
  set palette defined (0 '#2a4bec', 0.25 '#1ab8e6', 0.5 '#5cd15c', 0.75 '#ffd62e', 1 '#e6291f')
} else {
  set palette defined (0 '#2d1076', 1 '#183992', 2 '#0d5c8d', 3 '#157d93', 4 '#1c9d97', \
                       5 '#24bc8b', 6 '#7dd06f', 7 '#cbdc5a', 8 '#fee483')
}
x_step = (x_max - x_min) / columns
y_step = (y_max - y_min) / rows
# parts for which there may be no points
draw_isochrones = has_isochrones ? "isochrones using 1:2 with lines linewidth 4 linecolor rgb '#a0000000' notitle, \
  isochrones using 1:2:3 with lines linewidth 2 linecolor palette notitle," : ""
draw_routes = has_routes ? "routes using 1:2 with lines linewidth 7 linecolor rgb 'black' notitle, \
  routes using 1:2 with lines linewidth 4 linecolor rgb 'white' title 'cheapest path'," : ""
draw_targets = has_targets ? "targets using 1:2 with points pointtype 13 pointsize 3.2 linecolor rgb 'black' notitle, \
  targets using 1:2 with points pointtype 13 pointsize 2.2 linecolor rgb 'white' title 'target'," : ""
plot background binary array=(columns, rows) format='%uchar%uchar%uchar' \
       origin=(x_min + x_step / 2, y_min + y_step / 2) dx=x_step dy=y_step using 1:2:3 \
       with rgbimage notitle, \
     @draw_isochrones @draw_routes @draw_targets \
     sources using 1:2 with points pointtype 7 pointsize 3 linecolor rgb 'black' notitle, \
     sources using 1:2 with points pointtype 7 pointsize 2.2 linecolor rgb '#e6291f' title 'source'
