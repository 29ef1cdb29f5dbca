// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Wrong_input.h"
#include "meshes/surface_points.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// What does not compile is in Queries/wrong_calls and Search/wrong_models.cpp.

namespace {

using namespace geodesics_test;
namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

TEST_F(Wrong_input, of_meshes)
{
  expect_refusals({
      {"a quadrangle",
       distances_after(
           [](Mesh& m) { CGAL::Euler::join_face(m.halfedge(Vertex(7), Vertex(14)), m); }),
       {"face", "not a triangle: it has 4 sides"}},
      {"NaN",
       distances_after([](Mesh& m) { m.point(Vertex(9)) = Point(0, m_nan, 0); }),
       {"vertex 9"}},
      {"infinity",
       distances_after([](Mesh& m) { m.point(Vertex(9)) = Point(m_infinity, 0, 0); }),
       {"vertex 9"}},
      {"a length that breaks the triangle inequality",
       distances_with_length(9),
       {"triangle inequality", "9"}},
      {"a negative length", distances_with_length(-1), {"length", "-1", "not negative"}},
      {"two vertices with one index",
       distances_from(Vertex(0), parameters::vertex_index_map(
                                     boost::make_static_property_map<Vertex>(std::size_t(3)))),
       {"index 3"}},
  });
}

TEST_F(Wrong_input, of_numbers)
{
  const std::vector<Vertex> two = {Vertex(0), Vertex(1)};
  expect_refusals({
      {"epsilon -1", distances_from(Vertex(0), parameters::epsilon(-1.)), {"epsilon is -1"}},
      {"epsilon inf",
       distances_from(Vertex(0), parameters::epsilon(m_infinity)),
       {"epsilon is inf"}},
      {"epsilon nan", distances_from(Vertex(0), parameters::epsilon(m_nan)), {"epsilon is nan"}},
      {"maximum_distance -2",
       distances_from(Vertex(0), parameters::maximum_distance(-2.)),
       {"maximum distance is -2"}},
      {"too few initial distances",
       distances_from(two, parameters::initial_distances(std::vector<double>{1})),
       {"1 initial distances, and 2 sources"}},
      {"a negative initial distance",
       distances_from(two, parameters::initial_distances(std::vector<double>{0, -3})),
       {"initial distance of source 1 is -3"}},
      {"coordinates with the sum 2",
       distances_from(Face_location(Face(3), {1, 0.5, 0.5})),
       {"source: barycentric coordinates", "their sum must be 1"}},
  });
}

TEST_F(Wrong_input, of_places)
{
  Mesh mesh = m_mesh;
  mesh.remove_vertex(mesh.add_vertex(Point(7, 7, 7)));
  const auto path = [&](const Vertex source, const Vertex target) {
    std::vector<Point> points;
    CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source, target);
  };
  const std::vector<Vertex> sources = {Vertex(0), Vertex(1000)};
  expect_refusals({
      {"a source of another mesh",
       distances_from(sources),
       {"source 1 (counted from 0): vertex 1000 is not in the mesh"}},
      {"a target of another mesh",
       [&] { path(Vertex(0), Vertex(1000)); },
       {"target: vertex 1000 is not in the mesh"}},
      {"a face of another mesh",
       distances_from(Face_location(Face(1000), {0.5, 0.5, 0})),
       {"source: face 1000 is not in the mesh"}},
      {"a vertex that was never set",
       [&] { path(Vertex(), Vertex(0)); },
       {"source: the null vertex is not in the mesh"}},
      {"a vertex that was removed",
       [&] { path(Vertex(36), Vertex(0)); },
       {"source: vertex 36 is not in the mesh"}},
  });
}

std::string graph_file(const Mesh& mesh)
{
  std::ostringstream out;
  AG::Discrete_geodesic_graph(Triangulation(mesh)).save(out);
  return out.str();
}

TEST_F(Wrong_input, of_graph_files)
{
  const std::string file = graph_file(m_mesh);
  const auto load = [this](const std::string& text) {
    return [this, text] {
      std::istringstream in(text);
      AG::Discrete_geodesic_graph::load(in, Triangulation(m_mesh));
    };
  };
  expect_refusals({
      {"a graph of another mesh", load(graph_file(to_mesh(flat_grid(5, 5)))), {"25 vertices"}},
      {"half a graph", load(file.substr(0, file.size() / 2)), {"the graph is truncated"}},
      {"no graph",
       load("This is a text of more than sixteen characters."),
       {"not that of a discrete geodesic graph"}},
      {"no file",
       [&] {
         std::ifstream in("no folder/no file");
         AG::Discrete_geodesic_graph::load(in, Triangulation(m_mesh));
       },
       {"the stream of the graph cannot be read"}},
      {"a device that is full",
       [&] {
         std::ofstream out("/dev/full");
         AG::Discrete_geodesic_graph(Triangulation(m_mesh)).save(out);
       },
       {"the graph could not be written"}},
  });
}

// What looks wrong, and has an answer that is documented.
TEST_F(Wrong_input, that_is_none)
{
  const std::vector<double> along_edges = distances(m_mesh, Vertex(0));
  const std::vector<double> exact = distances(m_mesh, Vertex(0), parameters::epsilon(0));
  const std::vector<double> loose = distances(m_mesh, Vertex(0), parameters::epsilon(1e300));
  EXPECT_DOUBLE_EQ(exact[2 * 6 + 1], std::sqrt(5.));
  EXPECT_GT(along_edges[2 * 6 + 1], exact[2 * 6 + 1] * (1 + 1e-6));
  for(std::size_t i = 0; i < exact.size(); ++i)
  {
    EXPECT_GE(loose[i], exact[i] * (1 - 1e-12));
    EXPECT_LE(loose[i], along_edges[i] * (1 + 1e-6));
  }

  const Mesh empty;
  EXPECT_TRUE(distances(empty, std::vector<Vertex>()).empty());
  AG::Surface_mesh_shortest_path<Mesh> paths(empty);
  paths.build_sequence_tree();
  EXPECT_EQ(paths.number_of_source_points(), 0u);
  EXPECT_THROW(paths.add_source_point(Vertex(0)), std::invalid_argument);
}

} // namespace
