// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "meshes/test_costs.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/Geodesic_queries/distance_intervals.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

// What functions and the class do with costs that depend on the direction.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

using Distance_map = Mesh::Property_map<Vertex, double>;
using Location = AG::Face_location<Mesh>;
using Paths = AG::Surface_mesh_shortest_path<Mesh, Directional_graph<>>;

// A plane where all faces have the same gauge, and what ways across it cost.
class Directional_queries : public testing::Test
{
protected:
  Directional_queries()
    : mesh(to_mesh(flat_grid(6, 5))),
      slant{2, Vector(0.6, -0.2, 0)},
      from(mesh.add_property_map<Vertex, double>("v:from").first),
      to(mesh.add_property_map<Vertex, double>("v:to").first)
  {
  }

  auto parameters() const { return with_cost(cost_everywhere(slant)).epsilon(epsilon); }

  double cost(const Point& p, const Point& q) const { return slant.cost(q - p); }
  double cost(const Vertex v, const Vertex w) const { return cost(mesh.point(v), mesh.point(w)); }

  double cost(const std::vector<Point>& path) const
  {
    double result = 0;
    for(std::size_t i = 1; i < path.size(); ++i)
      result += cost(path[i - 1], path[i]);
    return result;
  }

  Point point(const Location& location) const
  {
    std::vector<Point> p;
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(location.first)))
      p.push_back(mesh.point(v)); // the first one is the target of the halfedge
    const auto& w = location.second;
    return CGAL::barycenter(p[2], w[0], p[0], w[1], p[1], w[2]);
  }

  static void expect_within(const double found, const double cheapest)
  {
    EXPECT_GE(found, (1 - 1e-9) * cheapest);
    EXPECT_LE(found, (1 + 1e-9) * (1 + epsilon) * cheapest);
  }

  static constexpr double epsilon = 0.1;
  Mesh mesh;
  Slant slant;
  Distance_map from, to;
};

TEST_F(Directional_queries, find_distances_from_and_to)
{
  const Vertex source(8);
  CGAL::approximate_geodesic_distances(mesh, from, source, parameters());
  CGAL::approximate_geodesic_distances(mesh, to, source, parameters().direction_to_source(true));
  for(const Vertex v : mesh.vertices())
  {
    expect_within(from[v], cost(source, v));
    expect_within(to[v], cost(v, source));
  }
}

TEST_F(Directional_queries, may_have_several_sources_and_initial_distances)
{
  const std::vector<Vertex> sources = {Vertex(0), Vertex(29)};
  const std::vector<double> initial = {0, 0.5};
  const auto nearest = mesh.add_property_map<Vertex, int>("v:nearest").first;
  CGAL::approximate_geodesic_distances(
      mesh, to, sources,
      parameters().direction_to_source(true).initial_distances(initial).nearest_source_map(
          nearest));
  for(const Vertex v : mesh.vertices())
  {
    const double first = cost(v, sources[0]), second = cost(v, sources[1]) + initial[1];
    expect_within(to[v], (std::min)(first, second));
    if(first > (1 + epsilon) * second || second > (1 + epsilon) * first)
    {
      EXPECT_EQ(first < second ? 0 : 1, nearest[v]);
    }
  }
}

TEST_F(Directional_queries, stop_at_a_distance_and_at_targets)
{
  const Vertex source(8), target(9);
  CGAL::approximate_geodesic_distances(mesh, to, source, parameters().direction_to_source(true));
  const double limit = to[Vertex(20)];
  CGAL::approximate_geodesic_distances(
      mesh, from, source, parameters().direction_to_source(true).maximum_distance(limit));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(to[v] <= limit ? to[v] : infinity, from[v]);
  CGAL::approximate_geodesic_distances(
      mesh, from, source,
      parameters().direction_to_source(true).targets(std::vector<Vertex>{target}));
  EXPECT_EQ(to[target], from[target]);
}

TEST_F(Directional_queries, have_paths_from_source_to_target)
{
  const Vertex a(1), b(22);
  for(const auto& [source, target] : {std::make_pair(a, b), std::make_pair(b, a)})
  {
    std::vector<Point> path;
    const double length = CGAL::approximate_geodesic_path(mesh, std::back_inserter(path), source,
                                                          target, parameters());
    ASSERT_GE(path.size(), 2u);
    EXPECT_EQ(mesh.point(source), path.front());
    EXPECT_EQ(mesh.point(target), path.back());
    expect_within(length, cost(source, target));
    EXPECT_LE(cost(path), (1 + 1e-9) * length); // costs were asked for in some directions
    EXPECT_GE(cost(path), length / 1.01);
  }
}

