// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_REFINED_NEEDLES_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_REFINED_NEEDLES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Balanced_fans.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The member functions of `Edge_flips` that only needles need.

inline Plane_vector Edge_flips::position_of_apex(const Index h,
                                                 const Plane_vector source,
                                                 const Plane_vector target) const
{
  const Plane_vector edge = target - source;
  const double scale = 1 / (m_halfedges[h].length * m_halfedges[h].length);
  const double along = m_halfedges[h].corner * scale;
  const double across = m_halfedges[h].doubled_area * scale;
  return {source.x + along * edge.x - across * edge.y, source.y + along * edge.y + across * edge.x};
}

inline bool
Edge_flips::is_sound(const double doubled_area, const double a, const double b, const double c)
{
  const double longest = (std::max)({a, b, c});
  return doubled_area > SMALLEST_HEIGHT * longest * longest;
}

inline bool Edge_flips::is_nearly_degenerate(const Index h) const
{
  const std::array<Index, 3> sides = halfedges_of_face(h);
  return !is_sound(m_halfedges[h].doubled_area, length(sides[0]), length(sides[1]),
                   length(sides[2]));
}

inline bool Edge_flips::is_worse_than_flipped(const Index h) const
{
  const Index g = m_halfedges[h].opposite;
  if(is_border(h) || is_border(g))
    return false;
  constexpr double rounding = 1e-9;
  const Quad q = this->quad(h);
  const double left_area = m_halfedges[h].doubled_area, right_area = m_halfedges[g].doubled_area;
  if(!(corner(q.left_side) * right_area + corner(q.right_rim) * left_area <
       -rounding * left_area * right_area))
    return false;
  return has_distinct_corners(q) && !is_nearly_degenerate(h) && !is_nearly_degenerate(g) &&
         has_sound_flip(q);
}

inline double Edge_flips::length_if_flipped(const Index h) const
{
  const Diagonal other = other_diagonal(quad(h));
  return internal::length(other.left - other.right);
}

inline Index Edge_flips::insert(const Index h, const Plane_vector p, const Plane_vector direction)
{
  const std::array<Index, 3> sides = halfedges_of_face(h);
  const Plane_vector corners[3] = {
      {0, 0}, {m_halfedges[h].length, 0}, position_of_apex(h, {0, 0}, {m_halfedges[h].length, 0})};
  const Index v = m_number_of_vertices++, first = number_of_halfedges();
  for(Index i = 0; i < 3; ++i) // `out` leads to the source of the side, `out` + 1 back
  {
    const Index side = sides[i], out = first + 2 * i, corner = source(side);
    const Index beyond = m_halfedges[side].counterclockwise;
    const double length = internal::length(p - corners[i]);
    m_halfedges.push_back({corner, out + 1, out, out, length, true});
    m_halfedges.push_back({v, out, beyond, side, length, true});
    m_halfedges[side].counterclockwise = out + 1;
    m_halfedges[beyond].clockwise = out + 1;
  }
  for(Index i = 0; i < 3; ++i)
  {
    const Index out = first + 2 * i, next_out = first + 2 * ((i + 1) % 3);
    m_halfedges[out].counterclockwise = next_out;
    m_halfedges[next_out].clockwise = out;
  }
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Plane_vector a = corners[i], b = corners[(i + 1) % 3];
    set_face(halfedges_of_face(sides[i]), {dot(b - a, p - a), dot(a - b, p - b), dot(a - p, b - p)},
             cross(b - a, p - a));
  }
  m_signposts.push_back({first, angle_of(turned_left(-1 * p, direction))});
  return first;
}

inline bool Edge_flips::has_sound_flip(const Quad& q) const
{
  const auto [left, right, far_left, far_right] = other_diagonal(q);
  const double diagonal = internal::length(left - right);
  return is_sound(cross(left, right), diagonal, length(q.left_rim), length(q.right_rim)) &&
         is_sound(cross(far_right, far_left), diagonal, length(q.left_side), length(q.right_side));
}

