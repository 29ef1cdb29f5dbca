// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GAUGE_COSTS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GAUGE_COSTS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>
#include <CGAL/Geodesic_costs/internal/Face_gauges.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_nodes.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The costs of paths along edges per unit of length, in both directions: the smaller cost of the
 * two faces. A barrier counts as two edges, with one face each.
 */
class Edge_costs
{
public:
  Edge_costs() = default;

  // `Cost` is how faces are asked for costs: with or without the limit of the slope.
  using Cost = double (Face_gauges::*)(Index, Plane_vector) const;

  explicit Edge_costs(const Intrinsic_triangulation& triangulation,
                      const Cost cost = &Face_gauges::cost)
    : m_cost(triangulation.number_of_halfedges()),
      m_cost_back(triangulation.has_barriers() ? m_cost.size() : 0)
  {
    if(!triangulation.has_directional_costs())
      reject("the triangulation of a Directional_graph has no costs; they are given to its "
             "constructor, as face_weight_map(directional_cost(f))");
    for(Index h = 0; h < m_cost.size(); ++h)
    {
      const double there = in_face(triangulation, h, 1, cost);
      if(triangulation.is_barrier(h))
      {
        m_cost[h] = there;
        m_cost_back[h] = in_face(triangulation, h, -1, cost);
      }
      else
        m_cost[h] = (std::min)(there, in_face(triangulation, triangulation.opposite(h), -1, cost));
    }
  }

  // Returns the cost in the direction of `h`.
  double along(const Index h) const { return m_cost[h]; }

  // Returns the cost against the direction of `h`, on its left side.
  double against(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    return triangulation.is_barrier(h) ? m_cost_back[h] : m_cost[triangulation.opposite(h)];
  }

  std::size_t memory() const { return memory_of(m_cost, m_cost_back); }

private:
  // Returns the cost of the direction of `h`, or of the opposite one, in the face to its left.
  static double in_face(const Intrinsic_triangulation& triangulation,
                        const Index h,
                        const double sign,
                        const Cost cost)
  {
    if(triangulation.is_border(h))
      return infinity;
    const auto& gauges = triangulation.gauges();
    return (gauges.*cost)(gauges.face(h), sign * gauges.side(h));
  }

  std::vector<double> m_cost;      // per halfedge
  std::vector<double> m_cost_back; // likewise, if there are barriers
};

/*
 * Costs in a Steiner graph that depend on the direction: the gauges of faces for straight lines. A
 * line has the direction of the search. If distances are those to the sources, costs are those of
 * the opposite direction.
 */
class Gauge_costs : public Steiner_view
{
public:
  static constexpr bool are_symmetric = false;
  using Edges = Edge_costs;

  Gauge_costs(const Intrinsic_triangulation& triangulation,
              const Steiner_nodes& nodes,
              const Edges& edges,
              const bool is_backward)
    : Steiner_view(triangulation, nodes), m_edges(edges), m_is_backward(is_backward)
  {
  }

  static double unit(const Intrinsic_triangulation& triangulation)
  {
    return triangulation.gauges().unit();
  }

  // Returns whether any direction is free. Gauges with a formula have none.
  static bool are_some_free(const Intrinsic_triangulation& triangulation)
  {
    const auto& sectors = triangulation.gauges().all_sectors();
    return std::any_of(sectors.begin(), sectors.end(), [](const Face_gauges::Sector& s) {
      return s.is_finite() && !(dot(s.functional, s.direction) > 0);
    });
  }

  // Returns the cost per unit of length along `h`, or against its direction on its left side.
  double along(const Index h, const bool is_forward) const
  {
    return is_forward == m_is_backward ? m_edges.against(m_triangulation, h) : m_edges.along(h);
  }

  // ----- straight lines in the face to the left of `h`

  // Returns the positions of its corners, from the source of `h` on, in the frame of the gauge.
  std::array<Plane_vector, 3> corners(const Index h) const
  {
    const auto halfedges = m_triangulation.halfedges_of_face(h);
    const auto way = [&](const Index g) {
      return m_triangulation.length(g) * m_triangulation.gauges().side(g);
    };
    return {Plane_vector{0, 0}, way(halfedges[0]), -1 * way(halfedges[2])};
  }

  double across(const Index h, const Plane_vector step) const
  {
    const Face_gauges& gauges = m_triangulation.gauges();
    return gauges.cost(gauges.face(h), m_is_backward ? -1 * step : step);
  }

  double between(const Index h, const Face_point& p, const Face_point& q) const
  {
    const auto corners = this->corners(h);
    return across(h, q.seen_from(m_triangulation, h).position(corners) -
                         p.seen_from(m_triangulation, h).position(corners));
  }

  // ----- arcs across faces, for `f(target, cost)`

