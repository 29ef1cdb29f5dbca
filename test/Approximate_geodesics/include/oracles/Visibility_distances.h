// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_VISIBILITY_DISTANCES_H
#define APPROXIMATE_GEODESICS_TEST_VISIBILITY_DISTANCES_H

#include "meshes/test_soup.h"
#include "oracles/Quad.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace geodesics_test {

/*
 * The distances between all vertices of a small mesh, whatever its faces are like: needles, caps,
 * faces without area, edges without length. No code of the package is used.
 *
 * A shortest path between vertices consists of straight lines between vertices, across faces
 * unfolded into the plane. For each vertex, all faces that lines from there lead to are unfolded,
 * one after the other; and the vertices seen are joined by Floyd's and Warshall's algorithm. What
 * is seen through an edge is a cone between two vertices on the way. Cones are followed until
 * - they are narrower than `ROUNDING`. What is seen in one is as close to a path over the vertex
 *   on its side;
 * - all that they see is farther than the longest of the distances known from the vertex;
 * - they come to a face that they have been in: a shortest path does not come back to a face, as
 *   the straight line there is shorter, or as short;
 * - the edge ahead has no length: its ends are on the line, and one vertex for all distances.
 */
class Visibility_distances
{
public:
  explicit Visibility_distances(const Mesh& mesh)
    : m_mesh(mesh),
      m_size(mesh.num_vertices()),
      m_distance(m_size * m_size, infinite()),
      m_step(mesh.num_halfedges()),
      m_is_crossed(mesh.num_faces(), false)
  {
    measure_edges();
    for(const Halfedge h : mesh.halfedges())
      if(!mesh.is_border(h))
        m_step[h.idx()] = step(h);
    for(const Vertex v : mesh.vertices())
      if(!mesh.is_isolated(v))
        look_from(v);
    join();
  }

  Quad operator()(const Vertex s, const Vertex t) const { return m_distance[index(s, t)]; }

  // the number of faces that cones were followed across
  std::size_t number_of_cones() const { return m_number_of_cones; }

private:
  // Of angles, and of lengths as a part of them.
  static constexpr long double ROUNDING = 1e-24L;

  using Vector_3 = std::array<Quad, 3>;

  struct Vector_2
  {
    Quad x, y;

    Vector_2 operator+(const Vector_2& v) const { return {x + v.x, y + v.y}; }
  };

  // Where the third vertex of the face to the left of a halfedge is, in lengths of that: along it
  // from its source and back from its target, and to its left. Edges ahead follow from the edge by
  // a rotation and a scaling, and so have directions to the last digits, however short they are.
  struct Step
  {
    Quad along = 0, beyond = 0, across = 0;

    Vector_2 left(const Vector_2& edge) const
    {
      return {along * edge.x - across * edge.y, along * edge.y + across * edge.x};
    }
    Vector_2 right(const Vector_2& edge) const
    {
      return {beyond * edge.x + across * edge.y, beyond * edge.y - across * edge.x};
    }
  };

  // what is seen between two directions
  struct Cone
  {
    Vector_2 right, left;
  };

  static Quad infinite() { return std::numeric_limits<long double>::infinity(); }

  static Quad turn(const Vector_2& v, const Vector_2& w) { return v.x * w.y - v.y * w.x; }
  static Quad dot(const Vector_2& v, const Vector_2& w) { return v.x * w.x + v.y * w.y; }
  static Quad length(const Vector_2& v) { return quad_root(dot(v, v)); }

  static Quad dot(const Vector_3& v, const Vector_3& w)
  {
    return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
  }

  static Vector_3 cross(const Vector_3& v, const Vector_3& w)
  {
    return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
  }

  // whether `w` is to the left of `v`, or nearly straight ahead or behind
  static bool is_left_of(const Vector_2& v, const Vector_2& w)
  {
    const Quad t = turn(v, w);
    return t >= 0 || t * t <= ROUNDING * ROUNDING * dot(v, v) * dot(w, w);
  }

  static bool is_empty(const Cone& cone)
  {
    return is_left_of(cone.left, cone.right) && !(dot(cone.left, cone.right) < 0); // half a plane
  }

  std::size_t index(const Vertex s, const Vertex t) const { return s.idx() * m_size + t.idx(); }

  void lower(const Vertex s, const Vertex t, const Quad distance)
  {
    for(const std::size_t i : {index(s, t), index(t, s)})
      m_distance[i] = (std::min)(m_distance[i], distance);
  }

