// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_WEIGHTED_COSTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_WEIGHTED_COSTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The points of an edge, which are nodes from `first_node` on, ranked by their distance from the
 * end that is at a corner of a face, which has this weight.
 */
struct Point_row
{
  Index first_node, size;
  const float* positions; // as in `Points_on_edges`, or null if points divide the edge equally
  double length;          // of the edge
  Index is_reversed;      // 0 if the corner is at the first end of the edge, and else 1
  Corner corner;
  double weight;

  double distance_from_corner(const Index rank) const
  {
    const Index i = is_reversed == 0 ? rank : size - 1 - rank;
    return positions == nullptr ? equal_parts()(i) : stored_positions()(i);
  }

  // Calls `f(node, costs, number)` for blocks of consecutive points, which have the ranks from
  // `first` to before `beyond`. Costs are those from the point on the other side of the corner, at
  // the distance `x` from the corner.
  template <typename F>
  void for_each_block(const Index first, const Index beyond, const double x, F f) const
  {
    const Index begin = first + is_reversed * (size - beyond - first);
    const Index end = begin + (beyond - first);
    if(positions == nullptr)
      measure(begin, end, x, equal_parts(), f);
    else
      measure(begin, end, x, stored_positions(), f);
  }

private:
  static constexpr Index SIZE_OF_BLOCK = 8;

  // Function objects for the distances of points from the corner, by their order on the edge.
  struct Equal_parts
  {
    double operator()(const Index i) const { return start + step * number(i); }

    double start, step;
  };

  struct Stored_positions
  {
    double operator()(const Index i) const
    {
      const double position = positions[i];
      return (position < 0 ? start_of_second_half : start) + step * position;
    }

    const float* positions;
    double start, start_of_second_half, step;
  };

  // Without branches, since the direction of an edge is unpredictable.
  Equal_parts equal_parts() const
  {
    const double part = length / number(size + 1);
    return {part * number(1 + is_reversed * (size - 1)), direction() * part};
  }

  Stored_positions stored_positions() const
  {
    return {positions, number(is_reversed) * length, number(1 - is_reversed) * length,
            direction() * length};
  }

  double direction() const { return number(1) - 2 * number(is_reversed); }

  // faster for signed integers
  static double number(const Index i) { return static_cast<double>(std::int32_t(i)); }

  template <typename Distance_from_corner, typename F>
  void measure(Index begin,
               const Index end,
               const double x,
               const Distance_from_corner& distance_from_corner,
               F& f) const
  {
    const Corner c = corner; // `f` cannot change these two
    const double w = weight;
    const auto cost = [&](const Index i) { return w * c.distance(x, distance_from_corner(i)); };
    std::array<double, SIZE_OF_BLOCK> costs;
    for(; end - begin >= SIZE_OF_BLOCK; begin += SIZE_OF_BLOCK)
    {
      for(Index i = 0; i < SIZE_OF_BLOCK; ++i) // in vector instructions
        costs[i] = cost(begin + i);
      f(first_node + begin, costs.data(), SIZE_OF_BLOCK);
    }
    for(Index i = 0; begin + i < end; ++i)
      costs[i] = cost(begin + i);
    f(first_node + begin, costs.data(), end - begin);
  }
};

// The label of a point, and its distance from a corner.
struct Reached_point
{
  double label;
  double distance_from_corner;
};

/*
 * Two points on one side of a corner, whose paths compete for the points on its other side.
 *
 * Straight arcs from two points of a side to two points of the other need not cross: exchanging
 * their ends does not make them longer. So the points that one of the two reaches at a lower cost
 * are at its own end of the row, and a binary search finds the last of them.
 *
 * Sums of large labels and short arcs lose digits by rounding. So the difference of two arcs is
 * compared with that of two labels. Both have small relative errors, as
 *   d^2 - d'^2 = (x - x') (x + x' - 2 y cos(angle)).
 * All is divided by the weight, which may be zero.
 */
class Rivals
{
public:
  Rivals(const Reached_point& nearer, const Reached_point& farther, const Point_row& row)
    : m_row(row), m_nearer(nearer.distance_from_corner), m_farther(farther.distance_from_corner)
  {
    const double gap = m_farther - m_nearer;
    if(nearer.label != farther.label)
      m_head_start = divided(farther.label - nearer.label, row.weight);
    else if(gap == 0)
      m_head_start = (std::numeric_limits<double>::min)(); // ties go to the nearer one
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    const double label = divided((std::min)(nearer.label, farther.label), row.weight);
    m_doubt = (std::min)(SMALLEST_DIFFERENCE * gap, rounding * (label + m_farther + row.length));
  }

