// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_STEINER_NODES_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_STEINER_NODES_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Geodesic_costs/internal/Steiner/limit_of_points.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The points that a placement puts on the edges of a triangulation, numbered from 0. Those of an
 * edge have consecutive numbers, from the source of one of its halfedges, called the first one, to
 * its target.
 *
 * A barrier counts as two edges, one for each side, with points of their own, in the same places.
 * Therefore edges have numbers that are private to this class.
 *
 * A position is a part of the edge, measured from the nearer end, so that points very close to an
 * end can be told apart: from 0 to 1/2, it is the part between the first end and the point; below
 * 0, minus the part between the point and the second end. Positions of equal parts are not stored.
 */
class Points_on_edges
{
public:
  Points_on_edges() = default;

  // Throws std::length_error if there are more points than `limit`, or than `largest_number`, so
  // that a graph would have more than 2^32 - 1 nodes. Points are counted before memory is
  // allocated.
  template <typename Placement>
  Points_on_edges(const Intrinsic_triangulation& triangulation,
                  const Placement& placement,
                  const std::size_t limit,
                  const std::size_t largest_number)
  {
    number_edges(triangulation);
    count_points(triangulation, placement, limit, largest_number);
    m_halfedge.resize(number_of_points());
    for_each_first_halfedge([&](const Index h, const Index e) {
      std::fill(m_halfedge.begin() + first_point(e), m_halfedge.begin() + beyond_point(e), h);
    });
    if constexpr(!Placement::makes_equal_parts)
    {
      m_position.resize(number_of_points());
      for_each_first_halfedge([&](const Index h, const Index e) {
        if(is_second_side(triangulation, h))
          copy_positions(triangulation.opposite(h), e);
        else if(number_of_points(e) > 0)
          placement.place(triangulation, h, m_position.data() + first_point(e),
                          number_of_points(e));
      });
    }
  }

  // ----- edges

  // Returns the edge of a halfedge; of a barrier, the one on the left side of `h`.
  Index edge(const Index h) const { return m_edge[h] / 2; }

  // Returns whether `h` is the first halfedge of its edge. It is not at the border, unless both
  // are.
  bool is_first(const Index h) const { return m_edge[h] % 2 == 0; }

  // Calls `f(h, e)` for every edge `e` and its first halfedge `h`.
  template <typename F>
  void for_each_first_halfedge(F f) const
  {
    for(Index h = 0; h < m_edge.size(); ++h)
      if(is_first(h))
        f(h, edge(h));
  }

  // ----- points

  Index number_of_points() const { return m_first_point.back(); }
  Index first_point(const Index e) const { return m_first_point[e]; }
  Index beyond_point(const Index e) const { return m_first_point[e + 1]; }
  Index number_of_points(const Index e) const { return beyond_point(e) - first_point(e); }

  // Returns the first halfedge of the edge of a point.
  Index halfedge(const Index p) const { return m_halfedge[p]; }

  // Returns the point in the place of `p` on the other side of a barrier, of which `h` is the first
  // halfedge on this side.
  Index twin(const Intrinsic_triangulation& triangulation, const Index h, const Index p) const
  {
    return beyond_point(edge(triangulation.opposite(h))) - 1 - (p - first_point(edge(h)));
  }

  // Return the part of the edge `e` between its first end and its point `p`, and the rest of it.
  double part_before(const Index e, const Index p) const
  {
    if(m_position.empty())
      return double(p - first_point(e) + 1) / double(number_of_points(e) + 1);
    return m_position[p] < 0 ? 1 + double(m_position[p]) : double(m_position[p]);
  }
  double part_behind(const Index e, const Index p) const
  {
    if(m_position.empty())
      return double(beyond_point(e) - p) / double(number_of_points(e) + 1);
    return m_position[p] < 0 ? -double(m_position[p]) : 1 - double(m_position[p]);
  }

  // Returns the part of the edge `e` between its point `p` and the next one.
  double part_between(const Index e, const Index p) const
  {
    if(m_position.empty())
      return 1 / double(number_of_points(e) + 1);
    const double difference = double(m_position[p + 1]) - double(m_position[p]);
    return m_position[p] >= 0 && m_position[p + 1] < 0 ? 1 + difference : difference;
  }

  // Returns the positions from that of `p` on, or a null pointer if they are not stored.
  const float* positions(const Index p) const
  {
    return m_position.empty() ? nullptr : m_position.data() + p;
  }

  void prefetch(const Index p) const
  {
    internal::prefetch(m_halfedge.data(), p);
    if(!m_position.empty())
      internal::prefetch(m_position.data(), p);
  }

