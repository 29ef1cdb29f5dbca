// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_VORONOI_BORDERS_H
#define CGAL_GEODESIC_CONSTRUCTIONS_VORONOI_BORDERS_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Queries/internal/compiled_searches.h>
#include <CGAL/Geodesic_constructions/internal/Cells/Surface_cells.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicConstructionsCells
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
 * \ingroup PkgGeodesicConstructionsCells
 *
 * A point where borders end: a point of three or more cells, a point of the border of the mesh, or
 * an end of a cut locus.
 */
template <typename TriangleMesh>
struct Voronoi_corner
{
  /// the point.
  Face_location<TriangleMesh> point;

  /// the sources whose cells meet, counterclockwise if there are three or more, seen from outside;
  /// in increasing order if a cell comes to the corner from several sides, or if several corners
  /// are one, up to rounding.
  std::vector<std::size_t> sources;
};

/*!
 * \ingroup PkgGeodesicConstructionsCells
 *
 * What `voronoi_borders()` and `cut_locus()` return.
 */
template <typename TriangleMesh>
struct Voronoi_cells
{
  /// the area of the cell of each source; `0` if no point is nearest to the source, and infinity if
  /// it exceeds the largest number. They add up to the area that is reached, up to a millionth.
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

template <typename NamedParameters>
double chord_error(const NamedParameters& np, const double mean_edge, const double unit)
{
  if constexpr(is_given<NamedParameters, internal_np::chord_error_t>)
  {
    const double result = to_double(parameters::get_parameter(np, internal_np::chord_error));
    if(!(result > 0))
      reject("the chord error is " + text_of(result) + "; it must be a positive number");
    return result / unit;
  }
  constexpr double part = 1e-3;
  return part * mean_edge;
}

// Across edges without length, it is not known in which direction lines of sight continue.
inline void reject_edges_without_length(const Intrinsic_triangulation& triangulation)
{
  for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(!(triangulation.length(h) > 0))
      reject("the edge between vertices " +
             std::to_string(triangulation.index(triangulation.source(h))) + " and " +
             std::to_string(triangulation.index(triangulation.target(h))) +
             " has no length; borders of cells need edges with a positive length");
}

// Searches from the sources, and divides the surface.
template <typename TriangleMesh, typename Sources, typename NamedParameters>
Voronoi_cells<TriangleMesh> cells_of(const TriangleMesh& tmesh,
                                     const Sources& sources,
                                     const bool within_cells,
                                     const NamedParameters& np)
{
  static_assert(!ignores_any<NamedParameters, internal_np::edge_length_t,
                             internal_np::initial_distances_t, internal_np::chord_error_t>,
                "voronoi_borders() and cut_locus() are exact, and read edge_length_map, "
                "initial_distances and chord_error only");
  const auto graph = exact_graph(tmesh, np);
  reject_edges_without_length(graph.triangulation());
  Mesh_translation translation(tmesh, vertex_index_map(tmesh, np), graph.triangulation());
  std::vector<Source_point> points;
  for(const Intrinsic_point& p : intrinsic_points(translation, sources, "source"))
    points.push_back({p});
  set_initial_distances(np, points);
  const double error = chord_error(np, graph.arc_lengths().mean, graph.unit());
  Surface_search<Saddle_vertex_graph> search(graph);
  Geodesic_visitor_base visitor; // as in the compiled searches
  search.run(std::move(points), {}, visitor);
  const Surface_cells cells(search, {within_cells, error});
  translation.list_vertices();
  return cells_on_mesh(translation, cells, graph.unit(),
                       Cell_network(graph.triangulation(), cells.arcs()));
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsCells
 *
 * computes the Voronoi diagram of points on the surface: the borders between the cells of the
 * points that are nearest to each source, their areas, and their neighbors.
 *
 * Borders are exact, up to rounding, like the distances that `epsilon(0)` finds: straight segments
 * in the unfolded faces where two sources of the same initial distance are seen directly, and arcs
 * of hyperbolas elsewhere. A polyline follows an arc: all of its points are at the same distance
 * from both sources, and the arc is at most `chord_error` away from it. Borders may be closed, and
 * two cells may have several borders in common. Where two sources are at the same distance from all
 * points of a region, as behind a saddle vertex that is at the same distance from both, one of them
 * gets the region. Of equal sources, the first one gets the cell.
 *
 * As in SurfaceVoronoi \cgalCite{xsctw-gvd-22}, each face is divided among the sources that reach
 * it. Here, distances in it are exact: the cell of an unfolded source or saddle vertex is bounded
 * by an envelope of conics with a common focus. Faces that are \f$10^5\f$ times longer than wide
 * are not divided, as rounding would matter: borders may have gaps there.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam Sources `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, `Face_location`,
 *         `Surface_point`, or a model of `ConstRange` with one of these as value type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param sources the sources: vertices, points on edges or in faces
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map`, `edge_length_map`, `initial_distances`, `concurrency_tag`,
 *           `vertex_index_map`, `halfedge_index_map` and `geom_traits`, as for
 *           `approximate_geodesic_distances()`, and the one listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{chord_error}
 *     \cgalParamDescription{the largest distance of an arc from its polyline, in the unit of the
 *                           mesh: a positive number. An arc in a face has at most 1,000 parts}
 *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
 *     \cgalParamDefault{a thousandth of the mean length of edges}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the areas, borders, and corners. With initial distances, the cell of a source may be
 *         empty: its area is `0`, and it has no borders. Parts of the surface without a source
 *         belong to no cell.
 *
 * \throws std::invalid_argument as `approximate_geodesic_distances()` does, if an edge has length
 *         zero, if `chord_error` is not positive, and if areas do not add up because of rounding,
 *         as where vertices nearly coincide. The message says what is wrong, and names the face
 *         where areas are farthest off.
 * \throws std::length_error if `tmesh` has too many halfedges for 32-bit indices.
 *
 * It takes an exact search, and then the time to follow all lines once more, and to divide the
 * faces that several sources see.
 *
 * \sa `voronoi_partition()`
 * \sa `cut_locus()`
 */
template <typename TriangleMesh,
          typename Sources,
          typename NamedParameters = parameters::Default_named_parameters>
Voronoi_cells<TriangleMesh>
voronoi_borders(const TriangleMesh& tmesh,
                const Sources& sources,
                const NamedParameters& np = parameters::default_values())
{
  return internal::cells_of(tmesh, sources, false, np);
}

/*!
 * \ingroup PkgGeodesicConstructionsCells
 *
 * computes the cut locus of a point: the points of the surface that several shortest paths from
 * there lead to.
 *
 * On a triangulated surface of genus 0 without border, it is a tree that leads to all vertices with
 * an angle of less than \f$2\pi\f$ but the source, and has no leaves elsewhere. On a smooth
 * surface, most branches are short. The same function finds the points with several shortest paths
 * to a set of sources, the borders of their cells among them.
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param source the point, or a range of points, as for `voronoi_borders()`
 * \param np named parameters as for `voronoi_borders()`
 *
 * \return as `voronoi_borders()`; the two sources of a border can be the same. Polylines end where
 *         three of them or more meet, or one ends.
 *
 * \throws std::invalid_argument, std::length_error as `voronoi_borders()` does.
 *
 * It takes an exact search, and the time to follow all lines once more and to divide all faces.
 */
template <typename TriangleMesh,
          typename Sources,
          typename NamedParameters = parameters::Default_named_parameters>
Voronoi_cells<TriangleMesh> cut_locus(const TriangleMesh& tmesh,
                                      const Sources& source,
                                      const NamedParameters& np = parameters::default_values())
{
  return internal::cells_of(tmesh, source, true, np);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_VORONOI_BORDERS_H
