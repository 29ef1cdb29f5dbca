// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_CELL_NETWORK_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_CELL_NETWORK_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Geodesic_constructions/internal/Cells/Face_cells.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// A border between two cells, as a polyline with the first cell on its left.
struct Network_border
{
  static constexpr std::size_t NONE = (std::numeric_limits<std::size_t>::max)();

  std::array<std::size_t, 2> sources;
  std::vector<Intrinsic_point> points;            // in faces
  std::array<std::size_t, 2> corners{NONE, NONE}; // where it begins and ends, unless it is closed
};

// Where borders end.
struct Network_corner
{
  Intrinsic_point point;
  std::vector<std::size_t> sources; // counterclockwise, if there are three or more
};

/*
 * Joins arcs to polylines. Ends of arcs that are next to each other, up to rounding, are one node:
 * in a face, on an edge, or at a vertex. Polylines go on where exactly two arcs between the same
 * cells meet.
 */
class Cell_network
{
public:
  Cell_network(const Intrinsic_triangulation& triangulation, const std::vector<Border_arc>& arcs)
    : m_triangulation(triangulation),
      m_arcs(arcs),
      m_ends(2 * arcs.size()),
      m_nodes(m_ends.size(), 0),
      m_parents(m_ends.size(), 0),
      m_sets(m_nodes.data(), m_parents.data())
  {
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      m_sets.make_set(i);
    for(std::size_t i = 0; i < m_ends.size(); ++i)
    {
      check_for_interruption_at(i);
      m_ends[i] = place(i);
    }
    join_at_vertices();
    join_on_edges();
    join_in_faces();
    list_incidences();
    follow_all();
  }

  const std::vector<Network_border>& borders() const { return m_borders; }
  const std::vector<Network_corner>& corners() const { return m_corners; }

private:
  static constexpr std::size_t NONE = Network_border::NONE;
  static constexpr double TOLERANCE = 1e-6; // in longest edges of faces

  // Ends with even numbers are first points, the others last points.
  struct End
  {
    Plane_vector position; // in the frame of the face
    double tolerance;
    bool is_at_border; // of the surface
  };

  const Border_arc& arc(const std::size_t end) const { return m_arcs[end / 2]; }

  const std::array<double, 3>& weights(const std::size_t end) const
  {
    return end % 2 == 0 ? arc(end).points.front() : arc(end).points.back();
  }

