# Growth of the number of comparisons with the size of the mesh: the publication's second figure.
load 'style.gp'
set output figure . 'comparisons.' . format
set logscale xy
set xlabel 'vertices'
set ylabel 'comparisons'
set format '10^{%L}'
file = data . 'table3.csv'
plot file using 'vertices':'E + V log2 V' with lines linetype 3 title 'E + V log_2 V', \
     file using 'vertices':'E + V' with lines linetype 2 title 'E + V', \
     file using 'vertices':'published' with points linetype 4 title 'published queue', \
     file using 'vertices':'ours' with points linetype 1 title 'this package'
