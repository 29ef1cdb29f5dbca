#ifndef COMMAND_LINE_DESCRIBE_OPTION_H
#define COMMAND_LINE_DESCRIBE_OPTION_H

#include <boost/program_options.hpp>

#include <string>
#include <vector>

// Groups of options as --help shows them, and options whose values are read later.

namespace po = boost::program_options;

inline auto text_option(const char* name) { return po::value<std::string>()->value_name(name); }

inline auto texts_option(const char* name)
{
  return po::value<std::vector<std::string>>()->multitoken()->value_name(name);
}

inline po::options_description make_group(const char* title)
{
  constexpr unsigned width = 88, width_of_descriptions = 60;
  return po::options_description(title, width, width_of_descriptions);
}

#endif // COMMAND_LINE_DESCRIBE_OPTION_H