  // Returns the number of points that the nearer one certainly reaches at a lower cost.
  Index end_of_nearer() const
  {
    return search([this](const double y) { return lead_of_nearer(y, -m_doubt) > 0; });
  }

  // Returns the rank of the first point that the farther one certainly reaches at a lower cost.
  Index start_of_farther() const
  {
    return search([this](const double y) { return !(lead_of_nearer(y, m_doubt) < 0); });
  }

private:
  // Sums that are rounded to the same number are not pruned, so that costs are those with all arcs,
  // to the last bit, unless labels are so large that rounding cancels all arcs of a face.
  static constexpr double SMALLEST_DIFFERENCE = 1e-3;

  // In a face of weight zero, any difference of two labels decides.
  static double divided(const double label, const double weight)
  {
    return weight > 0 ? label / weight : std::copysign(infinity, label);
  }

  // Returns by how much the nearer one is better for the point at the distance `y` from the corner,
  // times a positive number.
  double lead_of_nearer(const double y, const double allowance) const
  {
    const Corner& corner = m_row.corner;
    const double sum = corner.distance(m_nearer, y) + corner.distance(m_farther, y);
    return (m_head_start + allowance) * sum +
           (m_farther - m_nearer) * (m_farther + m_nearer - (2 - corner.opening()) * y);
  }

  // Returns the first rank for which `f` is false.
  template <typename F>
  Index search(const F& f) const
  {
    using Rank = boost::counting_iterator<Index>;
    return *std::partition_point(Rank(0), Rank(m_row.size), [&](const Index rank) {
      return f(m_row.distance_from_corner(rank));
    });
  }

  const Point_row& m_row;
  double m_nearer, m_farther; // distances from the corner
  double m_head_start = 0;    // of the nearer one
  double m_doubt;
};

/*
 * Returns the range of ranks of the points that `point` may reach at a lower cost than two other
 * points on the same side of the corner, one nearer to it and one farther from it.
 */
inline std::pair<Index, Index> cell(const Point_row& row,
                                    const Reached_point& point,
                                    const Reached_point& nearer,
                                    const Reached_point& farther)
{
  const auto first = Rivals(nearer, point, row).end_of_nearer();
  return {first, (std::max)(first, Rivals(point, farther, row).start_of_farther())};
}

/*
 * Costs in a Steiner graph: lengths times the weights of faces.
 */
class Weighted_costs : public Steiner_view, public Line_weights
{
  using Row = Point_row;

public:
  // whether opposite directions have the same cost
  static constexpr bool are_symmetric = true;

  // Weights of edges are not stored.
  struct Edges
  {
    explicit Edges(const Intrinsic_triangulation& triangulation)
    {
      reject_directional_costs(triangulation, "Steiner_graph");
    }
    static std::size_t memory() { return 0; }
  };

  Weighted_costs(const Intrinsic_triangulation& triangulation,
                 const Steiner_nodes& nodes,
                 const Edges& /* edges */,
                 const bool /* is_backward */)
    : Steiner_view(triangulation, nodes), Line_weights{triangulation}
  {
  }

  static double unit(const Intrinsic_triangulation& triangulation)
  {
    return triangulation.weight_unit();
  }

  // ----- straight lines in the face to the left of `h`

  // Returns the positions of its corners, from the source of `h` on.
  std::array<Plane_vector, 3> corners(const Index h) const
  {
    const Face_layout layout(m_triangulation, h);
    return {layout.corner(0), layout.corner(1), layout.corner(2)};
  }

  double across(const Index h, const Plane_vector step) const
  {
    return m_triangulation.weight(h) * length(step);
  }

  // ----- arcs across faces, for `f(target, cost)`

  // Enumerates the arcs from `v`, the source of `h`, across the face to the left of `h`.
  template <typename F>
  void expand_corner(const Node v, const Index h, F& f) const
  {
    const Index next = m_triangulation.next(h);
    if(m_points.number_of_points(m_points.edge(next)) == 0)
      return;
    const double x = m_triangulation.length(h);
    const double third = m_triangulation.length(m_triangulation.counterclockwise(v, h));
    const Corner at_target =
        corner_of_face(m_triangulation, next, x, m_triangulation.length(next), third);
    const Row opposite = row(next, true, at_target, m_triangulation.weight(h));
    visit(opposite, {0, opposite.size}, x, f);
  }

