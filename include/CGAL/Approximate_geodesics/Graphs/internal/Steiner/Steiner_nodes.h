// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_NODES_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_NODES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Points_on_edges.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The sectors into which barriers divide the faces around vertices. A vertex with at least two
 * sectors is called divided: no path leads through it from one sector to another. The border
 * divides as barriers do, but only at vertices with a barrier: where two parts of the surface touch
 * at a vertex, paths lead through it. Sectors are numbered from 0, those of a vertex consecutively.
 */
class Sectors
{
public:
  using Index = Intrinsic_triangulation::Index;
  static constexpr Index null_index = Intrinsic_triangulation::null_index;

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

  // Return the first sector of a vertex, and the one after the last. They are equal if it is not
  // divided.
  Index first_sector(const Index v) const
  {
    return static_cast<Index>(std::lower_bound(m_vertex.begin(), m_vertex.end(), v) -
                              m_vertex.begin());
  }
  Index beyond_sector(const Index v) const
  {
    return static_cast<Index>(std::upper_bound(m_vertex.begin(), m_vertex.end(), v) -
                              m_vertex.begin());
  }

  // Returns the sector of `v` with the face to the left of `h`, or null_index if `v` is not
  // divided. \pre `h` starts from `v`.
  Index sector(const Index v, const Index h) const
  {
    const Index first = first_sector(v), beyond = beyond_sector(v);
    if(first == beyond)
      return null_index;
    const auto begin = m_first_halfedge.begin();
    const auto next = std::upper_bound(begin + first, begin + beyond, h);
    return next == begin + first ? beyond - 1 : static_cast<Index>(next - begin) - 1;
  }

  std::size_t memory() const
  {
    return sizeof(Index) * (m_vertex.capacity() + m_first_halfedge.capacity());
  }

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
  using Node = Intrinsic_triangulation::Index;
  using Index = Node;

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
                               Intrinsic_triangulation::null_index -
                                   std::size_t(number_of_sectors()) - m_first_point);
    m_first_sector = m_first_point + m_points.number_of_points();
    if(m_points.number_of_points() > 0) // there are arcs across faces
      triangulation.check_triangle_inequality();
    m_maximum_degree = (std::max)(maximum_degree_of_vertices(triangulation),
                                  maximum_degree_of_points(triangulation));
  }

  const Points_on_edges& points() const { return m_points; }
  const Sectors& sectors() const { return m_sectors; }

  std::size_t size() const { return std::size_t(m_first_sector) + m_sectors.number_of_sectors(); }

  // Returns an upper bound of the number of arcs that start from a node.
  std::size_t maximum_degree() const { return m_maximum_degree; }

  // These return false for numbers that are no node, such as `null_index`.
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
    return !m_sectors.is_empty() && m_sectors.first_sector(v) != m_sectors.beyond_sector(v);
  }

  // Calls `f(node)` for the sectors of a divided vertex.
  template <typename F>
  void for_each_sector(const Node v, F f) const
  {
    for(Index s = m_sectors.first_sector(v); s < m_sectors.beyond_sector(v); ++s)
      f(node_of_sector(s));
  }

  // Returns the node of the vertex `v` in the face to the left of `h`, which starts there.
  Node at_corner(const Node v, const Index h) const
  {
    if(m_sectors.is_empty())
      return v;
    const Index sector = m_sectors.sector(v, h);
    return sector == Sectors::null_index ? v : node_of_sector(sector);
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

  std::size_t memory() const { return m_points.memory() + m_sectors.memory(); }

private:
  Node number_of_points() const { return m_first_sector - m_first_point; }
  Node number_of_sectors() const { return m_sectors.number_of_sectors(); }

  std::size_t maximum_degree_of_vertices(const Intrinsic_triangulation& triangulation) const
  {
    std::size_t result = 0;
    for(Node v = 0; v < triangulation.number_of_vertices(); ++v)
    {
      std::size_t degree = 1; // to the vertex, from one of its sectors
      for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
        degree += 2 + number_of_opposite_points(triangulation, h); // a barrier counts as two edges
      result = (std::max)(result, degree);
    }
    return result;
  }

  std::size_t maximum_degree_of_points(const Intrinsic_triangulation& triangulation) const
  {
    std::size_t result = 0;
    m_points.for_each_first_halfedge([&](const Index h, const Index /* edge */) {
      std::size_t degree = 4; // along the edge, and to the third vertices of both faces
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
};

/*
 * References to the data that costs and arcs are computed from.
 */
class Steiner_view
{
protected:
  Steiner_view(const Intrinsic_triangulation& triangulation, const Steiner_nodes& nodes)
    : m_triangulation(triangulation), m_nodes(nodes), m_points(nodes.points())
  {
  }

  // Calls `f`, unless the cost is infinite.
  template <typename F>
  static void offer(const Steiner_nodes::Node node, const double cost, F& f)
  {
    if(cost < std::numeric_limits<double>::infinity())
      f(node, cost);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Steiner_nodes& m_nodes;
  const Points_on_edges& m_points;
};

/*
 * A point on an edge as a node of the face to the left of a halfedge of the edge.
 */
struct Viewpoint
{
  using Index = Intrinsic_triangulation::Index;
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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_NODES_H
