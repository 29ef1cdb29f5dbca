# Time per vertex of terrains of up to ten million vertices.
load 'style.gp'
set output figure . 'growth.' . format
set logscale x
set xlabel 'vertices'
set ylabel 'nanoseconds per vertex'
set format x '10^{%L}'
set autoscale xfix
set yrange [0:*]
set key inside left top
file = data . 'growth.csv'
plot file using 'vertices':'search ns/vertex' with linespoints linetype 1 title 'search', \
     file using 'vertices':'breadth first ns/vertex' with linespoints linetype 2 \
       title 'breadth first'
