// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_WEIGHTED_COSTS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_WEIGHTED_COSTS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Narrow_arcs.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Point_row.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Rivals.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_nodes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Costs in a Steiner graph: lengths times the weights of faces.
 */
class Weighted_costs : public Steiner_sides, public Line_weights
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
    : Steiner_sides(triangulation, nodes), Line_weights{triangulation}
  {
  }

  static double unit(const Intrinsic_triangulation& triangulation)
  {
    return triangulation.weight_unit();
  }

  // Returns whether any face is free.
  static bool are_some_free(const Intrinsic_triangulation& triangulation)
  {
    for(Index h = 0; triangulation.has_weights() && h < triangulation.number_of_halfedges(); ++h)
      if(triangulation.weight(h) == 0)
        return true;
    return false;
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

  // Enumerates the arcs from a viewpoint back across a face that its path has crossed from
  // `origin`: to those points of the third side that there are no arcs to from the origin, as these
  // would be narrow.
  template <typename Labels, typename F>
  void expand_back(
      const Viewpoint& view, const Face& face, const Node origin, const Labels& labels, F& f) const
  {
    if(!m_nodes.is_point(origin))
      return;
    const Index e = m_points.edge(m_points.halfedge(m_nodes.point(origin)));
    const bool is_at_source = e == m_points.edge(face[1]); // the third side is
    const Index side = face[is_at_source ? 1 : 2], third = face[is_at_source ? 2 : 1];
    if(!have_narrow_arcs(side, third))
      return;
    const double weight = m_triangulation.weight(face[0]);
    const Ranks of_origin = arcs_of_origin(face, origin, is_at_source);
    const Row row = this->row(third, !is_at_source, corner(face[is_at_source ? 0 : 1]), weight);
    const Ranks ranks = worthwhile(row, view, is_at_source, labels);
    const double x = is_at_source ? view.from_source : view.from_target;
    if(ranks.first < of_origin.first)
      visit(row, {ranks.first, (std::min)(ranks.beyond, of_origin.first)}, x, f);
    if(of_origin.beyond < ranks.beyond)
      visit(row, {(std::max)(ranks.first, of_origin.beyond), ranks.beyond}, x, f);
  }

private:
  // In rows of at least this size, a binary search finds the points that can get a smaller label.
  static constexpr Index LONG_ROW = 16;

  // Enumerates the arcs to points of a row, from the point at the distance `x` from its corner.
  template <typename F>
  void visit(const Row& row, const Ranks& ranks, const double x, F& f) const
  {
    row.for_each_block(ranks, x,
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
  Ranks worthwhile(const Row& row,
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
    const Reached_point& nearer = is_at_source ? at_source : at_target;
    const Reached_point& farther = is_at_source ? at_target : at_source;
    const Index next = m_triangulation.next(view.halfedge), last = m_triangulation.next(next);
    if(!have_narrow_arcs(view.halfedge, is_at_source ? last : next))
      return cell(row, point, nearer, farther);
    const Row side = this->row(view.halfedge, is_at_source, row.corner, row.weight);
    const Narrow_arcs narrow(corner(is_at_source ? view.halfedge : next),
                             m_nodes.tangent_of_narrow_arcs(), side, row);
    const Index rank = side.rank(view.node), first = narrow.first(rank);
    const Index beyond_of_nearer = narrow.beyond(rank - 1);
    const Index beyond = narrow.beyond(rank, rank > 0 ? beyond_of_nearer : 0);
    return cell(row, point, nearer, farther, {first, beyond}, beyond_of_nearer,
                narrow.first(rank + 1, first));
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

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_WEIGHTED_COSTS_H
