// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_WEIGHTED_COSTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_WEIGHTED_COSTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Point_row.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Rivals.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_layout.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Costs in a Steiner graph: lengths times the weights of faces.
 */
class Weighted_costs
{
  using Index = Intrinsic_triangulation::Index;
  using Node = Steiner_nodes::Node;
  using Row = Point_row;
  using Face = Viewpoint::Face;

public:
  // Whether going back costs as much as going there.
  static constexpr bool are_symmetric = true;

  Weighted_costs(const Intrinsic_triangulation& triangulation, const Steiner_nodes& nodes)
    : m_triangulation(triangulation), m_nodes(nodes), m_points(nodes.points())
  {
  }

  // Whether paths may enter the face to the left of `h`.
  bool is_open(const Index h) const
  {
    return m_triangulation.weight(h) < std::numeric_limits<double>::infinity();
  }

  // Along `h`, or against it on its left side, per unit of length.
  double along(const Index h, const bool /* is_forward */) const
  {
    return m_triangulation.weight_of_edge(h);
  }

  // ----- straight lines in the face to the left of `h`

  // Where its corners are, from the source of `h` on, in a frame for vectors.
  std::array<Plane_vector, 3> corners(const Index h) const
  {
    const Face_layout layout(m_triangulation, h);
    return {layout.corner(0), layout.corner(1), layout.corner(2)};
  }

  double across(const Index h, const Plane_vector step) const
  {
    return m_triangulation.weight(h) * length(step);
  }

  double between(const Index h, const Face_point& p, const Face_point& q) const
  {
    return m_triangulation.weight(h) * distance(m_triangulation, p, q);
  }

  // ----- arcs across faces, for `f(target, cost)`

  // From `v`, the source of `h`, across the face to the left of `h`.
  template <typename F>
  void expand_corner(const Node v, const Index h, F& f) const
  {
    const Index next = m_triangulation.next(h);
    const Row opposite = row(next, true);
    if(opposite.size() == 0)
      return;
    const double x = m_triangulation.length(h);
    const double third = m_triangulation.length(m_triangulation.counterclockwise(v, h));
    // at the target of `h`
    const Corner corner = corner_of_face(m_triangulation, next, x, opposite.length(), third);
    visit(opposite, {0, opposite.size()}, corner, x, m_triangulation.weight(h), f);
  }

  // From a viewpoint across a face, whose first halfedge is that of the viewpoint.
  template <typename Labels, typename F>
  void expand_face(const Viewpoint& view, const Face& face, const Labels& labels, F& f) const
  {
    const double weight = m_triangulation.weight(view.halfedge);
    const double length = m_triangulation.length(view.halfedge);
    const Row at_target = row(face[1], true), at_source = row(face[2], false);

    const Corner corner =
        corner_of_face(m_triangulation, face[1], length, at_target.length(), at_source.length());
    f(m_nodes.at_corner(m_triangulation.target(face[1]), face[2]),
      weight * corner.distance(view.from_target, at_target.length()));
    if(at_target.size() > 0)
      visit(at_target, worthwhile(at_target, corner, weight, view, false, labels), corner,
            view.from_target, weight, f);
    if(at_source.size() > 0)
    {
      const Corner other_corner =
          corner_of_face(m_triangulation, face[0], length, at_source.length(), at_target.length());
      visit(at_source, worthwhile(at_source, other_corner, weight, view, true, labels),
            other_corner, view.from_source, weight, f);
    }
  }

private:
  // Rows of at least this size are searched for the points that can get a smaller label.
  static constexpr Index LONG_ROW = 16;

  // The points of the edge of `h`, as seen from its source or its target.
  Row row(const Index h, const bool is_from_source) const
  {
    const Index e = m_points.edge(h), first = m_points.first_point(e);
    return Row(m_nodes.node_of_point(first), m_points.number_of_points(e),
               m_points.positions(first), m_triangulation.length(h),
               m_points.is_first(h) == is_from_source);
  }

  // The arcs to points of a row, from the point at the distance `x` from its corner.
  template <typename F>
  void visit(const Row& row,
             const std::pair<Index, Index> ranks,
             const Corner& corner,
             const double x,
             const double weight,
             F& f) const
  {
    row.for_each_block(ranks.first, ranks.second, corner, x, weight,
                       [&f](const Node first, const double* const costs, const Index number) {
                         if constexpr(std::is_invocable_v<F, Node, const double*, std::size_t>)
                           f(first, costs, std::size_t(number));
                         else
                           for(Index i = 0; i < number; ++i)
                             f(first + i, costs[i]);
                       });
  }

  // The ranks of the points of a row that a path over a viewpoint may be the cheapest one to, given
  // its neighbors. The row starts from the corner at the source or target of its halfedge.
  template <typename Labels>
  std::pair<Index, Index> worthwhile(const Row& row,
                                     const Corner& corner,
                                     const double weight,
                                     const Viewpoint& view,
                                     const bool is_at_source,
                                     const Labels& labels) const
  {
    if(row.size() < LONG_ROW)
      return {0, row.size()};
    const double label = labels.distance(view.node);
    // a neighbor, which is reached from here in any case
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
    return is_at_source ? cell(row, corner, weight, point, at_source, at_target)
                        : cell(row, corner, weight, point, at_target, at_source);
  }

  // The distance of a point on the edge of `h` from the source or the target of `h`.
  double distance_from_end(const Index h, const Node node, const bool is_from_source) const
  {
    const Index p = m_nodes.point(node), e = m_points.edge(h);
    const bool is_from_first_end = m_points.is_first(h) == is_from_source;
    return m_triangulation.length(h) *
           (is_from_first_end ? m_points.part_before(e, p) : m_points.part_behind(e, p));
  }

  const Intrinsic_triangulation& m_triangulation;
  const Steiner_nodes& m_nodes;
  const Points_on_edges& m_points;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_WEIGHTED_COSTS_H
