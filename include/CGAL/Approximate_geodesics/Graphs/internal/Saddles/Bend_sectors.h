// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_BEND_SECTORS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_BEND_SECTORS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Arrival.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Bends.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Face_steps.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The sectors around a vertex that shortest paths may go on to, if they arrive there on a given
 * line: those that leave an angle of at least pi to that line, on both sides.
 */
class Bend_sectors
{
  using Index = Intrinsic_triangulation::Index;

public:
  Bend_sectors(const Intrinsic_triangulation& triangulation, const Face_steps& steps, const Index v)
    : m_triangulation(triangulation), m_steps(steps), m_vertex(v)
  {
  }

  // One end of a sector: a direction in the face to the left of a halfedge, which is the x axis.
  struct Boundary
  {
    Index halfedge = Intrinsic_triangulation::null_index;
    Plane_vector direction = {1, 0};

    bool exists() const { return halfedge != Intrinsic_triangulation::null_index; }
  };

  // Where, counterclockwise from the line, the angle gets to pi; nowhere if there is a border
  // before.
  Boundary right_boundary(const Arrival& arrival) const
  {
    Index h = side(arrival);
    if(!m_steps[h].has_face())
      return {};
    Plane_vector angle = turned_right(corner(h), way_back(arrival));
    angle = turned_left(angle.y > 0 ? angle : Plane_vector{1, 0}, slack());
    if(angle.y <= 0 &&
       angle.x < 0) // the rest of the face and the slack are a straight angle already
      angle = {-1, 0};
    for(Index n = m_triangulation.degree(m_vertex); n > 0; --n)
    {
      h = m_triangulation.counterclockwise(m_vertex, h);
      if(!m_steps[h].has_face())
        return {};
      const Plane_vector next = turned_left(angle, corner(h));
      if(!(next.y > 0) && (next.x < 0 || next.y < 0))
        return {h, {-angle.x, angle.y}};
      angle = next;
    }
    return {};
  }

  // The same clockwise.
  Boundary left_boundary(const Arrival& arrival) const
  {
    Index h = side(arrival);
    Plane_vector angle = turned_left(way_back(arrival), slack());
    if(angle.y <= 0 && angle.x < 0) // the line and the slack are a straight angle already
      angle = {-1, 0};
    for(Index n = m_triangulation.degree(m_vertex); n > 0; --n)
    {
      h = m_triangulation.clockwise(m_vertex, h);
      if(!m_steps[h].has_face())
        return {};
      const Plane_vector c = corner(h), next = turned_left(angle, c);
      if(!(next.y > 0) && (next.x < 0 || next.y < 0))
        return {h, turned_right(c, {-angle.x, angle.y})};
      angle = next;
    }
    return {};
  }

  // Where the line comes from, and an angle to the right of that, or to the left; the face's side
  // if there is a border before.
  Boundary right_of(const Arrival& arrival, const double angle) const
  {
    Index h = side(arrival);
    Plane_vector direction = turned_right(way_back(arrival), unit_vector(angle));
    for(Index n = m_triangulation.degree(m_vertex); n > 0 && direction.y < 0; --n)
    {
      const Index next = m_triangulation.clockwise(m_vertex, h);
      if(!m_steps[next].has_face())
        return {h, {1, 0}};
      h = next;
      direction = turned_left(direction, corner(h));
    }
    return {h, direction.y < 0 ? Plane_vector{1, 0} : direction};
  }

  // does not exist if there is no border, and the angle is not less than all around the vertex

  Boundary left_of(const Arrival& arrival, const double angle) const
  {
    Index h = side(arrival);
    Plane_vector direction = turned_left(way_back(arrival), unit_vector(angle));
    for(Index n = m_triangulation.degree(m_vertex); n > 0; --n)
    {
      if(!m_steps[h].has_face())
        return {h, {1, 0}};
      if(!(cross(corner(h), direction) > 0))
        return {h, direction};
      const Index next = m_triangulation.counterclockwise(m_vertex, h);
      if(!m_steps[next].has_face())
        return {h, corner(h)};
      direction = turned_right(direction, corner(h));
      h = next;
    }
    return {};
  }

private:
  // `angle` is small
  static Plane_vector unit_vector(const double angle)
  {
    return 1 / std::sqrt(1 + angle * angle) * Plane_vector{1, angle};
  }

  static Plane_vector slack() { return unit_vector(Arrival::ROUNDING); }

  // The halfedge from the vertex whose face the line has come through, or that it has come along.
  Index side(const Arrival& arrival) const
  {
    if(arrival.is_along_halfedge())
      return m_triangulation.opposite(arrival.halfedge);
    return m_triangulation.next(m_triangulation.next(arrival.halfedge));
  }

  static Plane_vector way_back(const Arrival& arrival)
  {
    return arrival.is_along_halfedge() ? Plane_vector{1, 0} : arrival.way_back();
  }

  Plane_vector corner(const Index h) const { return unit_corner(m_steps[h]); }

  const Intrinsic_triangulation& m_triangulation;
  const Face_steps& m_steps;
  const Index m_vertex;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_BEND_SECTORS_H
