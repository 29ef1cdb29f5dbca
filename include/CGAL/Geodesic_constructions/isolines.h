// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_ISOLINES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_ISOLINES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Mesh_links.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

/*
 * The isoline that separates the vertices below a value from the others. Vertices with exactly this
 * value count as above, which avoids special cases: the line crosses the edges of a face either
 * twice or not at all, once along an ascending halfedge and once along a descending one, whose
 * opposite ascends in the adjacent face.
 */
template <typename TriangleMesh, typename DistanceMap, typename PointMap, typename Traits>
class Isoline
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

public:
  using Polyline = std::vector<typename boost::property_traits<PointMap>::value_type>;

  Isoline(const TriangleMesh& tmesh,
          const DistanceMap& distance_map,
          const PointMap& point_map,
          const Traits& traits,
          const double isovalue)
    : m_mesh(tmesh),
      m_distance_map(distance_map),
      m_point_map(point_map),
      m_traits(traits),
      m_isovalue(isovalue)
  {
  }

  template <typename OutputIterator>
  OutputIterator write(OutputIterator polylines)
  {
    std::vector<halfedge_descriptor> entries;
    for(const face_descriptor f : faces(m_mesh))
      if(is_crossed(f))
      {
        halfedge_descriptor h = halfedge(f, m_mesh);
        while(!goes_up(h))
          h = next(h, m_mesh);
        entries.push_back(h);
      }
    m_not_passed.insert(entries.begin(), entries.end());

    for(const bool from_end : {true, false}) // then closed polylines remain
      for(const halfedge_descriptor h : entries)
        if(m_not_passed.count(h) > 0 && !(from_end && continues_behind(h)))
        {
          Polyline polyline = follow(h);
          if(polyline.size() > 1) // a single point if only one vertex is above
            *polylines++ = std::move(polyline);
        }
    return polylines;
  }

private:
  double value(const vertex_descriptor v) const { return CGAL::to_double(get(m_distance_map, v)); }

  bool is_above(const vertex_descriptor v) const { return value(v) >= m_isovalue; }

  bool goes_up(const halfedge_descriptor h) const
  {
    return !is_above(source(h, m_mesh)) && is_above(target(h, m_mesh));
  }

  bool is_crossed(const face_descriptor f) const
  {
    bool has_above = false, has_below = false;
    for(const vertex_descriptor v : vertices_around_face(halfedge(f, m_mesh), m_mesh))
    {
      if(!std::isfinite(value(v)))
        return false;
      (is_above(v) ? has_above : has_below) = true;
    }
    return has_above && has_below;
  }

  bool continues_behind(const halfedge_descriptor h) const
  {
    const halfedge_descriptor g = opposite(h, m_mesh);
    return !is_border(g, m_mesh) && is_crossed(face(g, m_mesh));
  }

  // Returns the polyline from the edge of `h` to its end, or back to its start if it is closed.
  Polyline follow(halfedge_descriptor h)
  {
    Polyline result(1, point(h));
    while(m_not_passed.erase(h) > 0)
    {
      h = next(h, m_mesh); // to the descending halfedge of the face, and across it
      h = opposite(is_above(target(h, m_mesh)) ? next(h, m_mesh) : h, m_mesh);
      auto p = point(h);
      if(p != result.back()) // consecutive crossings may coincide at a vertex
        result.push_back(std::move(p));
    }
    return result;
  }

  // Returns the intersection of the line with the edge of an ascending halfedge.
  typename Polyline::value_type point(const halfedge_descriptor h) const
  {
    const vertex_descriptor below = source(h, m_mesh), above = target(h, m_mesh);
    const double low = value(below), high = value(above);
    if(high == m_isovalue)
      return get(m_point_map, above);
    return m_traits.construct_barycenter_3_object()(
        get(m_point_map, above), typename Traits::FT(part(low, m_isovalue, high)),
        get(m_point_map, below));
  }

  // Returns the interpolation parameter of a value between `low` and `high`, whose difference may
  // overflow.
  static double part(const double low, const double value, const double high)
  {
    if(std::isinf(high - low))
      return (value / 2 - low / 2) / (high / 2 - low / 2);
    return (value - low) / (high - low);
  }

  const TriangleMesh& m_mesh;
  const DistanceMap& m_distance_map;
  const PointMap& m_point_map;
  const Traits& m_traits;
  double m_isovalue;
  std::set<halfedge_descriptor> m_not_passed; // ascending halfedges not yet visited
};

