// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_REFINED_PATH_H
#define CGAL_GEODESIC_QUERIES_REFINED_PATH_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

/*
 * A placement of equally spaced points on the edges near a path: edges of faces that the path
 * touches, and of `number_of_rings` rings of faces around them.
 */
class Points_near_path : public Equal_parts
{
public:
  Points_near_path(const Intrinsic_triangulation& triangulation,
                   const Path& path,
                   const std::size_t number_of_rings,
                   const std::size_t number_of_points_per_edge)
    : m_number_of_points(number_of_points_per_edge),
      m_is_near(triangulation.number_of_vertices(), false)
  {
    for(const Intrinsic_point& p : path.points)
      p.for_each_face(triangulation, [&](const Index h) {
        for(const Index side : triangulation.halfedges_of_face(h))
          m_is_near[triangulation.source(side)] = true;
      });
    for(std::size_t ring = 0; ring < number_of_rings; ++ring)
    {
      const std::vector<bool> was_near = m_is_near;
      for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
        if(was_near[v])
          for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
            m_is_near[triangulation.target(h)] = true;
    }
  }

  std::size_t number_of_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    return m_is_near[triangulation.source(h)] && m_is_near[triangulation.target(h)]
               ? m_number_of_points
               : 0;
  }

  std::size_t memory() const { return memory_of(m_is_near); }

private:
  std::size_t m_number_of_points;
  std::vector<bool> m_is_near; // per vertex
};

// Returns the mean number of points per edge.
template <typename Placement>
std::size_t mean_number_of_points(const Steiner_graph<Placement>& graph)
{
  if constexpr(std::is_same_v<Placement, Fixed_number_of_points>)
    return graph.placement().number_of_points(graph.triangulation(), 0);
  const std::size_t number_of_edges = graph.triangulation().number_of_halfedges() / 2;
  return graph.number_of_points() / (std::max)(number_of_edges, std::size_t(1));
}

// Refines the path found with the first placement, which has at most `maximum_number_of_points`
// points (0 selects the default), by repeated searches: each graph has twice as many points per
// edge as the previous one, in a narrowing corridor around the last path. Stops when the relative
// gain in length does not exceed the tolerance. Returns the path, which is empty if the target is
// not reached, and a lower bound on the length of all paths, 0 if there is none.
template <typename PriorityQueue = Adaptive_bucket_queue, typename Placement>
std::pair<Path, double> selective_refinement(const Intrinsic_triangulation& triangulation,
                                             const Intrinsic_triangulation::Index source,
                                             const Intrinsic_triangulation::Index target,
                                             Placement first_placement,
                                             const std::size_t maximum_number_of_points,
                                             const double relative_tolerance)
{
  constexpr std::size_t largest_number_of_points = 4096;
  const auto find_path = [&](const auto& graph) {
    Propagation<std::decay_t<decltype(graph)>, PriorityQueue> search(graph);
    search.run({{source}}, {infinity, {target}});
    return tree_path(search, target);
  };
  const Steiner_graph<Placement> graph(triangulation, std::move(first_placement),
                                       maximum_number_of_points);
  Path path = find_path(graph);
  if(path.points.empty())
    return {path, infinity};
  const double lower_bound = smallest_distance(path.length, graph.epsilon());
  std::size_t number_of_rings = 3; // around a coarse path
  for(std::size_t n = mean_number_of_points(graph); n < largest_number_of_points;)
  {
    n = 2 * n + 1; // equally spaced points stay points
    Path refined = find_path(Steiner_graph<Points_near_path>(
        triangulation, Points_near_path(triangulation, path, number_of_rings, n),
        (std::numeric_limits<std::size_t>::max)())); // no limit: few edges have points
    number_of_rings -= (std::min)(number_of_rings, std::size_t(1));
    const double gain = path.length - refined.length;
    if(gain > 0)
      path = std::move(refined);
    if(gain <= relative_tolerance * path.length)
      break;
  }
  return {std::move(path), lower_bound};
}

// Returns a lower bound on the distance, and the length of the path.
template <typename TriangleMesh,
          typename OutputIterator,
          typename Vertex,
          typename Placement,
          typename NamedParameters>