/*
 * Adds vertices inside needles, faces that are many times as long as their shortest side, if a mesh
 * has many of them: lines along a strip of them cross hundreds of faces before they meet a vertex.
 * The farther from the short sides, the fewer vertices are added, and edges are flipped until the
 * triangulation is locally Delaunay there. As distances between vertices grow in proportion to
 * those from the short sides, few are needed. Faces that are nearly degenerate stay as they are.
 */
class Refined_needles
{
public:
  // Faces that are longer than their shortest side by more than this are needles.
  static constexpr double LARGEST_ASPECT = 10;

  // Whether lines mostly cross needles. The number of needles that a line along a strip of them
  // crosses is about their length divided by their width. Those around hubs do not count, as fans
  // can be balanced, nor those that are nearly degenerate. In a small mesh, lines cross few faces
  // in any case.
  static bool are_useful(const Intrinsic_triangulation& mesh, const Loop& loop = Loop())
  {
    constexpr double most_faces = 8;
    if(mesh.number_of_halfedges() < 3 * SMALLEST_NUMBER_OF_FACES)
      return false;
    const std::size_t number_of_vertices = mesh.number_of_vertices(), size = Loop::SIZE_OF_BLOCK;
    std::vector<double> sums(number_of_vertices / size + 1);
    loop.run(sums.size(), [&](const std::size_t i, std::size_t /* thread */) {
      sums[i] = sum_of_needles(mesh, static_cast<Index>(i * size),
                               static_cast<Index>((std::min)((i + 1) * size, number_of_vertices)));
    });
    return std::accumulate(sums.begin(), sums.end(), 0.) > most_faces * mesh.number_of_halfedges();
  }

  // Refines the needles of the mesh that `flips` is a copy of. The number of flips is limited, in
  // case rounding errors make them cycle. Returns the positions of the added vertices.
  static std::vector<Intrinsic_point> refine(Edge_flips& flips, const std::size_t most_flips)
  {
    Refined_needles needles(flips, most_flips);
    needles.refine();
    return std::move(needles.m_positions);
  }

private:
  static constexpr Index SMALLEST_NUMBER_OF_FACES = 400;

  // Vertices are added at this height above a short side, in its lengths, and at heights that grow
  // by this factor ...
  static constexpr double FIRST_HEIGHT = 8, GROWTH = 4;
  // ... unless another vertex is closer than this part of that height, or the apex is too close.
  static constexpr double SMALLEST_GAP = 0.65, WIDTH_OF_COVER = 1.25, LARGEST_PART = 0.6;

  // Edges no farther from a new vertex than this, in its heights, are flipped immediately. The
  // others are flipped after its neighbors are added, which would undo most of these flips.
  static constexpr double WIDTH_OF_FLIPS = 1.05, LARGEST_GAIN = 0.9;

  // A needle of the mesh, laid out: its short side starts from the origin and lies along x.
  struct Needle
  {
    Index short_side; // the needle is to its left
    double length;
    Plane_vector apex;
  };

  // A face of the triangulation, to the left of a halfedge, laid out beside a needle.
  struct Place
  {
    Index halfedge;
    Plane_vector source, target, apex;
  };

  Refined_needles(Edge_flips& flips, const std::size_t most_flips)
    : m_flips(flips),
      m_flips_left(most_flips),
      m_number_of_vertices(flips.number_of_vertices()),
      m_covered(flips.number_of_vertices(), 0)
  {
  }

  // Adds up, at these vertices, how many times as long as wide needles are.
  static double
  sum_of_needles(const Intrinsic_triangulation& mesh, const Index first, const Index beyond)
  {
    constexpr double largest = 1e3;
    double result = 0;
    for(Index v = first; v < beyond; ++v)
      for(Index h = mesh.first_halfedge(v); h < mesh.beyond_halfedge(v); ++h)
      {
        const double a = mesh.length(h), b = mesh.length(mesh.counterclockwise(v, h));
        const double shorter = (std::min)(a, b), longer = (std::max)(a, b);
        if(longer > LARGEST_ASPECT * shorter && shorter > Edge_flips::SMALLEST_HEIGHT * longer &&
           !mesh.is_border(h) && !is_at_hub(mesh, v, h))
          result += (std::min)(largest, longer / shorter);
      }
    return result;
  }

