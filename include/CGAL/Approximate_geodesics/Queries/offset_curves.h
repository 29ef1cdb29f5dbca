// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_OFFSET_CURVES_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_OFFSET_CURVES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Fronts.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Approximate_geodesics/Queries/isolines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsQueries
 *
 * A polyline at constant distance from a curve, or from other sources. What is nearer to the
 * sources is on its left, seen from outside.
 */
template <typename Point_3>
struct Offset_curve
{
  /// the distance from the sources.
  double distance = 0;

  /// whether the curve is closed: the first point is not repeated then. It is open only where it
  /// ends at a border of the mesh.
  bool is_closed = false;

  /// the points, in order.
  std::vector<Point_3> points = {};
};

namespace internal {

/*
 * Isolines of exact distances. Faces are divided where the distance is far from linear: near the
 * sources, at edges that are long for their distance. Whether an edge is divided depends on nothing
 * but the edge, so that faces fit together. Where isolines cross edges is found by evaluating the
 * distance there, and not by linear interpolation.
 */
template <typename Search>
class Offset_tracer
{
public:
  struct Line
  {
    std::size_t number; // of the distance
    bool is_closed;
    std::vector<Intrinsic_point> points;
  };

  // `distances` are sorted. `step` is what errors are relative to. The search has found all
  // distances up to the limit.
  Offset_tracer(const Search& search,
                std::vector<double> distances,
                const double step,
                const double limit)
    : m_search(search),
      m_triangulation(search.graph().triangulation()),
      m_fronts(search, limit / m_triangulation.unit()),
      m_distances(std::move(distances)),
      m_step(step)
  {
  }

  std::vector<Line> trace()
  {
    for(Index v = 0; v < m_triangulation.number_of_vertices(); ++v)
      m_values.push_back(m_search.distance(Intrinsic_point::at_vertex(v)));
    for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
    {
      check_for_interruption_at(h);
      if(!m_triangulation.is_border(h) && m_triangulation.first_of_face(h) == h)
        add_face(h);
    }
    return lines();
  }

private:
  // A corner of a part of a face.
  struct Corner
  {
    std::uint32_t number;
    std::array<double, 3> weight; // in the face
  };
  using Triangle = std::array<Corner, 3>;

  static constexpr double LARGEST_ERROR = 2e-3; // in steps

  // Of a point of the present face.
  double value(const Corner& c) const
  {
    double result = infinity;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Plane_vector way =
          c.weight[(i + 1) % 3] * m_sides[i][0] + c.weight[(i + 2) % 3] * m_sides[i][1];
      result = (std::min)(result, m_fronts.distance(m_halfedges[i], way));
    }
    return result * m_triangulation.unit();
  }

