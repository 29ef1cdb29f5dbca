// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Solver.h>

#include "checks/solvers.h"
#include "meshes/test_meshes.h"
#include "meshes/test_soup.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs/Directional_graph.h>
#include <CGAL/Geodesic_costs/equal_parts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// The solver on plain arrays gives what the class gives on the same mesh, and names what is wrong.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Values = std::vector<double>;

AG::Solver_row_options radius_options(const double maximum_distance, const std::size_t threads)
{
  AG::Solver_row_options result;
  result.maximum_distance = maximum_distance;
  result.number_of_threads = threads;
  return result;
}

template <typename Graph, typename... NamedParameters>
void expect_same_as_class(const Solver& solver, const Mesh& mesh, const NamedParameters&... np)
{
  AG::Surface_mesh_shortest_path<Mesh, Graph> paths(mesh, np...);
  paths.add_source_point(Vertex(3));
  Values expected(mesh.number_of_vertices());
  paths.shortest_distances_to_source_points(
      CGAL::make_property_map(expected)); // numbers are those of the arrays
  EXPECT_EQ(solver_distances(solver), expected);
}

TEST(Solver, finds_the_distances_of_the_class)
{
  const Soup soup = sphere(12, 9);
  const Mesh mesh = to_mesh(soup);
  const Soup_arrays arrays(soup);
  expect_same_as_class<AG::Edge_graph>(Solver_of(arrays), mesh);
  expect_same_as_class<AG::Saddle_vertex_graph>(Solver_of(arrays, bound(0)), mesh);
  expect_same_as_class<AG::Discrete_geodesic_graph>(Solver_of(arrays, bound(0.2)), mesh,
                                                    CGAL::parameters::epsilon(0.2));
}

TEST(Solver, takes_points_of_faces_by_the_order_of_their_corners)
{
  const Soup soup = flat_grid(6, 5);
  const Soup_arrays arrays(soup);
  const Solver_of solver(arrays, bound(0));
  const std::array<double, 3> weights{0.2, 0.3, 0.5};
  for(std::size_t f = 0; f < arrays.number_of_faces(); ++f)
  {
    const auto& t = soup.triangles[f];
    const Point p = CGAL::barycenter(soup.points[t[0]], weights[0], soup.points[t[1]], weights[1],
                                     soup.points[t[2]], weights[2]);
    const auto found =
        solver_distances(solver, {Solver_point::in_face(static_cast<std::int64_t>(f), weights)});
    for(std::size_t v = 0; v < found.size(); ++v)
      EXPECT_NEAR(found[v], std::sqrt(CGAL::squared_distance(p, soup.points[v])), 1e-12);
  }
}

TEST(Solver, finds_paths_from_the_source_to_the_target)
{
  const Soup soup = flat_grid(6, 5);
  const Solver_of solver{Soup_arrays(soup)};
  for(const bool straighten : {false, true})
  {
    Values points;
    const double length = solver.find_path(Solver_point::at_vertex(0), Solver_point::at_vertex(14),
                                           straighten, points);
    ASSERT_GE(points.size(), 6u);
    EXPECT_EQ(Point(points[0], points[1], points[2]), soup.points[0]);
    EXPECT_EQ(Point(points.end()[-3], points.end()[-2], points.end()[-1]), soup.points[14]);
    double sum = 0;
    for(std::size_t i = 3; i < points.size(); i += 3)
      sum += std::hypot(points[i] - points[i - 3], points[i + 1] - points[i - 2],
                        points[i + 2] - points[i - 1]);
    EXPECT_NEAR(sum, length, 1e-12);
    if(straighten)
    {
      EXPECT_NEAR(length, std::sqrt(CGAL::squared_distance(soup.points[0], soup.points[14])),
                  1e-12);
    }
  }
}

