// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "expect_message.h"
#include "test_mesh_type.h"
#include "test_oracles.h"

#include <CGAL/Approximate_geodesics/Binary_heap_queue.h>
#include <CGAL/Approximate_geodesics/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Steiner_graph.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/farthest_point_sampling.h>
#include <CGAL/geodesic_gradient.h>
#include <CGAL/geodesic_isolines.h>
#include <CGAL/geodesic_voronoi_partition.h>
#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

// What is made of the distances at the vertices.

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;
using Vector = Kernel::Vector_3;
using Polyline = std::vector<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_mesh = CGAL::Surface_mesh<Exact_kernel::Point_3>;

// A function of the vertices as a property map.
template <typename F>
auto at_vertices(F f)
{
  return boost::make_function_property_map<Vertex, double>(f);
}

// A function of the points of `mesh`, which is referred to.
template <typename F>
auto at_points(const Mesh& mesh, F f)
{
  return at_vertices([&mesh, f](const Vertex v) { return double(f(mesh.point(v))); });
}

auto from_vector(const std::vector<double>& values)
{
  return at_vertices([&values](const Vertex v) { return values[v.idx()]; });
}

std::array<Vertex, 3> corners(const Mesh& mesh, const Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

double length(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// ----- isolines

template <typename Map>
std::vector<Polyline> isolines(const Mesh& mesh, const Map& map, const std::vector<double>& values)
{
  std::vector<Polyline> result;
  CGAL::geodesic_isolines(mesh, map, values, std::back_inserter(result));
  return result;
}

bool is_closed(const Polyline& polyline) { return polyline.front() == polyline.back(); }

double length(const std::vector<Polyline>& polylines)
{
  double result = 0;
  for(const Polyline& polyline : polylines)
    for(std::size_t i = 1; i < polyline.size(); ++i)
      result += length(polyline[i - 1], polyline[i]);
  return result;
}

testing::AssertionResult are_clean(const std::vector<Polyline>& polylines)
{
  for(const Polyline& polyline : polylines)
    if(polyline.size() < 2 ||
       std::adjacent_find(polyline.begin(), polyline.end()) != polyline.end())
      return testing::AssertionFailure() << "a polyline has repeated points, or just one";
  return testing::AssertionSuccess();
}

// The lengths of the isoline in all faces, added up face by face.
double length_in_faces(const Mesh& mesh, const std::vector<double>& values, const double isovalue)
{
  double result = 0;
  for(const Face f : mesh.faces())
  {
    Polyline ends;
    const std::array<Vertex, 3> v = corners(mesh, f);
    bool is_reached = true;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Vertex a = v[i], b = v[(i + 1) % 3];
      const double x = values[a.idx()], y = values[b.idx()];
      is_reached = is_reached && std::isfinite(x);
      if((x >= isovalue) != (y >= isovalue))
        ends.push_back(CGAL::barycenter(mesh.point(b), (isovalue - x) / (y - x), mesh.point(a)));
    }
    if(is_reached && !ends.empty())
      result += length(ends.at(0), ends.at(1));
  }
  return result;
}

// Between vertices and through them: from border to border, with what is smaller to the left.
TEST(Isolines, of_a_linear_function_are_straight)
{
  const Mesh mesh = to_mesh(flat_grid(9, 6));
  const auto x = at_points(mesh, [](const Point& p) { return p.x(); });
  const std::vector<double> values = {0.5, 3, 6.25, 8};
  const std::vector<Polyline> lines = isolines(mesh, x, values);
  ASSERT_EQ(lines.size(), values.size());
  EXPECT_TRUE(are_clean(lines));
  for(std::size_t i = 0; i < lines.size(); ++i)
  {
    EXPECT_EQ(lines[i].front(), Point(values[i], 0, 0));
    EXPECT_EQ(lines[i].back(), Point(values[i], 5, 0));
    EXPECT_EQ(lines[i].size(), std::floor(values[i]) == values[i] ? 6u : 11u);
    for(std::size_t j = 0; j < lines[i].size(); ++j)
    {
      EXPECT_EQ(lines[i][j].x(), values[i]);
      EXPECT_TRUE(j == 0 || lines[i][j - 1].y() < lines[i][j].y());
    }
  }
}

TEST(Isolines, go_counterclockwise_around_a_source)
{
  const Mesh cone = to_mesh(fan(50, 3));
  std::vector<double> distances(cone.num_vertices());
  const auto map = boost::make_iterator_property_map(distances.begin(), //
                                                     get(boost::vertex_index, cone));
  CGAL::approximate_geodesic_distances(cone, map, Vertex(0));
  const std::vector<Polyline> lines = isolines(cone, map, {std::sqrt(10.) / 3});
  ASSERT_EQ(lines.size(), 1u);
  ASSERT_EQ(lines[0].size(), 51u);
  EXPECT_TRUE(is_closed(lines[0]));
  for(std::size_t i = 0; i + 1 < lines[0].size(); ++i)
  {
    const Point &p = lines[0][i], &q = lines[0][i + 1];
    EXPECT_NEAR(p.z(), 2, 1e-14);
    EXPECT_GT(p.x() * q.y() - p.y() * q.x(), 0);
  }
}

TEST(Isolines, have_a_segment_in_every_face_that_they_cross)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    std::vector<double> values(mesh.num_vertices());
    for(const bool is_degenerate : {false, true})
    {
      for(double& value : values)
        value = is_degenerate ? double(random.below(5)) : random.between(0, 4);
      for(double& value : values)
        if(random.below(20) == 0)
          value = infinity;
      const std::vector<Polyline> lines = isolines(mesh, from_vector(values), {2});
      const double expected = length_in_faces(mesh, values, 2);
      EXPECT_NEAR(length(lines), expected, 1e-12 * expected);
      EXPECT_TRUE(are_clean(lines));
    }
  }
}