  // Enumerates the arcs from a viewpoint across a face, whose first halfedge is that of the
  // viewpoint.
  template <typename Labels, typename F>
  void expand_face(const Viewpoint& view, const Face& face, const Labels& labels, F& f) const
  {
    const double weight = m_triangulation.weight(view.halfedge);
    const double length = m_triangulation.length(view.halfedge);
    const double left = m_triangulation.length(face[2]), right = m_triangulation.length(face[1]);
    const auto expand = [&](const Row& row, const bool is_at_source) {
      visit(row, worthwhile(row, view, is_at_source, labels),
            is_at_source ? view.from_source : view.from_target, f);
    };
    const Corner at_target = corner_of_face(m_triangulation, face[1], length, right, left);
    f(m_nodes.at_corner(m_triangulation.target(face[1]), face[2]),
      weight * at_target.distance(view.from_target, right));
    if(m_points.number_of_points(m_points.edge(face[1])) > 0)
      expand(row(face[1], true, at_target, weight), false);
    if(m_points.number_of_points(m_points.edge(face[2])) > 0)
      expand(row(face[2], false, corner_of_face(m_triangulation, face[0], length, left, right),
                 weight),
             true);
  }

private:
  // In rows of at least this size, a binary search finds the points that can get a smaller label.
  static constexpr Index LONG_ROW = 16;

  // Returns the points of the edge of `h`, ranked from its source or its target.
  Row row(const Index h, const bool is_from_source, const Corner& corner, const double weight) const
  {
    const Index e = m_points.edge(h), first = m_points.first_point(e);
    return {m_nodes.node_of_point(first),
            m_points.number_of_points(e),
            m_points.positions(first),
            m_triangulation.length(h),
            m_points.is_first(h) == is_from_source ? Index(0) : Index(1),
            corner,
            weight};
  }

  // Enumerates the arcs to points of a row, from the point at the distance `x` from its corner.
  template <typename F>
  void visit(const Row& row, const std::pair<Index, Index> ranks, const double x, F& f) const
  {
    row.for_each_block(ranks.first, ranks.second, x,
                       [&f](const Node first, const double* const costs, const Index number) {
                         if constexpr(std::is_invocable_v<F, Node, const double*, std::size_t>)
                           f(first, costs, std::size_t(number));
                         else
                           for(Index i = 0; i < number; ++i)
                             f(first + i, costs[i]);
                       });
  }

  // Returns the range of ranks of the points of a row that a viewpoint may reach at a lower cost
  // than its neighbors. The row starts from the corner at the source or target of its halfedge.
  // `Gauge_costs::worthwhile()` does the same for gauges.
  template <typename Labels>
  std::pair<Index, Index> worthwhile(const Row& row,
                                     const Viewpoint& view,
                                     const bool is_at_source,
                                     const Labels& labels) const
  {
    if(row.size < LONG_ROW)
      return {0, row.size};
    const double label = labels.distance(view.node);
    // a neighbor, whose label the arc from here may lower
    const auto rival = [&](const Node node, const double cost, const double distance_if_end) {
      return Reached_point{(std::min)(labels.distance(node), label + cost),
                           m_nodes.is_point(node)
                               ? distance_from_end(view.halfedge, node, is_at_source)
                               : distance_if_end};
    };
    const double length = m_triangulation.length(view.halfedge);
    const Reached_point point{label, is_at_source ? view.from_source : view.from_target};
    const Reached_point at_source =
        rival(view.toward_source, view.cost_to_source, is_at_source ? 0 : length);
    const Reached_point at_target =
        rival(view.toward_target, view.cost_to_target, is_at_source ? length : 0);
    return is_at_source ? cell(row, point, at_source, at_target)
                        : cell(row, point, at_target, at_source);
  }

  // Returns the distance of a point on the edge of `h` from the source or the target of `h`.
  double distance_from_end(const Index h, const Node node, const bool is_from_source) const
  {
    const Index p = m_nodes.point(node), e = m_points.edge(h);
    const bool is_from_first_end = m_points.is_first(h) == is_from_source;
    return m_triangulation.length(h) *
           (is_from_first_end ? m_points.part_before(e, p) : m_points.part_behind(e, p));
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_WEIGHTED_COSTS_H
