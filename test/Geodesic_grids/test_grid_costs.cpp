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
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_distances_on_grid.h>

#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

// Grids with heights and costs that depend on the direction, against closed forms, and against
// meshes.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::directional_cost;
using AG::Grid_vector;
using AG::Hiking_time;
using AG::Propagation;
using CGAL::parameters::direction_to_source;
using CGAL::parameters::face_weight_map;
using CGAL::parameters::heights;

double hill(const double x, const double y)
{
  return 6 * std::sin(x / 40) * std::cos(y / 55) + 0.05 * x;
}

// ----- planes

// Expects costs between those of the cheapest straight lines and zigzags, which `cost(x, y)`
// returns for a horizontal vector, and the tolerance.
template <typename Cost>
void expect_costs_of_plane(const Grid_shape& shape,
                           const Grid_cell& source,
                           const Cell_values& found,
                           const Cost& cost,
                           const double tolerance)
{
  constexpr double slack = 1e-6; // of slopes that are tried
  const Grid_point p = shape.center(source);
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    const Grid_point q = shape.center(shape.cell(i));
    const double expected = cost(q.x - p.x, q.y - p.y);
    EXPECT_GE(found[i], expected * (1 - slack));
    EXPECT_LE(found[i], expected * (1 + tolerance));
  }
}

TEST(Grid_costs, are_lengths_on_a_slanted_plane)
{
  const Grid_shape shape{60, 50, 2, 1.5, {}};
  const Cell_values h =
      values_of_cells(shape, [](double x, double y) { return 0.3 * x - 0.2 * y; });
  const Grid_cell source{20, 17};
  expect_costs_of_plane(
      shape, source, costs_of_cells(shape, 2, source, heights(h)),
      [](const double x, const double y) {
        return 2 * std::hypot(std::hypot(x, y), 0.3 * x - 0.2 * y);
      },
      0.003);
}

// The cost of a vector on a plane, the slope of which is in the direction of x. Slopes beyond the
// steepest one are climbed in zigzags of this slope.
template <typename Cost>
double cost_on_slope(const Cost& cost, const double rise, const double x, const double y)
{
  const double run = std::hypot(x, y), height = rise * x;
  if(run == 0 || height == 0)
    return run * cost(0);
  double result = no_way; // of the smallest cost of a zigzag
  for(int i = 1; i <= 4000; ++i)
  {
    const double s = height / run * i / 4000;
    result = (std::min)(result, run * height / run / s * std::sqrt(1 + s * s) * cost(s));
  }
  return result;
}

TEST(Grid_costs, are_times_of_hikers_on_planes)
{
  const Grid_shape shape{41, 37, 10, 10, {}};
  const Hiking_time cost;
  for(const double rise : {0.05, 0.2, 0.5})
  {
    const Cell_values h = values_of_cells(shape, [&](double x, double) { return rise * x; });
    const Grid_cell source{20, 17};
    const auto there = heights(std::cref(h)).face_weight_map(directional_cost(cost));
    const double tolerance = rise > 0.3 ? 0.06 : 0.012;
    expect_costs_of_plane(
        shape, source, costs_of_cells(shape, 1, source, there),
        [&](double x, double y) { return cost_on_slope(cost, rise, x, y); }, tolerance);
    expect_costs_of_plane(
        shape, source, costs_of_cells(shape, 1, source, there.direction_to_source(true)),
        [&](double x, double y) { return cost_on_slope(cost, rise, -x, -y); }, tolerance);
  }
}

TEST(Grid_costs, climb_walls_in_zigzags)
{
  const Grid_shape shape{7, 30, 10, 10, {}};
  const Hiking_time cost;
  double climb = no_way;
  for(double s = 0.2; s < 0.4; s += 1e-5)
    climb = (std::min)(climb, std::sqrt(1 + s * s) * cost(s) / s);
  for(const double rise : {0.4, 1., 3.9, 7., 1e4})
  {
    const Cell_values h = values_of_cells(shape, [&](double, double y) { return rise * y; });
    const Cell_values found = costs_of_cells(shape, 1, Grid_cell{3, 0},
                                             heights(h).face_weight_map(directional_cost(cost)));
    const double height = 290 * rise;
    EXPECT_NEAR(found[shape.index({3, 29})] / (height * climb), 1, 1e-6);
  }
}

