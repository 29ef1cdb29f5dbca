// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_SIDE_WINDOWS_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_SIDE_WINDOWS_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Surface/internal/triangulation_arrays.h>
#include <CGAL/Geodesic_constructions/internal/Cells/Focal_curve.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * What is seen of a face from one tip, which is unfolded into the plane of the face: there, the
 * distance of a point that is seen is at most `label` plus that from `tip`. The frame is that of a
 * halfedge: the source is the origin, the target is on the x axis, and the face is to the left.
 */
struct Face_window
{
  Index halfedge;           // whose edge the window lies in, unless the tip is in the face
  bool has_tip_in_face;     // or on its boundary
  std::size_t source;       // that the paths start from
  double label;             // of the tip
  Plane_vector tip;         // below the x axis, unless it is in the face
  Plane_vector right, left; // unit vectors from the tip; the window is between them

  // Where a ray from the tip crosses the x axis.
  double crossing(const Plane_vector ray) const { return tip.x - tip.y * (ray.x / ray.y); }

  Plane_vector ray_to(const double x) const
  {
    const Plane_vector ray{x - tip.x, -tip.y};
    return 1 / length(ray) * ray;
  }

  double distance(const double x) const { return label + length(Plane_vector{x - tip.x, tip.y}); }
};

/*
 * The windows through which a face is seen across one of its sides: for each point of the side, the
 * one that knows the smallest distance. All points of a path to the face are nearest to the same
 * source; so the other windows know no smallest distance in the face, either.
 */
class Side_windows
{
public:
  // A part of a side, and the window that knows the smallest distance there.
  struct Part
  {
    Face_window window;
    double begin, end;

    bool is_same(const Face_window& w) const
    {
      return window.source == w.source && window.label == w.label && window.tip.x == w.tip.x &&
             window.tip.y == w.tip.y;
    }
  };

  // `parts` is a workspace.
  void insert(const Face_window& window, const double length_of_side, std::vector<Part>& parts)
  {
    const double begin = (std::clamp)(window.crossing(window.left), 0., length_of_side),
                 end = (std::clamp)(window.crossing(window.right), 0., length_of_side);
    if(!(begin < end) || is_useless(window, begin, end))
      return;
    parts.clear();
    double way = begin; // the window is inserted up to here
    for(const Part& old : m_parts)
    {
      if(old.end <= begin || old.begin >= end)
      {
        if(old.begin >= end && way < end)
        {
          append({window, way, end}, parts);
          way = end;
        }
        append(old, parts);
        continue;
      }
      append({window, way, old.begin}, parts);
      append({old.window, old.begin, begin}, parts);
      way = (std::min)(old.end, end);
      merge(old, window, (std::max)(old.begin, begin), way, parts);
      append({old.window, end, old.end}, parts);
    }
    append({window, way, end}, parts);
    m_parts.assign(parts.begin(), parts.end());
  }

  // Calls `f(window)`.
  template <typename F>
  void for_each(F f) const
  {
    for(const Part& part : m_parts)
    {
      Face_window window = part.window;
      if(part.begin > window.crossing(window.left))
        window.left = window.ray_to(part.begin);
      if(part.end < window.crossing(window.right))
        window.right = window.ray_to(part.end);
      if(is_before(window.right, window.left))
        f(window);
    }
  }

private:
  // Whether a window is nowhere better than those that cover it: a quick test that misses some.
  bool is_useless(const Face_window& window, const double begin, const double end) const
  {
    double covered = begin;
    for(const Part& part : m_parts)
    {
      if(part.end <= covered)
        continue;
      if(part.begin > covered)
        return false;
      const double next = (std::min)(part.end, end);
      const double smallest =
          (window.distance(covered) + window.distance(next) - (next - covered)) / 2;
      const double largest = (std::max)(part.window.distance(covered), part.window.distance(next));
      if(!(smallest > largest))
        return false;
      covered = next;
      if(covered >= end)
        return true;
    }
    return false;
  }

  static void append(const Part& part, std::vector<Part>& parts)
  {
    if(!(part.begin < part.end))
      return;
    if(!parts.empty() && parts.back().end == part.begin && parts.back().is_same(part.window))
    {
      parts.back().end = part.end;
      parts.back().window.right = part.window.right;
    }
    else
      parts.push_back(part);
  }

  // Appends the better of two windows, piece by piece.
  static void merge(const Part& old,
                    const Face_window& window,
                    const double begin,
                    const double end,
                    std::vector<Part>& parts)
  {
    const Plane_vector focus = old.window.tip - window.tip;
    const double difference = window.label - old.window.label;
    boost::container::small_vector<double, 4> ends{begin};
    if(std::abs(difference) < length(focus))
    {
      const Focal_curve side = Focal_curve::line(-1. * window.tip, {1, 0});
      (Focal_curve::hyperbola(focus, difference) - side)
          .for_each_root({window.ray_to(end), window.ray_to(begin)}, [&](const Plane_vector ray) {
            ends.push_back((std::clamp)(window.crossing(ray), begin, end));
          });
    }
    ends.push_back(end);
    std::sort(ends.begin(), ends.end());
    for(std::size_t i = 1; i < ends.size(); ++i)
    {
      const double middle = (ends[i - 1] + ends[i]) / 2;
      const bool is_better = window.distance(middle) < old.window.distance(middle);
      append({is_better ? window : old.window, ends[i - 1], ends[i]}, parts);
    }
  }

  std::vector<Part> m_parts; // in the order of the side
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_SIDE_WINDOWS_H