// On a surface without border, lines have no ends, even if they go through many vertices.
TEST(Isolines, are_closed_on_a_closed_surface)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(sphere(24, 15));
  for(int run = 0; run < 20; ++run)
  {
    std::vector<double> values(mesh.num_vertices());
    for(double& value : values)
      value = double(random.below(4));
    const std::vector<Polyline> lines = isolines(mesh, from_vector(values), {1, 1.5, 2});
    EXPECT_FALSE(lines.empty());
    EXPECT_TRUE(are_clean(lines));
    EXPECT_TRUE(std::all_of(lines.begin(), lines.end(), is_closed));
  }
}

TEST(Isolines, do_not_consist_of_a_single_point)
{
  const Mesh mesh = to_mesh(fan(7));
  const auto one_at = [&](const Vertex top) {
    return at_vertices([top](const Vertex v) { return v == top ? 1. : 0.; });
  };
  EXPECT_EQ(isolines(mesh, one_at(Vertex(0)), {-1, 0, 1, 2, infinity}).size(), 0u);
  EXPECT_EQ(isolines(mesh, one_at(Vertex(3)), {-1, 0, 1, 2, infinity}).size(), 0u);
  EXPECT_EQ(isolines(mesh, one_at(Vertex(0)), {0.5}).size(), 1u);
}

TEST(Isolines, end_where_vertices_were_not_reached)
{
  const Mesh mesh = to_mesh(flat_grid(5, 9));
  const auto x_below = at_points(mesh, [](const Point& p) { return p.y() > 6 ? infinity : p.x(); });
  const std::vector<Polyline> lines = isolines(mesh, x_below, {1.5, infinity});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].front(), Point(1.5, 0, 0));
  EXPECT_EQ(lines[0].back(), Point(1.5, 6, 0));
  const auto none = at_vertices([](Vertex) { return std::nan(""); });
  EXPECT_TRUE(isolines(mesh, none, {0, 1}).empty());
}

// ----- gradients

template <typename Map>
std::vector<Vector> gradients(const Mesh& mesh, const Map& map)
{
  std::map<Face, Vector> found;
  CGAL::geodesic_gradient(mesh, map, boost::make_assoc_property_map(found));
  std::vector<Vector> result;
  for(const Face f : mesh.faces())
    result.push_back(found.at(f));
  return result;
}

TEST(Gradient, of_a_linear_function_is_exact_on_a_grid)
{
  const Mesh mesh = to_mesh(flat_grid(9, 6));
  for(const Vector& expected : {Vector(1, 0, 0), Vector(-3, 0.25, 0), Vector(0, 0, 0)})
  {
    const auto map =
        at_points(mesh, [&](const Point& p) { return expected * (p - CGAL::ORIGIN) + 7; });
    for(const Vector& found : gradients(mesh, map))
      EXPECT_EQ(found, expected);
  }
}

