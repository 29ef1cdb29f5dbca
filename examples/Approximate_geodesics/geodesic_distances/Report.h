#ifndef GEODESIC_DISTANCES_REPORT_H
#define GEODESIC_DISTANCES_REPORT_H

#include "Stopwatch.h"
#include "exact_comparison.h"

#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
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
    add("vertices", mesh.number_of_vertices());
    add("edges", mesh.number_of_edges());
    add("faces", mesh.number_of_faces());
  }

  template <typename Search>
  void add_search(const Search& search)
  {
    const auto buckets = search.queue().statistics();
    const auto& counts = search.statistics();
    const double unit = search.graph().triangulation().unit();
    add_seconds("building the graph", seconds_to_build);
    add_seconds("first search, progress watched", seconds_to_first_search);
    add_seconds("second search", seconds_to_search);
    add("vertices settled", counts.settled_nodes);
    add("pops", counts.pops);
    add("  of them stale", counts.stale_pops);
    add("  of them repeated", counts.repeated_pops());
    add("relaxations", counts.relaxations);
    add("buckets visited", buckets.visited_buckets);
    add("  of them not empty", buckets.used_buckets);
    add("bucket width", buckets.width * unit);
    add("entries per bucket, mean", buckets.mean_occupancy());
    add("entries per bucket, deviation", buckets.standard_deviation_of_occupancy());
    const std::size_t bytes = search.graph().memory() + search.memory();
    add("bytes per vertex",
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
    add("vertices reached", number_reached);
    add("distance, mean", number_reached == 0 ? 0 : sum / static_cast<double>(number_reached));
    add("distance, largest", largest);
  }

  void print(std::ostream& out)
  {
    if(comparison)
      add_comparison();
    for(const Row& row : m_rows)
      out << std::left << std::setw(34) << row.name << std::right << std::setw(14) << row.value
          << '\n';
  }

private:
  struct Row
  {
    std::string name;
    std::string value;
  };

  template <typename Number>
  void add(const std::string& name, const Number number, const std::string& unit = "")
  {
    std::ostringstream text;
    text << std::setprecision(6) << number << unit;
    m_rows.push_back({name, text.str()});
  }

  void add_seconds(const std::string& name, const double seconds)
  {
    add(name, std::round(seconds * 1e6) / 1e3, " ms");
  }

  void add_comparison()
  {
    add_seconds("exact distances, by CGAL", comparison->seconds);
    add_seconds("exact distances, epsilon 0", comparison->seconds_of_ours);
    add("  largest difference, relative", comparison->largest_difference_of_ours);
    add("error, mean", 100 * comparison->mean_error, " %");
    add("error, largest", 100 * comparison->largest_error, " %");
    add("error, smallest signed", 100 * comparison->smallest_error, " %");
    add("vertices below the exact distance", comparison->number_below);
  }

  std::vector<Row> m_rows;
};

#endif // GEODESIC_DISTANCES_REPORT_H
