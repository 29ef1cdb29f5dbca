# Errors of points on edges against the number of nodes: on a scan, on a mesh with needles among its
# faces, and on a terrain with weights. Labels say how many points there are per edge, or for which
# epsilon; the panel in the middle has the names of all curves.
load 'style.gp'
if (format eq 'svg') {
  set terminal svg size 800,640 font 'sans,15'
} else {
  set terminal pngcairo size 1200,960 font 'sans,15'
}
set output figure . 'steiner.' . format
set logscale xy
set xlabel 'nodes per vertex'
set format x '%g'
set format y '%g %%'
set xrange [2:10000]
set xtics ('10' 10, '100' 100, '1000' 1000)
unset key
set yrange [0.002:50]
set datafile missing NaN
of(name, points, y) = strcol('mesh') eq name && strcol('points') eq points && \
  column('parameter') > 0 ? column(y) : NaN
spaced(y) = of(name, 'equally spaced', y)
geometric(y) = of(name, 'geometric', y)
label = "sprintf('%g', column('parameter'))"
set multiplot layout 1, 3 margins 0.12, 0.985, 0.11, 0.92 spacing 0.02, 0
set ylabel 'error' offset 2, 0
do for [name in 'elephant anchor terrain'] {
  file = data . (name eq 'terrain' ? 'steiner_weighted.csv' : 'steiner_convergence.csv')
  set title name . (name eq 'elephant' ? ' (a scan)' : name eq 'anchor' ? ' (with needles)' : \
    ' (with weights)')
  if (name eq 'anchor') { # which leaves room between the curves
    unset ylabel
    set format y ''
    set label 1 "equally spaced,\nlargest" at 40, 26 left font ',14' textcolor linetype 1
    set label 2 'mean' at 18, 0.9 right font ',14' textcolor linetype 1
    set label 3 "geometric,\nlargest" at 350, 5 left font ',14' textcolor linetype 3
    set label 4 'mean' at 1000, 0.015 right font ',14' textcolor linetype 3
    set label 5 'slope -2' at 28, 0.04 left font ',14' textcolor linetype 2
  } else {
    unset label
  }
  plot file using 'nodes/vertex':(spaced('mean %')) with linespoints linetype 1, \
       file using 'nodes/vertex':(spaced('largest %')) with lines linetype 1 dashtype 3, \
       file using 'nodes/vertex':(geometric('mean %')) with linespoints linetype 3, \
       file using 'nodes/vertex':(geometric('largest %')) with lines linetype 3 dashtype 3, \
       [6:110] 20. / x**2 with lines linetype 2, \
       file using 'nodes/vertex':(spaced('mean %')):(@label) with labels right \
         offset -0.7, -0.4 font ',13' textcolor linetype 1, \
       file using 'nodes/vertex':(geometric('mean %')):(@label) with labels left \
         offset 0.7, 0.4 font ',13' textcolor linetype 3
}
unset multiplot
