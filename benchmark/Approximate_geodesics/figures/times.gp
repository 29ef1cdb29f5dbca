# Time for one source, per vertex, against the size of the mesh, for all queues.
load 'style.gp'
set output figure . 'times.' . format
set logscale xy
set xlabel 'vertices'
set ylabel 'nanoseconds per vertex'
set format x '10^{%L}'
set yrange [10:*]
file = data . 'queues.csv'
names = '"array" "pairing heap" "Fibonacci heap" "Boost on the mesh" "std::priority_queue" ' . \
        '"binary heap" "radix heap" "4-ary heap" "published buckets" "adaptive buckets" ' . \
        '"breadth first"'
type_of(i) = i == 10 ? 1 : i == 11 ? 2 : 3 + (i - 1) % 7
dash_of(i) = i > 7 && i < 10 ? 2 : 1
plot for [i = 1:words(names)] file \
  using (column('vertices')):(column(word(names, i)) * 1e6 / column('vertices')) \
  with linespoints linetype type_of(i) dashtype dash_of(i) title word(names, i) noenhanced