TEST(Grid_costs, do_not_climb_what_cannot_be_climbed)
{
  const Grid_shape shape{9, 9, 1, 1, {}};
  const Cell_values h =
      values_of_cells(shape, [](double x, double) { return -0.1 * std::abs(x - 4.5); });
  const auto down = [](const double slope) { return slope > 0 ? no_way : 1; };
  const Cell_values found =
      costs_of_cells(shape, 1, Grid_cell{0, 4}, heights(h).face_weight_map(directional_cost(down)));
  EXPECT_EQ(found[shape.index({4, 4})], no_way);
  EXPECT_EQ(found[shape.index({0, 8})], 4);
  const Cell_values back =
      costs_of_cells(shape, 1, Grid_cell{0, 4},
                     heights(h).face_weight_map(directional_cost(down)).direction_to_source(true));
  EXPECT_NEAR(back[shape.index({4, 4})], 4 * std::hypot(1, 0.1), 1e-9);
  EXPECT_EQ(back[shape.index({8, 4})], no_way);
}

TEST(Grid_costs, have_their_published_values)
{
  const AG::Naismith_time time;
  const auto of_horizontal = [&](const double s) { return std::sqrt(1 + s * s) * time(s); };
  EXPECT_NEAR(of_horizontal(0), 0.72, 1e-12);
  EXPECT_NEAR(of_horizontal(0.1), 0.72 + 0.6, 1e-12);
  EXPECT_NEAR(of_horizontal(-0.2), 0.72 - 0.4, 1e-12);
  EXPECT_NEAR(of_horizontal(-0.3), 0.72 + 0.6, 1e-12);
  EXPECT_EQ(time(no_way), 6);
  EXPECT_EQ(time(-no_way), 2);
  EXPECT_EQ(Hiking_time(2)(-0.05), 0.3);
  EXPECT_EQ(AG::Walking_energy()(0.), 2.5);
  expect_message<std::invalid_argument>([] { return AG::Naismith_time(0.4); }, "0.425");
  expect_message<std::invalid_argument>([] { return AG::Naismith_time(no_way); }, "pace");
  for(const double wrong : {-1., std::nan(""), no_way})
    expect_message<std::invalid_argument>([&] { return AG::Naismith_time(1, wrong); }, "ascents");
}

TEST(Grid_costs, are_interpolated_with_the_error_that_is_told)
{
  const Grid_shape shape{3, 3, 1, 1, {}};
  const Cell_values h(9, 0);
  const auto graph = [&](const auto& f) {
    return Grid_graph(shape, 1, heights(h).face_weight_map(directional_cost(f)));
  };
  EXPECT_LT(graph(Hiking_time()).error_of_slopes(), 1e-6);
  EXPECT_LT(graph(AG::Walking_energy()).error_of_slopes(), 1e-5);
  EXPECT_LT(graph(AG::Naismith_time()).error_of_slopes(), 1e-6);
  const auto jump = [](const double s) { return s < 0.0001 ? 1 : 2; };
  EXPECT_GT(graph(jump).error_of_slopes(), 0.1);
  EXPECT_EQ(Grid_graph(shape, 1, heights(h)).error_of_slopes(), 0);
}

// ----- hills

// The grid as a mesh, two faces for each square of four centers.
template <typename Height>
Mesh mesh_of_centers(const Grid_shape& shape, const Height& height)
{
  Mesh mesh;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
  {
    const Grid_point p = shape.center(shape.cell(i));
    mesh.add_vertex(Point(p.x, p.y, height(p.x, p.y)));
  }
  for(std::size_t row = 0; row + 1 < shape.rows; ++row)
    for(std::size_t column = 0; column + 1 < shape.columns; ++column)
    {
      const auto vertex = [&](const std::size_t c, const std::size_t r) {
        return Vertex(static_cast<Vertex::size_type>(shape.index({column + c, row + r})));
      };
      mesh.add_face(vertex(0, 0), vertex(1, 0), vertex(1, 1));
      mesh.add_face(vertex(0, 0), vertex(1, 1), vertex(0, 1));
    }
  return mesh;
}

