# Errors of points on edges against the number of nodes: on a scan, on a mesh with needles among its
# faces, and on a terrain with weights. Labels say how many points there are per edge, or for which
# epsilon.
load 'style.gp'
set output figure . 'steiner.' . format
set logscale xy
set xlabel 'nodes per vertex'
set format x '%g'
set format y '%g %%'
set xrange [2:10000]
set yrange [0.002:50]
set datafile missing NaN
of(name, points, y) = strcol('mesh') eq name && strcol('points') eq points && \
  column('parameter') > 0 ? column(y) : NaN
spaced(y) = of(name, 'equally spaced', y)
geometric(y) = of(name, 'geometric', y)
label = "sprintf('%g', column('parameter'))"
set multiplot layout 1, 3 margins 0.09, 0.985, 0.11, 0.93 spacing 0.02, 0
set ylabel 'error' offset 0.5, 0
do for [name in 'elephant anchor terrain'] {
  file = data . (name eq 'terrain' ? 'steiner_weighted.csv' : 'steiner_convergence.csv')
  set title name . (name eq 'elephant' ? ' (a scan)' : name eq 'anchor' ? ' (with needles)' : \
    ' (with weights)')
  if (name eq 'anchor') {
    unset ylabel
    set format y ''
  }
  if (name eq 'terrain') { set key inside right top font ',12' } else { unset key }
  plot file using 'nodes/vertex':(spaced('mean %')) with linespoints linetype 1 \
         title 'equally spaced, mean', \
       file using 'nodes/vertex':(spaced('largest %')) with linespoints linetype 1 dashtype 3 \
         title 'equally spaced, largest', \
       file using 'nodes/vertex':(geometric('mean %')) with linespoints linetype 3 \
         title 'geometric, mean', \
       file using 'nodes/vertex':(geometric('largest %')) with linespoints linetype 3 dashtype 3 \
         title 'geometric, largest', \
       [6:110] 20. / x**2 with lines linetype 2 title 'slope -2', \
       file using 'nodes/vertex':(spaced('mean %')):(@label) with labels right \
         offset -0.7, -0.4 font ',10' textcolor linetype 1 notitle, \
       file using 'nodes/vertex':(geometric('mean %')):(@label) with labels left \
         offset 0.7, 0.4 font ',10' textcolor linetype 3 notitle
}
unset multiplot
