// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_READ_FACE_WEIGHTS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_READ_FACE_WEIGHTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/halfedge_groups.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Surface/Face_weights.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

// Scales weights by a power of two, without rounding, so that products with lengths neither
// overflow nor underflow: the largest finite weight is then in [1, 2), or smaller if the unit of
// costs would underflow.
inline void normalize(Face_weights& weights, const double unit_of_lengths)
{
  double largest = 0;
  for(const double w : weights.of_halfedge)
    largest = std::isinf(w) ? largest : (std::max)(largest, w);
  if(largest == 0)
    return;
  constexpr int smallest_of_costs = -1000;
  const int exponent =
      (std::max)(std::ilogb(largest), smallest_of_costs - std::ilogb(unit_of_lengths));
  weights.unit = std::ldexp(1., exponent);
  for(double& w : weights.of_halfedge)
    if(w > 0)
      // stays positive, and not denormalized, which would be slow
      w = (std::max)(std::ldexp(w, -exponent), Face_weights::SMALLEST_WEIGHT);
}

// Returns an upper bound on the cost of a simple path, in the units of lengths and weights. Each
// edge counts once per face, which also covers path ends inside faces.
inline double cost_of_all_edges(const Face_weights& weights,
                                const Intrinsic_triangulation& triangulation)
{
  double result = 0;
  for(Intrinsic_triangulation::Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(!std::isinf(weights.of_halfedge[h]))
      result += weights.of_halfedge[h] * triangulation.length(h);
  return result;
}

// Reads the weights of the faces of a mesh. `halfedges` has the order of the triangulation.
template <typename TriangleMesh, typename Halfedges, typename FaceWeightMap>
Face_weights weights_of_faces(const TriangleMesh& tmesh,
                              const Halfedges& halfedges,
                              const FaceWeightMap& face_weight_map,
                              const Intrinsic_triangulation& triangulation)
{
  using Index = Intrinsic_triangulation::Index;
  const auto name = [&](const Index h) { return std::to_string(triangulation.index(h)); };

  Face_weights result;
  result.of_halfedge.resize(halfedges.size(), std::numeric_limits<double>::infinity());
  for(Index h = 0; h < halfedges.size(); ++h)
  {
    if(is_border(halfedges[h], tmesh))
      continue;
    const double weight = CGAL::to_double(get(face_weight_map, face(halfedges[h], tmesh)));
    if(!(weight >= 0))
    {
      const Index g = triangulation.next(h);
      reject("the face with vertices " + name(triangulation.source(h)) + ", " +
             name(triangulation.target(h)) + ", " + name(triangulation.target(g)) + " has weight " +
             text_of(weight) + "; it must be a number that is not negative, or infinity");
    }
    result.of_halfedge[h] = weight + 0.0; // normalizes negative zero
  }
  normalize(result, triangulation.unit());
  const double unit_of_costs = triangulation.unit() * result.unit;
  if(std::isinf(unit_of_costs) ||
     std::isinf(cost_of_all_edges(result, triangulation) * unit_of_costs))
    reject(
        "the weights and the lengths of the mesh are too large: the cost of a path would be more "
        "than a double can hold. Use infinity for faces that paths must not enter.");
  return result;
}

// Returns the halfedges of a mesh in the order of its triangulation.
template <typename TriangleMesh, typename VertexIndexMap>
auto halfedges_in_groups(const TriangleMesh& tmesh,
                         const VertexIndexMap& vertex_index_map,
                         const Intrinsic_triangulation& triangulation)
{
  using Index = Intrinsic_triangulation::Index;
  using Graph_traits = boost::graph_traits<TriangleMesh>;

  std::vector<typename Graph_traits::halfedge_descriptor> result(
      triangulation.number_of_halfedges(), Graph_traits::null_halfedge());
  std::size_t number_of_vertices = 0, number_of_halfedges = 0;
  for(const auto v : vertices(tmesh))
  {
    ++number_of_vertices;
    const Index node = triangulation.vertex(static_cast<std::size_t>(get(vertex_index_map, v)));
    const auto first = first_halfedge_from(v, tmesh);
    if(node == Intrinsic_triangulation::null_index || first == Graph_traits::null_halfedge())
      continue;
    Index i = triangulation.first_halfedge(node);
    auto h = first;
    do
    {
      if(i < triangulation.beyond_halfedge(node))
        result[i++] = h;
      ++number_of_halfedges;
      h = counterclockwise(h, tmesh);
    } while(h != first);
  }
  if(number_of_vertices != triangulation.number_of_vertices() ||
     number_of_halfedges != triangulation.number_of_halfedges() ||
     std::count(result.begin(), result.end(), Graph_traits::null_halfedge()) > 0)
    reject("the triangulation was not built from this mesh");
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsMesh
 *
 * reads the weights of the faces of a mesh, for replacing the weights of a graph.
 *
 * \param tmesh the mesh from which `triangulation` was built
 * \param triangulation the triangulation
 * \param face_weight_map a property map with the faces of `tmesh` as keys and a number type
 *        convertible by `CGAL::to_double()` as value type: the cost per unit of length
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters":
 *           `vertex_index_map`, if one was given to the triangulation
 *
 * \throws std::invalid_argument if a weight is negative or NaN, if costs overflow a `double`, or if
 *         the number of vertices or halfedges of `tmesh` differs from that of `triangulation`.
 *
 * Run time is \cgalBigO{n} for `n` vertices.
 */
template <typename TriangleMesh,
          typename FaceWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Face_weights read_face_weights(const TriangleMesh& tmesh,
                               const Intrinsic_triangulation& triangulation,
                               const FaceWeightMap& face_weight_map,
                               const NamedParameters& np = parameters::default_values())
{
  const auto halfedges =
      internal::halfedges_in_groups(tmesh, internal::vertex_index_map(tmesh, np), triangulation);
  return internal::weights_of_faces(tmesh, halfedges, face_weight_map, triangulation);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_READ_FACE_WEIGHTS_H
