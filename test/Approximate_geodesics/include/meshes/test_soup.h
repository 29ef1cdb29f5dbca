// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_SOUP_H
#define APPROXIMATE_GEODESICS_TEST_SOUP_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace geodesics_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

// A mesh before it is one, so that tests can move points, and renumber, drop or flip triangles.
struct Soup
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  void append(const Soup& other)
  {
    const std::size_t shift = points.size();
    points.insert(points.end(), other.points.begin(), other.points.end());
    for(const auto& t : other.triangles)
      triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }

  // The same surface, with the point of index i at index position[i].
  Soup renumbered(const std::vector<std::size_t>& position) const
  {
    Soup result = *this;
    for(std::size_t i = 0; i < position.size(); ++i)
      result.points[position[i]] = points[i];
    for(auto& t : result.triangles)
      t = {position[t[0]], position[t[1]], position[t[2]]};
    return result;
  }

  template <typename F>
  Soup transformed(F f) const
  {
    Soup result = *this;
    std::transform(points.begin(), points.end(), result.points.begin(), f);
    return result;
  }
};

// Makes every halfedge without a face be followed by the next one around the hole.
inline void link_border(Mesh& mesh)
{
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h))
    {
      Halfedge g = mesh.opposite(h);
      while(!mesh.is_border(g))
        g = mesh.opposite(mesh.prev(g));
      mesh.set_next(h, g);
      mesh.set_halfedge(mesh.target(h), h); // as Surface_mesh likes it
    }
}

// Makes a mesh whose vertices have the indices that the points have in the soup.
class Mesh_maker
{
public:
  explicit Mesh_maker(const Soup& soup)
  {
    for(const Point& p : soup.points)
      m_mesh.add_vertex(p);
    for(const auto& t : soup.triangles)
      add_face(t);
    link_border(m_mesh);
    std::size_t number_of_halfedges = 0;
    for(const Vertex v : m_mesh.vertices())
      number_of_halfedges += m_mesh.is_isolated(v) ? 0 : m_mesh.degree(v);
    if(number_of_halfedges != m_mesh.num_halfedges() || !m_mesh.is_valid(false))
      throw std::logic_error("the fixture has a vertex that is not manifold");
  }

  Mesh mesh() const { return m_mesh; }

private:
  Halfedge halfedge(const std::size_t a, const std::size_t b)
  {
    const auto known = m_halfedges.find({a, b});
    if(known != m_halfedges.end())
      return known->second;
    const Halfedge h = m_mesh.add_edge(Vertex(Index(a)), Vertex(Index(b)));
    m_halfedges[{a, b}] = h;
    m_halfedges[{b, a}] = m_mesh.opposite(h);
    return h;
  }

  void add_face(const std::array<std::size_t, 3>& t)
  {
    const Face f = m_mesh.add_face();
    const std::array<Halfedge, 3> h = {halfedge(t[0], t[1]), halfedge(t[1], t[2]),
                                       halfedge(t[2], t[0])};
    m_mesh.set_halfedge(f, h[0]);
    for(std::size_t i = 0; i < 3; ++i)
    {
      if(!m_mesh.is_border(h[i]))
        throw std::logic_error("the fixture has an edge that is not manifold");
      m_mesh.set_face(h[i], f);
      m_mesh.set_next(h[i], h[(i + 1) % 3]);
      m_mesh.set_halfedge(m_mesh.target(h[i]), h[i]);
    }
  }

  using Index = Mesh::size_type;

  Mesh m_mesh;
  std::map<std::pair<std::size_t, std::size_t>, Halfedge> m_halfedges;
};

inline Mesh to_mesh(const Soup& soup) { return Mesh_maker(soup).mesh(); }

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_SOUP_H