TEST_F(Directional_queries, may_be_of_points_in_faces)
{
  const Location a(Face(3), {0.2, 0.3, 0.5}), b(Face(30), {0.6, 0.1, 0.3}),
      c(Face(3), {0.5, 0.4, 0.1}), d(Face(3), {0.5, 0.5, 0});
  Paths paths(mesh, parameters());
  Paths back(mesh, parameters().direction_to_source(true));
  for(const auto& [source, target] :
      {std::make_pair(a, b), std::make_pair(b, a), std::make_pair(a, c), std::make_pair(c, a),
       std::make_pair(a, d), std::make_pair(d, b)})
  {
    const double straight = cost(point(source), point(target));
    for(Paths* p : {&paths, &back}) // pairs go from source to target, in both
      expect_within(p->shortest_distance(source, target), straight);
    paths.remove_all_source_points();
    paths.add_source_point(source);
    const auto there = paths.shortest_distance_to_source_points(target.first, target.second).first;
    expect_within(there, straight);
    back.remove_all_source_points();
    back.add_source_point(target);
    EXPECT_NEAR(there, back.shortest_distance_to_source_points(source.first, source.second).first,
                1e-9 * there);
  }
}

TEST_F(Directional_queries, find_paths_in_both_directions_by_the_class)
{
  const Vertex a(1), b(22);
  Paths paths(mesh, parameters());
  paths.add_source_point(a);
  Paths back(mesh, paths.graph().reversed());
  back.add_source_point(a);

  std::vector<Point> points;
  const double from_source =
      paths.shortest_path_points_to_source_points(b, std::back_inserter(points)).first;
  EXPECT_EQ(mesh.point(b), points.front()); // against the direction of travel
  std::reverse(points.begin(), points.end());
  EXPECT_NEAR(from_source, cost(points), 0.011 * from_source);

  points.clear();
  const double to_source =
      back.shortest_path_points_to_source_points(b, std::back_inserter(points)).first;
  EXPECT_EQ(mesh.point(b), points.front());
  EXPECT_NEAR(to_source, cost(points), 0.011 * to_source);
  EXPECT_GT(std::abs(to_source - from_source), 0.1 * from_source);

  for(Paths* p : {&paths, &back})
  {
    points.clear();
    const double length = p->shortest_path_points(b, a, std::back_inserter(points));
    EXPECT_EQ(mesh.point(b), points.front());
    EXPECT_EQ(mesh.point(a), points.back());
    EXPECT_NEAR(to_source, length, 1e-9 * length);
  }
}

TEST_F(Directional_queries, fill_matrices)
{
  const std::vector<Vertex> sources = {Vertex(0), Vertex(8), Vertex(29)};
  AG::Dense_rows<double> there, back;
  CGAL::approximate_geodesic_distance_matrix(mesh, there, sources, parameters().targets(sources));
  CGAL::approximate_geodesic_distance_matrix(
      mesh, back, sources, parameters().targets(sources).direction_to_source(true));
  for(std::size_t i = 0; i < sources.size(); ++i)
    for(std::size_t j = 0; j < sources.size(); ++j)
    {
      expect_within(there(i, j), cost(sources[i], sources[j]));
      EXPECT_NEAR(there(i, j), back(j, i), 1e-9 * there(i, j));
    }
  expect_message<std::invalid_argument>(
      [&] {
        CGAL::approximate_geodesic_distance_matrix(mesh, there, sources,
                                                   parameters().targets(sources).symmetric(true));
      },
      "costs depend on the direction");
}

TEST_F(Directional_queries, fill_matrices_of_points_in_faces)
{
  const std::vector<Location> points = {{Face(3), {0.2, 0.3, 0.5}}, {Face(30), {0.6, 0.1, 0.3}}};
  AG::Dense_rows<double> rows;
  CGAL::approximate_geodesic_distance_matrix(mesh, rows, points, parameters().targets(points));
  expect_within(rows(0, 1), cost(point(points[0]), point(points[1])));
  expect_within(rows(1, 0), cost(point(points[1]), point(points[0])));
}

