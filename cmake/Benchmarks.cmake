# What all folders of benchmark programs share: settings, and the function that makes programs. Included by each of
# these folders; targets are made once.
find_package(Boost REQUIRED COMPONENTS program_options)
find_package(Eigen3 3.1.0 QUIET)
include(CGAL_Eigen3_support)
find_package(TBB QUIET)
include(CGAL_TBB_support)

option(APPROXIMATE_GEODESICS_CHECK_BENCHMARKS
       "Let the compiler check the benchmark programs, and generate none" OFF)

if(NOT TARGET benchmark_settings)
  add_library(benchmark_settings INTERFACE)
  target_include_directories(
    benchmark_settings
    INTERFACE ${CMAKE_CURRENT_LIST_DIR}/../benchmark/Approximate_geodesics/include)
  target_compile_options(benchmark_settings INTERFACE -march=native)
  target_link_libraries(
    benchmark_settings INTERFACE Approximate_geodesics::Matrix_files Approximate_geodesics::Solver
                                 Approximate_geodesics::Grid_files Boost::program_options
                                 developer_settings)
  if(TARGET CGAL::Eigen3_support)
    target_link_libraries(benchmark_settings INTERFACE CGAL::Eigen3_support)
  else()
    message(STATUS "NOTICE: the comparison with the heat method needs Eigen, and is left out.")
  endif()
  if(TARGET CGAL::TBB_support)
    target_link_libraries(benchmark_settings INTERFACE CGAL::TBB_support)
  else()
    message(STATUS "NOTICE: what several threads do needs TBB, and is not measured.")
  endif()
  add_precompiled_headers(
    precompiled_for_benchmarks benchmark_settings
    <CGAL/AABB_tree.h> <CGAL/Polygon_mesh_processing/orient_polygon_soup.h> <CGAL/Simple_cartesian.h>
    <CGAL/Surface_mesh.h> <CGAL/boost/graph/IO/polygon_mesh_io.h> <boost/program_options.hpp>
    <CGAL/Approximate_geodesics.h>)
  add_custom_target(benchmarks)
endif()

function(add_benchmark program source) # LIBRARY ...
  if(APPROXIMATE_GEODESICS_CHECK_BENCHMARKS)
    add_library(${program} OBJECT ${source})
    target_compile_options(${program} PRIVATE -fsyntax-only) # instantiates templates, too
  else()
    add_executable(${program} ${source})
  endif()
  target_link_libraries(${program} PRIVATE benchmark_settings ${ARGN})
  add_dependencies(benchmarks ${program})
endfunction()

# Programs of one file each, in this folder or those below it.
function(add_benchmarks) # FILE without its ending ...
  foreach(source IN LISTS ARGN)
    get_filename_component(program ${source} NAME)
    add_benchmark(${program} ${source}.cpp)
    target_precompile_headers(${program} REUSE_FROM precompiled_for_benchmarks)
  endforeach()
endfunction()
