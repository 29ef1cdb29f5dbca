// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_PORTAL_LABELS_H
#define CGAL_GEODESIC_QUERIES_PORTAL_LABELS_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Geodesic_queries/internal/Portals/Portal_builder.h>
#include <CGAL/Geodesic_queries/internal/Portals/Portal_file.h>
#include <CGAL/Geodesic_queries/internal/Portals/Portal_tables.h>
#include <CGAL/Geodesic_queries/internal/Portals/Two_way_arcs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <istream>
#include <ostream>
#include <string>
#include <utility>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicQueriesPairs
 *
 * Labels of all vertices of a graph, from which an interval that contains the distance of any two
 * of them is read in microseconds, without a search.
 *
 * Separators divide the graph into halves, these into halves, and so on, as in nested dissection
 * \cgalCite{g-ndrfem-73}. Each vertex keeps its distances from some nodes of each separator around
 * it, its portals; that a few of them stand for a whole separator, up to a factor, is an idea of
 * Thorup \cgalCite{t-corad-04}. They are chosen for each vertex such that each node \f$q\f$ of the
 * separator has a portal \f$p\f$ of the vertex \f$v\f$ with \f$d(v,p) + d(p,q) \le (1 +
 * \varepsilon)\, d(v,q)\f$, where \f$d\f$ are distances along paths that do not leave the part that
 * the separator divides. The distances between the portals of a separator are in a table. So the
 * distance of a pair is at most the smallest sum over portals of both, and at least this sum
 * divided by \f$1 + \varepsilon\f$: see the report \cgalCite{ag-report}. Parts of about a hundred
 * vertices are not divided; their distances are in tables. Hub labels \cgalCite{adgw-hlarn-11} keep
 * nodes that shortest paths of both vertices have in common instead, which makes them exact, and
 * larger.
 *
 * Distances are those in the graph whose arcs all lead back, too. They are at most
 * `asymmetry()` smaller, relatively, than those in `graph`, and paths on the surface all the same.
 *
 * Labels are worth it for very many pairs that are not known beforehand. An object takes a search
 * of each part from each node of its separator, and most nodes are in one if arcs are long; and one
 * to two thousand bytes per vertex. It can be saved. Section \ref AG_pair_lists of the user manual
 * has figures. A graph with a large bound is better than one with a small bound, as its arcs make
 * thinner separators.
 *
 * An object never changes after its construction, and may be used by several threads.
 *
 * \tparam SurfaceGraph a model of `SurfaceGraph` with the optional `asymmetry()`, which is not
 *         infinite: `Discrete_geodesic_graph`, `Edge_graph`, or, if it has few nodes,
 *         `Steiner_graph`
 *
 * \sa `Landmarks`
 */
template <typename SurfaceGraph>
class Portal_labels
{
  static_assert(internal::has_asymmetry<SurfaceGraph>,
                "Portal_labels need a graph with asymmetry(): Discrete_geodesic_graph, Edge_graph "
                "or Steiner_graph");

public:
  /// the number of a vertex in the triangulation, which is that of its node;
  /// `Intrinsic_triangulation::vertex()` returns it for the index in the mesh.
  using Node = typename SurfaceGraph::Node;

