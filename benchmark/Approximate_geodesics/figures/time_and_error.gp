# Mean error against the time of an answer, for all graphs and for CGAL's classes. Small numbers are
# bounds, or numbers of points per edge.
load 'style.gp'
if (format eq 'svg') {
  set terminal svg size 800,900 font 'sans,16'
} else {
  set terminal pngcairo size 1200,1350 font 'sans,16'
}
set output figure . 'time_and_error.' . format
set logscale xy
set format x '%g'
set format y '%g %%'
set xtics 10
set ytics 10
set xrange [0.5:20000]
set yrange [0.0008:12]
unset key
file = data . 'time_and_error.csv'
set datafile missing NaN
OURS = 1 # types of lines
PEERS = 3
STORED = 6
POINTS = 4
of(name, what) = strcol('method') eq name ? column(what) : NaN
# what is found in the last row of a method
found(name, what) = real(system(sprintf("awk -F, 'NR == 1 { for(i = 1; i <= NF; ++i) c[$i] = i } " . \
  "$1 == \"%s\" { x = $c[\"%s\"] } END { print x + 0 }' '%s'", name, what, file)))

set multiplot layout 2, 1 margins 0.14, 0.985, 0.08, 0.95 spacing 0, 0.11
set ylabel 'mean error' offset 1, 0
do for [panel = 1:2] {
  ms = panel == 1 ? 'first ms' : 'further ms'
  set title (panel == 1 ? 'first answer, everything included' : 'each further source') \
    offset 0, -0.6
  if (panel == 1) {
    unset xlabel
  } else {
    set xlabel 'milliseconds'
  }
  unset label
  unset arrow
  # exact distances have no error, and so their places are infinitely far down
  do for [name in '"exact" "exact class"'] {
    set arrow from found(name, ms), graph 0.09 to found(name, ms), graph 0 linewidth 2 \
      linecolor rgb color[name eq 'exact' ? OURS : PEERS]
  }
  set label 'exact' at found('exact', ms), graph 0.05 left offset 0.8, 0 textcolor linetype OURS
  set label "CGAL's\nexact class" at found('exact class', ms), graph 0.2 center \
    textcolor linetype PEERS
  set label 'along edges' at found('edges', ms), found('edges', 'mean %') left offset 0.8, 0.5 \
    textcolor linetype OURS
  if (panel == 1) {
    set label 'heat method' at found('heat', ms), found('heat', 'mean %') left offset 0.8, 0.5 \
      textcolor linetype PEERS
  } else {
    set label 'heat method' at found('heat', ms), found('heat', 'mean %') right offset -0.8, -0.4 \
      textcolor linetype PEERS
  }
  set label 'points on edges' at found('points', ms), found('points', 'mean %') left \
    offset 0.8, 0.3 textcolor linetype POINTS
  if (panel == 1) {
    set label 'epsilon' at found('lazy', ms), 0.013 left offset 0.8, 0 textcolor linetype OURS
  } else {
    set label 'epsilon, lazy graph' at found('lazy', ms), 0.013 left offset -1.5, 0 \
      textcolor linetype OURS
    set label "epsilon,\nbuilt graph" at found('built', ms), 0.013 right offset -1, -1 \
      textcolor linetype STORED
  }
  shown = panel == 1 ? 'lazy' : 'built lazy'
  type(name) = name eq 'built' ? STORED : OURS
  plot file using (of('edges', ms)):'mean %' with points linetype OURS pointsize 1, \
       file using (of('heat', ms)):'mean %' with points linetype PEERS pointsize 1, \
       file using (of('points', ms)):'mean %' with linespoints linetype POINTS, \
       file using (of('points', ms)):'mean %':(sprintf('%g', column('parameter'))) with labels \
         right offset -0.6, -0.3 font ',13' textcolor linetype POINTS, \
       for [name in shown] file using (of(name, ms)):'mean %' with linespoints \
         linetype type(name), \
       for [name in shown] file using (of(name, ms)):'mean %':(sprintf('%g', column('parameter'))) \
         with labels right offset -0.6, -0.3 font ',13' textcolor linetype type(name)
}
unset multiplot
