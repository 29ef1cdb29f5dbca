// Distances and shortest paths on a mesh, from the command line: see --help.

#include "../command_line/read_mesh.h"
#include "../command_line/vertex_numbers.h"
#include "Options.h"
#include "Report.h"
#include "exact_comparison.h"
#include "picture.h"
#include "results.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using Vertex = Mesh::Vertex_index;
using CGAL::Approximate_geodesics::Discrete_geodesic_graph;
using CGAL::Approximate_geodesics::Edge_graph;
using CGAL::Approximate_geodesics::Saddle_vertex_graph;
template <typename Graph>
using Shortest_paths = CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh, Graph>;

namespace parameters = CGAL::parameters;

// A vertex is given by its index; `random:K` stands for K of them.
std::vector<Vertex>
select_vertices(const std::vector<std::string>& names, const Mesh& mesh, std::mt19937_64& random)
{
  std::vector<Vertex> result;
  for(const std::string& name : names)
    if(const auto number = number_after("random", name))
    {
      for(std::size_t k = *number; k > 0; --k)
        result.push_back(
            Vertex(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices())));
    }
    else
    {
      const std::size_t index = to_number(name);
      check_vertex_index(index, mesh.number_of_vertices());
      result.push_back(Vertex(static_cast<Mesh::size_type>(index)));
    }
  return result;
}

template <typename Graph, typename... NamedParameters>
void run(const Options& options, const NamedParameters&... np)
{
  const Mesh mesh = read_mesh(options.input);
  std::mt19937_64 random(options.seed);
  const std::vector<Vertex> sources = select_vertices(options.sources, mesh, random);
  const std::vector<Vertex> targets = select_vertices(options.targets, mesh, random);
  Report report;
  report.add_mesh(mesh);

  Stopwatch stopwatch;
  Shortest_paths<Graph> shortest_paths(mesh, np...);
  report.seconds_to_build = stopwatch.seconds();

  shortest_paths.add_source_points(sources.begin(), sources.end());
  Progress_bar progress;
  stopwatch.restart();
  shortest_paths.build_sequence_tree(
      parameters::maximum_distance(options.maximum_distance).visitor(std::ref(progress)));
  report.seconds_to_first_search = stopwatch.seconds();

  stopwatch.restart();
  shortest_paths.build_sequence_tree(parameters::maximum_distance(options.maximum_distance));
  report.seconds_to_search = stopwatch.seconds();

  shortest_paths.collect_statistics(true);
  shortest_paths.build_sequence_tree(parameters::maximum_distance(options.maximum_distance));
  report.add_search(shortest_paths.search());

  const Results<Mesh> results(mesh, shortest_paths, targets);
  report.add_distances(results.distances);
  if(options.compares)
  {
    std::cerr << "Computing the exact distances ...\n";
    report.comparison = compare_with_exact_distances(mesh, sources, results.distances);
  }
  report.print(std::cout);

  write_distances(options.output + ".ply", mesh, results);
  write_paths(options.output + ".polylines.txt", results.paths);
  Scene_writer(mesh, sources, results).write(options.output + ".vtk");
  if(options.draws)
    draw_picture(options.output, options.view);
}

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parse_options(argc, argv);
    if(options.asks_for_help)
      return EXIT_SUCCESS;
    if(options.is_along_edges)
      run<Edge_graph>(options);
    else if(options.epsilon == 0)
      run<Saddle_vertex_graph>(options);
    else
      run<Discrete_geodesic_graph>(options, parameters::epsilon(options.epsilon));
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "geodesic_distances: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
