#ifndef GEODESIC_DISTANCES_ANSWER_H
#define GEODESIC_DISTANCES_ANSWER_H

#include "../command_line/Progress.h"
#include "../command_line/Stopwatch.h"
#include "../command_line/read_mesh.h"
#include "../command_line/vertex_numbers.h"
#include "Options.h"
#include "Output_files.h"
#include "Places.h"
#include "Report.h"
#include "exact_comparison.h"
#include "results.h"

#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <cstddef>
#include <functional>
#include <iostream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// What is asked for.
struct Question
{
  const Options& options;
  const Output_files& files;
  Mesh_of_file mesh;
  double seconds_to_read;
  std::vector<Place> sources;
  std::vector<Place> targets;
};

// Tells a progress line how far a search is.
class Search_progress : public CGAL::Approximate_geodesics::Geodesic_visitor_base
{
public:
  static constexpr bool is_told_of_nodes = false; // which would cost time

  explicit Search_progress(Progress& progress) : m_progress(progress) {}

  void on_progress(const std::size_t number_settled, const std::size_t number_of_nodes)
  {
    m_progress.set_part(number_settled, number_of_nodes);
  }

private:
  Progress& m_progress;
};

template <typename Shortest_paths>
double seconds_of_search(Shortest_paths& shortest_paths, const Options& options)
{
  Progress progress("Searching");
  Search_progress visitor(progress);
  const Stopwatch stopwatch;
  shortest_paths.build_sequence_tree(
      CGAL::parameters::maximum_distance(options.maximum_distance).visitor(std::ref(visitor)));
  return stopwatch.seconds();
}

template <typename Shortest_paths>
void add_statistics(Shortest_paths& shortest_paths, const Options& options, Report& report)
{
  const double seconds = seconds_of_search(shortest_paths, options);
  shortest_paths.collect_statistics(true);
  seconds_of_search(shortest_paths, options);
  report.add_statistics(shortest_paths.search(), seconds);
}

inline void add_comparison(const Question& question, const Results& results, Report& report)
{
  const Progress progress("Computing the exact distances");
  report.comparison =
      compare_with_exact_distances(question.mesh.mesh, question.sources, results.distances);
}

// Where there is no path, the table could be overlooked.
inline void tell_of_missing_paths(const Results& results)
{
  for(const Path_result& path : results.paths)
    if(path.points.empty())
      std::clog << "There is no path to target " << path.target
                << ": no source is connected with it, or it is farther away than "
                   "--maximum-distance, or behind what cannot be passed.\n";
}

// A file without lines could be taken for a failure.
inline void tell_of_missing_lines(const std::string& option,
                                  const std::vector<double>& without,
                                  const Results& results)
{
  if(!without.empty())
    std::clog << option << ": there are none at " << without.size() << " of the distances, such as "
              << without.front() << "; those of vertices go from " << results.smallest << " to "
              << results.largest << ".\n";
}

// A graph that is used for one question only, and has no file.
struct No_file
{
  template <typename Graph>
  void operator()(const Graph& /* graph */, std::ostream& /* out */) const
  {
  }
};

// Searches the graph that `make_graph()` returns, prints and writes all that is asked for. The
// graph is handed to `describe_graph` first, and to `save_graph` if it is to be written.
template <typename MakeGraph, typename DescribeGraph, typename SaveGraph = No_file>
void answer(const Question& question,
            const MakeGraph make_graph,
            const DescribeGraph describe_graph,
            const SaveGraph save_graph = {})
{
  using Graph = decltype(make_graph());
  Report report;
  const Mesh& mesh = question.mesh.mesh;
  const Sources sources(question.sources);
  report.add_mesh(question.mesh, question.seconds_to_read);

  const Stopwatch stopwatch;
  Graph graph = [&] {
    const Progress progress("Building the graph");
    return make_graph();
  }();
  const double seconds_to_build = stopwatch.seconds();
  describe_graph(graph, report);

  CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh, Graph> shortest_paths(
      mesh, std::move(graph));
  if(!question.options.curve.empty())
    name_in_errors("--curve",
                   [&] { shortest_paths.add_source_curve(curve_through(question.sources)); });
  else
    for(const Place& source : question.sources)
      for(const auto& point : source.points)
        shortest_paths.add_source_point(point);
  report.add_times(seconds_to_build, seconds_of_search(shortest_paths, question.options));

  Results results = find_results(mesh, shortest_paths, sources, question.targets, question.options);
  if(question.options.offsets.are_given())
  {
    const Progress progress("Following the offsets");
    find_offsets(mesh, question.sources, question.options, results);
  }
  if(question.options.compares)
    add_comparison(question, results, report);
  unite_copies(question.mesh.vertices, results);
  report.add_distances(results.distances, question.mesh.vertices.number());
  if(question.options.prints_statistics)
    add_statistics(shortest_paths, question.options, report);
  report.print(std::cout);
  Report::print_paths(results.paths, std::cout);
  std::cout.flush(); // what fails shall fail before anything is written
  tell_of_missing_paths(results);
  tell_of_missing_lines("--isolines", results.without_isolines, results);
  tell_of_missing_lines("--offset", results.without_offsets, results);
  question.files.write(question.mesh, results, [&](std::ostream& out) {
    save_graph(shortest_paths.search().graph(), out);
  });
  question.files.print(std::cout);
}

#endif // GEODESIC_DISTANCES_ANSWER_H
