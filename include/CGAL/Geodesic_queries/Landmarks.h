// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_LANDMARKS_H
#define CGAL_GEODESIC_QUERIES_LANDMARKS_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Geodesic_queries/internal/for_each_arc.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicQueriesPairs
 *
 * The distances of all nodes of a graph from a few nodes that are far from each other, the
 * landmarks. By the triangle inequality, they give lower bounds of the distances of any two points,
 * which lead a search from one to the other past most of the graph: the ALT algorithm of Goldberg
 * and Harrelson \cgalCite{gh-cspasmgt-05}. Unlike straight-line distances, they reflect weights,
 * barriers and holes. Distances do not change by this, up to rounding in a Steiner graph.
 *
 * Each landmark but the first one is behind the nodes that those before it serve worst, as seen
 * from somewhere: it is chosen by the algorithm *avoid* of Goldberg and Werneck
 * \cgalCite{gw-cppspem-05}.
 *
 * An object is made once for a graph, which is worth it for many pairs: it takes two searches of
 * the whole graph for each landmark. `Guided_search` and `Pair_queries` use it. All landmarks are
 * in the largest connected part of the graph; pairs elsewhere are found as without them.
 *
 * Arcs may go one way only. Bounds that need the way back are used if it is known: the constructor
 * compares the distances with `asymmetry()` of the graph, arc by arc. There are none for nodes that
 * paths may start from, but do not lead through, such as vertices that barriers divide.
 *
 * An object never changes after its construction, and may be used by several threads.
 *
 * \tparam SurfaceGraph a model of `SurfaceGraph` with `for_each_arc()` and the optional
 *         `asymmetry()`: `Steiner_graph`, `Directional_graph`, `Discrete_geodesic_graph` or
 *         `Edge_graph`
 */
template <typename SurfaceGraph>
class Landmarks
{
public:
  /// the number of a node.
  using Node = typename SurfaceGraph::Node;

  /// a number of landmarks beyond which few nodes are saved.
  static constexpr std::size_t DEFAULT_NUMBER = 16;

  class Heuristic;

  /*!
   * searches `graph` from each landmark.
   *
   * \param graph the graph, which is referred to, not copied
   * \param number the number of landmarks, at least `1`
   *
   * \throws std::invalid_argument if `number` is `0`.
   *
   * Run time is that of two searches of the graph for each landmark, of one or a few to find the
   * largest connected part, and of looking at all arcs. Memory is 8 bytes per node and
   * landmark; meanwhile, also that of a workspace and 20 bytes per node.
   */
  explicit Landmarks(const SurfaceGraph& graph, std::size_t number = DEFAULT_NUMBER);

  /// landmarks of a temporary graph would outlive it.
  explicit Landmarks(const SurfaceGraph&& graph, std::size_t number = DEFAULT_NUMBER) = delete;

  /// returns the graph.
  const SurfaceGraph& graph() const { return *m_graph; }

  /// returns the landmarks.
  const std::vector<Node>& nodes() const { return m_nodes; }

  /// returns whether arcs of the graph have not changed since the construction. If they have, lower
  /// bounds need not hold, and searches do not use them.
  bool are_valid() const { return m_number_of_changes == internal::number_of_changes(*m_graph); }

  /// returns lower bounds of the distances to `goal`, which refer to this object.
  Heuristic to(const Intrinsic_point& goal) const { return Heuristic(*this, goal); }

  /// returns the number of bytes that the distances take.
  std::size_t memory() const
  {
    return internal::memory_of(m_nodes, m_distance, m_dead_ends, m_nearest, m_farthest);
  }

private:
  using Search = Propagation<SurfaceGraph>;

  // A distance that is not known: comparisons with it are false.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  // Of sums of arcs.
  double rounding() const
  {
    constexpr double part = 1e-11; // of the largest distance
    return part * m_largest;
  }

  const double* distances(const Node node) const
  {
    return m_distance.data() + std::size_t(node) * m_nodes.size();
  }

