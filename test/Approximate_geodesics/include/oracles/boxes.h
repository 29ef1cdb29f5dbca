// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_BOXES_H
#define APPROXIMATE_GEODESICS_TEST_BOXES_H

#include "meshes/developed_surfaces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace geodesics_test {

/*
 * A box that is rolled in the plane. The shortest path is a straight line that stays on the sides
 * that the box is rolled over, as corners of a box are no place to bend at; and it meets each side
 * only once.
 */
class Box
{
public:
  using Triple = std::array<int, 3>;

  explicit Box(const Triple& size) : m_size(size) {}

  static constexpr std::size_t number_of_sides = 6;

  // Side s is across axis s / 2, at its end if s is odd. Its own axes are the two others, so that
  // it is seen from outside.
  std::size_t axis(const std::size_t side, const std::size_t i) const
  {
    const std::size_t first = (side / 2 + 1) % 3, second = (side / 2 + 2) % 3;
    return (i == 0) == (side % 2 == 1) ? first : second;
  }

  std::size_t extent(const std::size_t side, const std::size_t i) const
  {
    return static_cast<std::size_t>(m_size[axis(side, i)]);
  }

  template <typename Number>
  std::array<Number, 3> in_space(const std::size_t side, const Number x, const Number y) const
  {
    std::array<Number, 3> result{};
    result[side / 2] = side % 2 == 1 ? Number(m_size[side / 2]) : Number(0);
    result[axis(side, 0)] = x;
    result[axis(side, 1)] = y;
    return result;
  }

  // Planes have the numbers of sides.
  Long distance(const Place& p, const Place& q) const
  {
    const auto side = static_cast<std::size_t>(p.plane);
    std::array<bool, number_of_sides> is_met{};
    return roll({side, {0, 0}, {1, 0}, {0, 1}}, p, q, {}, is_met);
  }

private:
  // A side in the plane: its origin, and its axes.
  struct Print
  {
    std::size_t side;
    Place origin, x_axis, y_axis;

    Place at(const Long x, const Long y) const
    {
      return {origin.x + x * x_axis.x + y * y_axis.x, origin.y + x * x_axis.y + y * y_axis.y};
    }
  };

  struct Edge_in_plane
  {
    Place a, b;
  };

  Long roll(const Print& print,
            const Place& start,
            const Place& q,
            const std::vector<Edge_in_plane>& crossed,
            std::array<bool, number_of_sides>& is_met) const
  {
    const Place from{start.x, start.y};
    if(print.side == static_cast<std::size_t>(q.plane))
    {
      const Place to = print.at(q.x, q.y);
      const bool is_straight =
          std::all_of(crossed.begin(), crossed.end(),
                      [&](const Edge_in_plane& e) { return crosses(from, to, e); });
      return is_straight ? distance_in_plane(from, to) : infinity;
    }
    Long result = infinity;
    is_met[print.side] = true;
    for(std::size_t next = 0; next < number_of_sides; ++next)
      if(!is_met[next] && next / 2 != print.side / 2)
      {
        std::vector<Edge_in_plane> edges = crossed;
        const Print other = rolled(print, next, edges);
        result = (std::min)(result, roll(other, start, q, edges, is_met));
      }
    is_met[print.side] = false;
    return result;
  }

  // The position of a point in space on a side.
  static Place on_side(const Box& box, const std::size_t side, const Triple& p)
  {
    return {Long(p[box.axis(side, 0)]), Long(p[box.axis(side, 1)])};
  }

  // The two sides have an edge in common, along the third axis; there they touch in the plane.
  Print
  rolled(const Print& print, const std::size_t next, std::vector<Edge_in_plane>& crossed) const
  {
    const std::size_t along = 3 - print.side / 2 - next / 2;
    Triple first{}, second{};
    for(const std::size_t side : {print.side, next})
      first[side / 2] = side % 2 == 1 ? m_size[side / 2] : 0;
    second = first;
    second[along] = m_size[along];
    const Place p = on_side(*this, print.side, first), q = on_side(*this, print.side, second);
    const Place a = print.at(p.x, p.y), b = print.at(q.x, q.y);
    crossed.push_back({a, b});
    const Long length = distance_in_plane(a, b);
    const Place edge{(b.x - a.x) / length, (b.y - a.y) / length};
    // its axes are turned so that the edge has the same direction
    const Place c = on_side(*this, next, first), d = on_side(*this, next, second);
    const Place own{(d.x - c.x) / length, (d.y - c.y) / length};
    const Long cosine = own.x * edge.x + own.y * edge.y, sine = own.x * edge.y - own.y * edge.x;
    Print result{next, {0, 0}, {cosine, sine}, {-sine, cosine}};
    const Place moved = result.at(c.x, c.y);
    result.origin = {a.x - moved.x, a.y - moved.y};
    return result;
  }

  static bool crosses(const Place& p, const Place& q, const Edge_in_plane& e)
  {
    constexpr Long rounding = 1e-15;
    const auto turn = [&](const Place& r) {
      return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    const Long size = distance_in_plane(p, q) * distance_in_plane(e.a, e.b);
    const Long s = turn(e.a), t = turn(e.b);
    return (s <= rounding * size && t >= -rounding * size) ||
           (t <= rounding * size && s >= -rounding * size);
  }

  Triple m_size;
};

// Its sides, in cells of size 1, whose inner vertices are moved at random.
inline Developed_surface surface_of(const Box& box, const double extent_of_jitter, Random& random)
{
  Developed_surface result;
  std::map<std::array<std::size_t, 3>, std::size_t> at_borders;
  std::size_t number = 0;
  for(std::size_t side = 0; side < Box::number_of_sides; ++side)
  {
    const std::size_t columns = box.extent(side, 0), rows = box.extent(side, 1);
    const Jitter jitter(columns + 1, rows + 1, extent_of_jitter, random);
    std::map<std::array<std::size_t, 3>, std::size_t> inside;
    const auto vertex = [&](const std::size_t i, const std::size_t j) {
      auto& known = i % columns == 0 || j % rows == 0 ? at_borders : inside;
      const auto [it, is_new] = known.insert({box.in_space(side, i, j), number});
      number += is_new ? 1 : 0;
      return it->second;
    };
    const auto place = [&](const std::size_t i, const std::size_t j) {
      const Long moves = i % columns == 0 || j % rows == 0 ? 0 : 1;
      return Place{Long(i) + moves * jitter(i, j)[0], Long(j) + moves * jitter(i, j)[1],
                   Long(side)};
    };
    add_cells(result, columns, rows, vertex, place, at_random(random));
  }
  for(std::size_t k = 0; k < result.places.size(); ++k)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Place& p = result.places[k][i];
      const auto [x, y, z] = box.in_space(static_cast<std::size_t>(p.plane), p.x, p.y);
      result.soup.points[result.soup.triangles[k][i]] = Point(double(x), double(y), double(z));
    }
  result.is_embedded = true;
  result.distance = [box](const Place& p, const Place& q) { return box.distance(p, q); };
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_BOXES_H
