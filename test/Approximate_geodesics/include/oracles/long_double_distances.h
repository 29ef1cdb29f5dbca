// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_LONG_DOUBLE_DISTANCES_H
#define APPROXIMATE_GEODESICS_TEST_LONG_DOUBLE_DISTANCES_H

#include "meshes/test_soup.h"
#include "paths/dijkstra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Distances without the package and without tricks, in `long double`: its range is so large that
// no square of a coordinate overflows or vanishes. For small meshes.

namespace geodesics_test {

using Long = long double;
using Long_point = std::array<Long, 3>;

inline Long_point long_point(const Point& p) { return {p.x(), p.y(), p.z()}; }

inline Long_point operator-(const Long_point& p, const Long_point& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline Long long_norm(const Long_point& v) { return std::hypot(v[0], v[1], v[2]); }

inline Long long_distance(const Long_point& p, const Long_point& q) { return long_norm(p - q); }

inline Long long_product(const Long_point& v, const Long_point& w)
{
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

// The length of the cross product.
inline Long long_area(const Long_point& v, const Long_point& w)
{
  return long_norm({v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], //
                    v[0] * w[1] - v[1] * w[0]});
}

// ----- Dijkstra's algorithm

class Long_graph
{
public:
  static constexpr Long infinite = std::numeric_limits<Long>::infinity();

  explicit Long_graph(const std::size_t number_of_nodes) : m_arcs(number_of_nodes) {}

  void add_arc(const std::size_t from, const std::size_t to, const Long length)
  {
    m_arcs[from].push_back({length, to});
  }

  std::vector<Long> distances(const std::size_t source) const
  {
    return textbook_distances<Long>(m_arcs.size(), source,
                                    [&](const std::size_t node, const auto& f) {
                                      for(const auto& [length, target] : m_arcs[node])
                                        f(target, length);
                                    });
  }

private:
  using Arc = std::pair<Long, std::size_t>;

  std::vector<std::vector<Arc>> m_arcs;
};

inline Long_graph graph_of_edges(const Mesh& mesh)
{
  Long_graph result(mesh.num_vertices());
  for(const Halfedge h : mesh.halfedges())
    result.add_arc(mesh.source(h).idx(), mesh.target(h).idx(),
                   long_distance(long_point(mesh.point(mesh.source(h))),
                                 long_point(mesh.point(mesh.target(h)))));
  return result;
}

// ----- across faces

/*
 * The arcs between all pairs of vertices that see each other along a straight line, across faces
 * laid out in the plane: a shortest path on the surface consists of such lines. What a vertex sees
 * is followed from face to face, between the two rays that bound it. No shortest path meets a face
 * twice, nor is it longer than the one along edges; nothing else is left out.
 */
class Lines_of_sight
{
public:
  explicit Lines_of_sight(const Mesh& mesh)
    : m_mesh(mesh), m_graph(graph_of_edges(mesh)), m_is_crossed(mesh.num_faces(), false)
  {
    const Long_graph edges = m_graph;
    for(const Vertex v : mesh.vertices())
    {
      m_source = v;
      m_limit = 0;
      for(const Long d : edges.distances(v.idx()))
        m_limit = (std::max)(m_limit, d < Long_graph::infinite ? d : 0);
      if(!mesh.is_isolated(v))
        for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
          look_from(mesh.opposite(h));
    }
  }

  const Long_graph& graph() const { return m_graph; }

private:
  struct Vector_2
  {
    Long x, y;
  };

  // What is seen between two rays.
  struct Cone
  {
    Vector_2 right, left;
  };

  static Long turn(const Vector_2& v, const Vector_2& w) { return v.x * w.y - v.y * w.x; }

  static bool is_empty(const Cone& cone)
  {
    const Vector_2 &r = cone.right, &l = cone.left;
    return !(turn(r, l) > 0) && !(r.x * l.x + r.y * l.y < 0); // half a plane is not
  }

  Long_point point(const Vertex v) const { return long_point(m_mesh.point(v)); }

  // Where the third vertex of the face of `h` is, to the left of the line between its ends.
  Vector_2 third(const Halfedge h, const Vector_2& source, const Vector_2& target) const
  {
    const Long_point a = point(m_mesh.source(h));
    const Long_point side = point(m_mesh.target(h)) - a;
    const Long_point way = point(m_mesh.target(m_mesh.next(h))) - a;
    const Long length = long_norm(side);
    constexpr Long unknown = std::numeric_limits<Long>::quiet_NaN();
    if(length == 0)
      return {unknown, unknown};
    const Long along = long_product(side, way) / length, height = long_area(side, way) / length;
    const Vector_2 e{(target.x - source.x) / length, (target.y - source.y) / length};
    return {source.x + along * e.x - height * e.y, source.y + along * e.y + height * e.x};
  }

  // into the face to the left of `h`, which starts from the vertex
  void look_from(const Halfedge h)
  {
    const Long length = long_distance(point(m_source), point(m_mesh.target(h)));
    if(m_mesh.is_border(h) || length == 0)
      return;
    const Vector_2 right{length, 0}, left = third(h, {0, 0}, right);
    m_is_crossed[m_mesh.face(h).idx()] = true;
    look_across(m_mesh.next(h), right, left, {right, left});
    m_is_crossed[m_mesh.face(h).idx()] = false;
  }

  // over the edge of `h`, from the face to its left
  void look_across(const Halfedge h, const Vector_2& right, const Vector_2& left, const Cone& cone)
  {
    const Halfedge g = m_mesh.opposite(h);
    if(is_empty(cone) || m_mesh.is_border(g) || m_is_crossed[m_mesh.face(g).idx()] ||
       is_too_far(right, left))
      return;
    m_is_crossed[m_mesh.face(g).idx()] = true;
    const Vector_2 c = third(g, left, right);
    const bool is_left_of_right = turn(cone.right, c) >= 0,
               is_right_of_left = turn(c, cone.left) >= 0;
    if(is_left_of_right && is_right_of_left)
      m_graph.add_arc(m_source.idx(), m_mesh.target(m_mesh.next(g)).idx(), std::hypot(c.x, c.y));
    if(is_left_of_right)
      look_across(m_mesh.next(g), right, c, {cone.right, is_right_of_left ? c : cone.left});
    if(is_right_of_left)
      look_across(m_mesh.prev(g), c, left, {is_left_of_right ? c : cone.right, cone.left});
    m_is_crossed[m_mesh.face(g).idx()] = false;
  }

  bool is_too_far(const Vector_2& p, const Vector_2& q) const
  {
    const Vector_2 e{q.x - p.x, q.y - p.y};
    const Long t =
        (std::clamp)(-(p.x * e.x + p.y * e.y) / (e.x * e.x + e.y * e.y), Long(0), Long(1));
    return std::hypot(p.x + t * e.x, p.y + t * e.y) > m_limit * (1 + Long(1e-15));
  }

  const Mesh& m_mesh;
  Long_graph m_graph;
  std::vector<bool> m_is_crossed;
  Vertex m_source;
  Long m_limit = 0;
};

// ----- what a `double` can know

/*
 * How wrong a path can be since a `double` holds no more of the lengths of edges. Heights of faces
 * add nothing to that, as they follow from coordinates where lengths say too little of them.
 */
class Rounding_of_lengths
{
public:
  explicit Rounding_of_lengths(const Mesh& mesh)
  {
    for(const Face f : mesh.faces())
    {
      const Halfedge h = mesh.halfedge(f);
      m_faces.emplace_back(Triangle{long_point(mesh.point(mesh.source(h))),
                                    long_point(mesh.point(mesh.target(h))),
                                    long_point(mesh.point(mesh.target(mesh.next(h))))});
    }
  }

  // of a path from `p` that is not longer than `length`: of all faces that it may cross
  Long error_of_path(const Long_point& p, const Long length) const
  {
    Long result = 100 * Long(std::numeric_limits<double>::denorm_min());
    for(const Measured_face& f : m_faces)
      if(f.distance_to_box(p) <= length)
        result += 4 * ROUNDING * f.longest_side;
    return result;
  }

  // of costs, where small ones vanish beside weights: of all faces whose height lengths say nothing
  // of
  Long error_of_flat_faces() const
  {
    Long result = 0;
    for(const Measured_face& f : m_faces)
      if(f.error_of_height > 100 * ROUNDING * f.longest_side)
        result += 4 * f.error_of_height;
    return result;
  }

private:
  static constexpr Long ROUNDING = std::numeric_limits<double>::epsilon();

  using Triangle = std::array<Long_point, 3>;

  struct Measured_face
  {
    explicit Measured_face(const Triangle& t) : corners(t)
    {
      std::array<Long, 3> sides = {long_distance(t[0], t[1]), long_distance(t[1], t[2]),
                                   long_distance(t[2], t[0])};
      std::sort(sides.begin(), sides.end());
      longest_side = sides[2];
      const Long height = longest_side > 0 ? long_area(t[1] - t[0], t[2] - t[0]) / longest_side : 0;
      // its square changes by about twice this if the sides do
      const Long of_square = ROUNDING * sides[0] * longest_side;
      error_of_height = height * height > of_square ? of_square / height : std::sqrt(of_square);
    }

    Long distance_to_box(const Long_point& p) const
    {
      Long_point way;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const auto [low, high] = std::minmax({corners[0][i], corners[1][i], corners[2][i]});
        way[i] = p[i] - (std::clamp)(p[i], low, high);
      }
      return long_norm(way);
    }

    Triangle corners;
    Long longest_side = 0, error_of_height = 0;
  };

  std::vector<Measured_face> m_faces;
};

// ----- with weights

/*
 * The graph of the vertices and of equally spaced points on edges, any two of which are joined if
 * they are at the border of the same face.
 */
class Long_steiner_graph
{
public:
  Long_steiner_graph(const Mesh& mesh, const std::vector<double>& weights, const std::size_t number)
    : m_mesh(mesh), m_number(number), m_graph(mesh.num_vertices() + number * mesh.num_edges())
  {
    for(const Face f : mesh.faces())
      if(weights[f.idx()] < std::numeric_limits<double>::infinity())
        join(nodes_of(f), weights[f.idx()]);
  }

