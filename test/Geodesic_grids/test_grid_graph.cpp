// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "grids/cells.h"
#include "meshes/test_soup.h"

#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

// Grids of cells against closed forms, and against the graph of their triangulation.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Propagation;
using CGAL::parameters::epsilon;

// ----- cells of equal friction

// Returns the largest error.
double error_on_equal_cells(const Grid_graph& graph, const Grid_cell& source, const double friction)
{
  const Grid_shape& shape = graph.shape();
  const std::vector<double> distances = distances_of_cells(graph, source);
  double result = 0;
  for(std::size_t i = 0; i < distances.size(); ++i)
  {
    const double expected =
        friction * straight_distance(shape.center(source), shape.center(shape.cell(i)));
    EXPECT_GE(distances[i], expected * (1 - slack_of_costs));
    if(expected > 0)
      result = (std::max)(result, distances[i] / expected - 1);
  }
  return result;
}

TEST(Grid_graph, keeps_0_3_percent_in_all_directions)
{
  for(const double height : {1., 0.5, 0.7, 1.9})
  {
    const Grid_shape shape{90, 80, 3, 3 * height, {}};
    const Grid_graph graph(shape, equal_cells(shape, 2));
    EXPECT_LE(graph.error_on_equal_cells(), 0.003);
    for(const Grid_cell source : {Grid_cell{0, 0}, Grid_cell{40, 33}, Grid_cell{89, 12}})
    {
      const double error = error_on_equal_cells(graph, source, 2);
      EXPECT_LE(error, graph.error_on_equal_cells() + slack_of_costs);
      EXPECT_GE(error, 0.8 * graph.error_on_equal_cells());
    }
  }
}

TEST(Grid_graph, says_how_large_errors_are_where_cells_are_long)
{
  const Grid_shape shape{200, 30, 1, 40, {}};
  const Grid_graph graph(shape, equal_cells(shape));
  EXPECT_GT(graph.error_on_equal_cells(), 0.01);
  EXPECT_LE(error_on_equal_cells(graph, {100, 15}, 1),
            graph.error_on_equal_cells() + slack_of_costs);
}

TEST(Grid_graph, keeps_0_3_percent_with_points)
{
  const Grid_shape shape{40, 30, 1, 1, {}};
  const Grid_graph graph(shape, equal_cells(shape), epsilon(0.5));
  EXPECT_LE(error_on_equal_cells(graph, {3, 4}, 1), 0.003);
}

// ----- refraction

// The smallest cost from a point at the height `a` above a line, below which the friction is `w`,
// to a point at the depth `b` below it, and `x` farther along it. The friction above is 1.
double refracted_cost(const double a, const double b, const double x, const double w)
{
  double low = 0, high = x; // the cost is convex
  const auto cost = [&](const double at) { return std::hypot(at, a) + w * std::hypot(x - at, b); };
  for(int i = 0; i < 200; ++i)
  {
    const double first = low + (high - low) / 3, second = high - (high - low) / 3;
    (cost(first) < cost(second) ? high : low) = cost(first) < cost(second) ? second : first;
  }
  return cost(low);
}

TEST(Grid_graph, refracts_paths_between_half_planes)
{
  const Grid_shape shape{40, 24, 1, 1.25, {}};
  for(const double w : {0.3, 0.8, 4.})
  {
    Cell_values friction = equal_cells(shape);
    for(std::size_t i = 0; i < friction.size(); ++i)
      friction[i] = shape.cell(i).row < 12 ? w : 1;
    for(const double e : {0.3, 0.1, 0.02})
    {
      const Grid_graph graph(shape, friction, epsilon(e));
      const Grid_cell source{5, 20};
      const std::vector<double> distances = distances_of_cells(graph, source);
      const double line = 12 * shape.cell_height;
      for(std::size_t i = 0; i < 12 * shape.columns; ++i)
      {
        const Grid_point p = shape.center(source), q = shape.center(shape.cell(i));
        // paths along the line are straight for the side of lower friction, too
        const double expected = refracted_cost(p.y - line, line - q.y, std::abs(p.x - q.x), w);
        EXPECT_GE(distances[i], expected * (1 - slack_of_costs));
        EXPECT_LE(distances[i], expected * (1 + e));
      }
    }
  }
}

// ----- random rasters

