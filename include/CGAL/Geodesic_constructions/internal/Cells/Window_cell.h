// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_WINDOW_CELL_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_WINDOW_CELL_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Geodesic_constructions/internal/Cells/Focal_curve.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// What is seen of a face from a tip, in the frame of the face.
struct Placed_window
{
  static constexpr std::size_t NO_SIDE = 3;

  Plane_vector tip, right, left;
  double label;
  std::size_t source;
  std::size_t entry; // the side that it is seen through, or NO_SIDE

  bool has_entry() const { return entry != NO_SIDE; }
};

// What a part of the boundary of a window's cell is.
enum class Cell_end
{
  SIDE_0, // of the face
  SIDE_1,
  SIDE_2,
  EQUAL_DISTANCE,
  RIGHT_RAY, // of the other window
  LEFT_RAY,
  ENTRY // nothing of the window is in the cell
};

struct Cell_piece
{
  Direction_range range;
  Cell_end end;
  Focal_curve curve;
  std::size_t other; // the window on the other side, unless it is a side of the face

  bool is_side() const { return end <= Cell_end::SIDE_2; }
  bool is_same(const Cell_piece& p) const { return end == p.end && other == p.other; }
};

/*
 * The part of a window where no other window knows a smaller distance. Along a line from the tip,
 * no other distance grows faster. So once another one is smaller, it stays so: the cell is
 * star-shaped around the tip, and what bounds it is an envelope, found by merging one curve after
 * the other.
 *
 * Where two windows know the same distances, up to rounding, the first of them gets the cell; where
 * the tip of one is a point of the paths of the other, as behind a saddle vertex, the latter does.
 * The same decision is made in both of their cells, so that cells do not overlap.
 */
class Window_cell
{
public:
  // The arguments are referred to, not copied.
  Window_cell(const std::array<Plane_vector, 3>& corners, const std::vector<Placed_window>& windows)
    : m_face(corners), m_windows(windows)
  {
  }

  void find(const std::size_t number)
  {
    m_number = number;
    m_window = m_windows[number];
    set_sides();
    list_corners();
    for(std::size_t other = 0; other < m_windows.size() && !m_pieces.empty(); ++other)
      if(other != number && !is_beside(m_windows[other]))
        cut(other);
  }

  const std::vector<Cell_piece>& pieces() const { return m_pieces; }

  // The window has an entry.
  const Focal_curve& entry() const { return m_lines[m_window.entry]; }

  const Focal_curve& curve(const Cell_piece& piece) const
  {
    return piece.is_side() ? m_lines[static_cast<std::size_t>(piece.end)] : piece.curve;
  }

  const Placed_window& window() const { return m_window; }

private:
  // The curves that bound the region where another window knows a smaller distance. It begins at
  // the farthest of the upper bounds of 1 / r.
  struct Region
  {
    using Bound = std::pair<Cell_end, Focal_curve>;
    boost::container::static_vector<Bound, 4> upper;
    boost::container::static_vector<Bound, 2> lower;
    boost::container::static_vector<Plane_vector, 2> rays;
  };

  // A bound on errors of distances, as a part of them.
  static constexpr double ROUNDING = 1e-12;

  // Borders that are so close to a side, in lengths of the side, are on it. Otherwise, rounding
  // would decide in which face a border along an edge is, and differently in the two faces. So
  // sides are shifted inward while they are compared with other curves.
  static constexpr double CLOSE = 1e-10;

  Direction_range range() const { return {m_window.right, m_window.left}; }

