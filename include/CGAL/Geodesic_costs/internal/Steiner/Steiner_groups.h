// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_STEINER_GROUPS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_STEINER_GROUPS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Geodesic_costs/Arc_changes.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Geodesic_costs/triangulation_changes.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Calls `f(node)` for the sectors of a vertex that lifted barriers join to the one of `node`.
template <typename F>
void for_each_joined_sector(const Intrinsic_triangulation& triangulation,
                            const Steiner_nodes& nodes,
                            const Index node,
                            F f)
{
  const Index sector = nodes.sector(node), v = nodes.sectors().vertex(sector);
  Index h = nodes.sectors().first_halfedge(sector);
  if(triangulation.is_lifted(h))
    f(nodes.at_corner(v, triangulation.clockwise(v, h)));
  do
    h = triangulation.counterclockwise(v, h);
  while(!triangulation.is_border(h) && !triangulation.is_barrier(h));
  if(triangulation.is_lifted(h))
    f(nodes.at_corner(v, h));
}

/*
 * The triangulation and the nodes of a Steiner graph whose weights and barriers may change, and
 * what has changed since the graph was built, as `GeodesicGraph` says for searches that are
 * repaired.
 *
 * These are the groups of nodes within which arcs run: the nodes at the border of a face, those of
 * an edge without faces, a divided vertex with its sectors, and the nodes on both sides of a
 * barrier, which may be lifted. The group of a face or of an edge without faces has the number of
 * its smallest halfedge; those of vertices follow, and then those of barriers.
 */
class Steiner_groups
{
public:
  using Node = Steiner_nodes::Node;

  std::size_t number_of_groups() const
  {
    return m_triangulation.has_barriers()
               ? first_of_barriers() + m_triangulation.number_of_halfedges()
               : m_triangulation.number_of_halfedges();
  }

  // Calls `f(group)` for the groups of a node; for some of them several times.
  template <typename F>
  void for_each_group(const Node node, F f) const
  {
    if(m_nodes.is_point(node))
    {
      const Index h = m_nodes.points().halfedge(m_nodes.point(node));
      for_side(h, f);
      if(m_triangulation.is_barrier(h))
        f(group_of_barrier(h));
      const Index opposite = m_triangulation.opposite(h);
      if(m_nodes.points().edge(opposite) == m_nodes.points().edge(h) &&
         !m_triangulation.is_border(opposite))
        f(group_of_face(opposite));
    }
    else if(m_nodes.is_sector(node))
      for_each_group_of_sector(node, f);
    else if(m_nodes.is_divided(node))
      f(group_of_vertex(node));
    else
      for(Index h = m_triangulation.first_halfedge(node); h < m_triangulation.beyond_halfedge(node);
          ++h)
        for_side(h, f);
  }

  // Calls `f(node)` for the nodes of a group; for some of them several times.
  template <typename F>
  void for_each_node_of_group(const std::size_t group, F f) const
  {
    if(group >= first_of_barriers())
    {
      const Index h = static_cast<Index>(group - first_of_barriers());
      for_each_node_of_edge(h, f);
      for_each_node_of_edge(m_triangulation.opposite(h), f);
    }
    else if(group >= m_triangulation.number_of_halfedges())
    {
      const Node v = static_cast<Node>(group - m_triangulation.number_of_halfedges());
      f(v);
      m_nodes.for_each_sector(v, f);
    }
    else if(m_triangulation.is_border(static_cast<Index>(group)))
      for_each_node_of_edge(static_cast<Index>(group), f);
    else
      for(const Index side : m_triangulation.halfedges_of_face(static_cast<Index>(group)))
      {
        f(m_nodes.at_corner(m_triangulation.source(side), side));
        for_each_point(side, f);
      }
  }

  const Arc_changes& arc_changes() const { return m_changes; }

protected:
  explicit Steiner_groups(Intrinsic_triangulation triangulation)
    : m_triangulation(std::move(triangulation))
  {
  }

  void change_weights(const std::vector<Weight_change>& changes)
  {
    m_changes.reserve(changes.size());
    Triangulation_changes(m_triangulation)
        .set_weights(changes, [this](const Index h, const double before, const double after) {
          m_may_have_free_arcs = m_may_have_free_arcs || after == 0;
          if(after != before)
            add_change(group_of_face(h), after < before);
        });
  }

  void change_barriers(const std::vector<Barrier_change>& changes)
  {
    m_changes.reserve(changes.size());
    set_barriers(m_triangulation, changes);
    for(const Barrier_change& change : changes)
      add_change(group_of_barrier(change.halfedge), !change.is_barrier);
  }

  // The number of changes after which those before are dropped, as they change most results.
  std::size_t most_changes() const
  {
    constexpr std::size_t groups_per_change = 8;
    return number_of_groups() / groups_per_change;
  }

  Intrinsic_triangulation m_triangulation;
  Steiner_nodes m_nodes;
  Arc_changes m_changes;
  bool m_may_have_free_arcs = false;

private:
  void add_change(const std::size_t group, const bool is_shorter)
  {
    m_changes.add({group, is_shorter, !is_shorter}, most_changes());
  }

  // The group of the barrier of `h`.
  std::size_t group_of_barrier(const Index h) const
  {
    return first_of_barriers() + (std::min)(h, m_triangulation.opposite(h));
  }

  // The group of the face to the left of `h`.
  std::size_t group_of_face(const Index h) const { return m_triangulation.first_of_face(h); }

  std::size_t first_of_barriers() const
  {
    return std::size_t(m_triangulation.number_of_halfedges()) +
           m_triangulation.number_of_vertices();
  }

  std::size_t group_of_vertex(const Node v) const
  {
    return std::size_t(m_triangulation.number_of_halfedges()) + v;
  }

  // Calls `f` for the group of the face to the left of `h`, or of its edge if that has no faces.
  template <typename F>
  void for_side(const Index h, F& f) const
  {
    const Index opposite = m_triangulation.opposite(h);
    if(!m_triangulation.is_border(h))
      f(group_of_face(h));
    else if(m_triangulation.is_border(opposite))
      f(std::size_t((std::min)(h, opposite)));
  }

  template <typename F>
  void for_each_group_of_sector(const Node node, F& f) const
  {
    const Index sector = m_nodes.sector(node);
    const Node v = m_nodes.sectors().vertex(sector);
    f(group_of_vertex(v));
    Index h = m_nodes.sectors().first_halfedge(sector);
    if(m_triangulation.is_barrier(h))
      f(group_of_barrier(h));
    do
    {
      f(group_of_face(h));
      h = m_triangulation.counterclockwise(v, h);
    } while(!m_triangulation.is_border(h) && !m_triangulation.is_barrier(h));
    if(m_triangulation.is_barrier(h))
      f(group_of_barrier(h));
  }

  template <typename F>
  void for_each_node_of_edge(const Index h, F& f) const
  {
    f(m_nodes.at_source(m_triangulation, h));
    f(m_nodes.at_target(m_triangulation, h));
    for_each_point(h, f);
  }

  template <typename F>
  void for_each_point(const Index h, F& f) const
  {
    const Index e = m_nodes.points().edge(h);
    for(Index p = m_nodes.points().first_point(e); p < m_nodes.points().beyond_point(e); ++p)
      f(m_nodes.node_of_point(p));
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_STEINER_GROUPS_H
