#ifndef COMMAND_LINE_LINES_OF_FILE_H
#define COMMAND_LINE_LINES_OF_FILE_H

#include "files.h"
#include "vertex_numbers.h"

#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Refuses a file that an option names and that cannot be read.
inline void check_option_file(const std::string& option, const std::string& file)
{
  if(!file.empty())
    name_in_errors("--" + option, [&] { check_readable(file); });
}

// Calls `f(words, name)` for each line of a text file that is not empty; the rest of a line after #
// is a comment. Errors name the line.
template <typename F>
void for_each_line(const std::string& file, F f)
{
  std::ifstream in = open_to_read(file);
  std::size_t number = 1;
  for(std::string text; std::getline(in, text); ++number)
  {
    std::istringstream stream(text.substr(0, text.find('#')));
    std::vector<std::string> words;
    for(std::string word; stream >> word;)
      words.push_back(word);
    const std::string name = "line " + std::to_string(number);
    if(!words.empty())
      name_in_errors(name, [&] { f(words, name); });
  }
}

// The same, for `f(words)`. Errors name the option and the file, too.
template <typename F>
void for_each_line(const std::string& option, const std::string& file, F f)
{
  name_in_errors(option + ' ' + file, [&] {
    for_each_line(file, [&](const std::vector<std::string>& words, const std::string& /* line */) {
      f(words);
    });
  });
}

#endif // COMMAND_LINE_LINES_OF_FILE_H
