// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_SOURCE_CURVE_H
#define CGAL_GEODESIC_CONSTRUCTIONS_SOURCE_CURVE_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Queries/internal/other_sources.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/internal/Curves/Curve_reader.h>
#include <CGAL/Geodesic_constructions/internal/Curves/signed_distances.h>
#include <CGAL/Geodesic_constructions/search_from_curves.h>

#include <utility>
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

// Searches from curves and regions.
template <typename TriangleMesh>
struct Curve_or_region
{
  using Read = Intrinsic_curve;

  template <typename Graph, typename Translation, typename Source>
  static Intrinsic_curve
  read(const Graph& graph, const Translation& translation, const Source& source)
  {
    return Curve_reader(graph, translation).read(source);
  }

  template <typename Graph, typename Translation, typename Sources>
  static std::vector<Intrinsic_curve>
  read_all(const Graph& graph, const Translation& translation, const Sources& sources)
  {
    return Curve_reader(graph, translation).read_all(sources);
  }

  static Intrinsic_curve of_point(const Source_point& source)
  {
    return {{{source.point}}, {}, source.distance};
  }

  // The first point of a curve, or a corner of one of the faces.
  static Intrinsic_point first_point(const Intrinsic_triangulation& triangulation,
                                     const Intrinsic_curve& curve)
  {
    return curve.polylines.empty()
               ? Intrinsic_point::at_vertex(triangulation.source(curve.faces.front()))
               : curve.polylines.front().front();
  }

  template <typename SurfaceSearch>
  static auto attach(const typename SurfaceSearch::Graph& graph, std::vector<Intrinsic_curve> all)
  {
    return attached_curves<SurfaceSearch>(graph, std::move(all));
  }
};

template <typename TriangleMesh>
struct Other_source<TriangleMesh, Source_curve<TriangleMesh>> : Curve_or_region<TriangleMesh>
{
};

template <typename TriangleMesh>
struct Other_source<TriangleMesh, Source_region<TriangleMesh>> : Curve_or_region<TriangleMesh>
{
};

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_SOURCE_CURVE_H
