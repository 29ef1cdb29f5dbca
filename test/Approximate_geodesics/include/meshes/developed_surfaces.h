// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_DEVELOPED_SURFACES_H
#define APPROXIMATE_GEODESICS_TEST_DEVELOPED_SURFACES_H

#include "meshes/Developed_surface.h"
#include "meshes/test_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Surfaces whose distances have a closed form.

namespace geodesics_test {

inline Long long_pi() { return 4 * std::atan(Long(1)); }

// ----- flat ones

// A convex part of the plane z = 0.
inline Developed_surface flat_surface(const Soup& soup)
{
  Developed_surface result{soup, {}, distance_in_plane, true};
  for(const auto& t : soup.triangles)
  {
    const Point &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    result.places.push_back({Place{a.x(), a.y()}, Place{b.x(), b.y()}, Place{c.x(), c.y()}});
  }
  return result;
}

// The same without coordinates.
inline Developed_surface without_coordinates(Developed_surface surface)
{
  surface.is_embedded = false;
  std::fill(surface.soup.points.begin(), surface.soup.points.end(), Point(0, 0, 0));
  return surface;
}

// How far the inner vertices of a grid are moved, as parts of its cells.
class Jitter
{
public:
  Jitter(const std::size_t columns, const std::size_t rows, const double extent, Random& random)
    : m_columns(columns)
  {
    for(std::size_t i = 0; i < columns * rows; ++i)
    {
      const double x = random.between(-extent, extent);
      m_moves.push_back({x, random.between(-extent, extent)});
    }
  }

  const std::array<double, 2>& operator()(const std::size_t i, const std::size_t j) const
  {
    return m_moves[i + m_columns * j];
  }

private:
  std::size_t m_columns;
  std::vector<std::array<double, 2>> m_moves;
};

/*
 * Columns and rows of cells, in a plane, some of whose vertices are the same: `vertex(i, j)` is the
 * number of that in a column and a row, and `place(i, j)` where it is. The diagonal of a cell
 * rises if `is_rising(i, j)` says so.
 */
template <typename NumberOfVertex, typename PlaceOf, typename IsRising>
void add_cells(Developed_surface& surface,
               const std::size_t columns,
               const std::size_t rows,
               NumberOfVertex vertex,
               PlaceOf place,
               IsRising is_rising)
{
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const auto add = [&](const std::array<std::array<std::size_t, 2>, 3>& t) {
        Developed_surface::Corners places;
        std::array<std::size_t, 3> numbers;
        for(std::size_t k = 0; k < 3; ++k)
        {
          places[k] = place(t[k][0], t[k][1]);
          numbers[k] = vertex(t[k][0], t[k][1]);
          surface.soup.points.resize((std::max)(surface.soup.points.size(), numbers[k] + 1),
                                     Point(0, 0, 0));
        }
        surface.add(numbers, places);
      };
      const std::array<std::size_t, 2> a{i, j}, b{i + 1, j}, c{i + 1, j + 1}, d{i, j + 1};
      if(is_rising(i, j))
      {
        add({a, b, c});
        add({a, c, d});
      }
      else
      {
        add({a, b, d});
        add({b, c, d});
      }
    }
}

// Diagonals that go one way or the other.
inline auto at_random(Random& random)
{
  return [&random](std::size_t, std::size_t) { return random.below(2) == 0; };
}

// ----- rolled up ones

inline Long shortest_of_shifts(const Place& p, const Place& q, const Place& u, const Place& v)
{
  constexpr int most = 4;
  Long result = infinity;
  for(int i = -most; i <= most; ++i)
    for(int j = -most; j <= most; ++j)
      result = (std::min)(result, std::hypot(q.x - p.x + Long(i) * u.x + Long(j) * v.x,
                                             q.y - p.y + Long(i) * u.y + Long(j) * v.y));
  return result;
}

// Cells of the given size, whose columns are closed to rings.
inline Developed_surface cylinder(const std::size_t columns,
                                  const std::size_t rows,
                                  const double width,
                                  const double height,
                                  Random& random)
{
  Developed_surface result;
  const Jitter jitter(columns, rows + 1, 0.2, random);
  const auto vertex = [=](const std::size_t i, const std::size_t j) {
    return i % columns + columns * j;
  };
  const auto place = [&](const std::size_t i, const std::size_t j) {
    const auto& [x, y] = jitter(i % columns, j);
    return Place{width * (Long(i) + x), height * (Long(j) + (j % rows == 0 ? 0 : y))};
  };
  add_cells(result, columns, rows, vertex, place, at_random(random));
  const Place around{Long(columns) * width, 0}, none{0, 0};
  result.distance = [=](const Place& p, const Place& q) {
    return shortest_of_shifts(p, q, around, none);
  };
  return result;
}

// The plane, where what differs by a multiple of `u` and `v` is the same.
inline Developed_surface flat_torus(const std::size_t columns,
                                    const std::size_t rows,
                                    const Place& u,
                                    const Place& v,
                                    Random& random)
{
  Developed_surface result;
  const Jitter jitter(columns, rows, 0.2, random);
  const auto vertex = [=](const std::size_t i, const std::size_t j) {
    return i % columns + columns * (j % rows);
  };
  const auto place = [&](const std::size_t i, const std::size_t j) {
    const auto& [x, y] = jitter(i % columns, j % rows);
    const Long s = (Long(i) + x) / Long(columns), t = (Long(j) + y) / Long(rows);
    return Place{s * u.x + t * v.x, s * u.y + t * v.y};
  };
  add_cells(result, columns, rows, vertex, place, at_random(random));
  result.distance = [=](const Place& p, const Place& q) { return shortest_of_shifts(p, q, u, v); };
  return result;
}