  // Calls `f(nearest, farthest)` with the distances of a node from all landmarks as an end of
  // paths.
  template <typename F>
  void as_end(const Node node, const F& f) const
  {
    const auto end = std::lower_bound(m_dead_ends.begin(), m_dead_ends.end(), node);
    if(end == m_dead_ends.end() || *end != node)
      return f(distances(node), distances(node));
    const auto row = static_cast<std::size_t>(end - m_dead_ends.begin()) * m_nodes.size();
    f(m_nearest.data() + row, m_farthest.data() + row);
  }

  // Returns the farthest node of the largest connected part, as seen from one of its nodes.
  static Node first_landmark(Search& search);

  // Returns the farthest of the nodes that were reached. `label_of(node)` is its distance.
  template <typename F>
  static Node farthest(const Search& search, const F& label_of)
  {
    const auto& nodes = search.reached_nodes();
    return *std::max_element(nodes.begin(), nodes.end(), [&](const Node a, const Node b) {
      return std::make_pair(label_of(a), b) < std::make_pair(label_of(b), a);
    });
  }

  void find_distances(Search& search, Node first);
  void add(Search& search, Node landmark, std::size_t i);
  Node next_landmark(Search& search, Node root, std::size_t number) const;
  void check_arcs();
  void set_apart(const std::vector<bool>& is_dead_end);
  double largest_difference(Node a, Node b, std::size_t number) const; // from the first landmarks

  const SurfaceGraph* m_graph;
  std::vector<Node> m_nodes;      // the landmarks
  std::vector<double> m_distance; // from each of them, in units of the graph, node by node
  // The nodes that paths do not lead through, their distances, and the largest ones of the nodes
  // before them, less the arcs from there.
  std::vector<Node> m_dead_ends;
  std::vector<double> m_nearest, m_farthest;
  double m_largest = 0;          // of the distances
  double m_part_of_way_back = 0; // the way there, as part of the way back; 0 if it is not known
  std::size_t m_number_of_changes;
};

/*!
 * Lower bounds of the distances from nodes to a goal: a consistent heuristic for
 * `Propagation::run_toward()`, a model of `AStarHeuristic` of the Boost Graph Library.
 *
 * A landmark at the distance \f$a\f$ from a node and \f$b\f$ from the goal gives the bounds
 * \f$b - a\f$ and \f$(a - b) / (1 + \alpha)\f$, where \f$\alpha\f$ is the `asymmetry()` of the
 * graph. They are lowered by more than the rounding of \f$a\f$ and \f$b\f$.
 *
 * The bound of a node that paths may start from, but do not lead through, is 0, and consistent for
 * the arcs from there, but not for those to it.
 */
template <typename SurfaceGraph>
class Landmarks<SurfaceGraph>::Heuristic
{
public:
  /// that keys are nearly equal, and nodes have to be expanded in their order.
  static constexpr bool needs_order = true;

  /// returns a lower bound for `node`, in units of the graph.
  double operator()(const Node node) const
  {
    const double* const from = m_landmarks.distances(node);
    double forward = 0, back = 0;
    for(std::size_t i = 0; i < m_smallest.size(); ++i) // in vector instructions
    {
      const double ahead = m_smallest[i] - from[i], behind = from[i] - m_largest[i];
      forward = forward < ahead ? ahead : forward;
      back = back < behind ? behind : back;
    }
    return (std::max)((std::max)(forward, back * m_landmarks.m_part_of_way_back) - rounding(), 0.);
  }

  /// returns how much sums of a distance and a bound may decrease along a path, by rounding.
  double rounding() const { return m_landmarks.rounding(); }

private:
  friend class Landmarks;

  Heuristic(const Landmarks& landmarks, const Intrinsic_point& goal)
    : m_landmarks(landmarks),
      m_smallest(landmarks.m_nodes.size(), internal::infinity),
      m_largest(landmarks.m_nodes.size(), -internal::infinity)
  {
    internal::attach_target(*landmarks.m_graph, goal)
        .for_each_node([this](const Node node, const double length) {
          if(length < internal::infinity)
            m_landmarks.as_end(node,
                               [&](const double* const nearest, const double* const farthest) {
                                 add_line(nearest, farthest, length);
                               });
        });
    for(std::vector<double>* const values : {&m_smallest, &m_largest})
      std::replace_if(
          values->begin(), values->end(), [](const double d) { return std::isinf(d); }, unknown);
  }

