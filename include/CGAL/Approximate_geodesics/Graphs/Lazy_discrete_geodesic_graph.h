// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_LAZY_DISCRETE_GEODESIC_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_LAZY_DISCRETE_GEODESIC_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_front.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_run.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_triangulation.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/stored_arcs.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <boost/config.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsGraphs
 *
 * A discrete geodesic graph whose arcs are not computed before a search asks for them.
 *
 * It has the same bound as `Discrete_geodesic_graph`, and is for searches that reach a small part
 * of a large mesh, and for meshes that are searched once or a few times: on scanned models, a
 * search is several times as slow as in the built graph, and building that takes as long as several
 * such searches. `approximate_geodesic_distances()` and `approximate_geodesic_path()` use it.
 *
 * When a node is expanded, the distances found so far tell which arcs are of no use, and these are
 * never computed. Which ones depends on the order in which nodes are expanded. So distances may
 * differ between queues, from run to run of one workspace, whose queue adapts to the mesh, with and
 * without `Parallel_tag`, and from those in the built graph: always within the bound. If arcs are
 * to be kept, all arcs of a node are computed when it is expanded for the first time, and those are
 * the arcs, and the distances, of `Discrete_geodesic_graph`.
 *
 * An object of this class may be used by several threads at the same time.
 *
 * \cgalModels{SurfaceGraph}
 */
class Lazy_discrete_geodesic_graph
{
public:
  /// the number of a node; those of the vertices come first.
  using Node = Intrinsic_triangulation::Index;

  /// whether computed arcs are kept.
  enum class Arcs
  {
    FORGOTTEN, ///< they are computed again when they are needed again
    KEPT       ///< they take memory as in `Discrete_geodesic_graph`, for the nodes expanded so far
  };

  /// \name Creation
  /// @{

  /// the graph of an empty mesh.
  Lazy_discrete_geodesic_graph() : Lazy_discrete_geodesic_graph(Intrinsic_triangulation()) {}

  /*!
   * prepares the graph of `triangulation`.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param triangulation the triangulation
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
   *           listed below
   * \param arcs whether arcs are kept
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{epsilon}
   *     \cgalParamDescription{paths in the graph are at most \f$1 + \varepsilon\f$ times as long as
   *                           the shortest ones on the surface}
   *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
   *     \cgalParamDefault{`0.1`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{concurrency_tag}
   *     \cgalParamDescription{whether several threads take part in each search of the graph.
   *                           Their number does not change the result. Whether there are
   *                           several can change it within the bound.}
   *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
   *                    `CGAL::Parallel_if_available_tag`}
   *     \cgalParamDefault{`CGAL::Sequential_tag`}
   *     \cgalParamExtra{`CGAL::Parallel_tag` needs TBB.}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if `epsilon` is not a finite number above `0`, if a face breaks
   *         the triangle inequality, or if `triangulation` has weights or barriers.
   *
   * Run time and memory are \cgalBigO{n}: 192 bytes per vertex, in addition to the triangulation.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Lazy_discrete_geodesic_graph(Intrinsic_triangulation triangulation,
                                        const NamedParameters& np = parameters::default_values(),
                                        const Arcs arcs = Arcs::FORGOTTEN)
    : m_loop(internal::Loop::with_tag<internal::Concurrency_tag<NamedParameters>>().for_size(
          triangulation.number_of_vertices())),
      m_rules(internal::checked_epsilon(np)),
      m_triangulation(
          internal::without_weights(std::move(triangulation), np, "Lazy_discrete_geodesic_graph"),
          m_loop),
      m_unfolding(m_triangulation.get(), m_loop),
      m_edge_lengths(m_triangulation.edge_lengths())
  {
    if(arcs == Arcs::KEPT)
    {
      m_unit = internal::unit_of_arcs(this->triangulation());
      m_arc_cache = internal::Arc_cache(number_of_nodes());
    }
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the triangulation that the graph was built on.
  const Intrinsic_triangulation& triangulation() const { return m_triangulation.mesh(); }

  /// returns the bound that holds in the graph.
  double epsilon() const { return m_rules.epsilon; }

  /// \cond SKIP_IN_MANUAL
  // What a search keeps: which nodes were expanded before.
  using Run = internal::Cone_run<Lazy_discrete_geodesic_graph>;
  /// \endcond

  /// returns whether several threads take part in each search.
  bool is_parallel() const { return m_loop.is_parallel(); }

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return m_triangulation.get().number_of_vertices(); }

  /// returns the unit of lengths, that of the triangulation.
  double unit() const { return triangulation().unit(); }

  /// returns a summary of the lengths of the mesh's edges. Arcs can be longer.
  const Arc_lengths& arc_lengths() const { return m_edge_lengths; }

  /*!
   * calls `f(target, length)` for arcs that start from `node`: for all of them if arcs are kept,
   * else for those that may be of use to a search with these labels, which expands the node for the
   * first time.
   */
  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    if(!advances_together())
      return find_arcs_in_turn(node, false, labels, f);
    Arc_function<F> arcs{f};
    internal::Front_memory memory;
    expand(&node, 1, m_rules.epsilon, labels, arcs, memory);
  }

  /*!
   * calls `f(h, t)` for every edge that the arc of the given length from `source` to `target`
   * crosses, in this order: at the point that is at the part `t` of the way from the source to the
   * target of the halfedge `h`. `rounding` is a bound on the error of the given length. Returns the
   * length of the arc.
   * \pre There is such an arc.
   */
  template <typename F>
  double for_each_crossing(const Node source,
                           const Node target,
                           const double length,
                           F f,
                           const double rounding = 0) const
  {
    if(!advances_together())
      return m_triangulation.trace<internal::Leave_out_detours>(
          m_rules, source, target,
          m_arc_cache.is_enabled() ? internal::before_rounding_up(length) : length, rounding, f);
    return m_triangulation.trace<internal::Leave_out_nothing>(rules_of_longest_arcs(), source,
                                                              target, length, rounding, f);
  }

  /// returns where a node is, which may be one of the vertices.
  Intrinsic_point position(const Node node) const { return m_triangulation.position(node); }

  /// attaches a point of the surface by straight lines across the faces around it, as far as those
  /// from a vertex are followed. So the bound holds for it, too.
  internal::Cones_of_point attach(const Intrinsic_point& point) const
  {
    return {triangulation(), m_rules, point};
  }

  /// prefetches what it takes to find the first arcs of `node`.
  void prefetch(const Node node) const
  {
    const Intrinsic_triangulation& triangulation = m_triangulation.get();
    const auto h = triangulation.first_halfedge(node);
    triangulation.prefetch(h);
    constexpr Node faces_per_cache_line = 2;
    for(Node i = 0; i < 6; i += faces_per_cache_line) // of most nodes
      m_unfolding.prefetch(h + i);
  }

  /// returns the number of bytes that the graph takes, its triangulation and the arcs that were
  /// kept included.
  std::size_t memory() const
  {
    return internal::memory_of(m_triangulation, m_unfolding, m_arc_cache);
  }

  /// returns whether the triangulation is valid.
  bool is_valid() const { return triangulation().is_valid(); }

  /// @}

