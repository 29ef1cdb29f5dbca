// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_REFINED_NEEDLES_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_REFINED_NEEDLES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Apex_position.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Balanced_fans.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Edge_flips.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Flipped_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Another triangulation of the same surface, for meshes with many needles, faces that are many
 * times as long as their shortest side: lines along a strip of them cross hundreds of faces before
 * they meet a vertex. Vertices are added inside the needles, the farther from the short sides the
 * fewer, and edges are flipped until the triangulation is locally Delaunay there. As distances
 * between vertices grow in proportion to those from the short sides, few are needed.
 */
class Refined_needles
{
public:
  using Index = Intrinsic_triangulation::Index;

  // Faces that are longer than their shortest side by more than this are needles.
  static constexpr double LARGEST_ASPECT = 10;

  // Whether lines cross needles for the most part. A line along a strip of them crosses about as
  // many as they are long, in widths. Those around hubs do not count, as fans can be balanced.
  // Small meshes have no long strips. Next to nearly degenerate faces, rounding would change
  // lengths.
  static bool are_useful(const Intrinsic_triangulation& mesh)
  {
    constexpr double most_faces = 8, largest = 1e3, nearly_degenerate = 1e4;
    if(mesh.number_of_halfedges() < 3 * SMALLEST_NUMBER_OF_FACES)
      return false;
    double sum = 0;
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(Index h = mesh.first_halfedge(v); h < mesh.beyond_halfedge(v); ++h)
      {
        const double a = mesh.length(h), b = mesh.length(mesh.counterclockwise(v, h));
        const double shorter = (std::min)(a, b), longer = (std::max)(a, b);
        if(!(longer < nearly_degenerate * shorter) && !mesh.is_border(h))
          return false;
        if(longer > LARGEST_ASPECT * shorter && shorter > 0 && !mesh.is_border(h) &&
           !is_at_hub(mesh, v, h))
          sum += (std::min)(largest, longer / shorter);
      }
    return sum > most_faces * mesh.number_of_halfedges();
  }

  // Throws if a face of `mesh` breaks the triangle inequality.
  explicit Refined_needles(const Intrinsic_triangulation& mesh)
    : m_number_of_vertices(mesh.number_of_vertices()), m_covered(mesh.number_of_vertices(), 0)
  {
    mesh.check_triangle_inequality();
    Edge_flips flips(mesh);
    std::vector<Index> bases = short_sides(mesh);
    flip_edges_around(bases, flips);
    for(double height = FIRST_HEIGHT; !bases.empty(); height *= GROWTH)
      bases = add_vertices(mesh, bases, height, flips);
    m_flipped = Flipped_triangulation(mesh, flips);
    m_covered = std::vector<double>();
  }

  const Intrinsic_triangulation& triangulation() const { return m_flipped.triangulation(); }

  // Whether a halfedge of the mesh is none of this triangulation.
  bool is_lost(const Index h) const { return m_flipped.is_lost(h); }

  // Where an added vertex is in the mesh.
  const Intrinsic_point& position(const Index v) const
  {
    return m_positions[v - m_number_of_vertices];
  }

  std::size_t memory() const
  {
    return m_flipped.memory() + m_positions.capacity() * sizeof(Intrinsic_point);
  }

private:
  static constexpr std::size_t SMALLEST_NUMBER_OF_FACES = 1200;

  // Vertices are added so far above a short side, in its lengths, and so many times as far ...
  static constexpr double FIRST_HEIGHT = 8, GROWTH = 4;
  // ... unless there is one that is closer than this part of it, or it is too close to the apex.
  static constexpr double SMALLEST_GAP = 0.65, WIDTH_OF_COVER = 1.15, LARGEST_PART = 0.6;

  // A face of the triangulation, to the left of a halfedge, laid out in the plane.
  struct Place
  {
    Index halfedge;
    Plane_vector source, target, apex;
  };

  static bool is_at_hub(const Intrinsic_triangulation& mesh, const Index v, const Index h)
  {
    for(const Index corner : {v, mesh.target(h), mesh.target(mesh.counterclockwise(v, h))})
      if(mesh.degree(corner) > Balanced_fans::LARGEST_DEGREE / 2)
        return true;
    return false;
  }

  // The short sides of needles, as halfedges that have the needle to their left.
  static std::vector<Index> short_sides(const Intrinsic_triangulation& mesh)
  {
    std::vector<Index> result;
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(Index h = mesh.first_halfedge(v); h < mesh.beyond_halfedge(v); ++h)
      {
        const double base = mesh.length(h);
        if(mesh.is_border(h) ||
           !(mesh.length(mesh.counterclockwise(v, h)) > LARGEST_ASPECT * base && base > 0))
          continue;
        if(mesh.length(mesh.next(h)) > base && apex_position(mesh, v, h).across > 0)
          result.push_back(h);
      }
    return result;
  }

