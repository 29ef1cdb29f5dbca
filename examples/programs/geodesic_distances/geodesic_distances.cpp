// Distances and shortest paths on a mesh, from the command line: see --help.

#include "../command_line/Progress.h"
#include "../command_line/Stopwatch.h"
#include "../command_line/files.h"
#include "../command_line/lines_of_file.h"
#include "../command_line/read_mesh.h"
#include "../command_line/run_program.h"
#include "../command_line/vertex_numbers.h"
#include "Options.h"
#include "Output_files.h"
#include "Places.h"
#include "answer.h"
#include "costs.h"
#include "parse_options.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs.h>

#include <boost/property_map/property_map.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using CGAL::Approximate_geodesics::Discrete_geodesic_graph;
using CGAL::Approximate_geodesics::Edge_graph;
using CGAL::Approximate_geodesics::Intrinsic_triangulation;
using CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph;
using CGAL::Approximate_geodesics::Saddle_vertex_graph;
using CGAL::Approximate_geodesics::Steiner_graph;
namespace parameters = CGAL::parameters;

const auto no_description = [](const auto& /* graph */, Report&) {};
const auto describe_arcs = [](const auto& graph, Report& report) { report.add_graph(graph); };

void answer_with_loaded_graph(const Question& question)
{
  const std::string& file = question.options.graph_to_load;
  answer(
      question,
      [&] {
        return name_in_errors("--load-graph " + file, [&] {
          std::ifstream in = open_to_read(file, std::ios::binary);
          return Discrete_geodesic_graph::load(in, Intrinsic_triangulation(question.mesh.mesh));
        });
      },
      [](const auto& graph, Report& report) { report.add_bound(graph.epsilon()); });
}

// A graph that is built answers many questions in less time; for one, only the arcs that the search
// meets are computed.
void answer_within_bound(const Question& question)
{
  const double epsilon = *question.options.epsilon;
  if(epsilon < 0.001)
    std::clog
        << "--epsilon " << epsilon
        << ": so small a bound takes long, and much memory; --epsilon 0 is exact, and mostly takes "
           "less of both.\n";
  if(question.options.graph_to_save.empty())
    return answer(
        question,
        [&] {
          return Lazy_discrete_geodesic_graph(Intrinsic_triangulation(question.mesh.mesh),
                                              parameters::epsilon(epsilon));
        },
        describe_arcs);
  answer(
      question,
      [&] {
        return Discrete_geodesic_graph(Intrinsic_triangulation(question.mesh.mesh),
                                       parameters::epsilon(epsilon));
      },
      describe_arcs,
      [](const Discrete_geodesic_graph& graph, std::ostream& out) { graph.save(out); });
}

template <typename NamedParameters>
void answer_with_costs(const Question& question, const NamedParameters& np)
{
  answer(
      question,
      [&] {
        try
        {
          return Steiner_graph<>(Intrinsic_triangulation(question.mesh.mesh, np), np);
        }
        catch(const std::length_error& e)
        {
          throw std::invalid_argument(std::string("--epsilon: ") + e.what());
        }
      },
      [&](const auto& graph, Report& report) {
        if(question.options.accepts_weaker_bound)
          report.add_bound(graph.epsilon());
      });
}

void answer_with_costs(const Question& question)
{
  const Mesh& mesh = question.mesh.mesh;
  const std::vector<double> weights = read_weights(question.options, question.mesh);
  const std::vector<bool> barriers = read_barriers(question.options, question.mesh);
  const auto np = parameters::epsilon(*question.options.epsilon)
                      .accept_weaker_bound(question.options.accepts_weaker_bound)
                      .edge_is_constrained_map(boost::make_iterator_property_map(
                          barriers.begin(), get(boost::edge_index, mesh)));
  if(question.options.weights.empty()) // or else paths could not be straightened
    answer_with_costs(question, np);
  else
    answer_with_costs(question, np.face_weight_map(boost::make_iterator_property_map(
                                    weights.begin(), get(boost::face_index, mesh))));
}

void answer(const Question& question)
{
  const Options& options = question.options;
  if(options.has_costs())
    answer_with_costs(question);
  else if(!options.graph_to_load.empty())
    answer_with_loaded_graph(question);
  else if(options.epsilon && *options.epsilon > 0)
    answer_within_bound(question);
  else if(options.epsilon)
    answer(
        question, [&] { return Saddle_vertex_graph(Intrinsic_triangulation(question.mesh.mesh)); },
        no_description);
  else
    answer(
        question, [&] { return Edge_graph(Intrinsic_triangulation(question.mesh.mesh)); },
        no_description);
}

// What would be refused after the mesh was read.
void check(const Options& options)
{
  check_readable(options.input);
  Place_finder::check("--sources", options.sources);
  Place_finder::check("--curve", options.curve);
  Place_finder::check("--targets", options.targets);
  check_option_file("load-graph", options.graph_to_load);
  check_option_file("barriers", options.barriers);
  if(!names_property(options.weights))
    check_option_file("weights", options.weights);
}

void run(const Options& options)
{
  check(options);
  const Output_files files(options);
  const Stopwatch stopwatch;
  Mesh_of_file mesh = [&] {
    const Progress progress("Reading the mesh");
    return read_mesh(options.input);
  }();
  Question question{options, files, std::move(mesh), stopwatch.seconds(), {}, {}};
  Place_finder finder(question.mesh, options.seed);
  question.sources = options.curve.empty() ? finder.find("--sources", options.sources)
                                           : finder.find("--curve", options.curve);
  question.targets = finder.find("--targets", options.targets);
  answer(question);
}

int main(int argc, char* argv[])
{
  return run_program("geodesic_distances", [&] {
    const Options options = parse_options(argc, argv);
    if(!options.asks_for_help)
      run(options);
    return EXIT_SUCCESS;
  });
}
