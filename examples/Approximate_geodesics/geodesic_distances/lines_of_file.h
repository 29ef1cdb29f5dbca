#ifndef GEODESIC_DISTANCES_LINES_OF_FILE_H
#define GEODESIC_DISTANCES_LINES_OF_FILE_H

#include "../command_line/files.h"
#include "../command_line/vertex_numbers.h"

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Refuses a file that an option names and nobody can read.
inline void check_option_file(const std::string& option, const std::string& file)
{
  if(!file.empty())
    name_in_errors("--" + option, [&] { check_readable(file); });
}

// Calls `f(words)` for each line of a text file that is not empty; the rest of a line after # is a
// comment. Errors name the option, the file and the line.
template <typename F>
void for_each_line(const std::string& option, const std::string& file, F f)
{
  name_in_errors(option + ' ' + file, [&] {
    std::ifstream in = open_to_read(file);
    std::size_t number = 1;
    for(std::string text; std::getline(in, text); ++number)
    {
      std::istringstream stream(text.substr(0, text.find('#')));
      std::vector<std::string> words;
      for(std::string word; stream >> word;)
        words.push_back(word);
      if(!words.empty())
        name_in_errors(name_of_line(number), [&] { f(words); });
    }
  });
}

#endif // GEODESIC_DISTANCES_LINES_OF_FILE_H