template <typename Cost>
void expect_costs_of_mesh(const Cost& cost, const double tolerance, const bool is_to_source)
{
  const Grid_shape shape{26, 24, 10, 10, {}};
  const Cell_values h = values_of_cells(shape, hill);
  const Grid_cell source{7, 9};
  const Cell_values found = costs_of_cells(
      shape, 1, source, heights(h).face_weight_map(cost).direction_to_source(is_to_source));
  const Mesh mesh = mesh_of_centers(shape, hill);
  Mesh measured = mesh;
  auto distance = measured.add_property_map<Vertex, double>("v:distance").first;
  CGAL::approximate_geodesic_distances(
      measured, distance, Vertex(static_cast<Vertex::size_type>(shape.index(source))),
      face_weight_map(cost).direction_to_source(is_to_source).number_of_points_per_edge(8));
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], distance[Vertex(static_cast<Vertex::size_type>(i))],
                tolerance * found[i]);
}

TEST(Grid_costs, are_those_of_a_mesh)
{
  for(const bool is_to_source : {false, true})
  {
    expect_costs_of_mesh(directional_cost(Hiking_time()), 0.03, is_to_source);
    expect_costs_of_mesh(directional_cost(AG::Naismith_time()), 0.03, is_to_source);
    expect_costs_of_mesh(directional_cost([](const double s) { return 1 + s * s; }), 0.01,
                         is_to_source);
  }
}

Cell_values random_heights(Random& random, const Grid_shape& shape)
{
  const double phase = random.between(0, 6), size = random.between(0, 2);
  return values_of_cells(shape, [&](const double x, const double y) {
    return size * std::sin(x / 3 + phase) * std::cos(y / 4) + random.between(0, size / 3);
  });
}

Cell_values friction_with_barriers(Random& random, const Grid_shape& shape)
{
  return values_of_cells(shape, [&](double, double) {
    return random.below(6) == 0 ? no_way : random.between(0.5, 2);
  });
}

TEST(Grid_costs, are_there_what_they_are_back_from_the_other_end)
{
  Random random(test_seed());
  const Grid_shape shape{17, 13, 1, 1.2, {}};
  for(int i = 0; i < 5; ++i)
  {
    const Cell_values h = random_heights(random, shape),
                      friction = friction_with_barriers(random, shape);
    const Grid_cell a = shape.cell(random.below(friction.size()));
    const auto cost = heights(h).face_weight_map(directional_cost(Hiking_time()));
    const Cell_values to_a = costs_of_cells(shape, friction, a, cost.direction_to_source(true));
    for(int k = 0; k < 5; ++k)
    {
      const Grid_cell b = shape.cell(random.below(friction.size()));
      const double there = costs_of_cells(shape, friction, b, cost)[shape.index(a)];
      if(std::isinf(there))
        EXPECT_EQ(to_a[shape.index(b)], no_way);
      else
        EXPECT_NEAR(there, to_a[shape.index(b)], slack_of_costs * there);
    }
  }
}

// The graph with all lines, as labels tell nothing.
class Graph_with_all_lines : public Grid_graph
{
public:
  explicit Graph_with_all_lines(const Grid_graph& graph) : Grid_graph(graph) {}

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& /* labels */, F f) const
  {
    struct None
    {
      double distance(const Node other) const { return other == node ? 0 : no_way; }
      Node predecessor(Node) const { return (std::numeric_limits<Node>::max)(); }
      Node node;
    };
    Grid_graph::for_each_arc(node, None{node}, f);
  }
};

