// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_PORTAL_LABELS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_PORTAL_LABELS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Paths/Landmarks.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Portal_builder.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Portal_part.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Two_way_arcs.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsPaths
 *
 * Labels of all vertices of a graph, from which an interval that contains the distance of any two
 * of them is read in microseconds, without a search.
 *
 * Separators divide the graph into halves, these into halves, and so on, as in nested dissection
 * \cgalCite{g-ndrfem-73}. Each vertex keeps its distances from some nodes of each separator around
 * it, its portals; that a few of them stand for a whole separator, up to a factor, is an idea of
 * Thorup \cgalCite{t-corad-04}. They are chosen for each vertex such that each node \f$q\f$ of the
 * separator has a portal \f$p\f$ of the vertex \f$v\f$ with \f$d(v,p) + d(p,q) \le (1 +
 * \varepsilon)\, d(v,q)\f$. The distances between the portals of a separator are in a table. So the
 * distance of a pair is at most the smallest sum over portals of both, and at least this sum
 * divided by \f$1 + \varepsilon\f$: see the report \cgalCite{ag-report}. Pairs that no separator
 * divides are in a table of their own. Hub labels \cgalCite{adgw-hlarn-11} keep nodes that shortest
 * paths of both vertices have in common instead, which makes them exact, and larger.
 *
 * Distances are those in the graph whose arcs all lead back, too. They are at most
 * `asymmetry()` smaller, relatively, than those in `graph`, and paths on the surface all the same.
 *
 * Labels are worth it for very many pairs that are not known beforehand. An object takes a search
 * for each node of a separator, which most vertices are if arcs are long, and one to two thousand
 * bytes per vertex; section \ref AG_pair_lists of the user manual has figures. A graph with a large
 * bound is better than one with a small bound, as its arcs make thinner separators.
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
  /// the number of a vertex, which is that of its node.
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
   *                           \f$1 + \varepsilon\f$, up to rounding to single precision}
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
    : m_graph(&graph),
      m_epsilon(checked_epsilon(np)),
      m_number_of_changes(internal::number_of_changes(graph))
  {
    build(internal::Loop::with_tag<internal::Concurrency_tag<NamedParameters>>());
  }

  /// labels of a temporary graph would outlive it.
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Portal_labels(const SurfaceGraph&& graph, const NamedParameters& np = {}) = delete;

  /// returns the graph.
  const SurfaceGraph& graph() const { return *m_graph; }

  /// returns the factor, less one, by which the ends of intervals differ, except for rounding.
  double epsilon() const { return m_epsilon; }

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
  std::pair<double, double> distance_interval(Node source, Node target) const;

  /*!
   * returns a length from the distance between two vertices in `graph()` to `1 + ratio` times it,
   * or infinity if there is no path. It may be smaller than the distance if there is a path that is
   * shorter since arcs lead back.
   *
   * If the interval does not prove that, `search` finds the distance. It is led by landmarks if it
   * uses some.
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
  template <typename PriorityQueue>
  double distance(Node source,
                  Node target,
                  double ratio,
                  Surface_search<SurfaceGraph, PriorityQueue>& search) const;

  /// returns the number of labels of all vertices.
  std::size_t number_of_labels() const { return m_distance.size(); }

  /// returns the number of bytes that labels and tables take.
  std::size_t memory() const
  {
    return internal::memory_of(m_parts, m_part, m_place, m_first_level, m_first_label, m_portal,
                               m_distance, m_table);
  }

private:
  // Relative, of sums of distances in single precision, and of what is compared with them.
  static constexpr double ROUNDING = 1. / (1 << 22), ROUNDING_OF_COVER = 1. / (1 << 19);
  static constexpr float no_path = std::numeric_limits<float>::infinity();

  // Where the table of a part is, and how many rows it has.
  struct Part
  {
    std::size_t first_in_table, size;
    std::uint32_t parent, depth;
    bool is_last;
  };

  template <typename NamedParameters>
  static double checked_epsilon(const NamedParameters& np)
  {
    constexpr double by_default = 0.02, largest = 1e6;
    const double epsilon = internal::value_of_number(parameters::choose_parameter(
        parameters::get_parameter(np, internal_np::epsilon), by_default));
    return (std::min)(internal::checked_positive(epsilon, "epsilon"), largest);
  }

  std::size_t number_of_vertices() const { return m_graph->triangulation().number_of_vertices(); }

  void check_graph() const;
  void build(const internal::Loop& loop);
  void count_labels(const std::vector<internal::Portal_part>& parts);
  void add(internal::Portal_part& part, std::vector<std::uint32_t>& number_of_levels);

  void check(const Node vertex) const
  {
    if(vertex >= number_of_vertices())
      internal::reject("vertex " + std::to_string(vertex) + " does not exist: there are " +
                       std::to_string(number_of_vertices()) + " vertices");
  }

  double in_unit_of_mesh(const double stored) const
  {
    return m_scale.label(stored) * m_graph->unit();
  }

  std::uint32_t common_part(Node v, Node w) const;
  float distance_in(const Part& part, Node v, Node w) const;
  float smallest_sum(std::uint32_t part, Node v, Node w) const;
  void lower_sum(const Part& part, Node v, Node w, float& smallest) const;

  const SurfaceGraph* m_graph;
  double m_epsilon;
  std::size_t m_number_of_changes;
  internal::Portal_scale m_scale;
  std::vector<Part> m_parts;              // each after its parent
  std::vector<std::uint32_t> m_part;      // of each vertex, the deepest one
  std::vector<std::uint32_t> m_place;     // of a vertex in its last part
  std::vector<std::size_t> m_first_level; // of each vertex, in the next array
  std::vector<std::size_t> m_first_label; // at each separator around it, the largest part first
  std::vector<std::uint16_t> m_portal;    // of each label
  std::vector<float> m_distance;          // of each label, increasing
  std::vector<float> m_table;
};

template <typename SurfaceGraph>
void Portal_labels<SurfaceGraph>::check_graph() const
{
  if(std::isinf(m_graph->asymmetry()))
    internal::reject("Portal_labels need a graph whose arcs lead back; costs of this one depend on "
                     "the direction");
  if(m_graph->triangulation().has_barriers())
    internal::reject("Portal_labels do not support barriers, which the triangulation has");
}

template <typename SurfaceGraph>
void Portal_labels<SurfaceGraph>::build(const internal::Loop& loop)
{
  check_graph();
  const internal::Two_way_arcs arcs(*m_graph);
  internal::Portal_builder builder(arcs, number_of_vertices(), 1 + m_epsilon, loop);
  std::vector<internal::Portal_part> parts = builder.run();
  m_scale = builder.scale();
  count_labels(parts);
  std::vector<std::uint32_t> number_of_levels(number_of_vertices());
  for(internal::Portal_part& part : parts)
  {
    add(part, number_of_levels);
    part = {};
  }
}

// Makes room for them: `m_first_label` gets the sums.
template <typename SurfaceGraph>
void Portal_labels<SurfaceGraph>::count_labels(const std::vector<internal::Portal_part>& parts)
{
  m_part.resize(number_of_vertices());
  m_place.resize(number_of_vertices());
  m_first_level.resize(number_of_vertices() + 1);
  std::size_t size_of_tables = 0;
  for(const internal::Portal_part& part : parts)
  {
    size_of_tables += part.table.size();
    for(std::size_t i = 0; i < part.labels.size(); ++i)
      ++m_first_level[std::size_t(part.vertices[i]) + 1];
  }
  for(std::size_t i = 1; i < m_first_level.size(); ++i)
    m_first_level[i] += m_first_level[i - 1];
  m_first_label.resize(m_first_level.back() + 1);
  std::vector<std::uint32_t> number_of_levels(number_of_vertices());
  for(const internal::Portal_part& part : parts)
    for(std::size_t i = 0; i < part.labels.size(); ++i)
    {
      const Node v = part.vertices[i];
      m_first_label[m_first_level[v] + number_of_levels[v]++ + 1] = part.labels[i].size();
    }
  for(std::size_t i = 1; i < m_first_label.size(); ++i)
    m_first_label[i] += m_first_label[i - 1];
  m_portal.resize(m_first_label.back());
  m_distance.resize(m_first_label.back());
  m_parts.reserve(parts.size());
  m_table.reserve(size_of_tables);
}

template <typename SurfaceGraph>
void Portal_labels<SurfaceGraph>::add(internal::Portal_part& part,
                                      std::vector<std::uint32_t>& number_of_levels)
{
  for(std::size_t i = 0; i < part.vertices.size(); ++i)
  {
    const Node v = part.vertices[i];
    m_part[v] = static_cast<std::uint32_t>(m_parts.size());
    m_place[v] = static_cast<std::uint32_t>(i);
    if(part.is_last)
      continue;
    std::size_t label = m_first_label[m_first_level[v] + number_of_levels[v]++];
    for(const internal::Portal_label& l : part.labels[i])
    {
      m_portal[label] = static_cast<std::uint16_t>(l.portal);
      m_distance[label++] = l.distance;
    }
  }
  m_parts.push_back({m_table.size(), part.size, part.parent, part.depth, part.is_last});
  m_table.insert(m_table.end(), part.table.begin(), part.table.end());
}

template <typename SurfaceGraph>
std::pair<double, double> Portal_labels<SurfaceGraph>::distance_interval(const Node source,
                                                                         const Node target) const
{
  check(source);
  check(target);
  if(source == target)
    return {0, 0};
  const std::uint32_t part = common_part(source, target);
  if(part == internal::Portal_part::no_parent)
    return {internal::infinity, internal::infinity};
  const bool is_exact = m_parts[part].is_last;
  const double sum =
      is_exact ? distance_in(m_parts[part], source, target) : smallest_sum(part, source, target);
  const double factor = is_exact ? 1 + ROUNDING : (1 + m_epsilon) * (1 + ROUNDING_OF_COVER);
  constexpr double smallest = 16. * std::numeric_limits<float>::denorm_min();
  return {in_unit_of_mesh((std::max)(sum - smallest, 0.) / factor),
          in_unit_of_mesh(sum * (1 + ROUNDING))};
}

template <typename SurfaceGraph>
template <typename PriorityQueue>
double
Portal_labels<SurfaceGraph>::distance(const Node source,
                                      const Node target,
                                      const double ratio,
                                      Surface_search<SurfaceGraph, PriorityQueue>& search) const
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

// Returns the smallest part that both are in, or `no_parent`.
template <typename SurfaceGraph>
std::uint32_t Portal_labels<SurfaceGraph>::common_part(const Node v, const Node w) const
{
  std::uint32_t a = m_part[v], b = m_part[w];
  while(a != b)
  {
    std::uint32_t& deeper = m_parts[a].depth > m_parts[b].depth ? a : b;
    if(m_parts[deeper].parent == internal::Portal_part::no_parent)
      return internal::Portal_part::no_parent;
    deeper = m_parts[deeper].parent;
  }
  return a;
}

template <typename SurfaceGraph>
float Portal_labels<SurfaceGraph>::distance_in(const Part& part, const Node v, const Node w) const
{
  const std::size_t i = (std::max)(m_place[v], m_place[w]), j = (std::min)(m_place[v], m_place[w]);
  return m_table[part.first_in_table + i * (i - 1) / 2 + j];
}

template <typename SurfaceGraph>
float Portal_labels<SurfaceGraph>::smallest_sum(std::uint32_t part,
                                                const Node v,
                                                const Node w) const
{
  float result = no_path;
  while(part != internal::Portal_part::no_parent)
  {
    lower_sum(m_parts[part], v, w, result);
    part = m_parts[part].parent;
  }
  return result;
}

// Labels are sorted, so that those that are too far end a loop.
template <typename SurfaceGraph>
void Portal_labels<SurfaceGraph>::lower_sum(const Part& part,
                                            const Node v,
                                            const Node w,
                                            float& smallest) const
{
  const std::size_t* const of_v = m_first_label.data() + m_first_level[v] + part.depth;
  const std::size_t* const of_w = m_first_label.data() + m_first_level[w] + part.depth;
  if(of_w[0] == of_w[1])
    return; // an empty separator
  for(std::size_t i = of_v[0]; i < of_v[1]; ++i)
  {
    if(m_distance[i] + m_distance[of_w[0]] >= smallest)
      return;
    const float* const row = m_table.data() + part.first_in_table + m_portal[i] * part.size;
    for(std::size_t j = of_w[0]; j < of_w[1]; ++j)
    {
      const float sum = m_distance[i] + m_distance[j];
      if(sum >= smallest)
        break;
      smallest = (std::min)(smallest, sum + row[m_portal[j]]);
    }
  }
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_PORTAL_LABELS_H
