# Two processes write the file that one writes. `LAUNCHER` starts as many as the next argument says.
include(${CMAKE_CURRENT_LIST_DIR}/../command_line/test_helpers.cmake)
separate_arguments(LAUNCHER)

foreach(kind "all.npy;--epsilon;0.1" "near.csr;--radius;0.5" "far.npy;--sources;farthest:20")
  list(POP_FRONT kind name)
  expect(0 "processes +1\n" ${PROGRAM} ${mesh} ${kind} --output one_${name})
  expect(0 "processes +2\n" ${LAUNCHER} 2 ${PROGRAM} ${mesh} ${kind} --output two_${name} --threads
         2)
  if(name MATCHES csr)
    foreach(array data indices indptr shape)
      expect_same(one_${name}/${array}.npy two_${name}/${array}.npy)
    endforeach()
  else()
    expect_same(one_${name} two_${name})
  endif()
endforeach()
expect(1 "--radius" ${LAUNCHER} 2 ${PROGRAM} ${mesh} --radius -1)
expect_same(one_far.vertices.npy two_far.vertices.npy)
expect_files(
  one_all.npy one_all.vertices.npy one_far.npy one_far.vertices.npy one_far.columns.npy one_near.csr
  two_all.npy two_all.vertices.npy two_far.npy two_far.vertices.npy two_far.columns.npy
  two_near.csr)
