// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"
#include "checks/expect_message.h"
#include "meshes/test_weights.h"

#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// What a distance matrix refuses. Sinks are as they were.

namespace {

namespace parameters = CGAL::parameters;
using namespace geodesics_test;

class Bad_matrix : public testing::Test
{
protected:
  Bad_matrix()
  {
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, m_dense, Vertex(3)));
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, m_within_radius, Vertex(3)));
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, m_nearest, Vertex(3)));
  }

  // by all sinks, which keep what they had, and by a function object, which is not called
  template <typename Domain, typename Sources, typename NamedParameters>
  void expect_rejection(const std::vector<std::string>& texts,
                        const Domain& domain,
                        const Sources& sources,
                        const NamedParameters& np)
  {
    const auto no_row = [](std::size_t, const Distance_row&) { ADD_FAILURE() << "called"; };
    expect_rejection_by(m_dense, texts, domain, sources, np);
    expect_rejection_by(m_within_radius, texts, domain, sources, np);
    expect_rejection_by(m_nearest, texts, domain, sources, np);
    expect_rejection_by(no_row, texts, domain, sources, np);
    EXPECT_EQ(matrix_of(m_dense), m_expected);
    EXPECT_EQ(entries_of(m_within_radius), within(infinity, m_expected));
    EXPECT_EQ(entries_of(m_nearest), nearest_of(2, within(infinity, m_expected)));
  }

  template <typename Rows, typename Domain, typename Sources, typename NamedParameters>
  static void expect_rejection_by(Rows& rows,
                                  const std::vector<std::string>& texts,
                                  const Domain& domain,
                                  const Sources& sources,
                                  const NamedParameters& np)
  {
    for(const std::string& text : texts)
      expect_message<std::invalid_argument>(
          [&] { CGAL::approximate_geodesic_distance_matrix(domain, rows, sources, np); }, text);
  }

  static Mesh make_mesh()
  {
    Mesh result = to_mesh(flat_grid(6, 6));
    result.remove_vertex(result.add_vertex(Point(7, 7, 7)));
    return result;
  }

  const Mesh m_mesh = make_mesh();
  const Graph m_graph{Triangulation(m_mesh)};
  const Matrix m_expected = dense_matrix(m_mesh, Vertex(3));
  Dense_rows<> m_dense;
  Radius_rows<> m_within_radius;
  Nearest_rows<> m_nearest{2};
};

TEST_F(Bad_matrix, points_that_the_mesh_has_not)
{
  const auto none = parameters::default_values();
  for(const Vertex bad : {Mesh::null_vertex(), Vertex(1000), Vertex(36)}) // which was removed
  {
    const std::string text = (bad == Mesh::null_vertex() ? std::string("the null vertex")
                                                         : "vertex " + std::to_string(bad.idx())) +
                             " is not in the mesh";
    const std::vector<Vertex> list{Vertex(0), bad};
    expect_rejection({text}, m_mesh, bad, none);
    expect_rejection({text}, m_mesh, list, none);
    expect_rejection({text}, m_mesh, Vertex(0), parameters::targets(list));
  }
  const auto expect_location = [&](const Face_location& bad, const std::string& text) {
    expect_rejection({text}, m_mesh, bad, none);
    expect_rejection({text}, m_mesh, Vertex(0),
                     parameters::targets(std::vector<Face_location>{bad}));
  };
  expect_location({Face(3), {2, -1, 0}}, "must not be negative");
  expect_location({Face(1000), {1, 0, 0}}, "face 1000");
}

