# Searches that are kept in files have the answers of those in memory, and can be ended at any time.
include(${CMAKE_CURRENT_LIST_DIR}/test_rasters.cmake)

# Runs a line of the shell, in which $0 is the program.
function(expect_line code text line)
  expect(${code} "${text}" sh -c "${line}" ${PROGRAM})
endfunction()

set(files cost.asc back_links.asc corridor.asc paths.geojson isochrones.geojson)
set(call "large.asc -s cell:3,5 -t cell:280,260 -b -c -i count:3")
set(small_tiles "-w work -m 27M")

expect_line(0 "cells reached in [^,]*\n" "\"$0\" ${call} -o x")
expect_line(0 " s, [0-9]+ tiles, settled" "\"$0\" ${call} -o y ${small_tiles}")
foreach(name IN LISTS files)
  expect_same(x_${name} y_${name})
  list(APPEND outputs x_${name} y_${name})
endforeach()
expect_files(${rasters} ${outputs}) # none of the work folder

# Runs the program in the background, and a line of the shell when it has begun the search back.
function(expect_meanwhile code text line)
  expect_line(${code} "${text}" "env --default-signal=INT \"$0\" ${call} -e 0.5 -o z --force -w work -m 56M &
until [ -e work/targets/task ] || ! kill -0 $!
do sleep 0.01
done
${line}
wait $!")
endfunction()
expect_line(0 "Written" "\"$0\" ${call} -e 0.5 -o x --force")
expect_meanwhile(130 "The same call goes on from here.\n.*terrain_routes: interrupted" "sleep 0.2\nkill -INT $!")
expect_meanwhile(137 "" "sleep 0.3\nkill -9 $!")
expect_meanwhile(0 "--work-folder work: another process works there.*Written"
                 "sleep 0.2\n\"$0\" ${call} -e 0.5 -o w -w work && exit 3")
foreach(name IN LISTS files)
  expect_same(x_${name} z_${name})
  list(APPEND outputs z_${name})
endforeach()
expect_files(${rasters} ${outputs})

# another task
expect_meanwhile(137 "" "kill -9 $!")
expect_line(1 "work/sources has files of another task; delete it, or choose another folder"
            "\"$0\" large.asc -s cell:3,4 -o w -w work")
file(REMOVE_RECURSE ${folder}/work)

# no room on disk
expect_line(1 "work/terrain_routes_friction cannot be written: File too large"
            "ulimit -f 500 && \"$0\" large.asc -s cell:3,4 -o w -w work")
expect_line(1 "work/sources/labels cannot be written: File too large"
            "ulimit -f 2000 && \"$0\" large.asc -s cell:3,4 -o w -w work -e 0.5")
file(REMOVE_RECURSE ${folder}/work)
expect_files(${rasters} ${outputs})
