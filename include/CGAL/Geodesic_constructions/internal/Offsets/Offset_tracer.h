// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_OFFSET_TRACER_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_OFFSET_TRACER_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/internal/Offsets/Distances_in_face.h>
#include <CGAL/Geodesic_constructions/internal/Offsets/Distances_on_edges.h>
#include <CGAL/Geodesic_constructions/internal/Offsets/Offset_lines.h>
#include <CGAL/Geodesic_constructions/internal/Offsets/Offset_piece.h>
#include <CGAL/Geodesic_constructions/search_from_curves.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Isolines of exact distances. Faces are divided where the distance is far from linear: near the
 * sources, at edges that are long for their distance. Whether an edge is divided depends on nothing
 * but the edge, so that faces fit together. Distances on edges and in faces are found from
 * those of vertices, and from the directions in which paths arrive there; where these do not tell
 * them well enough, by queries of the search. All is in units of the triangulation: squares of
 * lengths in the unit of the mesh may be no numbers.
 */
template <typename Search>
class Offset_tracer
{
public:
  // `distances` are sorted. `step` is what errors are relative to. Both are in the unit of the
  // mesh. The search has gone farther than the largest distance by more than an edge.
  Offset_tracer(const Search& search, std::vector<double> distances, const double step)
    : Offset_tracer(search, distances, step, most_parts(search, distances.size()))
  {
  }

  // Divides faces into no more than that many parts.
  Offset_tracer(const Search& search,
                std::vector<double> distances,
                const double step,
                const std::size_t most_parts)
    : m_search(search),
      m_triangulation(search.graph().triangulation()),
      m_step(step / m_triangulation.unit()),
      m_smallest((std::max)(m_step / 4, longest_edge(m_triangulation) * SMALLEST_PART)),
      m_on_edges(search, LARGEST_ERROR * m_step),
      m_distances(std::move(distances)),
      m_most_parts(most_parts),
      m_middles(m_triangulation),
      m_first_crossings(m_triangulation)
  {
    for(double& d : m_distances)
      d /= m_triangulation.unit();
  }

