#ifndef GEODESIC_DISTANCES_REPORT_H
#define GEODESIC_DISTANCES_REPORT_H

#include "../command_line/Stopwatch.h"
#include "../command_line/Table.h"
#include "exact_comparison.h"

#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <ostream>
#include <vector>

// Says how far a search is, if it takes more than a second.
class Progress_bar : public CGAL::Approximate_geodesics::Geodesic_visitor_base
{
public:
  void on_progress(const std::size_t number_settled, const std::size_t number_of_nodes)
  {
    if(m_stopwatch.seconds() < 1)
      return;
    m_stopwatch.restart();
    std::cerr << "Searching: " << 100 * number_settled / number_of_nodes << " %\n";
  }

private:
  Stopwatch m_stopwatch;
};

// What the program prints.
class Report
{
public:
  double seconds_to_build = 0;
  double seconds_to_first_search = 0;
  double seconds_to_search = 0;
  std::optional<Exact_comparison> comparison;

  template <typename Mesh>
  void add_mesh(const Mesh& mesh)
  {
    m_table.add("vertices", mesh.number_of_vertices());
    m_table.add("edges", mesh.number_of_edges());
    m_table.add("faces", mesh.number_of_faces());
  }

  template <typename Search>
  void add_search(const Search& search)
  {
    const auto buckets = search.queue().statistics();
    const auto& counts = search.statistics();
    const double unit = search.graph().triangulation().unit();
    m_table.add_milliseconds("building the graph", seconds_to_build);
    m_table.add_milliseconds("first search, progress watched", seconds_to_first_search);
    m_table.add_milliseconds("second search", seconds_to_search);
    m_table.add("vertices settled", counts.settled_nodes);
    m_table.add("pops", counts.pops);
    m_table.add("  of them stale", counts.stale_pops);
    m_table.add("  of them repeated", counts.repeated_pops());
    m_table.add("relaxations", counts.relaxations);
    m_table.add("buckets visited", buckets.visited_buckets);
    m_table.add("  of them not empty", buckets.used_buckets);
    m_table.add("bucket width", buckets.width * unit);
    m_table.add("entries per bucket, mean", buckets.mean_occupancy());
    m_table.add("entries per bucket, deviation", buckets.standard_deviation_of_occupancy());
    const std::size_t bytes = search.graph().memory() + search.memory();
    m_table.add("bytes per vertex",
                static_cast<double>(bytes) / static_cast<double>(search.graph().number_of_nodes()));
  }

  // infinite distances are those of vertices not reached
  void add_distances(const std::vector<double>& distances)
  {
    double largest = 0, sum = 0;
    std::size_t number_reached = 0;
    for(const double distance : distances)
      if(std::isfinite(distance))
      {
        largest = (std::max)(largest, distance);
        sum += distance;
        ++number_reached;
      }
    m_table.add("vertices reached", number_reached);
    m_table.add("distance, mean",
                number_reached == 0 ? 0 : sum / static_cast<double>(number_reached));
    m_table.add("distance, largest", largest);
  }

  void print(std::ostream& out)
  {
    if(comparison)
      add_comparison();
    m_table.print(out);
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