  void add_face(const Index h)
  {
    m_halfedges = m_triangulation.halfedges_of_face(h);
    Triangle triangle;
    for(std::size_t i = 0; i < 3; ++i)
    {
      triangle[i] = {m_triangulation.source(m_halfedges[i]), {0, 0, 0}};
      triangle[i].weight[i] = 1;
    }
    for(const Corner& c : triangle)
      if(!(m_values[c.number] < infinity))
        return;
    std::array<double, 3> lengths;
    for(std::size_t i = 0; i < 3; ++i)
      lengths[i] = m_triangulation.length(m_halfedges[i]) * m_triangulation.unit();
    const Face_layout layout(m_triangulation, h);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Plane_vector side = layout.edge(i, (i + 1) % 3);
      const double l = length(side);
      const Plane_vector x_axis = l > 0 ? 1 / l * side : Plane_vector{1, 0};
      m_sides[i] = {turned_right(side, x_axis), turned_right(layout.edge(i, (i + 2) % 3), x_axis)};
    }
    divide(triangle, lengths, 0);
  }

  // `lengths[i]` is that of the side from corner `i` to the next one.
  void divide(const Triangle& t, const std::array<double, 3>& lengths, const int depth)
  {
    constexpr int deepest = 24;
    const auto [low, high] = range(t);
    const double reach = *std::max_element(lengths.begin(), lengths.end());
    const auto first = std::lower_bound(m_distances.begin(), m_distances.end(), low - reach);
    if(first == m_distances.end() || *first > high + reach)
      return;
    std::array<bool, 3> is_divided{};
    for(std::size_t i = 0; i < 3; ++i)
      is_divided[i] = depth < deepest && is_long(t[i], t[(i + 1) % 3], lengths[i]);
    const auto number = std::count(is_divided.begin(), is_divided.end(), true);
    if(number == 0)
      return add_triangle(t, low, high);
    std::size_t start = 0; // of a divided side, whose predecessor is not divided if there are two
    while(!is_divided[start] || (number == 2 && is_divided[(start + 2) % 3]))
      ++start;
    const auto a = t[start], b = t[(start + 1) % 3], c = t[(start + 2) % 3];
    const double ab = lengths[start], bc = lengths[(start + 1) % 3], ca = lengths[(start + 2) % 3];
    const Corner m = middle(a, b);
    if(number == 1)
    {
      const double mc = median(ab, bc, ca);
      divide({a, m, c}, {ab / 2, mc, ca}, depth + 1);
      return divide({m, b, c}, {ab / 2, bc, mc}, depth + 1);
    }
    const Corner n = middle(b, c);
    divide({m, b, n}, {ab / 2, bc / 2, ca / 2}, depth + 1);
    if(number == 2)
    {
      const double mc = median(ab, bc, ca);
      divide({a, m, c}, {ab / 2, mc, ca}, depth + 1);
      return divide({m, n, c}, {ca / 2, bc / 2, mc}, depth + 1);
    }
    const Corner o = middle(c, a);
    divide({a, m, o}, {ab / 2, bc / 2, ca / 2}, depth + 1);
    divide({o, n, c}, {ab / 2, bc / 2, ca / 2}, depth + 1);
    divide({m, n, o}, {ca / 2, ab / 2, bc / 2}, depth + 1);
  }

  std::pair<double, double> range(const Triangle& t) const
  {
    const auto [low, high] =
        std::minmax({m_values[t[0].number], m_values[t[1].number], m_values[t[2].number]});
    return {low, high};
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

  static std::uint64_t key(const std::uint32_t a, const std::uint32_t b)
  {
    return (std::uint64_t((std::max)(a, b)) << 32) | (std::min)(a, b);
  }

  Corner between(const Corner& a, const Corner& b, const double t, const std::uint32_t number) const
  {
    Corner result{number, {}};
    for(std::size_t i = 0; i < 3; ++i)
      result.weight[i] = (1 - t) * a.weight[i] + t * b.weight[i];
    return result;
  }

  Corner middle(const Corner& a, const Corner& b)
  {
    const auto [it, is_new] =
        m_middles.try_emplace(key(a.number, b.number), static_cast<std::uint32_t>(m_values.size()));
    const Corner result = between(a, b, 0.5, it->second);
    if(is_new)
      m_values.push_back(value(result));
    return result;
  }

  Intrinsic_point point(const Corner& c) const
  {
    const Face_point p{m_halfedges[0], c.weight};
    return Curve_segment{p, p}.point(m_triangulation, 0);
  }

  void add_triangle(const Triangle& t, const double low, const double high)
  {
    const auto first = std::upper_bound(m_distances.begin(), m_distances.end(), low);
    for(auto it = first; it != m_distances.end() && *it <= high; ++it)
    {
      const auto number = static_cast<std::size_t>(it - m_distances.begin());
      const auto is_above = [&](const std::size_t i) { return m_values[t[i % 3].number] >= *it; };
      std::size_t way_in = 0, way_out = 0;
      while(is_above(way_in) || !is_above(way_in + 1))
        ++way_in;
      while(!is_above(way_out) || is_above(way_out + 1))
        ++way_out;
      const std::size_t from = crossing(t[way_in], t[(way_in + 1) % 3], number);
      const std::size_t to = crossing(t[(way_out + 1) % 3], t[way_out], number);
      m_next[from] = to;
      m_has_previous[to] = true;
    }
  }

  // The number of the crossing of an isoline with the edge from a corner below it to one above.
  std::size_t crossing(const Corner& below, const Corner& above, const std::size_t number)
  {
    auto& of_edge = m_crossings[key(below.number, above.number)];
    for(const auto& [n, result] : of_edge)
      if(n == number)
        return result;
    const std::size_t result = m_points.size();
    of_edge.emplace_back(number, result);
    m_points.push_back({number, point(between(below, above, part(below, above, number), 0))});
    m_next.push_back(none);
    m_has_previous.push_back(false);
    return result;
  }

  // Where the distance has a value, as a part of the way: by linear interpolation between points
  // that come closer to each other.
  double part(const Corner& below, const Corner& above, const std::size_t number) const
  {
    const double wanted = m_distances[number];
    double start = 0, end = 1;
    double at_start = m_values[below.number] - wanted, at_end = m_values[above.number] - wanted;
    double result = -at_start / (at_end - at_start);
    for(int i = 0; i < 8; ++i)
    {
      const double here = value(between(below, above, result, 0)) - wanted;
      if(!(std::abs(here) > LARGEST_ERROR * m_step))
        break;
      (here < 0 ? start : end) = result;
      (here < 0 ? at_start : at_end) = here;
      result = start + (end - start) * (-at_start / (at_end - at_start));
    }
    return result;
  }

  std::vector<Line> lines()
  {
    std::vector<Line> result;
    std::vector<bool> is_done(m_points.size());
    for(const bool is_closed : {false, true}) // those that end at a border come first
      for(std::size_t i = 0; i < m_points.size(); ++i)
      {
        if(is_done[i] || (!is_closed && m_has_previous[i]))
          continue;
        Line line{m_points[i].first, is_closed, {}};
        for(std::size_t j = i; j != none && !is_done[j]; j = m_next[j])
        {
          is_done[j] = true;
          if(line.points.empty() ||
             !m_points[j].second.is_same(line.points.back(), m_triangulation))
            line.points.push_back(m_points[j].second);
        }
        if(line.points.size() > 1)
          result.push_back(std::move(line));
      }
    std::stable_sort(result.begin(), result.end(),
                     [](const Line& a, const Line& b) { return a.number < b.number; });
    return result;
  }

  static constexpr std::size_t none = std::size_t(-1);

  const Search& m_search;
  const Intrinsic_triangulation& m_triangulation;
  const Fronts<Search> m_fronts;
  const std::vector<double> m_distances;
  const double m_step;
  std::array<Index, 3> m_halfedges{};                   // of the present face
  std::array<std::array<Plane_vector, 2>, 3> m_sides{}; // from each corner; the first is the x axis
  std::vector<double> m_values; // of corners; those of the vertices come first
  std::unordered_map<std::uint64_t, std::uint32_t> m_middles;
  std::unordered_map<std::uint64_t, std::vector<std::pair<std::size_t, std::size_t>>> m_crossings;
  std::vector<std::pair<std::size_t, Intrinsic_point>> m_points; // with the number of the distance
  std::vector<std::size_t> m_next;
  std::vector<bool> m_has_previous;
};

