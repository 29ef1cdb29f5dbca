# Errors of distances on a grid of equal cells by direction, as distances from the middle: of steps to
# 8 and 16 neighbors, and of lines; and the latter enlarged.
load 'style.gp'
if (format eq 'svg') {
  set terminal svg size 800,440 background 'white' font 'sans,15' dynamic
} else {
  set terminal pngcairo size 1200,660 font 'sans,15' linewidth 1.5
}
set output figure . 'grid_directions.' . format
set datafile missing NaN
file = data . 'grid_circle.csv'
set polar
set angles degrees
set size square
unset border
unset raxis
unset xtics
unset ytics
unset key
set grid polar 45 linetype 1 linewidth 0.7 linecolor '#cccccc'
set rtics scale 0 font ',12' textcolor '#666666'
# the other octants are symmetric
angle(octant) = octant % 2 == 0 ? 45 * octant + column('degrees') : \
  45 * (octant + 1) - column('degrees')
error(name) = strcol('graph') eq name ? column('error %') : NaN
LINES = 1
STEPS_8 = 3
STEPS_16 = 6
set multiplot layout 1, 2 margins 0.02, 0.98, 0.04, 0.88 spacing 0.04, 0
set title '8 and 16 directions, and lines' offset 0, -0.5
set rrange [0:9]
set rtics 3, 3, 9 format '%g %%'
set label 1 '8 directions' at first 4.6, first 8 left textcolor linetype STEPS_8
set label 2 '16' at first 2.9, first 2 left textcolor linetype STEPS_16
set label 3 'lines, in the middle' at first -9, first -8.5 left textcolor linetype LINES
plot for [octant = 0:7] file every 2 using (angle(octant)):(error('8 directions')) with lines \
       linetype STEPS_8, \
     for [octant = 0:7] file every 2 using (angle(octant)):(error('16 directions')) with lines \
       linetype STEPS_16, \
     for [octant = 0:7] file every 2 using (angle(octant)):(error('lines')) with lines linetype LINES
unset label
set title 'lines, enlarged 30 times'
set rrange [0:0.3]
set rtics 0.1, 0.1, 0.3
plot for [octant = 0:7] file using (angle(octant)):(error('lines')) with lines linetype LINES
unset multiplot
