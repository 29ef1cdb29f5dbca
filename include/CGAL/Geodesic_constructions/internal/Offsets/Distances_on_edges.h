// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_DISTANCES_ON_EDGES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_DISTANCES_ON_EDGES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Exact_windows.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/search_from_curves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Distances of points on an edge, from what is known at its ends: the distance, its slope along the
 * edge, and the length of the last straight line of a shortest path. In units of the triangulation.
 */
class Distances_on_edge
{
public:
  struct End
  {
    double distance;
    double slope;    // toward the other end; not a number if it is not known
    double straight; // infinity if lines are parallel

    // The distance `x` away, if the last straight line of the path starts from the same point.
    double at(const double x) const
    {
      if(!(straight < infinity))
        return distance + slope * x;
      const double difference = x * (2 * straight * slope + x); // of squares
      const double length = std::sqrt((std::max)(straight * straight + difference, 0.)); // or NaN
      return length + straight == 0 ? distance : distance + difference / (straight + length);
    }
  };

  Distances_on_edge(const End& start, const End& end, const double length)
    : m_start(start), m_end(end), m_length(length)
  {
    if(!is_near_source())
      choose_model();
  }

  // Whether sources may be beside the edge.
  bool is_near_source() const { return !((std::min)(m_start.distance, m_end.distance) > m_length); }

  // An estimate of the largest error of `at()`, and no bound. Infinity where nothing is known.
  double estimated_error() const { return m_estimated_error; }

  // The same at a part of the way. Where paths meet, those from a third point may be shorter. The
  // squares of distances from points of a plane differ by linear functions: so the error is largest
  // where the paths from the ends have the same length, and none at the ends.
  double estimated_error(const double t) const
  {
    if(!has_meeting() || !(m_estimated_error > 0))
      return m_estimated_error;
    return m_estimated_error * (t <= m_meeting ? t / m_meeting : (1 - t) / (1 - m_meeting));
  }

  // Whether paths from two points, and not from segments of curves, meet on the edge.
  bool has_meeting() const
  {
    return m_model == Model::SMALLER && (std::max)(m_start.straight, m_end.straight) < infinity;
  }

  double meeting() const { return m_meeting; }

  // The distance at the part `t` of the way.
  double at(const double t) const
  {
    const double s = 1 - t, x = t * m_length, y = s * m_length;
    if(m_model == Model::CUBIC)
      return m_start.distance * s * s * (1 + 2 * t) + m_end.distance * t * t * (1 + 2 * s) +
             m_length * s * t * (m_start.slope * s + m_end.slope * t);
    const double from_start = m_start.at(x), from_end = m_end.at(y);
    return m_model == Model::SMALLER ? (std::min)(from_start, from_end)
                                     : s * from_start + t * from_end;
  }

private:
  enum class Model
  {
    SMALLER, // of the distances on paths like those to both ends, where these meet
    MEAN,    // of nearly the same distances
    CUBIC    // between bends of paths, where the distance is convex
  };

  void choose_model()
  {
    const double at_end = m_start.at(m_length) - m_end.distance,
                 at_start = m_end.at(m_length) - m_start.distance;
    const double difference = std::abs(at_end) + std::abs(at_start);
    constexpr double rounding = 1e-9;
    if(at_end >= -rounding * m_length && at_start >= -rounding * m_length)
      return choose_meeting((std::max)(at_end, 0.), (std::max)(at_start, 0.));
    // a mean leaves a part of the difference, which grows with the square of the way
    choose(Model::MEAN, difference / 8);
    // the distance is between the chord and the tangents at the ends
    const double rise = m_end.distance - m_start.distance;
    if(m_start.slope * m_length <= rise && m_end.slope * m_length <= -rise)
      choose(Model::CUBIC, -(m_start.slope + m_end.slope) * m_length / 48 + difference / 32);
  }

  // A third point may be nearer where paths meet, but not at the ends: its distance there limits by
  // how much. Not at all, if all paths start from the same point.
  void choose_meeting(const double at_end, const double at_start)
  {
    const double sum = at_end + at_start;
    choose(Model::SMALLER, sum);
    if(!has_meeting() || !(sum > 0))
      return;
    m_estimated_error = at_end * at_start / sum;
    const double end = m_end.distance * 2 + at_end, start = m_start.distance * 2 + at_start;
    const double squares = at_end * end + at_start * start; // differences at the ends
    m_meeting = at_start * start / squares;
  }

