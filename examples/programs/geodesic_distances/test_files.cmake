# A call writes all of its files, or leaves everything as it was.
include(${CMAKE_CURRENT_LIST_DIR}/test_meshes.cmake)
file(GLOB meshes RELATIVE ${CMAKE_CURRENT_BINARY_DIR}/${folder} ${folder}/*)
set(outputs x.csv x.ply x.polylines.txt x.vtp x_paths.vtp)

# Runs a line of the shell, in which $0 is the program.
function(expect_line code text line)
  expect(${code} "${text}" sh -c "${line}" ${PROGRAM})
endfunction()

# files that cannot become longer, as if the disk was full: the first one, or a later one
set(fails "^geodesic_distances: cannot write x[^:]*: File too large\n$")
set(big "'${mesh}' -o x -t 5 --csv -i count:9 -e 0.1")
foreach(blocks 0 1 16 45)
  expect_line(1 "${fails}" "ulimit -f ${blocks} && \"$0\" ${big} 2>&1 >/dev/null")
  expect_files(${meshes})
endforeach()

# what was there stays, to the byte
foreach(name IN LISTS outputs)
  file(WRITE ${folder}/${name} "the old ${name}\n")
endforeach()
foreach(blocks 0 1 16 45)
  expect_line(1 "${fails}" "ulimit -f ${blocks} && \"$0\" ${big} --force 2>&1 >/dev/null")
  expect_files(${meshes} ${outputs})
  foreach(name IN LISTS outputs)
    expect_contents(${name} "^the old ${name}\n$")
  endforeach()
endforeach()

# Runs the program in the background, and lines of the shell when it waits for a pipe.
file(REMOVE ${folder}/x.csv)
file(WRITE ${folder}/x_offsets.vtp "of an earlier run\n")
function(expect_meanwhile code text lines)
  # shells keep Ctrl-C from what they start in the background
  expect_line(${code} "${text}" "mkfifo x.csv
env --default-signal=INT \"$0\" ${big} --force &
until [ -e x_paths.vtp.new0 ]
do sleep 0.1
done
${lines}
timeout 5 cat x.csv >/dev/null
wait $!")
  file(REMOVE ${folder}/x.csv)
endfunction()
expect_meanwhile(130 "geodesic_distances: interrupted\n" "kill -INT $!")
expect_meanwhile(1 "cannot write x_paths.vtp: Is a directory" "rm x_paths.vtp && mkdir x_paths.vtp")
file(REMOVE_RECURSE ${folder}/x_paths.vtp)
file(WRITE ${folder}/x_paths.vtp "the old x_paths.vtp\n")
file(WRITE ${folder}/x.csv "the old x.csv\n")
expect_files(${meshes} ${outputs} x_offsets.vtp)
expect_contents(x_offsets.vtp "^of an earlier run\n$")
file(REMOVE ${folder}/x_offsets.vtp)
foreach(name IN LISTS outputs)
  expect_contents(${name} "^the old ${name}\n$")
endforeach()

# what replaces it has the same permissions, and a link stays one
file(CHMOD ${folder}/x.ply PERMISSIONS OWNER_READ OWNER_WRITE)
file(RENAME ${folder}/x.csv ${folder}/table)
file(CREATE_LINK table ${folder}/x.csv SYMBOLIC)
expect_line(0 "Written: x.ply" "umask 022 && \"$0\" square.off -o x -t 2 --csv --force")
expect_files(${meshes} ${outputs} table)
expect_line(0 "^-rw------- .*\n-rw-r--r-- .*\n$" "ls -l x.ply x_paths.vtp")
expect_contents(table "^vertex,x,y,z,")
if(NOT IS_SYMLINK ${folder}/x.csv)
  message(FATAL_ERROR "x.csv is no link any more")
endif()
file(REMOVE ${folder}/table ${folder}/x.csv)

# devices are written to at once, and their errors are told
file(CREATE_LINK /dev/full ${folder}/full.csv SYMBOLIC)
expect(1 "cannot write full.csv: No space left on device" ${PROGRAM} square.off -o full --csv --force)
expect_files(${meshes} full.csv x.ply x.polylines.txt x.vtp x_paths.vtp)
file(REMOVE ${folder}/full.csv)
expect_line(0 "vertex,x,y,z" "mkfifo y.csv
cat y.csv & \"$0\" square.off -o y --csv --force
wait")

# standard output, which comes before the files
set(cannot_print "^geodesic_distances: cannot write to standard output: ")
expect_line(1 "${cannot_print}No space left on device\n$" "\"$0\" --help >/dev/full")
expect_line(1 "${cannot_print}No space left on device\n$" "\"$0\" square.off -o z >/dev/full")
expect_line(1 "${cannot_print}Bad file descriptor\n$" "\"$0\" square.off -o z >&-")
expect_files(${meshes} x.ply x.polylines.txt x.vtp x_paths.vtp y.csv y.ply y.vtp y_paths.vtp)