// Every cell as four faces around its center.
Mesh triangulated(const Grid_shape& shape)
{
  Mesh mesh;
  std::vector<Vertex> centers, corners;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
  {
    const Grid_point p = shape.center(shape.cell(i));
    centers.push_back(mesh.add_vertex(Point(p.x, p.y, 0)));
  }
  for(std::size_t row = 0; row <= shape.rows; ++row)
    for(std::size_t column = 0; column <= shape.columns; ++column)
      corners.push_back(mesh.add_vertex(Point(static_cast<double>(column) * shape.cell_width,
                                              static_cast<double>(row) * shape.cell_height, 0)));
  const std::size_t stride = shape.columns + 1;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
  {
    const std::size_t first = shape.cell(i).row * stride + shape.cell(i).column;
    const Vertex around[] = {corners[first], corners[first + 1], corners[first + stride + 1],
                             corners[first + stride]};
    for(std::size_t k = 0; k < 4; ++k)
      mesh.add_face(centers[i], around[k], around[(k + 1) % 4]);
  }
  return mesh;
}

// The costs on the mesh, at most `1 + e` times too large.
std::vector<double> costs_on_mesh(const Grid_shape& shape,
                                  const Cell_values& friction,
                                  const Mesh& mesh,
                                  const double e)
{
  Mesh with_weights = mesh;
  auto weight = with_weights.add_property_map<Face, double>("f:weight").first;
  auto distance = with_weights.add_property_map<Vertex, double>("v:distance").first;
  for(const Face f : with_weights.faces())
    weight[f] = friction[std::size_t(f) / 4];
  CGAL::approximate_geodesic_distances(with_weights, distance, Vertex(0),
                                       CGAL::parameters::face_weight_map(weight).epsilon(e));
  std::vector<double> result;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
    result.push_back(distance[Vertex(static_cast<Vertex::size_type>(i))]);
  return result;
}

TEST(Grid_graph, keeps_its_bound_on_random_rasters)
{
  Random random(test_seed());
  constexpr double e_of_mesh = 0.02;
  for(std::size_t i = 0; i < 100; ++i)
  {
    const Grid_shape shape{
        1 + random.below(7), 1 + random.below(6), 1, random.between(0.4, 2.5), {}};
    const Cell_values friction = random_friction(random, shape);
    const std::vector<double> expected =
        costs_on_mesh(shape, friction, triangulated(shape), e_of_mesh);
    const double e = random.between(0.05, 1);
    const std::vector<double> found =
        distances_of_cells(Grid_graph(shape, friction, epsilon(e)), {});
    const std::vector<double> along_lines = distances_of_cells(Grid_graph(shape, friction), {});
    for(std::size_t k = 0; k < found.size(); ++k)
    {
      if(std::isinf(friction[k]))
      {
        EXPECT_EQ(found[k], no_way);
        continue;
      }
      EXPECT_LE(found[k], expected[k] * (1 + e) + slack_of_costs);
      EXPECT_GE(found[k], expected[k] / (1 + e_of_mesh) - slack_of_costs);
      EXPECT_GE(along_lines[k], expected[k] / (1 + e_of_mesh) - slack_of_costs);
    }
  }
}

TEST(Grid_graph, gives_the_same_with_all_queues)
{
  Random random(test_seed());
  const Grid_shape shape{20, 17, 1, 1.5, {}};
  for(std::size_t i = 0; i < 10; ++i)
  {
    const Cell_values friction = i == 0 ? equal_cells(shape) : random_friction(random, shape);
    const Grid_graph graph(shape, friction, epsilon(0.1));
    Propagation search(graph);
    Propagation<Grid_graph, AG::Binary_heap_queue> other(graph);
    search.run_from(0);
    other.run_from(0);
    for(Grid_graph::Node node = 0; node < graph.number_of_nodes(); ++node)
      EXPECT_EQ(search.distance(node), other.distance(node));
  }
}

// Labels as before a search, so that no arcs are left out.
AG::internal::Labels labels_of_sources(const Grid_graph& graph)
{
  AG::internal::Labels result(graph.number_of_nodes());
  for(Grid_graph::Node node = 0; node < graph.number_of_nodes(); ++node)
    result.set(node, 0, AG::internal::Labels::null_node);
  return result;
}

// The graph with all arcs.
class Graph_with_all_arcs : public Grid_graph
{
public:
  explicit Graph_with_all_arcs(const Grid_graph& graph)
    : Grid_graph(graph), m_labels(labels_of_sources(graph))
  {
  }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& /* labels */, F f) const
  {
    Grid_graph::for_each_arc(node, m_labels, f);
  }

private:
  AG::internal::Labels m_labels;
};

