// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_SADDLE_VERTEX_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_SADDLE_VERTEX_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Lines_of_sight.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Saddle_run.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <utility>

namespace CGAL::Approximate_geodesics {

class Discrete_geodesic_graph; // is needed for pairs only

/*!
 * \ingroup PkgApproximateGeodesicsGraphs
 *
 * The graph whose shortest paths are the shortest ones on the surface: distances and paths are
 * exact, up to rounding.
 *
 * A shortest path bends only at vertices whose angles add up to more than \f$2\pi\f$, saddle
 * vertices, and at border vertices where they add up to more than \f$\pi\f$
 * \cgalCite{mmp-dgp-87}; between them it is straight across unfolded faces. So the arcs of this
 * graph \cgalCite{ywh-svg-13} are all straight lines from such vertices to others. They are not
 * stored, but found when a node is expanded, and most of them are never looked for: upper bounds of
 * all distances, which a search along edges finds first, tell that they are of no use. Section
 * \ref AG_saddle_vertex_graph of the user manual describes the algorithm, and the report
 * \cgalCite{ag-report} explains why it loses no vertex.
 *
 * It is the default of the class `Surface_mesh_shortest_path`, and serves to measure errors. The
 * user manual compares times with those of \cgal's class of that name. On smooth surfaces, the time
 * per vertex grows with the square root of their number; a bound is far cheaper there.
 *
 * Where faces are thinner than rounding errors, a search may lose all lines to a vertex. It detects
 * that at its end, when no other vertex is left: it then reaches the vertex along edges, and
 * continues from there. So a visitor may be notified of such a vertex, and of those behind it,
 * after vertices that are farther away, and a second time if they had a longer path before. Runs
 * that end early, and runs toward a goal, do not do this: their paths do not lead over such a
 * vertex, unless it is the goal or a target. On ordinary meshes, no vertex is lost.
 *
 * An object of this class never changes after its construction and may be used by several threads.
 *
 * \cgalModels{SurfaceGraph}
 */
class Saddle_vertex_graph
{
public:
  /// the number of a node; that of the vertex it stands for.
  using Node = Intrinsic_triangulation::Index;

  /// a graph that gives bounds for searches for pairs: see `Exact_landmarks`.
  using Approximation = Discrete_geodesic_graph;

  /// \name Creation
  /// @{

  /// the graph of an empty mesh.
  Saddle_vertex_graph() : Saddle_vertex_graph(Intrinsic_triangulation()) {}

  /*!
   * prepares the graph of `triangulation`.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param triangulation the triangulation
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
   *           listed below; parameters that the graph does not support are rejected
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{epsilon}
   *     \cgalParamDescription{the error bound; only `0` is accepted}
   *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
   *     \cgalParamDefault{`0`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{concurrency_tag}
   *     \cgalParamDescription{whether several threads take part in each search of the graph. The
   *                           result does not depend on their number.}
   *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
   *                    `CGAL::Parallel_if_available_tag`}
   *     \cgalParamDefault{`CGAL::Sequential_tag`}
   *     \cgalParamExtra{`CGAL::Parallel_tag` needs TBB.}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if `epsilon` is given and not `0`, if a face breaks the triangle
   * inequality, or if `triangulation` has weights or barriers.
   *
   * Run time and memory are \cgalBigO{n}: 241 bytes per vertex, in addition to the triangulation.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Saddle_vertex_graph(Intrinsic_triangulation triangulation,
                               const NamedParameters& np = parameters::default_values())
    : m_loop(internal::Loop::with_tag<internal::Concurrency_tag<NamedParameters>>().for_size(
          triangulation.number_of_vertices())),
      m_edges(checked(std::move(triangulation), np)),
      m_tables(m_edges.triangulation(), m_loop)
  {
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the triangulation that the graph was built on.
  const Intrinsic_triangulation& triangulation() const { return m_edges.triangulation(); }

  /// returns the bound that holds in the graph: `0`.
  double epsilon() const { return 0; }

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return m_edges.number_of_nodes(); }

  /// returns the unit of lengths, that of the triangulation.
  double unit() const { return m_edges.unit(); }

  /// returns a summary of the lengths of the mesh's edges. Arcs can be longer.
  const Arc_lengths& arc_lengths() const { return m_edges.arc_lengths(); }

  /// \cond SKIP_IN_MANUAL
  // What a search keeps: upper bounds of distances, and how paths arrive.
  using Run = internal::Saddle_run<Saddle_vertex_graph>;
  /// \endcond

  /// returns whether several threads take part in each search.
  bool is_parallel() const { return m_loop.is_parallel(); }

  /// attaches a point of the surface by straight lines: those in its faces if no labels are known,
  /// otherwise all that may be part of shortest paths.
  internal::Lines_of_sight attach(const Intrinsic_point& point) const
  {
    return {triangulation(), m_tables, point};
  }

  /// prefetches what it takes to find the first arcs of `node`.
  void prefetch(const Node node) const { m_edges.prefetch(node); }

  /// returns the number of bytes that the graph takes, its triangulation included.
  std::size_t memory() const { return internal::memory_of(m_edges, m_tables); }

  /// returns whether the triangulation is valid.
  bool is_valid() const { return m_edges.is_valid(); }

  /// @}

private:
  template <typename Graph, typename Observer>
  friend class internal::Saddle_run;

  template <typename NamedParameters>
  static Intrinsic_triangulation checked(Intrinsic_triangulation triangulation,
                                         const NamedParameters& np)
  {
    if constexpr(internal::is_given<NamedParameters, internal_np::epsilon_t>)
      if(internal::value_of_number(parameters::get_parameter(np, internal_np::epsilon)) != 0)
        internal::reject("Saddle_vertex_graph gives exact distances: epsilon must be 0, if given");
    return internal::without_weights(std::move(triangulation), np, "Saddle_vertex_graph");
  }

  internal::Loop m_loop; // declared first: the others are constructed with it
  Edge_graph m_edges;
  internal::Sight_tables m_tables;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_SADDLE_VERTEX_GRAPH_H
