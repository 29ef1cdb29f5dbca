# How many buckets hold how many vertices, on the mesh `mesh`.
load 'style.gp'
set output figure . 'occupancy.' . format
set xlabel 'vertices in the bucket'
set ylabel 'buckets'
set logscale x 2
set key inside right top
set style fill solid 0.7
file = data . 'histogram.csv'
least = 'least vertices'
number(queue) = strcol('mesh') eq mesh && strcol('queue') eq queue ? column('buckets') : NaN
# classes double from one to the next, and the bars of the two queues stand side by side
plot file using (column(least) * 1.2):(number('published')):(column(least) * 0.35) \
       with boxes linetype 4 title 'published queue', \
     file using (column(least) * 1.65):(number('adaptive')):(column(least) * 0.45) \
       with boxes linetype 1 title 'this package'