  void add_line(const double* const nearest, const double* const farthest, const double length)
  {
    for(std::size_t i = 0; i < m_smallest.size(); ++i)
    {
      const double sum = nearest[i] + length, difference = farthest[i] - length;
      m_smallest[i] = sum < m_smallest[i] ? sum : m_smallest[i];
      m_largest[i] = difference > m_largest[i] ? difference : m_largest[i];
    }
  }

  const Landmarks& m_landmarks;
  // Distances of the goal, by the line to it that makes them smallest or largest: a vertex that
  // barriers divide has one in each of its sectors.
  std::vector<double> m_smallest, m_largest;
};

template <typename SurfaceGraph>
Landmarks<SurfaceGraph>::Landmarks(const SurfaceGraph& graph, const std::size_t number)
  : m_graph(&graph), m_nodes(number), m_number_of_changes(internal::number_of_changes(graph))
{
  static_assert(internal::has_asymmetry<SurfaceGraph>,
                "Landmarks need a graph with asymmetry(): Steiner_graph, Directional_graph, "
                "Discrete_geodesic_graph or Edge_graph");
  if(number == 0)
    internal::reject("the number of landmarks is 0; it must be at least 1");
  m_distance.assign(graph.number_of_nodes() * number, unknown);
  if(graph.number_of_nodes() == 0)
    return;
  Search search(graph);
  find_distances(search, first_landmark(search));
  check_arcs();
}

template <typename SurfaceGraph>
auto Landmarks<SurfaceGraph>::first_landmark(Search& search) -> Node
{
  const std::size_t number_of_nodes = search.graph().number_of_nodes();
  std::vector<bool> is_known(number_of_nodes);
  std::size_t most = 0, number_known = 0;
  Node result = 0;
  for(Node node = 0; node < number_of_nodes && most < number_of_nodes - number_known; ++node)
  {
    if(is_known[node])
      continue;
    search.run_from(node);
    std::size_t number = 0;
    for(const Node reached : search.reached_nodes())
    {
      number += is_known[reached] ? 0 : 1;
      is_known[reached] = true;
    }
    number_known += number;
    if(number > most)
    {
      most = number;
      result = farthest(search, [&](const Node n) { return search.labels().distance(n); });
    }
  }
  return result;
}

template <typename SurfaceGraph>
void Landmarks<SurfaceGraph>::find_distances(Search& search, const Node first)
{
  const std::size_t number = m_nodes.size();
  add(search, first, 0);
  const std::vector<Node> nodes = search.reached_nodes(); // of the largest part
  constexpr std::size_t stride = 1000003;                 // a prime: roots lie apart
  for(std::size_t i = 1; i < number; ++i)
  {
    internal::check_for_interruption();
    add(search, next_landmark(search, nodes[i * stride % nodes.size()], i), i);
  }
}

template <typename SurfaceGraph>
void Landmarks<SurfaceGraph>::add(Search& search, const Node landmark, const std::size_t i)
{
  m_nodes[i] = landmark;
  search.run_from(landmark);
  for(const Node node : search.reached_nodes())
  {
    const double distance = search.labels().distance(node);
    m_distance[std::size_t(node) * m_nodes.size() + i] = distance;
    m_largest = (std::max)(m_largest, distance);
  }
}

