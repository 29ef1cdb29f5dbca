# Paths on surfaces: lengths, costs by slope in both directions, degrees, and all of that in tiles.
include(${CMAKE_CURRENT_LIST_DIR}/test_rasters.cmake)

# a ramp that climbs 10 m per 100 m, and a step of 50 m; cells without a height
file(WRITE ${folder}/ramp.asc "ncols 4\nnrows 1\ncellsize 100\n0 10 20 30\n")
file(WRITE ${folder}/step.asc "ncols 3\nnrows 2\ncellsize 100\nNODATA_value -1\n0 0 50\n-1 0 -1\n")
file(WRITE ${folder}/friction.asc "ncols 4\nnrows 1\ncellsize 100\n2 2 2 2\n")

# 90 rows of 120 cells, one of which has no height
string(REPEAT "30 42 61 55 40 22 " 20 low)
string(REPEAT "35 60 90 80 " 30 high)
string(REPEAT "${low}\n${high}\n${high}\n" 10 rows)
file(WRITE ${folder}/hills.asc
     "ncols 120\nnrows 90\nxllcorner 7\nyllcorner 45\ncellsize 0.001\n${rows}${rows}${rows}")
string(REPEAT "1 1 1 3 1 1 1 2 1 1 1 1 " 10 equal)
string(REPEAT "1 1 -1 1 1 1 " 20 blocked)
string(REPEAT "${equal}\n${equal}\n${blocked}\n" 30 rows)
file(WRITE ${folder}/woods.asc
     "ncols 120\nnrows 90\nxllcorner 7\nyllcorner 45\ncellsize 0.001\nNODATA_value -1\n${rows}")
# lengths on the surface
expect(0 "To cell 3,0: cost 301.496, length 301.496\n" ${PROGRAM} --heights ramp.asc -s cell:0,0 -t
       cell:3,0 -o a --csv)
expect_contents(a_paths.csv
                "^target,x,y,length,height\n0,50,50,0,0\n.*\n0,350,50,301.49[0-9]*,30\n$")
expect(0 "To cell 2,0: cost 211.803, length 211.803\n.*To cell 0,1: there is no path" ${PROGRAM}
       --heights step.asc -s cell:0,0 -t cell:2,0 cell:0,1 -o b)

# files of NumPy have no map, so that of the heights counts
file(WRITE ${folder}/flat.asc "ncols 3\nnrows 3\ncellsize 100\n5 5 5\n5 5 5\n5 5 5\n")
expect(0 "To cell 2,0: cost 200, length 200" ${PROGRAM} ring.npy --no-data -1 --heights flat.asc -s
       50,250 -t 250,250 -o n)

# by slope, up and down: 0.6 exp(3.5 |s + 0.05|) seconds per meter; friction multiplies
set(hike --heights ramp.asc --cost hiking_time -t cell:3,0)
expect(0 "To cell 3,0: cost 305.8 s, length 301.496 m" ${PROGRAM} ${hike} -s cell:0,0 -o c --csv
       -c)
expect(0 "To cell 3,0: cost 611.6 s, length 301.496 m" ${PROGRAM} friction.asc ${hike} -s cell:0,0
       -o d)
expect(0 "From cell 3,0: cost 215.494 s, length 301.496 m" ${PROGRAM} ${hike} -s cell:0,0 -o e
       --to-sources --csv -c)
expect_contents(c_paths.csv "\n0,50,50,0,0\n.*\n0,350,50,301.49[0-9]*,30\n$")
expect_contents(e_paths.csv "\n0,350,50,0,30\n.*\n0,50,50,301.49[0-9]*,0\n$")
expect_contents(c_corridor.asc "\n305.80[0-9]* 305.80[0-9]* 305.80[0-9]* 305.80[0-9]*\n$")
expect_contents(e_corridor.asc "\n215.49[0-9]* 215.49[0-9]* 215.49[0-9]* 215.49[0-9]*\n$")
expect(0 "cost 396 s," ${PROGRAM} --heights ramp.asc --cost naismith_time -s cell:0,0 -t cell:3,0 -o f)
expect(0 "cost 1477.07 J/kg," ${PROGRAM} --heights ramp.asc --cost walking_energy -s cell:0,0 -t
       cell:3,0 -o g)

# no slope is steeper than the limit: round a wall that is one cell wide, or not at all
file(WRITE ${folder}/wall.asc "ncols 5\nnrows 4\ncellsize 10\n0 0 50 0 0\n0 0 50 0 0\n0 0 50 0 0\n0 0 0 0 0\n")
set(walk --heights wall.asc -s cell:0,0 -t cell:4,0)
expect(0 "To cell 4,0: cost 73.0056, " ${PROGRAM} ${walk} -o l)
expect(0 "To cell 4,0: cost 83.2456, " ${PROGRAM} ${walk} --max-slope 0.6 -o l -f)
expect(0 "To cell 3,0: there is no path" ${PROGRAM} --heights ramp.asc --cost walking_energy
       --max-slope 0.09 -s cell:0,0 -t cell:3,0 -o l -f)
expect(0 "To cell 3,0: cost 301.496, length 301.496\n" ${PROGRAM} --heights ramp.asc --max-slope 0.1
       -s cell:0,0 -t cell:3,0 -o l -f)

