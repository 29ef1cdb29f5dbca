// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ARCS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ARCS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Corner_nodes.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Point_row.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Rivals.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The arcs of a Steiner graph, which are computed from its nodes when they are asked for.
 */
class Steiner_arcs
{
  using Index = Intrinsic_triangulation::Index;
  using Node = Index;

public:
  Steiner_arcs(const Intrinsic_triangulation& triangulation, const Steiner_nodes& nodes)
    : m_triangulation(triangulation),
      m_nodes(nodes),
      m_points(nodes.points()),
      m_sectors(nodes.sectors()),
      m_corners(triangulation, nodes)
  {
  }

  // Calls `f(target, cost)` for the arcs that start from `node` and may be part of a cheapest path
  // that arrives there as `labels` says.
  template <typename Labels, typename F>
  void for_each(const Node node, const Labels& labels, F& f) const
  {
    if(m_nodes.is_point(node))
      expand_point(node, labels, f);
    else if(m_nodes.is_sector(node))
      expand_sector(node, f);
    else if(m_corners.is_divided(node))
      expand_divided_vertex(node, labels, f);
    else
      expand_vertex(node, f);
  }

private:
  using Row = Point_row;

  static constexpr Node null_node = Intrinsic_triangulation::null_index;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // From so many points on, it pays to search for those that are worth looking at.
  static constexpr Index LONG_ROW = 16;

  // ----- nodes and edges

  // The points of the edge of `h`, as seen from its source or its target.
  Row row(const Index h, const bool is_from_source) const
  {
    const Index e = m_points.edge(h), first = m_points.first_point(e);
    return Row(m_nodes.node_of_point(first), m_points.number_of_points(e),
               m_points.positions(first), m_triangulation.length(h),
               m_points.is_first(h) == is_from_source);
  }

  // Whether paths may enter the face to the left of `h`.
  bool is_open(const Index h) const { return m_triangulation.weight(h) < infinity; }

  // ----- arcs from vertices

  // A search can start at a divided vertex, and get there, but not go through it.
  template <typename Labels, typename F>
  void expand_divided_vertex(const Node v, const Labels& labels, F& f) const
  {
    if(labels.predecessor(v) == null_node)
      m_corners.for_each_sector(v, [&](const Node sector) { f(sector, 0.); });
  }

  template <typename F>
  void expand_sector(const Node node, F& f) const
  {
    const Index sector = m_nodes.sector(node);
    const Node v = m_sectors.vertex(sector);
    f(v, 0.);
    Index h = m_sectors.first_halfedge(sector);
    do
    {
      expand_corner(v, h, f);
      h = m_triangulation.counterclockwise(v, h);
    } while(!m_triangulation.is_border(h) && !m_triangulation.is_barrier(h));
    // of a barrier, the side that faces the sector
    expand_edge(m_triangulation.opposite(h), false, f);
  }

  template <typename F>
  void expand_vertex(const Node v, F& f) const
  {
    const Index beyond = m_triangulation.beyond_halfedge(v);
    for(Index h = m_triangulation.first_halfedge(v); h < beyond; ++h)
    {
      expand_corner(v, h, f);
      if(m_triangulation.is_barrier(h)) // both sides of which start here
        expand_edge(m_triangulation.opposite(h), false, f);
    }
  }

