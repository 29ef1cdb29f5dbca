# Mean error against the time for one source, on the mesh `mesh`; labels say for which epsilon.
load 'style.gp'
set output figure . 'accuracy.' . format
set logscale xy
set xlabel 'milliseconds for one source'
set ylabel 'mean error'
set format x '%g'
set format y '%g %%'
set key inside right top
file = data . 'accuracy.csv'
set datafile missing NaN
ms(name) = strcol('mesh') eq mesh && strcol('method') eq name ? column('ms') : NaN
label = "sprintf('%g', column('epsilon'))"
# exact distances have no error, and so their places are infinitely far down
stats file using (ms('edges')) name 'edges' nooutput
stats file using (ms('exact class')) name 'class' nooutput
stats file using (ms('exact graph')) name 'graph' nooutput
set xrange [edges_min / 2:2 * class_max]
set yrange [0.005:10]
set arrow from class_max, graph 0.12 to class_max, graph 0 linewidth 2 linecolor rgb color[5]
set label 'exact class' at class_max, graph 0.15 center
set arrow from graph_max, graph 0.12 to graph_max, graph 0 linewidth 2 linecolor rgb color[6]
set label 'exact graph' at graph_max, graph 0.15 left
plot file using (ms('edges')):'mean %' with points linetype 2 pointsize 1.5 title 'edges', \
     file using (ms('built')):'mean %' with linespoints linetype 1 pointsize 1 \
       title 'built graph', \
     file using (ms('lazy')):'mean %' with linespoints linetype 3 pointsize 1 \
       title 'lazy graph', \
     file using (ms('heat')):'mean %' with points linetype 4 pointtype 9 pointsize 2 \
       title 'heat method', \
     for [name in 'built lazy'] file using (ms(name)):'mean %':(@label) with labels left \
       offset 0.7, 0.4 font ',11' notitle