  /*!
   * chooses portals, and finds distances from them.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param graph the graph, which is referred to, not copied
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
   *           listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{epsilon}
   *     \cgalParamDescription{the ends of an interval differ by the factor
   *                           \f$1 + \varepsilon\f$, up to rounding to single precision. Numbers
   *                           above a million stand for a million.}
   *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
   *     \cgalParamDefault{`0.02`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{concurrency_tag}
   *     \cgalParamDescription{whether several threads work at the same time. The result is the
   *                           same.}
   *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
   *                    `CGAL::Parallel_if_available_tag`}
   *     \cgalParamDefault{`CGAL::Sequential_tag`}
   *     \cgalParamExtra{`CGAL::Parallel_tag` needs TBB.}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if `epsilon` is not a finite number above `0`, if distances in
   *         the graph depend on the direction, or if the triangulation has barriers.
   * \throws std::length_error if there are more than 65,536 portals on a separator.
   *
   * If separators have \cgalBigO{\sqrt n} nodes, as on surfaces of bounded genus with faces that
   * are not oblong and short arcs, run time is \cgalBigO{n^{1.5}}: that of a search of the part
   * that a separator divides, for each of its nodes, and for each vertex of this part, as many
   * operations on single numbers as the separator has nodes, times the number of portals of the
   * vertex. Memory is proportional to the number of labels and to the squares of the numbers of
   * portals on separators, the sum of which is \cgalBigO{n \log n}; meanwhile, also to the squares
   * of the numbers of nodes. 64 MB of rows of distances, or 64 rows, are kept at a time.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Portal_labels(const SurfaceGraph& graph,
                         const NamedParameters& np = parameters::default_values())
    : m_graph(&graph), m_number_of_changes(internal::number_of_changes(graph))
  {
    const double epsilon = checked_epsilon(np);
    check(graph);
    const internal::Two_way_arcs arcs(graph);
    const std::size_t number_of_vertices = graph.triangulation().number_of_vertices();
    const auto loop = internal::Loop::with_tag<internal::Concurrency_tag<NamedParameters>>();
    internal::Portal_builder builder(arcs, number_of_vertices, 1 + epsilon, loop);
    m_tables = internal::Portal_tables(builder.run(), number_of_vertices, builder.scale(), epsilon);
  }

  /// labels of a temporary graph would outlive it.
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Portal_labels(const SurfaceGraph&& graph, const NamedParameters& np = {}) = delete;

  /// returns the graph.
  const SurfaceGraph& graph() const { return *m_graph; }

  /// returns the factor, less one, by which the ends of intervals differ, except for rounding.
  double epsilon() const { return m_tables.epsilon(); }

  /// returns whether arcs of the graph have not changed since the construction. If they have,
  /// intervals are those of the graph as it was.
  bool are_valid() const { return m_number_of_changes == internal::number_of_changes(*m_graph); }

  /*!
   * returns an interval that contains the distance between two vertices of the triangulation, in
   * the unit of the mesh. The upper end is the length of a path. Both ends are infinity if there is
   * no path. The result does not depend on the order of the two, to the last bit.
   *
   * \throws std::invalid_argument if a vertex does not exist.
   *
   * Run time is that of the sums over pairs of portals on each separator around both vertices, at
   * most; those that cannot be the smallest are left out.
   */
  std::pair<double, double> distance_interval(const Node source, const Node target) const
  {
    check(source);
    check(target);
    const auto [lower, upper] = m_tables.interval(source, target);
    return {lower * m_graph->unit(), upper * m_graph->unit()};
  }

  /*!
   * returns a length from the distance between two vertices in `graph()` to `1 + ratio` times it,
   * or infinity if there is no path. It may be smaller than the distance if there is a path that is
   * shorter since arcs lead back.
   *
   * If the interval does not prove that, `search` finds the distance.
   *
   * \tparam SurfaceSearch `Surface_search` or `Guided_search`
   *
   * \param source the vertex where paths start
   * \param target the vertex where they end
   * \param ratio the largest relative error, which is not negative; if it is at least a little
   *              larger than `epsilon()`, there is never a search
   * \param search a search of `graph()`, which forgets its last run if it is used
   *
   * \throws std::invalid_argument if a vertex does not exist, if `ratio` is negative or not a
   *         number, or if the search is one of another graph.
   */
  template <typename SurfaceSearch>
  double distance(Node source, Node target, double ratio, SurfaceSearch& search) const;

