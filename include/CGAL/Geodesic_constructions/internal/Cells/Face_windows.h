// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_FACE_WINDOWS_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_FACE_WINDOWS_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Exact_windows.h>
#include <CGAL/Geodesic_constructions/internal/Cells/Side_windows.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The owner of each face: the source whose windows reach it, if it is the only one. The windows of
 * such faces need not be found.
 */
class Face_owners
{
public:
  static constexpr std::size_t NONE = (std::numeric_limits<std::size_t>::max)();

  // At first, no face has an owner.
  explicit Face_owners(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation), m_owners(triangulation.number_of_halfedges(), NONE)
  {
  }

  std::size_t operator[](const Index h) const { return m_owners[h]; }

  void set(const Index h, const std::size_t source)
  {
    for(const Index side : m_triangulation.halfedges_of_face(h))
      m_owners[side] = source;
  }

private:
  const Intrinsic_triangulation& m_triangulation;
  std::vector<std::size_t> m_owners; // by halfedge
};

/*
 * Finds the windows of faces after a search, when all labels are known: for each point, there is a
 * window that sees it and knows its distance. Sights are given up as in the search. Sights are
 * followed twice: first to find which faces several sources reach, then to find their windows.
 */
template <typename Search>
class Face_windows
{
public:
  // All are referred to.
  Face_windows(const Intrinsic_triangulation& triangulation,
               const Exact_windows<Search>& windows,
               Face_owners& owners)
    : m_triangulation(triangulation),
      m_exact_windows(windows),
      m_owners(owners),
      m_sides(triangulation.number_of_halfedges())
  {
  }

  // Fixes the owners, which are determined before; windows are found afterwards, of faces without
  // an owner.
  void fix_owners() { m_are_owners_fixed = true; }

  // Adds the windows of a vertex that was reached from a source.
  void add_vertex(const Index v, const std::size_t source)
  {
    Visitor visitor{{{}, m_exact_windows}, *this, source, m_exact_windows.label(v)};
    m_exact_windows.follow_from_vertex(
        v,
        [&](const Index h, const Plane_vector right, const Plane_vector left) {
          if(is_wanted(h, source))
            add({h, true, source, visitor.label_of_tip, {0, 0}, right, left});
        },
        visitor);
  }

  // Adds the windows of a source that is not a vertex.
  void add_point(const Intrinsic_point& point, const double label, const std::size_t source)
  {
    Visitor visitor{{{}, m_exact_windows}, *this, source, label};
    constexpr double smallest_height = 1e-10; // below that, rounding decides where a side is
    m_exact_windows.follow_from_point(
        point, label,
        [&](const Index side, const Face_point&, const Plane_vector start, const Plane_vector end) {
          const Plane_vector edge = end - start;
          if(cross(start, end) > smallest_height * dot(edge, edge) && is_wanted(side, source))
            add(from_tip_in_plane(side, source, true, label, start, edge, start, end));
        },
        visitor);
  }

  // The windows, in no particular order.
  std::vector<Face_window> windows() &&
  {
    for(const Side_windows& side : m_sides)
      side.for_each([&](const Face_window& window) { m_windows.push_back(window); });
    return std::move(m_windows);
  }

private:
  struct Visitor : Exact_windows<Search>::Visitor
  {
    static constexpr bool wants_faces = true;

    void on_vertex(Index, const Sight_path&, const Sight&, Plane_vector, Plane_vector) {}

    void on_face(const Sight& sight, Plane_vector /* apex */)
    {
      check_for_interruption_at(found.m_number_of_sights++);
      if(found.is_wanted(sight.halfedge, source))
        found.add(from_tip_in_plane(sight.halfedge, source, false, label_of_tip, sight.left,
                                    sight.edge, sight.right_ray.direction,
                                    sight.left_ray.direction));
    }

    Face_windows& found;
    std::size_t source;
    double label_of_tip;
  };

  // `edge` is the vector of the halfedge, whose source is at `start`, where the tip is the origin.
  static Face_window from_tip_in_plane(const Index h,
                                       const std::size_t source,
                                       const bool has_tip_in_face,
                                       const double label,
                                       const Plane_vector start,
                                       const Plane_vector edge,
                                       const Plane_vector right,
                                       const Plane_vector left)
  {
    const auto unit = [](const Plane_vector v) { return 1 / length(v) * v; };
    const Plane_vector x_axis = unit(edge);
    return {h,
            has_tip_in_face,
            source,
            label,
            turned_right(-1. * start, x_axis),
            turned_right(unit(right), x_axis),
            turned_right(unit(left), x_axis)};
  }

  bool is_wanted(const Index h, const std::size_t source)
  {
    if(m_are_owners_fixed)
      return m_owners[h] == Face_owners::NONE;
    if(m_owners[h] != Face_owners::NONE && m_owners[h] != source)
      m_owners.set(h, Face_owners::NONE);
    return false;
  }

  void add(const Face_window& window)
  {
    if(!is_before(window.right, window.left)) // or NaN
      return;
    if(window.has_tip_in_face)
      m_windows.push_back(window);
    else if(window.tip.y < 0 && window.right.y > 0 && window.left.y > 0)
      m_sides[window.halfedge].insert(window, m_triangulation.length(window.halfedge), m_workspace);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Exact_windows<Search>& m_exact_windows;
  Face_owners& m_owners;
  bool m_are_owners_fixed = false;
  std::vector<Side_windows> m_sides; // of faces, by halfedge
  std::vector<Side_windows::Part> m_workspace;
  std::vector<Face_window> m_windows; // with a tip in the face
  std::size_t m_number_of_sights = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_FACE_WINDOWS_H
