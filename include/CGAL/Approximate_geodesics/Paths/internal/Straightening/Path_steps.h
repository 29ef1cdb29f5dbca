// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_PATH_STEPS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_PATH_STEPS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_segments.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A segment of a path. If it leads along an edge, it is known which: both points are seen from the
 * halfedge that the path follows.
 */
struct Step : Segment
{
  Index edge = Intrinsic_triangulation::null_index;

  bool is_along_edge() const { return edge != Intrinsic_triangulation::null_index; }
};

/*
 * A path's vertices and points of edges, and how it gets from each to the next. Points inside faces
 * are left out, but for the first and the last one, and so are those between two steps along the
 * same edge.
 */
class Path_steps
{
public:
  using Index = Intrinsic_triangulation::Index;

  Path_steps(const Intrinsic_triangulation& triangulation, const std::vector<Intrinsic_point>& path)
    : m_triangulation(triangulation)
  {
    for(std::size_t i = 0; i < path.size(); ++i)
      if(i == 0 || i + 1 == path.size() || !path[i].is_in_face())
        add(path[i].reduced(triangulation));
  }

  // The sum of the steps; infinity if two of them do not meet.
  double length() const
  {
    double result = 0;
    for(const Step& s : steps)
      result += s.length;
    return result;
  }

  std::vector<Intrinsic_point> points;
  std::vector<Step> steps;

private:
  void add(const Intrinsic_point& p)
  {
    while(!points.empty())
    {
      if(p.is_vertex() && p.vertex == points.back().vertex)
        return;
      const Step next = step(points.back(), p);
      if(steps.empty() || !is_along_same_edge(steps.back(), next) || turns_at_barrier(next))
      {
        steps.push_back(next);
        break;
      }
      points.pop_back();
      steps.pop_back();
    }
    points.push_back(p);
  }

  bool is_along_same_edge(const Step& a, const Step& b) const
  {
    return a.is_along_edge() && b.is_along_edge() &&
           (a.edge == b.edge || a.edge == m_triangulation.opposite(b.edge));
  }

  // Whether a path that turns back here may do so to get to the other side.
  bool turns_at_barrier(const Step& next) const
  {
    return points.back().is_vertex() && m_triangulation.is_barrier(next.edge);
  }

  Step step(const Intrinsic_point& p, const Intrinsic_point& q) const
  {
    Step result{Segment_finder(m_triangulation).segment(p, q)};
    if(std::isinf(result.length) || !result.from.is_on_edge() || !result.to.is_on_edge())
      return result;
    for(const Index h : {result.from.halfedge, result.to.halfedge})
    {
      const Face_point from = result.from.seen_from(m_triangulation, h);
      const Face_point to = result.to.seen_from(m_triangulation, h);
      if(from.is_on_edge() && to.is_on_edge())
      {
        follow_edge(from, to, result);
        break;
      }
    }
    return result;
  }

  void follow_edge(const Face_point& from, const Face_point& to, Step& step) const
  {
    const bool is_forward = from.weight[1] <= to.weight[1]; // points next to an end are at it
    step.edge = is_forward ? from.halfedge : m_triangulation.opposite(from.halfedge);
    step.from = is_forward ? from : Face_point{step.edge, {from.weight[1], from.weight[0], 0}};
    step.to = is_forward ? to : Face_point{step.edge, {to.weight[1], to.weight[0], 0}};
  }

  const Intrinsic_triangulation& m_triangulation;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_STRAIGHTENING_PATH_STEPS_H
