#ifndef GEODESIC_DISTANCES_RESULTS_H
#define GEODESIC_DISTANCES_RESULTS_H

#include "../command_line/read_mesh.h"
#include "Options.h"
#include "Places.h"

#include <CGAL/Approximate_geodesics/Queries/isolines.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

// A path from a target to its nearest source.
struct Path_result
{
  std::string target;
  std::string source; // none, if there is no path
  double length = std::numeric_limits<double>::infinity();
  std::vector<Mesh::Point> points;
};

struct Isoline
{
  double distance;
  std::vector<Mesh::Point> points;
};

// What is printed, and written to files.
struct Results
{
  std::vector<Mesh::Point> sources;
  std::vector<double> distances;             // by vertex; infinity where no source reaches it
  std::vector<std::int64_t> nearest_sources; // by vertex; positions, or -1
  double smallest = 0, largest = 0;          // of the finite distances
  std::vector<Path_result> paths;            // in the order of the targets
  std::vector<Isoline> isolines;
  std::vector<double> without_isolines; // distances that were asked for
};

template <typename Map>
auto vertex_map(const Mesh& mesh, Map& values)
{
  return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, mesh));
}

template <typename Shortest_paths>
Path_result find_path(Shortest_paths& shortest_paths,
                      const Place& target,
                      const std::vector<Place>& sources,
                      const bool straightens)
{
  using Surface_point = typename Shortest_paths::Surface_point;
  Path_result result;
  result.target = target.name;
  std::vector<Surface_point> points;
  const auto answer = shortest_paths.shortest_path_surface_points_to_source_points(
      target.point, std::back_inserter(points), CGAL::parameters::straighten(straightens));
  if(answer.second == shortest_paths.source_points_end())
    return result;
  result.length = answer.first;
  result.source =
      sources[std::size_t(std::distance(shortest_paths.source_points_begin(), answer.second))].name;
  for(const Surface_point& p : points)
    result.points.push_back(shortest_paths.point(p));
  return result;
}

inline void find_isolines(const Mesh& mesh, const Options& options, Results& results)
{
  std::vector<double> isovalues = options.isovalues;
  if(options.number_of_isolines)
    for(std::size_t i = 1; i <= *options.number_of_isolines; ++i)
      isovalues.push_back(results.largest * double(i) / double(*options.number_of_isolines + 1));
  for(const double isovalue : isovalues)
  {
    std::vector<std::vector<Mesh::Point>> lines;
    CGAL::Approximate_geodesics::isolines(mesh, vertex_map(mesh, results.distances), isovalue,
                                          std::back_inserter(lines));
    if(lines.empty())
      results.without_isolines.push_back(isovalue);
    for(std::vector<Mesh::Point>& line : lines)
      results.isolines.push_back({isovalue, std::move(line)});
  }
}

template <typename Shortest_paths>
Results find_results(const Mesh& mesh,
                     Shortest_paths& shortest_paths,
                     const std::vector<Place>& sources,
                     const std::vector<Place>& targets,
                     const Options& options)
{
  Results results;
  for(const Place& source : sources)
    results.sources.push_back(shortest_paths.point(source.point));
  results.distances.resize(mesh.num_vertices());
  results.nearest_sources.resize(mesh.num_vertices());
  shortest_paths.shortest_distances_to_source_points(
      vertex_map(mesh, results.distances),
      CGAL::parameters::nearest_source_map(vertex_map(mesh, results.nearest_sources)));
  results.smallest = *std::min_element(results.distances.begin(), results.distances.end());
  for(const double distance : results.distances)
    if(std::isfinite(distance))
      results.largest = (std::max)(results.largest, distance);
  for(const Place& target : targets)
    results.paths.push_back(find_path(shortest_paths, target, sources, options.straightens));
  find_isolines(mesh, options, results);
  return results;
}

#endif // GEODESIC_DISTANCES_RESULTS_H
