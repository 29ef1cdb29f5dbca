// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_EDGE_FLIPS_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_EDGE_FLIPS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A copy of a triangulation in which edges can be flipped: the two faces at an edge are laid out in
 * the plane, and the edge is replaced by their other diagonal. The surface does not change. Flipped
 * halfedges keep their numbers. Vertices can be added inside faces; their numbers, and those of
 * their halfedges, follow the others.
 */
class Edge_flips
{
public:
  struct Halfedge
  {
    Index target, opposite;
    Index counterclockwise, clockwise; // among those that start from the same vertex
    double length;
    bool is_new; // whether it was flipped, or starts from or ends at an added vertex
    bool is_border = false;
    Index hub = null_index;  // the hub that a flip took it from, if any: see `Balanced_fans`
    double corner = 0;       // at its source, the scalar product of the two sides of the face ...
    double doubled_area = 0; // ... to its left
  };

  // A halfedge that starts from an added vertex, and its direction: the angle to it, in the face of
  // the mesh that the vertex is in.
  struct Signpost
  {
    Index halfedge;
    double angle;
  };

  // A face whose height is at most this part of its longest side is nearly degenerate: rounding
  // errors of flips would change distances.
  static constexpr double SMALLEST_HEIGHT = 0x1p-14;

  // Throws if a face breaks the triangle inequality.
  explicit Edge_flips(const Intrinsic_triangulation& triangulation)
    : m_number_of_vertices(triangulation.number_of_vertices())
  {
    const std::size_t size = triangulation.number_of_halfedges();
    m_halfedges.reserve(size + size / 2); // copying them would take as long as making them
    bool has_area = true;
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
      for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
      {
        const Halfedge copied = copy(triangulation, v, h);
        has_area = has_area && (copied.doubled_area > 0 || copied.is_border);
        m_halfedges.push_back(copied);
      }
    if(!has_area) // a face that violates the triangle inequality has none
      triangulation.check_triangle_inequality();
  }

  const Halfedge& operator[](const Index h) const { return m_halfedges[h]; }

  Index number_of_vertices() const { return m_number_of_vertices; }
  Index number_of_halfedges() const { return static_cast<Index>(m_halfedges.size()); }

  bool is_border(const Index h) const { return m_halfedges[h].is_border; }

  // Returns the position of the third vertex of the face to the left of `h`, if `h` is laid out.
  Plane_vector position_of_apex(Index h, Plane_vector source, Plane_vector target) const;

  // Returns whether `h` is not a halfedge of the mesh.
  bool is_flipped(const Index h) const { return m_halfedges[h].is_new; }

  // Whether a flip took `h` from a hub.
  bool is_taken(const Index h) const { return m_halfedges[h].hub != null_index; }

  Index source(const Index h) const { return m_halfedges[m_halfedges[h].opposite].target; }

  Index next(const Index h) const { return m_halfedges[m_halfedges[h].opposite].clockwise; }

  std::array<Index, 3> halfedges_of_face(const Index h) const
  {
    const Index second = next(h);
    return {h, second, next(second)};
  }

  // Calls `f(h)` for the halfedges that start where `first` does, counterclockwise.
  template <typename F>
  void for_each_around(const Index first, F f) const
  {
    Index h = first;
    do
    {
      f(h);
      h = m_halfedges[h].counterclockwise;
    } while(h != first);
  }

  // Returns whether `h`, which starts from `hub`, can be flipped: its target then lies beyond the
  // new edge or on it, and the angle at the hub between the ends of the new edge is acute. Edges
  // taken from another hub are not flipped, so that other edges separate those of two hubs.
  bool can_flip(const Index hub, const Index h) const
  {
    const Index g = m_halfedges[h].opposite;
    if(is_taken(h) || is_border(h) || is_border(g))
      return false;
    const Quad quad = this->quad(h);
    for(const Index side : {quad.left_side, quad.left_rim, quad.right_rim, quad.right_side})
      if(is_taken(side) && m_halfedges[side].hub != hub)
        return false;
    if(!has_distinct_corners(quad))
      return false;
    const Diagonal other = other_diagonal(quad);
    const double left_area = m_halfedges[h].doubled_area, right_area = m_halfedges[g].doubled_area;
    return left_area > 0 && right_area > 0 &&
           cross(other.left, other.right) >= -ROUNDING * (left_area + right_area) &&
           dot(other.far_left, other.far_right) > 0;
  }