TEST(Grid_graph, leaves_out_useless_arcs_only)
{
  Random random(test_seed());
  const Grid_shape shape{15, 11, 1, 0.8, {}};
  for(std::size_t i = 0; i < 10; ++i)
  {
    const Cell_values friction = i == 0 ? equal_cells(shape) : random_friction(random, shape);
    const Graph_with_all_arcs all(Grid_graph(shape, friction, epsilon(0.2)));
    const Grid_graph& graph = all;
    Propagation search(graph);
    Propagation<Graph_with_all_arcs> other(all);
    search.run_from(0);
    other.run_from(0);
    for(Grid_graph::Node node = 0; node < graph.number_of_nodes(); ++node)
    {
      const double distance = search.distance(node), expected = other.distance(node);
      if(std::isinf(expected))
        EXPECT_EQ(distance, expected);
      else
        EXPECT_NEAR(distance, expected, 1e-12 * expected);
    }
  }
}

// ----- cells that cannot be entered

TEST(Grid_graph, does_not_pass_between_cells_that_touch_at_a_corner)
{
  const Grid_shape shape{20, 20, 1, 1, -9999};
  for(const bool is_closed : {true, false})
  {
    Cell_values friction = equal_cells(shape);
    for(std::size_t i = 0; i < 20; ++i)
      friction[shape.index({i, 19 - i})] = -9999;
    if(!is_closed)
      friction[shape.index({0, 19})] = 1;
    for(const Grid_graph& graph :
        {Grid_graph(shape, friction), Grid_graph(shape, friction, epsilon(0.1))})
    {
      const double distance = distances_of_cells(graph, {3, 3})[shape.index({17, 17})];
      EXPECT_EQ(std::isinf(distance), is_closed);
    }
  }
}

TEST(Grid_graph, goes_around_barriers)
{
  const Grid_shape shape{21, 21, 1, 1, std::numeric_limits<double>::quiet_NaN()};
  Cell_values friction = equal_cells(shape);
  for(std::size_t row = 0; row < 15; ++row)
    friction[shape.index({10, row})] = *shape.no_data;
  // over both corners at the end of the barrier
  const double expected = 2 * std::hypot(14.5 - 10, 10.5 - 4) + 1;
  const auto found = [&](const Grid_graph& graph) {
    return distances_of_cells(graph, {3, 10})[shape.index({17, 10})];
  };
  EXPECT_GE(found(Grid_graph(shape, friction)), 2 * std::hypot(6.5, 4.5) + 1 - slack_of_costs);
  const double with_points = found(Grid_graph(shape, friction, epsilon(0.05)));
  EXPECT_GE(with_points, expected - slack_of_costs);
  EXPECT_LE(with_points, expected * 1.005);
}

TEST(Grid_graph, stays_in_a_blocked_source)
{
  const Grid_shape shape{3, 3, 1, 1, {}};
  Cell_values friction = equal_cells(shape);
  friction[4] = no_way;
  const Grid_graph graph(shape, friction, epsilon(0.1));
  const std::vector<double> distances = distances_of_cells(graph, {1, 1});
  for(std::size_t i = 0; i < distances.size(); ++i)
    EXPECT_EQ(distances[i], i == 4 ? 0 : no_way);
}

// ----- small and extreme grids

TEST(Grid_graph, has_rows_and_columns_of_any_number)
{
  for(const std::size_t n : {1u, 2u, 50u})
    for(const bool is_row : {true, false})
    {
      const Grid_shape shape{is_row ? n : 1, is_row ? 1 : n, 2, 2, {}};
      Cell_values friction;
      double expected = 0;
      for(std::size_t i = 0; i < n; ++i)
        friction.push_back(1 + static_cast<double>(i % 3));
      for(std::size_t i = 0; i + 1 < n; ++i)
        expected += friction[i] + friction[i + 1];
      EXPECT_NEAR(distances_of_cells(Grid_graph(shape, friction), {}).back(), expected, 1e-9);
      EXPECT_NEAR(distances_of_cells(Grid_graph(shape, friction, epsilon(0.3)), {}).back(),
                  expected, 1e-9);
    }
}

TEST(Grid_graph, accepts_extreme_sizes_and_friction)
{
  for(const double size : {1e-100, 1e100})
    for(const double friction : {1e-100, 1., 1e40})
    {
      const Grid_shape shape{12, 12, size, size, {}};
      const Grid_graph graph(shape, equal_cells(shape, friction), epsilon(0.2));
      const double found = distances_of_cells(graph, {})[shape.index({11, 11})];
      EXPECT_NEAR(found / (friction * size * std::hypot(11, 11)), 1, 1e-9);
    }
  const Grid_shape shape{5, 4, 1, 1, {}};
  for(const double distance : distances_of_cells(Grid_graph(shape, equal_cells(shape, 0)), {}))
    EXPECT_EQ(distance, 0);
}

