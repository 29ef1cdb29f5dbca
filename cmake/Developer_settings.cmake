# Settings of the project's own programs: warnings, sanitizers, sample meshes. They are attached to
# the target `developer_settings`, which only those programs link to.
add_library(developer_settings INTERFACE)

if(APPROXIMATE_GEODESICS_WARNINGS)
  target_compile_options(developer_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                      -Werror)
endif()

# CGAL 6 warns of headers that have another name by now, and only the old one in CGAL 5.
if(APPROXIMATE_GEODESICS_WARNINGS AND CGAL_VERSION VERSION_GREATER_EQUAL 6)
  target_compile_options(developer_settings INTERFACE -Wno-error=cpp)
endif()

if(APPROXIMATE_GEODESICS_SANITIZERS)
  set(sanitizers -fsanitize=${APPROXIMATE_GEODESICS_SANITIZERS} -fno-sanitize-recover=all)
  target_compile_options(developer_settings INTERFACE ${sanitizers} -fno-omit-frame-pointer)
  target_compile_definitions(developer_settings INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(developer_settings INTERFACE ${sanitizers})
endif()

# CGAL's sample meshes: Debian's package libcgal-demo has them in an archive. Elsewhere, set
# CGAL_DATA_DIR to the folder "data" of a CGAL source tree.
set(sample_archive /usr/share/doc/libcgal-dev/data.tar.gz)
if(NOT CGAL_DATA_DIR AND EXISTS ${sample_archive})
  set(CGAL_DATA_DIR ${CMAKE_BINARY_DIR}/samples/data)
  if(NOT EXISTS ${CGAL_DATA_DIR})
    file(ARCHIVE_EXTRACT INPUT ${sample_archive} DESTINATION ${CMAKE_BINARY_DIR}/samples)
  endif()
endif()
if(CGAL_DATA_DIR)
  target_compile_definitions(developer_settings INTERFACE CGAL_DATA_DIR="${CGAL_DATA_DIR}")
else()
  message(STATUS "NOTICE: CGAL's sample meshes were not found; set CGAL_DATA_DIR to use them.")
endif()
