#ifndef GEODESIC_DISTANCES_RESULTS_H
#define GEODESIC_DISTANCES_RESULTS_H

#include "../command_line/read_mesh.h"
#include "../command_line/read_options.h"
#include "Options.h"
#include "Places.h"

#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/offset_curves.h>

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

// A path to a target from its nearest source.
struct Path_result
{
  std::string source; // none, if there is no path
  std::string target;
  std::int64_t position_of_source = -1;
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
  std::vector<Mesh::Point> sources; // in the order in which they are given
  std::vector<std::string> names_of_sources;
  std::vector<double> distances;             // by vertex; infinity where no source reaches it
  std::vector<std::int64_t> nearest_sources; // by vertex; positions in that order, or -1
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

// Sources as the search has them, which may be several for a place, and the positions of the
// places.
struct Sources
{
  explicit Sources(const std::vector<Place>& the_places) : places(the_places)
  {
    for(std::size_t i = 0; i < places.size(); ++i)
      positions.insert(positions.end(), places[i].points.size(), std::int64_t(i));
  }

  const std::vector<Place>& places;
  std::vector<std::int64_t> positions; // by source of the search
};

template <typename Shortest_paths>
Path_result find_path(Shortest_paths& shortest_paths,
                      const Place& target,
                      const Sources& sources,
                      const Options& options)
{
  using Surface_point = typename Shortest_paths::Surface_point;
  Path_result result;
  result.target = target.name;
  for(const Surface_point& copy : target.points)
  {
    std::vector<Surface_point> points;
    const auto [length, source] = shortest_paths.shortest_path_surface_points_to_source_points(
        copy, std::back_inserter(points), CGAL::parameters::straighten(options.straightens));
    if(source == shortest_paths.source_points_end() || !(length < result.length))
      continue;
    result.length = length;
    const auto number = std::distance(shortest_paths.source_points_begin(), source);
    result.position_of_source =
        options.curve.empty() ? sources.positions[std::size_t(number)] : std::int64_t(0);
    result.points.clear();
    for(auto p = points.rbegin(); p != points.rend(); ++p) // they come from the target
      result.points.push_back(shortest_paths.point(*p));
  }
  if(!result.points.empty())
    result.source = options.curve.empty()
                        ? sources.places[std::size_t(result.position_of_source)].name
                        : "curve";
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
    points.insert(points.end(), source.points.begin(), source.points.end());
  find_offsets(mesh, points, distances, results);
}

template <typename Shortest_paths>
Results find_results(const Mesh& mesh,
                     Shortest_paths& shortest_paths,
                     const Sources& sources,
                     const std::vector<Place>& targets,
                     const Options& options)
{
  Results results;
  for(const Place& source : sources.places)
  {
    results.sources.push_back(shortest_paths.point(source.points.front()));
    results.names_of_sources.push_back(source.name);
  }
  results.distances.resize(mesh.num_vertices());
  results.nearest_sources.resize(mesh.num_vertices());
  shortest_paths.shortest_distances_to_source_points(
      vertex_map(mesh, results.distances),
      CGAL::parameters::nearest_source_map(vertex_map(mesh, results.nearest_sources))
          .signed_distances(options.is_signed));
  for(std::int64_t& source : results.nearest_sources)
    if(source >= 0 && options.curve.empty())
      source = sources.positions[std::size_t(source)];
  results.smallest = *std::min_element(results.distances.begin(), results.distances.end());
  for(const double distance : results.distances)
    if(std::isfinite(distance))
      results.largest = (std::max)(results.largest, distance);
  for(const Place& target : targets)
    results.paths.push_back(find_path(shortest_paths, target, sources, options));
  find_isolines(mesh, options, results);
  return results;
}

// Gives all vertices of the mesh that are one vertex of the file the distance of the nearest of
// them.
inline void unite_copies(const Vertices_of_file& vertices, Results& results)
{
  if(vertices.are_those_of_mesh())
    return;
  const std::vector<double> distances = results.distances;
  const std::vector<std::int64_t> sources = results.nearest_sources;
  for(std::size_t v = 0; v < distances.size(); ++v)
  {
    const std::vector<std::size_t> copies = vertices.vertices(vertices.number_of(v));
    const std::size_t nearest = *std::min_element(
        copies.begin(), copies.end(), [&](const std::size_t a, const std::size_t b) {
          return std::abs(distances[a]) < std::abs(distances[b]); // they may have signs
        });
    results.distances[v] = distances[nearest];
    results.nearest_sources[v] = sources[nearest];
  }
}

#endif // GEODESIC_DISTANCES_RESULTS_H
