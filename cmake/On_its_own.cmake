# What tests and examples include first if each folder is configured on its own: the package, which is
# the installed one that CMake finds, or else that of the source tree; and settings of developers.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
endif()
enable_testing()

find_package(CGAL 5.5 REQUIRED) # sets its variables only where it is found first
find_package(Approximate_geodesics QUIET)
if(Approximate_geodesics_FOUND)
  message(STATUS "Using the package in ${Approximate_geodesics_DIR}")
else()
  message(STATUS "Using the headers of the source tree")
  add_subdirectory(${CMAKE_CURRENT_LIST_DIR}/.. headers EXCLUDE_FROM_ALL)
endif()
list(APPEND CMAKE_MODULE_PATH ${CGAL_MODULES_DIR} ${CMAKE_CURRENT_LIST_DIR})

include(${CMAKE_CURRENT_LIST_DIR}/Developer_settings.cmake)
