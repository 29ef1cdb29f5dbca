// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "exact_distances.h"
#include "expect_message.h"
#include "sample_meshes.h"
#include "test_weights.h"

#include <CGAL/Approximate_geodesics/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/convex_hull_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Costs on meshes with weights, next to what they have to be.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

constexpr double all_epsilons[] = {0.5, 0.2, 0.1, 0.02};
constexpr std::size_t nested_numbers[] = {1, 3, 7, 15};
constexpr double rounding = 1e-12;

// ----- closed forms in the plane

struct Layer
{
  double thickness, weight;
};

/*
 * The cost of the cheapest path across layers, and by `shift` along them. It is refracted at their
 * borders: weight times sine is the same in all of them, and not more than the smallest weight. The
 * cost as a function of this constant is concave, and largest for the one of the path. A layer
 * without thickness is a road that the path may use.
 */
double cost_across(const std::vector<Layer>& layers, const double shift)
{
  double low = 0, high = infinity;
  for(const Layer& layer : layers)
    high = (std::min)(high, layer.weight);
  const auto cost = [&](const double p) {
    double result = p * shift;
    for(const Layer& layer : layers)
      result += layer.thickness * std::sqrt((layer.weight - p) * (layer.weight + p));
    return result;
  };
  double best = (std::max)(cost(low), cost(high));
  constexpr double golden = 0.6180339887498949;
  for(std::size_t i = 0; i < 100; ++i)
  {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    best = (std::max)({best, cost(a), cost(b)});
    (cost(a) < cost(b) ? low : high) = cost(a) < cost(b) ? a : b;
  }
  return best;
}

constexpr std::size_t columns = 13, rows = 11;
constexpr double line = 5; // a line of the grid

enum class Grid
{
  REGULAR,
  SHAKEN
};

// A rectangle; vertices at its border and on the lines y = 5 and y = 6 stay there.
Mesh rectangle(const Grid kind, Random& random)
{
  const Soup soup = flat_grid(columns, rows).transformed([&](const Point& p) {
    const bool is_inside = p.x() > 0 && p.x() < columns - 1 && p.y() > 0 && p.y() < rows - 1;
    if(kind == Grid::REGULAR || !is_inside)
      return p;
    const double dx = random.between(-0.3, 0.3), dy = random.between(-0.3, 0.3);
    const bool is_on_line = p.y() == line || p.y() == line + 1;
    return Point(p.x() + dx, is_on_line ? p.y() : p.y() + dy, 0);
  });
  return to_mesh(soup);
}

// Expects the bound of geometric points, and that equally spaced ones are never too short, get
// better when there are more of them, and come close to what is exact.
void expect_truth(const Mesh& mesh,
                  const Weights& weights,
                  const Vertex source,
                  const std::vector<double>& exact)
{
  for(const double e : all_epsilons)
  {
    SCOPED_TRACE("epsilon " + std::to_string(e));
    const auto graph = steiner_graph(mesh, weights, Geometric_points(e));
    EXPECT_EQ(graph.epsilon(), e);
    expect_within_bound(costs(mesh, weights, Geometric_points(e), {source}), exact, e);
  }
  std::vector<double> errors;
  std::vector<double> last(exact.size(), infinity);
  for(const std::size_t m : nested_numbers)
  {
    SCOPED_TRACE(m);
    const std::vector<double> found = costs(mesh, weights, Equally_spaced_points(m), {source});
    expect_within_bound(found, exact, infinity);
    double error = 0;
    for(std::size_t i = 0; i < exact.size(); ++i)
    {
      EXPECT_LE(found[i], last[i] * (1 + rounding));
      error += found[i] - exact[i];
    }
    errors.push_back(error);
    last = found;
  }
  // spaces shrink to an eighth, and errors at least in proportion, but for what is exact anyway
  EXPECT_LE(errors.back(), errors.front() / 4 + 1e-9);
}

