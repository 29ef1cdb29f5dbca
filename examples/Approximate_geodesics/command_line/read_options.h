#ifndef COMMAND_LINE_READ_OPTIONS_H
#define COMMAND_LINE_READ_OPTIONS_H

#include <boost/program_options.hpp>

#include <stdexcept>
#include <string>

// Reads the options, and the mesh, which comes without a name. It may be missing only if `help` is
// asked for.
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
  po::store(po::command_line_parser(argc, argv).options(all).positional(positions).run(), result);
  po::notify(result);
  if(mesh.empty() && !result["help"].as<bool>())
    throw std::invalid_argument("no mesh given (it comes before the options); try --help");
  return result;
}

#endif // COMMAND_LINE_READ_OPTIONS_H
