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
expect(0 "To cell 2,2: cost 8.8.*\nTo cell 1,1: there is no path: cell 1,1 cannot be entered, as it has \
no data or an infinite friction; the nearest cell that can be is [01],[01], 2 away; --snap"
       ${PROGRAM} ring.asc -s 100.1,205.9 -t file:places.txt -o y)
expect_contents(y_paths.geojson "\"column\":1,\"row\":1,\"cost\":null},\"geometry\":null")
file(REMOVE ${folder}/places.txt)

# from the nearest cell to one that cannot be entered, and in a raster of one cell
expect(0 "The source cell 1,1 cannot be entered; moved by 2 to cell 0,1\n.*\n\
To cell 2,2: cost [0-9.]+, length [0-9.]+\n"
       ${PROGRAM} ring.asc -s cell:1,1 -t cell:2,2 -o k -b -c -i 1 --snap)
file(WRITE ${folder}/one.asc "ncols 1\nnrows 1\ncellsize 1\n1\n")
expect(0 "Largest cost: 0\nTo cell 0,0: cost 0, length 0\n" ${PROGRAM} one.asc -s cell:0,0 -t cell:0,0 -o
       l -b -c -i count:3 -e 0.1)

# what was read, with units and extents
expect(0 "ring.asc: friction, text; 1 cells without data .by the value -1.\n\
Map: no coordinate system; x from 100 to 106, y from 200 to 206\nCells: 2 by 2, in the unit of the map\n"
       ${PROGRAM} ring.asc -s cell:0,0 -o u -i 1)
expect_contents(u_isochrones.geojson "\"bbox\":.100,200,106,206.,\"units\":{\"cost\":\"\",\"length\":\"\"}")
expect(0 "Cells: 0.6096 m by 0.6096 m\n.*To cell 2,2: cost 2.69[0-9]*, length 2.08[0-9]* m\n" ${PROGRAM}
       ring.asc -s cell:0,0 -t cell:2,2 -o u --csv --unit ft --force)
expect_contents(u_paths.csv "^target,x,y,length .m.\n0,101,205,0\n")
expect_contents(u_paths.geojson "\"units\":{\"cost\":\"\",\"length\":\"m\"}")

# files of an earlier call do not stay beside those of this one
if(EXISTS ${folder}/u_isochrones.geojson)
  message(FATAL_ERROR "what the first call has written is still there")
endif()
expect(1 "--output: u_cost.asc is of an earlier call, .*--force removes it" ${PROGRAM} ring.npy
       --no-data -1 -s cell:0,0 -o u)
expect(0 "Written: u_cost.npy\n" ${PROGRAM} ring.npy --no-data -1 -s cell:0,0 -o u --force)
foreach(name u_cost.asc u_paths.geojson u_paths.csv)
  if(EXISTS ${folder}/${name})
    message(FATAL_ERROR "${name} is still there")
  endif()
endforeach()

file(WRITE ${folder}/u.png "a photograph\n")
expect(1 "--output: u.png exists, which this call does not write, and may be no file of an earlier" ${PROGRAM}
       ring.npy --no-data -1 -s cell:0,0 -o u --force)
expect_contents(u.png "^a photograph\n$")
file(REMOVE ${folder}/u.png)

# values that begin with letters, and are no names
file(WRITE ${folder}/nan_first.asc "NCOLS 3\nnrows 2\ncellsize 1\nNODATA_value nan\nnan 1 inf\n1 1 1\n")
expect(0 "4 cells reached in .*\nTo cell 2,1: cost 2," ${PROGRAM} nan_first.asc -s cell:0,1 -t cell:2,1 -o v)
file(WRITE ${folder}/inf_first.asc "ncols 3\nnrows 2\ncellsize 1\ninf 1 1\n1 1 1\n")
expect(0 "5 cells reached in .*\nTo cell 1,0: cost 1.41421," ${PROGRAM} inf_first.asc -s cell:0,1 -t
       cell:1,0 -o w)

# -9999.9, which is no float, stands for those that are nearest to it
execute_process(
  COMMAND sh -c [[LC_ALL=C sed 's/\x00\x00\x80\xbf/\x9a\x3f\x1c\xc6/' ring.npy >floats.npy]]
  WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
expect(0 "8 cells reached" ${PROGRAM} floats.npy --no-data -9999.9 -s cell:0,0 -o q)

# round the Earth
string(REPEAT "1 " 360 row)
string(REPEAT "${row}\n" 20 values)
file(WRITE ${folder}/earth.asc "ncols 360\nnrows 20\nxllcorner -180\nyllcorner -10\ncellsize 1\n${values}")
set(round earth.asc --degrees -s 179.5,0.5 -t 182.5,0.5 -b -i 500000)
expect(0 "the first column follows the last one\n.*To cell 2,9: cost 333946, length 333946 m\n" ${PROGRAM}
       ${round} -o e)
expect_contents(e_paths.geojson "{\"type\":\"MultiLineString\",\"coordinates\":...179.5,0.5.,.180,0.5..,\
..-180,0.5.,.-179.5,0.5.,.-178.5,0.5.,.-177.5,0.5...}")
expect_contents(e_isochrones.geojson ",.180,[-0-9.]+..,..-180,")
expect(0 "tiles, settled .*To cell 2,9: cost 333946, length 333946 m\n" ${PROGRAM} ${round} -o f -w work -m
       25M)
foreach(name cost.asc back_links.asc paths.geojson isochrones.geojson)
  expect_same(e_${name} f_${name})
endforeach()

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

  # borders at whole numbers, and cells that are smaller than 1
  file(WRITE ${folder}/half.asc "ncols 2\nnrows 2\ncellsize 0.5\n1 2\n3 4\n")
  expect(0 "half.png" ${PROGRAM} half.asc -s cell:0,0 -o half --picture)
endif()
