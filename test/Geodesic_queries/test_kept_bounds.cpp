// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "checks/expect_message.h"
#include "meshes/sample_meshes.h"
#include "meshes/surface_points.h"
#include "meshes/test_meshes.h"
#include "meshes/test_weights.h"
#include "oracles/cost_across.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Geodesic_queries/distance_intervals.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The bound of geometric points, where it is hard to keep: thin faces, weights of all magnitudes,
// and points that are no vertices.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Geometric_graph = Steiner_graph<Geometric_points>;

// ----- thin faces in the plane

std::vector<double> distances_in_plane(const Mesh& mesh, const Vertex source)
{
  std::vector<double> result;
  for(const Vertex v : mesh.vertices())
    result.push_back(std::sqrt(CGAL::squared_distance(mesh.point(source), mesh.point(v))));
  return result;
}

TEST(Thin_faces, have_the_bound_if_weights_are_equal)
{
  for(const double angle : {1e-1, 1e-2, 1e-3})
    for(const Soup& soup : thin_soups(angle))
    {
      SCOPED_TRACE(angle);
      const Mesh mesh = to_mesh(soup);
      for(const double e : {0.5, 0.1})
      {
        Basic_mesh_search<Geometric_graph> search(mesh, parameters::epsilon(e));
        EXPECT_EQ(search.graph().epsilon(), e);
        for(const Vertex source : {Vertex(2), Vertex(3)})
          expect_within_bound(search.distances({source}), distances_in_plane(mesh, source), e);
      }
    }
}

// Thin faces that are cheap or expensive, next to graphs with so many points that few are missed.
TEST(Thin_faces, have_the_bound_if_they_are_cheap_or_expensive)
{
  Random random(test_seed());
  for(const double angle : {5e-2, 2e-3})
    for(const double cost : {1e-2, 30.})
      for(const Soup& soup : thin_soups(angle))
      {
        SCOPED_TRACE(angle);
        const Mesh mesh = to_mesh(soup);
        Weights weights = random_weights(mesh, random, 1, 1.5);
        for(const Face f : mesh.faces())
          if(std::abs(mesh.point(mesh.target(mesh.halfedge(f))).y()) < 0.5 &&
             CGAL::Polygon_mesh_processing::face_area(f, mesh) < 0.2)
            weights[f.idx()] *= cost;
        const std::vector<double> dense =
            costs(mesh, weights, Fixed_number_of_points(100), {Vertex(2)});
        const double e = angle < 0.01 ? 0.5 : 0.1; // which tells as much, with fewer points
        const std::vector<double> found = costs(mesh, weights, Geometric_points(e), {Vertex(2)});
        for(std::size_t i = 0; i < found.size(); ++i)
          EXPECT_LE(found[i], dense[i] * (1 + e) * (1 + rounding_of_costs));
      }
}

// Paths that run through nothing but thin faces, of different weights.
TEST(Thin_faces, have_the_bound_in_layers)
{
  Random random(test_seed());
  constexpr std::size_t columns = 3, rows = 13;
  for(const double thickness : {0.1, 0.01})
    for(const double range : {1., 30.})
    {
      SCOPED_TRACE(thickness);
      const Mesh mesh = to_mesh(flat_grid(columns, rows).transformed([&](const Point& p) {
        return Point(p.x() * 0.2, p.y() * thickness, 0);
      }));
      std::vector<Layer> layers;
      for(std::size_t i = 0; i + 1 < rows; ++i)
        layers.push_back({thickness, std::pow(range, random.between(0, 1))});
      const Weights weights = weights_by_place(mesh, [&](const Point& p) {
        return layers[static_cast<std::size_t>(p.y() / thickness)].weight;
      });
      for(const double e : {0.5, 0.1})
      {
        const auto graph = steiner_graph(mesh, weights, Geometric_points(e));
        EXPECT_EQ(graph.epsilon(), e);
        const std::vector<double> found = costs(mesh, weights, Geometric_points(e), {Vertex(1)});
        for(std::size_t i = 0; i < columns; ++i)
        {
          const double exact = cost_across(layers, 0.2 * std::abs(double(i) - 1));
          const double cost = found[i + (rows - 1) * columns];
          EXPECT_GE(cost, exact * (1 - 1e-9));
          EXPECT_LE(cost, exact * (1 + e));
        }
      }
    }
}

// ----- faces that take too many points