// The plane has one weight below a line and another one above. On the expensive side, paths may go
// to the line and along it.
TEST(Weighted_faces, refract_paths_at_a_line)
{
  Random random(test_seed());
  for(const Grid kind : {Grid::REGULAR, Grid::SHAKEN})
    for(const double ratio : {1.1, 2., 10., 1000.})
      for(const bool is_cheap_above : {false, true})
      {
        SCOPED_TRACE(ratio);
        const Mesh mesh = rectangle(kind, random);
        const double below = is_cheap_above ? ratio : 1, above = is_cheap_above ? 1 : ratio;
        const Vertex source(2 + 2 * columns);
        const Point s = mesh.point(source);
        const auto weight = [&](const Point& p) { return p.y() < line ? below : above; };
        std::vector<double> exact;
        for(const Vertex v : mesh.vertices())
        {
          const Point p = mesh.point(v);
          const double shift = std::abs(p.x() - s.x()), depth = line - s.y();
          if(p.y() > line)
            exact.push_back(cost_across({{depth, below}, {p.y() - line, above}}, shift));
          else
            exact.push_back((std::min)(
                below * std::sqrt(CGAL::squared_distance(p, s)),
                cost_across({{depth, below}, {0, above}, {line - p.y(), below}}, shift)));
        }
        expect_truth(mesh, weights_by_place(mesh, weight), source, exact);
      }
}

// A strip between two lines of the grid is cheap, or even free. Beside it, a path may go to it, at
// the critical angle, along it, and away from it again.
TEST(Weighted_faces, make_paths_use_roads)
{
  Random random(test_seed());
  for(const Grid kind : {Grid::REGULAR, Grid::SHAKEN})
    for(const double road : {0.7, 0.1, 1e-3, 0.})
    {
      SCOPED_TRACE(road);
      const Mesh mesh = rectangle(kind, random);
      const Vertex source(1 + 3 * columns);
      const Point s = mesh.point(source);
      const auto is_on_road = [](const Point& p) { return p.y() > line && p.y() < line + 1; };
      const auto weight = [&](const Point& p) { return is_on_road(p) ? road : 1; };
      std::vector<double> exact;
      for(const Vertex v : mesh.vertices())
      {
        const Point p = mesh.point(v);
        const double shift = std::abs(p.x() - s.x()), depth = line - s.y();
        const double beyond = (std::max)(p.y() - line - 1, 0.);
        if(p.y() > line)
          exact.push_back(cost_across({{depth, 1}, {1, road}, {beyond, 1}}, shift));
        else
          exact.push_back(
              (std::min)(std::sqrt(CGAL::squared_distance(p, s)),
                         cost_across({{depth, 1}, {0, road}, {line - p.y(), 1}}, shift)));
      }
      expect_truth(mesh, weights_by_place(mesh, weight), source, exact);
    }
}

TEST(Weighted_faces, refract_paths_in_layers)
{
  Random random(test_seed());
  for(const double range : {2., 30., 1000.})
  {
    SCOPED_TRACE(range);
    const Mesh mesh = to_mesh(flat_grid(columns, rows));
    std::vector<Layer> layers;
    for(std::size_t i = 0; i + 1 < rows; ++i)
      layers.push_back({1, std::pow(range, random.between(0, 1))});
    const Weights weights = weights_by_place(
        mesh, [&](const Point& p) { return layers[static_cast<std::size_t>(p.y())].weight; });
    const Vertex source(2);
    for(const double e : all_epsilons)
    {
      const std::vector<double> found = costs(mesh, weights, Geometric_points(e), {source});
      for(std::size_t i = 0; i < columns; ++i) // those at the far border
      {
        const double exact = cost_across(layers, std::abs(static_cast<double>(i) - 2));
        const double cost = found[i + (rows - 1) * columns];
        EXPECT_GE(cost, exact * (1 - rounding));
        EXPECT_LE(cost, exact * (1 + e));
      }
    }
  }
}

// ----- a convex polygon in the plane

using Point_2 = Kernel::Point_2;