TEST_F(Directional_queries, do_not_cross_barriers)
{
  const auto is_barrier = mesh.add_property_map<Edge, bool>("e:barrier", false).first;
  for(Mesh::size_type row = 0; row < 4; ++row) // all but the last row of squares
  {
    const Halfedge h = mesh.halfedge(Vertex(6 * row + 3), Vertex(6 * (row + 1) + 3));
    ASSERT_TRUE(mesh.is_valid(h));
    is_barrier[mesh.edge(h)] = row < 3;
  }
  const Vertex source(2), target(4), gap(3 * 6 + 3);
  CGAL::approximate_geodesic_distances(mesh, from, source,
                                       parameters().edge_is_constrained_map(is_barrier));
  expect_within(from[target], cost(source, gap) + cost(gap, target));
}

// ----- what is refused

TEST_F(Directional_queries, refuse_negative_costs)
{
  for(const double bad : {-1., not_a_number, -infinity})
  {
    const auto cost = [bad](const Face f, const Vector& d) {
      return f == Face(7) && d.x() > 0.9 ? bad : 1;
    };
    expect_message<std::invalid_argument>(
        [&] { CGAL::approximate_geodesic_distances(mesh, from, Vertex(0), with_cost(cost)); },
        "the face with vertices", "in the direction", "must be a number that is not negative");
  }
}

TEST_F(Directional_queries, refuse_bounds_that_cannot_be_kept)
{
  const AG::One_way one_way(boost::static_property_map<Vector, Face>(Vector(1, 0, 0)));
  expect_message<std::invalid_argument>([&] { bounded_graph(mesh, one_way, 0.1); },
                                        "free or forbidden");
  const auto half_free = [](const Face, const Vector& d) { return (std::max)(0., d.x()); };
  expect_message<std::invalid_argument>([&] { bounded_graph(mesh, half_free, 0.1); },
                                        "free or forbidden");
  const auto extreme = [](const Face, const Vector& d) { return std::hypot(1e9 * d.x(), d.y()); };
  expect_message<std::invalid_argument>([&] { bounded_graph(mesh, extreme, 0.1); },
                                        "cannot be kept");
  const Triangulation coarse(mesh, with_cost(cost_everywhere(slant)));
  expect_message<std::invalid_argument>(
      [&] { Directional_graph<>(coarse, CGAL::parameters::epsilon(0.005)); }, "too few directions");

  const auto parameters = CGAL::parameters::epsilon(0.1).accept_weaker_bound(true);
  const Directional_graph<> accepted(Triangulation(mesh, with_cost(one_way)), parameters);
  EXPECT_EQ(infinity, accepted.epsilon());
  const Triangulation triangulation(mesh, with_cost(cost_everywhere(slant)));
  expect_message<std::invalid_argument>(
      [&] {
        Directional_graph<>(triangulation,
                            CGAL::parameters::epsilon(0.1).maximum_number_of_points_per_edge(1));
      },
      "needs more points on an edge than 1,");
  const Directional_graph<> few(triangulation, parameters.maximum_number_of_points_per_edge(1));
  EXPECT_EQ(infinity, few.epsilon());
  EXPECT_GT(few.number_of_points(), 0);
  EXPECT_LE(few.number_of_points(), mesh.number_of_edges());
}

// Along a corner's way, the cost matters in both directions.
TEST_F(Directional_queries, know_costs_to_corners)
{
  const Slant steep{2, Vector(0.9, 0.3, 0)};
  const auto np = with_cost(cost_everywhere(steep)).epsilon(0.5);
  const Triangulation triangulation(mesh, np);
  const Directional_graph<> graph(triangulation, np);
  Random random(test_seed());
  for(int i = 0; i < 50; ++i)
  {
    const double t = random.between(0, 1), s = random.between(0, 1 - t);
    const auto h = static_cast<Triangulation::Index>(random.below(mesh.number_of_halfedges()));
    if(triangulation.is_border(h))
      continue;
    const auto corner = [&](const Triangulation::Index g) {
      return mesh.point(Vertex(triangulation.index(triangulation.target(g))));
    };
    const std::array<Point, 3> p = {corner(triangulation.next(triangulation.next(h))), corner(h),
                                    corner(triangulation.next(h))};
    const Point q = CGAL::barycenter(p[0], 1 - t - s, p[1], t, p[2], s);
    double expected = infinity;
    for(const Point& c : p)
      expected = (std::min)(expected, (std::max)(steep.cost(c - q), steep.cost(q - c)));
    const double found = graph.unit() * graph.cost_to_corner(AG::Intrinsic_point::in_face(h, t, s));
    EXPECT_GE(found, (1 - 1e-9) * expected);
    EXPECT_LE(found, (1 + graph.sampling_error()) * (1 + 1e-9) * expected);
  }
}

