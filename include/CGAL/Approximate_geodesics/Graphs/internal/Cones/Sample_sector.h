// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_SAMPLE_SECTOR_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_SAMPLE_SECTOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_curve.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL::Approximate_geodesics::internal {

// The directions between which the lines from a sample of a curve are needed, in the layout of a
// view.
struct Sample_sector
{
  Plane_vector right, left;

  bool contains_part_of(const Window& w) const
  {
    return !is_beyond(w.right_position, left) && !is_beyond(right, w.left_position);
  }

private:
  // Whether a ray is to the left of another one, by more than rounding errors.
  static bool is_beyond(const Plane_vector a, const Plane_vector b)
  {
    constexpr double rounding = 1e-6;
    return cross(a, b) <
           -rounding * (std::abs(a.x) + std::abs(a.y)) * (std::abs(b.x) + std::abs(b.y));
  }
};

// Prunes windows that are outside of a sector, too.
template <typename Visitor>
struct In_sector : Visitor
{
  bool prune(const Window& w) const { return !sector.contains_part_of(w) || Visitor::prune(w); }

  Sample_sector sector;
};

// The direction of a vector; zero, which is beyond no ray, if its length is.
inline Plane_vector direction_of(const Plane_vector v)
{
  const double l = length(v);
  return l > 0 ? 1 / l * v : Plane_vector{0, 0};
}

// The direction of a halfedge of a face in its layout.
inline Plane_vector unit_vector(const Face_layout& layout, const Index h)
{
  std::size_t i = 0;
  while(layout.halfedge(i) != h)
    ++i;
  return direction_of(layout.edge(i, (i + 1) % 3));
}

// The direction of a side of a face that contains the point, which is the sample, in the layout of
// the sample's face. The latter may be on the other side of an edge that the point lies on; none if
// that is the same face.
inline std::optional<Plane_vector> direction_of_side(const Intrinsic_triangulation& t,
                                                     const Intrinsic_point& point,
                                                     const Curve_sample& sample,
                                                     const Index side)
{
  const auto face_of = [&](const Index h) { return t.first_of_face(h); };
  if(point.is_on_edge() && !t.is_border(t.opposite(point.halfedge)) &&
     face_of(point.halfedge) == face_of(t.opposite(point.halfedge)))
    return std::nullopt;
  const Face_layout own(t, sample.halfedge);
  if(face_of(side) == face_of(sample.halfedge))
    return unit_vector(own, side);
  const bool is_in_own_face = face_of(point.halfedge) == face_of(sample.halfedge);
  const Index h = is_in_own_face ? point.halfedge : t.opposite(point.halfedge);
  const Face_layout beyond(t, side);
  const Plane_vector edge = unit_vector(beyond, t.opposite(h));
  return turned_left(turned_right(unit_vector(beyond, side), -1. * edge), unit_vector(own, h));
}

// The sector of a sample in a view from its point; none where it is not known.
inline std::optional<Sample_sector> sector_of_sample(const Intrinsic_triangulation& triangulation,
                                                     const Intrinsic_point& point,
                                                     const Curve_sample& sample,
                                                     const View& view)
{
  const Window& w = view.window;
  const bool has_area = cross(w.right_position, w.left_position) > 0;
  const auto other = direction_of_side(triangulation, point, sample, view.start);
  if(!has_area || !other)
    return std::nullopt;
  const Plane_vector side = direction_of(-1. * w.edge);
  const auto in_view = [&](const Plane_vector v) {
    return turned_left(turned_right(v, *other), side);
  };
  return Sample_sector{in_view(sample.right), in_view(sample.left)};
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_SAMPLE_SECTOR_H
