# The program writes the same file by one thread and by two, tells before what it will be, and leaves
# nothing else.
include(${CMAKE_CURRENT_LIST_DIR}/../geodesic_distances/test_meshes.cmake)
file(GLOB meshes RELATIVE ${CMAKE_CURRENT_BINARY_DIR}/${folder} ${folder}/*)

expect(0 "length of the file +397 kB" ${PROGRAM} ${mesh} --epsilon 0.1 --estimate)
expect_files(${meshes})
expect(0 "length of the file +397 kB" ${PROGRAM} ${mesh} --epsilon 0.1 --output one.npy --threads 1)
expect(0 "rows +315" ${PROGRAM} ${mesh} --epsilon 0.1 --output all.npy)
expect_same(one.npy all.npy)

file(WRITE ${folder}/vertices.txt "# some vertices\n314\n0 # the first one\n\n7\n")
expect(0 "rows +3\n.*columns +20\n" ${PROGRAM} ${mesh} --sources file:vertices.txt --targets farthest:20
       --type float64 --output some.npy)
expect(0 "rows +6\n.*columns +2\n" ${PROGRAM} ${mesh} --sources 7 file:vertices.txt random:2 --targets 0 5
       --output mixed.npy)
expect(0 "rows +30\n.*columns +30\n" ${PROGRAM} ${mesh} --sources random:30 --epsilon 0 --symmetric
       --output symmetric.npy)
expect(0 "microseconds a row" ${PROGRAM} ${mesh} --radius 0.5 --nearest 9 --output near.csr/)
if(NOT EXISTS ${folder}/near.csr/vertices.npy)
  message(FATAL_ERROR "near.csr has no vertices of its rows")
endif()
expect_files(${meshes} all.npy mixed.npy near.csr one.npy some.npy symmetric.npy all.vertices.npy mixed.vertices.npy
             one.vertices.npy some.vertices.npy symmetric.vertices.npy mixed.columns.npy
             some.columns.npy vertices.txt)

# Fails unless an array has these bytes, in hexadecimal digits, behind its header.
function(expect_numbers name digits)
  file(READ ${folder}/${name} numbers OFFSET 128 HEX)
  if(NOT numbers STREQUAL digits)
    message(FATAL_ERROR "${name} holds ${numbers}")
  endif()
endfunction()

# Returns 64-bit integers below 16 in this form.
function(digits_of result)
  set(digits "")
  foreach(number IN LISTS ARGN)
    string(APPEND digits "0${number}00000000000000")
  endforeach()
  set(${result} ${digits} PARENT_SCOPE)
endfunction()

# the numbers of the file, in spite of repairs
set(one "000000000000f03f")
set(infinity "000000000000f07f")
set(zero "0000000000000000")
expect(0 "vertices of its rows +mended.vertices.npy\nvertices of its columns +mended.columns.npy\n" ${PROGRAM}
       mended.off --sources 6 5 0 --targets 1 0 6 --epsilon 0 --type float64 --output mended.npy)
expect_numbers(mended.npy "${one}${infinity}${zero}${zero}${infinity}${one}${infinity}${zero}${infinity}")
digits_of(digits 6 5 0)
expect_numbers(mended.vertices.npy "${digits}")
digits_of(digits 1 0 6)
expect_numbers(mended.columns.npy "${digits}")
expect(0 "rows +3\n" ${PROGRAM} mended.off --sources farthest:3 --symmetric --output farthest.npy)
digits_of(digits 1 4 2)
expect_numbers(farthest.vertices.npy "${digits}")
expect(1 "--sources farthest:5: the mesh has 4 vertices" ${PROGRAM} mended.off --sources farthest:5)
expect(0 "rows +8\n" ${PROGRAM} mended.off --output whole.npy)
digits_of(digits 0 1 2 3 4 5 6 7)
expect_numbers(whole.vertices.npy "${digits}")
expect(0 "At some vertices, such as 0, faces do not form a surface" ${PROGRAM} fan_of_three.off --output fan.npy)
file(REMOVE ${folder}/whole.npy)
expect(1 "whole.vertices.npy already exists" ${PROGRAM} mended.off --output whole.npy)

# a run that is refused leaves no files that could pass for those of another one
expect(0 "rows +8\n" ${PROGRAM} mended.off --radius 1 --output whole.csr)
file(REMOVE ${folder}/whole.vertices.npy)
file(GLOB before RELATIVE ${CMAKE_CURRENT_BINARY_DIR}/${folder} ${folder}/*)
file(MAKE_DIRECTORY ${folder}/whole.npy.part)
file(WRITE ${folder}/whole.npy.part/identity "of another run\n")
expect(1 "whole.npy.part" ${PROGRAM} mended.off --output whole.npy)
file(REMOVE_RECURSE ${folder}/whole.npy.part)
expect_files(${before})
expect(0 "vertices of its columns +whole.vertices.npy\n" ${PROGRAM} mended.off --output whole.npy)