Point_2 in_plane(const Point& p) { return Point_2(p.x(), p.y()); }

double distance(const Point_2& p, const Point_2& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// a hexagon whose edges are edges of the grid
const std::vector<Point_2> hexagon = {Point_2(3, 3), Point_2(5, 3), Point_2(9, 7),
                                      Point_2(9, 8), Point_2(7, 8), Point_2(3, 4)};

// How far `p` is to the left of the edge `i` of the hexagon, times the length of that.
double to_the_left(const std::size_t i, const Point_2& p)
{
  const Point_2 &a = hexagon[i], &b = hexagon[(i + 1) % hexagon.size()];
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool is_inside(const Point_2& p)
{
  for(std::size_t i = 0; i < hexagon.size(); ++i)
    if(to_the_left(i, p) <= 0)
      return false;
  return true;
}

// Whether the straight line comes through the inside: what edges cut off leaves something.
bool is_hidden(const Point_2& s, const Point_2& t)
{
  double first = 0, last = 1;
  for(std::size_t i = 0; i < hexagon.size(); ++i)
  {
    const double a = to_the_left(i, s), b = to_the_left(i, t);
    if(a <= 0 && b <= 0)
      return false;
    if(a < 0)
      first = (std::max)(first, a / (a - b));
    else if(b < 0)
      last = (std::min)(last, a / (a - b));
  }
  return first < last;
}

// A string around the hexagon is as long as one side of the convex hull.
double length_around(const Point_2& s, const Point_2& t)
{
  if(!is_hidden(s, t))
    return distance(s, t);
  std::vector<Point_2> points = hexagon, hull;
  points.push_back(s);
  points.push_back(t);
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  std::rotate(hull.begin(), std::find(hull.begin(), hull.end(), s), hull.end());
  hull.push_back(s);
  for(std::size_t i = 1; i < hull.size(); ++i) // which has no points inside its edges
    if(CGAL::are_strictly_ordered_along_line(hull[i - 1], t, hull[i]))
      hull.insert(hull.begin() + static_cast<std::ptrdiff_t>(i), t);
  double sides[2] = {0, 0};
  bool is_beyond = false;
  for(std::size_t i = 0; i + 1 < hull.size(); ++i)
  {
    is_beyond = is_beyond || hull[i] == t;
    sides[is_beyond] += distance(hull[i], hull[i + 1]);
  }
  return (std::min)(sides[0], sides[1]);
}

double distance_from_hexagon(const Point_2& p)
{
  if(is_inside(p))
    return 0;
  double result = infinity;
  for(std::size_t i = 0; i < hexagon.size(); ++i)
    result = (std::min)(result,
                        std::sqrt(CGAL::squared_distance(
                            p, Kernel::Segment_2(hexagon[i], hexagon[(i + 1) % hexagon.size()]))));
  return result;
}

Weights weights_of_hexagon(const Mesh& mesh, const double inside)
{
  return weights_by_place(mesh,
                          [&](const Point& p) { return is_inside(in_plane(p)) ? inside : 1.; });
}

TEST(Weighted_faces, make_paths_walk_around_forbidden_ones)
{
  const Mesh mesh = to_mesh(flat_grid(columns, rows));
  const Vertex source(1 + 2 * columns);
  const Weights weights = weights_of_hexagon(mesh, infinity);
  std::vector<double> exact;
  bool has_hidden = false;
  for(const Vertex v : mesh.vertices())
  {
    const Point_2 s = in_plane(mesh.point(source)), p = in_plane(mesh.point(v));
    exact.push_back(is_inside(p) ? infinity : length_around(s, p));
    has_hidden = has_hidden || exact.back() > distance(s, p) * 1.05;
  }
  ASSERT_TRUE(has_hidden);
  for(const double e : all_epsilons)
    expect_within_bound(costs(mesh, weights, Geometric_points(e), {source}), exact, e);
  for(const std::size_t m : nested_numbers)
    expect_within_bound(costs(mesh, weights, Equally_spaced_points(m), {source}), exact, infinity);

  // with expensive ground in place of it, nothing changes but that its inside can be reached
  const Weights expensive = weights_of_hexagon(mesh, 1e6);
  for(const double e : all_epsilons)
  {
    std::vector<double> found = costs(mesh, expensive, Geometric_points(e), {source});
    for(const Vertex v : mesh.vertices())
      if(is_inside(in_plane(mesh.point(v))))
      {
        EXPECT_GT(found[v.idx()], 1e5);
        EXPECT_LT(found[v.idx()], infinity);
        found[v.idx()] = infinity;
      }
    expect_within_bound(found, exact, e);
  }
}

TEST(Weighted_faces, are_passed_at_no_cost_if_they_are_free)
{
  const Mesh mesh = to_mesh(flat_grid(columns, rows));
  const Weights weights = weights_of_hexagon(mesh, 0);
  for(const Vertex source : {Vertex(1 + 2 * columns), Vertex(5 + 4 * columns)})
  {
    const Point_2 s = in_plane(mesh.point(source));
    std::vector<double> exact;
    for(const Vertex v : mesh.vertices())
    {
      const Point_2 p = in_plane(mesh.point(v));
      exact.push_back(
          (std::min)(distance(s, p), distance_from_hexagon(s) + distance_from_hexagon(p)));
    }
    expect_truth(mesh, weights, source, exact);
  }
}

// ----- references without a closed form

// Many points on every edge find no path that is cheaper than the bound allows, and any path of
// theirs is one on the surface.
TEST(Weighted_faces, are_crossed_about_as_cheaply_as_with_many_points)
{
  Random random(test_seed());
  const auto shake = [&](const Point& p) {
    return Point(p.x() + random.between(-0.3, 0.3), p.y() + random.between(-0.3, 0.3),
                 random.between(0, 1));
  };
  for(const double range : {1.5, 20., 1000.})
    for(const double extreme : {0., 0.1})
      for(const Soup& soup : {flat_grid(6, 5).transformed(shake), sphere(6, 4), fan(9, 1)})
      {
        SCOPED_TRACE(range);
        const Mesh mesh = to_mesh(soup);
        const Weights weights = random_weights(mesh, random, 1, range, extreme);
        const Vertex source = random_vertex(mesh, random);
        const std::vector<double> dense = costs(mesh, weights, Equally_spaced_points(64), {source});
        for(const double e : all_epsilons)
        {
          const auto graph = steiner_graph(mesh, weights, Geometric_points(e));
          const std::vector<double> found = costs(mesh, weights, Geometric_points(e), {source});
          ASSERT_EQ(graph.epsilon(), e);
          for(std::size_t i = 0; i < dense.size(); ++i)
          {
            EXPECT_LE(found[i], dense[i] * (1 + e) * (1 + rounding));
            // a path that crosses all edges a 130th of their length from the best place
            EXPECT_LE(dense[i], found[i] * 1.1 + rounding);
          }
        }
      }
}

// Where the bound is infinite, because of thin faces, costs are still those of paths.
void expect_bound_on(const Mesh& mesh, const Vertex source)
{
  const std::vector<double> exact = exact_distances(mesh, source);
  for(const double e : {0.5, 0.1, 0.01})
  {
    Basic_mesh_search<Steiner_graph<>> search(mesh, parameters::epsilon(e));
    const double bound = search.graph().epsilon();
    EXPECT_TRUE(bound == e || bound == infinity);
    expect_within_bound(search.distances({source}), exact, bound);
  }
}

TEST(Faces_of_equal_weight, have_the_bound_on_generated_meshes)
{
  Random random(test_seed());
  for(const Soup& soup : {flat_grid(12, 9), terrain(16, 12, random), sphere(20, 9), fan(40, 3),
                          fan(9), growing_strip(30, 1e-3, 1e3)})
  {
    const Mesh mesh = to_mesh(soup);
    expect_bound_on(mesh, random_vertex(mesh, random));
  }
}

TEST(Faces_of_equal_weight, have_the_bound_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  for(const std::string name : {"cube.off", "mesh_with_border.off", "eight.off", "oblong.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    ASSERT_GT(mesh.num_vertices(), 0u);
    expect_bound_on(mesh, Vertex(mesh.number_of_vertices() / 3));
  }
}

// ----- exchanged weights

TEST(Exchanged_weights, give_the_same_as_a_graph_built_with_them)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    const Mesh& mesh = named.mesh;
    const Vertex source = random_vertex(mesh, random);
    const Weights first = random_weights(mesh, random, 0.1, 10, 0.05);
    const Weights second = random_weights(mesh, random, 1e-3, 1e5, 0.05);
    auto graph = steiner_graph(mesh, first, Equally_spaced_points(2));
    graph.set_face_weights(mesh, weight_map(second));
    Basic_mesh_search<Steiner_graph<Equally_spaced_points>> exchanged(mesh, std::move(graph));
    EXPECT_TRUE(have_same_bits(exchanged.distances({source}),
                               costs(mesh, second, Equally_spaced_points(2), {source})));

    AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Equally_spaced_points>> paths(
        mesh, steiner_graph(mesh, first, Equally_spaced_points(2)));
    paths.add_source_point(source);
    const Vertex target = random_vertex(mesh, random);
    const auto expect = [&](const Weights& weights) {
      const double expected = costs(mesh, weights, Equally_spaced_points(2), {source})[target];
      const double found = paths.shortest_distance_to_source_points(target).first;
      EXPECT_EQ(found, expected == infinity ? -1 : expected);
    };
    expect(first);
    paths.set_face_weights(weight_map(second));
    expect(second);
  }
}

TEST(Exchanged_weights, have_a_worse_bound_if_they_are_more_different)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(8, 7));
  const Weights mild = random_weights(mesh, random, 1, 2);
  const Weights strong = random_weights(mesh, random, 1, 100);
  const Weights scaled = [&] {
    Weights result = mild;
    for(double& w : result)
      w *= 1024;
    return result;
  }();
  auto graph = steiner_graph(mesh, mild, Geometric_points(0.1));
  EXPECT_EQ(graph.epsilon(), 0.1);
  graph.set_face_weights(mesh, weight_map(scaled));
  EXPECT_EQ(graph.epsilon(), 0.1);
  graph.set_face_weights(mesh, weight_map(strong));
  EXPECT_GT(graph.epsilon(), 0.1);
  EXPECT_LT(graph.epsilon(), infinity);
  const double bound = graph.epsilon();
  Basic_mesh_search<Steiner_graph<>> search(mesh, std::move(graph));
  const std::vector<double> found = search.distances({Vertex(3)});
  const std::vector<double> close = costs(mesh, strong, Geometric_points(0.01), {Vertex(3)});
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_LE(found[i], close[i] * (1 + bound));
}

