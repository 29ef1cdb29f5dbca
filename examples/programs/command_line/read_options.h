#ifndef COMMAND_LINE_READ_OPTIONS_H
#define COMMAND_LINE_READ_OPTIONS_H

#include "run_program.h"

#include <boost/program_options.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

[[noreturn]] inline void reject_option(const std::string& option, const std::string& reason)
{
  throw std::invalid_argument("--" + option + ": " + reason);
}

// Whether a word is one such as -1.5 or -1,0,2, and so no option.
inline bool is_negative_number(const std::string& word)
{
  return word.size() > 1 && word[0] == '-' && word.find_first_of("0123456789.", 1) == 1;
}

// Takes such a word for a value.
inline std::vector<boost::program_options::option>
read_negative_number(std::vector<std::string>& words)
{
  const std::string word = words.front();
  if(!is_negative_number(word))
    return {};
  words.erase(words.begin());
  boost::program_options::option result;
  result.value = {word};
  result.original_tokens = {word};
  return {result};
}

// Refuses an option whose value has been left out, so that the next option was taken for it.
inline void check_values(const boost::program_options::parsed_options& parsed)
{
  for(const boost::program_options::option& option : parsed.options)
    for(const std::string& word : option.value)
      if(!option.string_key.empty() && word.size() > 1 && word[0] == '-' &&
         !is_negative_number(word))
        reject_option(option.string_key, "a value must follow, in place of " + word);
}

// Prints the version, as all programs do when asked with --version, wherever it stands.
[[noreturn]] inline void print_version(const std::string& command)
{
  std::cout << std::filesystem::path(command).filename().string() << " (Approximate Geodesics) "
            << APPROXIMATE_GEODESICS_VERSION << std::endl; // which fails here if at all
  throw Answered();
}

// Reads the options, whose names cannot be abbreviated, and the name of the mesh, or of another
// kind of input, which comes without an option. It may be missing only if `help` is asked for, or
// the option `substitute` is given.
inline boost::program_options::variables_map
read_options(const int argc,
             char* argv[],
             const boost::program_options::options_description& description,
             std::string& input,
             const std::string& kind = "mesh",
             const std::string& substitute = "")
{
  namespace po = boost::program_options;
  po::options_description all;
  std::vector<std::string> inputs;
  all.add(description)
      .add_options()("version", po::bool_switch())(kind.c_str(), po::value(&inputs), "the input");
  po::positional_options_description positions;
  positions.add(kind.c_str(), -1);

  po::variables_map result;
  try
  {
    const po::parsed_options parsed =
        po::command_line_parser(argc, argv)
            .options(all)
            .positional(positions)
            .style(po::command_line_style::unix_style ^ po::command_line_style::allow_guessing)
            .extra_style_parser(read_negative_number)
            .run();
    check_values(parsed);
    po::store(parsed, result);
  }
  catch(const po::invalid_command_line_syntax& e)
  {
    if(e.kind() == po::invalid_syntax::missing_parameter ||
       e.kind() == po::invalid_syntax::empty_adjacent_parameter)
      throw std::invalid_argument(e.get_option_name() + ": a value must follow");
    throw;
  }
  po::notify(result);
  if(result["version"].as<bool>())
    print_version(argv[0]);
  if(inputs.size() > 1)
    throw std::invalid_argument("more than one " + kind + " is given: " + inputs[0] + " and " +
                                inputs[1]);
  if(!inputs.empty())
    input = inputs.front();
  if(input.empty() && !result["help"].as<bool>() && result.count(substitute) == 0)
    throw std::invalid_argument("no " + kind + " given (it comes before the options); try --help");
  return result;
}

// Numbers, which are read as text first, so that what is wrong can be said in words.

inline double number_of(const std::string& option, const std::string& text)
{
  char* end = nullptr;
  const double result = std::strtod(text.c_str(), &end);
  if(text.empty() || *end != '\0' || std::isnan(result))
    reject_option(option, '"' + text + "\" is not a number");
  return result;
}

inline double
number_from_0(const std::string& option, const std::string& text, const bool may_be_infinite)
{
  const double result = number_of(option, text);
  if(result < 0 || (!may_be_infinite && std::isinf(result)))
    reject_option(option, "it is " + text + ", and must be a number that is not negative" +
                              (may_be_infinite ? "" : ", nor infinite"));
  return result;
}

// An error bound. Above 1, a percentage has mostly been meant.
inline double error_bound(const std::string& option, const std::string& text)
{
  const double result = number_from_0(option, text, false);
  if(result > 1)
    reject_option(option, "it is " + text +
                              ", which would let paths be more than twice as long as "
                              "the shortest ones; 0.05 stands for 5 %");
  return result;
}

inline std::size_t
whole_number(const std::string& option, const std::string& text, const std::size_t least)
{
  const bool is_number = !text.empty() && text.size() < 10 &&
                         text.find_first_not_of("0123456789") == std::string::npos;
  if(!is_number || std::stoul(text) < least)
    reject_option(option, '"' + text + "\" is not a whole number from " + std::to_string(least) +
                              " to 999999999");
  return std::stoul(text);
}

#endif // COMMAND_LINE_READ_OPTIONS_H
