# Takes lines with #include out of pages: those of concepts, which are documented like classes but
# cannot be included, and those of functions from internal headers, which public ones include. To be
# called with -D html=FOLDER.
file(GLOB pages ${html}/class*.html ${html}/group__*.html)
foreach(page IN LISTS pages)
  file(READ ${page} content)
  string(REGEX REPLACE "<p><code>#include &quot;[^\n]*\n" "" content "${content}")
  string(REGEX REPLACE "<p><code>#include &lt;[^\n]*/internal/[^\n]*\n" "" content "${content}")
  file(WRITE ${page} "${content}")
endforeach()
