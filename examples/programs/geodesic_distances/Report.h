#ifndef GEODESIC_DISTANCES_REPORT_H
#define GEODESIC_DISTANCES_REPORT_H

#include "../command_line/Table.h"
#include "exact_comparison.h"
#include "results.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// What the program prints.
class Report
{
public:
  std::optional<Exact_comparison> comparison;

  // the vertices are those of the file
  void add_mesh(const Mesh_of_file& mesh, const double seconds_to_read)
  {
    m_table.add("vertices", mesh.vertices.number());
    m_table.add("edges", mesh.mesh.number_of_edges());
    m_table.add("faces", mesh.mesh.number_of_faces());
    m_table.add("connected components", number_of_components(mesh.mesh));
    m_table.add_milliseconds("reading the mesh", seconds_to_read);
  }

  void add_times(const double seconds_to_build, const double seconds_to_search)
  {
    m_table.add_milliseconds("building the graph", seconds_to_build);
    m_table.add_milliseconds("search", seconds_to_search);
    m_table.add_milliseconds("first answer, both together", seconds_to_build + seconds_to_search);
  }

  void add_graph(const CGAL::Approximate_geodesics::Discrete_geodesic_graph& /* graph */)
  {
    m_table.add("arcs are computed", "in advance");
  }

  void add_graph(const CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph& /* graph */)
  {
    m_table.add("arcs are computed", "by the search");
  }

  void add_bound(const double epsilon) { m_table.add("bound that holds, epsilon", epsilon); }

  // of a run that was counted, and one that was not
  template <typename Search>
  void add_statistics(const Search& search, const double seconds_to_search_again)
  {
    const auto buckets = search.queue().statistics();
    const auto& counts = search.statistics();
    m_table.add_milliseconds("second search", seconds_to_search_again);
    m_table.add("nodes settled", counts.settled_nodes);
    m_table.add("pops", counts.pops);
    m_table.add("  of them stale", counts.stale_pops);
    m_table.add("  of them repeated", counts.repeated_pops());
    m_table.add("relaxations", counts.relaxations);
    m_table.add("buckets visited", buckets.visited_buckets);
    m_table.add("  of them not empty", buckets.used_buckets);
    m_table.add("bucket width", buckets.width * search.graph().triangulation().unit());
    m_table.add("entries per bucket, mean", buckets.mean_occupancy());
    m_table.add("entries per bucket, deviation", buckets.standard_deviation_of_occupancy());
    const std::size_t bytes = search.graph().memory() + search.memory();
    const std::size_t number_of_vertices = search.graph().triangulation().number_of_vertices();
    m_table.add("bytes per vertex", double(bytes) / double(number_of_vertices));
  }

  // of the first vertices; infinite distances are those of vertices not reached
  void add_distances(const std::vector<double>& distances, const std::size_t number_of_vertices)
  {
    double smallest = 0, largest = 0, sum = 0;
    std::size_t number_reached = 0;
    for(std::size_t i = 0; i < number_of_vertices; ++i)
      if(const double distance = distances[i]; std::isfinite(distance))
      {
        smallest = (std::min)(smallest, distance);
        largest = (std::max)(largest, distance);
        sum += distance;
        ++number_reached;
      }
    m_table.add("vertices reached", number_reached);
    m_table.add("distance, mean",
                number_reached == 0 ? 0 : sum / static_cast<double>(number_reached));
    if(smallest < 0)
      m_table.add("distance, smallest", smallest);
    m_table.add("distance, largest", largest);
  }

  void print(std::ostream& out)
  {
    if(comparison)
      add_comparison();
    m_table.print(out);
  }

  // The length of each path that was asked for.
  static void print_paths(const std::vector<Path_result>& paths, std::ostream& out)
  {
    if(paths.empty())
      return;
    const auto row = [&](const std::string& source, const std::string& target) -> std::ostream& {
      return out << std::left << std::setw(24) << source << ' ' << std::setw(24) << target << ' ';
    };
    out << '\n';
    row("from source", "to target") << "length\n";
    for(const Path_result& path : paths)
      row(path.source.empty() ? "none" : path.source, path.target)
          << std::setprecision(12) << path.length << '\n';
  }

private:
  void add_comparison()
  {
    m_table.add_milliseconds("exact distances, by CGAL", comparison->seconds);
    m_table.add_milliseconds("exact distances, epsilon 0", comparison->seconds_of_ours);
    m_table.add("  largest difference, relative", comparison->largest_difference_of_ours);
    m_table.add("error, mean", 100 * comparison->mean_error, " %");
    m_table.add("error, largest", 100 * comparison->largest_error, " %");
    m_table.add("error, smallest signed", 100 * comparison->smallest_error, " %");
    m_table.add("vertices below the exact distance", comparison->number_below);
  }

  Table m_table;
};

#endif // GEODESIC_DISTANCES_REPORT_H
