# What a fixed width of the buckets costs, compared with the adaptive one.
load 'style.gp'
set output figure . 'widths.' . format
set logscale xy
set xlabel 'width of the buckets, in mean lengths of an edge'
set ylabel 'time, in that with the adaptive width'
set xtics ('1/64' 1. / 64, '1/16' 1. / 16, '1/4' 0.25, '1' 1, '4' 4, '16' 16)
set ytics (0.8, 1, 1.5, 2, 3, 4, 6)
set xrange [1. / 90:24]
set yrange [0.8:*]
file = data . 'widths.csv'
meshes = system("tail -n +2 '" . file . "' | cut -d, -f1 | uniq | sed 's/.*/\"&\"/' | tr '\\n' ' '")
row(mesh, kind, value) = strcol('mesh') eq mesh && strcol('kind') eq kind ? value : NaN
set datafile missing NaN
plot for [i = 1:words(meshes)] file \
       using (row(word(meshes, i), 'fixed', column('width'))):(column('this : adaptive')) \
       with linespoints linetype i title word(meshes, i) noenhanced, \
     for [i = 1:words(meshes)] file \
       using (row(word(meshes, i), 'adaptive', column('width'))):(column('this : adaptive')) \
       with points linetype i pointtype 2 pointsize 2 notitle, \
     keyentry with points linetype 2 pointtype 2 pointsize 2 title 'adaptive'
