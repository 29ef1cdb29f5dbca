#ifndef GEODESIC_DISTANCES_RESULTS_H
#define GEODESIC_DISTANCES_RESULTS_H

#include "../command_line/read_mesh.h"
#include "../command_line/read_options.h"
#include "Options.h"
#include "Places.h"

#include <CGAL/Approximate_geodesics/Queries/isolines.h>
#include <CGAL/Approximate_geodesics/Queries/offset_curves.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

// A path from a target to its nearest source.
struct Path_result
{
  std::string target;
  std::string source; // none, if there is no path
  double length = std::numeric_limits<double>::infinity();
  std::vector<Mesh::Point> points;
};

// At a distance, or curves at an exact one.
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
  std::vector<Isoline> isolines, offsets;
  std::vector<double> without_isolines, without_offsets; // distances that were asked for
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
                      const Options& options)
{
  using Surface_point = typename Shortest_paths::Surface_point;
  Path_result result;
  result.target = target.name;
  std::vector<Surface_point> points;
  const auto answer = shortest_paths.shortest_path_surface_points_to_source_points(
      target.point, std::back_inserter(points), CGAL::parameters::straighten(options.straightens));
  if(answer.second == shortest_paths.source_points_end())
    return result;
  result.length = answer.first;
  const auto number = std::distance(shortest_paths.source_points_begin(), answer.second);
  result.source = options.curve.empty() ? sources[std::size_t(number)].name : "curve";
  for(const Surface_point& p : points)
    result.points.push_back(shortest_paths.point(p));
  return result;
}

// The distances of lines from `low`, which is not above 0, to `largest`.
inline std::vector<double>
values_of(const Levels& levels, const std::string& option, const double low, const double largest)
{
  constexpr double most = 100000;
  std::vector<double> values = levels.values;
  const double range = largest - low;
  if(levels.number)
    for(std::size_t i = 1; i <= *levels.number; ++i)
      values.push_back(low + range * double(i) / double(*levels.number + 1));
  if(!levels.step)
    return values;
  if(range / *levels.step > most)
    reject_option(option, "these are more than 100000 distances; the largest is " +
                              std::to_string(largest));
  const double beyond = largest / *levels.step;
  for(double i = low < 0 ? std::ceil(low / *levels.step) : 1; i <= beyond; ++i)
    values.push_back(i * *levels.step);
  return values;
}

inline void find_isolines(const Mesh& mesh, const Options& options, Results& results)
{
  for(const double isovalue :
      values_of(options.isolines, "isolines", (std::min)(0., results.smallest), results.largest))
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

template <typename Sources>
void find_offsets(const Mesh& mesh,
                  const Sources& sources,
                  const std::vector<double>& distances,
                  Results& results)
{
  std::vector<CGAL::Approximate_geodesics::Offset_curve<Mesh::Point>> curves;
  CGAL::Approximate_geodesics::offset_curves(mesh, sources, distances, std::back_inserter(curves));
  std::set<double> without(distances.begin(), distances.end());
  for(auto& curve : curves)
  {
    without.erase(curve.distance);
    if(curve.is_closed)
      curve.points.push_back(curve.points.front());
    results.offsets.push_back({curve.distance, std::move(curve.points)});
  }
  results.without_offsets.assign(without.begin(), without.end());
}

inline void find_offsets(const Mesh& mesh,
                         const std::vector<Place>& sources,
                         const Options& options,
                         Results& results)
{
  const double largest = (std::max)(results.largest, -results.smallest); // there may be signs
  const std::vector<double> distances = values_of(options.offsets, "offset", 0, largest);
  if(!options.curve.empty())
    return find_offsets(mesh, curve_through(sources), distances, results);
  std::vector<CGAL::Approximate_geodesics::Surface_point<Mesh>> points;
  for(const Place& source : sources)
    points.push_back(source.point);
  find_offsets(mesh, points, distances, results);
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
      CGAL::parameters::nearest_source_map(vertex_map(mesh, results.nearest_sources))
          .signed_distances(options.is_signed));
  results.smallest = *std::min_element(results.distances.begin(), results.distances.end());
  for(const double distance : results.distances)
    if(std::isfinite(distance))
      results.largest = (std::max)(results.largest, distance);
  for(const Place& target : targets)
    results.paths.push_back(find_path(shortest_paths, target, sources, options));
  find_isolines(mesh, options, results);
  return results;
}

#endif // GEODESIC_DISTANCES_RESULTS_H