  std::size_t memory() const { return memory_of(m_edge, m_first_point, m_halfedge, m_position); }

private:
  void number_edges(const Intrinsic_triangulation& triangulation)
  {
    m_edge.assign(triangulation.number_of_halfedges(), null_index);
    Index number = 0;
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    {
      const Index opposite = triangulation.opposite(h);
      const bool comes_second = m_edge[h] != null_index;
      if(comes_second || (triangulation.is_border(h) && !triangulation.is_border(opposite)))
        continue;
      m_edge[h] = 2 * number;
      if(!triangulation.is_barrier(h))
        m_edge[opposite] = 2 * number + 1;
      ++number;
    }
    m_first_point.assign(number + std::size_t(1), 0);
  }

  template <typename Placement>
  void count_points(const Intrinsic_triangulation& triangulation,
                    const Placement& placement,
                    const std::size_t limit,
                    const std::size_t largest_number)
  {
    double number = 0;
    Index halfedge_with_most = 0;
    std::size_t most = 0;
    for_each_first_halfedge([&](const Index h, const Index e) {
      const std::size_t number_on_edge =
          is_second_side(triangulation, h) ? number_of_points(edge(triangulation.opposite(h)))
          : triangulation.length(h) > 0    ? placement.number_of_points(triangulation, h)
                                           : 0;
      number += double(number_on_edge);
      if(number_on_edge > most)
      {
        most = number_on_edge;
        halfedge_with_most = h;
      }
      m_first_point[e + 1] = m_first_point[e] + static_cast<Index>(number_on_edge); // checked below
    });
    if(number > double((std::min)(limit, largest_number)))
      refuse_points(triangulation, placement, number, halfedge_with_most, most, limit);
  }

  // Whether `h` is at the side of a barrier that comes second.
  static bool is_second_side(const Intrinsic_triangulation& triangulation, const Index h)
  {
    return triangulation.is_barrier(h) && triangulation.opposite(h) < h;
  }

  // Copies the positions from the side of `h` of a barrier to the other one, which is edge `e`.
  void copy_positions(const Index h, const Index e)
  {
    for(Index i = 0; i < number_of_points(e); ++i)
      m_position[beyond_point(e) - 1 - i] = -m_position[first_point(edge(h)) + i];
  }

  std::vector<Index> m_edge;              // per halfedge: twice the edge, plus one if not first
  std::vector<Index> m_first_point = {0}; // per edge, and one beyond
  std::vector<Index> m_halfedge;          // per point
  std::vector<float> m_position;          // likewise, or empty
};

/*
 * The sectors into which barriers divide the faces around vertices. A vertex with at least two
 * sectors is called divided: no path leads through it from one sector to another. The border
 * divides as barriers do, but only at vertices with a barrier: where two parts of the surface touch
 * at a vertex, paths lead through it. Sectors are numbered from 0, those of a vertex consecutively.
 */
class Sectors
{
public:
  Sectors() = default;

  explicit Sectors(const Intrinsic_triangulation& triangulation)
  {
    if(triangulation.has_barriers())
      for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
        divide(triangulation, v);
  }

  bool is_empty() const { return m_first_halfedge.empty(); }
  Index number_of_sectors() const { return static_cast<Index>(m_first_halfedge.size()); }

  // Returns the vertex of a sector.
  Index vertex(const Index sector) const { return m_vertex[sector]; }

  // Returns the first halfedge of a sector: its faces are to the left of the halfedges from there
  // on, counterclockwise, up to the next halfedge that is a barrier or at the border.
  Index first_halfedge(const Index sector) const { return m_first_halfedge[sector]; }

  // Returns the first sector of a vertex, and the one after the last. They are equal if it is not
  // divided.
  std::pair<Index, Index> sectors(const Index v) const
  {
    const auto [first, beyond] = std::equal_range(m_vertex.begin(), m_vertex.end(), v);
    return {static_cast<Index>(first - m_vertex.begin()),
            static_cast<Index>(beyond - m_vertex.begin())};
  }

  // Returns the sector of `v` with the face to the left of `h`, or null_index if `v` is not
  // divided. \pre `h` starts from `v`.
  Index sector(const Index v, const Index h) const
  {
    const auto [first, beyond] = sectors(v);
    if(first == beyond)
      return null_index;
    const auto begin = m_first_halfedge.begin();
    const auto next = std::upper_bound(begin + first, begin + beyond, h);
    return next == begin + first ? beyond - 1 : static_cast<Index>(next - begin) - 1;
  }

