// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_OFFSETS_OFFSET_TRACER_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_OFFSETS_OFFSET_TRACER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Offsets/Distances_in_face.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Offsets/Distances_on_edges.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Offsets/Offset_lines.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_curve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Isolines of exact distances. Faces are divided where the distance is far from linear: near the
 * sources, at edges that are long for their distance. Whether an edge is divided depends on nothing
 * but the edge, so that faces fit together. Distances on edges and in faces are found from
 * those of vertices, and from the directions in which paths arrive there; where these do not tell
 * them well enough, by queries of the search.
 */
template <typename Search>
class Offset_tracer
{
public:
  // `distances` are sorted. `step` is what errors are relative to. The search has gone farther than
  // the largest distance by more than an edge.
  Offset_tracer(const Search& search, std::vector<double> distances, const double step)
    : m_search(search),
      m_triangulation(search.graph().triangulation()),
      m_on_edges(search),
      m_distances(std::move(distances)),
      m_step(step)
  {
  }

  std::vector<Offset_line> trace()
  {
    for(Index v = 0; v < m_triangulation.number_of_vertices(); ++v)
      m_values.push_back(m_search.distance(Intrinsic_point::at_vertex(v)));
    for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
      if(!m_triangulation.is_border(h) && m_triangulation.first_of_face(h) == h)
        add_face(h);
    return m_lines.lines(m_triangulation);
  }

private:
  // A corner of a part of the present face.
  struct Corner
  {
    std::uint32_t number;
    std::array<double, 3> weight; // in the face
  };
  using Triangle = std::array<Corner, 3>;

  // From a corner to the next one: a part of an edge, or a line across the face.
  struct Side
  {
    double length;
    Index halfedge = null_index;
    double begin = 0, end = 1; // on the halfedge

    bool is_part_of_edge() const { return halfedge != null_index; }
    bool is_edge() const { return is_part_of_edge() && begin == 0 && end == 1; }
    double middle() const { return (begin + end) / 2; }
    Side first_half() const { return {length / 2, halfedge, begin, middle()}; }
    Side second_half() const { return {length / 2, halfedge, middle(), end}; }
  };
  using Sides = std::array<Side, 3>;

  // In steps: of distances found from slopes, and of those that have to be equal to another.
  static constexpr double LARGEST_ERROR = 1e-2, LARGEST_DIFFERENCE = 2e-3;

  double value(const Corner& c) const
  {
    return is_small(m_in_face.error()) ? m_in_face.at(c.weight) * m_triangulation.unit()
                                       : m_search.distance(point(c));
  }

  bool is_small(const double error) const
  {
    return error * m_triangulation.unit() <= LARGEST_ERROR * m_step;
  }

  Intrinsic_point point(const Corner& c) const
  {
    const Face_point p{m_face, c.weight};
    return Curve_segment{p, p}.point(m_triangulation, 0);
  }