TEST(Grid_costs, do_not_need_the_lines_that_are_left_out)
{
  Random random(test_seed());
  const Grid_shape shape{19, 23, 1, 1.2, {}};
  for(int i = 0; i < 6; ++i)
  {
    const Cell_values h = random_heights(random, shape),
                      friction = friction_with_barriers(random, shape);
    const auto jump = [](const double s) { return s > 0.1 && s < 0.2 ? 3 : 1; }; // not convex
    const Graph_with_all_lines all(
        i % 2 == 0 ? Grid_graph(shape, friction, heights(h).face_weight_map(directional_cost(jump)))
                   : Grid_graph(shape, friction,
                                heights(h).face_weight_map(directional_cost(Hiking_time()))));
    const Grid_graph& graph = all;
    Propagation search(graph);
    Propagation<Graph_with_all_lines> other(all);
    Propagation<Grid_graph, AG::Binary_heap_queue> by_heap(graph);
    search.run_from(0);
    other.run_from(0);
    by_heap.run_from(0);
    for(Grid_graph::Node node = 0; node < graph.number_of_nodes(); ++node)
    {
      EXPECT_EQ(search.distance(node), other.distance(node));
      EXPECT_EQ(search.distance(node), by_heap.distance(node));
    }
  }
}

TEST(Grid_costs, give_lower_bounds_and_paths)
{
  Random random(test_seed());
  const Grid_shape shape{31, 29, 1, 1.2, {}};
  for(int i = 0; i < 6; ++i)
  {
    const Cell_values h = random_heights(random, shape),
                      friction = friction_with_barriers(random, shape);
    const auto cost = heights(h).face_weight_map(directional_cost(Hiking_time()));
    const Grid_graph graph(shape, friction, cost);
    const Grid_cell source = shape.cell(random.below(friction.size())),
                    target = shape.cell(random.below(friction.size()));
    const Cell_values found = costs_of_cells(shape, friction, source, cost);
    const double expected = found[shape.index(target)];
    std::vector<Grid_point> path;
    EXPECT_EQ(CGAL::approximate_geodesic_path_on_grid(shape, friction, std::back_inserter(path),
                                                      source, target, cost),
              expected);
    EXPECT_EQ(path.empty(), std::isinf(expected));
    for(std::size_t k = 0; k < found.size(); ++k)
      EXPECT_LE(graph.lower_bound(graph.node(source), static_cast<Grid_graph::Node>(k)),
                found[k] * (1 + slack_of_costs));
    EXPECT_EQ(graph.height(target), h[shape.index(target)]);
  }
}

// ----- barriers

TEST(Grid_costs, do_not_enter_cells_without_heights)
{
  const Grid_shape shape{21, 21, 1, 1, -9999};
  Cell_values h = values_of_cells(shape, [](double x, double) { return 0.1 * x; });
  for(std::size_t row = 0; row < 15; ++row)
    h[shape.index({10, row})] = -9999;
  const Cell_values found = costs_of_cells(shape, 1, Grid_cell{3, 10}, heights(h));
  EXPECT_EQ(found[shape.index({10, 3})], no_way);
  const double steep = std::sqrt(1.01);
  EXPECT_GE(found[shape.index({17, 10})], steep * 2 * std::hypot(6.5, 4.5) + 1);
  EXPECT_LE(found[shape.index({17, 10})], steep * (2 * std::hypot(7, 5) + 2));
  Cell_values diagonal(shape.number_of_cells(), 0);
  for(std::size_t i = 0; i < 21; ++i)
    diagonal[shape.index({i, 20 - i})] = -9999;
  EXPECT_EQ(costs_of_cells(shape, 1, Grid_cell{3, 3}, heights(diagonal))[shape.index({17, 17})],
            no_way);
}

TEST(Grid_costs, compare_heights_only_with_no_data_if_friction_is_one_number)
{
  const Grid_shape shape{3, 1, 1, 1, 2};
  EXPECT_EQ(costs_of_cells(shape, 2, Grid_cell{}, heights(Cell_values{0, 0, 2})),
            (Cell_values{0, 2, no_way}));
  const Grid_shape other{3, 1, 1, 1, std::nan("")};
  expect_message<std::invalid_argument>([&] { Grid_graph(other, std::nan("")); }, "friction");
}