std::pair<double, double> refine_path(const TriangleMesh& tmesh,
                                      OutputIterator points,
                                      const Vertex source,
                                      const Vertex target,
                                      const Placement& first_placement,
                                      const NamedParameters& np)
{
  static_assert(!has_directional_cost<NamedParameters>,
                "directional_cost: selective refinement does not support directional costs; use "
                "approximate_geodesic_path()");
  const double tolerance = CGAL::to_double(parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::relative_tolerance), 1e-5));
  if(!(tolerance >= 0))
    reject("the relative tolerance is " + text_of(tolerance) +
           "; it must be a number that is not negative");
  const Intrinsic_triangulation triangulation(tmesh, np);
  Mesh_translation translation(tmesh, vertex_index_map(tmesh, np), triangulation);
  translation.list_vertices();
  const auto [path, lower_bound] =
      selective_refinement(triangulation, translation.node(source), translation.node(target),
                           first_placement, maximum_number_of_points(np), tolerance);
  const auto point_map = vertex_point_map(tmesh, np);
  for(auto p = path.points.rbegin(); p != path.points.rend(); ++p)
    *points++ = point(translation, *p, point_map, np);
  return {lower_bound, path.points.empty() ? infinity : path.length};
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicQueriesIntervals
 *
 * computes a short path on the mesh from `source` to `target` by selective refinement, and returns
 * its length.
 *
 * The first path is found in a graph with a few points on every edge. The search is then repeated
 * in graphs with twice as many points, but only on edges near the previous path, until the relative
 * decrease in length is below a tolerance. This is much faster than a uniformly fine graph, and
 * finds about the same path, unless the first path is in a different homotopy class: the result is
 * short among nearby paths, without an error bound; `refined_path_interval()` gives a bound. If
 * weights differ by orders of magnitude, the path can cost many times as much as the cheapest one.
 *
 * The method is that of Kanai and Suzuki \cgalCite{ks-asppa-01}.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam OutputIterator a model of `OutputIterator` that takes points of the vertex point map
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param points receives the points of the path, as in `approximate_geodesic_path()`
 * \param source the start vertex of the path
 * \param target the end vertex of the path
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those listed
 *           below and `vertex_point_map`, `edge_length_map`, `face_weight_map`,
 *           `edge_is_constrained_map`, `vertex_index_map`, `halfedge_index_map` and `geom_traits`,
 *           as for `approximate_geodesic_path()`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_points_per_edge}
 *     \cgalParamDescription{the number of points on every edge for the first path}
 *     \cgalParamType{an integer type}
 *     \cgalParamDefault{`3`}
 *     \cgalParamExtra{A chain that starts with this parameter cannot be continued with those of
 *                     this package, see \ref AG_chains.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{relative_tolerance}
 *     \cgalParamDescription{Refinement stops when the relative decrease in length is at most this
 *                           value. Typically, further refinements would gain less than a third of
 *                           it.}
 *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
 *     \cgalParamDefault{`1e-5`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the length of the path, or its cost if faces have weights, or infinity if `target` is not
 *         reachable.
 *
 * \throws std::invalid_argument as `approximate_geodesic_path()` does, if a face violates the
 *         triangle inequality, or if the tolerance is negative or NaN.
 * \throws std::length_error as `approximate_geodesic_path()` does.
 *
 * In practice, run time and memory are those of a search with the initial number of points, and
 * \cgalBigO{n} more for every refinement of a mesh of `n` vertices.
 *
 * \sa `approximate_geodesic_path()`
 * \sa `refined_path_interval()`
 */
template <typename TriangleMesh,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
double refined_path(const TriangleMesh& tmesh,
                    OutputIterator points,
                    const typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
                    const typename boost::graph_traits<TriangleMesh>::vertex_descriptor target,
                    const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::is_given<NamedParameters, internal_np::epsilon_t>,
                "epsilon: selective refinement gives no bound; use refined_path_interval()");
  static_assert(
      !internal::ignores_any<NamedParameters, internal_np::epsilon_t,
                             internal_np::relative_tolerance_t,
                             internal_np::number_of_points_per_edge_t, internal_np::edge_length_t,
                             internal_np::face_weight_t, internal_np::edge_is_constrained_t>,
      "refined_path() reads relative_tolerance, number_of_points_per_edge, and parameters that "
      "describe the mesh only; use approximate_geodesic_path()");

  return internal::refine_path(tmesh, points, source, target, Fixed_number_of_points(np), np)
      .second;
}

/*!
 * \ingroup PkgGeodesicQueriesIntervals
 *
 * computes a path like `refined_path()`, and returns an interval that contains the distance from
 * `source` to `target`. Its upper end is the length of the path, up to rounding.
 *
 * The first path is found in a graph with `Geometric_points`, and costs at most
 * \f$1 + \varepsilon\f$ times as much as the cheapest path. So the lower end of the interval is the
 * cost of the first path, divided by \f$1 + \varepsilon\f$; refinement decreases the upper end. A
 * mesh with faces too thin for the bound is rejected, unless `accept_weaker_bound` is given; then
 * the lower end is that of the guaranteed bound `Steiner_graph::epsilon()`.
 *
 * Template arguments are those of `refined_path()`.
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param points receives the points of the path
 * \param source the start vertex of the path
 * \param target the end vertex of the path
 * \param np a sequence of \ref bgl_namedparameters "Named Parameters": `epsilon`, which is
 *           required, `accept_weaker_bound`, `maximum_number_of_points`,
 *           `maximum_number_of_points_per_edge`, `relative_tolerance`, and parameters that describe
 *           the mesh, as for `refined_path()`
 *
 * \return a lower bound on the distance, or cost, and the length of the path, which is at most
 *         \f$1 + \varepsilon\f$ times as large; both are infinity if `target` is not reachable. The
 *         lower bound allows for a relative \f$10^{-12}\f$ of rounding.
 *
 * \throws std::invalid_argument, std::length_error as `refined_path()` and `Geometric_points` do.
 *
 * In practice, run time and memory are those of a search in a graph with that bound, and
 * \cgalBigO{n} more for every refinement of a mesh of `n` vertices.
 *
 * \sa `distance_intervals()`
 */
template <typename TriangleMesh, typename OutputIterator, typename NamedParameters>
std::pair<double, double>
refined_path_interval(const TriangleMesh& tmesh,
                      OutputIterator points,
                      const typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
                      const typename boost::graph_traits<TriangleMesh>::vertex_descriptor target,
                      const NamedParameters& np)
{
  static_assert(internal::is_given<NamedParameters, internal_np::epsilon_t>,
                "refined_path_interval() needs epsilon, the bound of the first path");
  static_assert(
      !internal::ignores_any<
          NamedParameters, internal_np::epsilon_t, internal_np::maximum_number_of_points_t,
          internal_np::maximum_number_of_points_per_edge_t, internal_np::accept_weaker_bound_t,
          internal_np::relative_tolerance_t, internal_np::edge_length_t, internal_np::face_weight_t,
          internal_np::edge_is_constrained_t>,
      "refined_path_interval() reads epsilon, accept_weaker_bound, the limits of points, "
      "relative_tolerance, and parameters that describe the mesh only");
  return internal::refine_path(tmesh, points, source, target, Geometric_points(np), np);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_REFINED_PATH_H
