// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_STRIPS_OF_CURVE_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_STRIPS_OF_CURVE_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/internal/Curves/Strip_expansion.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

// The largest ratio of the width of a strip to its height at which a point is such a sample.
inline double slope_of_strips(const Cone_rules& rules)
{
  const double error = rules.largest_error_of_samples();
  return std::sqrt(error * (2 + error));
}

/*
 * Follows strips of parallel rays from a segment of a curve until they are far higher than wide.
 *
 * `f(v, length, foot)` is called for vertices that are nearest to a point `foot` inside the
 * segment, along these rays, and `on_sample(sample)` for points of the segment whose lines are
 * needed, too, as strips end: those to what lies behind. From the point, the way there is longer
 * than the rays by a factor of at most `1 + Cone_rules::largest_error_of_samples()`.
 */
template <typename F, typename OnSample>
struct Strips_of_curve
{
  struct Visitor
  {
    double bound(Index /* v */) const { return infinity; }

    void on_vertex(const Index v,
                   const double length,
                   const double x,
                   const Strip& /* strip */,
                   const Plane_vector /* apex */,
                   const Plane_vector /* left_edge */)
    {
      strips.f(v, length, segment.point(strips.triangulation, x / layout.length()));
    }

    bool ends(const Strip& strip)
    {
      const double height = strip.height(), width = layout.length();
      const double begin = strip.begin / width, end = strip.end / width;
      const double t = simplest_part(begin, end);
      if(!(height > 0 && width * (std::max)(t - begin, end - t) <= strips.slope * height))
        return false;
      const auto direction = [&](const double x) {
        const Plane_vector crossing =
            strip.left + Strip::part(strip.left, strip.right, x) * strip.edge;
        return layout.in_face_layout({x - t * width, crossing.y});
      };
      strips.on_sample(Curve_sample{segment.point(strips.triangulation, t), segment.from.halfedge,
                                    direction(strip.end), direction(strip.begin)});
      return true;
    }

    // At an end of the segment, which may be a vertex, its middle, and so on.
    static double simplest_part(const double begin, const double end)
    {
      for(double step = 1; step > 1e-6; step /= 2)
        if(const double t = step * std::ceil(begin / step); t <= end)
          return t;
      return (begin + end) / 2;
    }

    const Strips_of_curve& strips;
    const Curve_segment& segment;
    const Segment_layout& layout;
  };

  // Follows those from the segment between two points, to both sides.
  void follow(const Intrinsic_point& from, const Intrinsic_point& to) const
  {
    for_each_segment(triangulation, from, to, [&](const Curve_segment& segment) {
      for(const Curve_segment& s : {segment, Curve_segment{segment.to, segment.from}})
      {
        const Segment_layout layout(triangulation, s);
        if(!(layout.length() > 0))
          continue;
        Visitor visitor{*this, s, layout};
        const Face_steps_on_demand steps(triangulation);
        Strip_expansion<Face_steps_on_demand, Visitor>(triangulation, steps, 0, visitor)
            .look(layout, is_along_halfedge(s.from, s.to));
      }
    });
  }

  const Intrinsic_triangulation& triangulation;
  double slope; // largest ratio of width to height
  F& f;
  OnSample& on_sample;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_STRIPS_OF_CURVE_H
