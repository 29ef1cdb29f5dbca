// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_DIRECTIONAL_ARCS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_DIRECTIONAL_ARCS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Directional/Travel_costs.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Corner_nodes.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The arcs of a graph with directional costs, which are computed from its nodes when they are asked
 * for. They have the ends that those of a Steiner graph have.
 */
class Directional_arcs
{
  using Index = Intrinsic_triangulation::Index;
  using Node = Index;

public:
  Directional_arcs(const Intrinsic_triangulation& triangulation,
                   const Steiner_nodes& nodes,
                   const Travel_costs& costs)
    : m_triangulation(triangulation),
      m_nodes(nodes),
      m_points(nodes.points()),
      m_corners(triangulation, nodes),
      m_costs(costs)
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
    else if(!m_corners.is_divided(node))
      expand_vertex(node, f);
    else if(labels.predecessor(node) == null_node) // a path may start there, but not go through
      m_corners.for_each_sector(node, [&](const Node sector) { f(sector, 0.); });
  }

private:
  static constexpr Node null_node = Intrinsic_triangulation::null_index;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // From so many points on, it pays to search for those that are worth looking at.
  static constexpr Index LONG_ROW = 8;

  // The points of an edge, ranked from the corner of a face on, with their places relative to where
  // arcs start: `start` is the place of the corner, and points are in the given direction.
  struct Row
  {
    Index edge, first, size;
    bool starts_at_first_end;
    double length;
    Plane_vector start, direction;
  };

  // A node that arcs start from, its label, and its place relative to another one.
  struct Rival
  {
    double label;
    Plane_vector offset;
  };

  // ----- rows

  // The points of the edge of `h`, which is a side of a face, from its source or its target on.
  Row row(const Index h, const bool is_from_source, const Plane_vector start) const
  {
    const Index e = m_points.edge(h);
    const Plane_vector side = m_triangulation.gauges().side(h);
    return {e,
            m_points.first_point(e),
            m_points.number_of_points(e),
            m_points.is_first(h) == is_from_source,
            m_triangulation.length(h),
            start,
            is_from_source ? side : -1 * side};
  }

  Index point(const Row& row, const Index rank) const
  {
    return row.first + (row.starts_at_first_end ? rank : row.size - 1 - rank);
  }

  Plane_vector step_to(const Row& row, const Index p) const
  {
    const double part = row.starts_at_first_end ? m_points.part_before(row.edge, p)
                                                : m_points.part_behind(row.edge, p);
    return row.start + (part * row.length) * row.direction;
  }

  template <typename F>
  void visit(const Index h, const Row& row, const std::pair<Index, Index> ranks, F& f) const
  {
    for(Index rank = ranks.first; rank < ranks.second; ++rank)
    {
      const Index p = point(row, rank);
      offer(m_nodes.node_of_point(p), m_costs.across(h, step_to(row, p)), f);
    }
  }

  template <typename F>
  static void offer(const Node node, const double cost, F& f)
  {
    if(cost < infinity)
      f(node, cost);
  }

  // ----- arcs from vertices

  template <typename F>
  void expand_sector(const Node node, F& f) const
  {
    const Index sector = m_nodes.sector(node);
    const Node v = m_nodes.sectors().vertex(sector);
    f(v, 0.);
    Index h = m_nodes.sectors().first_halfedge(sector);
    do
    {
      expand_corner(h, f);
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
      expand_corner(h, f);
      if(m_triangulation.is_barrier(h)) // both sides of which start here
        expand_edge(m_triangulation.opposite(h), false, f);
    }
  }

  // The arcs from the source of `h` along it and across the face to its left.
  template <typename F>
  void expand_corner(const Index h, F& f) const
  {
    expand_edge(h, true, f);
    if(m_triangulation.is_border(h))
      return;
    const Row opposite = row(m_triangulation.next(h), true,
                             m_triangulation.length(h) * m_triangulation.gauges().side(h));
    visit(h, opposite, {0, opposite.size}, f);
  }

  // The arc along the edge of `h`, or along its left side, from its source or target.
  template <typename F>
  void expand_edge(const Index h, const bool starts_at_source, F& f) const
  {
    const Index e = m_points.edge(h), first = m_points.first_point(e);
    const Index beyond = m_points.beyond_point(e);
    const double cost = starts_at_source ? m_costs.along(h) : m_costs.against(h);
    const double length = m_triangulation.length(h);
    if(first == beyond)
      offer_along(starts_at_source ? m_corners.at_target(h) : m_corners.at_source(h), cost, length,
                  f);
    else if(starts_at_source == m_points.is_first(h))
      offer_along(m_nodes.node_of_point(first), cost, length * m_points.part_before(e, first), f);
    else
      offer_along(m_nodes.node_of_point(beyond - 1), cost,
                  length * m_points.part_behind(e, beyond - 1), f);
  }

  template <typename F>
  static void offer_along(const Node node, const double cost, const double length, F& f)
  {
    if(cost < infinity)
      f(node, cost * length);
  }

  // ----- arcs from points on edges

  using Face = std::array<Index, 3>; // its halfedges

  // A point on an edge, seen from the face to the left of a halfedge.
  struct Viewpoint
  {
    Viewpoint reversed(const Index opposite) const
    {
      return {opposite, node, from_target, from_source, toward_target, toward_source};
    }

    Index halfedge;
    Node node;
    double from_source, from_target;   // distances
    Node toward_source, toward_target; // neighbors
  };

  // A path that has come across a face does not go back into it, as a straight line is not dearer.
  template <typename Labels, typename F>
  void expand_point(const Node node, const Labels& labels, F& f) const
  {
    const Index p = m_nodes.point(node), h = m_points.halfedge(p);
    const Viewpoint left = viewpoint(p, h);
    expand_along_edge(left, p, f);

    const Node origin = labels.predecessor(node);
    const Index opposite = m_triangulation.opposite(h);
    const bool has_right =
        m_points.edge(opposite) == m_points.edge(h) && !m_triangulation.is_border(opposite);
    const bool comes_along =
        origin == left.toward_source || origin == left.toward_target || origin == null_node;
    const bool comes_from_left = !comes_along && has_across(origin, h);
    const bool comes_from_right = !comes_along && has_right && has_across(origin, opposite);
    const bool is_certain = comes_from_left != comes_from_right; // faces can have two common edges
    if(!m_triangulation.is_border(h) && !(is_certain && comes_from_left))
      expand_face(left, labels, f);
    if(has_right && !(is_certain && comes_from_right))
      expand_face(left.reversed(opposite), labels, f);
  }

  // The point `p`, whose edge has `h` as its first halfedge.
  Viewpoint viewpoint(const Index p, const Index h) const
  {
    const Index e = m_points.edge(h);
    const double length = m_triangulation.length(h);
    const Node node = m_nodes.node_of_point(p);
    return {h,
            node,
            length * m_points.part_before(e, p),
            length * m_points.part_behind(e, p),
            p == m_points.first_point(e) ? m_corners.at_source(h) : node - 1,
            p + 1 == m_points.beyond_point(e) ? m_corners.at_target(h) : node + 1};
  }

  template <typename F>
  void expand_along_edge(const Viewpoint& view, const Index p, F& f) const
  {
    const Index h = view.halfedge, e = m_points.edge(h);
    const double length = m_triangulation.length(h);
    offer_along(view.toward_source, m_costs.against(h),
                p == m_points.first_point(e) ? view.from_source
                                             : length * m_points.part_between(e, p - 1),
                f);
    offer_along(view.toward_target, m_costs.along(h),
                p + 1 == m_points.beyond_point(e) ? view.from_target
                                                  : length * m_points.part_between(e, p),
                f);
  }

  // Whether a node is on one of the other two edges of the face to the left of `h`, if there is
  // one, or where these meet.
  bool has_across(const Node node, const Index h) const
  {
    if(m_triangulation.is_border(h))
      return false;
    const Face face = m_triangulation.halfedges_of_face(h);
    if(!m_nodes.is_point(node))
      return node == m_corners.at_corner(m_triangulation.target(face[1]), face[2]);
    const Index e = m_points.edge(m_points.halfedge(m_nodes.point(node)));
    return e == m_points.edge(face[1]) || e == m_points.edge(face[2]);
  }

  // The arcs across the face to the left of the viewpoint's halfedge.
  template <typename Labels, typename F>
  void expand_face(const Viewpoint& view, const Labels& labels, F& f) const
  {
    const Face_gauges& gauges = m_triangulation.gauges();
    const Index h = view.halfedge;
    const Face face = m_triangulation.halfedges_of_face(h);
    if(gauges.is_forbidden(gauges.face(h)))
      return;
    const Plane_vector side = gauges.side(h);
    const Row at_target = row(face[1], true, view.from_target * side);
    const Row at_source = row(face[2], false, -view.from_source * side);
    const Plane_vector third = at_target.start + at_target.length * at_target.direction;
    offer(m_corners.at_corner(m_triangulation.target(face[1]), face[2]), m_costs.across(h, third),
          f);

    const Rival self{labels.distance(view.node), {0, 0}};
    const Rival source = neighbor(view, false, side, labels);
    const Rival target = neighbor(view, true, side, labels);
    visit(h, at_target, worthwhile(h, at_target, self, target, source), f);
    visit(h, at_source, worthwhile(h, at_source, self, source, target), f);
  }

  // The neighbor on the edge of the viewpoint toward the target of its halfedge, or the source.
  template <typename Labels>
  Rival neighbor(const Viewpoint& view,
                 const bool is_toward_target,
                 const Plane_vector side,
                 const Labels& labels) const
  {
    const Node node = is_toward_target ? view.toward_target : view.toward_source;
    double distance = is_toward_target ? view.from_target : view.from_source;
    if(m_nodes.is_point(node))
    {
      const Index e = m_points.edge(view.halfedge);
      const Index p = m_nodes.point(node), q = m_nodes.point(view.node);
      distance = m_triangulation.length(view.halfedge) * m_points.part_between(e, p < q ? p : q);
    }
    return {labels.distance(node), (is_toward_target ? distance : -distance) * side};
  }

  // The ranks of the points of a row that a path over a node may be the cheapest one to, given its
  // neighbors on the edge, of which one is nearer to the corner that the row starts from: as a
  // first one and one beyond. Straight arcs from two points of a side to two points of another need
  // not cross, as exchanging their ends does not make them dearer, by the triangle inequality at
  // the crossing. So what a neighbor reaches at less cost lies at its own end of the row. Where
  // both costs are infinite the search may miss some of that, which does no harm.
  std::pair<Index, Index> worthwhile(const Index h,
                                     const Row& row,
                                     const Rival& self,
                                     const Rival& nearer,
                                     const Rival& farther) const
  {
    if(row.size < LONG_ROW)
      return {0, row.size};
    const Index first = search(h, row, self, nearer, 0, true);
    return {first, search(h, row, self, farther, first, false)};
  }

  // The first rank from `low` on that the rival does not reach at less cost, or that it does.
  Index search(const Index h,
               const Row& row,
               const Rival& self,
               const Rival& rival,
               const Index low,
               const bool is_nearer) const
  {
    // If costs are the same but for rounding, the one with the smaller label wins, or neither.
    constexpr double tolerance = 1e-12;
    const double factor =
        rival.label < (1 - tolerance) * self.label ? 1 - tolerance : 1 + tolerance;
    using Rank = boost::counting_iterator<Index>;
    return *std::partition_point(Rank(low), Rank(row.size), [&](const Index rank) {
      const Plane_vector step = step_to(row, point(row, rank));
      const double cost = rival.label + m_costs.across(h, step - rival.offset);
      return (factor * cost < self.label + m_costs.across(h, step)) == is_nearer;
    });
  }

  const Intrinsic_triangulation& m_triangulation;
  const Steiner_nodes& m_nodes;
  const Points_on_edges& m_points;
  const Corner_nodes m_corners;
  const Travel_costs m_costs;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_DIRECTIONAL_ARCS_H
