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
      const double length = std::sqrt((std::max)(0., straight * straight + difference));
      return length + straight > 0 ? distance + difference / (straight + length) : distance;
    }
  };

  Distances_on_edge(const End& start, const End& end, const double length)
    : m_start(start), m_end(end), m_length(length)
  {
    if((std::min)(start.distance, end.distance) > length) // or else, sources may be beside the edge
      choose_model();
  }

  // An estimate of the largest error of `at()`, and no bound: paths may come from a third
  // direction. Infinity where nothing is known.
  double estimated_error() const { return m_estimated_error; }

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
    if((std::min)(at_end, at_start) >= -rounding * m_length)
      return choose(Model::SMALLER, 0);
    // a mean leaves a part of the difference, which grows with the square of the way
    choose(Model::MEAN, difference / 8);
    // the distance is between the chord and the tangents at the ends
    const double rise = m_end.distance - m_start.distance;
    if(m_start.slope * m_length <= rise && m_end.slope * m_length <= -rise)
      choose(Model::CUBIC, -(m_start.slope + m_end.slope) * m_length / 48 + difference / 32);
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
  double m_estimated_error = infinity;
};

/*
 * What an exact search knows of the distances of all edges: those of vertices, and the directions
 * in which paths arrive there, which give the slopes along edges.
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

private:
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
