# Runs `program`, and expects each of the `texts` to show all that it prints, where lines may be
# indented.
execute_process(COMMAND ${program} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
foreach(text IN LISTS texts)
  file(READ ${text} shown)
  string(REGEX REPLACE "\n +" "\n" shown "${shown}")
  string(FIND "${shown}" "\n${printed}" position)
  if(position EQUAL -1)
    message(SEND_ERROR "${text} does not show what the program prints:\n${printed}")
  endif()
endforeach()