  std::size_t memory() const { return memory_of(m_vertex, m_first_halfedge); }

private:
  void divide(const Intrinsic_triangulation& triangulation, const Index v)
  {
    const std::size_t number_before = m_vertex.size();
    bool has_barrier = false;
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
    {
      const bool is_at_border = triangulation.is_border(triangulation.opposite(h));
      has_barrier = has_barrier || triangulation.is_barrier(h);
      if(!triangulation.is_border(h) && (is_at_border || triangulation.is_barrier(h)))
      {
        m_vertex.push_back(v);
        m_first_halfedge.push_back(h);
      }
    }
    if(!has_barrier || m_vertex.size() < number_before + 2) // nothing is divided
    {
      m_vertex.resize(number_before);
      m_first_halfedge.resize(number_before);
    }
  }

  std::vector<Index> m_vertex; // per sector, ascending
  std::vector<Index> m_first_halfedge;
};

/*
 * The nodes of a Steiner graph: the vertices, then the points on edges, then the sectors of divided
 * vertices. All member functions must be given the triangulation that the constructor was given.
 */
class Steiner_nodes
{
public:
  using Node = Index;

  Steiner_nodes() = default;

  // Prepares the placement, and puts its points on the edges. If `maximum_number_of_points` is 0,
  // the default applies. Throws std::length_error if there are more points, or more than 2^32 - 1
  // nodes, and std::invalid_argument if there are points and a face violates the triangle
  // inequality.
  template <typename Placement>
  Steiner_nodes(const Intrinsic_triangulation& triangulation,
                Placement& placement,
                const std::size_t maximum_number_of_points)
    : m_sectors(triangulation), m_first_point(triangulation.number_of_vertices())
  {
    const std::size_t limit =
        internal::maximum_number_of_points(triangulation, maximum_number_of_points);
    placement.prepare(triangulation, limit);
    m_points = Points_on_edges(triangulation, placement, limit,
                               null_index - std::size_t(number_of_sectors()) - m_first_point);
    m_first_sector = m_first_point + m_points.number_of_points();
    if(m_points.number_of_points() > 0) // there are arcs across faces
      triangulation.check_triangle_inequality();
    m_maximum_degree = find_maximum_degree(triangulation);
    if constexpr(is_valid<const Placement&>([](auto& p) -> decltype(p.tangent_of_narrow_arcs()) {}))
      m_tangent_of_narrow_arcs = placement.tangent_of_narrow_arcs();
  }

  const Points_on_edges& points() const { return m_points; }
  const Sectors& sectors() const { return m_sectors; }

  std::size_t size() const { return std::size_t(m_first_sector) + m_sectors.number_of_sectors(); }

  // Returns the tangent of the largest angle with a side at which an arc across a face is narrow,
  // or 0 if no arcs are left out.
  double tangent_of_narrow_arcs() const { return m_tangent_of_narrow_arcs; }

  // Returns an upper bound of the number of arcs that start from a node.
  std::size_t maximum_degree() const { return m_maximum_degree; }

  // These return false for numbers that are not nodes, such as `null_index`.
  bool is_vertex(const Node node) const { return node < m_first_point; }
  bool is_point(const Node node) const { return node - m_first_point < number_of_points(); }
  bool is_sector(const Node node) const { return node - m_first_sector < number_of_sectors(); }

  // Convert between nodes and the numbers of points and sectors.
  Node point(const Node node) const { return node - m_first_point; }
  Node sector(const Node node) const { return node - m_first_sector; }
  Node node_of_point(const Node p) const { return m_first_point + p; }
  Node node_of_sector(const Node s) const { return m_first_sector + s; }

  Intrinsic_point position(const Node node) const
  {
    if(is_sector(node))
      return Intrinsic_point::at_vertex(m_sectors.vertex(sector(node)));
    if(is_vertex(node))
      return Intrinsic_point::at_vertex(node);
    const Node p = point(node), h = m_points.halfedge(p);
    return Intrinsic_point::on_edge(h, m_points.part_before(m_points.edge(h), p));
  }

  // ----- nodes at the corners of faces: the vertices, unless these are divided

  bool is_divided(const Node v) const
  {
    const auto [first, beyond] = m_sectors.sectors(v);
    return first != beyond;
  }

  // Calls `f(node)` for the sectors of a divided vertex.
  template <typename F>
  void for_each_sector(const Node v, F f) const
  {
    const auto [first, beyond] = m_sectors.sectors(v);
    for(Index s = first; s < beyond; ++s)
      f(node_of_sector(s));
  }