TEST(Grid_costs, multiply_costs_by_friction)
{
  Random random(test_seed());
  const Grid_shape shape{20, 20, 1, 1, {}};
  const Cell_values h = random_heights(random, shape);
  const auto cost = heights(h).face_weight_map(directional_cost(Hiking_time()));
  const Cell_values once = costs_of_cells(shape, 1, Grid_cell{4, 5}, cost);
  Cell_values friction(shape.number_of_cells(), 2); // one of them is different, and out of the way
  friction.back() = 2.5;
  const Cell_values twice = costs_of_cells(shape, friction, Grid_cell{4, 5}, cost);
  for(std::size_t i = 0; i + 1 < once.size(); ++i)
    EXPECT_NEAR(twice[i], 2 * once[i], slack_of_costs * twice[i]);
  const Cell_values free = costs_of_cells(shape, 0, Grid_cell{4, 5}, cost);
  EXPECT_EQ(free, Cell_values(free.size(), 0));
}

// ----- functions of cell and direction

TEST(Grid_costs, are_times_in_a_wind)
{
  const Grid_shape shape{50, 40, 1, 1.3, {}};
  const auto wind = boost::make_function_property_map<Grid_cell>(
      [](const Grid_cell&) { return Grid_vector(0.5, 0.3); });
  const auto cost = directional_cost(AG::Drift_time(wind, 1));
  const auto time = [](const double x, const double y) { // |t (wind + speed)| is the distance
    const double a = 1 - 0.34, b = 0.5 * x + 0.3 * y, c = x * x + y * y;
    return (std::sqrt(b * b + a * c) - b) / a;
  };
  const Grid_cell source{22, 11};
  expect_costs_of_plane(shape, source, costs_of_cells(shape, 1, source, face_weight_map(cost)),
                        time, 0.02);
  expect_costs_of_plane(
      shape, source,
      costs_of_cells(shape, 1, source, face_weight_map(cost).direction_to_source(true)),
      [&](const double x, const double y) { return time(-x, -y); }, 0.02);
  const Grid_graph graph(shape, 1, face_weight_map(cost));
  EXPECT_NEAR(graph.lower_bound(0, 49), 49 / (1 + std::hypot(0.5, 0.3)), 0.1);
  const Cell_values flat(shape.number_of_cells(), 3);
  const Cell_values on_plain =
      costs_of_cells(shape, 1, source, heights(flat).face_weight_map(cost));
  const Cell_values in_plane = costs_of_cells(shape, 1, source, face_weight_map(cost));
  for(std::size_t i = 0; i < flat.size(); ++i)
    EXPECT_NEAR(on_plain[i], in_plane[i], slack_of_costs * in_plane[i]);
}

TEST(Grid_costs, may_be_functions_of_cells_and_directions)
{
  Random random(test_seed());
  const Grid_shape shape{21, 20, 1, 1, {}};
  const Cell_values h = random_heights(random, shape),
                    friction = friction_with_barriers(random, shape);
  const Hiking_time time;
  const auto with_cells = [&](const Grid_cell& cell, const Grid_vector& d) {
    EXPECT_NEAR(d * d, 1, 1e-12);
    return (cell.column < 10 ? 1 : 2) * time(d.z() / std::hypot(d.x(), d.y()));
  };
  Cell_values doubled = friction;
  for(std::size_t i = 0; i < doubled.size(); ++i)
    doubled[i] *= shape.cell(i).column < 10 ? 1 : 2;
  for(const bool is_to_source : {false, true})
  {
    const auto by_cells = costs_of_cells(
        shape, friction, Grid_cell{2, 2},
        heights(h).face_weight_map(directional_cost(with_cells)).direction_to_source(is_to_source));
    // as slopes are small, there are no zigzags, which such functions do without
    const auto by_slopes = costs_of_cells(
        shape, doubled, Grid_cell{2, 2},
        heights(h).face_weight_map(directional_cost(time)).direction_to_source(is_to_source));
    for(std::size_t i = 0; i < by_cells.size(); ++i)
      if(std::isinf(by_slopes[i]))
        EXPECT_EQ(by_cells[i], no_way);
      else
        EXPECT_GE(by_cells[i], by_slopes[i] * (1 - 1e-5));
  }
}

TEST(Grid_costs, make_cells_one_way)
{
  const Grid_shape shape{12, 9, 1, 1, {}};
  const auto ways = boost::make_function_property_map<Grid_cell>(
      [](const Grid_cell&) { return Grid_vector(1, 0); });
  const Cell_values found = costs_of_cells(shape, 1, Grid_cell{5, 4},
                                           face_weight_map(directional_cost(AG::One_way(ways))));
  EXPECT_EQ(found[shape.index({11, 4})], 6);
  EXPECT_EQ(found[shape.index({5, 0})], 4);
  EXPECT_EQ(found[shape.index({4, 4})], no_way);
}