// Going up costs little here, and to all corners much; so a source below the edge between two flat
// triangles is much nearer to the top than to points on that edge.
TEST_F(Directional_queries, find_intervals_that_contain_the_costs)
{
  const double height = 0.4, epsilon_here = 0.5;
  Mesh kite;
  const Vertex left = kite.add_vertex(Point(0, 0, 0)), right = kite.add_vertex(Point(1, 0, 0)),
               top = kite.add_vertex(Point(0.5, height, 0)),
               bottom = kite.add_vertex(Point(0.5, -1, 0));
  kite.add_face(left, right, top);
  const Face lower_face = kite.add_face(right, left, bottom);
  const auto intervals = kite.add_property_map<Vertex, std::pair<double, double>>("v:i").first;

  std::size_t number_above_epsilon = 0;
  for(const double sign : {-1., 1.})
  {
    const Slant steep{1, Vector(0, sign * 0.95, 0)};
    const auto np = with_cost(cost_everywhere(steep)).epsilon(epsilon_here);
    Random random(test_seed());
    for(int i = 0; i < 100; ++i)
    {
      const double y = random.between(0.001, 0.05), x = random.between(y, 1 - y);
      const Point p(x, -y, 0);
      const double at_left = 1 - x - y / 2, at_right = x - y / 2;
      const Halfedge h = kite.halfedge(lower_face);
      std::array<double, 3> at{};
      const std::array<Vertex, 3> corners = {kite.source(h), kite.target(h),
                                             kite.target(kite.next(h))};
      for(std::size_t k = 0; k < 3; ++k)
        at[k] = corners[k] == left ? at_left : corners[k] == right ? at_right : y;
      AG::distance_intervals(kite, intervals, Location(lower_face, at),
                             np.direction_to_source(sign > 0));
      for(const Vertex v : kite.vertices())
      {
        const double cost = steep.cost(-sign * (kite.point(v) - p));
        EXPECT_LE(intervals[v].first, cost * (1 + 1e-9));
        EXPECT_GE(intervals[v].second, cost * (1 - 1e-9));
        if(intervals[v].second > (1 + epsilon_here) * cost)
          ++number_above_epsilon;
      }
    }
  }
  EXPECT_GT(number_above_epsilon, 0); // so that points in faces do matter
}

TEST_F(Directional_queries, refuse_graphs_without_directions)
{
  const Triangulation triangulation(mesh, parameters());
  expect_message<std::invalid_argument>([&] { Graph graph(triangulation); },
                                        "use Directional_graph");
  expect_message<std::invalid_argument>([&] { Steiner_graph<> graph(triangulation); },
                                        "use Directional_graph");
  expect_message<std::invalid_argument>([&] { Directional_graph<> graph{Triangulation(mesh)}; },
                                        "has no costs");
}

// Costs and lengths of any size, in units that products of them do not overflow in.
TEST_F(Directional_queries, may_have_large_and_small_costs)
{
  CGAL::approximate_geodesic_distances(mesh, from, Vertex(8), parameters());
  for(const double factor : {0x1p-900, 0x1p-20, 0x1p900})
  {
    const auto cost = cost_everywhere(Slant{factor * slant.factor, slant.slant});
    CGAL::approximate_geodesic_distances(mesh, to, Vertex(8), with_cost(cost).epsilon(epsilon));
    for(const Vertex v : mesh.vertices())
      EXPECT_EQ(factor * from[v], to[v]);
  }
  const auto too_large = cost_everywhere(Slant{1e308, slant.slant});
  expect_message<std::invalid_argument>(
      [&] { CGAL::approximate_geodesic_distances(mesh, to, Vertex(8), with_cost(too_large)); },
      "exceed the largest double");
}

TEST_F(Directional_queries, let_hikers_go_up_and_down)
{
  const Mesh slope = to_mesh(flat_grid(5, 9).transformed(
      [](const Point& p) { return Point(100 * p.x(), 100 * p.y(), 20 * p.y()); }));
  const auto np = CGAL::parameters::face_weight_map(directional_cost(AG::Hiking_time()))
                      .number_of_points_per_edge(5);
  std::vector<Point> path;
  const Vertex low(0), high(40);
  const double up = CGAL::approximate_geodesic_path(slope, std::back_inserter(path), low, high, np);
  const double down =
      CGAL::approximate_geodesic_path(slope, std::back_inserter(path), high, low, np);
  EXPECT_GT(up, 1.3 * down);
  EXPECT_LT(up, 1.5 * down); // exp(0.35) times
}

} // namespace