  // Calls `f(node, part)` for the points at a part of `h`, or of its left side.
  template <typename F>
  void for_each_node_on_edge(const Index h, F f) const
  {
    const Index e = m_points.edge(h);
    for(Index p = m_points.first_point(e); p < m_points.beyond_point(e); ++p)
      f(node_of_point(p),
        m_points.is_first(h) ? m_points.part_before(e, p) : m_points.part_behind(e, p));
  }

  // Returns the node of the vertex `v` in the face to the left of `h`, which starts there.
  Node at_corner(const Node v, const Index h) const
  {
    if(m_sectors.is_empty())
      return v;
    const Index sector = m_sectors.sector(v, h);
    return sector == null_index ? v : node_of_sector(sector);
  }

  // Return the nodes at the ends of the edge of `h`, or of its left side.
  Node at_source(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    const Index opposite = triangulation.opposite(h);
    const Node v = triangulation.target(opposite);
    if(m_sectors.is_empty() || (triangulation.is_border(h) && triangulation.is_border(opposite)))
      return v;
    return at_corner(v, triangulation.is_border(h) ? triangulation.next(opposite) : h);
  }
  Node at_target(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    const Node v = triangulation.target(h);
    if(m_sectors.is_empty())
      return v;
    return triangulation.is_border(h) ? at_source(triangulation, triangulation.opposite(h))
                                      : at_corner(v, triangulation.next(h));
  }

  // Prefetches the data from which the arcs of a node are computed.
  void prefetch(const Intrinsic_triangulation& triangulation, const Node node) const
  {
    if(is_vertex(node))
      triangulation.prefetch(triangulation.first_halfedge(node));
    else if(is_point(node))
      m_points.prefetch(point(node));
  }

  std::size_t memory() const { return memory_of(m_points, m_sectors); }

private:
  Node number_of_points() const { return m_first_sector - m_first_point; }
  Node number_of_sectors() const { return m_sectors.number_of_sectors(); }

  std::size_t find_maximum_degree(const Intrinsic_triangulation& triangulation) const
  {
    std::size_t result = 0;
    for(Node v = 0; v < triangulation.number_of_vertices(); ++v)
    {
      std::size_t degree = 1; // to the vertex, from one of its sectors
      for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
        degree += 2 + number_of_opposite_points(triangulation, h); // a barrier counts as two edges
      result = (std::max)(result, degree);
    }
    m_points.for_each_first_halfedge([&](const Index h, const Index /* edge */) {
      std::size_t degree = 5; // along the edge, to its other side, and to two third vertices
      for(const Index side : {h, triangulation.opposite(h)})
        if(!triangulation.is_border(side))
          degree += number_of_opposite_points(triangulation, side) +
                    number_of_opposite_points(triangulation, triangulation.next(side));
      result = (std::max)(result, degree);
    });
    return result;
  }

  // Returns the number of points opposite to the source of `h`, in the face to the left of `h`.
  std::size_t number_of_opposite_points(const Intrinsic_triangulation& triangulation,
                                        const Index h) const
  {
    return triangulation.is_border(h)
               ? 0
               : m_points.number_of_points(m_points.edge(triangulation.next(h)));
  }

  Sectors m_sectors;
  Points_on_edges m_points;
  Node m_first_point = 0;
  Node m_first_sector = 0;
  std::size_t m_maximum_degree = 0;
  double m_tangent_of_narrow_arcs = 0;
};

/*
 * A point on an edge as a node of the face to the left of a halfedge of the edge.
 */
struct Viewpoint
{
  using Node = Steiner_nodes::Node;
  using Face = std::array<Index, 3>; // its halfedges, from that of the viewpoint on

  Viewpoint reversed(const Index opposite) const
  {
    return {opposite,      node,          from_target,    from_source,
            toward_target, toward_source, cost_to_target, cost_to_source};
  }

  Index halfedge;
  Node node;
  double from_source, from_target;       // distances from the ends of the halfedge
  Node toward_source, toward_target;     // neighbors on the edge
  double cost_to_source, cost_to_target; // costs of the arcs to the neighbors
};

/*
 * References to the data that costs and arcs are computed from.
 */
class Steiner_view
{
protected:
  using Node = Steiner_nodes::Node;
  using Face = Viewpoint::Face;

  Steiner_view(const Intrinsic_triangulation& triangulation, const Steiner_nodes& nodes)
    : m_triangulation(triangulation), m_nodes(nodes), m_points(nodes.points())
  {
  }

  // Calls `f`, unless the cost is infinite.
  template <typename F>
  static void offer(const Node node, const double cost, F& f)
  {
    if(cost < infinity)
      f(node, cost);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Steiner_nodes& m_nodes;
  const Points_on_edges& m_points;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_STEINER_NODES_H