  Vector_3 way(const Halfedge h) const
  {
    const Point &p = m_mesh.point(m_mesh.source(h)), &q = m_mesh.point(m_mesh.target(h));
    return {Quad(q.x()) - p.x(), Quad(q.y()) - p.y(), Quad(q.z()) - p.z()};
  }

  Quad length(const Halfedge h) const { return quad_root(dot(way(h), way(h))); }

  void measure_edges()
  {
    for(const Vertex v : m_mesh.vertices())
      m_distance[index(v, v)] = 0;
    for(const Halfedge h : m_mesh.halfedges())
      lower(m_mesh.source(h), m_mesh.target(h), length(h));
    join();
  }

  void join()
  {
    for(const Vertex k : m_mesh.vertices())
      for(const Vertex s : m_mesh.vertices())
        for(const Vertex t : m_mesh.vertices())
          lower(s, t, m_distance[index(s, k)] + m_distance[index(k, t)]);
  }

  Step step(const Halfedge h) const
  {
    const Vector_3 base = way(h), right = way(m_mesh.next(h)), left = way(m_mesh.prev(h));
    const Quad square = dot(base, base);
    if(square == 0)
      return {};
    // of the two shorter sides, as the error of their product grows with them
    const bool has_longest_left = dot(left, left) > dot(right, right) && dot(left, left) > square;
    const bool has_longest_base = !has_longest_left && square > dot(right, right);
    const Vector_3 normal = cross(has_longest_base ? left : base, has_longest_left   ? right
                                                                  : has_longest_base ? right
                                                                                     : left);
    return {-dot(base, left) / square, -dot(base, right) / square,
            quad_root(dot(normal, normal)) / square};
  }

  void look_from(const Vertex v)
  {
    m_source = v;
    m_limit = 0;
    for(const Vertex t : m_mesh.vertices())
      if(m_distance[index(v, t)] < infinite())
        m_limit = (std::max)(m_limit, m_distance[index(v, t)]);
    for(const Halfedge to_v : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      const Halfedge h = m_mesh.opposite(to_v);
      const Vector_2 right{length(h), 0};
      if(m_mesh.is_border(h) || !(right.x > 0))
        continue;
      const Step& step = m_step[h.idx()];
      const Vector_2 left = step.left(right), edge = step.right(right);
      m_is_crossed[m_mesh.face(h).idx()] = true;
      look_across(m_mesh.opposite(m_mesh.next(h)), left, edge, {right, left});
      m_is_crossed[m_mesh.face(h).idx()] = false;
    }
  }

  // Into the face to the left of `h`, whose source and edge are there.
  void look_across(const Halfedge h, const Vector_2& left, const Vector_2& edge, const Cone& cone)
  {
    if(m_mesh.is_border(h) || m_is_crossed[m_mesh.face(h).idx()] || !(dot(edge, edge) > 0) ||
       is_empty(cone) || is_too_far(left, edge))
      return;
    ++m_number_of_cones;
    const Step& step = m_step[h.idx()];
    const Vector_2 left_edge = step.left(edge), right_edge = step.right(edge);
    const Vector_2 apex = left + left_edge;
    const bool is_left = is_left_of(cone.right, apex), is_right = is_left_of(apex, cone.left);
    if(is_left && is_right)
      lower(m_source, m_mesh.target(m_mesh.next(h)), length(apex));
    m_is_crossed[m_mesh.face(h).idx()] = true;
    if(is_left)
      look_across(m_mesh.opposite(m_mesh.next(h)), apex, right_edge,
                  {cone.right, is_right ? apex : cone.left});
    if(is_right)
      look_across(m_mesh.opposite(m_mesh.prev(h)), left, left_edge,
                  {is_left ? apex : cone.right, cone.left});
    m_is_crossed[m_mesh.face(h).idx()] = false;
  }

  bool is_too_far(const Vector_2& start, const Vector_2& edge) const
  {
    const Quad part = (std::min)((std::max)(-dot(start, edge) / dot(edge, edge), Quad(0)), Quad(1));
    const Vector_2 nearest{start.x + part * edge.x, start.y + part * edge.y};
    return dot(nearest, nearest) > m_limit * m_limit * (1 + ROUNDING);
  }

  const Mesh& m_mesh;
  const std::size_t m_size;
  std::vector<Quad> m_distance; // of pairs
  std::vector<Step> m_step;     // per halfedge
  std::vector<bool> m_is_crossed;
  Vertex m_source;
  Quad m_limit = 0;
  std::size_t m_number_of_cones = 0;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_VISIBILITY_DISTANCES_H
