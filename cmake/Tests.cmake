# What all folders of tests share: settings, helpers, and the function that makes programs of them. Included by each
# of these folders; targets are made once.
if(NOT TARGET developer_settings) # the folder is on its own
  include(${CMAKE_CURRENT_LIST_DIR}/On_its_own.cmake)
endif()
find_package(GTest REQUIRED)
find_package(TBB QUIET)
include(CGAL_TBB_support)

option(APPROXIMATE_GEODESICS_LONG_CASES "Run the tests that long_cases.txt lists" ON)
option(APPROXIMATE_GEODESICS_NIGHT_CASES "Run the tests that night_cases.txt lists" OFF)
option(APPROXIMATE_GEODESICS_NIGHT_FOLDERS "Build the tests in the folders of night_folders.txt" ON)

# Tests are compiled far longer than they run. Examples and benchmarks are optimized in full.
set(APPROXIMATE_GEODESICS_TEST_OPTIMIZATION $<IF:$<CXX_COMPILER_ID:GNU>,-Og,-O1>
    CACHE STRING "Optimization of tests, if released")
set(test_dir ${CMAKE_CURRENT_LIST_DIR}/../test)

if(NOT TARGET test_settings)
  add_library(test_settings INTERFACE)
  target_compile_options(test_settings
                         INTERFACE $<$<CONFIG:Release>:${APPROXIMATE_GEODESICS_TEST_OPTIMIZATION}>)
  # g++ suspects CGAL's readers and OpenMesh's arrays of it, where it inlines them; and it spends a
  # fifteenth of its time on collecting garbage, unless memory has grown by more
  target_compile_options(
    test_settings
    INTERFACE "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;--param=ggc-min-expand=1000>")
  target_include_directories(
    test_settings INTERFACE ${test_dir}/Approximate_geodesics/include
                            ${test_dir}/../benchmark/Approximate_geodesics/include)
  foreach(package IN LISTS APPROXIMATE_GEODESICS_PACKAGES)
    target_include_directories(test_settings INTERFACE ${test_dir}/${package}/include)
  endforeach()
  target_link_libraries(test_settings INTERFACE Approximate_geodesics::Approximate_geodesics
                                                developer_settings GTest::gtest_main)
  if(TARGET CGAL::TBB_support) # all, so that they have one precompiled header
    target_link_libraries(test_settings INTERFACE CGAL::TBB_support)
  else()
    message(STATUS "NOTICE: the test of parallel builds needs TBB, and is left out.")
  endif()

  # What most tests include, and seldom changes, is compiled once.
  add_precompiled_headers(
    precompiled_for_tests test_settings
    <CGAL/AABB_tree.h> <CGAL/Polygon_mesh_processing/orient_polygon_soup.h> <CGAL/Simple_cartesian.h>
    <CGAL/Surface_mesh.h> <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
    <boost/graph/dijkstra_shortest_paths.hpp> <boost/heap/d_ary_heap.hpp>
    <boost/heap/fibonacci_heap.hpp> <boost/heap/pairing_heap.hpp> <gtest/gtest.h>)

  # So are the functions of theirs that instantiate most of CGAL: beside those headers, for which all else
  # has to wait.
  add_library(test_support STATIC
              ${test_dir}/Approximate_geodesics/include/meshes/sample_meshes.cpp
              ${test_dir}/Approximate_geodesics/include/oracles/exact_distances.cpp)
  target_link_libraries(test_support PRIVATE test_settings)
endif()

# What is left out, if it is.
foreach(kind IN ITEMS LONG NIGHT)
  if(NOT APPROXIMATE_GEODESICS_${kind}_CASES)
    string(TOLOWER ${kind}_cases.txt file)
    file(STRINGS ${test_dir}/${file} cases REGEX "^[^#]")
    list(APPEND left_out ${cases})
  endif()
endforeach()
if(left_out)
  list(JOIN left_out : left_out)
  set(filter --gtest_filter=-${left_out})
endif()
if(NOT APPROXIMATE_GEODESICS_NIGHT_FOLDERS)
  file(STRINGS ${test_dir}/night_folders.txt folders_left_out REGEX "^[^#]")
endif()

# A program for a folder, or for several that use the same, of all their files, which the presets
# compile together: what they have in common is instantiated once then. It is run in parts, so that no
# core waits for another. No part takes minutes, not even under a sanitizer: one that does hangs.
# Tests have the label of their package, and `tests_of_<label>` builds them.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 0) # all of them
function(add_geodesics_test label name number_of_parts) # FOLDER ...
  set(folders ${ARGN})
  if(folders_left_out)
    list(REMOVE_ITEM folders ${folders_left_out})
  endif()
  if(NOT folders)
    return()
  endif()
  list(TRANSFORM folders APPEND /test_*.cpp)
  file(GLOB files CONFIGURE_DEPENDS ${folders})
  add_executable(${name} ${files})
  target_link_libraries(${name} PRIVATE test_settings test_support)
  target_precompile_headers(${name} REUSE_FROM precompiled_for_tests)
  if(NOT TARGET tests_of_${label})
    add_custom_target(tests_of_${label})
  endif()
  add_dependencies(tests_of_${label} ${name})
  foreach(part RANGE 1 ${number_of_parts})
    math(EXPR index "${part} - 1")
    add_test(NAME ${name}_${part} COMMAND ${name} ${filter})
    set_tests_properties(
      ${name}_${part}
      PROPERTIES LABELS ${label} TIMEOUT 300
                 ENVIRONMENT
                 "${sample_environment};GTEST_TOTAL_SHARDS=${number_of_parts};\
GTEST_SHARD_INDEX=${index}")
  endforeach()
endfunction()

# Programs whose tests call functions, or the class, compile faster with these. Tests of layers do without.
function(link_compiled_searches) # PROGRAM ...
  foreach(program IN LISTS ARGN)
    if(TARGET ${program} AND TARGET Approximate_geodesics::compiled)
      target_link_libraries(${program} PRIVATE Approximate_geodesics::compiled)
    endif()
  endforeach()
endfunction()

# Programs whose tests let allocations fail have global allocation functions of their own.
function(let_allocations_fail program)
  set(source ${test_dir}/Approximate_geodesics/include/checks/failing_allocation.cpp)
  if(TARGET ${program})
    target_sources(${program} PRIVATE ${source})
    set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# Wrong calls, those of the file `name`.cpp, are refused by the compiler, in words. Sanitizers find nothing
# there that they do not find elsewhere.
function(expect_errors name) # [LABEL]
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" OR APPROXIMATE_GEODESICS_SANITIZERS)
    return()
  endif()
  list(JOIN ARGV _ test)
  add_test(NAME ${test}
           COMMAND ${CMAKE_COMMAND} -D compiler=${CMAKE_CXX_COMPILER}
                   -D include_dirs=$<TARGET_PROPERTY:test_settings,INTERFACE_INCLUDE_DIRECTORIES>
                   -D source=${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp
                   -P ${test_dir}/../cmake/expect_errors.cmake)
  set_tests_properties(${test} PROPERTIES TIMEOUT 300)
endfunction()
