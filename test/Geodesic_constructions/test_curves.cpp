// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_constructions/search_from_curves.h>

#include "checks/expect_message.h"
#include "checks/graphs_of_all_kinds.h"
#include "checks/test_random.h"
#include "meshes/sample_meshes.h"
#include "meshes/test_costs.h"
#include "meshes/test_meshes.h"
#include "meshes/test_weights.h"
#include "oracles/Graph_with_lines.h"
#include "oracles/distances_to_curves.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_costs/Directional_graph.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Distances from curves, on triangulations.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

constexpr double ROUNDING = 1e-9;

template <typename Graph>
Surface_search<Graph> search_from(const Graph& graph, const Polyline_on_surface& polyline)
{
  Surface_search<Graph> result(graph);
  AG::run_from_curves(result, {{{polyline}}});
  return result;
}

Intrinsic_point vertex_with_index(const Triangulation& t, const std::size_t i)
{
  return Intrinsic_point::at_vertex(t.vertex(i));
}

// ----- closed forms

// On a plane, a polyline of vertices that is as far away as the segments between its points.
class Curve_in_plane : public testing::Test
{
protected:
  Curve_in_plane()
  {
    AG::Surface_search<Saddle_vertex_graph> search(m_exact);
    for(const std::size_t i : {63u, 300u, 415u, 189u})
    {
      const Intrinsic_point p = vertex_with_index(m_triangulation, i);
      m_corners.push_back(m_mesh.point(Vertex(static_cast<unsigned>(i))));
      if(m_polyline.empty())
      {
        m_polyline.push_back(p);
        continue;
      }
      const Intrinsic_point last = m_polyline.back();
      search.run_to(last, {{p}});
      const auto path = search.find_path(last).points;
      m_polyline.insert(m_polyline.end(), path.begin() + 1, path.end());
    }
  }

  double distance(const Point& p) const
  {
    double result = infinity;
    for(std::size_t i = 0; i + 1 < m_corners.size(); ++i)
      result = (std::min)(result, std::sqrt(CGAL::squared_distance(
                                      p, Kernel::Segment_3(m_corners[i], m_corners[i + 1]))));
    return result;
  }

  template <typename Graph>
  void expect_distances(const Graph& graph, const double epsilon) const
  {
    const auto search = search_from(graph, m_polyline);
    for(const Vertex v : m_mesh.vertices())
    {
      const Intrinsic_point p = vertex_with_index(m_triangulation, v.idx());
      expect_between(search.distance(p), distance(m_mesh.point(v)), epsilon);
      expect_path_to_curve(search, p, 1e-6);
    }
    Random random(test_seed());
    for(int i = 0; i < 200; ++i)
    {
      const Face_location p = random_face_location(m_mesh, random);
      const Intrinsic_point q = m_translation.intrinsic_point(p);
      expect_between(search.distance(q), distance(position(m_mesh, p)), epsilon);
      expect_path_to_curve(search, q, 1e-6);
    }
  }

  static void expect_between(const double found, const double wanted, const double epsilon)
  {
    EXPECT_GE(found, wanted * (1 - ROUNDING) - 1e-12);
    EXPECT_LE(found, wanted * (1 + epsilon) + 1e-12);
  }

  Random m_random{test_seed()};
  const Mesh m_mesh = to_mesh(grid(24, 20, [this](const double i, const double j) {
    const bool is_inside = i > 0 && i < 23 && j > 0 && j < 19;
    const double largest = is_inside ? 0.2 : 0;
    const double x = i + m_random.between(-largest, largest);
    return Point(x, j + m_random.between(-largest, largest), 0);
  }));
  const Triangulation m_triangulation{m_mesh};
  const Saddle_vertex_graph m_exact{m_triangulation};
  AG::Mesh_translation<Mesh, decltype(get(boost::vertex_index, m_mesh))> m_translation{
      m_mesh, get(boost::vertex_index, m_mesh), m_triangulation};
  Polyline_on_surface m_polyline;
  std::vector<Point> m_corners;
};

