// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_LOOP_STRAIGHTENER_H
#define CGAL_GEODESIC_CONSTRUCTIONS_LOOP_STRAIGHTENER_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Straightening/Sleeve_straightener.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/// \cond SKIP_IN_MANUAL

/*!
 * \ingroup PkgGeodesicConstructionsLoops
 *
 * Makes closed paths locally shortest. A path from a point back to it, its base, is straightened
 * with both ends fixed; then the base moves along the loop, and the old one is straightened.
 *
 * Each such step makes the loop shorter, and a loop with its base at a vertex is determined by the
 * faces that it passes. So it takes a finite number of steps.
 *
 * Weighted faces and barriers are not supported: points along a barrier do not tell on which side
 * of it a loop is. Along a border, there is only one side.
 */
class Loop_straightener
{
public:
  /// a straightener for loops on `triangulation`, with at most 1,000 steps more for each loop than
  /// there are vertices.
  /// \warning `triangulation` is referred to, not copied.
  explicit Loop_straightener(const Intrinsic_triangulation& triangulation)
    : Loop_straightener(triangulation, 1000 + std::size_t(triangulation.number_of_vertices()))
  {
  }

  /// a straightener with at most this number of steps for each loop.
  Loop_straightener(const Intrinsic_triangulation& triangulation,
                    const std::size_t largest_number_of_steps)
    : m_triangulation(triangulation), m_largest_number_of_steps(largest_number_of_steps)
  {
  }

  /// returns a closed path that `loop` can be moved to on the surface, that is not longer, and
  /// locally shortest: straight across edges, with no angle below \f$\pi\f$ on either side at a
  /// vertex, unless there is the border. If `loop` contracts to a point, it consists of one point.
  ///
  /// The first point of a loop is also its last one. Each point shares a face or an edge with the
  /// next.
  ///
  /// \throws std::runtime_error if it is not locally shortest after the largest number of steps.
  Path shortened(const Path& loop) const
  {
    const auto base = std::find_if(loop.points.begin(), loop.points.end(),
                                   [](const Intrinsic_point& p) { return !p.is_in_face(); });
    if(base == loop.points.end()) // all in the same face
      return {{loop.points.front()}, 0};
    Path result =
        tightened(rotated(loop.points, static_cast<std::size_t>(base - loop.points.begin())));
    for(std::size_t i = 0; !is_point(result) && shorten(result); ++i)
      if(i == m_largest_number_of_steps)
        throw std::runtime_error(internal::name_of_package() +
                                 "the loop is not locally shortest after " + std::to_string(i) +
                                 " steps; its length is " +
                                 internal::text_of(result.length * m_triangulation.unit()));
    return finished(std::move(result));
  }

  /// returns a path like `shortened()`, but one from the first point of `path` to its last one.
  /// They may be the same point: then there may be an angle below \f$\pi\f$.
  Path shortened_with_fixed_ends(const Path& path) const
  {
    Path result = tightened(path.points);
    while(!is_point(result) && replace(result, result.points))
      ;
    return finished(std::move(result));
  }

private:
  using Points = std::vector<Intrinsic_point>;

  // Lengths are in units of the triangulation until a loop is finished.
  Path finished(Path loop) const
  {
    if(is_point(loop))
      return {{loop.points.front()}, 0};
    loop.length *= m_triangulation.unit();
    return loop;
  }

  Path tightened(const Points& points) const
  {
    internal::check_for_interruption();
    const internal::Path_steps steps(m_triangulation, points);
    if(!std::isfinite(steps.length())) // the points do not form a path
      return {points, steps.length()};
    Path result;
    result.points = internal::tightened_points(m_triangulation, steps);
    result.length = internal::length_of_segments(m_triangulation, result.points);
    return is_point(result) || result.length <= steps.length() ? result
                                                               : Path{steps.points, steps.length()};
  }

  bool is_point(const Path& loop) const
  {
    return std::all_of(loop.points.begin(), loop.points.end(), [&](const Intrinsic_point& p) {
      return p.is_same(loop.points.front(), m_triangulation);
    });
  }