  const Long_graph& graph() const { return m_graph; }

private:
  struct Node
  {
    std::size_t number;
    Long_point point;
  };

  std::vector<Node> nodes_of(const Face f) const
  {
    std::vector<Node> result;
    for(const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
    {
      const Vertex v = m_mesh.source(h);
      result.push_back({v.idx(), long_point(m_mesh.point(v))});
      for(std::size_t i = 0; i < m_number; ++i)
        result.push_back(node(m_mesh.edge(h), i));
    }
    return result;
  }

  Node node(const Edge e, const std::size_t i) const
  {
    const Long_point a = long_point(m_mesh.point(m_mesh.vertex(e, 0))),
                     b = long_point(m_mesh.point(m_mesh.vertex(e, 1)));
    const Long t = Long(i + 1) / Long(m_number + 1);
    return {m_mesh.num_vertices() + e.idx() * m_number + i,
            {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])}};
  }

  void join(const std::vector<Node>& nodes, const Long weight)
  {
    for(const Node& p : nodes)
      for(const Node& q : nodes)
        m_graph.add_arc(p.number, q.number, weight * long_distance(p.point, q.point));
  }

  const Mesh& m_mesh;
  std::size_t m_number;
  Long_graph m_graph;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_LONG_DOUBLE_DISTANCES_H
