#ifndef GEODESIC_DISTANCES_EXACT_COMPARISON_H
#define GEODESIC_DISTANCES_EXACT_COMPARISON_H

#include "../command_line/Stopwatch.h"
#include "../command_line/read_mesh.h"
#include "Places.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

// How distances differ from the exact ones, relative to these: from CGAL's, which those of the
// package with `epsilon(0)` are compared with, too.
struct Exact_comparison
{
  double seconds = 0;
  double seconds_of_ours = 0;
  double mean_error = 0;
  double largest_error = 0;
  double smallest_error = 0;
  double largest_difference_of_ours = 0;
  std::size_t number_below = 0;
};

inline std::vector<double> exact_distances(const Mesh& mesh, const std::vector<Place>& places)
{
  std::vector<CGAL::Approximate_geodesics::Surface_point<Mesh>> sources;
  for(const Place& place : places)
    sources.insert(sources.end(), place.points.begin(), place.points.end());
  std::vector<double> result(mesh.num_vertices());
  CGAL::approximate_geodesic_distances(
      mesh, boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh)),
      sources, CGAL::parameters::epsilon(0));
  return result;
}

// The sources are vertices: from points on edges, CGAL's distances can be wrong.
inline Exact_comparison compare_with_exact_distances(const Mesh& mesh,
                                                     const std::vector<Place>& sources,
                                                     const std::vector<double>& distances)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  constexpr double rounding = 1e-10; // the exact class computes with doubles too

  Exact_comparison result;
  Stopwatch stopwatch;
  const std::vector<double> ours = exact_distances(mesh, sources);
  result.seconds_of_ours = stopwatch.seconds();

  stopwatch.restart();
  CGAL::Surface_mesh_shortest_path<Traits> exact(mesh);
  for(const Place& source : sources)
    for(const auto& point : source.points)
      if(!mesh.is_isolated(std::get<Mesh::Vertex_index>(point))) // which CGAL's class does not take
        exact.add_source_point(std::get<Mesh::Vertex_index>(point));
  exact.build_sequence_tree();
  result.seconds = stopwatch.seconds();
  result.smallest_error = std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  for(const auto v : vertices(mesh))
  {
    if(mesh.is_isolated(v))
      continue;
    const double distance = exact.shortest_distance_to_source_points(v).first;
    if(!(distance > 0))
      continue; // a source, or not connected with one
    result.largest_difference_of_ours =
        (std::max)(result.largest_difference_of_ours, std::abs(ours[v] / distance - 1));
    if(!std::isfinite(distances[v]))
      continue; // too far away
    const double error = distances[v] / distance - 1;
    result.mean_error += error;
    result.largest_error = (std::max)(result.largest_error, error);
    result.smallest_error = (std::min)(result.smallest_error, error);
    result.number_below += error < -rounding ? 1 : 0;
    ++count;
  }
  if(count > 0)
    result.mean_error /= static_cast<double>(count);
  else
    result.smallest_error = 0;
  return result;
}

#endif // GEODESIC_DISTANCES_EXACT_COMPARISON_H
