// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_FACE_CELLS_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_FACE_CELLS_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Geodesic_constructions/internal/Cells/Face_windows.h>
#include <CGAL/Geodesic_constructions/internal/Cells/Hyperbola_branch.h>
#include <CGAL/Geodesic_constructions/internal/Cells/Window_cell.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// A part of the border between two cells, in a face.
struct Border_arc
{
  Index halfedge;                            // the first of the face
  std::size_t left, right;                   // the sources of the cells beside it
  std::vector<std::array<double, 3>> points; // barycentric coordinates
};

// A part of a side of a face where a window knows the smallest distance.
struct Side_part
{
  static constexpr double SHORTEST = 1e-7; // parts of this size can be due to rounding

  Index halfedge;
  double begin, end; // from the source to the target of the halfedge, as parts of its length
  Plane_vector tip;  // in the frame of the halfedge
  double label;      // of the tip; infinite if there is no tip, as only one source reaches the face
  std::size_t source;

  double distance(const double x) const { return label + length(Plane_vector{x - tip.x, tip.y}); }
};

// Whether two distances are the same, up to rounding.
inline bool are_equal(const double a, const double b)
{
  constexpr double rounding = 1e-8;
  return std::abs(a - b) <= rounding * (a + b);
}

// Which borders are wanted.
struct Cell_options
{
  bool within_cells;  // also those where two shortest paths from the same source meet
  double chord_error; // the largest distance of an arc from its polyline
};

// Whether two directions differ by more than rounding errors of labels can turn paths at a tip.
inline bool differ_in_direction(const Plane_vector a, const Plane_vector b)
{
  constexpr double smallest_angle = 1e-5;
  const double size = length(a) * length(b);
  return std::abs(cross(a, b)) > smallest_angle * size || (dot(a, b) < 0 && size > 0);
}

// How far areas of cells are from what is possible: none is negative, and those in a face are the
// face. This is more than rounding where positions of windows are lost to it.
struct Area_errors
{
  void add(const double error, const Index h)
  {
    sum += error;
    if(error > largest)
    {
      largest = error;
      face = h;
    }
  }

  double area = 0; // of the faces
  double sum = 0, largest = 0;
  Index face = null_index; // the first halfedge of that with the largest error
};

/*
 * Divides faces among their windows: finds the areas of cells, the arcs of borders in the faces,
 * and the parts of their sides, which are sorted by side and along it.
 */
class Face_cells
{
public:
  Face_cells(const Intrinsic_triangulation& triangulation,
             const Cell_options& options,
             std::vector<double>& areas,
             Area_errors& area_errors,
             std::vector<Border_arc>& arcs,
             std::vector<Side_part>& side_parts)
    : m_triangulation(triangulation),
      m_options(options),
      m_areas(areas),
      m_area_errors(area_errors),
      m_arcs(arcs),
      m_side_parts(side_parts)
  {
  }

  // Divides the face to the left of `h`, the first of the face, among the windows from `first` on.
  template <typename Iterator>
  void divide(const Index h, const Iterator first, const Iterator beyond)
  {
    const Face_layout layout(m_triangulation, h);
    m_face = h;
    for(std::size_t i = 0; i < 3; ++i)
    {
      m_corners[i] = layout.corner(i);
      m_edges[i] = layout.edge(i, (i + 1) % 3);
      m_halfedges[i] = layout.halfedge(i);
    }
    m_doubled_area = cross(m_edges[0], m_edges[1]);
    if(!(m_doubled_area > 0))
      return;
    for(std::size_t i = 0; i < 3; ++i)
      m_axes[i] = 1 / length(m_edges[i]) * m_edges[i];
    m_area_errors.area += m_doubled_area / 2;
    m_windows.clear();
    for(Iterator it = first; it != beyond; ++it)
      m_windows.push_back(placed(*it));
    const auto number_of_parts = static_cast<std::ptrdiff_t>(m_side_parts.size());
    is_thin() ? fill(nearest_to_center()) : divide();
    std::sort(m_side_parts.begin() + number_of_parts, m_side_parts.end(),
              [](const Side_part& p, const Side_part& q) {
                return std::make_pair(p.halfedge, p.begin) < std::make_pair(q.halfedge, q.begin);
              });
  }

private:
  using Segment = std::pair<Plane_vector, Plane_vector>; // relative to the tip of a window