  static bool is_at_hub(const Intrinsic_triangulation& mesh, const Index v, const Index h)
  {
    for(const Index corner : {v, mesh.target(h), mesh.target(mesh.counterclockwise(v, h))})
      if(mesh.degree(corner) > Balanced_fans::LARGEST_DEGREE / 2)
        return true;
    return false;
  }

  void refine()
  {
    std::vector<Needle> needles = this->needles();
    for(const Needle& needle : needles)
    {
      m_far_edges.push_back(m_flips.next(needle.short_side));
      flip_far_edges();
    }
    // If the faces around a vertex are needles, the lines from the middles of their short sides all
    // lead to it, and the next vertex would lie on an edge to the previous one.
    double start = 0.5;
    for(double height = FIRST_HEIGHT; !needles.empty(); height *= GROWTH)
    {
      // on the line to the apex from the part `start` of the short side, if no vertex is close by
      const auto has_none = [&](const Needle& n) {
        return !add_vertex(n, height * n.length, start);
      };
      needles.erase(std::remove_if(needles.begin(), needles.end(), has_none), needles.end());
      flip_far_edges();
      start = start < 0.5 ? 0.875 : 0.125;
    }
  }

  std::vector<Needle> needles() const
  {
    std::vector<Needle> result;
    for(Index h = 0; h < m_flips.number_of_halfedges(); ++h)
    {
      const std::array<Index, 3> sides = m_flips.halfedges_of_face(h);
      const double base = m_flips[h].length;
      if(!m_flips.is_border(h) && m_flips[sides[2]].length > LARGEST_ASPECT * base &&
         m_flips[sides[1]].length > base && !m_flips.is_nearly_degenerate(h))
        result.push_back({h, base, m_flips.position_of_apex(h, {0, 0}, {base, 0})});
    }
    return result;
  }

  // Flips edges until these, and all edges of changed faces, are locally Delaunay. Edges along
  // strips stay where the other diagonal is about as long.
  void flip_far_edges()
  {
    while(!m_far_edges.empty())
    {
      const Index h = m_far_edges.back();
      m_far_edges.pop_back();
      if(m_flips_left == 0 || !(m_flips.length_if_flipped(h) < LARGEST_GAIN * m_flips[h].length) ||
         !m_flips.is_worse_than_flipped(h))
        continue;
      const Index g = m_flips[h].opposite;
      for(const Index side : {m_flips.next(h), m_flips.next(m_flips.next(h)), m_flips.next(g),
                              m_flips.next(m_flips.next(g))})
        m_far_edges.push_back(side);
      m_flips.flip(null_index, h);
      --m_flips_left;
    }
  }

  // Flips edges opposite to a new vertex, from the sides of the face that it is in, until those
  // within this distance are locally Delaunay.
  void flip_edges_around(const std::array<Index, 3>& sides, const double radius)
  {
    m_near_edges.assign(sides.begin(), sides.end());
    while(!m_near_edges.empty())
    {
      const Index h = m_near_edges.back();
      m_near_edges.pop_back();
      if(m_flips[h].doubled_area > radius * m_flips[h].length)
        m_far_edges.push_back(h);
      else if(m_flips_left > 0 && m_flips.is_worse_than_flipped(h))
      {
        const Index side = m_flips.next(m_flips[h].opposite);
        m_near_edges.push_back(side);
        m_near_edges.push_back(m_flips.next(side));
        m_flips.flip(null_index, h);
        --m_flips_left;
      }
    }
  }

