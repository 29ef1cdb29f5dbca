// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_MESH_TRANSLATION_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_MESH_TRANSLATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Mesh_links.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Origin.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Approximate_geodesics {

namespace internal {

// Returns the mesh whose descriptors `tmesh` uses. Overloaded for a part of a mesh.
template <typename TriangleMesh>
const TriangleMesh& whole(const TriangleMesh& tmesh)
{
  return tmesh;
}

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * Converts between points on the surface of a mesh, which are vertices, points on edges or points
 * in faces, and points of its intrinsic triangulation, on which `Surface_search` operates.
 *
 * All `const` member functions are thread-safe. Functions that return elements or points of the
 * mesh require a list of its vertices: call `list_vertices()` before.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertices of the mesh as keys and
 *         an integer type as value type
 */
template <typename TriangleMesh, typename VertexIndexMap>
class Mesh_translation
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Index = Intrinsic_triangulation::Index;

public:
  /// \name Types
  /// @{

  /// the mesh.
  using Triangle_mesh = TriangleMesh;

  /// a vertex of the mesh.
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;

  /// a halfedge of the mesh.
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

  /// a face of the mesh.
  using face_descriptor = typename Graph_traits::face_descriptor;

  /// @}

  /// \name Creation
  /// @{

  /// constructs a translation for `tmesh` and the triangulation built from it with the same index
  /// map.
  /// \warning Both are referred to, not copied.
  Mesh_translation(const TriangleMesh& tmesh,
                   VertexIndexMap vertex_index_map,
                   const Intrinsic_triangulation& triangulation)
    : m_mesh(&tmesh),
      m_vertex_index_map(std::move(vertex_index_map)),
      m_triangulation(&triangulation)
  {
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the mesh.
  const TriangleMesh& mesh() const { return *m_mesh; }

  /// returns the vertex index map.
  const VertexIndexMap& index_map() const { return m_vertex_index_map; }

  /// checks that the mesh has as many vertices and halfedges as the triangulation.
  /// \throws std::invalid_argument otherwise.
  ///
  /// Run time is linear.
  void check_size() const
  {
    // num_vertices() of some mesh types includes removed vertices
    const Intrinsic_triangulation& t = *m_triangulation;
    const auto count = [](const auto& range) {
      return static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    };
    const std::size_t v = count(vertices(*m_mesh)), h = count(halfedges(*m_mesh));
    if(v != t.number_of_vertices() || h != t.number_of_halfedges())
      internal::reject("the graph belongs to another mesh: it has " +
                       std::to_string(t.number_of_vertices()) + " vertices and " +
                       std::to_string(t.number_of_halfedges()) + " halfedges, and the mesh has " +
                       std::to_string(v) + " and " + std::to_string(h));
  }

  /// @}

  /// \name From the Mesh to Its Triangulation
  /// These functions throw `std::invalid_argument` if an element is not in the mesh, or coordinates
  /// are invalid; the message names it.
  /// @{

  /// returns the index of the vertex `v` in the triangulation.
  Index node(const vertex_descriptor v) const
  {
    if(v == Graph_traits::null_vertex())
      internal::reject("the null vertex is not in the mesh");
    const auto index = get(m_vertex_index_map, v);
    const Index result = m_triangulation->vertex(static_cast<std::size_t>(index));
    if(result == Intrinsic_triangulation::null_index)
      internal::reject("vertex " + std::to_string(index) + " is not in the mesh");
    return result;
  }

  /// returns whether a node is a vertex, as opposed to a point that a graph has added.
  bool is_vertex(const Index node) const { return node < m_triangulation->number_of_vertices(); }

  /// returns the point at the vertex `v`.
  Intrinsic_point intrinsic_point(const vertex_descriptor v) const
  {
    return Intrinsic_point::at_vertex(node(v));
  }

  /// returns the point at the parameter `t` along `h`: `0` is its source, `1` is its target.
  Intrinsic_point intrinsic_point(const halfedge_descriptor h, const double t) const
  {
    using internal::whole;
    internal::check_point(h, t, whole(*m_mesh));
    if(t < internal::rounding_of_weights || 1 - t < internal::rounding_of_weights)
      return intrinsic_point(t < internal::rounding_of_weights ? source(h, *m_mesh)
                                                               : target(h, *m_mesh));
    return Intrinsic_point::on_edge(number(h), t);
  }

  /// returns the point of the face `f` with the given barycentric coordinates. If some of them are
  /// zero, it is a point on an edge or a vertex.
  template <typename FT>
  Intrinsic_point intrinsic_point(const face_descriptor f,
                                  const std::array<FT, 3>& coordinates) const
  {
    using internal::whole;
    const std::array<double, 3> weights = internal::checked_weights(f, coordinates, whole(*m_mesh));
    const halfedge_descriptor h = halfedge(f, *m_mesh);
    const std::array<halfedge_descriptor, 3> sides{h, next(h, *m_mesh), prev(h, *m_mesh)};
    for(std::size_t i = 0; i < 3; ++i)
      if(weights[i] == 1)
        return intrinsic_point(source(sides[i], *m_mesh));
    const Index first = number(h);
    const std::array<Index, 3> numbers = m_triangulation->halfedges_of_face(first);
    for(std::size_t i = 0; i < 3; ++i)
      if(weights[(i + 2) % 3] == 0)
        return Intrinsic_point::on_edge(numbers[i], weights[(i + 1) % 3]);
    return Intrinsic_point::in_face(first, weights[1], weights[2]);
  }

  /// returns the first halfedge of the face `f`.
  Index halfedge_of(const face_descriptor f) const
  {
    using internal::whole;
    internal::checked_weights(f, std::array<double, 3>{1, 0, 0}, whole(*m_mesh));
    return number(halfedge(f, *m_mesh));
  }

  /// returns the point at a face location, or at a parameter along a halfedge.
  template <typename Element, typename Coordinates>
  Intrinsic_point intrinsic_point(const std::pair<Element, Coordinates>& location) const
  {
    return intrinsic_point(location.first, location.second);
  }

  /// converts a point of the surface.
  Intrinsic_point intrinsic_point(const Surface_point<TriangleMesh>& point) const
  {
    return std::visit([this](const auto& p) { return this->intrinsic_point(p); }, point);
  }

  /// @}

  /// \name From the Triangulation to the Mesh
  /// @{

  /// lists the vertices, which the following functions require. Run time and memory are
  /// \cgalBigO{n}.
  void list_vertices()
  {
    std::vector<vertex_descriptor> result(m_triangulation->number_of_vertices(),
                                          Graph_traits::null_vertex());
    for(const vertex_descriptor v : vertices(*m_mesh))
    {
      vertex_descriptor& listed = result[node(v)];
      if(listed != Graph_traits::null_vertex())
        internal::reject("vertex index " + std::to_string(get(m_vertex_index_map, v)) +
                         " is assigned to more than one vertex");
      listed = v;
    }
    m_vertices = std::move(result);
  }

  /// returns the listed vertices, in the order of the triangulation.
  const std::vector<vertex_descriptor>& vertex_list() const { return m_vertices; }

  /// returns the vertex with the index `node` in the triangulation.
  vertex_descriptor vertex(const Index node) const
  {
    if(node >= m_vertices.size())
      internal::reject("there is no vertex " + std::to_string(node) +
                       " in the list: call list_vertices() before");
    return m_vertices[node];
  }

  /// returns the halfedge with the index `h` in the triangulation. Run time is linear in the degree
  /// of its source.
  halfedge_descriptor mesh_halfedge(const Index h) const
  {
    // halfedges have the order of the mesh around vertices
    const Index source = m_triangulation->source(h);
    halfedge_descriptor result = internal::first_halfedge_from(vertex(source), *m_mesh);
    for(Index i = m_triangulation->first_halfedge(source); i < h; ++i)
      result = internal::counterclockwise(result, *m_mesh);
    return result;
  }

  /// returns the location of a point in the face to the left of its halfedge. \pre `!p.is_vertex()`
  Face_location<TriangleMesh> face_location(const Intrinsic_point& p) const
  {
    return internal::location_in_face(mesh_halfedge(p.halfedge), p.t, p.s, *m_mesh);
  }

  /// returns the point of the surface at `p`.
  Surface_point<TriangleMesh> surface_point(const Intrinsic_point& p) const
  {
    if(p.is_vertex())
      return vertex(p.vertex);
    if(p.is_on_edge())
      return std::make_pair(mesh_halfedge(p.halfedge), p.t);
    return face_location(p);
  }

  /// reports the location of a point to `visitor`, a model of `SurfaceMeshShortestPathVisitor`.
  template <typename Visitor>
  void visit(const Intrinsic_point& p, Visitor& visitor) const
  {
    const auto report = [&](const auto& point) {
      if constexpr(internal::is_pair<std::decay_t<decltype(point)>>)
        visitor(point.first, point.second);
      else
        visitor(point);
    };
    std::visit(report, surface_point(p));
  }

  /// returns the position of a point in space, computed with `traits`, a model of `Kernel`.
  template <typename VertexPointMap, typename Traits>
  auto point(const Intrinsic_point& p, const VertexPointMap& point_map, const Traits& traits) const
  {
    using Result = typename boost::property_traits<VertexPointMap>::value_type;
    using FT = typename Traits::FT;
    if(p.is_vertex())
      return Result(get(point_map, vertex(p.vertex)));
    const auto barycenter = traits.construct_barycenter_3_object();
    const Intrinsic_triangulation& t = *m_triangulation;
    const auto& source = get(point_map, vertex(t.source(p.halfedge)));
    const auto& target = get(point_map, vertex(t.target(p.halfedge)));
    if(p.is_on_edge())
      return Result(barycenter(target, FT(p.t), source));
    const auto& third = get(point_map, vertex(t.target(t.next(p.halfedge))));
    return Result(barycenter(target, FT(p.t), third, FT(p.s), source));
  }

  /// returns a function from vertex indices to positions, for `Vertex_positions`. Their coordinates
  /// are those of the mesh, not rounded again: they have to fit edge lengths.
  template <typename VertexPointMap>
  auto position_of_vertex(const VertexPointMap& point_map) const
  {
    return [this, point_map](const Index v) {
      return internal::space_vector(get(point_map, vertex(v)) - CGAL::ORIGIN);
    };
  }

  /// @}

private:
  // Returns the index of a halfedge in the triangulation, by rotating around the vertex of its face
  // with the smallest degree.
  Index number(const halfedge_descriptor h) const
  {
    const Intrinsic_triangulation& t = *m_triangulation;
    if(is_border(h, *m_mesh))
      return number_around_source(h);
    const std::array<halfedge_descriptor, 3> sides{h, prev(h, *m_mesh), next(h, *m_mesh)};
    const auto degree = [&](const auto g) { return t.degree(node(source(g, *m_mesh))); };
    auto best = std::min_element(sides.begin(), sides.end(),
                                 [&](const auto a, const auto b) { return degree(a) < degree(b); });
    Index result = number_around_source(*best);
    for(; best != sides.begin(); --best)
      result = t.next(result);
    return result;
  }

  Index number_around_source(const halfedge_descriptor h) const
  {
    const vertex_descriptor v = source(h, *m_mesh);
    Index result = m_triangulation->first_halfedge(node(v));
    for(halfedge_descriptor g = internal::first_halfedge_from(v, *m_mesh); g != h;
        g = internal::counterclockwise(g, *m_mesh))
      ++result;
    return result;
  }

  const TriangleMesh* m_mesh;
  VertexIndexMap m_vertex_index_map;
  const Intrinsic_triangulation* m_triangulation;
  std::vector<vertex_descriptor> m_vertices; // by node; filled by list_vertices()
};

namespace internal {

// The following functions convert points. Messages about invalid ones name their role, such as
// "source", and their position in the range.

template <typename Translation, typename Point>
Intrinsic_point
intrinsic_point(const Translation& translation, const Point& point, const char* const role)
{
  return name_in_message([&] { return std::string(role); },
                         [&] { return translation.intrinsic_point(point); });
}

// Converts a single point or a range of points.
template <typename Translation, typename Points>
std::vector<Intrinsic_point>
intrinsic_points(const Translation& translation, const Points& points, const char* const role)
{
  std::vector<Intrinsic_point> result;
  if constexpr(is_surface_point<typename Translation::Triangle_mesh, Points>)
    result.push_back(intrinsic_point(translation, points, role));
  else
    for(const auto& point : points)
      result.push_back(name_in_message([&] { return name_in_list(role, result.size()); },
                                       [&] { return translation.intrinsic_point(point); }));
  return result;
}

// Returns the position of a point in the kernel of the mesh. Without a kernel, only vertices have
// positions.
template <typename Translation, typename VertexPointMap, typename NamedParameters>
auto point(const Translation& translation,
           const Intrinsic_point& p,
           const VertexPointMap& point_map,
           [[maybe_unused]] const NamedParameters& np)
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  if constexpr(is_given<NamedParameters, internal_np::geom_traits_t>)
    return Point(
        translation.point(p, point_map, parameters::get_parameter(np, internal_np::geom_traits)));
  else if constexpr(is_point_of_kernel<Point>)
    return Point(translation.point(p, point_map, typename Kernel_traits<Point>::Kernel()));
  else if(p.is_vertex())
    return Point(get(point_map, translation.vertex(p.vertex)));
  else
    reject("points on edges and faces cannot be computed: the point type of the mesh belongs to no "
           "kernel");
}

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_MESH_TRANSLATION_H