  std::vector<Offset_line> trace()
  {
    for(Index v = 0; v < m_triangulation.number_of_vertices(); ++v)
    {
      check_for_interruption_at(v);
      m_values.push_back(m_search.distance(Intrinsic_point::at_vertex(v)) / m_triangulation.unit());
    }
    const std::vector<bool> is_source = faces_of_sources();
    for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
      if(!m_triangulation.is_border(h) && m_triangulation.first_of_face(h) == h && !is_source[h])
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

  // By the first halfedge of each face.
  std::vector<bool> faces_of_sources() const
  {
    std::vector<bool> result(m_triangulation.number_of_halfedges());
    for(const Intrinsic_curve& curve : curves_of(m_search))
      for(const Index h : curve.faces)
        result[m_triangulation.first_of_face(h)] = true;
    return result;
  }

  // In steps: of distances found from slopes, of those that have to be equal to another, and of
  // those of middles of chords.
  static constexpr double LARGEST_ERROR = 8e-3, LARGEST_DIFFERENCE = 2e-3, LARGEST_HEIGHT = 5e-3;

  // Of the longest edge: shorter sides are not divided. A limit of length depends on nothing but
  // the side, which a depth does not where faces of different shapes meet.
  static constexpr double SMALLEST_PART = 0x1p-24;

  // How often a triangle is divided at most, as a safeguard: sides are too short before.
  static constexpr int DEEPEST = 64;

  // Some hundred thousand in any case, as few faces may have long curves, and thousands for each
  // face and distance: more than curves need unless steps are far smaller than edges.
  static std::size_t most_parts(const Search& search, const std::size_t number_of_distances)
  {
    constexpr std::size_t in_any_case = 1 << 18, of_a_face = 1 << 12;
    return in_any_case +
           of_a_face * number_of_distances * search.graph().triangulation().number_of_faces();
  }

  static double longest_edge(const Intrinsic_triangulation& t)
  {
    double result = 0;
    for(Index h = 0; h < t.number_of_halfedges(); ++h)
      result = (std::max)(result, t.length(h));
    return result;
  }

  const Distances_in_face& in_face()
  {
    if(m_face_of_distances != m_face)
    {
      m_in_face = Distances_in_face(m_triangulation, m_on_edges, m_face);
      m_face_of_distances = m_face;
    }
    return m_in_face;
  }

  double value(const Corner& c)
  {
    const double estimate = in_face().at(c.weight);
    return is_small(m_in_face.estimated_error()) ? estimate
                                                 : m_on_edges.distance(point(c), estimate);
  }

  bool is_small(const double error) const { return error <= m_on_edges.negligible_error(); }

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
      sides[i] = {m_triangulation.length(halfedges[i]), halfedges[i]};
    }
    divide(triangle, sides, 0);
    m_middles.forget_lines_in_face();
    m_first_crossings.forget_lines_in_face();
  }

  // Counts a part of the present face, or of one of its sides.
  void count_part()
  {
    check_for_interruption_at(m_number_of_parts++);
    if(m_number_of_parts > m_most_parts)
      throw std::length_error(name_of_package() + "offset curves take more than " +
                              std::to_string(m_most_parts) + " parts of faces, the last one in " +
                              m_triangulation.name_of_face(m_face) +
                              "; fewer distances, or a larger difference between them, take fewer");
  }

  void divide(const Triangle& t, const Sides& sides, const int depth)
  {
    count_part();
    const auto [low, high] = range(t);
    const double reach = (std::max)({sides[0].length, sides[1].length, sides[2].length});
    if(!has_isoline(low - reach, high + reach))
      return;
    std::array<bool, 3> is_divided{};
    for(std::size_t i = 0; i < 3; ++i)
      is_divided[i] = depth < DEEPEST && is_long(t[i], t[(i + 1) % 3], sides[i].length);
    const auto number = std::count(is_divided.begin(), is_divided.end(), true);
    if(number == 0)
      return add_triangle(t, sides, low, high);
    std::size_t start = 0; // of a divided side, whose predecessor is not divided if there are two
    while(!is_divided[start] || (number == 2 && is_divided[(start + 2) % 3]))
      ++start;
    const Triangle turned{t[start], t[(start + 1) % 3], t[(start + 2) % 3]};
    const Sides sides_of_it{sides[start], sides[(start + 1) % 3], sides[(start + 2) % 3]};
    const auto& [ab, bc, ca] = sides_of_it;
    if(number == 2 && 2 * ca.length <= (std::min)(ab.length, bc.length))
      return divide_needle(turned, sides_of_it, depth + 1);
    divide(turned, sides_of_it, static_cast<int>(number), depth + 1);
  }

  // Whether there is an isoline between two distances.
  bool has_isoline(const double low, const double high) const
  {
    const auto first = std::lower_bound(m_distances.begin(), m_distances.end(), low);
    return first != m_distances.end() && *first <= high;
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

  // A part of a side that is not divided further, from one corner to the next.
  struct Part
  {
    Corner start, end;
    Side side;
    int depth;
  };

  // Appends the parts of a side. Isolines may cross it that are as near as `width` to its range.
  void add_parts(const Corner& a,
                 const Corner& b,
                 const Side& side,
                 const double width,
                 const int depth,
                 std::vector<Part>& parts)
  {
    const auto [low, high] = std::minmax(m_values[a.number], m_values[b.number]);
    const double reach = side.length + width;
    if(depth == DEEPEST || !is_long(a, b, side.length) || !has_isoline(low - reach, high + reach))
    {
      count_part();
      return parts.push_back({a, b, side, depth});
    }
    const Corner m = middle(a, b, side);
    add_parts(a, m, side.first_half(), width, depth + 1, parts);
    add_parts(m, b, side.second_half(), width, depth + 1, parts);
  }

  // Divides the first two sides, which are far longer than the third one, into all of their parts
  // at once: a strip of as many triangles. Divided by halves, each triangle would leave three of
  // half its length, time and again.
  void divide_needle(const Triangle& t, const Sides& sides, const int depth)
  {
    const auto& [a, b, c] = t;
    const auto& [ab, bc, ca] = sides;
    std::vector<Part> to_b, from_b;
    add_parts(a, b, ab, ca.length, depth, to_b);
    add_parts(b, c, bc, ca.length, depth, from_b);
    const internal::Corner at_b(ab.length, bc.length, ca.length);
    Corner p = a, q = c; // the corners of the strip that is left
    Side pq = ca;
    double x = ab.length, y = bc.length; // how far they are from b
    auto next = to_b.begin();
    for(auto last = from_b.rbegin();;)
    {
      const bool is_p_last = next + 1 == to_b.end(), is_q_last = last + 1 == from_b.rend();
      const int deeper = (std::max)(next->depth, last->depth);
      if(is_p_last && is_q_last)
        return divide({p, b, q}, {next->side, last->side, pq}, deeper);
      const bool moves_p = is_q_last || (!is_p_last && (x - next->side.length) * bc.length >=
                                                           (y - last->side.length) * ab.length);
      const Part& part = moves_p ? *next++ : *last++;
      const Corner r = moves_p ? part.end : part.start;
      (moves_p ? x : y) -= part.side.length;
      const Side across{at_b.distance(x, y)};
      divide({p, r, q}, moves_p ? Sides{part.side, across, pq} : Sides{across, part.side, pq},
             part.depth);
      (moves_p ? p : q) = r;
      pq = across;
    }
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

  // Whether isolines there could be missed, or chords that cannot be divided in a triangle be
  // farther from them than 1 % of a step: a chord of length l of a circle of radius r is up to l *
  // l / (8 r) away.
  bool is_long(const Corner& a, const Corner& b, const double length) const
  {
    const double nearest = (std::min)(m_values[a.number], m_values[b.number]);
    return length > m_smallest && (nearest < length || length * length > 0.08 * m_step * nearest);
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
    std::uint32_t& number = m_middles.at(side, a.number, b.number);
    const bool is_new = number == null_index;
    if(is_new)
      number = static_cast<std::uint32_t>(m_values.size());
    const Corner result = between(a, b, 0.5, number);
    if(is_new)
      m_values.push_back(with_distances(
          side, a, b, [](const auto& /* estimate */, const auto& at) { return at(0.5); }));
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
      const std::size_t way_in_end = (way_in + 1) % 3, way_out_end = (way_out + 1) % 3;
      const std::size_t from = crossing(t[way_in], t[way_in_end], sides[way_in], number),
                        to = crossing(t[way_out_end], t[way_out], reversed(sides[way_out]), number);
      Weights p{}, q{};
      p[way_in] = 1 - m_parts[from];
      p[way_in_end] = m_parts[from];
      q[way_out_end] = 1 - m_parts[to];
      q[way_out] = m_parts[to];
      add_piece(t,
                {from, to, p, q, way_in_end == way_out ? way_out : way_in, way_in_end == way_out},
                number);
    }
  }

  using Weights = std::array<double, 3>;

  // From one crossing to another.
  struct Piece
  {
    std::size_t from, to;
    Weights begin, end; // of the corners of the triangle
    std::size_t corner; // that it cuts off
    bool is_corner_farther;
  };

  // Adds a piece, with points in the triangle where it is curved.
  void add_piece(const Triangle& t, const Piece& piece, const std::size_t number)
  {
    const auto corner = [&](const Weights& w) {
      Corner result{0, {0, 0, 0}};
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t j = 0; j < 3; ++j)
          result.weight[i] += w[j] * t[j].weight[i];
      return result;
    };
    std::size_t last = piece.from;
    const auto go_to = [&](const std::size_t next) {
      m_lines.add_piece(last, next);
      last = next;
    };
    const auto difference = [&](const Weights& w) {
      return value(corner(w)) - m_distances[number];
    };
    Offset_piece(difference, piece.corner, piece.is_corner_farther, LARGEST_HEIGHT * m_step)
        .for_each_between(piece.begin, piece.end, [&](const Weights& w) {
          add_point(number, corner(w), 0);
          go_to(m_lines.number_of_points() - 1);
        });
    go_to(piece.to);
  }

  void add_point(const std::size_t number, const Corner& c, const double part)
  {
    m_lines.add_point(number, point(c));
    m_parts.push_back(part);
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
    std::uint32_t& result = m_first_crossings.at(side, below.number, above.number);
    if(result == null_index)
    {
      result = static_cast<std::uint32_t>(m_lines.number_of_points());
      const std::size_t beyond = first_above(m_values[above.number]);
      with_distances(side, below, above, [&](const auto& estimate, const auto& at) {
        for(std::size_t i = first; i < beyond; ++i)
        {
          const double t = part(below, above, i, estimate, at);
          add_point(i, between(below, above, t, 0), t);
        }
      });
    }
    return result + (number - first);
  }

  Side reversed(const Side& side) const
  {
    if(!side.is_part_of_edge())
      return side;
    return {side.length, m_triangulation.opposite(side.halfedge), 1 - side.end, 1 - side.begin};
  }

  // Returns `f(estimate, at)`, where `at(t)` is the distance at a part `t` of the way along a side,
  // and `estimate(t)` what it is without a query of the search.
  template <typename F>
  auto with_distances(const Side& side, const Corner& from, const Corner& to, const F& f)
  {
    if(!side.is_part_of_edge())
      return f([&](const double t) { return in_face().at(between(from, to, t, 0).weight); },
               [&](const double t) { return value(between(from, to, t, 0)); });
    const Distances_on_edge on_edge = m_on_edges[side.halfedge];
    const auto part_of_edge = [&](const double t) {
      return side.begin + t * (side.end - side.begin);
    };
    return f(
        [&](const double t) { return on_edge.at(part_of_edge(t)); },
        [&](const double t) { return m_on_edges.at(side.halfedge, on_edge, part_of_edge(t)); });
  }

  // The part of the way along a side at which an isoline crosses it.
  template <typename Estimate, typename Value>
  double part(const Corner& below,
              const Corner& above,
              const std::size_t number,
              const Estimate& estimate,
              const Value& value_at) const
  {
    constexpr double rounding = 1e-9;
    const double wanted = m_distances[number], largest = LARGEST_DIFFERENCE * m_step;
    const double at_start = m_values[below.number] - wanted,
                 at_end = m_values[above.number] - wanted;
    const double estimated = regula_falsi(at_start, at_end, largest,
                                          [&](const double t) { return estimate(t) - wanted; });
    const double result = regula_falsi(
        at_start, at_end, largest, [&](const double t) { return value_at(t) - wanted; }, estimated);
    return result < rounding ? 0 : result > 1 - rounding ? 1 : result; // so that points coincide
  }

  // A number for each side.
  class Numbers_of_sides
  {
  public:
    explicit Numbers_of_sides(const Intrinsic_triangulation& triangulation)
      : m_triangulation(triangulation), m_of_edges(triangulation.number_of_halfedges(), null_index)
    {
    }

    // null_index if there is none yet. Two faces may have the same corners, but not the same lines
    // between them, and two vertices several edges.
    std::uint32_t& at(const Side& side, const std::uint32_t a, const std::uint32_t b)
    {
      if(side.is_edge())
        return m_of_edges[(std::min)(side.halfedge, m_triangulation.opposite(side.halfedge))];
      auto& others = side.is_part_of_edge() ? m_of_parts : m_in_face;
      const std::uint64_t key =
          (std::uint64_t((std::max)(a, b)) << 32) | std::uint64_t((std::min)(a, b));
      return others.try_emplace(key, null_index).first->second;
    }

    void forget_lines_in_face()
    {
      if(!m_in_face.empty())
        m_in_face.clear();
    }

  private:
    const Intrinsic_triangulation& m_triangulation;
    std::vector<std::uint32_t> m_of_edges; // by halfedge
    std::unordered_map<std::uint64_t, std::uint32_t> m_of_parts, m_in_face;
  };

  const Search& m_search;
  const Intrinsic_triangulation& m_triangulation;
  const double m_step, m_smallest;
  Distances_on_edges<Search> m_on_edges;
  std::vector<double> m_distances;
  const std::size_t m_most_parts;
  Index m_face = null_index; // a halfedge of the present one
  Index m_face_of_distances = null_index;
  Distances_in_face m_in_face;  // of that face
  std::vector<double> m_values; // of corners; those of the vertices come first
  Numbers_of_sides m_middles, m_first_crossings;
  std::size_t m_number_of_parts = 0; // of faces and of their sides
  Offset_lines m_lines;
  std::vector<double> m_parts; // of the way along the side that a point of a line is on, by point
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_OFFSET_TRACER_H
