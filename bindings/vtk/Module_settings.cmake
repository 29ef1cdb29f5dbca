# What VTK's filters need in both projects: the headers, TBB if it is there, and the folders of VTK.
if(NOT TARGET Approximate_geodesics::Approximate_geodesics)
  add_subdirectory(${CMAKE_CURRENT_LIST_DIR}/../.. headers EXCLUDE_FROM_ALL)
endif()
find_package(TBB QUIET)
find_package(CGAL 5.5 REQUIRED) # adds its modules only where it is found first
list(APPEND CMAKE_MODULE_PATH ${CGAL_MODULES_DIR})
include(CGAL_TBB_support)
if(NOT TARGET CGAL::TBB_support)
  message(STATUS "NOTICE: TBB was not found; graphs are built by one thread.")
endif()

set(CMAKE_CXX_VISIBILITY_PRESET hidden) # a program that links the module may compile the headers otherwise
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR})
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR})