TEST(Solver, tells_which_points_of_a_path_are_vertices)
{
  const Soup soup = flat_grid(6, 5);
  const auto vertices_of_path = [&](const AG::Solver_options& options) {
    Values points;
    std::vector<std::int64_t> vertices;
    Solver_of(Soup_arrays(soup), options)
        .find_path(Solver_point::at_vertex(0), Solver_point::at_vertex(14), false, points, {},
                   &vertices);
    EXPECT_EQ(points.size(), 3 * vertices.size());
    EXPECT_EQ(vertices.front(), 0);
    EXPECT_EQ(vertices.back(), 14);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(vertices[i] >= 0)
      {
        EXPECT_EQ(soup.points[static_cast<std::size_t>(vertices[i])],
                  Point(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
      }
    return vertices;
  };
  for(const std::int64_t v : vertices_of_path({}))
    EXPECT_GE(v, 0) << "of a path along edges";
  const auto across_faces = vertices_of_path(bound(0));
  EXPECT_EQ(std::count(across_faces.begin(), across_faces.end(), -1),
            static_cast<std::ptrdiff_t>(across_faces.size()) - 2);
}

TEST(Solver, fills_rows_of_matrices)
{
  const Solver_of solver(Soup_arrays(sphere(12, 9)), bound(0.1));
  const std::vector<Solver_point> sources{Solver_point::at_vertex(3), Solver_point::at_vertex(0)};
  const Values expected = solver_distances(solver);
  Values dense(2 * solver.number_of_vertices());
  solver.compute_matrix(dense.data(), sources);
  EXPECT_EQ(Values(dense.begin(), dense.begin() + std::ptrdiff_t(expected.size())), expected);

  AG::Nearest_rows<double> nearest(4);
  solver.compute_matrix(nearest, sources);
  EXPECT_EQ(nearest.number_of_entries(), 8u);
  AG::Radius_rows<double> radius;
  solver.compute_matrix(radius, sources, radius_options(0.5, 1));
  std::size_t number = 0;
  for(const double d : dense)
    number += d <= 0.5 ? 1 : 0;
  EXPECT_EQ(radius.number_of_entries(), number);
}

// ----- directional costs

// A slope, as otherwise there is nothing to climb.
Soup_arrays slope()
{
  Soup soup = flat_grid(6, 5);
  for(Point& p : soup.points)
    p = Point(p.x(), p.y(), 0.3 * p.x() + 0.1 * p.y() * p.y());
  return Soup_arrays(soup);
}

// One of each kind, whose numbers of faces differ.
std::vector<AG::Solver_cost> ready_costs(const Soup_arrays& arrays)
{
  Values vectors, tensors;
  for(std::size_t f = 0; f < arrays.number_of_faces(); ++f)
  {
    const double x = 0.1 * double(f % 7);
    vectors.insert(vectors.end(), {x, 0.3, 0});
    tensors.insert(tensors.end(), {1 + x, 0.1, 0, 2, 0, 3});
  }
  return {AG::Solver_cost::hiking_time(0.6), AG::Solver_cost::walking_energy(),
          AG::Solver_cost::drift_time(vectors, 2), AG::Solver_cost::one_way(vectors, 3, -0.5),
          AG::Solver_cost::tensor_cost(tensors)};
}

Solver_options with_cost(const AG::Solver_cost& cost, const std::optional<double> epsilon)
{
  Solver_options result = bound(epsilon);
  result.directional_cost = cost;
  result.accept_weaker_bound = true; // there is none for ways that are forbidden
  return result;
}

template <typename CostFunction>
void expect_same_costs(const Soup_arrays& arrays,
                       const Mesh& mesh,
                       const AG::Solver_cost& cost,
                       const CostFunction& function)
{
  const auto weights = CGAL::parameters::face_weight_map(AG::directional_cost(function));
  expect_same_as_class<AG::Directional_graph<>>(Solver_of(arrays, with_cost(cost, 0.3)), mesh,
                                                weights.epsilon(0.3).accept_weaker_bound(true));
  expect_same_as_class<AG::Directional_graph<AG::Fixed_number_of_points>>(
      Solver_of(arrays, with_cost(cost, std::nullopt)), mesh, weights.number_of_points_per_edge(0));
}

TEST(Solver, has_the_ready_costs_of_the_class)
{
  const Soup_arrays arrays = slope();
  Soup soup;
  for(std::size_t v = 0; v < arrays.number_of_vertices(); ++v)
    soup.points.emplace_back(arrays.coordinates[3 * v], arrays.coordinates[3 * v + 1],
                             arrays.coordinates[3 * v + 2]);
  for(std::size_t f = 0; f < arrays.number_of_faces(); ++f)
    soup.triangles.push_back({std::size_t(arrays.corners[3 * f]),
                              std::size_t(arrays.corners[3 * f + 1]),
                              std::size_t(arrays.corners[3 * f + 2])});
  const Mesh mesh = to_mesh(soup);
  const auto costs = ready_costs(arrays);
  std::vector<CGAL::Simple_cartesian<double>::Vector_3> vectors;
  std::vector<std::array<double, 6>> tensors;
  for(std::size_t f = 0; f < arrays.number_of_faces(); ++f)
  {
    const double* const v = costs[2].of_faces.data() + 3 * f;
    vectors.emplace_back(v[0], v[1], v[2]);
    std::copy_n(costs[4].of_faces.data() + 6 * f, 6, tensors.emplace_back().begin());
  }
  const auto map = CGAL::make_property_map(vectors);
  expect_same_costs(arrays, mesh, costs[0], AG::Hiking_time(0.6));
  expect_same_costs(arrays, mesh, costs[1], AG::Walking_energy());
  expect_same_costs(arrays, mesh, costs[2], AG::Drift_time(map, 2));
  expect_same_costs(arrays, mesh, costs[3], AG::One_way(map, 3, -0.5));
  expect_same_costs(arrays, mesh, costs[4], AG::Tensor_cost(CGAL::make_property_map(tensors)));
}

TEST(Solver, finds_distances_to_sources)
{
  const Solver_of solver(slope(), with_cost(AG::Solver_cost::hiking_time(), 2));
  const std::size_t size = solver.number_of_vertices();
  std::vector<Solver_point> all;
  for(std::size_t v = 0; v < size; ++v)
    all.push_back(Solver_point::at_vertex(static_cast<std::int64_t>(v)));
  Values there(size * size), back(size * size);
  AG::Solver_row_options to_source;
  to_source.direction_to_source = true;
  solver.compute_matrix(there.data(), all);
  solver.compute_matrix(back.data(), all, to_source);
  std::size_t number_of_differences = 0;
  for(std::size_t i = 0; i < size; ++i)
  {
    Values row(size);
    solver.find_distances({all[i]}, row.data(), nullptr, nullptr, {1e9, true});
    for(std::size_t j = 0; j < size; ++j)
    {
      EXPECT_EQ(row[j], back[i * size + j]);
      EXPECT_NEAR(back[i * size + j], there[j * size + i], 1e-9);
      number_of_differences += std::abs(there[i * size + j] - there[j * size + i]) > 0.1 ? 1 : 0;
    }
  }
  EXPECT_GT(number_of_differences, size);
}

TEST(Solver, saves_directional_costs)
{
  const Soup_arrays arrays = slope();
  for(const auto& cost : ready_costs(arrays))
    for(const std::optional<double> epsilon : {std::optional<double>(), std::optional(0.3)})
    {
      const Solver_of solver(arrays, with_cost(cost, epsilon));
      std::stringstream file;
      solver.save(file);
      const Solver copy(file);
      EXPECT_EQ(solver_distances(copy), solver_distances(solver));
      EXPECT_EQ(copy.error_bound(), solver.error_bound());
      ASSERT_TRUE(copy.directional_cost().has_value());
      EXPECT_EQ(copy.directional_cost()->model, cost.model);
    }
}

TEST(Solver, keeps_a_limit_of_slopes_in_files)
{
  const Soup_arrays arrays = slope();
  const std::vector<double> weights(arrays.number_of_faces(), 2);
  Solver_options options = bound(0.5);
  options.accept_weaker_bound = true;
  const Values free = solver_distances(Solver_of(arrays, options));
  options.max_slope = 0.05;
  for(const double* const w : {static_cast<const double*>(nullptr), weights.data()})
  {
    options.face_weights = w;
    const Solver_of solver(arrays, options);
    std::stringstream file;
    solver.save(file);
    const Solver copy(file);
    EXPECT_EQ(0.05, copy.max_slope());
    const Values found = solver_distances(solver);
    EXPECT_EQ(found, solver_distances(copy));
    EXPECT_GT(*std::max_element(found.begin(), found.end()),
              1.1 * *std::max_element(free.begin(), free.end()));
  }
  options.max_slope = -1;
  expect_message<std::invalid_argument>([&] { Solver_of(arrays, options); }, "max_slope is -1");
}

TEST(Solver, names_what_is_wrong_with_costs)
{
  const Soup_arrays arrays = slope();
  const auto refuse = [&](const std::string& message, const AG::Solver_cost& cost,
                          const std::optional<double> epsilon) {
    Solver_options options = with_cost(cost, epsilon);
    options.accept_weaker_bound = false;
    expect_refused(message, [&] { Solver_of(arrays, options); });
  };
  Values vectors(3 * arrays.number_of_faces(), 1);
  refuse("factor of hiking speeds is 0", AG::Solver_cost::hiking_time(0), 0.5);
  refuse("no exact distances", AG::Solver_cost::hiking_time(), 0.);
  refuse("speed through the drift is -1", AG::Solver_cost::drift_time(vectors, -1), 0.5);
  refuse("accept_weaker_bound", AG::Solver_cost::one_way(vectors), 0.5);
  refuse("2 numbers for", AG::Solver_cost::one_way({1, 2}), 0.5);
  refuse("model 9", {AG::Solver_cost::Model(9), {}, {}}, 0.5);
  refuse("0 parameters", {AG::Solver_cost::HIKING_TIME, {}, {}}, 0.5);
  vectors[16] = std::numeric_limits<double>::quiet_NaN();
  refuse("face 5 has the number", AG::Solver_cost::one_way(vectors), std::nullopt);
  Values tensors(6 * arrays.number_of_faces(), 0);
  tensors[0] = -1;
  refuse("the face with vertices", AG::Solver_cost::tensor_cost(tensors), 0.5);

  Solver_options both = with_cost(AG::Solver_cost::hiking_time(), 0.5);
  const Values weights(arrays.number_of_faces(), 1);
  both.face_weights = weights.data();
  expect_refused("only one of them", [&] { Solver_of(arrays, both); });
}

TEST(Solver, makes_matrices_symmetric)
{
  const Solver_of solver(Soup_arrays(sphere(12, 9)), bound(0.5));
  std::vector<Solver_point> points;
  for(std::int64_t v = 0; v < 90; ++v)
    points.push_back(Solver_point::at_vertex(v));
  const std::size_t size = points.size();
  AG::Solver_row_options options;
  options.targets = &points;
  Values any(size * size), symmetric(size * size);
  solver.compute_matrix(any.data(), points, options);
  options.symmetric = true;
  solver.compute_matrix(symmetric.data(), points, options);
  std::size_t number_of_changes = 0;
  for(std::size_t i = 0; i < size; ++i)
    for(std::size_t j = 0; j < size; ++j)
    {
      EXPECT_EQ(symmetric[i * size + j], (std::min)(any[i * size + j], any[j * size + i]));
      number_of_changes += any[i * size + j] != symmetric[i * size + j] ? 1 : 0;
    }
  EXPECT_GT(number_of_changes, 0u);

  AG::Nearest_rows<double> nearest(3);
  expect_refused("nearest columns", [&] { solver.compute_matrix(nearest, points, options); });
  points.pop_back();
  const std::vector<Solver_point> fewer = points;
  options.targets = &fewer;
  points.push_back(Solver_point::at_vertex(95));
  expect_refused("not the same points",
                 [&] { solver.compute_matrix(symmetric.data(), points, options); });
}

// A barrier and a weight, each where only it makes a difference.
TEST(Solver, is_the_same_after_it_was_saved)
{
  const Soup_arrays arrays(flat_grid(6, 5));
  const Values weights(arrays.number_of_faces(), 2.5);
  const std::vector<std::int64_t> barrier{arrays.corners[0], arrays.corners[1]};
  for(const std::optional<double> epsilon :
      {std::optional<double>(), std::optional(0.), std::optional(0.1)})
    for(const int costs : {0, 1, 2, 3})
    {
      if(epsilon == 0 && costs > 0)
        continue;
      Solver_options options = bound(epsilon);
      if(costs & 1)
        options.face_weights = weights.data();
      if(costs & 2)
      {
        options.barriers = barrier.data();
        options.number_of_barriers = 1;
      }
      const Solver_of solver(arrays, options);
      std::stringstream file;
      solver.save(file);
      const std::string contents = file.str();
      const Solver copy(file);
      EXPECT_EQ(solver_distances(copy), solver_distances(solver));
      EXPECT_EQ(copy.epsilon(), epsilon);
      EXPECT_EQ(copy.has_face_weights(), (costs & 1) != 0);
      EXPECT_EQ(copy.has_barriers(), (costs & 2) != 0);

      std::istringstream shorter(contents.substr(0, contents.size() - 1));
      EXPECT_THROW(Solver{shorter}, std::invalid_argument);
    }
}

TEST(Solver, saves_how_many_points_there_may_be)
{
  Soup needles; // side by side
  for(std::size_t i = 0; i < 42; ++i)
    needles.points.emplace_back(0.05 * double(i), double(i % 2), 0);
  for(std::size_t i = 0; i < 40; ++i)
    needles.triangles.push_back({i, i + 1 + i % 2, i + 2 - i % 2});
  const Soup_arrays arrays(needles);
  std::vector<double> weights;
  for(std::size_t f = 0; f < arrays.number_of_faces(); ++f)
    weights.push_back(double(1 + f % 3));
  Solver_options options = bound(0.1);
  options.face_weights = weights.data();
  options.maximum_number_of_points = 400;
  expect_message<std::length_error>([&] { Solver_of(arrays, options); },
                                    "maximum_number_of_points is 400");
  options.accept_weaker_bound = true;
  const Solver_of weak(arrays, options);
  EXPECT_GT(weak.error_bound(), 0.1);
  std::stringstream file;
  weak.save(file);
  EXPECT_EQ(weak.error_bound(), Solver(file).error_bound());
}

// What the module for WebAssembly does.
TEST(Solver, is_written_and_read_by_functions)
{
  const Solver_of solver(Soup_arrays(sphere(20, 10)), bound(0.1));
  std::stringstream file;
  solver.save(file);
  std::string bytes;
  solver.save([&](const char* const part, const std::size_t size) {
    bytes.append(part, size);
    return true;
  });
  EXPECT_EQ(bytes, file.str());
  for(const std::size_t size : {bytes.size(), bytes.size() - 1})
  {
    std::size_t position = 0;
    const auto get = [&](char* const part, const std::size_t number) {
      if(number > size - position)
        return false;
      bytes.copy(part, number, position);
      position += number;
      return true;
    };
    if(size == bytes.size())
      EXPECT_EQ(solver_distances(Solver(get)), solver_distances(solver));
    else
      EXPECT_THROW(Solver{get}, std::invalid_argument);
  }
  EXPECT_THROW(solver.save([](const char*, std::size_t) { return false; }), std::runtime_error);
}

TEST(Solver, can_be_interrupted_and_used_again)
{
  const Solver_of solver(Soup_arrays(sphere(100, 50)), bound(0.1));
  const Values expected = solver_distances(solver);
  AG::Solver_watch watch;
  int number_of_calls = 0;
  watch.go_further = [&] { return ++number_of_calls < 2; };
  std::vector<Solver_point> all;
  for(std::size_t v = 0; v < solver.number_of_vertices(); ++v)
    all.push_back(Solver_point::at_vertex(static_cast<std::int64_t>(v)));
  AG::Radius_rows<double> rows;
  EXPECT_THROW(solver.compute_matrix(rows, all, radius_options(1, 2), watch),
               AG::Solver_interrupted);
  EXPECT_EQ(number_of_calls, 2);
  EXPECT_EQ(solver_distances(solver), expected);
}

TEST(Solver, can_be_interrupted_amid_a_row)
{
  const Soup_arrays arrays(sphere(60, 30));
  const Values weights(arrays.number_of_faces(), 1);
  Solver_options options = bound(0.02); // so that a row takes long
  options.face_weights = weights.data();
  const Solver_of solver(arrays, options);
  const std::vector<Solver_point> one_row{Solver_point::at_vertex(0)};
  Values row(solver.number_of_vertices());
  EXPECT_THROW(solver.compute_matrix(row.data(), one_row, {}, impatient_watch()),
               AG::Solver_interrupted);
  AG::Nearest_rows<double> nearest(1500);
  EXPECT_THROW(solver.compute_matrix(nearest, one_row, {}, impatient_watch()),
               AG::Solver_interrupted);
}

TEST(Solver, can_be_interrupted_amid_a_path)
{
  const Soup_arrays arrays(sphere(60, 30));
  const Values weights(arrays.number_of_faces(), 1);
  Solver_options options = bound(0.01); // so that it takes long
  options.face_weights = weights.data();
  const Solver_of solver(arrays, options);
  const auto last = static_cast<std::int64_t>(solver.number_of_vertices()) - 1;
  Values points;
  EXPECT_THROW(solver.find_path(Solver_point::at_vertex(0), Solver_point::at_vertex(last), false,
                                points, impatient_watch()),
               AG::Solver_interrupted);
}

TEST(Solver, can_be_interrupted_amid_construction)
{
  const Soup_arrays arrays(sphere(60, 30));
  const auto construct = [&](const Solver_options& options) {
    Solver(arrays.coordinates.data(), arrays.number_of_vertices(), arrays.corners.data(),
           arrays.number_of_faces(), options, impatient_watch());
  };
  for(const std::size_t number_of_threads : {std::size_t(1), std::size_t(2)})
  {
    Solver_options options = bound(0.001);
    options.number_of_threads = number_of_threads;
    EXPECT_THROW(construct(options), AG::Solver_interrupted);
  }
  EXPECT_THROW(construct(with_cost(AG::Solver_cost::hiking_time(), 0.01)), AG::Solver_interrupted);
}

TEST(Solver, tells_that_all_is_done)
{
  const Solver_of solver(Soup_arrays(flat_grid(6, 5)), bound(0.1));
  AG::Solver_watch watch;
  std::size_t done = 0, number = 0;
  watch.on_progress = [&](const std::size_t d, const std::size_t n) {
    done = d;
    number = n;
  };
  Values result(solver.number_of_vertices());
  solver.find_distances({Solver_point::at_vertex(0)}, result.data(), nullptr, nullptr, {1e9},
                        watch);
  EXPECT_EQ(done, solver.number_of_vertices());
  EXPECT_EQ(number, solver.number_of_vertices());
}

// ----- errors

void expect_mesh_refused(const std::string& message, const Soup& soup)
{
  expect_refused(message, [&] { Solver_of{Soup_arrays(soup)}; });
}

TEST(Solver, names_what_is_wrong_with_a_mesh)
{
  const Soup right = flat_grid(3, 3);
  Soup soup = right;
  soup.points[5] = Point(0, std::numeric_limits<double>::infinity(), 0);
  expect_mesh_refused("vertex 5 is not finite", soup);
  soup = right;
  soup.triangles[2][1] = 99;
  expect_mesh_refused("face 2 has vertex 99", soup);
  soup = right;
  soup.triangles[4][0] = soup.triangles[4][2];
  expect_mesh_refused("face 4 has vertex", soup);
  soup = right;
  std::swap(soup.triangles[3][0], soup.triangles[3][1]);
  expect_mesh_refused("in the same direction", soup);
  soup = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
          {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  expect_mesh_refused(
      "the edge between vertices 0 and 1 is not manifold: face 0, face 1 and face 2", soup);
  soup.triangles = {{0, 1, 2}, {0, 3, 4}};
  expect_mesh_refused("vertex 0 is not manifold", soup);
}

// Two closed surfaces that touch in a vertex, where no border tells of it.
TEST(Solver, refuses_a_vertex_of_two_closed_fans)
{
  const Soup tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                         {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  Soup soup = tetrahedron;
  soup.append(tetrahedron);
  EXPECT_NO_THROW(Solver_of{Soup_arrays(soup)});
  for(std::size_t i = 4; i < 8; ++i)
    for(std::size_t& v : soup.triangles[i])
      v = v == 4 ? 0 : v;
  expect_mesh_refused("vertex 0 is not manifold", soup);
}

TEST(Solver, names_what_is_wrong_with_a_question)
{
  const Soup_arrays arrays(flat_grid(3, 3));
  const Solver_of solver(arrays);
  const auto number = static_cast<std::int64_t>(solver.number_of_vertices());
  expect_refused("source 0 is vertex " + std::to_string(number),
                 [&] { solver_distances(solver, {Solver_point::at_vertex(number)}); });
  expect_refused("source 1 is vertex -1", [&] {
    solver_distances(solver, {Solver_point::at_vertex(0), Solver_point::at_vertex(-1)});
  });
  expect_refused("source 0 is face 1000", [&] {
    solver_distances(solver, {Solver_point::in_face(1000, {1, 0, 0})});
  });
  expect_refused("barycentric", [&] {
    solver_distances(solver, {Solver_point::in_face(0, {1, 1, 0})});
  });
  expect_refused("epsilon is -1", [&] { Solver_of(arrays, bound(-1)); });
  const std::vector<std::int64_t> barrier{0, 0};
  Solver_options options;
  options.barriers = barrier.data();
  options.number_of_barriers = 1;
  expect_refused("barrier 0 is not an edge", [&] { Solver_of(arrays, options); });
}

} // namespace
