# Compiles the file `source`, and expects one error for each comment inside a function there, with
# the text of that comment in its message, and no others.
list(TRANSFORM include_dirs PREPEND -I)
if(compiler MATCHES "clang")
  set(all_errors -ferror-limit=0) # instead of the first 20
endif()
execute_process(COMMAND ${compiler} -std=c++17 -fsyntax-only ${all_errors} ${include_dirs} ${source}
                ERROR_VARIABLE output)
string(REPLACE ";" "," output "${output}") # which would end elements of a list
string(REGEX MATCHALL "[^\n]*error: [^\n]*" errors "${output}")

file(READ ${source} text)
string(REGEX MATCHALL "\n  // [^\n]+" messages "${text}")
foreach(message IN LISTS messages)
  string(REPLACE "\n  // " "" message "${message}")
  string(FIND "${errors}" "${message}" position)
  if(position EQUAL -1)
    message(SEND_ERROR "No error says: ${message}")
  endif()
endforeach()

list(LENGTH messages expected_number)
list(LENGTH errors number)
if(NOT number EQUAL expected_number)
  list(JOIN errors "\n" errors)
  message(SEND_ERROR "There are ${number} errors, and should be ${expected_number}:\n${errors}")
endif()