// Converts and checks a single value or a range of values.
template <typename Isovalues>
std::vector<double> numbers(const Isovalues& isovalues)
{
  std::vector<double> result;
  if constexpr(boost::is_detected_v<Begin_of_range, Isovalues>)
    for(const auto& isovalue : isovalues)
      result.push_back(CGAL::to_double(isovalue));
  else
    result.push_back(CGAL::to_double(isovalues));
  for(std::size_t i = 0; i < result.size(); ++i)
    if(std::isnan(result[i]))
      reject("isovalue " + std::to_string(i) + ", counted from 0, is not a number");
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsFields
 *
 * computes the isolines of a piecewise linear function, given by its values at the vertices, at one
 * or several isovalues.
 *
 * The part of the surface with smaller values is to the left of an isoline: isolines of a distance
 * field run counterclockwise around its sources, seen from outside. An isoline consists of
 * polylines, with a segment in each crossed face, which are closed or end at a border of the mesh
 * or of the part that was reached. If a vertex has exactly the isovalue, polylines pass through it,
 * without a repeated point; if all points of an edge or a face have the isovalue, polylines go
 * around them.
 *
 * To cut the mesh along isolines, use `CGAL::Polygon_mesh_processing::refine_mesh_at_isolevel()` of
 * \cgal 5.6 or later.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeGraph`
 * \tparam VertexDistanceMap a model of `ReadablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type
 *         convertible by `CGAL::to_double()` as value type
 * \tparam Isovalues a number type convertible by `CGAL::to_double()`, or a model of `ConstRange`
 *         with such a value type
 * \tparam OutputIterator a model of `OutputIterator` that takes `std::vector<Point_3>`, where
 *         `Point_3` is the value type of the vertex point map
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param vertex_distance_map one value per vertex, for example from
 *        `approximate_geodesic_distances()`; faces with an infinite value or NaN have no isolines
 * \param isovalues one isovalue, or a range; infinite isovalues have no isolines
 * \param polylines receives the polylines, ordered by isovalue; the last point of a closed polyline
 *        equals its first point
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map` and `geom_traits`, as for `approximate_geodesic_distances()`
 *
 * \return the output iterator, after the last polyline.
 *
 * \throws std::invalid_argument if a face is not a triangle, or an isovalue is NaN. The message
 *         names the face or the isovalue. In this case, nothing is written.
 *
 * Run time is \cgalBigO{n + k \log k} per isovalue, for `n` faces, `k` of which are crossed by the
 * isoline.
 *
 * \sa `approximate_geodesic_distances()`
 * \sa `gradient()`
 */
template <typename TriangleMesh,
          typename VertexDistanceMap,
          typename Isovalues,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator isolines(const TriangleMesh& tmesh,
                        const VertexDistanceMap& vertex_distance_map,
                        const Isovalues& isovalues,
                        OutputIterator polylines,
                        const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::ignores_any<NamedParameters>,
                "isolines() reads vertex_point_map and geom_traits only; other parameters "
                "are for the function that computes the distances");
  using Traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;

  internal::check_triangles(tmesh);
  const std::vector<double> values = internal::numbers(isovalues);
  const auto point_map = internal::vertex_point_map(tmesh, np);
  const auto traits =
      parameters::choose_parameter<Traits>(parameters::get_parameter(np, internal_np::geom_traits));

  for(const double isovalue : values)
    polylines =
        internal::Isoline(tmesh, vertex_distance_map, point_map, traits, isovalue).write(polylines);
  return polylines;
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_ISOLINES_H