// The part of the slope that is parallel to the face, whatever the unit of the coordinates.
TEST(Gradient, of_a_linear_function_is_its_projection_to_the_faces)
{
  Random random(test_seed());
  const Soup soup = terrain(12, 9, random);
  const Vector slope(2, -1, 3);
  for(const double unit : {1e-250, 1e-90, 1., 1e90, 1e250})
  {
    const Mesh mesh = to_mesh(
        soup.transformed([&](const Point& p) { return CGAL::ORIGIN + unit * (p - CGAL::ORIGIN); }));
    const std::vector<Vector> found = gradients(
        mesh, at_points(mesh, [&](const Point& p) { return slope * (p - CGAL::ORIGIN); }));
    const Mesh original = to_mesh(soup);
    for(const Face f : mesh.faces())
    {
      const auto [a, b, c] = corners(original, f);
      const Vector n = CGAL::normal(original.point(a), original.point(b), original.point(c));
      const Vector expected = slope - (slope * n) / n.squared_length() * n;
      EXPECT_LT((found[f.idx()] - expected).squared_length(), 1e-22);
    }
  }
}

TEST(Gradient, is_zero_where_there_is_none)
{
  Random random(test_seed());
  const Mesh mesh =
      to_mesh(with_caps(flat_grid(6, 4), [] { return 0.5; }).transformed([](const Point& p) {
        return p.y() == 0 ? Point(1, 1, 1) : p; // edges of length zero, too
      }));
  const auto x = [&](const Point& p) { return p.x() > 4 ? infinity : p.x(); };
  const std::vector<Vector> found = gradients(mesh, at_points(mesh, x));
  for(const Face f : mesh.faces())
  {
    const auto [a, b, c] = corners(mesh, f);
    const bool is_reached = (std::max)({x(mesh.point(a)), x(mesh.point(b)), x(mesh.point(c))}) < 5;
    const bool has_area = !CGAL::collinear(mesh.point(a), mesh.point(b), mesh.point(c));
    EXPECT_EQ(found[f.idx()] == CGAL::NULL_VECTOR, !is_reached || !has_area);
  }
  for(const Vector& v : gradients(mesh, at_vertices([](Vertex) { return std::nan(""); })))
    EXPECT_EQ(v, CGAL::NULL_VECTOR);
}

// ----- Voronoi partitions

template <typename NamedParameters = parameters::Default_named_parameters>
std::vector<int> partition(const Mesh& mesh,
                           const std::vector<Vertex>& sources,
                           const NamedParameters& np = parameters::default_values())
{
  std::map<Face, int> found;
  CGAL::geodesic_voronoi_partition(mesh, sources, boost::make_assoc_property_map(found), np);
  std::vector<int> result;
  for(const Face f : mesh.faces())
    result.push_back(found.at(f));
  return result;
}

TEST(Voronoi_partition, divides_a_strip_in_the_middle)
{
  const Mesh mesh = to_mesh(flat_grid(10, 2));
  const std::vector<int> cells = partition(mesh, {Vertex(9), Vertex(0)});
  for(std::size_t i = 0; i < 9; ++i)
  {
    EXPECT_EQ(cells[2 * i], i < 4 ? 1 : 0); // two corners at x = i + 1
    EXPECT_EQ(cells[2 * i + 1], i < 5 ? 1 : 0);
  }
}

// A triangle, and one beside each of its edges, with the source near one of its corners.
TEST(Voronoi_partition, gives_a_face_with_three_sources_to_the_nearest)
{
  const Mesh mesh = to_mesh({{Point(0, 0, 0), Point(10, 0, 0), Point(5, 9, 0), //
                              Point(0, -3, 0), Point(11, 0, 0), Point(5, 11, 0)},
                             {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}}});
  EXPECT_EQ(partition(mesh, {Vertex(3), Vertex(4), Vertex(5)}), std::vector<int>({1, 0, 1, 2}));
}

