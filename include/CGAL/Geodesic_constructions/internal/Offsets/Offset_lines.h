// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_OFFSET_LINES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_OFFSET_LINES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// A polyline at one of several distances.
struct Offset_line
{
  std::size_t number; // of the distance
  bool is_closed;
  std::vector<Intrinsic_point> points;
};

/*
 * Polylines that are found piece by piece, in any order. At each point, at most one piece ends, and
 * at most one starts.
 */
class Offset_lines
{
public:
  std::size_t number_of_points() const { return m_points.size(); }

  // Adds a point of a line at the distance with this number.
  void add_point(const std::size_t number, const Intrinsic_point& point)
  {
    m_points.push_back({number, point, none, false});
  }

  void add_piece(const std::size_t from, const std::size_t to)
  {
    m_points[from].next = to;
    m_points[to].has_previous = true;
  }

  // Returns the lines, ordered by distance.
  std::vector<Offset_line> lines(const Intrinsic_triangulation& triangulation) const
  {
    std::vector<Offset_line> result;
    std::vector<bool> is_done(m_points.size());
    for(const bool is_closed : {false, true}) // those that end at a border come first
      for(std::size_t i = 0; i < m_points.size(); ++i)
      {
        check_for_interruption_at(i);
        if(is_done[i] || (!is_closed && m_points[i].has_previous))
          continue;
        Offset_line line{m_points[i].number, is_closed, {}};
        for(std::size_t j = i; j != none && !is_done[j]; j = m_points[j].next)
        {
          is_done[j] = true;
          const Intrinsic_point& p = m_points[j].point;
          if(line.points.empty() || !p.is_same(line.points.back(), triangulation))
            line.points.push_back(p);
        }
        while(is_closed && line.points.size() > 1 &&
              line.points.back().is_same(line.points.front(), triangulation))
          line.points.pop_back();
        if(line.points.size() > 1)
          result.push_back(std::move(line));
      }
    std::stable_sort(result.begin(), result.end(), [](const Offset_line& a, const Offset_line& b) {
      return a.number < b.number;
    });
    return result;
  }

private:
  struct Point
  {
    std::size_t number; // of the distance
    Intrinsic_point point;
    std::size_t next;
    bool has_previous;
  };

  static constexpr std::size_t none = std::size_t(-1);

  std::vector<Point> m_points;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_OFFSET_LINES_H