  void add_face(const Index h)
  {
    m_face = h;
    Triangle triangle{};
    Sides sides{};
    const auto halfedges = m_triangulation.halfedges_of_face(h);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Index v = m_triangulation.source(halfedges[i]);
      if(!(m_values[v] < infinity))
        return;
      triangle[i] = {v, {0, 0, 0}};
      triangle[i].weight[i] = 1;
      sides[i] = {m_triangulation.length(halfedges[i]) * m_triangulation.unit(), halfedges[i]};
    }
    m_in_face = Distances_in_face(m_triangulation, m_on_edges, h);
    m_middles_in_face.clear();
    m_first_crossings_in_face.clear();
    divide(triangle, sides, 0);
  }

  void divide(const Triangle& t, const Sides& sides, const int depth)
  {
    constexpr int deepest = 24;
    check_for_interruption_at(m_number_of_triangles++);
    const auto [low, high] = range(t);
    const double reach = (std::max)({sides[0].length, sides[1].length, sides[2].length});
    const auto first = std::lower_bound(m_distances.begin(), m_distances.end(), low - reach);
    if(first == m_distances.end() || *first > high + reach)
      return;
    std::array<bool, 3> is_divided{};
    for(std::size_t i = 0; i < 3; ++i)
      is_divided[i] = depth < deepest && is_long(t[i], t[(i + 1) % 3], sides[i].length);
    const auto number = std::count(is_divided.begin(), is_divided.end(), true);
    if(number == 0)
      return add_triangle(t, sides, low, high);
    std::size_t start = 0; // of a divided side, whose predecessor is not divided if there are two
    while(!is_divided[start] || (number == 2 && is_divided[(start + 2) % 3]))
      ++start;
    divide({t[start], t[(start + 1) % 3], t[(start + 2) % 3]},
           {sides[start], sides[(start + 1) % 3], sides[(start + 2) % 3]}, static_cast<int>(number),
           depth + 1);
  }

  // Divides the first sides, as many as `number`.
  void divide(const Triangle& t, const Sides& sides, const int number, const int depth)
  {
    const auto& [a, b, c] = t;
    const auto& [ab, bc, ca] = sides;
    const Side half_ab{ab.length / 2}, half_bc{bc.length / 2}, half_ca{ca.length / 2};
    const Side mc{median(ab.length, bc.length, ca.length)};
    const Corner m = middle(a, b, ab);
    if(number == 1)
    {
      divide({a, m, c}, {ab.first_half(), mc, ca}, depth);
      return divide({m, b, c}, {ab.second_half(), bc, mc}, depth);
    }
    const Corner n = middle(b, c, bc);
    divide({m, b, n}, {ab.second_half(), bc.first_half(), half_ca}, depth);
    if(number == 2)
    {
      divide({a, m, c}, {ab.first_half(), mc, ca}, depth);
      return divide({m, n, c}, {half_ca, bc.second_half(), mc}, depth);
    }
    const Corner o = middle(c, a, ca);
    divide({a, m, o}, {ab.first_half(), half_bc, ca.second_half()}, depth);
    divide({o, n, c}, {half_ab, bc.second_half(), ca.first_half()}, depth);
    divide({m, n, o}, {half_ca, half_ab, half_bc}, depth);
  }

  std::pair<double, double> range(const Triangle& t) const
  {
    return std::minmax({m_values[t[0].number], m_values[t[1].number], m_values[t[2].number]});
  }

  // The length of the line from the middle of a side to the opposite corner.
  static double median(const double side, const double second, const double third)
  {
    return std::sqrt((std::max)(0., (second * second + third * third) / 2 - side * side / 4));
  }

  // Whether chords are far from isolines there, or could miss them.
  bool is_long(const Corner& a, const Corner& b, const double length) const
  {
    const double nearest = (std::min)(m_values[a.number], m_values[b.number]);
    const double smallest = m_step / 4;
    return length > smallest && (nearest < length || length * length > 0.16 * m_step * nearest);
  }

  // Two vertices may have several edges between them.
  std::uint64_t key(const Corner& a, const Corner& b, const Side& side) const
  {
    std::uint32_t low = (std::min)(a.number, b.number), high = (std::max)(a.number, b.number);
    if(side.is_edge())
    {
      low = (std::min)(side.halfedge, m_triangulation.opposite(side.halfedge));
      high = null_index;
    }
    return (std::uint64_t(high) << 32) | low;
  }

  Corner between(const Corner& a, const Corner& b, const double t, const std::uint32_t number) const
  {
    Corner result{number, {}};
    for(std::size_t i = 0; i < 3; ++i)
      result.weight[i] = (1 - t) * a.weight[i] + t * b.weight[i];
    return result;
  }

  Corner middle(const Corner& a, const Corner& b, const Side& side)
  {
    auto& middles = side.is_part_of_edge() ? m_middles : m_middles_in_face;
    const auto [it, is_new] =
        middles.try_emplace(key(a, b, side), static_cast<std::uint32_t>(m_values.size()));
    const Corner result = between(a, b, 0.5, it->second);
    if(is_new)
      m_values.push_back(has_slopes(side) ? value(side, 0.5) : value(result));
    return result;
  }

  void add_triangle(const Triangle& t, const Sides& sides, const double low, const double high)
  {
    const std::size_t beyond = first_above(high);
    for(std::size_t number = first_above(low); number < beyond; ++number)
    {
      const auto is_above = [&](const std::size_t i) {
        return m_values[t[i % 3].number] >= m_distances[number];
      };
      std::size_t way_in = 0, way_out = 0;
      while(is_above(way_in) || !is_above(way_in + 1))
        ++way_in;
      while(!is_above(way_out) || is_above(way_out + 1))
        ++way_out;
      const std::size_t from = crossing(t[way_in], t[(way_in + 1) % 3], sides[way_in], number);
      m_lines.add_piece(
          from, crossing(t[(way_out + 1) % 3], t[way_out], reversed(sides[way_out]), number));
    }
  }

  // The number of the first distance that is larger than a value.
  std::size_t first_above(const double value) const
  {
    return static_cast<std::size_t>(
        std::upper_bound(m_distances.begin(), m_distances.end(), value) - m_distances.begin());
  }

  // The number of the crossing of an isoline with the side from a corner below it to one above.
  // Those of all isolines that cross the side follow each other.
  std::size_t
  crossing(const Corner& below, const Corner& above, const Side& side, const std::size_t number)
  {
    const std::size_t first = first_above(m_values[below.number]);
    auto& crossings = side.is_part_of_edge() ? m_first_crossings : m_first_crossings_in_face;
    const auto [it, is_new] =
        crossings.try_emplace(key(below, above, side), m_lines.number_of_points());
    if(is_new)
    {
      const std::size_t beyond = first_above(m_values[above.number]);
      for(std::size_t i = first; i < beyond; ++i)
        m_lines.add_point(i, point(between(below, above, part(below, above, side, i), 0)));
    }
    return it->second + (number - first);
  }

  Side reversed(const Side& side) const
  {
    if(!side.is_part_of_edge())
      return side;
    return {side.length, m_triangulation.opposite(side.halfedge), 1 - side.end, 1 - side.begin};
  }

  // Whether the slopes at the ends of an edge determine the distance on a side well enough.
  bool has_slopes(const Side& side) const
  {
    return side.is_part_of_edge() && is_small(m_on_edges.error(side.halfedge));
  }

  // The distance that follows from these slopes, at a part of the way along the side.
  double value(const Side& side, const double t) const
  {
    return m_on_edges.at(side.halfedge, side.begin + t * (side.end - side.begin)) *
           m_triangulation.unit();
  }

  // The part of the way along a side at which an isoline crosses it.
  double
  part(const Corner& below, const Corner& above, const Side& side, const std::size_t number) const
  {
    if(has_slopes(side))
      return part(below, above, number, [&](const double t) { return value(side, t); });
    return part(below, above, number,
                [&](const double t) { return value(between(below, above, t, 0)); });
  }

  // Finds it by regula falsi.
  template <typename Value>
  double part(const Corner& below,
              const Corner& above,
              const std::size_t number,
              const Value& value_at) const
  {
    constexpr double rounding = 1e-9;
    const double wanted = m_distances[number];
    double start = 0, end = 1;
    double at_start = m_values[below.number] - wanted, at_end = m_values[above.number] - wanted;
    double result = -at_start / (at_end - at_start);
    for(int i = 0; i < 8; ++i)
    {
      const double here = value_at(result) - wanted;
      if(!(std::abs(here) > LARGEST_DIFFERENCE * m_step))
        break;
      (here < 0 ? start : end) = result;
      (here < 0 ? at_start : at_end) = here;
      result = start + (end - start) * (-at_start / (at_end - at_start));
    }
    return result < rounding ? 0 : result > 1 - rounding ? 1 : result; // so that points coincide
  }

  const Search& m_search;
  const Intrinsic_triangulation& m_triangulation;
  const Distances_on_edges<Search> m_on_edges;
  const std::vector<double> m_distances;
  const double m_step;
  Index m_face = null_index; // a halfedge of the present one
  Distances_in_face m_in_face;
  std::vector<double> m_values; // of corners; those of the vertices come first
  // Of sides; two faces may have the same corners, but not the same lines between them.
  std::unordered_map<std::uint64_t, std::uint32_t> m_middles, m_middles_in_face;
  std::unordered_map<std::uint64_t, std::size_t> m_first_crossings, m_first_crossings_in_face;
  std::size_t m_number_of_triangles = 0;
  Offset_lines m_lines;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_OFFSETS_OFFSET_TRACER_H
