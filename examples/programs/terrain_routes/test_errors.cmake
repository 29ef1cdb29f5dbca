# What the user gets wrong is refused with the name of the argument and the reason, before anything is
# written.
include(${CMAKE_CURRENT_LIST_DIR}/test_rasters.cmake)

# Fails unless the program refuses its arguments with one line, which begins with the regular
# expression.
function(refuse text)
  expect(1 "^terrain_routes: ${text}[^\n]*\n$" ${PROGRAM} ${ARGN})
endfunction()

# Fails unless it refuses a raster of these lines.
function(refuse_raster text)
  list(JOIN ARGN "\n" lines)
  file(WRITE ${folder}/bad.asc "${lines}\n")
  refuse("cannot read a raster from bad.asc: ${text}" bad.asc -s cell:0,0)
  file(REMOVE ${folder}/bad.asc)
endfunction()

# options
refuse("no raster given" -s cell:0,0)
refuse("--sources: there must be at least one" ring.asc)
refuse("unrecognised option '--nonsense'" ring.asc --nonsense)
refuse("--epsilon: it must be above 0" ring.asc -s cell:0,0 -e 0)
refuse("--epsilon: it is -1" ring.asc -s cell:0,0 -e -1)
refuse("--corridor: it needs --targets" ring.asc -s cell:0,0 -c)
refuse("--csv: it is for the paths" ring.asc -s cell:0,0 --csv)
refuse("--isochrones: it is -1" ring.asc -s cell:0,0 -i -1)
refuse("--isochrones: count:20000: a number from 1 to 10000" ring.asc -s cell:0,0 -i count:20000)
refuse("--cell-size: 0: sizes must be finite numbers above 0" ring.asc -s cell:0,0 --cell-size 0)
refuse("--memory: it needs --work-folder" ring.asc -s cell:0,0 -m 1G)
refuse("--memory: 1K is not a size from 16M" ring.asc -s cell:0,0 -m 1K -w work)
refuse("--memory: it is too little; [0-9]+M are needed" ring.asc -s cell:0,0 -m 16M -w work)
file(REMOVE_RECURSE ${folder}/work)

refuse("--unit: ell is not m, km" ring.asc -s cell:0,0 --unit ell)
refuse("--unit: coordinates are in degrees" ring.asc -s cell:0,0 --unit ft --degrees)
refuse("--height-unit: it needs --heights" ring.asc -s cell:0,0 --height-unit ft)
refuse("--colors: gray is not uniform or rainbow" ring.asc -s cell:0,0 --colors gray)

# places
refuse("--sources: cell 1,1 cannot be entered, as it has no data or an infinite friction; the nearest cell \
that can be is 0,1, 2 away; --snap moves it there" ring.asc -s cell:1,1)
file(WRITE ${folder}/none.asc "ncols 2\nnrows 1\ncellsize 1\nNODATA_value -1\n-1 -1\n")
refuse("--sources: cell 0,0 cannot be entered, .*; nor can any other cell" none.asc -s cell:0,0 --snap)
file(REMOVE ${folder}/none.asc)
refuse("--sources: .one. is not x,y, cell:C,R or file:NAME" ring.asc -s one)
refuse("--sources: .1. is not x,y" ring.asc -s 1)
refuse("--sources: cell:0.5,0: column and row must be whole numbers" ring.asc -s cell:0.5,0)
refuse("--sources: cell:3,0 is not in the raster, which has 3 columns and 3 rows" ring.asc -s cell:3,0)
refuse("--targets: 99,203 is not in the raster, which has 3 columns and 3 rows, x from 100 to 106, and y \
from 200 to 206" ring.asc -s cell:0,0 -t 99,203)
file(WRITE ${folder}/nowhere.txt "# none yet\n")
refuse("--sources: there must be at least one" ring.asc -s file:nowhere.txt)
refuse("--targets: there must be at least one" ring.asc -s cell:0,0 -t file:nowhere.txt)
file(REMOVE ${folder}/nowhere.txt)
refuse("--targets missing.txt: cannot read missing.txt: No such file" ring.asc -s cell:0,0 -t
       file:missing.txt)