  void set_sides()
  {
    m_pieces.clear();
    m_entry.reset();
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Plane_vector p = m_face[i] - m_window.tip, edge = m_face[(i + 1) % 3] - m_face[i];
      const double size = length(edge), distance = cross(p, edge) / size; // to the left
      m_lines[i] = Focal_curve::line(p, edge);
      const double shift = (std::min)(CLOSE * size, std::abs(distance) / 4);
      const Focal_curve shifted =
          Focal_curve::line(p + shift / size * Plane_vector{-edge.y, edge.x}, edge);
      if(i == m_window.entry)
      {
        if(!(distance < 0))
          return m_pieces.clear();
        m_entry = shifted;
      }
      else if(distance > ROUNDING * size)
      {
        const Cell_piece piece{range(), static_cast<Cell_end>(i), shifted, 0};
        if(m_pieces.empty())
          m_pieces.push_back(piece);
        else
          merge(piece);
      }
    }
    const bool is_bounded = std::all_of(m_pieces.begin(), m_pieces.end(), [](const auto& p) {
      return p.curve.at(p.range.middle()) > 0;
    });
    if(!is_bounded)
      m_pieces.clear();
  }

  // The corners of what the window sees of the face.
  void list_corners()
  {
    m_corners.clear();
    for(const Cell_piece& piece : m_pieces)
      for(const Plane_vector u : {piece.range.begin, piece.range.end})
        m_corners.push_back(curve(piece).point(u));
    for(const Plane_vector u : {m_window.right, m_window.left})
      m_corners.push_back(m_entry ? entry().point(u) : Plane_vector{0, 0});
  }

  // Whether no point of the face is seen through both windows. This quick test excludes most pairs.
  bool is_beside(const Placed_window& v) const
  {
    const Plane_vector tip = v.tip - m_window.tip;
    bool is_right = true, is_left = true;
    for(const Plane_vector p : m_corners)
    {
      is_right = is_right && cross(v.right, p - tip) <= 0;
      is_left = is_left && cross(v.left, p - tip) >= 0;
      if(!is_right && !is_left)
        return false;
    }
    return true;
  }

  void cut(const std::size_t other)
  {
    const Placed_window& v = m_windows[other];
    const Plane_vector focus = v.tip - m_window.tip;
    const double distance = length(focus), difference = m_window.label - v.label;
    const double rounding =
        ROUNDING * (m_window.label + v.label + length(m_window.tip) + length(v.tip) + distance);
    const bool is_never_nearer = -difference >= distance - rounding,
               is_always_nearer = difference >= distance - rounding;
    if(is_never_nearer && !(is_always_nearer && yields_to(other)))
      return;
    Region region;
    if(!is_always_nearer)
      region.upper.push_back({Cell_end::EQUAL_DISTANCE, Focal_curve::hyperbola(focus, difference)});
    if(m_entry)
      region.upper.push_back({Cell_end::ENTRY, *m_entry});
    add_ray(focus, v.right, Cell_end::RIGHT_RAY, rounding, region);
    add_ray(focus, -1. * v.left, Cell_end::LEFT_RAY, rounding, region);
    const bool is_outside =
        std::any_of(region.upper.begin(), region.upper.end(), [&](const Region::Bound& bound) {
          return !is_anywhere_nearer({range(), bound.first, bound.second, other});
        });
    if(!is_outside)
      cut(other, region);
  }

  bool yields_to(const std::size_t other) const
  {
    return std::make_pair(m_windows[other].source, other) <
           std::make_pair(m_window.source, m_number);
  }

  // The region lies to the left of a line through `p`.
  static void add_ray(const Plane_vector p,
                      const Plane_vector d,
                      const Cell_end end,
                      const double rounding,
                      Region& region)
  {
    const double side = cross(d, p);
    if(side > rounding)
      region.upper.push_back({end, Focal_curve::line(p, d)});
    else if(side < -rounding)
      region.lower.push_back({end, Focal_curve::line(p, d)});
    else
      region.rays.push_back(d);
  }

  void cut(const std::size_t other, const Region& region)
  {
    const Direction_range all = range();
    boost::container::static_vector<Plane_vector, 16> ends{all.begin, all.end};
    const auto add = [&](const Plane_vector u) { ends.push_back(u); };
    for(auto it = region.upper.begin(); it != region.upper.end(); ++it)
    {
      for(auto next = it + 1; next != region.upper.end(); ++next)
        (it->second - next->second).for_each_root(all, add);
      for(const Region::Bound& bound : region.lower)
        (it->second - bound.second).for_each_root(all, add);
    }
    for(const Plane_vector d : region.rays)
      Focal_curve{0, {-d.y, d.x}}.for_each_root(all, add);
    std::sort(ends.begin(), ends.end(),
              [](const Plane_vector u, const Plane_vector v) { return is_before(u, v); });
    // one curve bounds the region from each end to the next, and often farther
    const Region::Bound* bound = nullptr;
    Plane_vector begin = all.begin;
    for(std::size_t i = 1; i < ends.size(); ++i)
    {
      const Direction_range part{ends[i - 1], ends[i]};
      const Region::Bound* next = part.is_empty() ? bound : bound_at(part.middle(), region);
      if(next == bound)
        continue;
      cut(other, bound, {begin, part.begin});
      bound = next;
      begin = part.begin;
    }
    cut(other, bound, {begin, all.end});
  }

  // The curve where the region begins in a direction; none if it does not.
  static const Region::Bound* bound_at(const Plane_vector u, const Region& region)
  {
    static constexpr Region::Bound everywhere{Cell_end::ENTRY, {infinity, {0, 0}}};
    const Region::Bound* result = &everywhere;
    double value = infinity;
    for(const Region::Bound& bound : region.upper)
      if(const double at_u = bound.second.at(u); result == &everywhere || at_u < value)
      {
        result = &bound;
        value = at_u;
      }
    const bool is_in_region =
        std::all_of(region.lower.begin(), region.lower.end(),
                    [&](const auto& bound) { return value > bound.second.at(u); }) &&
        std::all_of(region.rays.begin(), region.rays.end(),
                    [&](const Plane_vector d) { return cross(d, u) > 0; });
    return is_in_region ? result : nullptr;
  }

  void cut(const std::size_t other, const Region::Bound* const bound, const Direction_range& part)
  {
    if(bound != nullptr && !part.is_empty())
      merge({part, bound->first, bound->second, other});
  }

  // Replaces the pieces that are farther than `piece`.
  void merge(const Cell_piece& piece)
  {
    m_merged.clear();
    for(const Cell_piece& old : m_pieces)
    {
      const Direction_range common{later(old.range.begin, piece.range.begin),
                                   earlier(old.range.end, piece.range.end)};
      if(common.is_empty())
      {
        append(old, old.range);
        continue;
      }
      append(old, {old.range.begin, common.begin});
      const Focal_curve difference = piece.curve - old.curve;
      boost::container::static_vector<Plane_vector, 4> ends{common.begin};
      difference.for_each_root(common, [&](const Plane_vector u) { ends.push_back(u); });
      if(ends.size() == 3 && is_before(ends[2], ends[1]))
        std::swap(ends[1], ends[2]);
      ends.push_back(common.end);
      for(std::size_t i = 1; i < ends.size(); ++i)
      {
        const Direction_range part{ends[i - 1], ends[i]};
        append(difference.is_positive_within(part) ? piece : old, part);
      }
      append(old, {common.end, old.range.end});
    }
    m_pieces.swap(m_merged);
  }

  bool is_anywhere_nearer(const Cell_piece& piece) const
  {
    return std::any_of(m_pieces.begin(), m_pieces.end(), [&](const Cell_piece& old) {
      const Direction_range common{later(old.range.begin, piece.range.begin),
                                   earlier(old.range.end, piece.range.end)};
      return !common.is_empty() && !((piece.curve - old.curve).maximum(common) <= 0);
    });
  }

  static Plane_vector later(const Plane_vector u, const Plane_vector v)
  {
    return is_before(u, v) ? v : u;
  }

  static Plane_vector earlier(const Plane_vector u, const Plane_vector v)
  {
    return is_before(u, v) ? u : v;
  }

  void append(const Cell_piece& piece, const Direction_range& part)
  {
    if(part.is_empty())
      return;
    if(!m_merged.empty() && m_merged.back().is_same(piece))
      m_merged.back().range.end = part.end;
    else
      m_merged.push_back({part, piece.end, piece.curve, piece.other});
  }

  const std::array<Plane_vector, 3>& m_face;
  const std::vector<Placed_window>& m_windows;
  std::size_t m_number = 0;
  Placed_window m_window{};
  std::array<Focal_curve, 3> m_lines;  // of the sides
  std::optional<Focal_curve> m_entry;  // shifted
  std::vector<Plane_vector> m_corners; // relative to the tip
  std::vector<Cell_piece> m_pieces, m_merged;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_WINDOW_CELL_H