  // Locates the end of an arc, and lists it at the vertices and edges that it is next to.
  End place(const std::size_t end)
  {
    const Index h = arc(end).halfedge;
    const Face_layout layout(m_triangulation, h);
    const std::array<double, 3>& weight = weights(end);
    const double longest = (std::max)({m_triangulation.length(layout.halfedge(0)),
                                       m_triangulation.length(layout.halfedge(1)),
                                       m_triangulation.length(layout.halfedge(2))});
    End result{layout.position({h, weight}), TOLERANCE * longest, false};
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Index side = layout.halfedge(i), opposite = m_triangulation.opposite(side);
      const Plane_vector p = result.position - layout.corner(i), edge = layout.edge(i, (i + 1) % 3);
      if(length(p) <= result.tolerance)
        m_at_vertices.emplace_back(layout.vertex(i), end);
      const double size = length(edge);
      if(std::abs(cross(edge, p)) > result.tolerance * size || !(size > 0))
        continue;
      result.is_at_border = result.is_at_border || m_triangulation.is_border(opposite);
      const double way = dot(edge, p) / size;
      m_on_edges.push_back({(std::min)(side, opposite), side < opposite ? way : size - way, end});
    }
    return result;
  }

  void join_at_vertices()
  {
    std::sort(m_at_vertices.begin(), m_at_vertices.end());
    for(std::size_t i = 1; i < m_at_vertices.size(); ++i)
      if(m_at_vertices[i].first == m_at_vertices[i - 1].first)
        m_sets.union_set(m_at_vertices[i].second, m_at_vertices[i - 1].second);
  }

  void join_on_edges()
  {
    std::sort(m_on_edges.begin(), m_on_edges.end());
    for(std::size_t i = 1; i < m_on_edges.size(); ++i)
    {
      const auto& [edge, way, end] = m_on_edges[i - 1];
      const auto& [next_edge, next_way, next_end] = m_on_edges[i];
      if(edge == next_edge &&
         next_way - way <= (std::max)(m_ends[end].tolerance, m_ends[next_end].tolerance))
        m_sets.union_set(end, next_end);
    }
  }

  void join_in_faces()
  {
    std::vector<std::tuple<Index, double, std::size_t>> list;
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      list.emplace_back(arc(i).halfedge, m_ends[i].position.x, i);
    std::sort(list.begin(), list.end());
    for(auto it = list.begin(); it != list.end(); ++it)
    {
      check_for_interruption_at(static_cast<std::size_t>(it - list.begin()));
      const auto& [face, x, end] = *it;
      const double tolerance = m_ends[end].tolerance;
      for(auto next = it + 1;
          next != list.end() && std::get<0>(*next) == face && std::get<1>(*next) - x <= tolerance;
          ++next)
        if(length(m_ends[std::get<2>(*next)].position - m_ends[end].position) <= tolerance)
          m_sets.union_set(end, std::get<2>(*next));
    }
  }

  // Whether an arc is a point, up to rounding.
  bool is_point(const std::size_t i) const
  {
    constexpr double several = 4;
    return m_nodes[2 * i] == m_nodes[2 * i + 1] &&
           length(m_ends[2 * i].position - m_ends[2 * i + 1].position) <=
               several * m_ends[2 * i].tolerance;
  }

  // Lists the ends by node and pair of cells, and what follows each of them.
  void list_incidences()
  {
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      m_nodes[i] = m_sets.find_set(i);
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      if(!is_point(i / 2))
        m_incidences.emplace_back(m_nodes[i], arc(i).left, arc(i).right, i);
    std::sort(m_incidences.begin(), m_incidences.end());
    m_next.assign(m_ends.size(), NONE);
    const auto is_same = [&](const std::size_t i, const std::size_t j) {
      const auto key = [](const Incidence& x) {
        return std::tie(std::get<0>(x), std::get<1>(x), std::get<2>(x));
      };
      return j < m_incidences.size() && key(m_incidences[i]) == key(m_incidences[j]);
    };
    for(std::size_t i = 0, beyond; i < m_incidences.size(); i = beyond)
    {
      for(beyond = i + 1; is_same(i, beyond);)
        ++beyond;
      if(beyond == i + 2)
      {
        const std::size_t a = std::get<3>(m_incidences[i]), b = std::get<3>(m_incidences[i + 1]);
        if(has_same_cells(a) || a % 2 != b % 2) // so that the same cell stays on the left
        {
          m_next[a] = b;
          m_next[b] = a;
        }
      }
    }
  }

  // Whether there is the same cell on both sides of an arc: then it has no direction.
  bool has_same_cells(const std::size_t end) const { return arc(end).left == arc(end).right; }

  // In the direction of the arcs, as far as they have any.
  void follow_all()
  {
    m_is_passed.resize(m_arcs.size());
    const auto follow_from = [&](const std::size_t end, const bool is_closed) {
      if(!m_is_passed[end / 2] && !is_point(end / 2) && (is_closed || m_next[end] == NONE))
        follow(end);
    };
    for(const bool is_closed : {false, true})
      for(const std::size_t first : {0u, 1u})
        for(std::size_t end = first; end < m_ends.size(); end += 2)
          follow_from(end, is_closed);
  }

  // Whether an arc in a face is far smaller than the face, and meets no other: between two narrow
  // windows, there was one that is narrower than rounding errors. An arc from border to border cuts
  // off a corner of the surface.
  bool is_stray(const std::size_t first, const std::size_t last) const
  {
    constexpr double several = 1000;
    const auto is_alone = [&](const std::size_t end) {
      const auto it = std::lower_bound(m_incidences.begin(), m_incidences.end(),
                                       Incidence(m_nodes[end], 0, 0, 0));
      return it + 1 == m_incidences.end() || std::get<0>(*(it + 1)) != m_nodes[end];
    };
    return first / 2 == last / 2 && is_alone(first) && is_alone(last) &&
           !(m_ends[first].is_at_border && m_ends[last].is_at_border) &&
           length(m_ends[first].position - m_ends[last].position) <=
               several * m_ends[first].tolerance;
  }

  // Follows a polyline that begins with an end of an arc.
  void follow(const std::size_t first)
  {
    Network_border border{{arc(first).left, arc(first).right}, {}};
    std::size_t last = first;
    for(std::size_t end = first; end != NONE && !m_is_passed[end / 2]; end = m_next[last])
    {
      m_is_passed[end / 2] = true;
      append(end, border.points);
      last = end ^ 1;
    }
    if(is_stray(first, last))
      return;
    if(m_next[last] == NONE)
      border.corners = {corner(first), corner(last)};
    else
      border.points.push_back(border.points.front());
    m_borders.push_back(std::move(border));
  }

  // Appends the points of an arc from one end to the other, but the one that is there already.
  void append(const std::size_t end, std::vector<Intrinsic_point>& points) const
  {
    const Border_arc& a = arc(end);
    const std::size_t n = a.points.size();
    for(std::size_t i = points.empty() ? 0 : 1; i < n; ++i)
      points.push_back(point(a.halfedge, a.points[end % 2 == 0 ? i : n - 1 - i]));
  }

  static Intrinsic_point point(const Index h, const std::array<double, 3>& weight)
  {
    return Intrinsic_point::in_face(h, weight[1], weight[2]);
  }

  std::size_t corner(const std::size_t end)
  {
    const auto [it, is_new] = m_corner_of_node.emplace(m_nodes[end], m_corners.size());
    if(is_new)
      m_corners.push_back({point(arc(end).halfedge, weights(end)), cells_around(m_nodes[end])});
    return it->second;
  }

  // Counterclockwise, unless a cell comes to the node more than once.
  std::vector<std::size_t> cells_around(const std::size_t node) const
  {
    // across a border that leaves the node, the next cell counterclockwise is that on its left
    std::vector<std::size_t> before, after;
    for(auto it =
            std::lower_bound(m_incidences.begin(), m_incidences.end(), Incidence(node, 0, 0, 0));
        it != m_incidences.end() && std::get<0>(*it) == node; ++it)
    {
      const auto& [n, left, right, end] = *it;
      before.push_back(end % 2 == 0 ? right : left);
      after.push_back(end % 2 == 0 ? left : right);
    }
    std::vector<std::size_t> sorted = before;
    sorted.insert(sorted.end(), after.begin(), after.end());
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    const std::vector<std::size_t> ordered = in_order(sorted, before, after);
    return ordered.size() == sorted.size() ? ordered : sorted;
  }

  // Begins with a cell that comes after no other, if there is one, at the border of the surface;
  // each number in `after` follows that in `before`. Ends where more than one follows, or one that
  // is there already: two nodes that are next to each other, up to rounding, are one.
  static std::vector<std::size_t> in_order(const std::vector<std::size_t>& cells,
                                           const std::vector<std::size_t>& before,
                                           const std::vector<std::size_t>& after)
  {
    std::vector<std::size_t> result;
    const auto first = std::find_if(cells.begin(), cells.end(), [&](const std::size_t cell) {
      return std::count(after.begin(), after.end(), cell) == 0;
    });
    std::size_t cell = first == cells.end() ? cells.front() : *first;
    while(std::count(result.begin(), result.end(), cell) == 0)
    {
      result.push_back(cell);
      const auto it = std::find(before.begin(), before.end(), cell);
      if(std::count(it, before.end(), cell) != 1)
        break;
      cell = after[static_cast<std::size_t>(it - before.begin())];
    }
    return result;
  }

  using Incidence = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>;

  const Intrinsic_triangulation& m_triangulation;
  const std::vector<Border_arc>& m_arcs;
  std::vector<End> m_ends;
  std::vector<std::size_t> m_nodes, m_parents; // of ends; ranks of sets before
  boost::disjoint_sets<std::size_t*, std::size_t*> m_sets;
  std::vector<std::pair<Index, std::size_t>> m_at_vertices;
  std::vector<std::tuple<Index, double, std::size_t>> m_on_edges;
  std::vector<Incidence> m_incidences; // node, cells, end
  std::vector<std::size_t> m_next;     // the end of another arc that follows an end
  std::vector<bool> m_is_passed;       // arcs
  std::vector<Network_border> m_borders;
  std::vector<Network_corner> m_corners;
  std::map<std::size_t, std::size_t> m_corner_of_node;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_CELL_NETWORK_H
