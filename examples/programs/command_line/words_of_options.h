#ifndef COMMAND_LINE_WORDS_OF_OPTIONS_H
#define COMMAND_LINE_WORDS_OF_OPTIONS_H

#include <cstddef>
#include <string>
#include <utility>

// Replaces words of C++ in a message of the library by those of the command line.
inline std::string in_words_of_options(std::string text)
{
  using Words = std::pair<std::string, std::string>;
  for(const auto& [words, replacement] :
      {Words("Approximate_geodesics: ", ""),
       Words("accept_weaker_bound(true)", "--accept-weaker-bound"),
       Words(", which Steiner_graph::epsilon() returns", ", which is printed"),
       Words("for this epsilon", "for this --epsilon"),
       Words("a larger epsilon", "a larger --epsilon"),
       Words("maximum_number_of_points_per_edge is", "the most is"),
       Words("maximum_number_of_points is", "the most is")})
    for(std::size_t i = text.find(words); i != text.npos;
        i = text.find(words, i + replacement.size()))
      text.replace(i, words.size(), replacement);
  return text;
}

#endif // COMMAND_LINE_WORDS_OF_OPTIONS_H
