// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_OFFSETS_DISTANCES_ON_EDGES_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_OFFSETS_DISTANCES_ON_EDGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/angles_at_vertex.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Distances of points on edges, from what an exact search knows at vertices: the distance, the
 * direction in which the shortest path arrives, and how far the path is straight. The direction
 * gives the slope of the distance along each edge. All in units of the triangulation.
 */
template <typename Search>
class Distances_on_edges
{
public:
  // The search is referred to, not copied.
  explicit Distances_on_edges(const Search& search)
    : m_triangulation(search.graph().triangulation()),
      m_labels(search.search().labels()),
      m_slopes(m_triangulation.number_of_halfedges(), std::numeric_limits<double>::quiet_NaN()),
      m_straight(m_triangulation.number_of_vertices(), infinity)
  {
    const auto& run = search.search().graph_run();
    for(Index v = 0; v < m_triangulation.number_of_vertices(); ++v)
    {
      check_for_interruption_at(v);
      if(m_labels.is_reached(v))
      {
        set_straight(v, search);
        set_slopes(v, run.arrival(v), run.tables().steps);
      }
    }
  }

  double distance(const Index v) const { return m_labels.distance(v); }

  // The length of the last line of the path to a vertex; infinity if lines are parallel.
  double straight(const Index v) const { return m_straight[v]; }

  // The slope of the distance at the source of a halfedge; not a number if it is not known.
  double slope(const Index h) const { return m_slopes[h]; }

  // An estimate of the largest error of `at()`, off the medial axis; infinity where a direction is
  // not known, or a path may come from beside the edge.
  double error(const Index h) const
  {
    const Side side = this->side(h);
    if(!((std::min)(side.start, side.end) > side.length))
      return infinity;
    const double result = (std::min)(error_from_ends(h), error_of_cubic(h));
    return std::isnan(result) ? infinity : result;
  }

  // The distance at the part `t` of the way along the edge.
  double at(const Index h, const double t) const
  {
    const Side side = this->side(h);
    const double s = 1 - t;
    if(error_from_ends(h) <= error_of_cubic(h))
      return s * from_start(h, t * side.length) +
             t * from_start(m_triangulation.opposite(h), s * side.length);
    return side.start * s * s * (1 + 2 * t) + side.end * t * t * (1 + 2 * s) +
           side.length * s * t * (side.slope * s + side.slope_back * t);
  }

private:
  struct Side
  {
    double start, end;        // distances
    double slope, slope_back; // from the start, and from the end
    double length;
  };

  Side side(const Index h) const
  {
    return {m_labels.distance(m_triangulation.source(h)),
            m_labels.distance(m_triangulation.target(h)), m_slopes[h],
            m_slopes[m_triangulation.opposite(h)], m_triangulation.length(h)};
  }

  // The distance at `x` from the source of `h`, if all last lines start where that to the source
  // does.
  double from_start(const Index h, const double x) const
  {
    const Index v = m_triangulation.source(h);
    const double distance = m_labels.distance(v), straight = m_straight[v], slope = m_slopes[h];
    if(!(straight < infinity))
      return distance + slope * x;
    const double difference = x * (2 * straight * slope + x); // of squares
    const double end = std::sqrt((std::max)(0., straight * straight + difference));
    return end + straight > 0 ? distance + difference / (straight + end) : distance;
  }

  // The error of `from_start()` at the other end, of both directions together; not a number if a
  // slope is not known.
  double difference(const Index h) const
  {
    const Index opposite = m_triangulation.opposite(h);
    const double length = m_triangulation.length(h);
    const double at_end = from_start(h, length) - m_labels.distance(m_triangulation.target(h)),
                 at_start =
                     from_start(opposite, length) - m_labels.distance(m_triangulation.source(h));
    return std::abs(at_end) + std::abs(at_start);
  }

  // Interpolation leaves a part of the difference, which grows with the square of the way.
  double error_from_ends(const Index h) const { return difference(h) / 8; }

  // Except where paths from different directions meet, the distance is convex: between the chord
  // and the tangents at the ends, and close to the cubic function with these slopes.
  double error_of_cubic(const Index h) const
  {
    const Side side = this->side(h);
    const bool is_convex = side.slope * side.length <= side.end - side.start &&
                           side.slope_back * side.length <= side.start - side.end;
    return is_convex ? -(side.slope + side.slope_back) * side.length / 48 + difference(h) / 32
                     : infinity;
  }

  // Paths from a curve count as parallel.
  void set_straight(const Index v, const Search& search)
  {
    const auto& nodes = search.search();
    const Index before = m_labels.predecessor(v);
    if(before != null_index)
      m_straight[v] = m_labels.distance(v) - m_labels.distance(before);
    else if(search.curves().empty())
      m_straight[v] = m_labels.distance(v) -
                      search.sources()[nodes.source(v)].distance / m_triangulation.unit();
  }

  void set_slopes(const Index v, const Arrival& arrival, const Face_steps& steps)
  {
    if(!arrival.is_none() && (arrival.is_along_halfedge() || arrival.has_direction()))
      Bend_sectors(m_triangulation, steps, v)
          .for_each_angle(
              arrival, [&](const Index h, const double angle) { m_slopes[h] = -std::cos(angle); });
  }

  const Intrinsic_triangulation& m_triangulation;
  const Labels& m_labels;
  std::vector<double> m_slopes;   // by halfedge, at its source
  std::vector<double> m_straight; // by vertex: the length of the last line of the path to it
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_OFFSETS_DISTANCES_ON_EDGES_H