  static void flip_edges_around(const std::vector<Index>& bases, Edge_flips& flips)
  {
    std::vector<Index> edges;
    for(const Index h : bases)
    {
      edges.push_back(flips.next(h));
      flip_edges(edges, flips);
    }
  }

  // Flips edges until these are locally Delaunay, and those that change on the way.
  static void flip_edges(std::vector<Index>& edges, Edge_flips& flips)
  {
    while(!edges.empty())
    {
      const Index h = edges.back();
      edges.pop_back();
      if(!flips.is_worse_than_flipped(h))
        continue;
      const Index g = flips[h].opposite;
      for(const Index side :
          {flips.next(h), flips.next(flips.next(h)), flips.next(g), flips.next(flips.next(g))})
        edges.push_back(side);
      flips.flip(flips[g].target, h);
    }
  }

  // Adds vertices above those short sides that have none close by. Returns those sides.
  std::vector<Index> add_vertices(const Intrinsic_triangulation& mesh,
                                  const std::vector<Index>& bases,
                                  const double height,
                                  Edge_flips& flips)
  {
    std::vector<Index> result, edges;
    for(const Index h : bases)
    {
      const Plane_vector p = middle(mesh, h), to_apex = apex(mesh, h) - p;
      const double distance = height * mesh.length(h), part = distance / length(to_apex);
      if(!(part < LARGEST_PART) || flips.is_flipped(h) || m_covered[mesh.target(h)] >= distance)
        continue;
      const std::optional<Place> place = find_place(flips, h, p, p + part * to_apex);
      if(!place || !is_free(*place, p + part * to_apex, SMALLEST_GAP * distance))
        continue;
      for(const Index side : flips.halfedges_of_face(place->halfedge))
        edges.push_back(side);
      const Index first = insert(flips, *place, p + part * to_apex);
      m_positions.push_back(Intrinsic_point::in_face(h, (1 - part) / 2, part));
      flip_edges(edges, flips);
      cover(flips, first, distance);
      result.push_back(h);
    }
    return result;
  }

  static Plane_vector middle(const Intrinsic_triangulation& mesh, const Index h)
  {
    return {mesh.length(h) / 2, 0};
  }

  // The third vertex of the face to the left of `h`, which starts from the origin and lies along x.
  static Plane_vector apex(const Intrinsic_triangulation& mesh, const Index h)
  {
    const Apex_position apex = apex_position(mesh, mesh.source(h), h);
    return mesh.length(h) * Plane_vector{apex.along, apex.across};
  }

  // The face at the end of the segment from `middle`, on `h`, to `p`.
  static std::optional<Place> find_place(const Edge_flips& flips,
                                         const Index h,
                                         const Plane_vector middle,
                                         const Plane_vector p)
  {
    constexpr int most_steps = 1000;
    Place place{h, {0, 0}, {flips[h].length, 0}, {0, 0}};
    for(int i = 0; i < most_steps && !flips.is_border(place.halfedge); ++i)
    {
      place.apex = flips.position_of_apex(place.halfedge, place.source, place.target);
      const Index right = flips.next(place.halfedge);
      const bool goes_right = cross(p - middle, place.apex - middle) > 0;
      const Plane_vector end = goes_right ? place.target : place.source;
      const double side = cross(place.apex - end, p - end);
      if(goes_right ? side >= 0 : side <= 0)
        return place;
      (goes_right ? place.source : place.target) = place.apex;
      place.halfedge = flips[goes_right ? right : flips.next(right)].opposite;
    }
    return std::nullopt;
  }

  static bool is_free(const Place& place, const Plane_vector p, const double gap)
  {
    constexpr double smallest_part = 1e-6;
    const Plane_vector corners[3] = {place.source, place.target, place.apex};
    const double area = cross(place.target - place.source, place.apex - place.source);
    for(std::size_t i = 0; i < 3; ++i)
      if(!(length(p - corners[i]) >= gap &&
           cross(corners[(i + 1) % 3] - corners[i], p - corners[i]) > smallest_part * area))
        return false;
    return true;
  }

  // Notes the vertices around a new one, from which `h` starts, that are closer than this: above
  // their short sides there is no room.
  void cover(const Edge_flips& flips, const Index h, const double distance)
  {
    Index g = h;
    do
    {
      const Index v = flips[g].target;
      if(v < m_number_of_vertices && flips[g].length < WIDTH_OF_COVER * distance)
        m_covered[v] = distance;
      g = flips[g].counterclockwise;
    } while(g != h);
  }

  static Index insert(Edge_flips& flips, const Place& place, const Plane_vector p)
  {
    const Plane_vector edge = place.target - place.source;
    const Plane_vector x = 1 / length(edge) * edge;
    return flips.insert(place.halfedge, {dot(x, p - place.source), cross(x, p - place.source)});
  }

  Index m_number_of_vertices; // of the mesh
  std::vector<Intrinsic_point> m_positions;
  std::vector<double> m_covered; // while vertices are added, how far from each one there are any
  Flipped_triangulation m_flipped;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_REFINED_NEEDLES_H