TEST(Curve, that_goes_straight_on_at_an_edge_is_nearest_there)
{
  const Triangulation t(to_mesh(flat_grid(5, 4)));
  const auto vertex = [&](const std::size_t i) { return vertex_with_index(t, i); };
  unsigned diagonal = 0;
  while(t.source(diagonal) != t.vertex(0) || t.target(diagonal) != t.vertex(6))
    ++diagonal;
  const Polyline_on_surface polyline{vertex(1), Intrinsic_point::on_edge(diagonal, 0.5), vertex(5)};
  const auto expect_distances = [&](const auto& graph) {
    const auto search = search_from(graph, polyline);
    for(const std::size_t i : {0u, 6u})
      EXPECT_NEAR(search.distance(vertex(i)), std::sqrt(0.5), 1e-12);
  };
  expect_distances(Saddle_vertex_graph(t));
  expect_distances(Lazy_discrete_geodesic_graph(t, parameters::epsilon(1)));
  expect_distances(Discrete_geodesic_graph(t, parameters::epsilon(1)));
}

TEST_F(Curve_in_plane, has_exact_distances_in_the_exact_graph)
{
  expect_distances(m_exact, ROUNDING);
}

TEST_F(Curve_in_plane, has_distances_within_the_bound_in_other_graphs)
{
  for(const double epsilon : {0.01, 0.1, 1., 10.})
  {
    expect_distances(Lazy_discrete_geodesic_graph(m_triangulation, parameters::epsilon(epsilon)),
                     epsilon);
    expect_distances(Discrete_geodesic_graph(m_triangulation, parameters::epsilon(epsilon)),
                     epsilon);
  }
  expect_distances(Lazy_discrete_geodesic_graph(m_triangulation, parameters::epsilon(0.1),
                                                Lazy_discrete_geodesic_graph::Arcs::KEPT),
                   0.1);
}

// A circle that is a polygon at half of the height of a cone: its sides are parallel to those of
// the base, from whose vertices the nearest points are its corners, on the cone's edges.
TEST(Curve_on_cone, has_exact_distances)
{
  const std::size_t valence = 12;
  const Mesh mesh = to_mesh(fan(valence, 2));
  const Triangulation t(mesh);
  Polyline_on_surface circle;
  for(std::size_t i = 1; i <= valence; ++i)
    for(auto h = t.first_halfedge(t.vertex(0)); h < t.beyond_halfedge(t.vertex(0)); ++h)
      if(t.index(t.target(h)) == i)
        circle.push_back(Intrinsic_point::on_edge(h, 0.5));
  circle.push_back(circle.front());
  const Saddle_vertex_graph graph(t);
  const auto search = search_from(graph, circle);
  const double edge = std::sqrt(5.), side = 2 * std::sin(std::acos(-1.) / double(valence));
  const double height = std::sqrt(edge * edge - side * side / 4);
  EXPECT_NEAR(search.distance(vertex_with_index(t, 0)), height / 2, ROUNDING);
  for(std::size_t i = 1; i <= valence; ++i)
    EXPECT_NEAR(search.distance(vertex_with_index(t, i)), edge / 2, ROUNDING);
  for(AG::Intrinsic_point::Index h = 0; h < t.number_of_halfedges(); ++h)
    if(t.is_border(h)) // seen from the middle of a side of the base
    {
      EXPECT_NEAR(search.distance(Intrinsic_point::on_edge(h, 0.5)), height / 2, ROUNDING);
    }
}

// From the equator of a polyhedron, paths go straight up the middle of a gore, and along it.
TEST(Curve_on_sphere, has_exact_distances_from_the_equator)
{
  const std::size_t meridians = 16, parallels = 9;
  const Mesh mesh = to_mesh(sphere(meridians, parallels));
  const Triangulation t(mesh);
  Polyline_on_surface equator;
  for(std::size_t i = 0; i <= meridians; ++i)
    equator.push_back(vertex_with_index(t, 2 + 4 * meridians + i % meridians));
  const Saddle_vertex_graph graph(t);
  const auto search = search_from(graph, equator);
  double sum = 0;
  const auto middle = [&](const std::size_t j) { // of a side of a parallel
    const Point a = mesh.point(Vertex(static_cast<unsigned>(2 + j * meridians))),
                b = mesh.point(Vertex(static_cast<unsigned>(3 + j * meridians)));
    return CGAL::midpoint(a, b);
  };
  for(std::size_t j = 4; j-- > 0;)
  {
    sum += std::sqrt(CGAL::squared_distance(middle(j + 1), middle(j)));
    for(std::size_t i = 0; i < meridians; ++i)
    {
      EXPECT_NEAR(search.distance(vertex_with_index(t, 2 + j * meridians + i)), sum, ROUNDING);
      EXPECT_NEAR(search.distance(vertex_with_index(t, 2 + (8 - j) * meridians + i)), sum,
                  ROUNDING);
    }
  }
  sum += std::sqrt(CGAL::squared_distance(middle(0), Point(0, 0, 1)));
  EXPECT_NEAR(search.distance(vertex_with_index(t, 0)), sum, ROUNDING);
  EXPECT_NEAR(search.distance(vertex_with_index(t, 1)), sum, ROUNDING);
}