  // Unless there is a better one.
  void choose(const Model model, const double error)
  {
    if(!(error < m_estimated_error)) // or not a number
      return;
    m_model = model;
    m_estimated_error = error;
  }

  End m_start, m_end;
  double m_length;
  Model m_model = Model::MEAN;
  double m_meeting = 0.5;
  double m_estimated_error = infinity;
};

/*
 * What an exact search knows of the distances of all edges: those of vertices, and the directions
 * in which paths arrive there, which give the slopes along edges. Where this leaves a third
 * direction open, paths are followed back to edges where it does not.
 */
template <typename Search>
class Distances_on_edges
{
public:
  // The search is referred to, not copied. It is not asked for errors up to `negligible_error`.
  Distances_on_edges(const Search& search, const double negligible_error)
    : m_search(search),
      m_negligible_error(negligible_error),
      m_triangulation(search.graph().triangulation()),
      m_windows(search.search()),
      m_labels(search.search().labels()),
      m_slopes(m_triangulation.number_of_halfedges(), std::numeric_limits<double>::quiet_NaN()),
      m_straight(m_triangulation.number_of_vertices(), infinity)
  {
    const std::vector<Point_key> ends = ends_of_segments(curves_of(search));
    for(Index v = 0; v < m_triangulation.number_of_vertices(); ++v)
    {
      check_for_interruption_at(v);
      if(m_labels.is_reached(v))
      {
        set_straight(v, ends);
        m_windows.for_each_slope(v,
                                 [&](const Index h, const double slope) { m_slopes[h] = slope; });
      }
    }
  }

  Distances_on_edge::End end(const Index h) const
  {
    const Index v = m_triangulation.source(h);
    return {m_labels.distance(v), m_slopes[h], m_straight[v]};
  }

  // From the source to the target of a halfedge.
  Distances_on_edge operator[](const Index h) const
  {
    return {end(h), end(m_triangulation.opposite(h)), m_triangulation.length(h)};
  }

  // The distance at a part of the way along an edge.
  double at(const Index h, const Distances_on_edge& on_edge, const double t) const
  {
    return on_edge.estimated_error(t) <= m_negligible_error
               ? on_edge.at(t)
               : distance(Intrinsic_point::on_edge(h, t).reduced(m_triangulation), on_edge.at(t));
  }

  // The distance of a point: over edges around whose distances are known well enough, or by the
  // search, which takes far longer. Takes less time the better the estimate.
  double distance(const Intrinsic_point& point, const double estimate) const
  {
    check_for_interruption();
    double result = distance_over_edges(point, estimate + m_negligible_error);
    if(result < infinity)
      return result;
    const double largest = (estimate + m_negligible_error) * m_triangulation.unit();
    if(largest < infinity)
      result = m_search.nearest(point, largest).distance;
    if(!(result <= largest))
      result = m_search.distance(point);
    return result / m_triangulation.unit();
  }

  double negligible_error() const { return m_negligible_error; }

private:
  using Point_key = std::tuple<Index, Index, double, double>;

  static Point_key key(const Intrinsic_point& p) { return {p.vertex, p.halfedge, p.t, p.s}; }

  static std::vector<Point_key> ends_of_segments(const std::vector<Intrinsic_curve>& curves)
  {
    std::vector<Point_key> result;
    for(const Intrinsic_curve& curve : curves)
      for(const auto& polyline : curve.polylines)
        for(const Intrinsic_point& p : polyline)
          result.push_back(key(p));
    std::sort(result.begin(), result.end());
    return result;
  }

  // Paths from the inside of a segment of a curve count as parallel.
  void set_straight(const Index v, const std::vector<Point_key>& ends)
  {
    const Index before = m_labels.predecessor(v);
    if(before != null_index)
      m_straight[v] = m_labels.distance(v) - m_labels.distance(before);
    else if(const auto path = m_search.nearest(Intrinsic_point::at_vertex(v));
            path.is_reached() &&
            (ends.empty() || std::binary_search(ends.begin(), ends.end(), key(path.start))))
      m_straight[v] =
          m_labels.distance(v) - m_search.initial_distance(path.source) / m_triangulation.unit();
  }

  // Follows the windows from a point to edges with known distances.
  struct Visitor : Sight_visitor_base
  {
    static constexpr bool ends_sights = true;
    static constexpr int most_faces = 200;

    // of the line to a vertex
    double bound(const Index v) const
    {
      return largest - (std::min)(largest, on_edges.m_labels.distance(v));
    }