// The rule, applied to what the function for distances says of the vertices.
TEST(Voronoi_partition, follows_from_the_sources_of_the_corners)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    std::vector<Vertex> sources;
    for(int i = 0; i < 5; ++i)
      sources.push_back(random_vertex(mesh, random));
    const auto np = parameters::epsilon(0.3).maximum_distance(random.between(5, 20));
    std::map<Vertex, double> distance;
    std::map<Vertex, int> expected, source;
    CGAL::approximate_geodesic_distances(
        mesh, boost::make_assoc_property_map(distance), sources,
        np.nearest_source_map(boost::make_assoc_property_map(expected)));
    const std::vector<int> cells =
        partition(mesh, sources, np.nearest_source_map(boost::make_assoc_property_map(source)));
    EXPECT_EQ(source, expected);
    for(const Face f : mesh.faces())
    {
      std::map<int, int> votes;
      for(const Vertex v : corners(mesh, f))
        ++votes[source[v]];
      const int cell = cells[f.idx()];
      ASSERT_EQ(votes.count(cell), 1u);
      EXPECT_TRUE(votes.size() == 3 || votes[cell] > 1);
      for(const Vertex v : corners(mesh, f))
        for(const Vertex w : corners(mesh, f))
          EXPECT_TRUE(votes.size() < 3 || source[v] != cell || distance[v] <= distance[w]);
    }
  }
}

TEST(Voronoi_partition, leaves_out_what_is_not_reached)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(scattered_parts(random));
  const std::vector<int> cells = partition(mesh, {Vertex(0), Vertex(2)});
  for(const Face f : mesh.faces())
    EXPECT_EQ(cells[f.idx()], corners(mesh, f)[0].idx() < 2 + 12 * 9 ? 1 : -1);
  EXPECT_EQ(partition(mesh, {}), std::vector<int>(mesh.num_faces(), -1));
}

// ----- farthest-point sampling

struct Sample
{
  std::vector<Vertex> points;
  double radius = 0;
};

template <typename... NamedParameters>
Sample sample(const Mesh& mesh,
              const std::vector<Vertex>& sources,
              const std::size_t number,
              const NamedParameters&... np)
{
  Sample result;
  result.radius = CGAL::farthest_point_sampling(mesh, sources, number,
                                                std::back_inserter(result.points), np...);
  return result;
}

// A search from all points for every point.
template <typename GeodesicGraph>
Sample sample_from_scratch(Basic_mesh_search<GeodesicGraph> search,
                           std::vector<Vertex> sources,
                           const std::size_t number)
{
  Sample result;
  for(;;)
  {
    const std::vector<double> distances = search.distances(sources);
    const auto farthest = std::max_element(distances.begin(), distances.end());
    result.radius = *farthest;
    if(result.points.size() == number || result.radius == 0)
      return result;
    const auto i = static_cast<Mesh::size_type>(farthest - distances.begin());
    result.points.push_back(Vertex(i));
    sources.push_back(Vertex(i));
  }
}

template <typename GeodesicGraph, typename... NamedParameters>
void expect_sample_from_scratch(const Mesh& mesh, const NamedParameters&... np)
{
  for(const std::vector<Vertex>& sources : {std::vector<Vertex>{}, {Vertex(2), Vertex(1)}})
  {
    const Sample found = sample(mesh, sources, 30, np...);
    const Sample expected =
        sample_from_scratch(Basic_mesh_search<GeodesicGraph>(mesh, np...), sources, 30);
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.radius, expected.radius); // bit for bit
  }
}

TEST(Farthest_point_sampling, is_the_same_as_from_scratch)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    namespace AG = CGAL::Approximate_geodesics;
    expect_sample_from_scratch<AG::Edge_graph>(mesh);
    expect_sample_from_scratch<AG::Discrete_geodesic_graph>(mesh, parameters::epsilon(0.2));
    expect_sample_from_scratch<AG::Steiner_graph<AG::Equally_spaced_points>>(
        mesh, parameters::number_of_points_per_edge(1));
  }
}

// A hexagon with its centre, all of whose edges have length 1.
TEST(Farthest_point_sampling, chooses_the_first_of_those_that_are_equally_far)
{
  const Mesh mesh = to_mesh(fan(6));
  const auto one = boost::make_static_property_map<Edge>(1.);
  const auto np = parameters::edge_length_map(one);
  for(std::size_t number = 0; number < 10; ++number)
  {
    const Sample found = sample(mesh, {}, number, np);
    EXPECT_EQ(found.radius, number == 0 ? infinity : number < 7 ? 1 : 0);
    ASSERT_EQ(found.points.size(), (std::min<std::size_t>)(number, 7));
    for(std::size_t i = 0; i < found.points.size(); ++i)
      EXPECT_EQ(found.points[i], Vertex(Mesh::size_type(i)));
  }
}

