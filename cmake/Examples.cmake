# What all folders of examples share. Included by each of them, which is configured with the whole, or on its own:
# against the installed package, or else in its source tree.
if(NOT TARGET Approximate_geodesics::Approximate_geodesics)
  include(${CMAKE_CURRENT_LIST_DIR}/On_its_own.cmake)
elseif(PROJECT_IS_TOP_LEVEL) # this file is installed
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
  endif()
  list(APPEND CMAKE_MODULE_PATH ${Approximate_geodesics_DIR}) # FindMPI.cmake
  enable_testing()
endif()
find_package(Threads REQUIRED)
find_package(TBB QUIET)
include(CGAL_TBB_support)
if(NOT DEFINED Approximate_geodesics_VERSION) # the headers are beside it
  get_target_property(library Approximate_geodesics SOURCE_DIR)
  get_directory_property(Approximate_geodesics_VERSION DIRECTORY ${library} DEFINITION PROJECT_VERSION)
endif()

if(TARGET developer_settings AND NOT TARGET precompiled_for_examples)
  add_precompiled_headers(
    precompiled_for_examples "Approximate_geodesics::Approximate_geodesics;developer_settings"
    <CGAL/AABB_tree.h> <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h>
    <CGAL/boost/graph/IO/polygon_mesh_io.h> <CGAL/Approximate_geodesics.h>)
endif()

# Examples of one file each, which are tests, too. `arguments_of_<program>` may say what they are called with.
function(add_geodesics_examples) # PROGRAM ...
  foreach(program IN LISTS ARGN)
    add_executable(${program} ${program}.cpp)
    target_link_libraries(${program} PRIVATE Approximate_geodesics::Approximate_geodesics
                                             Threads::Threads)
    add_test(NAME example_${program} COMMAND ${program} ${arguments_of_${program}}
             WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
    if(TARGET developer_settings)
      target_link_libraries(${program} PRIVATE developer_settings)
      target_precompile_headers(${program} REUSE_FROM precompiled_for_examples)
      set_tests_properties(example_${program} PROPERTIES ENVIRONMENT "${sample_environment}")
    endif()
  endforeach()
endfunction()

# Links a library to those of these programs that exist: they have other definitions then than those that headers
# are precompiled with.
function(link_geodesics_examples library) # PROGRAM ...
  foreach(program IN LISTS ARGN)
    if(TARGET ${program})
      target_link_libraries(${program} PRIVATE ${library})
      set_target_properties(${program} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()

# Compares what a program prints with what README and manual say that it does. TEXT is below the top folder.
function(compare_output program) # TEXT ...
  if(TARGET ${program} AND TARGET developer_settings AND sample_dir)
    list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/../../ OUTPUT_VARIABLE texts)
    add_test(NAME output_of_${program}
             COMMAND ${CMAKE_COMMAND} -D program=$<TARGET_FILE:${program}> -D "texts=${texts}"
                     -P ${CMAKE_CURRENT_SOURCE_DIR}/compare_output.cmake)
    set_tests_properties(output_of_${program} PROPERTIES ENVIRONMENT "${sample_environment}")
  endif()
endfunction()