inline std::vector<double> checked_offsets(std::vector<double> distances)
{
  for(std::size_t i = 0; i < distances.size(); ++i)
    if(!(distances[i] > 0 && distances[i] < infinity))
      reject("offset " + std::to_string(i) + ", counted from 0, is " + text_of(distances[i]) +
             "; it must be a finite number larger than 0");
  std::sort(distances.begin(), distances.end());
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  return distances;
}

// The smallest difference of two offsets, or of the first one and the source.
inline double smallest_step(const std::vector<double>& distances)
{
  double result = distances.front();
  for(std::size_t i = 1; i < distances.size(); ++i)
    result = (std::min)(result, distances[i] - distances[i - 1]);
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsQueries
 *
 * computes curves at given distances from sources, such as tool paths at constant distance from
 * each other.
 *
 * Distances are exact, and are evaluated where an offset curve crosses an edge, so its points have
 * the distance up to 0.2 % of the smallest step between two offsets. Between them, it is straight;
 * faces near the sources are divided for that. At points that have several shortest paths to the
 * sources (the medial axis), offset curves have corners, which may be cut off by up to a face.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam Sources as for `approximate_geodesic_distances()`
 * \tparam Distances a number type convertible by `CGAL::to_double()`, or a model of `ConstRange`
 * with such a value type \tparam OutputIterator a model of `OutputIterator` that takes
 * `Offset_curve<Point_3>`, where `Point_3` is the value type of the vertex point map \tparam
 * NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param sources a point, a curve or a region of the surface, or a range of these
 * \param distances the distances of the offset curves, in the unit of the mesh: finite, and larger
 *        than `0`; their order does not matter
 * \param curves receives the offset curves, ordered by distance; a distance may have any number of
 *        them
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *        `vertex_point_map`, `vertex_index_map`, `halfedge_index_map`, `geom_traits` and
 *        `concurrency_tag`, as for `approximate_geodesic_distances()`
 *
 * \return the output iterator, after the last curve.
 *
 * \throws std::invalid_argument as `approximate_geodesic_distances()` does with `epsilon(0)`, and
 * if a distance is not finite or not larger than `0`. Nothing is written then.
 *
 * Run time is that of an exact search up to the largest distance, and then the time to follow all
 * lines once more, and to evaluate the distance of each point of the curves a few times.
 *
 * \sa `approximate_geodesic_distances()`
 * \sa `isolines()`
 */
template <typename TriangleMesh,
          typename Sources,
          typename Distances,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator offset_curves(const TriangleMesh& tmesh,
                             const Sources& sources,
                             const Distances& distances,
                             OutputIterator curves,
                             const NamedParameters& np = parameters::default_values())
{
  const std::vector<double> offsets = internal::checked_offsets(internal::numbers(distances));
  if(offsets.empty())
    return curves;
  const Saddle_vertex_graph graph(Intrinsic_triangulation(tmesh, np));
  Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np), graph.triangulation());
  translation.list_vertices();
  auto point_map = internal::vertex_point_map(tmesh, np);
  using Point_3 = typename boost::property_traits<decltype(point_map)>::value_type;
  internal::Mesh_search<Saddle_vertex_graph, Adaptive_bucket_queue, decltype(translation),
                        decltype(point_map)>
      search(graph, translation, std::move(point_map));
  const double margin = 2 * graph.arc_lengths().longest * graph.unit();
  const double limit = offsets.back() + margin;
  search.run_from(sources, parameters::maximum_distance(limit));
  internal::Offset_tracer tracer(search.search(), offsets, internal::smallest_step(offsets), limit);
  for(const auto& line : tracer.trace())
  {
    Offset_curve<Point_3> curve{offsets[line.number], line.is_closed, {}};
    for(const Intrinsic_point& p : line.points)
      curve.points.push_back(search.point(p, np));
    *curves++ = std::move(curve);
  }
  return curves;
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_OFFSET_CURVES_H