  // Flips `h`, which is taken from `hub`, unless that is null.
  // \pre `can_flip(hub, h)`, or `is_worse_than_flipped(h)`
  void flip(const Index hub, const Index h)
  {
    const Index g = m_halfedges[h].opposite;
    const Quad quad = this->quad(h);
    const auto [left, right, far_left, far_right] = other_diagonal(quad);
    const Plane_vector diagonal = left - right;
    const double beyond = cross(left, right);
    const double area = m_halfedges[h].doubled_area + m_halfedges[g].doubled_area;
    const bool is_straight = beyond <= ROUNDING * area; // and may be bent by rounding only
    const Index ends[2] = {m_halfedges[quad.right_side].target, m_halfedges[quad.left_rim].target};
    // both new faces satisfy the triangle inequality
    const double longest = length(quad.left_rim) + length(quad.right_rim);
    const double shortest = std::abs(length(quad.left_side) - length(quad.right_side));
    const double new_length =
        is_straight ? longest
                    : (std::max)(shortest, (std::min)(internal::length(diagonal), longest));

    remove(h);
    remove(g);
    connect(h, quad.right_rim, ends[1], hub, new_length);
    connect(g, quad.left_side, ends[0], hub, new_length);
    set_face({quad.left_rim, g, quad.right_rim},
             {dot(left, right), dot(left, diagonal), -dot(right, diagonal)},
             is_straight ? 0 : beyond);
    set_face({quad.right_side, h, quad.left_side},
             {dot(far_left, far_right), -dot(far_right, diagonal), dot(far_left, diagonal)},
             cross(far_right, far_left));
  }

  // Returns whether the edge is not locally Delaunay, can be flipped, and neither the two faces nor
  // the new ones are nearly degenerate.
  bool is_worse_than_flipped(Index h) const;

  // Returns the length of the other diagonal.
  double length_if_flipped(Index h) const;

  // Whether the face to the left of `h` is nearly degenerate.
  bool is_nearly_degenerate(Index h) const;

  // Whether a triangle with these sides and twice this area is not nearly degenerate.
  static bool is_sound(double doubled_area, double a, double b, double c);

  // Returns for each vertex a halfedge that starts from it, or null if it is isolated: the first
  // one that is not flipped, if any.
  std::vector<Index> first_halfedges() const
  {
    std::vector<Index> result(m_number_of_vertices, null_index);
    for(Index h = number_of_halfedges(); h-- > 0;)
      if(Index& first = result[source(h)];
         first == null_index || !is_flipped(h) || is_flipped(first))
        first = h;
    return result;
  }

  // Adds a vertex at `p` in the face to the left of `h`, in the plane where `h` starts from the
  // origin and is the x axis. `direction` is that of the x axis in the face of the mesh. Returns a
  // halfedge that starts from the new vertex.
  Index insert(Index h, Plane_vector p, Plane_vector direction);

  // The signposts of the added vertices.
  const std::vector<Signpost>& signposts() const { return m_signposts; }

private:
  // A bound of the errors of coordinates, relative to the distance from the hub.
  static constexpr double ROUNDING = 16 * std::numeric_limits<double>::epsilon();

  // The sides of the two faces at an edge, counterclockwise around both of them.
  struct Quad
  {
    Index diagonal;
    Index left_rim;   // from its target
    Index left_side;  // to its source
    Index right_side; // from its source
    Index right_rim;  // to its target
  };