    void consider(const double distance) { smallest = (std::min)(smallest, distance); }

    void on_vertex(const Index v, const Sight_path& path, const Sight&, Plane_vector, Plane_vector)
    {
      consider(on_edges.m_labels.distance(v) + path.length);
    }

    bool is_end(const Sight& sight)
    {
      const Distances_on_edge on_edge = on_edges[sight.halfedge];
      is_known = is_known && ++number_of_faces < most_faces && !on_edge.is_near_source();
      const bool is_good = on_edge.estimated_error() <= on_edges.m_negligible_error / 2;
      if(is_known && is_good)
        consider(on_edges.smallest_distance(sight, on_edge, smallest));
      return !is_known || is_good;
    }

    const Distances_on_edges& on_edges;
    double largest, smallest = infinity;
    bool is_known = true;
    int number_of_faces = 0;
  };

  // Infinity if there may be sources around, or too many edges have distances that are not known.
  double distance_over_edges(const Intrinsic_point& point, const double largest) const
  {
    if(point.is_vertex())
      return m_labels.distance(point.vertex);
    if(!(largest < infinity))
      return infinity;
    Visitor visitor{{}, *this, largest * (1 + Sight::ROUNDING)};
    m_windows.follow_from_point(
        point, 0,
        [&](const Index side, const Face_point& p, Plane_vector /* start */,
            Plane_vector /* end */) {
          visitor.consider(m_labels.distance(m_triangulation.source(side)) +
                           internal::distance(m_triangulation, p, Face_point::at_source(side)));
        },
        visitor);
    return visitor.is_known && visitor.smallest <= largest ? visitor.smallest : infinity;
  }

  // On paths from the tip of a sight through what it sees of an edge, if it is below `known`.
  double
  smallest_distance(const Sight& sight, const Distances_on_edge& on_edge, const double known) const
  {
    const double squared = dot(sight.edge, sight.edge);
    const auto part = [&](const Sight_ray& ray, const double otherwise) {
      const Plane_vector way = sight.crossing(ray, otherwise) - sight.left;
      return (std::clamp)(dot(way, sight.edge) / squared, 0., 1.);
    };
    const double begin = part(sight.left_ray, 0), end = part(sight.right_ray, 1);
    const auto distance = [&](const double t) {
      return length(sight.left + t * sight.edge) + on_edge.at(t);
    };
    // both of its terms grow no faster than one walks
    const double reach = (end - begin) * std::sqrt(squared);
    if((distance(begin) + distance(end)) / 2 - reach > known)
      return known;
    // it is convex on both sides of a meeting, up to the error that is allowed
    const double precision = m_negligible_error / (2 * std::sqrt(squared));
    const double meeting = on_edge.has_meeting() ? on_edge.meeting() : begin;
    if(!(begin < meeting && meeting < end))
      return minimum(begin, end, precision, distance);
    return (std::min)(minimum(begin, meeting, precision, distance),
                      minimum(meeting, end, precision, distance));
  }

  // The smallest value of a convex function, by golden sections that are not larger than
  // `precision` at the end: close to a point beside the edge, the function is nearly a kink.
  template <typename F>
  static double minimum(double begin, double end, const double precision, const F& f)
  {
    constexpr double part = 0.6180339887498949;
    constexpr int most_steps = 50;
    double first = end - part * (end - begin), second = begin + part * (end - begin);
    double at_first = f(first), at_second = f(second);
    double result = (std::min)({f(begin), f(end), at_first, at_second});
    for(int i = 0; i < most_steps && end - begin > precision; ++i)
    {
      const bool goes_left = at_first < at_second;
      (goes_left ? end : begin) = goes_left ? second : first;
      (goes_left ? second : first) = goes_left ? first : second;
      (goes_left ? at_second : at_first) = goes_left ? at_first : at_second;
      double& next = goes_left ? first : second;
      next = goes_left ? end - part * (end - begin) : begin + part * (end - begin);
      (goes_left ? at_first : at_second) = f(next);
      result = (std::min)({result, at_first, at_second});
    }
    return result;
  }

  const Search& m_search;
  const double m_negligible_error;
  const Intrinsic_triangulation& m_triangulation;
  const Exact_windows<typename Search::Search> m_windows;
  const Labels& m_labels;
  std::vector<double> m_slopes;   // by halfedge, at its source
  std::vector<double> m_straight; // by vertex: the length of the last line of the path to it
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_DISTANCES_ON_EDGES_H
