// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_FARTHEST_POINT_SAMPLING_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_FARTHEST_POINT_SAMPLING_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/intrinsic_points.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Queries/internal/with_graph.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Finds which of the numbers `0`, `1`, ... is farthest away, while distances fall. An entry is
 * lowered only when it comes to the top: until then, its distance is an upper bound. Of several
 * that are equally far, the first one is found.
 */
class Farthest_first
{
public:
  struct Entry
  {
    double distance;
    std::size_t number;

    bool operator<(const Entry& other) const
    {
      return distance < other.distance || (distance == other.distance && number > other.number);
    }
  };

  explicit Farthest_first(const std::size_t size)
  {
    std::vector<Entry> entries;
    for(std::size_t i = 0; i < size; ++i)
      entries.push_back({std::numeric_limits<double>::infinity(), i});
    m_queue = std::priority_queue<Entry>(std::less<Entry>(), std::move(entries));
  }

  // The distance is `0` if there are no numbers.
  template <typename Distance>
  Entry find(const Distance& distance)
  {
    while(!m_queue.empty())
    {
      const Entry top = m_queue.top();
      const double present = distance(top.number);
      if(present == top.distance)
        return top;
      m_queue.pop();
      m_queue.push({present, top.number});
    }
    return {0, 0};
  }

private:
  std::priority_queue<Entry> m_queue;
};

template <typename Integer>
void check_number_of_points(const Integer number)
{
  static_assert(std::is_integral_v<Integer>,
                "farthest_point_sampling() takes the output iterator, then the number of points");
  if constexpr(std::is_signed_v<Integer>)
    if(number < 0)
      reject("the number of points is " + std::to_string(number) + "; it must not be negative");
}

// one vertex, or a range of them, to start from
template <typename Search, typename Sources, typename MeshTranslation>
std::vector<typename Search::Seed> seeds(const Sources& sources, const MeshTranslation& translation)
{
  std::vector<typename Search::Seed> result;
  if constexpr(std::is_convertible_v<Sources, typename MeshTranslation::vertex_descriptor>)
    result.push_back({intrinsic_point(translation, sources, "source").vertex});
  else
    for(const Intrinsic_point& point : intrinsic_points(translation, sources, "source"))
      result.push_back({point.vertex});
  return result;
}

template <typename NamedParameters>
constexpr void refuse_other_parameters_than_of_sampling()
{
  static_assert(
      !ignores_any<NamedParameters, internal_np::edge_length_t, internal_np::epsilon_t,
                   internal_np::maximum_number_of_points_t,
                   internal_np::maximum_number_of_points_per_edge_t,
                   internal_np::accept_weaker_bound_t, internal_np::face_weight_t,
                   internal_np::number_of_points_per_edge_t, internal_np::edge_is_constrained_t>,
      "farthest_point_sampling() reads epsilon, number_of_points_per_edge, and what "
      "describes the mesh only; it always searches all of it");
}

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsQueries
 *
 * chooses vertices that are spread evenly over the surface: one after the other, each as far as
 * possible from the sources and from those chosen before.
 *
 * Parts of the mesh that no path connects with these, isolated vertices among them, are infinitely
 * far away: each part gets a point before any gets another one. Of vertices that are equally far,
 * the first one in the order of `vertices(tmesh)` is chosen.
 *
 * If paths run along edges, and there are no sources, no choice of as many vertices covers the mesh
 * with less than half of the radius that this one does.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam OutputIterator a model of `OutputIterator` that takes
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
 * \tparam Integer an integer type
 * \tparam Sources `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, or a model of
 *         `ConstRange` with that value type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param points receives the points, in the order in which they are chosen
 * \param number_of_points how many points are chosen; fewer if all distances have become zero, so
 *        never more than there are vertices
 * \param sources a vertex, or a range of vertices, that the points are to keep away from; they do
 *        not count as points. If there are none, the first point is the first vertex.
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map`, `edge_length_map`, `epsilon`, `maximum_number_of_points`,
 * `maximum_number_of_points_per_edge`, `accept_weaker_bound`, `number_of_points_per_edge`,
 *           `face_weight_map`, `edge_is_constrained_map`, `vertex_index_map`, `halfedge_index_map`
 *           and `geom_traits`, which are as for `approximate_geodesic_distances()`, and
 *           `concurrency_tag`, which is as for `Discrete_geodesic_graph`, the graph that is built
 * if `epsilon` is given
 *
 * \return the covering radius: the greatest distance of a vertex from the nearest of the sources
 *         and points. It is infinite if a part of the mesh has none, and `0` if there are no
 *         vertices.
 *
 * \throws std::invalid_argument if `number_of_points` is negative.
 * \throws std::invalid_argument, std::length_error as `approximate_geodesic_distances()` does.
 *         In all cases, nothing has been written then.
 *
 * The first points cost a search of the whole mesh each, and every further one costs the search of
 * the part that is nearer to it than to those before, which gets smaller and smaller. Together,
 * \f$k\f$ points cost about as much as \f$\log k\f$ searches.
 *
 * \sa `approximate_geodesic_distances()`
 * \sa `voronoi_partition()`
 */
template <typename TriangleMesh,
          typename OutputIterator,
          typename Integer,
          typename Sources,
          typename NamedParameters = parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
double
#else
std::enable_if_t<!internal::is_named_parameters<Sources>, double>
#endif
farthest_point_sampling(const TriangleMesh& tmesh,
                        OutputIterator points,
                        const Integer number_of_points,
                        const Sources& sources,
                        const NamedParameters& np = parameters::default_values())
{
  internal::refuse_other_parameters_than_of_sampling<NamedParameters>();
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  internal::check_number_of_points(number_of_points);
  // all arcs are computed in advance, which pays off from about ten points on
  return internal::with_graph<Discrete_geodesic_graph>(tmesh, np, [&](const auto& graph) {
    const Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np),
                                       graph.triangulation());
    Propagation<std::decay_t<decltype(graph)>> search(graph);
    search.run(internal::seeds<decltype(search)>(sources, translation));

    const std::vector<vertex_descriptor> candidates(vertices(tmesh).begin(), vertices(tmesh).end());
    const auto distance = [&](const std::size_t i) {
      return search.distance(translation.node(candidates[i]));
    };
    internal::Farthest_first farthest_first(candidates.size());
    auto farthest = farthest_first.find(distance);
    for(Integer i = 0; i < number_of_points && farthest.distance > 0; ++i)
    {
      search.run_further({{translation.node(candidates[farthest.number])}});
      *points++ = candidates[farthest.number];
      farthest = farthest_first.find(distance);
    }
    return farthest.distance;
  });
}

/*!
 * \ingroup PkgApproximateGeodesicsQueries
 *
 * chooses vertices likewise, without sources: the first point is the first vertex.
 */
template <typename TriangleMesh,
          typename OutputIterator,
          typename Integer,
          typename NamedParameters = parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
double
#else
std::enable_if_t<internal::is_named_parameters<NamedParameters>, double>
#endif
farthest_point_sampling(const TriangleMesh& tmesh,
                        OutputIterator points,
                        const Integer number_of_points,
                        const NamedParameters& np = parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  return farthest_point_sampling(tmesh, points, number_of_points,
                                 std::array<vertex_descriptor, 0>(), np);
}

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_FARTHEST_POINT_SAMPLING_H