// Both sides of it are at the same place, as only lengths along it count.
TEST(Farthest_point_sampling, halves_a_strip)
{
  const Mesh mesh = to_mesh(flat_grid(17, 2));
  const auto x = [&](const Vertex v) { return mesh.point(v).x(); };
  const auto lengths = boost::make_function_property_map<Edge, double>(
      [&](const Edge e) { return std::abs(x(mesh.vertex(e, 0)) - x(mesh.vertex(e, 1))); });
  const Sample found = sample(mesh, {Vertex(0)}, 1000, parameters::edge_length_map(lengths));
  const std::vector<double> expected = {16, 8, 4, 12, 2, 6, 10, 14, 1, 3, 5, 7, 9, 11, 13, 15};
  ASSERT_EQ(found.points.size(), expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(x(found.points[i]), expected[i]);
  EXPECT_EQ(found.radius, 0);
}

TEST(Farthest_point_sampling, gives_every_part_a_point_first)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(scattered_parts(random));
  const Vertex last(mesh.number_of_vertices() - 1);
  const std::vector<Vertex> firsts = {Vertex(0), Vertex(1), Vertex(2), Vertex(2 + 12 * 9), last};
  for(std::size_t number = 0; number < 5; ++number)
  {
    const Sample found = sample(mesh, {}, number);
    EXPECT_EQ(found.points,
              std::vector<Vertex>(firsts.begin(), firsts.begin() + std::ptrdiff_t(number)));
    EXPECT_EQ(found.radius, infinity);
  }
  EXPECT_LT(sample(mesh, {}, 5).radius, infinity);
  EXPECT_EQ(sample(mesh, {last, Vertex(0)}, 2).points, std::vector<Vertex>({Vertex(1), Vertex(2)}));
}

TEST(Farthest_point_sampling, can_do_without_sources_and_with_another_queue)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(20, 20, random));
  const Sample expected = sample(mesh, {}, 50);
  std::vector<Vertex> same, with_heap, from_vertex;
  EXPECT_EQ(CGAL::farthest_point_sampling(mesh, 50, std::back_inserter(same)), expected.radius);
  EXPECT_EQ(same, expected.points);
  using Queue = CGAL::Approximate_geodesics::Binary_heap_queue;
  EXPECT_EQ(CGAL::farthest_point_sampling<Queue>(mesh, 50, std::back_inserter(with_heap)),
            expected.radius);
  EXPECT_EQ(with_heap, expected.points);
  CGAL::farthest_point_sampling(mesh, Vertex(0), 49, std::back_inserter(from_vertex));
  EXPECT_TRUE(std::equal(from_vertex.begin(), from_vertex.end(), expected.points.begin() + 1));
}

// ----- meshes

// All functions, on a mesh of any type: the results as numbers.
template <typename AnyMesh>
std::vector<double> everything(const AnyMesh& mesh)
{
  using Graph_traits = boost::graph_traits<AnyMesh>;
  std::vector<typename Graph_traits::vertex_descriptor> points;
  const double radius = CGAL::farthest_point_sampling(mesh, 6, std::back_inserter(points));
  std::map<typename Graph_traits::vertex_descriptor, double> distance;
  std::map<typename Graph_traits::face_descriptor, int> cell;
  std::map<typename Graph_traits::face_descriptor, Vector> gradient;
  const auto distances = boost::make_assoc_property_map(distance);
  CGAL::approximate_geodesic_distances(mesh, distances, points);
  CGAL::geodesic_voronoi_partition(mesh, points, boost::make_assoc_property_map(cell));
  CGAL::geodesic_gradient(mesh, distances, boost::make_assoc_property_map(gradient));
  std::vector<Polyline> lines;
  CGAL::geodesic_isolines(mesh, distances, std::array<float, 2>{0.25, 0.5},
                          std::back_inserter(lines));

  std::vector<double> result = {radius, double(lines.size()), length(lines)};
  for(const auto v : points)
    result.push_back(get(CGAL::vertex_point, mesh, v).x());
  for(const auto f : faces(mesh))
  {
    result.push_back(cell[f]);
    result.push_back(gradient[f].x());
  }
  return result;
}