TEST(Thin_faces, are_refused_by_name_if_they_take_too_many_points)
{
  const Mesh mesh = to_mesh(thin_needles(1, 1e-3));
  const Triangulation t(mesh);
  const auto np = parameters::epsilon(0.1);
  const auto count = [&](const Geometric_points& points) {
    return Geometric_graph(t, points).number_of_points();
  };
  expect_message<std::length_error>(
      [&] { count(Geometric_points(np.maximum_number_of_points_per_edge(500))); }, "epsilon",
      "the face with vertices 0, 4, 5", " points on an edge", "500");
  EXPECT_GT(count(Geometric_points(np.maximum_number_of_points_per_edge(100000))), 2000u);
  const Geometric_graph weak(t,
                             np.accept_weaker_bound(true).maximum_number_of_points_per_edge(500));
  EXPECT_LT(weak.number_of_points(), 2000u);
  EXPECT_GT(weak.epsilon(), 0.1);
  EXPECT_LT(weak.epsilon(), infinity);
}

TEST(Weights, that_vanish_beside_others_have_no_bound)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  std::vector<double> weights(mesh.number_of_faces(), 1e300);
  weights[0] = 1e-10;
  const Triangulation t(mesh, parameters::face_weight_map(weight_map(weights)));
  expect_message<std::invalid_argument>([&] { Geometric_graph(t, Geometric_points(0.1)); },
                                        "cannot be kept", "has a weight that is less than 1e-307");
  EXPECT_EQ(infinity, Geometric_graph(t, lenient_points(0.1)).epsilon());
}

TEST(Thin_faces, have_the_weaker_bound_that_is_told)
{
  bool is_weaker = false;
  for(const double angle : {1e-2, 1e-4, 1e-6})
    for(const Soup& soup : thin_soups(angle))
    {
      SCOPED_TRACE(angle);
      const Mesh mesh = to_mesh(soup);
      for(const std::size_t limit : {1u, 10u, 100u})
      {
        Basic_mesh_search<Geometric_graph> search(
            mesh,
            parameters::epsilon(0.1).accept_weaker_bound(true).maximum_number_of_points_per_edge(
                limit));
        const double bound = search.graph().epsilon();
        EXPECT_LT(bound, infinity);
        is_weaker = is_weaker || bound > 0.1;
        for(const Vertex source : {Vertex(2), Vertex(3)})
          expect_within_bound(search.distances({source}), distances_in_plane(mesh, source), bound);
      }
    }
  EXPECT_TRUE(is_weaker);
}

TEST(Faces_without_area, have_no_bound)
{
  const Mesh mesh = to_mesh(thin_cap(0));
  const Triangulation t(mesh);
  expect_message<std::length_error>([&] { Geometric_graph g(t, parameters::epsilon(0.1)); },
                                    "the face with vertices");
  EXPECT_EQ(Geometric_graph(t, lenient_points(0.1)).epsilon(), infinity);
}

// ... and do not matter where no path may enter them, until one may.
TEST(Faces_without_area, do_no_harm_if_they_are_forbidden)
{
  const Mesh mesh = to_mesh(thin_cap(0));
  Weights weights(mesh.num_faces(), 1);
  weights[0] = infinity;
  auto graph = steiner_graph(mesh, weights, Geometric_points(0.1));
  EXPECT_EQ(graph.epsilon(), 0.1);
  weights[0] = 1;
  graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(), weight_map(weights)));
  EXPECT_EQ(graph.epsilon(), infinity);
}

TEST(Sample_meshes, keep_the_bound_or_are_refused_by_name)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  std::size_t number_of_meshes = 0, number_of_refused = 0;
  for(const std::string& name : names_of_sample_files())
  {
    const Mesh mesh = sample_mesh(name);
    if(mesh.is_empty() || !CGAL::is_triangle_mesh(mesh))
      continue;
    SCOPED_TRACE(name);
    ++number_of_meshes;
    const Triangulation t(mesh);
    Geometric_points points(0.1), lenient = lenient_points(0.1);
    EXPECT_NO_THROW(lenient.prepare(t));
    try
    {
      points.prepare(t);
      EXPECT_EQ(points.epsilon(t), 0.1);
    }
    catch(const std::length_error& e)
    {
      ++number_of_refused;
      EXPECT_NE(std::string(e.what()).find("the face with vertices"), std::string::npos);
      EXPECT_GT(lenient.epsilon(t), 0.1);
    }
  }
  EXPECT_LE(20 * number_of_refused, number_of_meshes);
}

TEST(Limit_of_points, is_refused_if_it_is_none)
{
  for(const double limit : {0., -1., 2.5, 1e10, not_a_number, infinity})
    expect_message<std::invalid_argument>(
        [&] { Geometric_points p(parameters::maximum_number_of_points_per_edge(limit)); },
        "maximum_number_of_points_per_edge");
}

// ----- weights