# degrees: the same place to the west, and to the north
file(WRITE ${folder}/degrees.asc "ncols 2\nnrows 2\nxllcorner 7\nyllcorner 59\ncellsize 1\n1 1\n1 1\n")
expect(0 "To cell 1,0: cost 54955.9, length 54955.9 m\nTo cell 0,1: cost 111412, length 111412 m\n"
       ${PROGRAM} degrees.asc --degrees -s 7.5,60.5 -t 8.5,60.5 7.5,59.5 -o h)
expect(0 "To cell 1,0: cost 1," ${PROGRAM} degrees.asc -s 7.5,60.5 -t 8.5,60.5 -o i)
expect(0 "To cell 1,0: cost 5," ${PROGRAM} degrees.asc --degrees --cell-size 5 -s 7.5,60.5 -t
       8.5,60.5 -o j)
if(HAS_GDAL)
  configure_file(${folder}/degrees.asc ${folder}/degrees.grd COPYONLY)
  file(WRITE ${folder}/degrees.prj
       "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
       "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]\n")
  expect(0 "To cell 1,0: cost 54955.9" ${PROGRAM} degrees.grd -s 7.5,60.5 -t 8.5,60.5 -o k)
endif()

# in tiles
set(files cost.asc back_links.asc corridor.asc paths.geojson paths.csv isochrones.geojson)
set(call --degrees --cost hiking_time -s cell:3,5 -t cell:110,80 cell:50,40 -b -c -i count:3 --csv)
foreach(more "" "woods.asc;--to-sources")
  set(all --heights hills.asc ${call} ${more} --force)
  expect(0 "cells reached in [^,]*\n" ${PROGRAM} ${all} -o x)
  expect(0 " s, [0-9]+ tiles, settled" ${PROGRAM} ${all} -o y -w work -m 25M)
  foreach(name IN LISTS files)
    expect_same(x_${name} y_${name})
  endforeach()
endforeach()
if(EXISTS ${folder}/work)
  message(FATAL_ERROR "the work folder was not removed")
endif()

# another task in the work folder of one that was stopped
execute_process(
  COMMAND sh -c "\"$0\" \"$@\" & until [ -e work/targets/task ] || ! kill -0 $!
do sleep 0.01
done
kill -9 $!" ${PROGRAM} --heights hills.asc ${call} -o z -w work -m 25M
  WORKING_DIRECTORY ${folder} OUTPUT_QUIET ERROR_QUIET)
foreach(other "--to-sources" "--cost;naismith_time" "woods.asc")
  set(changed ${call})
  if(other MATCHES cost)
    list(REMOVE_ITEM changed --cost hiking_time)
  endif()
  expect(1 "work/sources has files of another task" ${PROGRAM} ${other} --heights hills.asc ${changed}
         -o z -w work)
endforeach()
expect(0 "Written" ${PROGRAM} --heights hills.asc ${call} -o z -w work -m 25M)

find_program(gnuplot gnuplot)
if(gnuplot)
  expect(0 "p.png" ${PROGRAM} --heights step.asc -s cell:0,0 -t cell:2,0 -o p --picture)
  expect_contents(p.png "PNG")
endif()

# what is refused
function(refuse text)
  expect(1 "^terrain_routes: ${text}[^\n]*\n$" ${PROGRAM} ${ARGN} -s cell:0,0 -o r)
endfunction()
refuse("--cost: flying is not length, hiking_time" --heights ramp.asc --cost flying)
refuse("--cost: hiking_time depends on the slope; it needs --heights" friction.asc --cost hiking_time)
refuse("--max-slope: it needs --heights" friction.asc --max-slope 0.3)
refuse("--max-slope: it is -1" --heights ramp.asc --max-slope -1)
refuse("--max-slope: .nan. is not a number" --heights ramp.asc --max-slope nan)
refuse("--epsilon: there is no bound with --heights" --heights ramp.asc -e 0.1)
refuse("--epsilon: there is no bound where coordinates are in degrees" degrees.asc --degrees -e 0.1)
refuse("--degrees: ring.npy does not tell where its cells are" ring.npy --degrees)
refuse("cannot read a raster from step.asc: it has 3 columns and 2 rows, and the raster of friction has 4"
       friction.asc --heights step.asc)
file(WRITE ${folder}/moved.asc "ncols 4\nnrows 1\nxllcorner 50\ncellsize 100\n0 10 20 30\n")
refuse("cannot read a raster from moved.asc: its cells are elsewhere on the map" friction.asc
       --heights moved.asc)
file(WRITE ${folder}/nan.asc "ncols 4\nnrows 1\ncellsize 100\n0 nan 20 30\n")
refuse("cannot read a raster from nan.asc: the height of cell 1,0 .column, row. is nan" --heights
       nan.asc)
file(WRITE ${folder}/poles.asc "ncols 4\nnrows 1\nyllcorner 91\ncellsize 1\n1 1 1 1\n")
refuse("[^\n]*latitudes go from 91 to 92; they must be from -90 to 90 degrees" poles.asc --degrees)
configure_file(${folder}/ramp.asc ${folder}/q_cost.asc COPYONLY)
expect(1 "--output: q_cost.asc is a file that is read" ${PROGRAM} --heights q_cost.asc -s cell:0,0 -o q
       -f)
