# Makes the main page of a package's manual a page that the start page has a link to.
/^\\mainpage User Manual$/ {
  N
  s/^.*\n\\anchor Chapter_(.*)$/\\page Chapter_\1 \1\n/
  :blanks
  s/^(\\page \w+ .*)_/\1 /
  t blanks
}
