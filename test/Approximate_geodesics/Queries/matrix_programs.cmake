# Programs that compute files of distances, for tests that kill them, let them work together, or let
# Python read what they have written.
if(WIN32)
  return()
endif()

add_executable(compute_matrix_file Queries/compute_matrix_file.cpp)
target_link_libraries(compute_matrix_file PRIVATE test_settings)
target_precompile_headers(compute_matrix_file REUSE_FROM precompiled_for_tests)
set(program_definition APPROXIMATE_GEODESICS_TEST_MATRIX_PROGRAM="$<TARGET_FILE:compute_matrix_file>")
target_compile_definitions(test_matrix_files PRIVATE ${program_definition})
add_dependencies(test_matrix_files compute_matrix_file)

foreach(candidate python3 /usr/bin/python3) # the system's has Debian's packages
  execute_process(COMMAND ${candidate} -c "import numpy, scipy.sparse" ERROR_QUIET OUTPUT_QUIET
                  RESULT_VARIABLE error)
  if(error EQUAL 0)
    set(python_with_scipy ${candidate})
    break()
  endif()
endforeach()
if(python_with_scipy)
  add_test(NAME read_matrix_files
           COMMAND ${python_with_scipy} ${CMAKE_CURRENT_LIST_DIR}/read_matrix_files.py
                   $<TARGET_FILE:compute_matrix_file>)
  set_tests_properties(read_matrix_files PROPERTIES TIMEOUT 300)
else()
  message(STATUS "NOTICE: the test that Python reads files of distances needs NumPy and SciPy, and "
                 "is left out.")
endif()

find_package(MPI COMPONENTS CXX QUIET)
if(MPI_CXX_FOUND AND MPIEXEC_EXECUTABLE)
  add_executable(compute_matrix_file_mpi Queries/compute_matrix_file.cpp)
  target_link_libraries(compute_matrix_file_mpi PRIVATE test_settings MPI::MPI_CXX)
  target_compile_definitions(compute_matrix_file_mpi PRIVATE APPROXIMATE_GEODESICS_TEST_MPI
                                                             OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
  add_geodesics_test(test_mpi_matrix Queries/test_mpi_matrix.cpp)
  target_compile_definitions(
    test_mpi_matrix
    PRIVATE ${program_definition} APPROXIMATE_GEODESICS_TEST_MPIEXEC="${MPIEXEC_EXECUTABLE}"
            APPROXIMATE_GEODESICS_TEST_MPI_PROGRAM="$<TARGET_FILE:compute_matrix_file_mpi>")
  add_dependencies(test_mpi_matrix compute_matrix_file compute_matrix_file_mpi)
  # Open MPI refuses root, and more processes than cores, unless it is told otherwise, lets who
  # waits take a core from who works, and keeps memory at the end.
  set_tests_properties(
    test_mpi_matrix
    PROPERTIES ENVIRONMENT
               "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;\
OMPI_MCA_rmaps_base_oversubscribe=1;OMPI_MCA_hwloc_base_binding_policy=none;\
OMPI_MCA_mpi_yield_when_idle=1;ASAN_OPTIONS=detect_leaks=0")
else()
  message(STATUS "NOTICE: the test of several processes needs MPI, and is left out.")
endif()
