#ifndef GEODESIC_MATRIX_OPTIONS_H
#define GEODESIC_MATRIX_OPTIONS_H

#include "../command_line/read_options.h"

#include <boost/program_options.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// What the user wants, as checked as it can be before the mesh is read.
struct Options
{
  std::string input;
  std::vector<std::string> sources;
  std::vector<std::string> targets;
  std::uint64_t seed = 0;
  double radius = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;       // columns of a row; 0 stands for all
  std::optional<double> epsilon; // none: along edges
  std::string type;
  bool is_symmetric = false;
  std::string output;
  std::size_t threads = 0; // 0 stands for all cores
  bool may_resume = true;
  bool only_estimates = false;
  bool asks_for_help = false;

  bool is_sparse() const { return nearest > 0 || radius < std::numeric_limits<double>::infinity(); }
};

inline boost::program_options::options_description describe_options(Options& options)
{
  namespace po = boost::program_options;
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  po::options_description description("Options");
  po::options_description_easy_init add = description.add_options();
  add("help,h", po::bool_switch(&options.asks_for_help),
      "print this text; --version prints the version");
  add("sources,s",
      po::value(&options.sources)->multitoken()->default_value({"all"}, "all")->value_name("V ..."),
      "the vertices that the rows belong to. V is the index of a vertex, counted from 0 in the "
      "order of the file, whatever had to be repaired in that; or random:K for K different random "
      "vertices; farthest:K for K ones that "
      "are spread evenly; file:NAME for those whose indices a text file lists, with comments after "
      "#; or all");
  add("targets,t", po::value(&options.targets)->multitoken()->value_name("V ..."),
      "the vertices that the columns belong to, given likewise (default: all, or the sources if "
      "--symmetric)");
  add("seed", text("N"), "what random vertices depend on (default: 0)");
  add("radius,r", text("D"), "keep distances up to D only, in the unit of the coordinates");
  add("nearest,k", text("K"), "keep the K smallest distances of each row only");
  add("epsilon,e", text("E"),
      "let paths run across faces, and be at most 1 + E times as long as the shortest ones on the "
      "surface, for E up to 1: 0.05 stands for 5 %; 0 gives the shortest ones (default: along "
      "edges, without a bound)");
  add("type", po::value(&options.type)->default_value("float32")->value_name("TYPE"),
      "float32 or float64");
  add("symmetric", po::bool_switch(&options.is_symmetric),
      "replace each distance by the smaller one of both directions");
  add("output,o", po::value(&options.output)->value_name("FILE"),
      "the file, .npy; or, if --radius or --nearest is given, a folder of files, .csr (default: "
      "distances.npy or distances.csr)");
  add("threads", text("N"), "threads of each process (default: one per core that it may use)");
  add("resume", po::value<std::string>()->default_value("yes")->value_name("yes|no"),
      "whether to resume an earlier run of the same command");
  add("estimate", po::bool_switch(&options.only_estimates),
      "only tell how long the file would be, and how much memory and time it would take, which "
      "takes about a second; nothing is written");
  return description;
}