  // Replaces a loop by the straightened `points` if that makes it shorter.
  bool replace(Path& loop, const Points& points) const
  {
    constexpr double rounding = 1e-12;
    Path next = tightened(points);
    if(!is_point(next) && !(next.length < loop.length * (1 - rounding)))
      return false;
    loop = std::move(next);
    return true;
  }

  // ----- moving the base

  // The loop is locally shortest except at its base. If it is not shorter from a vertex where it
  // bends, then it is locally shortest there, too.
  bool shorten(Path& loop) const
  {
    const std::size_t middle = loop.points.size() / 2, bend = bend_next_to(middle, loop.points);
    if(bend > 0)
      return replace(loop, rotated(loop.points, bend));
    if(!loop.points.front().is_vertex())
      for(const bool is_left : {true, false})
      {
        const Points points = through_vertex(loop.points, is_left);
        if(!points.empty() && replace(loop, points))
          return true;
      }
    return replace(loop, rotated(loop.points, middle));
  }

  // 0 if there are no vertices but the base
  static std::size_t bend_next_to(const std::size_t middle, const Points& points)
  {
    const std::size_t last = points.size() - 1;
    for(std::size_t i = 0; i < last; ++i)
      for(const std::size_t j : {middle + i, middle - i})
        if(j > 0 && j < last && points[j].is_vertex()) // or below 0
          return j;
    return 0;
  }

  static Points rotated(const Points& points, const std::size_t base)
  {
    const auto middle = points.begin() + static_cast<std::ptrdiff_t>(base);
    Points result(middle, points.end());
    result.insert(result.end(), points.begin() + 1, middle + 1);
    return result;
  }

  // A straight loop with an angle at its base can be moved toward that side until it meets a
  // vertex. In the plane, one round around the loop is a rotation, the same for each point. The
  // vertex is the one that is farthest from the center, so it moves farthest; only vertices on that
  // side move less than the base. No points if there is no such vertex, or if the loop turns back
  // at its base.
  Points through_vertex(const Points& points, const bool is_left) const
  {
    Points rounds = points;
    for(int i = 0; i < 2; ++i)
      rounds.insert(rounds.end(), points.begin() + 1, points.end());
    Points result;
    internal::Path_sleeves(m_triangulation, internal::Path_steps(m_triangulation, rounds))
        .for_each_sleeve([&](const internal::Sleeve& sleeve, const Intrinsic_point&) {
          result = through_vertex(sleeve, is_left);
        });
    return result;
  }

  // `sleeve` is that of three rounds.
  static Points through_vertex(const internal::Sleeve& sleeve, const bool is_left)
  {
    const std::size_t size = (sleeve.gates().size() + 1) / 3; // that of the base may be left out
    if(!is_periodic(sleeve, size))
      return {};
    internal::Funnel plane;
    plane.find(sleeve);
    const auto distance = [&](const std::size_t gate) {
      return internal::length(plane.position(gate + size, is_left) - plane.position(gate, is_left));
    };
    std::size_t best = 0;
    for(std::size_t i = 1; i < size; ++i)
      if(distance(i) > distance(best))
        best = i;
    while(best > 0 && sleeve.is_kept(best, is_left))
      --best;
    return around(sleeve, sleeve.range(best, is_left), size);
  }

  static bool is_periodic(const internal::Sleeve& sleeve, const std::size_t size)
  {
    const auto& gates = sleeve.gates();
    bool result = size > 0 && gates.size() >= 3 * size - 1;
    for(std::size_t i = 0; result && i + size < gates.size(); ++i)
      result = gates[i].halfedge == gates[i + size].halfedge;
    return result;
  }

  // One round from a vertex: any curve in the sleeve.
  static Points
  around(const internal::Sleeve& sleeve, const internal::Gate_range& vertex, const std::size_t size)
  {
    Points result(1, Intrinsic_point::at_vertex(sleeve.vertex(vertex)));
    for(std::size_t i = vertex.beyond; i < vertex.first + size; ++i)
      result.push_back(Intrinsic_point::on_edge(sleeve.gates()[i].halfedge, 0.5));
    result.push_back(result.front());
    return result;
  }

  const Intrinsic_triangulation& m_triangulation;
  const std::size_t m_largest_number_of_steps;
};

/// \endcond

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_LOOP_STRAIGHTENER_H
