# What all figures have in common. `data` is what the names of the tables' files start with,
# `figure` that of the figures; `format` is svg or png.
set datafile separator comma
set datafile columnheaders
set datafile missing '-'
if (format eq 'svg') {
  set terminal svg size 800,500 background 'white' font 'sans,14' dynamic
} else {
  set terminal pngcairo size 1200,750 font 'sans,14' linewidth 1.5
}
set border 3 linecolor '#666666'
set tics nomirror
set grid linecolor '#cccccc'
set key outside right center reverse Left samplen 2
array color[9] = ['#d62728', '#7f7f7f', '#1f77b4', '#2ca02c', '#9467bd', '#ff7f0e', '#8c564b', \
                   '#e377c2', '#17becf']
set for [i = 1:9] linetype i linecolor rgb color[i] linewidth 2 pointtype (i == 2 ? 4 : 7) \
  pointsize 0.7