  /*!
   * writes the labels to a binary stream: 6 bytes per label, 2 to 4 per distance in a table, and
   * some more. The graph is not written, only a checksum of its arcs.
   *
   * \throws std::runtime_error if writing fails.
   * \throws std::invalid_argument if the graph has changed since the construction.
   *
   * Run time is proportional to the size of the file and of the graph, all arcs of which are copied
   * for the checksum: this takes about 24 bytes per arc meanwhile.
   */
  void save(std::ostream& out) const
  {
    if(!are_valid())
      internal::reject("labels cannot be saved, as the graph has changed since they were made");
    internal::Portal_file::save(internal::bytes_to(out), internal::Two_way_arcs(*m_graph),
                                m_tables);
  }

  /*!
   * reads labels from a binary stream that were written for the same graph, which is referred to:
   * one whose arcs are the same, to the last bit of their lengths.
   *
   * \throws std::invalid_argument if the stream does not contain labels, is damaged or incomplete,
   *         or belongs to another graph. The message says which.
   *
   * Run time and memory are those of `save()`, and the labels.
   */
  static Portal_labels load(std::istream& in, const SurfaceGraph& graph)
  {
    check(graph);
    return {graph,
            internal::Portal_file::load(internal::bytes_from(in), internal::Two_way_arcs(graph),
                                        graph.triangulation().number_of_vertices())};
  }

  /// labels of a temporary graph would outlive it.
  static Portal_labels load(std::istream& in, const SurfaceGraph&& graph) = delete;

  /// returns the number of labels of all vertices.
  std::size_t number_of_labels() const { return m_tables.number_of_labels(); }

  /// returns the number of bytes that labels and tables take.
  std::size_t memory() const { return m_tables.memory(); }

private:
  Portal_labels(const SurfaceGraph& graph, internal::Portal_tables tables)
    : m_graph(&graph),
      m_number_of_changes(internal::number_of_changes(graph)),
      m_tables(std::move(tables))
  {
  }

  template <typename NamedParameters>
  static double checked_epsilon(const NamedParameters& np)
  {
    constexpr double by_default = 0.02, largest = 1e6;
    const double epsilon = internal::value_of_number(parameters::choose_parameter(
        parameters::get_parameter(np, internal_np::epsilon), by_default));
    return (std::min)(internal::checked_positive(epsilon, "epsilon"), largest);
  }

  static void check(const SurfaceGraph& graph)
  {
    if(std::isinf(graph.asymmetry()))
      internal::reject("Portal_labels need a graph whose arcs lead back; costs of this one depend "
                       "on the direction");
    if(graph.triangulation().has_barriers())
      internal::reject("Portal_labels do not support barriers, which the triangulation has");
  }

  void check(const Node vertex) const
  {
    const std::size_t number = m_graph->triangulation().number_of_vertices();
    if(vertex >= number)
      internal::reject("vertex " + std::to_string(vertex) + " does not exist: there are " +
                       std::to_string(number) + " vertices");
  }

  const SurfaceGraph* m_graph;
  std::size_t m_number_of_changes;
  internal::Portal_tables m_tables;
};

template <typename SurfaceGraph>
template <typename SurfaceSearch>
double Portal_labels<SurfaceGraph>::distance(const Node source,
                                             const Node target,
                                             const double ratio,
                                             SurfaceSearch& search) const
{
  if(!(ratio >= 0))
    internal::reject("the ratio is " + internal::text_of(ratio) +
                     "; it must be a number that is not negative");
  if(&search.graph() != m_graph)
    internal::reject("the search is one of another graph than the labels");
  const auto [lower, upper] = distance_interval(source, target);
  if(are_valid() && (upper <= lower || upper <= (1 + ratio) * lower))
    return upper;
  const Intrinsic_point goal = Intrinsic_point::at_vertex(target);
  search.run_to(goal, {{Intrinsic_point::at_vertex(source)}});
  const double found = search.distance(goal);
  return are_valid() ? (std::min)(found, upper) : found;
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_PORTAL_LABELS_H
