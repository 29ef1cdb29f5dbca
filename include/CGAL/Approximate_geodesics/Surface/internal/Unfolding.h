// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_UNFOLDING_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_UNFOLDING_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The data for laying out the face to the left of a halfedge that is laid out.
struct Unfolded_face
{
  // The data for `h`, which starts from `source`. Also writes the position of the apex if
  // `position` is not null and there is a face.
  static Unfolded_face of(const Intrinsic_triangulation& triangulation,
                          const Index source,
                          const Index h,
                          Apex_position* const position = nullptr)
  {
    if(triangulation.is_border(h))
      return {null_index, null_index, null_index, triangulation.is_flipped(h), false, 0, 0};

    const auto left = triangulation.counterclockwise(source, h);
    const auto apex = triangulation.target(left);
    const auto right = triangulation.counterclockwise(apex, triangulation.opposite(left));
    const Apex_position p =
        apex_position(triangulation, h, triangulation.length(left), triangulation.length(right));
    if(position != nullptr)
      *position = p;
    return {apex,
            triangulation.is_border(left) ? null_index : left,
            triangulation.is_border(right) ? null_index : right,
            triangulation.is_flipped(h),
            triangulation.lines_may_return() || triangulation.is_in_new_face(h),
            p.along,
            p.across};
  }

  Index apex;  // the third vertex, or null_index if the halfedge is a border halfedge
  Index left;  // the halfedge from the source to the apex, or null_index if it is a border halfedge
  Index right; // likewise, the one from the apex to the target
  bool is_flipped;      // whether the halfedge is not one of the mesh
  bool may_return;      // whether a shortest path may return to the face
  double along, across; // of the apex: along the halfedge and to its left, in its lengths

  Plane_vector position_of_apex(const Plane_vector source, const Plane_vector target) const
  {
    const Plane_vector edge = target - source;
    return {source.x + along * edge.x - across * edge.y,
            source.y + along * edge.y + across * edge.x};
  }

  // The side from the source to the apex, if the vector of the halfedge is known.
  Plane_vector left_side(const Plane_vector edge) const
  {
    return {along * edge.x - across * edge.y, along * edge.y + across * edge.x};
  }
};

// Likewise the side from the apex to the target. `face` is the one to the left of `h`.
inline Plane_vector right_side(const Intrinsic_triangulation& triangulation,
                               const Index h,
                               const Unfolded_face& face,
                               const Plane_vector edge)
{
  constexpr double cancellation = 0x1p-10; // where this side is short
  double beyond = 1 - face.along;
  if(std::abs(beyond) < cancellation)
    beyond = apex_position(triangulation, triangulation.source(h), h).beyond;
  return {beyond * edge.x + face.across * edge.y, beyond * edge.y - face.across * edge.x};
}

/*
 * The data of all halfedges, computed in advance: unfolding then takes a few multiplications, and
 * no square root or division. `Face` is `Unfolded_face`, or derived from it.
 */
template <typename Face>
class Unfolded_faces
{
public:
  // Throws if a face violates the triangle inequality.
  explicit Unfolded_faces(const Intrinsic_triangulation& triangulation, const Loop& loop = Loop())
  {
    resize_in_huge_pages(m_faces, triangulation.number_of_halfedges());
    std::atomic<bool> is_any_without_shape(false);
    loop.run_blocks(
        triangulation.number_of_vertices(), [&](const std::size_t first, const std::size_t beyond) {
          const Intrinsic_triangulation& t = triangulation; // these two are kept in registers
          Face* const faces = m_faces.data();
          bool is_without_shape = false;
          for(Index v = static_cast<Index>(first); v < beyond; ++v)
            for(Index h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
            {
              faces[h] = Face::of(t, v, h);
              // a face without shape has no area, or one that underflows
              if(!(faces[h].across > 0 && t.length(h) >= t.smallest_perimeter) && !t.is_border(h) &&
                 !t.has_shape(h))
                is_without_shape = true;
            }
          if(is_without_shape)
            is_any_without_shape = true;
        });
    if(is_any_without_shape)
      triangulation.check_triangle_inequality();
  }

  const Face& operator[](const Index h) const { return m_faces[h]; }

  // `h` may be null_index.
  void prefetch(const Index h) const { internal::prefetch(m_faces.data(), h); }

  // Prefetches the lengths of the sides behind `h`, whose face was prefetched before.
  void prefetch_sides(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    triangulation.prefetch_length(m_faces[h].left);
    triangulation.prefetch_length(m_faces[h].right);
  }

  std::size_t memory() const { return memory_of(m_faces); }

private:
  std::vector<Face, Uninitialized_allocator<Face>> m_faces;
};

using Unfolding = Unfolded_faces<Unfolded_face>;

// The same interface for few faces: each is computed on request.
struct Unfolding_on_demand
{
  Unfolded_face operator[](const Index h) const
  {
    return Unfolded_face::of(triangulation, triangulation.source(h), h);
  }