// No number of points depends on how different they are.
TEST(Weights_of_all_magnitudes, have_the_bound)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(7, 6, random));
  const double values[] = {0, 1e-200, 1e-30, 1, 10, 1e30, 1e100, infinity};
  for(std::size_t i = 0; i < 3; ++i)
  {
    Weights weights(mesh.num_faces());
    for(double& w : weights)
      w = values[random.below(8)];
    const Vertex source = random_vertex(mesh, random);
    const auto graph = steiner_graph(mesh, weights, Geometric_points(0.1));
    EXPECT_EQ(graph.epsilon(), 0.1);
    EXPECT_LT(graph.number_of_points(), 100 * mesh.num_edges());
    const std::vector<double> dense = costs(mesh, weights, Fixed_number_of_points(40), {source});
    const std::vector<double> found = costs(mesh, weights, Geometric_points(0.1), {source});
    for(std::size_t k = 0; k < found.size(); ++k)
      EXPECT_LE(found[k], dense[k] * (1.1 + rounding_of_costs));
  }
}

TEST(Exchanged_weights, have_the_bound_if_that_was_expected)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(7, 6, random));
  const Weights ones(mesh.num_faces(), 1), others = random_weights(mesh, random, 1e-5, 1e5);
  for(const bool is_expected : {false, true})
  {
    auto graph = steiner_graph(mesh, ones, Geometric_points(0.1, is_expected));
    EXPECT_EQ(graph.epsilon(), 0.1);
    graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(), weight_map(others)));
    EXPECT_EQ(graph.epsilon() == 0.1, is_expected);
    EXPECT_LT(graph.epsilon(), 2);
  }
}

// ----- points that are no vertices

// On both sides of edges, close to them and to each other, on a square.
TEST(Points_in_faces, are_not_farther_apart_than_the_distance_of_corners_allows)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const Geometric_graph graph(Triangulation(mesh), Geometric_points(0.1));
  const Triangulation& t = graph.triangulation();
  const auto random_point = [&] {
    for(;;)
    {
      const Node h = static_cast<Node>(random.below(t.number_of_halfedges()));
      const double s = std::pow(10, random.between(-6, -0.5));
      if(!t.is_border(h))
        return AG::Intrinsic_point::in_face(h, random.between(0, 1 - s), s);
    }
  };
  const auto place = [&](const AG::Intrinsic_point& p) {
    const Point a = mesh.point(Vertex(t.index(t.target(t.opposite(p.halfedge))))),
                b = mesh.point(Vertex(t.index(t.target(p.halfedge)))),
                c = mesh.point(Vertex(t.index(t.target(t.next(p.halfedge)))));
    return CGAL::barycenter(a, 1 - p.t - p.s, b, p.t, c, p.s);
  };
  AG::Surface_search<Geometric_graph> search(graph);
  double largest_factor = 0;
  for(std::size_t i = 0; i < 500; ++i)
  {
    const AG::Intrinsic_point p = random_point();
    AG::Intrinsic_point q = random_point();
    const Node opposite = t.opposite(p.halfedge);
    if(i % 2 == 0 && !t.is_border(opposite))
      q = AG::Intrinsic_point::in_face(opposite, (1 - p.t - p.s) * 0.999, p.s);
    search.run({{p}});
    const double found = search.distance(q);
    const double exact = std::sqrt(CGAL::squared_distance(place(p), place(q)));
    const double corners = graph.unit() * (graph.cost_to_corner(p) + graph.cost_to_corner(q));
    EXPECT_GE(found, exact * (1 - 1e-9));
    EXPECT_LE(found, (1.1 * exact + 2.1 * corners) * (1 + 1e-9));
    largest_factor = (std::max)(largest_factor, found / exact);
  }
  EXPECT_GT(largest_factor, 1.2); // so that the corners do matter
}

TEST(Points_in_faces, have_intervals_that_contain_the_distance)
{
  const Mesh mesh = to_mesh(thin_needles(1, 0.05));
  const Weights weights(mesh.num_faces(), 1);
  for(const Face f : mesh.faces())
    for(const double part : {1e-3, 0.3})
    {
      const Face_location source{f, {{0.5, 0.5 - part, part}}};
      const Halfedge h = mesh.halfedge(f);
      const Point p = CGAL::barycenter(mesh.point(mesh.source(h)), 0.5, mesh.point(mesh.target(h)),
                                       0.5 - part, mesh.point(mesh.target(mesh.next(h))), part);
      std::vector<std::pair<double, double>> found(mesh.num_vertices());
      AG::distance_intervals(
          mesh, boost::make_iterator_property_map(found.begin(), get(CGAL::vertex_index, mesh)),
          source, with_weights(weights).epsilon(0.5));
      for(const Vertex v : mesh.vertices())
      {
        const double exact = std::sqrt(CGAL::squared_distance(p, mesh.point(v)));
        EXPECT_LE(found[v.idx()].first, exact);
        EXPECT_GE(found[v.idx()].second, exact);
      }
    }
}

} // namespace