  Placed_window placed(const Face_window& w) const
  {
    const auto side = static_cast<std::size_t>(
        std::find(m_halfedges.begin(), m_halfedges.end(), w.halfedge) - m_halfedges.begin());
    return {m_corners[side] + turned_left(w.tip, m_axes[side]),
            turned_left(w.right, m_axes[side]),
            turned_left(w.left, m_axes[side]),
            w.label,
            w.source,
            w.has_tip_in_face ? Placed_window::NO_SIDE : side};
  }

  // Whether the face is so thin that rounding errors across it would matter.
  bool is_thin() const
  {
    constexpr double smallest_height = 1e-5; // over the longest side, as a part of it
    const double squared = (std::max)(
        {dot(m_edges[0], m_edges[0]), dot(m_edges[1], m_edges[1]), dot(m_edges[2], m_edges[2])});
    return !(m_doubled_area > smallest_height * squared);
  }

  const Placed_window& nearest_to_center() const
  {
    const Plane_vector center = 1. / 3 * (m_corners[0] + m_corners[1] + m_corners[2]);
    const auto distance = [&](const Placed_window& w) {
      const Plane_vector way = center - w.tip;
      const bool is_seen = cross(w.right, way) >= 0 && cross(way, w.left) >= 0;
      return std::make_pair(!is_seen, w.label + length(way));
    };
    return *std::min_element(
        m_windows.begin(), m_windows.end(),
        [&](const Placed_window& w, const Placed_window& v) { return distance(w) < distance(v); });
  }

  // The whole face belongs to one window.
  void fill(const Placed_window& w)
  {
    m_areas[w.source] += m_doubled_area / 2;
    for(std::size_t i = 0; i < 3; ++i)
      add_side_part(i, m_corners[i] - w.tip, m_corners[(i + 1) % 3] - w.tip, w);
  }

  void divide()
  {
    Window_cell cell(m_corners, m_windows);
    double rest = m_doubled_area / 2, error = 0;
    for(std::size_t i = 0; i < m_windows.size(); ++i)
    {
      check_for_interruption();
      cell.find(i);
      const double area = report(cell, i);
      m_areas[m_windows[i].source] += area;
      error += (std::max)(-area, 0.);
      rest -= area;
    }
    m_area_errors.add(error + std::abs(rest), m_face);
  }

  // Returns the area of the cell.
  double report(const Window_cell& cell, const std::size_t number)
  {
    const Placed_window& w = cell.window();
    double result = 0;
    for(const Cell_piece& piece : cell.pieces())
    {
      if(piece.end == Cell_end::ENTRY)
        continue;
      const Focal_curve& curve = cell.curve(piece);
      const Segment end{curve.point(piece.range.begin), curve.point(piece.range.end)};
      Segment begin{{0, 0}, {0, 0}};
      if(w.has_entry())
      {
        begin = {cell.entry().point(piece.range.begin), cell.entry().point(piece.range.end)};
        add_side_part(w.entry, begin.second, begin.first, w);
      }
      result += area(w, piece, begin, end);
      if(piece.is_side())
        add_side_part(static_cast<std::size_t>(piece.end), end.first, end.second, w);
      else if(is_wanted(piece, number))
        add_arc(piece, number, end);
    }
    return result;
  }

  // The area between the side that the window is seen through and the piece.
  double area(const Placed_window& w,
              const Cell_piece& piece,
              const Segment& begin,
              const Segment& end) const
  {
    double result = cross(end.first - begin.second, end.second - begin.first) / 2;
    if(piece.end == Cell_end::EQUAL_DISTANCE)
      result += branch(w, m_windows[piece.other]).area_beside_chord(end.first, end.second);
    return std::isfinite(result) ? result : 0;
  }