// ----- searches from points

// Distances from a curve are the smallest ones from its points, which searches from the other end
// find.
void expect_smallest_distances(const std::string& name, const Mesh& mesh, Random& random)
{
  SCOPED_TRACE(name);
  const Triangulation t(mesh);
  const Saddle_vertex_graph graph(t);
  const Polyline_on_surface polyline = random_polyline(graph, 3, random);
  const auto search = search_from(graph, polyline);
  AG::Surface_search<Saddle_vertex_graph> from_point(graph);
  for(int i = 0; i < 6; ++i)
  {
    const Intrinsic_point p = random_intrinsic_point(t, random);
    from_point.run({{p}});
    const double wanted = distance_to_polyline(from_point, polyline), found = search.distance(p);
    if(wanted == infinity || found == infinity)
      EXPECT_EQ(found, wanted);
    else
      EXPECT_NEAR(found, wanted, ROUNDING * (wanted + graph.arc_lengths().longest * t.unit()));
    expect_path_to_curve(search, p, 1e-7);
  }
}

TEST(Curve, sources_have_the_smallest_distance_of_their_points_on_generated_meshes)
{
  Random random(test_seed());
  for(const Named_mesh& m : generated_meshes(test_seed()))
    if(m.mesh.number_of_faces() > 0)
      expect_smallest_distances(m.name, m.mesh, random);
}

TEST(Curve, sources_have_the_smallest_distance_of_their_points_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  Random random(test_seed());
  for(const char* const name :
      {"tetrahedron.off", "cube.off", "bull.off", "joint.off", "pig.off", "elephant.off"})
    if(const Mesh mesh = sample_mesh(name); mesh.number_of_faces() > 0)
      expect_smallest_distances(name, mesh, random);
}

// ----- bounds

TEST(Curve, sources_have_distances_within_the_bound)
{
  Random random(test_seed());
  for(const Named_mesh& m : generated_meshes(test_seed()))
  {
    if(m.mesh.number_of_faces() == 0)
      continue;
    SCOPED_TRACE(m.name);
    const Triangulation t(m.mesh);
    const Saddle_vertex_graph graph(t);
    const Polyline_on_surface polyline = random_polyline(graph, 4, random);
    const auto wanted = search_from(graph, polyline);
    const auto expect = [&](const auto& other, const double epsilon) {
      const auto search = search_from(other, polyline);
      for(unsigned v = 0; v < t.number_of_vertices(); ++v)
      {
        const double d = wanted.distance(Intrinsic_point::at_vertex(v)),
                     found = search.distance(Intrinsic_point::at_vertex(v));
        if(d == infinity)
          EXPECT_EQ(found, infinity);
        else
        {
          const double small = 1e-12 * graph.arc_lengths().longest * t.unit();
          EXPECT_GE(found, d * (1 - ROUNDING) - small);
          EXPECT_LE(found, d * (1 + epsilon) + small);
        }
      }
      for(int i = 0; i < 5; ++i)
        expect_path_to_curve(search, random_intrinsic_point(t, random), 1e-6);
    };
    for(const double epsilon : {0.05, 0.5})
    {
      expect(Lazy_discrete_geodesic_graph(t, parameters::epsilon(epsilon)), epsilon);
      expect(Discrete_geodesic_graph(t, parameters::epsilon(epsilon)), epsilon);
    }
  }
}

