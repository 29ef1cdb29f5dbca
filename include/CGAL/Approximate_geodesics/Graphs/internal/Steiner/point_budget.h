// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINT_BUDGET_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINT_BUDGET_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

// How many points there may be on all edges of a graph together. They are counted before there is
// any memory for them, in time that depends on the number of edges only.

namespace CGAL::Approximate_geodesics::internal {

// The limit that was given, or by default, if it is 0: as many as small bounds take on large
// meshes, and on small meshes what a search takes some seconds for. A point takes about 50 bytes of
// a graph and a search.
inline std::size_t maximum_number_of_points(const Intrinsic_triangulation& triangulation,
                                            const std::size_t given)
{
  constexpr double smallest = 1e6, per_edge = 1000, largest = 1e8;
  const double by_default =
      (std::clamp)(per_edge * (triangulation.number_of_halfedges() / 2), smallest, largest);
  return given > 0 ? given : static_cast<std::size_t>(by_default);
}

// A sum of numbers of points that does not overflow.
class Number_of_points
{
public:
  static constexpr double FAR_TOO_MANY = 1e12;

  void add(const std::size_t number) { m_sum += double(number); }
  bool is_above(const std::size_t limit) const { return m_sum > double(limit); }

  friend std::string to_string(const Number_of_points& number)
  {
    return number.m_sum < FAR_TOO_MANY ? std::to_string(static_cast<long long>(number.m_sum))
                                       : std::string("more than 10^12");
  }

private:
  double m_sum = 0; // exact as far as it is told
};

// Whether there are more points than the limit on the edges that paths may cross.
template <typename Placement>
bool has_more_points(const Intrinsic_triangulation& triangulation,
                     const Placement& placement,
                     const std::size_t limit)
{
  using Index = Intrinsic_triangulation::Index;
  Number_of_points sum;
  for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(h < triangulation.opposite(h) && triangulation.is_crossable(h) &&
       triangulation.length(h) > 0)
      sum.add(placement.number_of_points(triangulation, h));
  return sum.is_above(limit);
}

// What makes a placement take fewer points, for a message; nothing if it has no bound, or has
// accepted a weaker one.
template <typename Placement>
auto advice_on_points(const Placement& placement, int)
    -> decltype(placement.accepts_weaker_bound(), std::string())
{
  return placement.accepts_weaker_bound()
             ? ""
             : "; fewer are enough for a larger epsilon, or with accept_weaker_bound(true)";
}
template <typename Placement>
std::string advice_on_points(const Placement& /* placement */, long)
{
  return "";
}

// Says how many points there would be, and on which edge most of them.
[[noreturn]] inline void refuse_points(const Intrinsic_triangulation& triangulation,
                                       const Number_of_points& number,
                                       const Intrinsic_triangulation::Index halfedge_with_most,
                                       const std::size_t number_there,
                                       const std::size_t limit,
                                       const std::string& advice)
{
  Number_of_points on_edge;
  on_edge.add(number_there);
  const auto index = [&](const Intrinsic_triangulation::Index h) {
    return std::to_string(triangulation.index(triangulation.target(h)));
  };
  throw std::length_error("Approximate_geodesics: the graph takes " + to_string(number) +
                          " points on edges, " + to_string(on_edge) + " of them between vertices " +
                          index(triangulation.opposite(halfedge_with_most)) + " and " +
                          index(halfedge_with_most) + ", and maximum_number_of_points is " +
                          std::to_string(limit) + advice);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINT_BUDGET_H
