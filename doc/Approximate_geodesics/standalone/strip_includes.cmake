# Concepts are documented like classes, but cannot be included: takes the line that says so out of
# their pages. To be called with -D html=FOLDER.
file(GLOB pages ${html}/class*.html)
foreach(page IN LISTS pages)
  file(READ ${page} content)
  string(REGEX REPLACE "<p><code>#include &quot;[^\n]*\n" "" content "${content}")
  file(WRITE ${page} "${content}")
endforeach()
