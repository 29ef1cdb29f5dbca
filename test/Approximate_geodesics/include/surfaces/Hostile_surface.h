// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_HOSTILE_SURFACE_H
#define APPROXIMATE_GEODESICS_TEST_HOSTILE_SURFACE_H

#include "meshes/random_soups.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace geodesics_test {

/*
 * A small random surface with all that is hard for distances: needles and caps of any width down to
 * 1e-9, faces without area, edges without length, spikes, hubs, borders; closed, open, or a strip.
 * It grows from a few faces, by points on edges and in faces, by flips of edges, and by points that
 * move.
 */
class Hostile_surface
{
public:
  explicit Hostile_surface(const std::uint64_t seed) : m_random(seed)
  {
    m_soup = start();
    m_hub = m_random.below(m_soup.points.size());
    const std::size_t size = 6 + m_random.below(11);
    const double share_of_tiny = m_random.between(0, 1);
    m_share_of_tiny = share_of_tiny * share_of_tiny;
    while(m_soup.points.size() < size)
      take_step();
    if(m_random.below(3) == 0)
      m_soup = with_holes(m_soup, 0.2, m_random);
  }

  const Soup& soup() const { return m_soup; }

private:
  using Vector = Kernel::Vector_3;

  // Two faces with a common side, which `triangles` have in opposite directions.
  struct Side
  {
    std::size_t a, b;
    std::size_t face;
    std::optional<std::size_t> other_face;
  };

  Soup start()
  {
    switch(m_random.below(5))
    {
    case 0:
      return octahedron().transformed([&](const Point& p) { return moved(p, 0.5); });
    case 1:
      return flat_grid(3, 2).transformed([&](const Point& p) { return moved(p, 0.3); });
    case 2:
      return flat_grid(6, 2).transformed([&](const Point& p) { return moved(p, tiny()); });
    case 3:
      return fan(5, m_random.between(0, 1));
    default:
      return Soup{{any_point(), any_point(), any_point(), any_point()},
                  {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    }
  }

  void take_step()
  {
    switch(m_random.below(8))
    {
    case 0:
    case 1:
      return insert_in_face();
    case 2:
    case 3:
    case 4:
      return split_edge();
    case 5:
    case 6:
      return flip_edge();
    default:
      return move_vertex();
    }
  }

  Point any_point()
  {
    const double x = m_random.between(-1, 1), y = m_random.between(-1, 1);
    return Point(x, y, m_random.between(-1, 1));
  }

  Point moved(const Point& p, const double extent)
  {
    return p + extent * (any_point() - CGAL::ORIGIN);
  }

  // mostly of the size of 1; else of any size down to 1e-9, or nothing
  double tiny()
  {
    if(m_random.between(0, 1) >= m_share_of_tiny)
      return m_random.between(0, 1);
    return m_random.below(5) == 0 ? 0 : std::pow(10., -m_random.between(1, 9));
  }

  void insert_in_face()
  {
    const std::size_t f = m_random.below(m_soup.triangles.size());
    const auto [a, b, c] = m_soup.triangles[f];
    const double s = tiny() / 2, t = tiny() / 2;
    const Point &p = m_soup.points[a], &q = m_soup.points[b], &r = m_soup.points[c];
    const std::size_t m = m_soup.points.size();
    m_soup.points.push_back(moved(p + s * (q - p) + t * (r - p), tiny() * tiny()));
    m_soup.triangles[f] = {a, b, m};
    m_soup.triangles.push_back({b, c, m});
    m_soup.triangles.push_back({c, a, m});
  }

  Side side(const std::size_t face, const std::size_t i) const
  {
    const auto& triangle = m_soup.triangles[face];
    Side result{triangle[i], triangle[(i + 1) % 3], face, std::nullopt};
    for(std::size_t g = 0; g < m_soup.triangles.size(); ++g)
      for(std::size_t j = 0; j < 3; ++j)
        if(m_soup.triangles[g][j] == result.b && m_soup.triangles[g][(j + 1) % 3] == result.a)
          result.other_face = g;
    return result;
  }

  Side any_side()
  {
    const std::size_t face = m_random.below(m_soup.triangles.size());
    return side(face, m_random.below(3));
  }

  std::size_t third(const std::size_t face, const std::size_t a, const std::size_t b) const
  {
    const auto& t = m_soup.triangles[face];
    return t[0] + t[1] + t[2] - a - b;
  }

  void split_edge()
  {
    const Side side = any_side();
    const auto [a, b] = std::pair(side.a, side.b);
    const Point &p = m_soup.points[a], &q = m_soup.points[b];
    const std::size_t m = m_soup.points.size(), c = third(side.face, a, b);
    m_soup.points.push_back(moved(p + tiny() * (q - p), tiny() * tiny()));
    m_soup.triangles[side.face] = {a, m, c};
    m_soup.triangles.push_back({m, b, c});
    if(!side.other_face)
      return;
    const std::size_t d = third(*side.other_face, a, b);
    m_soup.triangles[*side.other_face] = {b, m, d};
    m_soup.triangles.push_back({m, a, d});
  }

  // Away from the hub, if it is next to the hub.
  void flip_edge()
  {
    const Side side = any_side();
    const auto [a, b] = std::pair(side.a, side.b);
    if(!side.other_face || a == m_hub || b == m_hub)
      return;
    const std::size_t c = third(side.face, a, b), d = third(*side.other_face, a, b);
    if(c == d || has_edge(c, d))
      return;
    m_soup.triangles[side.face] = {a, d, c};
    m_soup.triangles[*side.other_face] = {d, b, c};
  }

  bool has_edge(const std::size_t c, const std::size_t d) const
  {
    for(const auto& t : m_soup.triangles)
      if((t[0] == c || t[1] == c || t[2] == c) && (t[0] == d || t[1] == d || t[2] == d))
        return true;
    return false;
  }

  // Next to another one, or far away.
  void move_vertex()
  {
    const Side side = any_side();
    Point& p = m_soup.points[side.a];
    const Point& q = m_soup.points[side.b];
    if(m_random.below(4) == 0)
      p = CGAL::ORIGIN + std::pow(10., m_random.between(0, 2)) * (p - CGAL::ORIGIN);
    else
      p = q + tiny() * (p - q);
  }

  Random m_random;
  Soup m_soup;
  std::size_t m_hub = 0;
  double m_share_of_tiny = 0;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_HOSTILE_SURFACE_H