inline void print_help(const boost::program_options::options_description& description)
{
  std::cout
      << "Usage: geodesic_matrix MESH [options]\n\n"
         "Computes distances between many vertices of a triangle mesh, on all cores, and writes\n"
         "them to a file for NumPy: numpy.load(FILE, mmap_mode=\"r\"), with a row per source and\n"
         "a column per target. If only some of each row are kept, they are the arrays of a sparse\n"
         "matrix, FOLDER/data.npy, indices.npy, indptr.npy and shape.npy, for\n"
         "scipy.sparse.csr_matrix((data, indices, indptr), shape=shape).\n\n"
         "When it is complete, NAME.vertices.npy beside the file NAME.npy, or vertices.npy in the\n"
         "folder NAME.csr, has the indices of the vertices that the rows belong to, and\n"
         "NAME.columns.npy, or columns.npy, those of the columns, unless they are the same.\n"
         "Vertices without faces are infinitely far from all others.\n\n"
         "If a run ends early, by Ctrl-C, an error or a kill, the same command resumes it. Only\n"
         "the rows are lost that each thread is computing, 64 or fewer. Until all is complete, "
         "the\n"
         "finished rows are in the folder FILE.part.\n\n"
         "If the program was built with MPI, several processes compute one file. Best is one on\n"
         "each machine, with all of its cores as threads, which share the graph in memory:\n"
         "  mpirun --map-by ppr:1:node --bind-to none geodesic_matrix MESH [options]\n"
         "Several processes on one machine need --threads, so that they share the cores.\n\n"
      << description
      << "\nThe exit status is 0 if the file is complete; 1, with a message on standard error, if\n"
         "something was refused or failed; and 128 and the number of a signal that ended the run.\n"
         "\nExamples:\n"
         "  geodesic_matrix cortex.ply --epsilon 0.1 --output cortex.npy\n"
         "  geodesic_matrix cortex.ply --epsilon 0.1 --radius 15 --output patches.csr\n"
         "  geodesic_matrix cortex.ply --sources farthest:1000 --symmetric --output samples.npy\n"
         "  geodesic_matrix cortex.ply --epsilon 0 --estimate\n";
}

// What option parsing cannot tell by itself.
inline void read_numbers(const boost::program_options::variables_map& values, Options& options)
{
  const auto text = [&](const char* option) { return values[option].as<std::string>(); };
  if(values.count("seed") > 0)
    options.seed = whole_number("seed", text("seed"), 0);
  if(values.count("nearest") > 0)
    options.nearest = whole_number("nearest", text("nearest"), 1);
  if(values.count("threads") > 0)
    options.threads = whole_number("threads", text("threads"), 1);
  if(values.count("radius") > 0)
    options.radius = number_from_0("radius", text("radius"), false);
  if(values.count("epsilon") > 0)
    options.epsilon = error_bound("epsilon", text("epsilon"));
  const std::string resume = text("resume");
  if(resume != "yes" && resume != "no")
    reject_option("resume", '"' + resume + "\" is neither yes nor no");
  options.may_resume = resume == "yes";
}

inline void check_output(Options& options)
{
  namespace fs = std::filesystem;
  const std::string extension = options.is_sparse() ? ".csr" : ".npy";
  if(options.output.empty())
    options.output = "distances" + extension;
  fs::path path(options.output);
  if(!path.has_filename() && path.has_parent_path()) // a slash behind the name of a folder
    options.output = (path = path.parent_path()).string();
  if(path.has_filename() && path.filename() == extension)
    reject_option("output", options.output + " has only an ending; a name must come before it");
  if(path.extension() != extension)
    reject_option("output", options.output + " must end with " + extension +
                                (options.is_sparse() ? ", as --radius and --nearest make the matrix"
                                                       " sparse; without them, it is .npy"
                                                     : "; with --radius or --nearest, it is .csr"));
  if(path.has_parent_path() && !fs::is_directory(path.parent_path()))
    reject_option("output", "there is no folder " + path.parent_path().string());
}

inline void check_combination(Options& options)
{
  if(options.type != "float32" && options.type != "float64")
    reject_option("type", '"' + options.type + "\" is neither float32 nor float64");
  if(options.is_symmetric && options.is_sparse())
    reject_option("symmetric", "it is for all distances, without --radius and --nearest");
  if(options.targets.empty())
    options.targets = options.is_symmetric ? options.sources : std::vector<std::string>{"all"};
  if(options.is_symmetric && options.targets != options.sources)
    reject_option("symmetric", "--targets must be the same as --sources");
  check_output(options);
}

inline Options parse_options(const int argc, char* argv[])
{
  Options options;
  const boost::program_options::options_description description = describe_options(options);
  const auto values = read_options(argc, argv, description, options.input);
  if(options.asks_for_help)
  {
    print_help(description);
    return options;
  }
  read_numbers(values, options);
  check_combination(options);
  return options;
}

#endif // GEODESIC_MATRIX_OPTIONS_H
