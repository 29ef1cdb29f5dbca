# A call writes all of its files, or leaves everything as it was.
include(${CMAKE_CURRENT_LIST_DIR}/test_rasters.cmake)

# Runs a line of the shell, in which $0 is the program.
function(expect_line code text line)
  expect(${code} "${text}" sh -c "${line}" ${PROGRAM})
endfunction()

set(outputs x_cost.asc x_back_links.asc x_paths.geojson x_isochrones.geojson)
set(call "large.asc -s cell:0,0 -t cell:299,299 -o x -b -i count:3")

# files that cannot become longer, as if the disk was full: the first one, or a later one
# after lines of progress on a slow machine
set(fails "(^|\n)terrain_routes: cannot write x_[^:]*: File too large\n$")
foreach(blocks 0 1 1000 3300)
  expect_line(1 "${fails}" "ulimit -f ${blocks} && \"$0\" ${call} 2>&1 >/dev/null")
  expect_files(${rasters})
endforeach()

# what was there stays, to the byte
foreach(name IN LISTS outputs)
  file(WRITE ${folder}/${name} "the old ${name}\n")
endforeach()
expect_line(1 "${fails}" "ulimit -f 1000 && \"$0\" ${call} --force 2>&1 >/dev/null")
expect_line(1 "--output: x_cost.asc exists; --force replaces it\n$" "\"$0\" ${call}")
expect_files(${rasters} ${outputs})
foreach(name IN LISTS outputs)
  expect_contents(${name} "^the old ${name}\n$")
endforeach()
expect_line(0 "Written: x_cost.asc" "\"$0\" ${call} --force")
expect_files(${rasters} ${outputs})
expect_contents(x_cost.asc "^ncols 300\n")

# what is read, and what cannot be written
configure_file(${folder}/ring.asc ${folder}/y_cost.asc COPYONLY)
expect_line(1 "--output: y_cost.asc is a file that is read" "\"$0\" y_cost.asc -s cell:0,0 -o y -f")
file(REMOVE ${folder}/y_cost.asc)
expect_line(1 "cannot write missing/y_cost.asc: No such file" "\"$0\" ring.asc -s cell:0,0 -o missing/y")
expect_line(1 "is no name that files can begin with" "\"$0\" ring.asc -s cell:0,0 -o ./")
file(CREATE_LINK /dev/full ${folder}/full_cost.asc SYMBOLIC)
expect_line(1 "cannot write full_cost.asc: No space left on device"
            "\"$0\" large.asc -s cell:0,0 -o full --force")
file(REMOVE ${folder}/full_cost.asc)
if(HAS_GDAL)
  configure_file(${folder}/large.asc ${folder}/large.grd COPYONLY)
  expect_line(1 "cannot write t_cost.tif: " "ulimit -f 100 && \"$0\" large.grd -s cell:0,0 -o t")
  file(REMOVE ${folder}/large.grd)
endif()
expect_files(${rasters} ${outputs})