  void add_side_part(const std::size_t side,
                     const Plane_vector begin,
                     const Plane_vector end,
                     const Placed_window& w)
  {
    const double squared = dot(m_edges[side], m_edges[side]);
    const Plane_vector tip = w.tip - m_corners[side];
    const auto part = [&](const Plane_vector p) { return dot(tip + p, m_edges[side]) / squared; };
    const double first = part(begin), last = part(end);
    if(last - first > Side_part::SHORTEST)
      m_side_parts.push_back(
          {m_halfedges[side], first, last, turned_right(tip, m_axes[side]), w.label, w.source});
  }

  // Both sides of an arc report it; one of them is enough. Only one side reports a ray; where it is
  // no border, another window is between the two, and narrower than rounding errors.
  bool is_wanted(const Cell_piece& piece, const std::size_t number) const
  {
    const Placed_window &w = m_windows[number], &v = m_windows[piece.other];
    const Plane_vector middle = piece.curve.point(piece.range.middle()),
                       from_other = middle + (w.tip - v.tip);
    if(piece.end == Cell_end::EQUAL_DISTANCE)
    {
      if(w.source > v.source || (w.source == v.source && number > piece.other))
        return false;
    }
    else if(!are_equal(w.label + length(middle), v.label + length(from_other)))
      return false;
    return w.source != v.source ||
           (m_options.within_cells && differ_in_direction(middle, from_other));
  }

  // Where the tips of two windows are at the same distance, relative to the first tip.
  static Hyperbola_branch branch(const Placed_window& w, const Placed_window& v)
  {
    return {v.tip - w.tip, w.label - v.label};
  }

  void add_arc(const Cell_piece& piece, const std::size_t number, const Segment& ends)
  {
    const Placed_window &w = m_windows[number], &v = m_windows[piece.other];
    const auto& [p, q] = ends;
    Border_arc arc{m_face, w.source, v.source, {}};
    const auto add = [&](const Plane_vector x) { arc.points.push_back(weights(w.tip + x)); };
    add(p);
    if(piece.end == Cell_end::EQUAL_DISTANCE)
      branch(w, v).for_each_between(p, q, m_options.chord_error, add);
    add(q);
    if(arc.left > arc.right)
    {
      std::swap(arc.left, arc.right);
      std::reverse(arc.points.begin(), arc.points.end());
    }
    const bool is_finite = std::all_of(arc.points.begin(), arc.points.end(), [](const auto& x) {
      return std::isfinite(x[0] + x[1] + x[2]);
    });
    if(is_finite)
      m_arcs.push_back(std::move(arc));
  }

  // Returns barycentric coordinates, which are exactly 0 for points on sides.
  std::array<double, 3> weights(const Plane_vector p) const
  {
    constexpr double rounding = 1e-9;
    std::array<double, 3> result;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t side = (i + 1) % 3;
      result[i] = cross(m_edges[side], p - m_corners[side]) / m_doubled_area;
      if(!(result[i] > rounding))
        result[i] = 0;
    }
    const double sum = result[0] + result[1] + result[2];
    for(double& weight : result)
      weight /= sum;
    return result;
  }

  const Intrinsic_triangulation& m_triangulation;
  const Cell_options& m_options;
  std::vector<double>& m_areas;
  Area_errors& m_area_errors;
  std::vector<Border_arc>& m_arcs;
  std::vector<Side_part>& m_side_parts;
  Index m_face = 0;
  std::array<Plane_vector, 3> m_corners{}, m_edges{}, m_axes{}; // the latter are unit vectors
  std::array<Index, 3> m_halfedges{};
  double m_doubled_area = 0;
  std::vector<Placed_window> m_windows;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_FACE_CELLS_H