TEST(Distance_fields, are_the_same_on_a_polyhedron)
{
  for(const Mesh& mesh : simple_meshes())
  {
    const std::vector<double> expected = everything(mesh);
    const std::vector<double> found = everything(Copied_mesh<Polyhedron>(mesh).mesh);
    ASSERT_EQ(found.size(), expected.size());
    for(std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-12); // corners may come in another order
  }
}

TEST(Distance_fields, need_neither_faces_nor_vertices)
{
  EXPECT_EQ(everything(Mesh()), std::vector<double>(3, 0.));
  EXPECT_EQ(everything(Polyhedron()), std::vector<double>(3, 0.));
  Mesh points;
  for(int i = 0; i < 4; ++i)
    points.add_vertex(Point(i, 0, 0));
  EXPECT_EQ(everything(points), std::vector<double>({0, 0, 0, 0, 1, 2, 3}));
}

TEST(Distance_fields, do_not_mind_removed_elements)
{
  Mesh mesh = to_mesh({{Point(9, 9, 9)}, {}}), original = to_mesh(flat_grid(5, 4));
  mesh += original;
  mesh.remove_vertex(Vertex(0));
  EXPECT_TRUE(have_same_bits(everything(mesh), everything(original)));
}

TEST(Distance_fields, are_exact_with_an_exact_kernel)
{
  using Exact_point = Exact_kernel::Point_3;
  using Exact_vector = Exact_kernel::Vector_3;
  Exact_mesh mesh;
  mesh.add_face(mesh.add_vertex(Exact_point(0, 0, 0)), mesh.add_vertex(Exact_point(3, 0, 0)),
                mesh.add_vertex(Exact_point(0, 7, 1)));
  const auto x = at_vertices([&](const Vertex v) { return CGAL::to_double(mesh.point(v).x()); });
  std::map<Face, Exact_vector> gradient;
  CGAL::geodesic_gradient(mesh, x, boost::make_assoc_property_map(gradient));
  EXPECT_EQ(gradient.at(Face(0)), Exact_vector(1, 0, 0));
  std::vector<std::vector<Exact_point>> lines;
  CGAL::geodesic_isolines(mesh, x, std::vector<double>{1.5}, std::back_inserter(lines));
  const std::vector<Exact_point> expected = {Exact_point(1.5, 0, 0), Exact_point(1.5, 3.5, 0.5)};
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], expected);
}

TEST(Distance_fields, take_points_from_a_map)
{
  const Mesh mesh = to_mesh(flat_grid(3, 2));
  const auto x = at_points(mesh, [](const Point& p) { return p.x(); });
  const auto doubled = boost::make_function_property_map<Vertex>(
      [&](const Vertex v) { return CGAL::ORIGIN + 2 * (mesh.point(v) - CGAL::ORIGIN); });
  std::map<Face, Vector> gradient;
  CGAL::geodesic_gradient(mesh, x, boost::make_assoc_property_map(gradient),
                          parameters::vertex_point_map(doubled).geom_traits(Kernel()));
  EXPECT_EQ(gradient.at(Face(0)), Vector(0.5, 0, 0));
  std::vector<Polyline> lines;
  CGAL::geodesic_isolines(mesh, x, std::vector<int>{1}, std::back_inserter(lines),
                          parameters::vertex_point_map(doubled).geom_traits(Kernel()));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], Polyline({Point(2, 0, 0), Point(2, 2, 0)}));
}

TEST(Distance_fields, refuse_other_faces_than_triangles)
{
  Mesh mesh;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), mesh);
  const auto x = at_points(mesh, [](const Point& p) { return p.x(); });
  expect_message<std::invalid_argument>([&] { isolines(mesh, x, {0.5}); }, "not a triangle");
  expect_message<std::invalid_argument>([&] { gradients(mesh, x); }, "not a triangle");
  expect_message<std::invalid_argument>([&] { partition(mesh, {}); }, "not a triangle");
  expect_message<std::invalid_argument>([&] { sample(mesh, {}, 3); }, "not a triangle");
}

TEST(Distance_fields, refuse_sources_that_are_not_vertices)
{
  const Mesh mesh = to_mesh(flat_grid(3, 2));
  const std::vector<Vertex> wrong = {Vertex(0), Vertex(6)};
  expect_message<std::invalid_argument>([&] { partition(mesh, wrong); }, "not one of the mesh");
  expect_message<std::invalid_argument>([&] { sample(mesh, wrong, 3); }, "not one of the mesh");
}

} // namespace