TEST(Grid_graph, knows_where_nodes_are)
{
  const Grid_shape shape{4, 3, 2, 5, {}};
  const Grid_graph graph(shape, equal_cells(shape), epsilon(0.2));
  const AG::internal::Labels labels = labels_of_sources(graph);
  for(Grid_graph::Node node = 0; node < graph.number_of_nodes(); ++node)
    graph.for_each_arc(node, labels, [&](const auto target, const auto& costs, auto... number) {
      if constexpr(sizeof...(number) == 0)
        EXPECT_NEAR(costs, straight_distance(graph.position(node), graph.position(target)), 1e-9);
      else
        for(std::size_t i = 0; i < (number + ...); ++i)
          EXPECT_NEAR(costs[i],
                      straight_distance(graph.position(node),
                                        graph.position(target + static_cast<Grid_graph::Node>(i))),
                      1e-9);
    });
  EXPECT_GT(graph.memory(), 12 * sizeof(double));
}

// The bound follows from these inequalities.
TEST(Grid_graph, places_points_as_the_proof_needs)
{
  for(const double height : {1., 0.3, 1.7})
    for(const double e : {1., 0.1, 0.003})
    {
      const AG::internal::Grid_border border({1, 1, 1, height, {}}, e);
      const double crossings = 0.65 * e, corners = (e - crossings) / (1 + crossings / 2);
      const double half = (std::min)(1., height) / 2;
      std::vector<double> row, column;
      for(std::size_t i = 0; i < border.size_of_block(); ++i)
      {
        const Grid_point& p = border.position_in_block(i);
        if(!border.is_corner(i))
          (p.y == 0 ? row : column).push_back(p.x + p.y);
      }
      for(const bool is_row : {true, false})
      {
        const std::vector<double>& points = is_row ? row : column;
        const double length = is_row ? 1 : height;
        const double sine = (std::min)(1., is_row ? height : 1 / height);
        for(const double start : {points.front(), length - points.back()})
          EXPECT_LE(start / (half - start), corners * (1 + 1e-6));
        for(std::size_t i = 0; i + 1 < points.size(); ++i)
          for(const double t : {0.1, 0.3, 0.45, 0.5, 0.6, 0.8})
          {
            const double gap = points[i + 1] - points[i], x = points[i] + t * gap;
            const double to_others = sine * (std::min)(x, length - x);
            EXPECT_LE(t * (1 - t) * gap * gap, crossings * to_others * to_others * (1 + 1e-6));
          }
      }
    }
}

// ----- bad input

TEST(Grid_graph, rejects_bad_input)
{
  const Grid_shape shape{4, 3, 1, 1, {}};
  const auto rejects = [](const Grid_shape& s, const Cell_values& f, const char* const text) {
    expect_message<std::invalid_argument>([&] { Grid_graph(s, f); }, text);
  };
  rejects({0, 3, 1, 1, {}}, {}, "no cells");
  rejects({3, 0, 1, 1, {}}, {}, "no cells");
  for(const double size : {0., -1., std::nan(""), no_way})
  {
    rejects({4, 3, size, 1, {}}, equal_cells(shape), "width");
    rejects({4, 3, 1, size, {}}, equal_cells(shape), "height");
  }
  rejects(shape, Cell_values(11, 1), "11 values of friction, and 12 cells");
  rejects(shape, Cell_values(13, 1), "13 values");
  for(const double wrong : {-1., std::nan("")})
  {
    Cell_values friction = equal_cells(shape);
    friction[6] = wrong;
    rejects(shape, friction, "cell (2, 1)");
  }
  rejects(shape, Cell_values(12, 1e200), "too large");
  for(const double e : {0., -0.1, std::nan(""), no_way})
    expect_message<std::invalid_argument>(
        [&] { Grid_graph(shape, equal_cells(shape), epsilon(e)); }, "epsilon");
  expect_message<std::length_error>([&] { Grid_graph(shape, equal_cells(shape), epsilon(1e-6)); },
                                    "points on a side");
  constexpr std::size_t most = (std::numeric_limits<std::size_t>::max)();
  for(const Grid_shape& s : {Grid_shape{most, 2, 1, 1, {}}, Grid_shape{2, most, 1, 1, {}},
                             Grid_shape{most, most, 1, 1, {}}})
    expect_message<std::length_error>([&] { Grid_graph(s, Cell_values()); }, "2^32 - 1");
  rejects({0xffffffff, 1, 1, 1, {}}, Cell_values(1), "1 values"); // before memory is allocated
  expect_message<std::length_error>(
      [&] {
        Grid_graph({std::size_t(1) << 14, std::size_t(1) << 14, 1, 1, {}}, Cell_values(),
                   epsilon(0.1));
      },
      "2^32 - 1");
  const Grid_graph graph(shape, equal_cells(shape));
  expect_message<std::invalid_argument>([&] { graph.node({4, 0}); }, "(4, 0)", "4 columns");
}

} // namespace
