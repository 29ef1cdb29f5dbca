# Settings of the project's own programs: warnings, sanitizers, sample meshes. They are attached to
# the target `developer_settings`, which only those programs link to.
add_library(developer_settings INTERFACE)

if(APPROXIMATE_GEODESICS_WARNINGS)
  target_compile_options(developer_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                      -Werror)
endif()

if(APPROXIMATE_GEODESICS_SANITIZERS)
  set(sanitizers -fsanitize=${APPROXIMATE_GEODESICS_SANITIZERS} -fno-sanitize-recover=all)
  target_compile_options(developer_settings INTERFACE ${sanitizers} -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    target_compile_options(
      developer_settings
      INTERFACE "-fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/Ignored_by_sanitizers.txt")
  endif()
  target_compile_definitions(developer_settings INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(developer_settings INTERFACE ${sanitizers})
endif()

# CGAL's sample meshes, in this order: from the folder that -DCGAL_DATA_DIR=FOLDER names, from the
# archive of Debian's package libcgal-demo, from where CGAL looks for them. The last comes last as it
# is any folder "data" beside or above this one, or what the environment happens to say.
set(sample_archive /usr/share/doc/libcgal-dev/data.tar.gz)
if(DEFINED CACHE{CGAL_DATA_DIR})
  set(sample_dir $CACHE{CGAL_DATA_DIR})
elseif(EXISTS ${sample_archive})
  set(sample_dir ${CMAKE_BINARY_DIR}/samples/data)
  if(NOT EXISTS ${sample_dir})
    file(ARCHIVE_EXTRACT INPUT ${sample_archive} DESTINATION ${CMAKE_BINARY_DIR}/samples
         PATTERNS data/meshes/*)
  endif()
elseif(EXISTS "${CGAL_DATA_DIR}/meshes/elephant.off")
  set(sample_dir ${CGAL_DATA_DIR})
endif()
if(sample_dir)
  target_compile_definitions(developer_settings INTERFACE CGAL_DATA_DIR="${sample_dir}")
  set(sample_environment "CGAL_DATA_DIR=${sample_dir}") # of tests: CGAL asks it first
else()
  message(STATUS "NOTICE: CGAL's sample meshes were not found; set CGAL_DATA_DIR to use them.")
endif()

# Lets a target that has these settings compile headers for all those that reuse them from it. CMake makes
# system headers of them, without warnings, unless this variable of its own is empty.
set(CMAKE_PCH_PROLOGUE "")
function(add_precompiled_headers target settings)
  file(CONFIGURE OUTPUT ${target}.cpp CONTENT "")
  add_library(${target} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
  target_link_libraries(${target} PRIVATE ${settings})
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()