  // Adds a vertex at this distance from a short side, if there is room for it.
  bool add_vertex(const Needle& needle, const double distance, const double start)
  {
    const Index h = needle.short_side;
    const Plane_vector origin{start * needle.length, 0}, to_apex = needle.apex - origin;
    const double part = distance / length(to_apex);
    if(!(part < LARGEST_PART) || m_flips.is_flipped(h) || m_covered[m_flips[h].target] >= distance)
      return false;
    const Plane_vector p = origin + part * to_apex;
    const std::optional<Place> place = find_place(h, origin, p);
    if(!place || !is_free(*place, p, SMALLEST_GAP * distance))
      return false;
    const auto sides = m_flips.halfedges_of_face(place->halfedge);
    const Plane_vector edge = place->target - place->source, x = 1 / length(edge) * edge;
    const Plane_vector way = p - place->source;
    const Index first = m_flips.insert(place->halfedge, {dot(x, way), cross(x, way)}, x);
    m_positions.push_back(Intrinsic_point::in_face(h, start * (1 - part), part));
    flip_edges_around(sides, WIDTH_OF_FLIPS * distance);
    // there is no room for another vertex in needles whose short side ends at a neighbor this close
    m_flips.for_each_around(first, [&](const Index g) {
      const Index v = m_flips[g].target;
      if(v < m_number_of_vertices && m_flips[g].length < WIDTH_OF_COVER * distance)
        m_covered[v] = distance;
    });
    return true;
  }

  // The face that contains `p`, which is reached along the segment from `origin`, a point of `h`.
  std::optional<Place>
  find_place(const Index h, const Plane_vector origin, const Plane_vector p) const
  {
    constexpr int most_steps = 1000;
    Place place{h, {0, 0}, {m_flips[h].length, 0}, {0, 0}};
    for(int i = 0; i < most_steps && !m_flips.is_border(place.halfedge); ++i)
    {
      place.apex = m_flips.position_of_apex(place.halfedge, place.source, place.target);
      const Index right = m_flips.next(place.halfedge);
      const bool goes_right = cross(p - origin, place.apex - origin) > 0;
      const Plane_vector end = goes_right ? place.target : place.source;
      const double side = cross(place.apex - end, p - end);
      if(goes_right ? side >= 0 : side <= 0)
        return place;
      (goes_right ? place.source : place.target) = place.apex;
      place.halfedge = m_flips[goes_right ? right : m_flips.next(right)].opposite;
    }
    return std::nullopt;
  }

  // Whether no corner of a face is closer than `gap`, and no face is nearly degenerate with `p`.
  bool is_free(const Place& place, const Plane_vector p, const double gap) const
  {
    if(m_flips.is_nearly_degenerate(place.halfedge))
      return false;
    const Plane_vector corners[3] = {place.source, place.target, place.apex};
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Plane_vector side = corners[(i + 1) % 3] - corners[i], spoke = p - corners[i];
      if(!(length(spoke) >= gap &&
           Edge_flips::is_sound(cross(side, spoke), length(side), length(spoke),
                                length(p - corners[(i + 1) % 3]))))
        return false;
    }
    return true;
  }

  Edge_flips& m_flips;
  std::size_t m_flips_left;
  Index m_number_of_vertices; // of the mesh
  std::vector<Intrinsic_point> m_positions;
  std::vector<Index> m_near_edges, m_far_edges; // that may have to be flipped
  std::vector<double> m_covered; // per vertex of the mesh, how far from it there are added ones
};

// Returns a summary of the lengths of edges. Nodes in needles are far closer to each other than
// most edges are long, so the mean is that of the shortest edge of each node.
inline Arc_lengths summarize_edges(const Intrinsic_triangulation& refined)
{
  Arc_lengths result = summarize_arc_lengths(refined.lengths());
  double sum = 0;
  for(Index v = 0; v < refined.number_of_vertices(); ++v)
    if(refined.degree(v) > 0)
      sum += *std::min_element(refined.lengths().begin() + refined.first_halfedge(v),
                               refined.lengths().begin() + refined.beyond_halfedge(v));
  result.mean = sum / refined.number_of_vertices();
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_REFINED_NEEDLES_H