# rasters
refuse("cannot read missing.asc: No such file or directory" missing.asc -s cell:0,0)
file(MAKE_DIRECTORY ${folder}/folder.asc)
refuse("cannot read folder.asc: it is a folder" folder.asc -s cell:0,0)
file(REMOVE_RECURSE ${folder}/folder.asc)
refuse_raster("its header has no ncols" "nrows 2")
refuse_raster("its header has no cellsize" "ncols 2" "nrows 2" "1 1 1 1")
refuse_raster("ncols is not a number of cells" "ncols 0" "nrows 2" "cellsize 1")
refuse_raster("ncols: .two. is not a number" "ncols two" "nrows 2" "cellsize 1")
refuse_raster("its cells have no size above 0" "ncols 1" "nrows 1" "cellsize 0" "1")
refuse_raster("it ends in row 1 of 2" "ncols 2" "nrows 2" "cellsize 1" "1 1" "1")
refuse_raster("it has more values than cells" "ncols 2" "nrows 1" "cellsize 1" "1 1" "1")
refuse_raster("it has too many cells: 3000000000 columns and 3000000000 rows" "ncols 3000000000"
              "nrows 3000000000" "cellsize 1" "1")
refuse_raster("row 0: .nonsense. is not a number" "ncols 2" "nrows 1" "cellsize 1" "nonsense 1")
refuse_raster("row 0: .x. is not a number" "ncols 2" "nrows 1" "cellsize 1" "1 x")
refuse_raster("the cost of cell 1,0 .column, row. is nan" "ncols 2" "nrows 1" "cellsize 1" "1 nan")
refuse_raster("the cost of cell 0,0 .column, row. is -2" "ncols 2" "nrows 1" "cellsize 1" "-2 1")
refuse("cannot read a raster from ring.npy: the cost of cell 1,1 .column, row. is -1" ring.npy -s cell:0,0
       --no-data NAN)
refuse("cannot read a raster from ring.asc: it has no bands that could be chosen" ring.asc -s cell:0,0
       --band 2)
file(WRITE ${folder}/bad.npy "text")
refuse("cannot read a raster from bad.npy: it is no NPY file" bad.npy -s cell:0,0)
execute_process(COMMAND sh -c "head -c 150 ring.npy >bad.npy" WORKING_DIRECTORY ${folder})
refuse("cannot read a raster from bad.npy: it has 150 bytes in place of 164" bad.npy -s cell:0,0)
execute_process(COMMAND sh -c "sed 's/(3, 3)/(9,  )/' ring.npy >bad.npy" WORKING_DIRECTORY ${folder})
refuse("cannot read a raster from bad.npy: it must be an array .* two dimensions" bad.npy -s cell:0,0)
execute_process(COMMAND sh -c "sed 's/False/True /' ring.npy >bad.npy" WORKING_DIRECTORY ${folder})
refuse("cannot read a raster from bad.npy: it holds columns" bad.npy -s cell:0,0)
foreach(rows 0 99999999999999999999 4294967296)
  execute_process(COMMAND sh -c "sed 's/(3, 3)/(${rows}, ${rows})/' ring.npy >bad.npy"
                  WORKING_DIRECTORY ${folder})
  refuse("cannot read a raster from bad.npy: it has (no|too many) cells" bad.npy -s cell:0,0)
endforeach()
file(REMOVE ${folder}/bad.npy)
# a header that promises more values than come takes no memory for them
file(WRITE ${folder}/bad.asc "ncols 4000000000\nnrows 1\ncellsize 1\n1 1\n")
refuse("(cannot read a raster from bad.asc: it ends in row 0 of 1|.*memory cannot be mapped)" bad.asc -s
       cell:0,0)
file(REMOVE ${folder}/bad.asc)
file(WRITE ${folder}/text.dat "text")
if(HAS_GDAL)
  refuse("cannot read a raster from text.dat: .*not recognized" text.dat -s cell:0,0)
  configure_file(${folder}/ring.asc ${folder}/ring.grd COPYONLY)
  refuse("cannot read a raster from ring.grd: it has 1 bands, and no band 2" ring.grd -s cell:0,0
         --band 2)
  file(REMOVE ${folder}/ring.grd)
else()
  refuse("cannot read a raster from text.dat: .* compiled without GDAL" text.dat -s cell:0,0)
endif()
file(REMOVE ${folder}/text.dat)
expect_files(${rasters})
