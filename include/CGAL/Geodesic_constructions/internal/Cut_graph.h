// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CUT_GRAPH_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CUT_GRAPH_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Loops from a point that do not contract: one for each link of a cut graph.
 *
 * A tree of edges connects the point with all vertices that can be reached. Each other edge makes a
 * loop with the paths to its ends. These edges, as links between the faces on both sides, are the
 * cut graph: what it leaves of the surface is a disk. If one side of a link is a tree, the loop
 * contracts; such links are removed, leaf by leaf (J. Erickson and S. Har-Peled, Optimally cutting
 * a surface into a disk). The border is a face that is never a leaf.
 */
class Cut_graph
{
public:
  using Index = Intrinsic_triangulation::Index;

  struct Link
  {
    Index halfedge;     // across which the faces are linked
    double length;      // of its loop, if the distances are those along the tree
    double lower_bound; // on loops that cross the edge, if they are those on the surface
  };

  // `distances` are those of the vertices from `base`, and infinity if they are not reached.
  Cut_graph(const Intrinsic_triangulation& triangulation,
            const Intrinsic_point& base,
            std::vector<double> distances)
    : m_triangulation(triangulation),
      m_base(base),
      m_distance(std::move(distances)),
      m_to_parent(triangulation.number_of_vertices(), null_index),
      m_is_link(triangulation.number_of_halfedges(), false)
  {
    grow_tree();
    make_links();
    remove_leaves();
    list_links();
  }

  // the one with the shortest loop first
  const std::vector<Link>& links() const { return m_links; }

  // From the base back to it.
  std::vector<Intrinsic_point> loop(const Link& link) const
  {
    std::vector<Intrinsic_point> result;
    append_path(m_triangulation.source(link.halfedge), result);
    std::reverse(result.begin(), result.end());
    append_path(m_triangulation.target(link.halfedge), result);
    return result;
  }

private:
  // ----- the tree

  bool is_reached(const Index v) const { return m_distance[v] < infinity; }

  // Calls `f(v)` for the vertices that are joined to the base by straight lines, or for the base.
  template <typename F>
  void for_each_root(F f) const
  {
    if(m_base.is_vertex())
      return f(m_base.vertex);
    m_base.for_each_face(m_triangulation, [&](const Index h) {
      for(const Index side : m_triangulation.halfedges_of_face(h))
        f(m_triangulation.source(side));
    });
  }

  // Adds the vertices in order of their distances, as soon as they have a neighbor in the tree.
  void grow_tree()
  {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::vector<bool> is_queued(m_distance.size(), false), is_in_tree(m_distance.size(), false);
    const auto push = [&](const Index v) {
      if(!is_queued[v] && is_reached(v))
        queue.emplace(m_distance[v], v);
      is_queued[v] = true;
    };
    for_each_root(push);
    for_each_root([&](const Index v) { is_in_tree[v] = true; });
    while(!queue.empty())
    {
      const Index v = queue.top().second;
      queue.pop();
      if(!is_in_tree[v])
        m_to_parent[v] = halfedge_to_parent(v, is_in_tree);
      is_in_tree[v] = true;
      for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v); ++h)
        push(m_triangulation.target(h));
    }
  }

  Index halfedge_to_parent(const Index v, const std::vector<bool>& is_in_tree) const
  {
    Index result = null_index;
    double shortest = infinity;
    for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v); ++h)
    {
      const Index w = m_triangulation.target(h);
      const double length = m_distance[w] + m_triangulation.length(h);
      if(is_in_tree[w] && length < shortest)
      {
        shortest = length;
        result = h;
      }
    }
    return result;
  }

  // From a vertex to the base.
  void append_path(Index v, std::vector<Intrinsic_point>& points) const
  {
    for(; m_to_parent[v] != null_index; v = m_triangulation.target(m_to_parent[v]))
      points.push_back(Intrinsic_point::at_vertex(v));
    points.push_back(Intrinsic_point::at_vertex(v));
    if(!m_base.is_vertex())
      points.push_back(m_base);
  }

  // ----- links

  void set_link(const Index h, const bool is_link)
  {
    m_is_link[h] = m_is_link[m_triangulation.opposite(h)] = is_link;
  }

  void make_links()
  {
    for(Index v = 0; v < m_triangulation.number_of_vertices(); ++v)
      if(is_reached(v))
        for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v);
            ++h)
          m_is_link[h] = true;
    for(const Index h : m_to_parent)
      if(h != null_index)
        set_link(h, false);
    if(!m_base.is_vertex()) // its lines to the corners divide the face: each part is a leaf
      m_base.for_each_face(m_triangulation, [&](const Index h) {
        for(const Index side : m_triangulation.halfedges_of_face(h))
          set_link(side, false);
      });
  }

  // The only link of a face, or `null_index` if it has none, or more.
  Index only_link(const Index h) const
  {
    Index result = null_index;
    for(const Index side : m_triangulation.halfedges_of_face(h))
      if(m_is_link[side])
      {
        if(result != null_index)
          return null_index;
        result = side;
      }
    return result;
  }

  void remove_leaves()
  {
    for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
      for(Index face = h; !m_triangulation.is_border(face);)
      {
        const Index link = only_link(face);
        if(link == null_index)
          break;
        set_link(link, false);
        face = m_triangulation.opposite(link);
      }
  }

  void list_links()
  {
    for(Index h = 0; h < m_is_link.size(); ++h)
      if(m_is_link[h] && h < m_triangulation.opposite(h))
      {
        const double length = m_triangulation.length(h),
                     ends = m_distance[m_triangulation.source(h)] +
                            m_distance[m_triangulation.target(h)];
        m_links.push_back({h, ends + length, ends - length});
      }
    std::sort(m_links.begin(), m_links.end(),
              [](const Link& a, const Link& b) { return a.length < b.length; });
  }

  const Intrinsic_triangulation& m_triangulation;
  const Intrinsic_point m_base;
  std::vector<double> m_distance; // by vertex
  std::vector<Index> m_to_parent; // by vertex: a halfedge that starts there
  std::vector<bool> m_is_link;    // by halfedge
  std::vector<Link> m_links;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CUT_GRAPH_H
