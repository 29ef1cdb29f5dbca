# What the tests of command-line programs have in common: a folder of their own, and a small mesh.
cmake_minimum_required(VERSION 3.21)
get_filename_component(folder ${CMAKE_SCRIPT_MODE_FILE} NAME_WE)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
set(mesh $ENV{CGAL_DATA_DIR}/meshes/eight.off)

# Runs a command, and fails unless it ends with `code` and writes what the regular expression
# matches.
function(expect code text)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder} RESULT_VARIABLE result
                  OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL code OR NOT output MATCHES "${text}")
    message(FATAL_ERROR "${ARGN}\nended with ${result} and wrote:\n${output}")
  endif()
endfunction()

# Fails unless the regular expression matches what is in a file.
function(expect_contents name text)
  file(READ ${folder}/${name} contents)
  if(NOT contents MATCHES "${text}")
    message(FATAL_ERROR "${name} holds\n${contents}")
  endif()
endfunction()

# Fails unless both files are there and have the same bytes.
function(expect_same first second)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${folder}/${first} ${folder}/${second}
                  COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Fails unless the folder has these files, and no others.
function(expect_files)
  file(GLOB found RELATIVE ${CMAKE_CURRENT_BINARY_DIR}/${folder} ${folder}/*)
  set(expected ${ARGN})
  list(SORT found)
  list(SORT expected)
  if(NOT "${found}" STREQUAL "${expected}")
    message(FATAL_ERROR "There are ${found}, in place of ${expected}.")
  endif()
endfunction()