  const Intrinsic_triangulation& triangulation;
};

// The same interface, if faces are needed several times in a row: those that were computed last are
// kept, in little memory. Each thread needs its own.
class Recent_unfolding
{
public:
  explicit Recent_unfolding(const Intrinsic_triangulation& triangulation)
    : m_on_demand{triangulation}, m_halfedges(SIZE, null_index), m_faces(SIZE)
  {
  }

  Unfolded_face operator[](const Index h) const
  {
    const Index i = h % SIZE;
    if(m_halfedges[i] != h)
    {
      m_halfedges[i] = h;
      m_faces[i] = m_on_demand[h];
    }
    return m_faces[i];
  }

private:
  static constexpr Index SIZE = 1 << 15;

  Unfolding_on_demand m_on_demand;
  mutable std::vector<Index> m_halfedges;
  mutable std::vector<Unfolded_face> m_faces; // of these
};

// Takes the last line from a stack of those to be followed. Returns whether there was one.
template <typename Stack, typename T>
bool pop(Stack& stack, T& last)
{
  if(stack.empty())
    return false;
  last = stack.back();
  stack.pop_back();
  return true;
}

// A halfedge that straight lines from the origin meet, laid out between two points.
struct Crossing
{
  Index halfedge = null_index;
  Plane_vector source = {0, 0}, target = {0, 0};

  Plane_vector point(const double t) const { return source + t * (target - source); }

  // Where a ray crosses the edge: 0 at the source, which is to its left, and 1 at the target;
  // `otherwise` if they are parallel.
  double part(const Plane_vector ray, const double otherwise) const
  {
    const double left = cross(ray, source), right = cross(ray, target);
    return left > right ? (std::clamp)(left / (left - right), 0., 1.) : otherwise;
  }
};

/*
 * Decides when to give up straight lines that come back to a halfedge.
 *
 * On a mesh in space, a segment in a face is a shortest path. So a shortest path meets a face only
 * once, while straight lines may wind around a spike many times. To detect that, lines remember
 * where they met one halfedge, and replace it by a later one each time the number of faces doubles,
 * as in Brent's cycle detection (R. P. Brent, An improved Monte Carlo factorization algorithm,
 * 1980).
 *
 * If only lengths are given, edges may wind around the surface like a spring, so that a shortest
 * path crosses them repeatedly. Then lines are given up if the path straight to the edge, where
 * they first met it, and then along the edge, is not longer. Faces that are thinner than rounding
 * errors are met only once in any case.
 */
class Winding
{
public:
  explicit Winding(const Intrinsic_triangulation& triangulation)
    : m_may_return(triangulation.lines_may_return()),
      m_number_of_edges(triangulation.number_of_halfedges() / 2)
  {
  }

  // Whether lines have crossed more edges than there are, and thus one of them twice, and are given
  // up. Between faces without area, their number could double with each face, and they grow by no
  // more than rounding errors. It is enough to ask at milestones.
  bool is_over(const std::uint32_t depth) const
  {
    return !m_may_return && depth > m_number_of_edges;
  }

  // Whether the lines between two rays are given up at a halfedge, given an earlier one. The next
  // face has this height, in lengths of the halfedge.
  bool is_over(const Crossing& here,
               const Crossing& earlier,
               const Plane_vector left_ray,
               const Plane_vector right_ray,
               const double height) const
  {
    constexpr double smallest_height = 1e-8;
    return here.halfedge == earlier.halfedge && (!m_may_return || !(height > smallest_height) ||
                                                 is_detour(here, earlier, left_ray, right_ray));
  }

  // Whether a line remembers the halfedge that it meets after `depth` faces.
  static bool is_milestone(const std::uint32_t depth) { return (depth & (depth + 1)) == 0; }

private:
  // Whether all points of the edge that the lines meet now are reached by an alternative path that
  // is not longer, up to rounding. It is enough to check both ends: outward along the edge from the
  // earlier points, the alternative grows by the length along the edge, and a line does not grow
  // faster; between these points, the alternative is a line as well, and which of two lines is
  // longer changes at most once along an edge.
  static bool is_detour(const Crossing& here,
                        const Crossing& earlier,
                        const Plane_vector left_ray,
                        const Plane_vector right_ray)
  {
    const double left = earlier.part(left_ray, 0), right = earlier.part(right_ray, 1);
    const double edge = length(here.target - here.source);
    const auto is_beaten = [&](const double t) {
      const double nearest = (std::clamp)(t, (std::min)(left, right), (std::max)(left, right));
      const double detour = length(earlier.point(nearest)) + std::abs(t - nearest) * edge;
      return detour <= length(here.point(t)) * (1 + 1e-12) + edge * 1e-15;
    };
    return is_beaten(here.part(left_ray, 0)) && is_beaten(here.part(right_ray, 1));
  }

  bool m_may_return;
  std::size_t m_number_of_edges;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_UNFOLDING_H