TEST(Exchanged_weights, are_refused_for_another_mesh)
{
  const Mesh mesh = to_mesh(flat_grid(5, 4)), other = to_mesh(flat_grid(5, 5));
  auto graph = steiner_graph(mesh, Weights(mesh.num_faces(), 1), Equally_spaced_points(1));
  const Weights weights(other.num_faces(), 1);
  expect_message<std::invalid_argument>([&] { graph.set_face_weights(other, weight_map(weights)); },
                                        "mesh");
  const Mesh smaller = to_mesh(flat_grid(4, 4));
  expect_message<std::invalid_argument>(
      [&] { graph.set_face_weights(smaller, weight_map(weights)); }, "mesh");
}

// Weights that are refused for what costs would be do not take the place of those before.
TEST(Exchanged_weights, are_not_exchanged_if_costs_do_not_fit_a_double)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4).transformed(
      [](const Point& p) { return Point(p.x() * 1e200, p.y() * 1e200, 0); }));
  const Weights ones(mesh.num_faces(), 1), large(mesh.num_faces(), 1e200);
  auto graph = steiner_graph(mesh, ones, Equally_spaced_points(1));
  const double unit = graph.unit();
  expect_message<std::invalid_argument>([&] { graph.set_face_weights(mesh, weight_map(large)); },
                                        "weights", "lengths");
  EXPECT_EQ(graph.unit(), unit);

  AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Equally_spaced_points>> paths(mesh, graph);
  paths.add_source_point(Vertex(0));
  const double distance = paths.shortest_distance_to_source_points(Vertex(15)).first;
  expect_message<std::invalid_argument>([&] { paths.set_face_weights(weight_map(large)); },
                                        "weights");
  EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(15)).first, distance);
  EXPECT_NEAR(distance, std::sqrt(18.) * 1e200, 1e187);
}

