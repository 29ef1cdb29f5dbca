// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_SOURCE_CURVE_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_SOURCE_CURVE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_curve.h>

#include <set>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicConstructionsSources
 *
 * A curve on the surface of a mesh, all points of which are sources:
 * `approximate_geodesic_distances()` and `Surface_mesh_shortest_path` compute distances from the
 * nearest of them.
 *
 * Consecutive points that lie in the same face, or on its border, are joined by a straight line.
 * All others are joined by a shortest path of the graph that is searched: along edges, if that is
 * where paths run.
 *
 * The curve may cross itself, run along edges and through vertices, and have points more than once.
 */
template <typename TriangleMesh>
struct Source_curve
{
  /// the vertices of the curve, in order; at least one.
  std::vector<Surface_point<TriangleMesh>> points;

  /// whether the last point is joined to the first one.
  bool is_closed = false;
};

/*!
 * \ingroup PkgGeodesicConstructionsSources
 *
 * A set of faces, all points of which are sources: distances are `0` there, and outside those from
 * the border of the set.
 */
template <typename TriangleMesh>
struct Source_region
{
  /// the faces, in any order; at least one. Duplicates are allowed.
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> faces;
};

namespace internal {

template <typename TriangleMesh, typename T>
constexpr bool is_curve =
    std::is_same_v<T, Source_curve<TriangleMesh>> || std::is_same_v<T, Source_region<TriangleMesh>>;

// Whether `T` is a curve or a region of a mesh, or a range of them.
template <typename TriangleMesh, typename T>
constexpr bool are_curves =
    is_curve<TriangleMesh, T> || is_curve<TriangleMesh, Element_of_range<T>>;

// Returns the first point of a curve, or a corner of one of its faces.
inline Intrinsic_point first_point(const Intrinsic_triangulation& triangulation,
                                   const Intrinsic_curve& curve)
{
  return curve.polylines.empty()
             ? Intrinsic_point::at_vertex(triangulation.source(curve.faces.front()))
             : curve.polylines.front().front();
}

// Converts a region. Its border is divided into closed polylines.
template <typename Translation>
Intrinsic_curve intrinsic_curve(const Translation& translation,
                                const Intrinsic_triangulation& triangulation,
                                const Source_region<typename Translation::Triangle_mesh>& region)
{
  if(region.faces.empty())
    reject("a region has no faces");
  Intrinsic_curve result;
  std::set<Index> faces; // their smallest halfedges
  for(const auto f : region.faces)
  {
    const Index h = translation.halfedge_of(f);
    if(faces.insert(triangulation.first_of_face(h)).second)
      result.faces.push_back(h);
  }
  const auto is_inside = [&](const Index h) {
    return !triangulation.is_border(h) && faces.count(triangulation.first_of_face(h)) > 0;
  };
  std::set<Index> passed;
  for(const Index face : result.faces)
    for(Index h : triangulation.halfedges_of_face(face))
    {
      if(is_inside(triangulation.opposite(h)) || passed.count(h) > 0)
        continue;
      auto& polyline = result.polylines.emplace_back();
      while(passed.insert(h).second)
      {
        polyline.push_back(Intrinsic_point::at_vertex(triangulation.source(h)));
        h = triangulation.next(h);
        while(is_inside(triangulation.opposite(h)))
          h = triangulation.next(triangulation.opposite(h));
      }
      polyline.push_back(polyline.front());
    }
  return result;
}

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_SOURCE_CURVE_H