// Samples there have a face on one side only.
TEST(Curve, sources_at_the_border_have_distances_within_the_bound)
{
  const Triangulation t(to_mesh(flat_grid(8, 6)));
  const Saddle_vertex_graph exact(t);
  const Discrete_geodesic_graph graph(t, parameters::epsilon(0.5));
  for(unsigned h = 0; h < t.number_of_halfedges(); ++h)
    if(!t.is_border(h) && t.is_border(t.opposite(h)))
      for(const Intrinsic_point& end :
          {Intrinsic_point::on_edge(h, 0.8), Intrinsic_point::on_edge(t.next(h), 0.4)})
      {
        const Polyline_on_surface polyline{Intrinsic_point::on_edge(h, 0.1), end};
        const auto wanted = search_from(exact, polyline);
        const auto found = search_from(graph, polyline);
        for(unsigned v = 0; v < t.number_of_vertices(); ++v)
        {
          const Intrinsic_point vertex = Intrinsic_point::at_vertex(v);
          EXPECT_GE(found.distance(vertex), wanted.distance(vertex) * (1 - ROUNDING));
          EXPECT_LE(found.distance(vertex), wanted.distance(vertex) * 1.5);
        }
      }
}

// Along edges and with weights, no point of the curve is nearer, and a path has the distance.
TEST(Curve, sources_are_no_farther_than_their_points_in_all_graphs)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(9, 8, random));
  const Weights weights = random_weights(mesh, random, 1, 10);
  const Triangulation t(mesh), weighted(mesh, with_weights(weights));
  const auto expect = [&](const auto& graph) {
    const Polyline_on_surface polyline = random_polyline(graph, 4, random);
    const auto search = search_from(graph, polyline);
    AG::Surface_search from_point(graph);
    std::vector<double> smallest(t.number_of_vertices(), infinity);
    for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
      for(int k = 0; k <= 8; ++k)
      {
        from_point.run({{point_between(t, polyline[i], polyline[i + 1], k / 8.)}});
        for(unsigned v = 0; v < t.number_of_vertices(); ++v)
          smallest[v] = (std::min)(smallest[v], from_point.distance(Intrinsic_point::at_vertex(v)));
      }
    for(unsigned v = 0; v < t.number_of_vertices(); ++v)
    {
      const double found = search.distance(Intrinsic_point::at_vertex(v));
      EXPECT_LE(found, smallest[v] * (1 + 1e-12) + 1e-12);
      EXPECT_GE(found, smallest[v] * 0.9 - 0.1); // samples are close to each other
      expect_path_to_curve(search, Intrinsic_point::at_vertex(v), 1e-9);
    }
    for(int i = 0; i < 20; ++i)
      expect_path_to_curve(search, random_intrinsic_point(t, random), 1e-9);
  };
  expect(AG::Edge_graph(t));
  expect(Steiner_graph<Fixed_number_of_points>(t, Fixed_number_of_points(2)));
  expect(Steiner_graph<Fixed_number_of_points>(weighted, Fixed_number_of_points(2)));
  expect(Steiner_graph<Geometric_points>(weighted, Geometric_points(0.5)));
}

// ----- regions, several sources

TEST(Region, is_at_distance_zero_and_the_rest_as_far_as_from_its_border)
{
  const Mesh mesh = to_mesh(flat_grid(12, 10));
  const Triangulation t(mesh);
  const Saddle_vertex_graph graph(t);
  Intrinsic_curve square;
  for(unsigned h = 0; h < t.number_of_halfedges(); ++h)
    if(!t.is_border(h) && h == t.first_of_face(h))
    {
      double x = 0, y = 0;
      for(const auto side : t.halfedges_of_face(h))
      {
        const Point p = mesh.point(Vertex(t.index(t.target(side))));
        x += p.x() / 3;
        y += p.y() / 3;
      }
      if(x > 3 && x < 7 && y > 2 && y < 6)
        square.faces.push_back(h);
    }
  auto& border = square.polylines.emplace_back();
  for(const std::size_t i : {0u, 1u, 2u, 3u, 4u})
    border.push_back(vertex_with_index(t, 3 + i + 2 * 12));
  for(const std::size_t i : {1u, 2u, 3u, 4u})
    border.push_back(vertex_with_index(t, 7 + (2 + i) * 12));
  for(const std::size_t i : {1u, 2u, 3u, 4u})
    border.push_back(vertex_with_index(t, 7 - i + 6 * 12));
  for(const std::size_t i : {1u, 2u, 3u, 4u})
    border.push_back(vertex_with_index(t, 3 + (6 - i) * 12));
  AG::Surface_search<Saddle_vertex_graph> search(graph);
  AG::run_from_curves(search, {square});
  for(const Vertex v : mesh.vertices())
  {
    const Point p = mesh.point(v);
    const double x = (std::max)({0., 3 - p.x(), p.x() - 7}),
                 y = (std::max)({0., 2 - p.y(), p.y() - 6});
    EXPECT_NEAR(search.distance(vertex_with_index(t, v.idx())), std::hypot(x, y), ROUNDING);
  }
  for(const auto h : square.faces)
    EXPECT_EQ(search.distance(Intrinsic_point::in_face(h, 0.3, 0.2)), 0);
}