// ... nor is anything left of them if all faces become forbidden.
TEST(Exchanged_weights, may_forbid_everything)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  auto graph = steiner_graph(mesh, Weights(mesh.num_faces(), 1), Equally_spaced_points(1));
  graph.set_face_weights(mesh, weight_map(Weights(mesh.num_faces(), infinity)));
  EXPECT_EQ(graph.arc_lengths().longest, 0);
}

// ----- weights that are wrong or extreme

TEST(Bad_weights, are_refused_by_name_of_the_face)
{
  const Mesh mesh = to_mesh(flat_grid(6, 5));
  const Face bad(17);
  std::vector<std::string> names;
  for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(bad)))
    names.push_back(std::to_string(v.idx()));
  const auto expect_refusal = [&](const auto& f) {
    expect_message<std::invalid_argument>(f, names[0], names[1], names[2], "weight");
  };
  for(const double w : {-1., -1e-300, -infinity, std::numeric_limits<double>::quiet_NaN()})
  {
    const Weights good(mesh.num_faces(), 2);
    Weights weights = good;
    weights[bad.idx()] = w;
    std::vector<double> distances(mesh.num_vertices(), 7);
    const auto map = boost::make_iterator_property_map(distances.begin(), //
                                                       get(boost::vertex_index, mesh));
    expect_refusal(
        [&] { CGAL::approximate_geodesic_distances(mesh, map, Vertex(0), with_weights(weights)); });
    EXPECT_EQ(distances, std::vector<double>(mesh.num_vertices(), 7));
    expect_refusal([&] {
      std::vector<Point> points;
      CGAL::approximate_geodesic_path(mesh, Vertex(0), Vertex(1), std::back_inserter(points),
                                      with_weights(weights));
    });
    using Paths = AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<>>;
    expect_refusal([&] { Paths paths(mesh, with_weights(weights)); });
    Paths paths(mesh, with_weights(good));
    paths.add_source_point(Vertex(0));
    const double before = paths.shortest_distance_to_source_points(Vertex(29)).first;
    expect_refusal([&] { paths.set_face_weights(weight_map(weights)); });
    paths.build_sequence_tree(parameters::default_values());
    EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(29)).first, before);
    EXPECT_GT(before, 0);
  }
}

