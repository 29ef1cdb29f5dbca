// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_PREDICTED_DISTANCES_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_PREDICTED_DISTANCES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <tuple>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Distances of points of faces, predicted from the path to a corner of the face after an exact
 * search: its last line starts from a point, or is one of the parallel rays from a segment of a
 * curve. If the same point or segment is nearest to the other point, and nothing is in between, the
 * prediction is exact. If it is not, predictions from the corners differ.
 */
template <typename Search>
class Predicted_distances
{
public:
  explicit Predicted_distances(const Search& search)
    : m_triangulation(search.graph().triangulation()),
      m_angle(m_triangulation.number_of_halfedges())
  {
    for(const Intrinsic_curve& curve : search.curves())
      for(const auto& polyline : curve.polylines)
        for(const Intrinsic_point& p : polyline)
          m_points_of_curves.insert(key(p));
    for(Index v = 0; v < m_triangulation.number_of_vertices(); ++v)
      m_lines.push_back(last_line(search, v));
  }

  // At a vector from the source of `h` across the face to its left, where `h` is the x axis; in
  // units of the triangulation, and infinity if it cannot be told.
  double distance(const Index h, const Plane_vector way) const
  {
    const Last_line& line = m_lines[m_triangulation.source(h)];
    if(!(line.total_angle > 0))
      return infinity;
    const double r = length(way);
    double angle = std::abs(line.angle - m_angle[h] - angle_of(way));
    angle = (std::min)(angle, std::abs(line.total_angle - angle));
    if(angle >= straight_angle)
      return line.label + line.length + r;
    const double along = r * std::cos(angle);
    if(line.is_parallel)
      return line.label + line.length - along;
    return line.label + std::sqrt((std::max)(0., line.length * (line.length - 2 * along) + r * r));
  }

private:
  // The last line of the path to a vertex.
  struct Last_line
  {
    double label = 0, length = 0; // that of its start, and its own
    double angle = 0;             // of the way back
    double total_angle = 0;       // of the vertex; 0 if there is no prediction
    bool is_parallel = false;
  };

  static auto key(const Intrinsic_point& p)
  {
    return std::make_tuple(p.vertex, p.halfedge, p.t, p.s);
  }

  Last_line last_line(const Search& search, const Index v)
  {
    const auto& labels = search.search().labels();
    if(!search.search().is_reached(v))
      return {};
    const Index before = search.search().predecessor(v);
    Last_line result;
    if(before == null_index)
    {
      const auto answer = search.nearest(Intrinsic_point::at_vertex(v));
      if(search.curves().empty())
        result.label = search.sources()[answer.source].distance / m_triangulation.unit();
      else
      {
        result.label = search.curves()[answer.source].distance / m_triangulation.unit();
        result.is_parallel = m_points_of_curves.count(key(answer.start)) == 0;
      }
    }
    else
      result.label = labels.distance(before);
    result.length = labels.distance(v) - result.label;
    const double total = add_angles(v);
    const Arrival arrival = search.search().graph_run().arrival(v);
    if(arrival.is_none() || !(result.length > 0))
      return {};
    if(arrival.is_along_halfedge())
      result.angle = m_angle[m_triangulation.opposite(arrival.halfedge)];
    else if(arrival.has_direction())
      result.angle = m_angle[m_triangulation.next(m_triangulation.next(arrival.halfedge))] +
                     angle_of(arrival.way_back());
    else
      return {};
    result.total_angle = total;
    return result;
  }

  // Sets the angles of the halfedges of a vertex, and returns the total angle; 0 at the border.
  double add_angles(const Index v)
  {
    double sum = 0;
    bool is_inside = true;
    for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v); ++h)
    {
      m_angle[h] = sum;
      if(m_triangulation.is_border(h))
        is_inside = false;
      else
        sum += angle_of(corner_angle(m_triangulation, h));
    }
    return is_inside ? sum : 0;
  }

  const Intrinsic_triangulation& m_triangulation;
  std::vector<double> m_angle; // of halfedges around their sources, from the first one on
  std::vector<Last_line> m_lines;
  std::set<std::tuple<Index, Index, double, double>> m_points_of_curves;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_PREDICTED_DISTANCES_H