  // The arcs from the source `v` of `h` along it and across the face to its left.
  template <typename F>
  void expand_corner(const Node v, const Index h, F& f) const
  {
    expand_edge(h, true, f);
    if(!is_open(h))
      return;
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

  // The arc along the edge of `h`, or along its left side, from its source or target.
  template <typename F>
  void expand_edge(const Index h, const bool starts_at_source, F& f) const
  {
    const double weight = m_triangulation.weight_of_edge(h);
    if(weight == infinity)
      return;
    const Index e = m_points.edge(h);
    const Index first = m_points.first_point(e), beyond = m_points.beyond_point(e);
    const double length = m_triangulation.length(h);
    if(first == beyond)
      f(starts_at_source ? m_corners.at_target(h) : m_corners.at_source(h), weight * length);
    else if(starts_at_source == m_points.is_first(h))
      f(m_nodes.node_of_point(first), weight * (length * m_points.part_before(e, first)));
    else
      f(m_nodes.node_of_point(beyond - 1), weight * (length * m_points.part_behind(e, beyond - 1)));
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

  // ----- arcs from points on edges

  // A point on an edge, seen from the face to the left of a halfedge.
  struct Viewpoint
  {
    Viewpoint reversed(const Index opposite) const
    {
      return {opposite,      node,          from_target,    from_source,
              toward_target, toward_source, cost_to_target, cost_to_source};
    }

    Index halfedge;
    Node node;
    double from_source, from_target;       // distances
    Node toward_source, toward_target;     // neighbors
    double cost_to_source, cost_to_target; // of arcs to these
  };

  using Face = std::array<Index, 3>; // its halfedges

  // A path that comes along the edge goes on into both faces, any other one only into the face that
  // it does not come from.
  template <typename Labels, typename F>
  void expand_point(const Node node, const Labels& labels, F& f) const
  {
    const Index p = m_nodes.point(node), h = m_points.halfedge(p);
    const Index opposite = m_triangulation.opposite(h);
    const bool has_right = m_points.edge(opposite) == m_points.edge(h) && is_open(opposite);
    const Viewpoint left = viewpoint(p, h);
    if(left.cost_to_source < infinity)
    {
      f(left.toward_source, left.cost_to_source);
      f(left.toward_target, left.cost_to_target);
    }

    const Node origin = labels.predecessor(node);
    if(origin == left.toward_source || origin == left.toward_target || origin == null_node)
    {
      if(is_open(h))
        expand_face(left, m_triangulation.halfedges_of_face(h), labels, f);
      if(has_right)
        expand_face(left.reversed(opposite), m_triangulation.halfedges_of_face(opposite), labels,
                    f);
    }
    else if(has_right)
      expand_crossed_edge(left, origin, labels, f);
  }

  // The arcs from a viewpoint between two faces, one of which the path has crossed from `origin`
  // on.
  template <typename Labels, typename F>
  void
  expand_crossed_edge(const Viewpoint& left, const Node origin, const Labels& labels, F& f) const
  {
    const Face right_face =
        m_triangulation.halfedges_of_face(m_triangulation.opposite(left.halfedge));
    const bool comes_from_right = is_opposite(origin, right_face);
    if(comes_from_right && is_open(left.halfedge))
    {
      const Face left_face = m_triangulation.halfedges_of_face(left.halfedge);
      expand_face(left, left_face, labels, f);
      if(is_opposite(origin, left_face)) // two faces can have several edges in common
        expand_face(left.reversed(right_face[0]), right_face, labels, f);
    }
    else if(!comes_from_right)
      expand_face(left.reversed(right_face[0]), right_face, labels, f);
  }

  // The point `p`, whose edge has `h` as its first halfedge.
  Viewpoint viewpoint(const Index p, const Index h) const
  {
    const Index e = m_points.edge(h);
    const double length = m_triangulation.length(h), weight = m_triangulation.weight_of_edge(h);
    const double from_source = length * m_points.part_before(e, p);
    const double from_target = length * m_points.part_behind(e, p);
    const bool is_first = p == m_points.first_point(e), is_last = p + 1 == m_points.beyond_point(e);
    const Node node = m_nodes.node_of_point(p);
    return {h,
            node,
            from_source,
            from_target,
            is_first ? m_corners.at_source(h) : node - 1,
            is_last ? m_corners.at_target(h) : node + 1,
            weight * (is_first ? from_source : length * m_points.part_between(e, p - 1)),
            weight * (is_last ? from_target : length * m_points.part_between(e, p))};
  }

  // Whether a node is on one of the two edges of a face that are not the first, or where these
  // meet.
  bool is_opposite(const Node node, const Face& face) const
  {
    if(!m_nodes.is_point(node))
      return node == m_corners.at_corner(m_triangulation.target(face[1]), face[2]);
    const Index e = m_points.edge(m_points.halfedge(m_nodes.point(node)));
    return e == m_points.edge(face[1]) || e == m_points.edge(face[2]);
  }

  // The arcs across a face, whose first halfedge is that of the viewpoint.
  template <typename Labels, typename F>
  void expand_face(const Viewpoint& view, const Face& face, const Labels& labels, F& f) const
  {
    const double weight = m_triangulation.weight(view.halfedge);
    const double length = m_triangulation.length(view.halfedge);
    const Row at_target = row(face[1], true), at_source = row(face[2], false);

    const Corner corner =
        corner_of_face(m_triangulation, face[1], length, at_target.length(), at_source.length());
    f(m_corners.at_corner(m_triangulation.target(face[1]), face[2]),
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
  const Sectors& m_sectors;
  const Corner_nodes m_corners;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ARCS_H