TEST(Curve, sources_are_numbered_and_have_initial_distances)
{
  const Mesh mesh = to_mesh(flat_grid(20, 5));
  const Triangulation t(mesh);
  const AG::Edge_graph graph(t);
  AG::Surface_search<AG::Edge_graph> search(graph);
  const auto column = [&](const std::size_t x) {
    Polyline_on_surface result;
    for(std::size_t y = 0; y < 5; ++y)
      result.push_back(vertex_with_index(t, x + y * 20));
    return result;
  };
  AG::run_from_curves(search, {{{column(2)}, {}, 4}, {{column(16)}}});
  for(std::size_t x = 0; x < 20; ++x)
  {
    const double first = std::abs(double(x) - 2) + 4, second = std::abs(double(x) - 16);
    const auto answer = search.nearest(vertex_with_index(t, x + 40));
    EXPECT_NEAR(answer.distance, (std::min)(first, second), ROUNDING);
    EXPECT_EQ(answer.source, first <= second ? 0u : 1u);
    EXPECT_EQ(search.source(t.vertex(x + 40)), answer.source);
  }
  search.run({{vertex_with_index(t, 0)}}); // the curves are forgotten
  EXPECT_NEAR(search.distance(vertex_with_index(t, 19)), 19, ROUNDING);
  EXPECT_TRUE(AG::curves_of(search).empty());
}

// ----- bad input

TEST(Curve, sources_that_are_none_are_refused)
{
  const Mesh mesh = quiet_mesh();
  const Triangulation t(mesh);
  const Saddle_vertex_graph graph(t);
  AG::Surface_search<Saddle_vertex_graph> search(graph);
  search.run({{vertex_with_index(t, 0)}});
  const auto refuse = [&](const Intrinsic_curve& curve, const char* const text) {
    expect_message<std::invalid_argument>([&] { AG::run_from_curves(search, {curve}); }, text);
  };
  refuse({{{}}}, "a polyline without points");
  refuse({{{vertex_with_index(t, 0), vertex_with_index(t, 19)}}}, "not in the same face");
  refuse({{{Intrinsic_point::at_vertex(99)}}}, "vertex 99");
  refuse({{{vertex_with_index(t, 0)}}, {}, -1}, "initial distance of source 0 is -1");
  refuse({{{vertex_with_index(t, 0)}}, {9999}}, "a face that does not exist");
  EXPECT_EQ(search.distance(vertex_with_index(t, 0)), 0); // results are kept
}

TEST(Curve, sources_are_refused_where_costs_depend_on_the_direction)
{
  const Mesh mesh = quiet_mesh();
  const AG::Directional_graph<Fixed_number_of_points> graph(
      Triangulation(mesh, with_cost([](Face, const Vector& v) { return std::sqrt(v * v); })),
      Fixed_number_of_points(1));
  AG::Surface_search<AG::Directional_graph<Fixed_number_of_points>> search(graph);
  expect_message<std::invalid_argument>(
      [&] { AG::run_from_curves(search, {{{{Intrinsic_point::at_vertex(0)}}}}); },
      "Directional_graph");
}

TEST(Curve, sources_are_refused_by_graphs_whose_runs_find_no_lines_from_curves)
{
  const Mesh mesh = quiet_mesh();
  const Graph_with_lines graph(Triangulation(mesh), CGAL::parameters::default_values());
  AG::Surface_search<Graph_with_lines> search(graph);
  expect_message<std::invalid_argument>(
      [&] { AG::run_from_curves(search, {{{{Intrinsic_point::at_vertex(0)}}}}); }, "curves");
}

} // namespace