TEST(Weighted_faces, may_have_weights_of_all_magnitudes)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(14, 12, random));
  const double values[] = {0, 1e-12, 1, 1e12, infinity};
  Weights weights(mesh.num_faces());
  for(double& w : weights)
    w = values[random.below(5)];
  for(const Vertex source : {Vertex(0), Vertex(40), Vertex(100)})
  {
    const std::vector<double> coarse = costs(mesh, weights, Equally_spaced_points(1), {source});
    const std::vector<double> fine = costs(mesh, weights, Equally_spaced_points(3), {source});
    const std::vector<double> bound = costs(mesh, weights, Geometric_points(0.1), {source});
    EXPECT_EQ(fine[source], 0);
    for(std::size_t i = 0; i < fine.size(); ++i)
    {
      EXPECT_GE(fine[i], 0);
      EXPECT_LE(fine[i], coarse[i] * (1 + rounding));
      EXPECT_LE(bound[i], coarse[i] * 1.1);
      EXPECT_EQ(std::isinf(bound[i]), std::isinf(coarse[i]));
    }
  }
}

TEST(Weighted_faces, have_their_inside_unreachable_if_forbidden_ones_surround_it)
{
  const Mesh mesh = to_mesh(flat_grid(9, 9));
  const auto is_in_ring = [](const Point& p) {
    const double r = (std::max)(std::abs(p.x() - 4), std::abs(p.y() - 4));
    return r > 1 && r < 2;
  };
  const Weights weights =
      weights_by_place(mesh, [&](const Point& p) { return is_in_ring(p) ? infinity : 1; });
  const Vertex outside(0), inside(4 + 4 * 9);
  for(const std::size_t m : {0u, 1u, 5u})
  {
    const std::vector<double> found = costs(mesh, weights, Equally_spaced_points(m), {outside});
    for(const Vertex v : mesh.vertices())
    {
      const Point& p = mesh.point(v);
      const bool is_enclosed = std::abs(p.x() - 4) <= 1 && std::abs(p.y() - 4) <= 1;
      EXPECT_EQ(found[v] == infinity, is_enclosed);
    }
    AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Equally_spaced_points>> paths(
        mesh, steiner_graph(mesh, weights, Equally_spaced_points(m)));
    paths.add_source_point(outside);
    EXPECT_LT(paths.shortest_distance_to_source_points(inside).first, 0);
    std::vector<Point> points;
    paths.shortest_path_points_to_source_points(inside, std::back_inserter(points));
    EXPECT_TRUE(points.empty());
    EXPECT_EQ(CGAL::approximate_geodesic_path(mesh, outside, inside, std::back_inserter(points),
                                              with_weights(weights).epsilon(0.2)),
              infinity);
    EXPECT_TRUE(points.empty());
  }
}

