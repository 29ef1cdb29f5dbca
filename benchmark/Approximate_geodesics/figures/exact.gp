# Exact distances: time per vertex, and sights per vertex, against the size of the mesh.
load 'style.gp'
set output figure . 'exact.' . format
set logscale xyy2
set border 11
set xlabel 'vertices'
set ylabel 'microseconds per vertex'
set y2label 'sights per vertex'
set y2tics
set format x '10^{%L}'
set autoscale xfix
set key inside left top
file = data . 'exact_growth.csv'
set datafile missing NaN
of(surface, name) = strcol('surface') eq surface ? column(name) : NaN
surfaces = 'smooth terrain rough subdivided'
plot for [i = 1:words(surfaces)] file \
       using 'vertices':(of(word(surfaces, i), 'us/vertex')) \
       with linespoints linetype i title word(surfaces, i) . ', time', \
     for [i = 1:words(surfaces)] file \
       using 'vertices':(of(word(surfaces, i), 'sights/vertex')) axes x1y2 \
       with linespoints linetype i dashtype 2 title word(surfaces, i) . ', sights'