private:
  friend class internal::Cone_run<Lazy_discrete_geodesic_graph>;

  using Expansion = internal::Cone_expansion<internal::Unfolding>;

  // whether nodes that are expanded for the first time are expanded together
  bool advances_together() const
  {
    return !m_arc_cache.is_enabled() && !m_triangulation.has_balanced_fans();
  }

  // With these rules, cones reach at least as far as those of `Cone_front`, so that all arcs of a
  // front are found again.
  internal::Cone_rules rules_of_longest_arcs() const
  {
    return m_rules.farther(internal::Cone_rules::share_of_ends_beside_labels(m_rules.epsilon));
  }

  template <typename F>
  struct Arc_function
  {
    void make_room(std::size_t /* number */) const {}

    void append(const bool is_arc, Node, double, const Node target, const double length) const
    {
      if(is_arc)
        f(target, length);
    }

    F& f;
  };

  // Not inline, so that it is compiled once: another compilation may round differently.
  template <typename Labels, typename Arcs>
  BOOST_NOINLINE void expand(const Node* const nodes,
                             const std::size_t number,
                             const double epsilon,
                             const Labels& labels,
                             Arcs& arcs,
                             internal::Front_memory& memory) const
  {
    const Intrinsic_triangulation& t = m_triangulation.get();
    const auto expand_with = [&](const auto is_general) {
      using Front = internal::Cone_front<is_general, internal::Unfolding, Labels, Arcs>;
      Front(t, m_unfolding, epsilon, labels, arcs, memory).expand(nodes, number);
    };
    if(internal::needs_general_front(t))
      expand_with(std::true_type());
    else
      expand_with(std::false_type());
    for(std::size_t i = 0; i < number; ++i)
      m_triangulation.for_each_lost_edge(nodes[i], [&](const Node target, const double length) {
        arcs.make_room(1);
        arcs.append(true, nodes[i], labels.distance(nodes[i]), target, length);
      });
  }

  // Finds the arcs of a node that is not expanded together with others.
  template <typename Labels, typename F>
  void find_arcs_in_turn(const Node node,
                         const bool was_expanded,
                         const Labels& labels,
                         const F& f) const
  {
    if(m_arc_cache.is_enabled())
    {
      const auto find = [&](std::vector<internal::Stored_arc>& arcs) {
        internal::find_stored_arcs(node, m_unit, arcs, [&](const auto& f_of_arc) {
          find_arcs(node, f_of_arc, internal::Leave_out_detours(), m_rules);
        });
      };
      for(const internal::Stored_arc& arc : m_arc_cache.arcs(node, find))
        f(arc.target, static_cast<double>(arc.length) * m_unit);
    }
    else if(!m_triangulation.has_balanced_fans()) // it was expanded before
      find_arcs(node, f, internal::Leave_out_nothing(), rules_of_longest_arcs());
    else if(was_expanded)
      find_arcs(node, f, internal::Leave_out_detours(), m_rules);
    else // the neighbors of a hub may all see each other: most arcs have a detour
      find_arcs(
          node, f,
          internal::Label_pruning<internal::Leave_out_detours, Labels>{
              {}, m_triangulation.get(), labels, labels.distance(node), m_rules.longest_detour},
          m_rules);
  }

  template <typename F, typename Visitor>
  void find_arcs(const Node node,
                 const F& f,
                 const Visitor& visitor,
                 const internal::Cone_rules& rules) const
  {
    const Expansion expansion(m_triangulation.get(), m_unfolding, rules);
    m_triangulation.for_each_arc(expansion, node, f, visitor);
  }

  internal::Loop m_loop; // declared first: the others are constructed with it
  internal::Cone_rules m_rules;
  internal::Cone_triangulation m_triangulation;
  internal::Unfolding m_unfolding;
  Arc_lengths m_edge_lengths;
  double m_unit = 1;                       // of kept arcs
  mutable internal::Arc_cache m_arc_cache; // may be added to by several threads at the same time
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_LAZY_DISCRETE_GEODESIC_GRAPH_H
