// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_POLYGONAL_DOMAIN_H
#define APPROXIMATE_GEODESICS_TEST_POLYGONAL_DOMAIN_H

#include "meshes/developed_surfaces.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace geodesics_test {

struct Rectangle
{
  int x, y, end_of_x, end_of_y;

  bool contains_cell(const int i, const int j) const
  {
    return x <= i && i < end_of_x && y <= j && j < end_of_y;
  }

  bool has_inside(const int i, const int j) const
  {
    return x < i && i < end_of_x && y < j && j < end_of_y;
  }
};

/*
 * A rectangle of cells without some open rectangles, its walls: shortest paths in it are the
 * shortest ones over corners of these that see each other. Walls may overlap; where two only touch,
 * there would be a way between them.
 */
class Polygonal_domain
{
public:
  Polygonal_domain(const int columns, const int rows, std::vector<Rectangle> walls)
    : m_columns(columns), m_rows(rows), m_walls(std::move(walls))
  {
    for(const Rectangle& w : m_walls)
      for(const int x : {w.x, w.end_of_x})
        for(const int y : {w.y, w.end_of_y})
          if(0 < x && x < columns && 0 < y && y < rows)
            m_corners.push_back({Long(x), Long(y)});
    for(const Place& p : m_corners)
    {
      m_between.emplace_back();
      for(const Place& q : m_corners)
        m_between.back().push_back(line(p, q));
    }
    join_corners();
  }

  Long distance(const Place& p, const Place& q) const
  {
    Long result = line(p, q);
    for(std::size_t i = 0; i < m_corners.size(); ++i)
      for(std::size_t j = 0; j < m_corners.size(); ++j)
        if(m_between[i][j] < infinity)
          result =
              (std::min)(result, line(p, m_corners[i]) + m_between[i][j] + line(m_corners[j], q));
    return result;
  }

  bool has_cell(const int i, const int j) const
  {
    return std::none_of(m_walls.begin(), m_walls.end(),
                        [&](const Rectangle& w) { return w.contains_cell(i, j); });
  }

  // Not at the border.
  bool has_inside(const int i, const int j) const
  {
    return has_cell(i, j) && has_cell(i - 1, j) && has_cell(i, j - 1) && has_cell(i - 1, j - 1) &&
           0 < i && i < m_columns && 0 < j && j < m_rows;
  }

  int columns() const { return m_columns; }
  int rows() const { return m_rows; }

private:
  // The length of the straight line between two points if they see each other.
  Long line(const Place& p, const Place& q) const
  {
    const bool is_free = std::none_of(m_walls.begin(), m_walls.end(),
                                      [&](const Rectangle& w) { return hides(w, p, q); });
    return is_free ? distance_in_plane(p, q) : infinity;
  }

  // Whether some of the line is inside, up to rounding.
  static bool hides(const Rectangle& w, const Place& p, const Place& q)
  {
    constexpr Long rounding = 1e-13;
    Long first = 0, last = 1;
    const auto clip = [&](const Long from, const Long to, const Long low, const Long high) {
      if(from == to)
      {
        if(from <= low || from >= high)
          last = -1;
        return;
      }
      const Long s = (low - from) / (to - from), t = (high - from) / (to - from);
      first = (std::max)(first, (std::min)(s, t));
      last = (std::min)(last, (std::max)(s, t));
    };
    clip(p.x, q.x, w.x + rounding, w.end_of_x - rounding);
    clip(p.y, q.y, w.y + rounding, w.end_of_y - rounding);
    return last - first > 0;
  }

  // by Floyd's and Warshall's algorithm
  void join_corners()
  {
    const std::size_t n = m_corners.size();
    for(std::size_t k = 0; k < n; ++k)
      for(std::size_t i = 0; i < n; ++i)
        for(std::size_t j = 0; j < n; ++j)
          m_between[i][j] = (std::min)(m_between[i][j], m_between[i][k] + m_between[k][j]);
  }

  int m_columns, m_rows;
  std::vector<Rectangle> m_walls;
  std::vector<Place> m_corners;
  std::vector<std::vector<Long>> m_between;
};

// Its cells, with inner vertices moved at random, by a part of a cell.
inline Developed_surface
surface_of(const Polygonal_domain& domain, const double extent_of_jitter, Random& random)
{
  const auto columns = static_cast<std::size_t>(domain.columns()),
             rows = static_cast<std::size_t>(domain.rows());
  const Jitter jitter(columns + 1, rows + 1, extent_of_jitter, random);
  const auto place = [&](const std::size_t i, const std::size_t j) {
    const bool moves = domain.has_inside(static_cast<int>(i), static_cast<int>(j));
    return Place{Long(i) + (moves ? jitter(i, j)[0] : 0), Long(j) + (moves ? jitter(i, j)[1] : 0)};
  };
  Developed_surface whole, result;
  const auto vertex = [=](const std::size_t i, const std::size_t j) {
    return i + (columns + 1) * j;
  };
  add_cells(whole, columns, rows, vertex, place, at_random(random));
  result.soup.points = whole.soup.points;
  for(std::size_t k = 0; k < whole.places.size(); ++k) // two in each cell
    if(domain.has_cell(static_cast<int>(k / 2 % columns), static_cast<int>(k / 2 / columns)))
      result.add(whole.soup.triangles[k], whole.places[k]);
  result.distance = [domain](const Place& p, const Place& q) { return domain.distance(p, q); };
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_POLYGONAL_DOMAIN_H
