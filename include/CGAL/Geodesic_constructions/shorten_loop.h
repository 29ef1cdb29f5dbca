// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_SHORTEN_LOOP_H
#define CGAL_GEODESIC_CONSTRUCTIONS_SHORTEN_LOOP_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Queries/internal/compiled_searches.h>
#include <CGAL/Geodesic_constructions/Loop_straightener.h>
#include <CGAL/Geodesic_constructions/internal/Cut_graph.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicConstructionsLoops
 *
 * A closed curve on the surface: what `shorten_loop()` and `shortest_loop_through()` return.
 */
template <typename TriangleMesh>
struct Geodesic_loop
{
  /// the vertices and the crossings with edges, in order; the first one is also the last. Two
  /// consecutive points lie in the same face. A single point if the loop contracts to it, and none
  /// if there is no loop.
  std::vector<Surface_point<TriangleMesh>> points;

  /// the length, in the unit of the mesh; infinity if there is no loop.
  double length = 0;

  /// returns whether the loop has contracted to a point.
  bool is_point() const { return points.size() == 1; }
};

namespace internal {

template <typename TriangleMesh, typename Range>
constexpr bool are_halfedges =
    std::is_same_v<Element_of_range<Range>,
                   typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>;

// The sources of halfedges that form a closed chain.
template <typename Translation, typename HalfedgeRange>
std::vector<Intrinsic_point> points_of_chain(const Translation& translation,
                                             const HalfedgeRange& halfedges)
{
  std::vector<Intrinsic_point> sources, targets;
  for(const auto h : halfedges)
    name_in_message([&] { return name_in_list("halfedge", sources.size()); },
                    [&] {
                      targets.push_back(translation.intrinsic_point(h, 1));
                      sources.push_back(translation.intrinsic_point(h, 0));
                    });
  for(std::size_t i = 0; i < sources.size(); ++i)
    if(targets[i].vertex != sources[(i + 1) % sources.size()].vertex)
      reject(name_in_list("halfedge", i) + " does not end where the next one starts");
  return sources;
}

// Returns the closed path along a curve, which is given by its points or its halfedges.
template <typename Translation, typename CurveRange>
Path closed_path(const Translation& translation,
                 const Intrinsic_triangulation& triangulation,
                 const CurveRange& curve)
{
  Path result;
  if constexpr(are_halfedges<typename Translation::Triangle_mesh, CurveRange>)
    result.points = points_of_chain(translation, curve);
  else
    result.points = intrinsic_points(translation, curve, "point of the loop");
  if(result.points.empty())
    reject("the loop has no points");
  const std::size_t size = result.points.size();
  result.points.push_back(result.points.front());
  for(std::size_t i = 0; i < size; ++i)
    if(std::isinf(shortest_segment(triangulation, result.points[i], result.points[i + 1]).length))
      reject("points " + std::to_string(i) + " and " + std::to_string((i + 1) % size) +
             " of the loop, counted from 0, lie in no common face");
  return result;
}

template <typename Translation>
Geodesic_loop<typename Translation::Triangle_mesh> loop_on_mesh(const Translation& translation,
                                                                const Path& loop)
{
  Geodesic_loop<typename Translation::Triangle_mesh> result;
  for(const Intrinsic_point& p : loop.points)
    result.points.push_back(translation.surface_point(p));
  result.length = loop.points.empty() ? infinity : loop.length;
  return result;
}

// Shortens the loops of the cut graph that belongs to a search from `base`. Replaces `shortest` by
// the shortest of them, if that is shorter.
template <typename Graph>
void shorten_loops_of_cut_graph(const Graph& graph, const Intrinsic_point& base, Path& shortest)
{
  const Intrinsic_triangulation& triangulation = graph.triangulation();
  Surface_search<Graph> search(graph);
  Geodesic_visitor_base visitor; // as in the compiled searches
  search.run({{base}}, {}, visitor);
  std::vector<double> distances;
  for(Intrinsic_point::Index v = 0; v < triangulation.number_of_vertices(); ++v)
    distances.push_back(search.search().distance(v) / triangulation.unit());

  const Loop_straightener straightener(triangulation);
  const Cut_graph cut_graph(triangulation, base, std::move(distances));
  for(const Cut_graph::Link& link : cut_graph.links())
    if(link.lower_bound * triangulation.unit() < shortest.length)
    {
      Path loop = straightener.shortened_with_fixed_ends({cut_graph.loop(link), 0});
      const bool is_point = loop.points.size() == 1; // of parallel edges, only the shortest counts
      if(!is_point && loop.length < shortest.length)
        shortest = std::move(loop);
    }
}

// Edges give a loop that is not longer than any one along edges; exact distances, in most cases, a
// shorter one.
inline Path shortest_loop(const Saddle_vertex_graph& graph, const Intrinsic_point& base)
{
  Path result{{}, infinity};
  shorten_loops_of_cut_graph(Edge_graph(graph.triangulation()), base, result);
  shorten_loops_of_cut_graph(graph, base, result);
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsLoops
 *
 * shortens a closed curve on the surface until it is locally shortest: a closed geodesic.
 *
 * The curve is moved on the surface, without lifting it, as a rubber band would move: the result is
 * in the same free homotopy class, and never longer. It is straight across faces and edges. At a
 * vertex, the angles on both sides are at least \f$\pi\f$, unless the border is on that side. No
 * point of the loop stays fixed. To keep it from crossing some edges, cut the mesh along them.
 *
 * In its class, the result is a local minimum, and not always the shortest curve: a loop around the
 * neck of a vase stays there, although it could contract over the bottom of the vase. A loop for
 * which nothing is in the way contracts to a point, see `Geodesic_loop::is_point()`.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam CurveRange a model of `ConstRange` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, `Face_location`,
 *         `Surface_point`, or `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as value
 *         type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param curve the closed curve: points of the surface, where each lies in a face or on an edge
 *        with the next one, and the last with the first; or halfedges, where each starts where the
 *        one before it ends. The first point may be repeated at the end. Where several edges join
 *        two vertices, the shortest one counts.
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map`, `edge_length_map`, `vertex_index_map`, `halfedge_index_map` and
 *           `geom_traits`, as for `approximate_geodesic_distances()`
 *
 * \return the loop, and its length.
 *
 * \throws std::invalid_argument if the curve has no points, if two consecutive points have no face
 *         and no edge in common, if a point is not on the mesh, if a face breaks the triangle
 *         inequality, and as `Intrinsic_triangulation` does.
 * \throws std::length_error if `tmesh` has too many halfedges for 32-bit indices.
 * \throws std::runtime_error if the loop is not locally shortest after \f$n + 1000\f$ steps.
 *
 * Reading the mesh takes \cgalBigO{n} time. A loop takes a number of steps that is mostly below
 * ten: each fixes one point, and straightens the loop in time in
 * proportion to the number of faces that it crosses, in practice.
 *
 * The method is that of straightened paths, with a base that moves.
 *
 * \sa `shortest_loop_through()`
 */
template <typename TriangleMesh,
          typename CurveRange,
          typename NamedParameters = parameters::Default_named_parameters>
Geodesic_loop<TriangleMesh> shorten_loop(const TriangleMesh& tmesh,
                                         const CurveRange& curve,
                                         const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::ignores_any<NamedParameters, internal_np::edge_length_t>,
                "shorten_loop() reads edge_length_map, and no parameter of distances");
  const Intrinsic_triangulation triangulation(tmesh, np);
  triangulation.check_triangle_inequality();
  Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np), triangulation);
  translation.list_vertices();
  return internal::loop_on_mesh(
      translation, Loop_straightener(triangulation)
                       .shortened(internal::closed_path(translation, triangulation, curve)));
}

