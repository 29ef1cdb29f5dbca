// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/test_mesh_type.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>

#ifdef APPROXIMATE_GEODESICS_TEST_OPENMESH
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace {

using namespace geodesics_test;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Polyhedron_with_id = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
using Cell_complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2,
    3,
    CGAL::Linear_cell_complex_traits<3, Kernel>>::type;

TEST(Mesh_type, polyhedron_without_ids) { expect_same_results_on_copies<Polyhedron>(); }

TEST(Mesh_type, polyhedron_with_ids)
{
  for(const Mesh& original : simple_meshes())
  {
    Copied_mesh<Polyhedron_with_id> copy(original);
    CGAL::set_halfedgeds_items_id(copy.mesh);
    expect_same_results(original, copy.mesh, copy.vertices);
  }
}

TEST(Mesh_type, linear_cell_complex) { expect_same_results_on_copies<Cell_complex>(); }

#ifdef APPROXIMATE_GEODESICS_TEST_OPENMESH
// whose points are `float`
TEST(Mesh_type, open_mesh_of_triangles)
{
  expect_same_results_on_copies<OpenMesh::TriMesh_ArrayKernelT<>>();
}

TEST(Mesh_type, open_mesh_of_polygons)
{
  expect_same_results_on_copies<OpenMesh::PolyMesh_ArrayKernelT<>>();
}
#endif

// Some faces of a mesh, against a mesh that has only those.
TEST(Mesh_type, face_filtered_graph)
{
  for(const Mesh& mesh : simple_meshes())
  {
    std::map<Face, std::size_t> part;
    for(const Face f : mesh.faces())
      part[f] = mesh.point(mesh.source(mesh.halfedge(f))).x() < 0.5 ? 1 : 0;
    using Filtered_mesh = CGAL::Face_filtered_graph<Mesh>;
    const Filtered_mesh filtered(mesh, std::size_t(1), boost::make_assoc_property_map(part));
    ASSERT_GT(num_faces(filtered), 0u);
    ASSERT_TRUE(filtered.is_selection_valid());

    Mesh same_faces;
    std::vector<std::pair<Vertex, Vertex>> pairs;
    CGAL::copy_face_graph(
        filtered, same_faces,
        CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(pairs)));
    std::vector<Vertex> vertices(same_faces.num_vertices());
    for(const auto& [v, copy] : pairs)
      vertices[copy.idx()] = v;
    expect_same_results(same_faces, filtered, vertices);
  }
}

// This mesh counts its elements whenever it is asked for their number: done at every halfedge, that
// would take minutes here.
TEST(Face_filtered_graph, is_read_in_linear_time)
{
  Mesh mesh;
  CGAL::make_grid(800, 800, mesh, true);
  const auto part = mesh.add_property_map<Face, int>("part", 1).first;
  const CGAL::Face_filtered_graph<Mesh> filtered(mesh, 1, part);
  const Triangulation triangulation(filtered);
  EXPECT_EQ(triangulation.number_of_faces(), mesh.num_faces());
}

} // namespace