// ----- bad input

TEST(Grid_costs, reject_bad_input)
{
  const Grid_shape shape{4, 3, 1, 1, {}};
  const auto rejects = [&](const auto& np, const char* const text, const char* const more = "") {
    expect_message<std::invalid_argument>([&] { Grid_graph(shape, 1, np); }, text, more);
  };
  rejects(heights(Cell_values(11, 0)), "11 values of height, and 12 cells");
  for(const double wrong : {std::nan(""), no_way, -no_way, 1e101})
  {
    Cell_values h(12, 0);
    h[6] = wrong;
    rejects(heights(h), "height of cell (2, 1)");
  }
  const Cell_values flat(12, 0);
  const auto negative = [](const double s) { return 1 - 2 * s; };
  rejects(heights(flat).face_weight_map(directional_cost(negative)), "for the slope 0.5");
  rejects(heights(flat).face_weight_map(directional_cost([](double) { return std::nan(""); })),
          "slope 0");
  const auto of_cell = [](const Grid_cell& cell, const Grid_vector&) {
    return cell == Grid_cell{2, 1} ? -1. : 1.;
  };
  rejects(face_weight_map(directional_cost(of_cell)), "cost of cell (2, 1)", "-1 in direction");
  const auto of_cell_on_heights = [](const Grid_cell& cell, const Grid_vector&) {
    return cell == Grid_cell{2, 2} ? std::nan("") : 1.;
  };
  expect_message<std::invalid_argument>(
      [&] {
        costs_of_cells(shape, 1, Grid_cell{},
                       heights(flat).face_weight_map(directional_cost(of_cell_on_heights)));
      },
      "cost of cell (2, 2)");
}

TEST(Grid_costs, have_rows_and_columns_of_any_number)
{
  for(const std::size_t n : {1u, 2u, 40u})
    for(const bool is_row : {true, false})
    {
      const Grid_shape shape{is_row ? n : 1, is_row ? 1 : n, 2, 2, {}};
      Cell_values h;
      for(std::size_t i = 0; i < n; ++i)
        h.push_back(i % 2 == 0 ? 0 : 1.5);
      EXPECT_NEAR(costs_of_cells(shape, 3, Grid_cell{}, heights(h)).back(),
                  3 * 2.5 * static_cast<double>(n - 1), 1e-9);
    }
}

TEST(Grid_costs, survive_extreme_heights)
{
  const Grid_shape shape{6, 5, 1e-3, 1e-3, {}};
  Cell_values h(30, 0);
  h[7] = 9e99;
  h[8] = -9e99;
  for(const double cost : costs_of_cells(shape, 1, Grid_cell{}, heights(h)))
    EXPECT_LT(cost, no_way);
  for(const double cost : costs_of_cells(
          shape, 1, Grid_cell{}, heights(h).face_weight_map(directional_cost(Hiking_time()))))
    EXPECT_FALSE(std::isnan(cost));
  const Grid_shape tiny{6, 5, 1e-120, 1e-120, {}};
  const auto of_cells = directional_cost([](const Grid_cell&, const Grid_vector& d) {
    EXPECT_FALSE(std::isnan(d.z()));
    return 1;
  });
  for(const double cost :
      costs_of_cells(tiny, 0, Grid_cell{}, heights(h).face_weight_map(of_cells)))
    EXPECT_FALSE(std::isnan(cost));
  for(const double cost : costs_of_cells(
          tiny, 0, Grid_cell{}, heights(h).face_weight_map(directional_cost(Hiking_time()))))
    EXPECT_FALSE(std::isnan(cost));
  const Grid_shape all{2, 2, 1, 1, 7};
  const Cell_values none(4, 7);
  EXPECT_EQ(costs_of_cells(all, 1, Grid_cell{}, heights(none)),
            (Cell_values{0, no_way, no_way, no_way}));
}

} // namespace
