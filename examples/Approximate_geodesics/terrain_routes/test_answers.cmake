# Rasters in all formats, and what is written about them.
include(${CMAKE_CURRENT_LIST_DIR}/test_rasters.cmake)

expect(0 "^Usage: terrain_routes .RASTER" ${PROGRAM} --help)

# round the cell that cannot be entered
expect(0 "3 columns, 3 rows; 8 cells reached in .*\nLargest cost: 8.82843\n\
To cell 2,2: cost 8.82843, length 6.82843\n"
       ${PROGRAM} ring.asc -s cell:0,0 -t cell:2,2 -o x --csv -b -c -i 1 5)
expect_files(${rasters} x_cost.asc x_back_links.asc x_corridor.asc x_paths.geojson x_paths.csv
             x_isochrones.geojson)
expect_contents(x_cost.asc "^ncols 3\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 2\n\
NODATA_value -9999\n0 2 4\n2 -9999 4.8284[0-9]*\n4 4.8284[0-9]* 8.8284[0-9]*\n$")
expect_contents(x_corridor.asc "\n8.8[0-9]* 8.8[0-9]* 10\n8.8[0-9]* -9999 8.8[0-9]*\n10 8.8")
expect_contents(x_back_links.asc "NODATA_value -9999\n-9999 270 270\n0 -9999 315\n0 315 0\n$")
expect_contents(x_paths.csv "^target,x,y,length\n0,101,205,0\n0,103,205,2\n0,105,203,4.8284[0-9]*\n\
0,105,201,6.8284[0-9]*\n$") # of two paths, the upper one
expect_contents(x_paths.geojson "\"target\":0,\"column\":2,\"row\":2,\"cost\":8.8[0-9]*,\"length\":6.8\
[0-9]*},\"geometry\":{\"type\":\"LineString\",\"coordinates\":.*101,205.,.103,205.,.105,203.,.105,201")

# places on the map, and in files
file(WRITE ${folder}/places.txt "# where to go\n105.9,200.1\ncell:1,1 # cannot be entered\n")
expect(0 "To cell 2,2: cost 8.8.*\nTo cell 1,1: there is no path\n" ${PROGRAM} ring.asc -s
       100.1,205.9 -t file:places.txt -o y)
expect_contents(y_paths.geojson "\"column\":1,\"row\":1,\"cost\":null},\"geometry\":null")
file(REMOVE ${folder}/places.txt)

# from a cell that cannot be entered, and in a raster of one cell, and of none that can be entered
expect(0 "1 cells reached in .*\nLargest cost: 0\nTo cell 2,2: there is no path\n" ${PROGRAM} ring.asc
       -s cell:1,1 -t cell:2,2 -o k -b -c -i 1)
file(WRITE ${folder}/one.asc "ncols 1\nnrows 1\ncellsize 1\n1\n")
expect(0 "Largest cost: 0\nTo cell 0,0: cost 0, length 0\n" ${PROGRAM} one.asc -s cell:0,0 -t cell:0,0 -o
       l -b -c -i count:3 -e 0.1)
file(WRITE ${folder}/none.asc "ncols 2\nnrows 1\ncellsize 1\nNODATA_value -1\n-1 -1\n")
expect(0 "1 cells reached in .*\nLargest cost: 0\n" ${PROGRAM} none.asc -s cell:0,0 -o l -f)

# with a bound, paths bend at sides
expect(0 "To cell 2,2: cost 8.4" ${PROGRAM} ring.asc -s cell:0,0 -t cell:2,2 -o z -e 0.1 -b)

# NumPy's format, without a map
expect(0 "Largest cost: 4.41421\nTo cell 2,2: cost 4.41421, length 3.41421\n" ${PROGRAM} ring.npy --no-data -1 -s
       0.5,0.5 -t 2.5,2.5 -o n)
expect(0 "Largest cost: [1-9]" ${PROGRAM} n_cost.npy --no-data inf -s cell:0,0 -o m --cell-size 2,2)

# lines of equal costs: half way between the sources
file(WRITE ${folder}/strip.asc "ncols 5\nnrows 2\ncellsize 1\n1 1 1 1 1\n1 1 1 1 1\n")
expect(0 "Largest cost: 4.*" ${PROGRAM} strip.asc -s cell:0,0 cell:0,1 -o s -i 1.5 3)
expect_contents(s_isochrones.geojson "\"cost\":1.5},\"geometry\":{\"type\":\"MultiLineString\",\
\"coordinates\":...2,1.5.,.2,0.5.*\"cost\":3}.*3.5,1.5.,.3.5,0.5")

# by GDAL, which knows rasters by their contents; and what it has written
if(HAS_GDAL)
  configure_file(${folder}/ring.asc ${folder}/ring.grd COPYONLY)
  expect(0 "cost 8.8.*g_cost.tif" ${PROGRAM} ring.grd -s cell:0,0 -t 105,201 -o g -b)
  expect(0 "8 cells reached in .*\nLargest cost: [0-9]" ${PROGRAM} g_cost.tif -s 101,205 -t 105,201 -o h)
  expect_contents(h_paths.geojson "105,201")
endif()

find_program(gnuplot gnuplot)
if(gnuplot)
  expect(0 "p.png" ${PROGRAM} ring.asc -s cell:0,0 -t cell:2,2 -o p --picture)
  expect_contents(p.png "PNG")
endif()