TEST_F(Bad_matrix, points_that_the_graph_has_not)
{
  const auto none = parameters::default_values();
  const std::vector<int> good{0, 35}, negative{0, -1}, too_large{0, 36};
  const std::vector<std::size_t> largest{(std::numeric_limits<std::size_t>::max)()};
  expect_rejection({"source -1 is negative"}, m_graph, negative, none);
  expect_rejection({"target -1 is negative"}, m_graph, good, parameters::targets(negative));
  expect_rejection({"source 36 is not the index of a vertex"}, m_graph, too_large, none);
  expect_rejection({"target 36 is not the index of a vertex"}, m_graph, good,
                   parameters::targets(too_large));
  expect_rejection({"is not the index of a vertex"}, m_graph, largest, none);
  const auto in_face = [](const double t, const double s) {
    return Intrinsic_point::in_face(0, t, s);
  };
  for(const Intrinsic_point& bad :
      {Intrinsic_point::at_vertex(36), Intrinsic_point::on_edge(1000, 0.5),
       Intrinsic_point::on_edge(0, 1.5), Intrinsic_point::on_edge(0, not_a_number),
       in_face(0.6, 0.6), in_face(0.5, not_a_number), in_face(0.5, -0.1)})
  {
    const std::vector<Intrinsic_point> points{Intrinsic_point::at_vertex(0), bad};
    expect_rejection({"source 1 is not a point"}, m_graph, points, none);
    expect_rejection({"target 1 is not a point"}, m_graph, good, parameters::targets(points));
  }
}

TEST_F(Bad_matrix, maximum_distance_that_is_no_distance)
{
  for(const double bad : {-1., -1e-300, not_a_number, -infinity})
  {
    const auto np = parameters::maximum_distance(bad);
    expect_rejection({"maximum_distance is", "must not be negative"}, m_mesh, Vertex(0), np);
    expect_rejection({"maximum_distance is", "must not be negative"}, m_graph, std::vector<int>{0},
                     np);
    // also where no search would be run
    expect_rejection({"maximum_distance is"}, m_mesh, std::vector<Vertex>(), np);
  }
}

TEST_F(Bad_matrix, number_of_nearest_that_is_zero)
{
  expect_message<std::invalid_argument>([] { Nearest_rows<>(0); }, "number of nearest columns is 0",
                                        "at least 1");
}

TEST_F(Bad_matrix, epsilon_that_is_no_bound)
{
  for(const double bad : {-1., -1e-300, not_a_number})
    expect_rejection({"epsilon"}, m_mesh, Vertex(0), parameters::epsilon(bad));
}

TEST_F(Bad_matrix, weights_and_barriers_with_exact_distances)
{
  const Weights weights(m_mesh.num_faces(), 2);
  const Barriers barriers(m_mesh.num_edges(), false);
  const std::string text = "supports neither weights nor barriers";
  expect_rejection({text}, m_mesh, Vertex(0), with_weights(weights).epsilon(0));
  expect_rejection({text}, m_mesh, Vertex(0),
                   parameters::epsilon(0).edge_is_constrained_map(barrier_map(barriers)));
}

TEST_F(Bad_matrix, directions_that_have_other_ends)
{
  const std::string text = "symmetric: targets are not the same points as sources";
  const std::vector<Vertex> some{Vertex(1), Vertex(2)}, reversed{Vertex(2), Vertex(1)},
      more{Vertex(1), Vertex(2), Vertex(3)};
  const auto expect = [&](const auto& domain, const auto& sources, const auto& np) {
    expect_rejection_by(m_dense, {text, "in the same order"}, domain, sources, np);
    expect_rejection_by(m_within_radius, {text}, domain, sources, np);
    EXPECT_EQ(matrix_of(m_dense), m_expected);
  };
  expect(m_mesh, some, parameters::symmetric(true)); // targets are all vertices
  for(const auto& targets : {reversed, more, std::vector<Vertex>{Vertex(1)}})
    expect(m_mesh, some, parameters::symmetric(true).targets(targets));
  const std::vector<Face_location> points{{Face(3), {0.2, 0.3, 0.5}}},
      other_points{{Face(3), {0.2, 0.4, 0.4}}};
  expect(m_mesh, points, parameters::symmetric(true).targets(other_points));
  expect(m_graph, std::vector<int>{1, 2},
         parameters::symmetric(true).targets(std::vector<int>{2, 1}));
}

} // namespace