// In the shortest-path tree of `root`, sums up how much the bounds are below the distances of the
// nodes of each subtree that has none of the landmarks so far. Returns a leaf of the subtree with
// the largest sum, behind the worst of its subtrees.
template <typename SurfaceGraph>
auto Landmarks<SurfaceGraph>::next_landmark(Search& search,
                                            const Node root,
                                            const std::size_t number) const -> Node
{
  search.run_from(root);
  std::vector<Node> order = search.reached_nodes();
  const auto& labels = search.labels();
  std::sort(order.begin(), order.end(), [&](const Node a, const Node b) {
    return std::make_pair(labels.distance(a), a) < std::make_pair(labels.distance(b), b);
  });
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::vector<double> sum(labels.number_of_nodes());
  std::vector<Node> worst_child(labels.number_of_nodes(), Search::null_node);
  for(std::size_t i = 0; i < number; ++i)
    sum[m_nodes[i]] = -internal::infinity;
  Node result = root;
  for(std::size_t i = order.size(); i-- > 0;)
  {
    const Node node = order[i], parent = labels.predecessor(node);
    sum[node] += labels.distance(node) - largest_difference(root, node, number);
    result = sum[node] > sum[result] ? node : result;
    if(parent == Search::null_node)
      continue;
    sum[parent] += sum[node];
    if(worst_child[parent] == Search::null_node || sum[node] > sum[worst_child[parent]])
      worst_child[parent] = node;
  }
  while(worst_child[result] != Search::null_node)
    result = worst_child[result];
  return result;
}

template <typename SurfaceGraph>
double Landmarks<SurfaceGraph>::largest_difference(const Node a,
                                                   const Node b,
                                                   const std::size_t number) const
{
  double result = 0;
  for(std::size_t i = 0; i < number; ++i)
  {
    const double difference = std::abs(distances(a)[i] - distances(b)[i]);
    result = result < difference ? difference : result; // which may be unknown
  }
  return result;
}

// Where a search from a landmark has not followed an arc, paths do not lead through the node that
// it starts from. If distances say that the way back along any other arc is longer than the graph
// does, nothing is known of ways back.
template <typename SurfaceGraph>
void Landmarks<SurfaceGraph>::check_arcs()
{
  const double ratio = 1 + m_graph->asymmetry();
  std::vector<bool> is_dead_end(m_graph->number_of_nodes()), has_long_way_back(is_dead_end);
  internal::for_each_arc(*m_graph, [&](const Node node, const Node target, const double length) {
    const double *const from = distances(node), *const to = distances(target);
    const double way = length + rounding(), way_back = ratio * length + rounding();
    bool is_followed = true, leads_back = true;
    for(std::size_t i = 0; i < m_nodes.size(); ++i)
    {
      is_followed &= !(from[i] + way < internal::infinity) | (to[i] <= from[i] + way);
      leads_back &= !(from[i] > to[i] + way_back);
    }
    if(!is_followed)
      is_dead_end[node] = true;
    if(!leads_back)
      has_long_way_back[target] = true;
  });
  set_apart(is_dead_end);
  for(const Node node : m_dead_ends)
    has_long_way_back[node] = false;
  if(std::find(has_long_way_back.begin(), has_long_way_back.end(), true) == has_long_way_back.end())
    m_part_of_way_back = 1 / ratio;
}

// Keeps the distances of dead ends for paths that end there. Bounds for paths from there would be
// those of another node.
template <typename SurfaceGraph>
void Landmarks<SurfaceGraph>::set_apart(const std::vector<bool>& is_dead_end)
{
  std::vector<std::size_t> row(is_dead_end.size());
  for(Node node = 0; node < is_dead_end.size(); ++node)
    if(is_dead_end[node])
    {
      row[node] = m_nearest.size();
      m_dead_ends.push_back(node);
      m_nearest.insert(m_nearest.end(), distances(node), distances(node) + m_nodes.size());
      std::fill_n(m_distance.data() + std::size_t(node) * m_nodes.size(), m_nodes.size(), unknown);
    }
  if(m_dead_ends.empty())
    return;
  m_farthest.assign(m_nearest.size(), -internal::infinity);
  internal::for_each_arc(*m_graph, [&](const Node node, const Node target, const double length) {
    if(!is_dead_end[target])
      return;
    const double way_back = (1 + m_graph->asymmetry()) * length;
    for(std::size_t i = 0; i < m_nodes.size(); ++i)
      if(const double distance = distances(node)[i] - way_back;
         distance > m_farthest[row[target] + i])
        m_farthest[row[target] + i] = distance;
  });
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_LANDMARKS_H
