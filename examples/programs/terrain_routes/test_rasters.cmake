# What the tests have in common: a folder of their own, and small rasters.
include(${CMAKE_CURRENT_LIST_DIR}/../command_line/test_helpers.cmake)

# eight cells around one that cannot be entered
file(WRITE ${folder}/ring.asc
     "ncols 3\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 2\nNODATA_value -1\n"
     "1 1 1\n1 -1 1\n1 1 3\n")

# 300 rows of 300 cells
string(REPEAT "1 3 2 5 4 1 9 2 6 3 " 30 first)
string(REPEAT "2 7 1 8 2 8 1 8 2 8 4 5 " 25 second)
string(REPEAT "${first}\n${second}\n${first}\n" 100 values)
file(WRITE ${folder}/large.asc "ncols 300\nnrows 300\ncellsize 1\n${values}")

# the same values as in ring.asc, as NumPy would write them
set(header "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 3), }")
string(LENGTH "${header}" length)
math(EXPR blanks "117 - ${length}")
string(REPEAT " " ${blanks} blanks)
set(one "\\000\\000\\200\\077")
execute_process(
  COMMAND
    sh -c "printf '\\223NUMPY\\001\\000\\166\\000'\"${header}${blanks}\"'\\n'\
'${one}${one}${one}${one}\\000\\000\\200\\277${one}${one}${one}\\000\\000\\100\\100' >ring.npy"
  WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)

file(GLOB rasters RELATIVE ${CMAKE_CURRENT_BINARY_DIR}/${folder} ${folder}/*)
