// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_SOUP_MESHES_H
#define APPROXIMATE_GEODESICS_TEST_SOUP_MESHES_H

#include "meshes/test_meshes.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangle_soup_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// Meshes on arrays, without links.

namespace geodesics_test {

using Soup_mesh =
    CGAL::Approximate_geodesics::Triangle_soup_mesh<std::vector<Point>,
                                                    std::vector<std::array<std::size_t, 3>>>;

inline Soup_mesh on_arrays(const Soup& soup) { return {soup.points, soup.triangles}; }

inline Soup soup_of(const Mesh& mesh)
{
  Soup result;
  result.points.assign(mesh.points().begin(), mesh.points().end());
  for(const Face f : mesh.faces())
  {
    const Halfedge h = mesh.halfedge(f);
    result.triangles.push_back(
        {mesh.source(h), mesh.target(h), std::size_t(mesh.target(mesh.next(h)))});
  }
  return result;
}

// The distances from a vertex, by the number of the vertex.
template <typename AnyMesh, typename... NamedParameters>
std::vector<double>
distances_from_vertex(const AnyMesh& mesh, const std::size_t source, const NamedParameters&... np)
{
  std::vector<double> result(num_vertices(mesh));
  const auto map =
      boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh));
  using vertex_descriptor = typename boost::graph_traits<AnyMesh>::vertex_descriptor;
  CGAL::approximate_geodesic_distances(
      mesh, map, vertex_descriptor(static_cast<std::uint32_t>(source)), np...);
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_SOUP_MESHES_H
