#ifndef COMMAND_LINE_READ_OPTIONS_H
#define COMMAND_LINE_READ_OPTIONS_H

#include <boost/program_options.hpp>

#include <stdexcept>
#include <string>
#include <vector>

[[noreturn]] inline void reject_option(const std::string& option, const std::string& reason)
{
  throw std::invalid_argument("--" + option + ": " + reason);
}

// Takes a word such as -1.5 or -1,0,2 for a value, and not for an option.
inline std::vector<boost::program_options::option>
read_negative_number(std::vector<std::string>& words)
{
  const std::string word = words.front();
  if(word.size() < 2 || word[0] != '-' || word.find_first_of("0123456789.", 1) != 1)
    return {};
  words.erase(words.begin());
  boost::program_options::option result;
  result.value = {word};
  result.original_tokens = {word};
  return {result};
}

// Reads the options, whose names cannot be abbreviated, and the mesh, which comes without a name.
// It may be missing only if `help` is asked for.
inline boost::program_options::variables_map
read_options(const int argc,
             char* argv[],
             const boost::program_options::options_description& description,
             std::string& mesh)
{
  namespace po = boost::program_options;
  po::options_description all;
  all.add(description).add_options()("mesh", po::value(&mesh), "the mesh");
  po::positional_options_description positions;
  positions.add("mesh", 1);

  po::variables_map result;
  try
  {
    po::store(
        po::command_line_parser(argc, argv)
            .options(all)
            .positional(positions)
            .style(po::command_line_style::unix_style ^ po::command_line_style::allow_guessing)
            .extra_style_parser(read_negative_number)
            .run(),
        result);
  }
  catch(const po::too_many_positional_options_error&)
  {
    throw std::invalid_argument("more than one mesh is given");
  }
  po::notify(result);
  if(mesh.empty() && !result["help"].as<bool>())
    throw std::invalid_argument("no mesh given (it comes before the options); try --help");
  return result;
}

#endif // COMMAND_LINE_READ_OPTIONS_H
