# MPI as CMake's own module finds it. That ends with an error where a wrapper of the compiler is installed
# without MPI's headers, as by Debian's package openmpi-bin. So this one asks the wrapper first, which is
# to call the compiler that is used here. Where there is none, CMake's module copes.
set(MPI_CXX_SKIP_MPICXX ON) # not the C++ functions of MPI 2, which no program here calls
if(NOT MPI_SKIP_COMPILER_WRAPPER)
  find_program(MPI_CXX_COMPILER NAMES mpicxx mpic++ mpiCC HINTS ${MPI_HOME} ENV MPI_HOME
               PATH_SUFFIXES bin DOC "MPI compiler for CXX")
endif()

set(mpi_error 0)
if(MPI_CXX_COMPILER)
  set(mpi_source ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/include_mpi.cpp)
  file(WRITE ${mpi_source} "#include <mpi.h>\n")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env OMPI_CXX=${CMAKE_CXX_COMPILER} MPICH_CXX=${CMAKE_CXX_COMPILER}
            ${MPI_CXX_COMPILER} -E ${mpi_source}
    OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE mpi_error)
endif()
if(mpi_error EQUAL 0)
  include(${CMAKE_ROOT}/Modules/FindMPI.cmake)
else()
  set(MPI_FOUND FALSE)
  set(MPI_CXX_FOUND FALSE)
  set(MPI_NOT_FOUND_MESSAGE "${MPI_CXX_COMPILER} does not find mpi.h")
endif()
