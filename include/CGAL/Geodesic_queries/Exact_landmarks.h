// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_EXACT_LANDMARKS_H
#define CGAL_GEODESIC_QUERIES_EXACT_LANDMARKS_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h> // their approximation
#include <CGAL/Geodesic_queries/Landmarks.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Approximate_geodesics {

namespace internal {

// Whether searches of a graph can be limited to a corridor.
template <typename Graph>
constexpr bool can_stay_in_corridor =
    is_valid<const Graph&>([](auto& g) -> typename std::decay_t<decltype(g)>::Approximation* {});

} // namespace internal

/*!
 * \ingroup PkgGeodesicQueriesPairs
 *
 * What makes exact searches for pairs fast: a graph of the same surface with a small error bound,
 * and its landmarks.
 *
 * For each pair, the graph gives a path that is nearly shortest, and, from the other end, distances
 * that are not much larger than the exact ones. So they tell which part of the surface the shortest
 * path is in, and the exact search stays there: a narrow ellipse, if the surface is flat. Section
 * \ref AG_pairs of the user manual compares times, and the report \cgalCite{ag-report} proves that
 * the result is that of a search of the whole surface.
 *
 * An object is made once for a graph, which is worth it for many pairs. `Guided_search` and
 * `Pair_queries` use it. It never changes after its construction, and may be used by several
 * threads.
 *
 * \tparam SurfaceGraph a model of `SurfaceGraph` that is exact, with the type of a graph with a
 *         bound: `Saddle_vertex_graph`
 */
template <typename SurfaceGraph>
class Exact_landmarks
{
public:
  /// the graph with a bound.
  using Approximation = typename SurfaceGraph::Approximation;

  /// the bound of that graph: smaller ones make ellipses narrower, and the graph larger.
  static constexpr double EPSILON = 0.01;

  /*!
   * builds the graph with a bound and its landmarks.
   *
   * \param graph the exact graph, which is referred to, not copied
   * \param number the number of landmarks, at least `1`
   *
   * \throws std::invalid_argument if `number` is `0`.
   *
   * Run time is that of building the graph, and of two searches of it for each landmark. Several
   * threads take part in building if they do in each search of `graph`. Memory is that of both:
   * about 800 bytes per vertex, and 8 bytes per vertex and landmark.
   */
  explicit Exact_landmarks(const SurfaceGraph& graph,
                           const std::size_t number = Landmarks<Approximation>::DEFAULT_NUMBER)
    : m_graph(&graph),
      m_approximation(approximation_of(graph)),
      m_landmarks(m_approximation, number)
  {
  }

  /// landmarks of a temporary graph would outlive it.
  explicit Exact_landmarks(const SurfaceGraph&& graph,
                           std::size_t number = Landmarks<Approximation>::DEFAULT_NUMBER) = delete;

  /// not copyable.
  Exact_landmarks(const Exact_landmarks&) = delete;
  Exact_landmarks& operator=(const Exact_landmarks&) = delete;

  /// returns the exact graph.
  const SurfaceGraph& graph() const { return *m_graph; }

  /// returns the graph with a bound.
  const Approximation& approximation() const { return m_approximation; }

  /// returns the landmarks of that graph.
  const Landmarks<Approximation>& landmarks() const { return m_landmarks; }

  /// returns the number of bytes of both.
  std::size_t memory() const { return internal::memory_of(m_approximation, m_landmarks); }

private:
  static Approximation approximation_of(const SurfaceGraph& graph)
  {
    const auto np = parameters::epsilon(EPSILON);
    if(graph.is_parallel())
      return Approximation(graph.triangulation(), np.concurrency_tag(Parallel_if_available_tag()));
    return Approximation(graph.triangulation(), np);
  }

  const SurfaceGraph* m_graph;
  Approximation m_approximation;
  Landmarks<Approximation> m_landmarks; // of the approximation
};

namespace internal {

// What guides searches for pairs of points in a graph.
template <typename Graph>
using Landmarks_of =
    std::conditional_t<can_stay_in_corridor<Graph>, Exact_landmarks<Graph>, Landmarks<Graph>>;

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_EXACT_LANDMARKS_H
