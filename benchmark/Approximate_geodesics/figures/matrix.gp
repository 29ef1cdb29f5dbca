# Rows of a distance matrix that end early: time against what they reach.
load 'style.gp'
set output figure . 'matrix.' . format
set logscale xy
set xlabel 'distances per row'
set ylabel 'microseconds per row'
set format xy '10^{%L}'
set key inside left top
by_radius = data . 'matrix_radius.csv'
nearest = data . 'matrix_nearest.csv'
stats by_radius using 'entries/row':'us/row' nooutput prefix 'ALL'
plot by_radius using 'entries/row':'us/row' with linespoints linetype 3 title 'up to a radius', \
     nearest using 'entries/row':'us/row' with linespoints linetype 1 title 'the nearest', \
     [ALL_min_x:ALL_max_x] x * ALL_max_y / ALL_max_x with lines linetype 2 dashtype 2 \
       title 'in proportion'
