// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_VORONOI_BORDERS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_VORONOI_BORDERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queries/internal/Cells/Surface_cells.h>
#include <CGAL/Approximate_geodesics/Queries/internal/query_parameters.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsQueries
 *
 * A border between the cells of two sources.
 */
template <typename TriangleMesh>
struct Voronoi_border
{
  /// the number of no corner.
  static constexpr std::size_t null_corner = (std::numeric_limits<std::size_t>::max)();

  /// the positions of the sources in their range, in increasing order; the cell of the first is to
  /// the left, seen from outside. They are equal on a cut locus.
  std::array<std::size_t, 2> sources;

  /// the points of a polyline. Two consecutive points lie in the same face: that of the latter.
  std::vector<Face_location<TriangleMesh>> points;

  /// the numbers of the corners where it begins and ends; `null_corner` if it is closed. The last
  /// point of a closed polyline equals its first point.
  std::array<std::size_t, 2> corners;

  /// returns whether it is closed.
  bool is_closed() const { return corners[0] == null_corner; }
};

/*!
 * \ingroup PkgApproximateGeodesicsQueries
 *
 * A point where borders end: a point of three or more cells, a point of the border of the mesh, or
 * an end of a cut locus.
 */
template <typename TriangleMesh>
struct Voronoi_corner
{
  /// the point.
  Face_location<TriangleMesh> point;

  /// the sources whose cells meet, counterclockwise if there are three or more, seen from outside.
  std::vector<std::size_t> sources;
};

/*!
 * \ingroup PkgApproximateGeodesicsQueries
 *
 * What `voronoi_borders()` and `cut_locus()` return.
 */
template <typename TriangleMesh>
struct Voronoi_cells
{
  /// the area of the cell of each source; `0` if no point is nearest to the source.
  std::vector<double> areas;

  /// the borders, in no particular order.
  std::vector<Voronoi_border<TriangleMesh>> borders;

  /// where they end.
  std::vector<Voronoi_corner<TriangleMesh>> corners;

  /// returns the pairs of sources whose cells have a border in common, sorted.
  std::vector<std::array<std::size_t, 2>> neighbors() const
  {
    std::vector<std::array<std::size_t, 2>> result;
    for(const auto& border : borders)
      result.push_back(border.sources);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// returns the triangles of the dual triangulation: the sources of each corner where three cells
  /// meet, counterclockwise. Where more of them meet, their polygon is divided into triangles. If
  /// cells surround each other, or touch repeatedly, it is no triangulation in the strict sense.
  std::vector<std::array<std::size_t, 3>> triangles() const
  {
    std::vector<std::array<std::size_t, 3>> result;
    for(const auto& corner : corners)
      for(std::size_t i = 2; i < corner.sources.size(); ++i)
        result.push_back({corner.sources[0], corner.sources[i - 1], corner.sources[i]});
    return result;
  }
};

namespace internal {

// In terms of the mesh.
template <typename Translation>
Voronoi_cells<typename Translation::Triangle_mesh> cells_on_mesh(const Translation& translation,
                                                                 const Surface_cells& cells,
                                                                 const double unit,
                                                                 const Cell_network& network)
{
  Voronoi_cells<typename Translation::Triangle_mesh> result;
  for(const double area : cells.areas())
    result.areas.push_back(area * unit * unit);
  for(const Network_border& border : network.borders())
  {
    result.borders.push_back({border.sources, {}, border.corners});
    for(const Intrinsic_point& p : border.points)
      result.borders.back().points.push_back(translation.face_location(p));
  }
  for(const Network_corner& corner : network.corners())
    result.corners.push_back({translation.face_location(corner.point), corner.sources});
  return result;
}

} // namespace internal

template <typename TriangleMesh,
          typename Sources,
          typename NamedParameters = parameters::Default_named_parameters>
Voronoi_cells<TriangleMesh>
voronoi_borders(const TriangleMesh& tmesh,
                const Sources& sources,
                const NamedParameters& np = parameters::default_values())
{
  const auto graph =
      internal::graph_with_epsilon<Saddle_vertex_graph, internal::Concurrency_tag<NamedParameters>>(
          Intrinsic_triangulation(tmesh, np), 0);
  Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np), graph.triangulation());
  translation.list_vertices();
  std::vector<Source_point> points;
  for(const Intrinsic_point& p : internal::intrinsic_points(translation, sources, "source"))
    points.push_back({p});
  internal::set_initial_distances(np, points);
  Surface_search<Saddle_vertex_graph> search(graph);
  Geodesic_visitor_base visitor; // as in the compiled searches
  search.run(points, {}, visitor);
  const internal::Surface_cells cells(search, {false, 0.001*graph.arc_lengths().mean});
  return internal::cells_on_mesh(translation, cells, graph.unit(),
                                 internal::Cell_network(graph.triangulation(), cells.arcs()));
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_VORONOI_BORDERS_H