// ----- cones

// Its places are seen from the apex, in a plane for each sector, turned by the number of that.
inline Long distance_on_cone(const Place& p, const Place& q, const Long total_angle)
{
  const Long r = std::hypot(p.x, p.y), s = std::hypot(q.x, q.y);
  const Long between = std::fmod(
      std::abs(p.plane + std::atan2(p.y, p.x) - q.plane - std::atan2(q.y, q.x)), total_angle);
  const Long angle = (std::min)(between, total_angle - between);
  if(angle >= long_pi())
    return r + s;
  const Long half = std::sin(angle / 2);
  return std::sqrt((r - s) * (r - s) + 4 * r * s * half * half);
}

// Vertices of rings around an apex, moved by a part of a cell, but for the last ring, which is
// convex. There are so many of them that chords of that do not come near the ring before.
inline Developed_surface
cone(const std::size_t rings, const Long total_angle, const double extent_of_jitter, Random& random)
{
  Developed_surface result;
  const Long largest = (std::min)(Long(1.5), 1 / std::sqrt(Long(rings)));
  const std::size_t sectors =
      (std::max)(std::size_t(3), static_cast<std::size_t>(std::ceil(total_angle / largest)));
  const Long angle = total_angle / Long(sectors);
  const Jitter jitter(sectors, rings + 1, extent_of_jitter, random);
  const auto vertex = [=](const std::size_t i, const std::size_t j) {
    return j == 0 ? 0 : 1 + i % sectors + sectors * (j - 1);
  };
  const auto add = [&](const std::size_t first,
                       const std::array<std::array<std::size_t, 2>, 3>& t) {
    Developed_surface::Corners places;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t i = t[k][0], j = t[k][1];
      const auto& [x, y] = jitter(i % sectors, j);
      const Long r = j == 0 ? 0 : Long(j) + (j == rings ? 0 : y);
      const Long turn = angle * (Long(i) - Long(first) + x);
      places[k] = {r * std::cos(turn), r * std::sin(turn), angle * Long(first)};
    }
    result.add({vertex(t[0][0], t[0][1]), vertex(t[1][0], t[1][1]), vertex(t[2][0], t[2][1])},
               places);
  };
  for(std::size_t i = 0; i < sectors; ++i)
  {
    add(i, {{{i, 0}, {i, 1}, {i + 1, 1}}});
    for(std::size_t j = 1; j < rings; ++j)
    {
      add(i, {{{i, j}, {i, j + 1}, {i + 1, j + 1}}});
      add(i, {{{i, j}, {i + 1, j + 1}, {i + 1, j}}});
    }
  }
  result.soup.points.resize(1 + sectors * rings, Point(0, 0, 0));
  result.distance = [=](const Place& p, const Place& q) {
    return distance_on_cone(p, q, total_angle);
  };
  return result;
}

// ----- an envelope: two rectangles with the same border

inline Long distance_over_side(const Place& p, const Place& q, const Long low, const Long high)
{ // the side is the x axis, and both are above it
  const Long sum = p.y + q.y;
  const Long x = sum > 0 ? (p.x * q.y + q.x * p.y) / sum : (p.x + q.x) / 2;
  const Long over = (std::clamp)(x, low, high);
  return std::hypot(p.x - over, p.y) + std::hypot(q.x - over, q.y);
}

// The second side is seen from behind.
inline Long distance_on_envelope(Place p, Place q, const Long width, const Long height)
{
  if(p.plane == q.plane)
    return distance_in_plane(p, q);
  for(Place* const r : {&p, &q})
    if(r->plane == 1)
      r->x = width - r->x;
  const auto turned = [](const Place& r) { return Place{r.y, r.x}; };
  const auto flipped = [=](const Place& r) { return Place{width - r.x, height - r.y}; };
  const auto over_low_sides = [=](const Place& r, const Place& s) {
    return (std::min)(distance_over_side(r, s, 0, width),
                      distance_over_side(turned(r), turned(s), 0, height));
  };
  return (std::min)(over_low_sides(p, q), over_low_sides(flipped(p), flipped(q)));
}

inline Developed_surface envelope(const std::size_t columns, const std::size_t rows, Random& random)
{
  Developed_surface result;
  const std::size_t number = (columns + 1) * (rows + 1);
  const auto is_inner = [=](const std::size_t i, const std::size_t j) {
    return i % columns != 0 && j % rows != 0;
  };
  for(const std::size_t side : {0u, 1u})
  {
    const Jitter jitter(columns + 1, rows + 1, 0.2, random);
    const auto column = [=](const std::size_t i) { return side == 0 ? i : columns - i; };
    const auto vertex = [=](const std::size_t i, const std::size_t j) {
      return column(i) + (columns + 1) * j + (side == 1 && is_inner(i, j) ? number : 0);
    };
    const auto place = [&](const std::size_t i, const std::size_t j) {
      const auto& [x, y] = jitter(i, j);
      const bool moves = is_inner(i, j);
      return Place{Long(i) + (moves ? x : 0), Long(j) + (moves ? y : 0), Long(side)};
    };
    add_cells(result, columns, rows, vertex, place,
              [=](const std::size_t i, const std::size_t j) { // no edge is on both sides
                return !is_inner(i + 1, j) && !is_inner(i, j + 1);
              });
  }
  result.distance = [=](const Place& p, const Place& q) {
    return distance_on_envelope(p, q, Long(columns), Long(rows));
  };
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_DEVELOPED_SURFACES_H