  // Enumerates the arcs from the source of `h` across the face to the left of `h`.
  template <typename F>
  void expand_corner(const Node /* source */, const Index h, F& f) const
  {
    const Row opposite = row(m_triangulation.next(h), true,
                             m_triangulation.length(h) * m_triangulation.gauges().side(h));
    visit(h, opposite, {0, opposite.size}, f);
  }

  // Enumerates the arcs from a viewpoint across a face, whose first halfedge is that of the
  // viewpoint.
  template <typename Labels, typename F>
  void expand_face(const Viewpoint& view, const Face& face, const Labels& labels, F& f) const
  {
    const Index h = view.halfedge;
    const Plane_vector side = m_triangulation.gauges().side(h);
    const Row at_target = row(face[1], true, view.from_target * side);
    const Row at_source = row(face[2], false, -view.from_source * side);
    const Plane_vector third = at_target.start + at_target.length * at_target.direction;
    offer(m_nodes.at_corner(m_triangulation.target(face[1]), face[2]), across(h, third), f);

    const Rival self{labels.distance(view.node), {0, 0}};
    const Rival source = neighbor(view, false, side, labels);
    const Rival target = neighbor(view, true, side, labels);
    visit(h, at_target, worthwhile(h, at_target, self, target, source), f);
    visit(h, at_source, worthwhile(h, at_source, self, source, target), f);
  }

  // Enumerates the arcs from a viewpoint back across a face that its path has crossed: none, as
  // narrow ones are not left out; but where the limit of the slope keeps a path from going straight
  // on, it may turn at the side.
  template <typename Labels, typename F>
  void expand_back(
      const Viewpoint& view, const Face& face, Node /* origin */, const Labels& labels, F& f) const
  {
    const Face_gauges& gauges = m_triangulation.gauges();
    if(gauges.is_limited(gauges.face(face[0])))
      expand_face(view, face, labels, f);
  }

private:
  // In rows of at least this size, a binary search finds the points that can get a smaller label.
  static constexpr Index LONG_ROW = 8;

  // The points of an edge, ranked from a corner of a face on. Their positions are relative to the
  // node where arcs start: `start` is that of the corner, and points follow in the given direction.
  struct Row
  {
    Index edge, first, size;
    bool starts_at_first_end;
    double length;
    Plane_vector start, direction;
  };

  // The label of a node where arcs start, and its position relative to another one.
  struct Rival
  {
    double label;
    Plane_vector offset;
  };

  // Returns the points of the edge of `h`, ranked from its source or its target.
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
      offer(m_nodes.node_of_point(p), across(h, step_to(row, p)), f);
    }
  }

  // Returns the neighbor of the viewpoint toward the target of its halfedge, or the source.
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

  // Returns the range of ranks of the points of a row that a node may reach at a lower cost than
  // its neighbors on the edge, one nearer to the corner where the row starts and one farther from
  // it. Straight arcs from two points of a side to two points of another need not cross: exchanging
  // their ends does not increase their costs, by the triangle inequality at the crossing. So the
  // points that a neighbor reaches at a lower cost are at its own end of the row. Where both costs
  // are infinite, the search may miss some of these points, which only enumerates more arcs. A face
  // where the slope is limited has no triangle inequality, so all its arcs are enumerated.
  // `Weighted_costs::worthwhile()` does the same for weights.
  std::pair<Index, Index> worthwhile(const Index h,
                                     const Row& row,
                                     const Rival& self,
                                     const Rival& nearer,
                                     const Rival& farther) const
  {
    const Face_gauges& gauges = m_triangulation.gauges();
    if(row.size < LONG_ROW || gauges.is_limited(gauges.face(h)))
      return {0, row.size};
    const Index first = search(h, row, self, nearer, 0, true);
    return {first, search(h, row, self, farther, first, false)};
  }

  // Returns the first rank from `low` on that the rival does not reach at a lower cost, if it is
  // the nearer one, or that it does.
  Index search(const Index h,
               const Row& row,
               const Rival& self,
               const Rival& rival,
               const Index low,
               const bool is_nearer) const
  {
    // If costs are the same up to rounding, the one with the smaller label wins, or neither.
    constexpr double tolerance = 1e-12;
    const double factor =
        rival.label < (1 - tolerance) * self.label ? 1 - tolerance : 1 + tolerance;
    using Rank = boost::counting_iterator<Index>;
    return *std::partition_point(Rank(low), Rank(row.size), [&](const Index rank) {
      const Plane_vector step = step_to(row, point(row, rank));
      const double cost = rival.label + across(h, step - rival.offset);
      return (factor * cost < self.label + across(h, step)) == is_nearer;
    });
  }

  const Edge_costs& m_edges;
  bool m_is_backward;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_GAUGE_COSTS_H