/*!
 * \ingroup PkgGeodesicConstructionsLoops
 *
 * finds a shortest loop through a point that does not contract: around a handle, a hole, or the
 * border.
 *
 * Two searches from the point, one along edges and one that is exact, give a cut graph each
 * (Erickson and Har-Peled \cgalCite{eh-ocsd-04}): the edges where shortest paths from two sides of
 * a handle or a hole meet. Each of these edges makes a loop with the paths to its ends. The loops
 * are made locally shortest, with the point fixed, except for those that a lower bound excludes,
 * and the shortest of them is returned.
 *
 * It is never longer than the shortest loop along edges through a vertex, which
 * `Surface_mesh_topology::Curves_on_surface_topology` computes. In most cases, it is the shortest
 * loop of all; this is not proved, as straightening may end at a local minimum, and edges of coarse
 * meshes may miss a class of loops.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam Point `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, `Face_location`, or
 *         `Surface_point`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param point the point
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map`, `edge_length_map`, `concurrency_tag`, `vertex_index_map`,
 *           `halfedge_index_map` and `geom_traits`, as for `approximate_geodesic_distances()`
 *
 * \return the loop, which starts and ends at the point, and its length; no points, and infinity, if
 *         all loops in the component of the point contract, as on a sphere or a disk.
 *
 * \throws std::invalid_argument as `approximate_geodesic_distances()` does.
 * \throws std::length_error if `tmesh` has too many halfedges for 32-bit indices.
 *
 * It takes two searches, and the time to straighten the loops: on usual meshes, there are
 * \cgalBigO{\sqrt{n}} of them, each with \cgalBigO{\sqrt{n}} points.
 *
 * \sa `shorten_loop()`
 */
template <typename TriangleMesh,
          typename Point,
          typename NamedParameters = parameters::Default_named_parameters>
Geodesic_loop<TriangleMesh>
shortest_loop_through(const TriangleMesh& tmesh,
                      const Point& point,
                      const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::ignores_any<NamedParameters, internal_np::edge_length_t>,
                "shortest_loop_through() is exact, and reads edge_length_map only");
  const auto graph = internal::exact_graph(tmesh, np);
  Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np), graph.triangulation());
  translation.list_vertices();
  return internal::loop_on_mesh(
      translation,
      internal::shortest_loop(graph, internal::intrinsic_point(translation, point, "point")));
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_SHORTEN_LOOP_H
