// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_SAMPLE_SECTOR_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_SAMPLE_SECTOR_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cones_of_point.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/internal/Curves/Strips_of_curve.h>

#include <cmath>
#include <optional>
#include <type_traits>

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
    return own.direction(side);
  const bool is_in_own_face = face_of(point.halfedge) == face_of(sample.halfedge);
  const Index h = is_in_own_face ? point.halfedge : t.opposite(point.halfedge);
  const Face_layout beyond(t, side);
  const Plane_vector edge = beyond.direction(t.opposite(h));
  return turned_left(turned_right(beyond.direction(side), -1. * edge), own.direction(h));
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

// Prunes windows that a search from samples of a curve, or from points beside them, does not need.
template <typename Labels>
Label_pruning<Leave_out_nothing, Labels>
pruning_of_samples(const Intrinsic_triangulation& triangulation,
                   const Cone_rules& rules,
                   const Labels& labels,
                   const double label_of_tip)
{
  return {{}, triangulation, labels, label_of_tip, 1 + rules.epsilon_from_samples()};
}

// Calls `f(v, length)` for the lines from an attached point of a curve that may be of use to a
// search from there. The labels, in units of the graph, are upper bounds.
template <typename Labels, typename F>
void for_each_node_in_cones(const Intrinsic_triangulation& triangulation,
                            const Cones_of_point& cones,
                            const Labels& labels,
                            F f)
{
  cones.for_each_node(pruning_of_samples(triangulation, cones.rules(), labels, 0), f);
}

// The same for the lines that a sample, which is the point, is needed for.
template <typename Labels, typename F>
void for_each_node_in_sector(const Intrinsic_triangulation& triangulation,
                             const Cones_of_point& cones,
                             const Curve_sample& sample,
                             const Labels& labels,
                             F f)
{
  if(sample.point.is_vertex()) // a node
    return f(sample.point.vertex, 0.);
  const auto pruning = pruning_of_samples(triangulation, cones.rules(), labels, 0);
  cones.for_each_view([&](const View& view) {
    if(const auto sector = sector_of_sample(triangulation, sample.point, sample, view))
      cones.for_each_node_in_view(view,
                                  In_sector<std::decay_t<decltype(pruning)>>{pruning, *sector}, f);
    else
      cones.for_each_node_in_view(view, pruning, f);
  });
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_SAMPLE_SECTOR_H
