# Runs `program` in `folder`, and compares the paths that it prints, or writes to a file there, with
# the exact distances.
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${program} WORKING_DIRECTORY ${folder} OUTPUT_FILE printed.txt
                COMMAND_ERROR_IS_FATAL ANY)
file(GLOB paths ${folder}/*.polylines.txt)
if(NOT paths)
  set(paths ${folder}/printed.txt)
endif()
execute_process(COMMAND ${compare} ${paths} COMMAND_ERROR_IS_FATAL ANY)