template <typename Graph>
void expect_refusal(const std::string& name)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const Weights weights(mesh.num_faces(), 1);
  const Barriers barriers(mesh.num_edges(), true);
  expect_message<std::invalid_argument>([&] { Graph(Triangulation(mesh, with_weights(weights))); },
                                        name, "weights", "Steiner_graph");
  expect_message<std::invalid_argument>(
      [&] { Graph(Triangulation(mesh, with_barriers(barriers))); }, name, "barriers",
      "Steiner_graph");
}

TEST(Weighted_faces, are_refused_by_graphs_that_do_not_heed_them)
{
  expect_refusal<AG::Edge_graph>("Edge_graph");
  expect_refusal<AG::Discrete_geodesic_graph>("Discrete_geodesic_graph");
  expect_refusal<AG::Lazy_discrete_geodesic_graph>("Lazy_discrete_geodesic_graph");
}

std::vector<double> costs_on_square(const double length, const double weight)
{
  const auto stretch = [&](const Point& p) { return Point(p.x() * length, p.y() * length, 0); };
  const Mesh mesh = to_mesh(flat_grid(4, 4).transformed(stretch));
  return costs(mesh, Weights(mesh.num_faces(), weight), Equally_spaced_points(1), {Vertex(0)});
}

void expect_in_proportion_to(const double weight)
{
  SCOPED_TRACE(weight);
  std::vector<double> found = costs_on_square(1, weight);
  for(double& d : found)
    d /= weight;
  expect_about_the_same(found, costs_on_square(1, 1), rounding);
}

TEST(Weighted_faces, may_cost_very_much)
{
  for(const double weight : {1e12, 1e200, 1e300})
    expect_in_proportion_to(weight);
}

TEST(Weighted_faces, may_cost_very_little)
{
  for(const double weight : {1e-12, 1e-200, 1e-300})
    expect_in_proportion_to(weight);
}

TEST(Weighted_faces, are_refused_if_costs_do_not_fit_a_double)
{
  expect_message<std::invalid_argument>([] { costs_on_square(1e150, 1e300); }, "weights",
                                        "lengths");
}

} // namespace