  // The ends of the edge that replaces another one, which lies along x.
  struct Diagonal
  {
    Plane_vector left, right;         // seen from the target of the replaced edge
    Plane_vector far_left, far_right; // seen from its source
  };

  static Halfedge copy(const Intrinsic_triangulation& mesh, const Index v, const Index h)
  {
    const double length = mesh.length(h);
    Halfedge result{mesh.target(h),       mesh.opposite(h), mesh.counterclockwise(v, h),
                    mesh.clockwise(v, h), length,           false};
    result.is_border = mesh.is_border(h);
    if(!result.is_border)
    {
      const Apex_position apex = apex_position(mesh, v, h);
      result.corner = apex.along * length * length;
      result.doubled_area = apex.across * length * length;
    }
    return result;
  }

  Quad quad(const Index h) const
  {
    const auto left = halfedges_of_face(h), right = halfedges_of_face(m_halfedges[h].opposite);
    return {h, left[1], left[2], right[1], right[2]};
  }

  bool has_distinct_corners(const Quad& q) const
  {
    const Index target = m_halfedges[q.diagonal].target, left = m_halfedges[q.left_rim].target;
    const Index source = m_halfedges[q.left_side].target, right = m_halfedges[q.right_side].target;
    return left != right && left != source && right != source && left != target &&
           right != target && source != target;
  }

  Diagonal other_diagonal(const Quad& q) const
  {
    const Halfedge &h = m_halfedges[q.diagonal], &g = m_halfedges[h.opposite];
    const double height = h.doubled_area / h.length, depth = -g.doubled_area / h.length;
    return {{-corner(q.left_rim) / h.length, height},
            {-g.corner / h.length, depth},
            {h.corner / h.length, height},
            {corner(q.right_side) / h.length, depth}};
  }

  double corner(const Index h) const { return m_halfedges[h].corner; }
  double length(const Index h) const { return m_halfedges[h].length; }

  // Whether flipping the edge makes two faces that are not nearly degenerate.
  bool has_sound_flip(const Quad& q) const;

  // If `h` is the signpost of an added vertex, makes the next halfedge clockwise its signpost.
  void turn_signpost(const Index h)
  {
    const std::size_t number_of_others = m_number_of_vertices - m_signposts.size();
    const Index v = source(h);
    if(v < number_of_others || m_signposts[v - number_of_others].halfedge != h)
      return;
    Signpost& signpost = m_signposts[v - number_of_others];
    const Index next = m_halfedges[h].clockwise;
    signpost = {next, signpost.angle -
                          angle_of({m_halfedges[next].corner, m_halfedges[next].doubled_area})};
  }

  void remove(const Index h)
  {
    const Halfedge& old = m_halfedges[h];
    turn_signpost(h);
    m_halfedges[old.clockwise].counterclockwise = old.counterclockwise;
    m_halfedges[old.counterclockwise].clockwise = old.clockwise;
  }

  // Puts `h` behind another halfedge of its new source.
  void connect(const Index h, const Index clockwise, const Index target, const Index hub, double l)
  {
    const Index counterclockwise = m_halfedges[clockwise].counterclockwise;
    m_halfedges[h] = {target, m_halfedges[h].opposite, counterclockwise, clockwise, l, true, false,
                      hub};
    m_halfedges[clockwise].counterclockwise = h;
    m_halfedges[counterclockwise].clockwise = h;
  }

  void set_face(const std::array<Index, 3>& halfedges,
                const std::array<double, 3>& at_corner,
                const double doubled_area)
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      m_halfedges[halfedges[i]].corner = at_corner[i];
      m_halfedges[halfedges[i]].doubled_area = doubled_area;
    }
  }

  Index m_number_of_vertices;
  std::vector<Halfedge> m_halfedges;
  std::vector<Signpost> m_signposts; // of the added vertices, which are the last ones
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_EDGE_FLIPS_H
