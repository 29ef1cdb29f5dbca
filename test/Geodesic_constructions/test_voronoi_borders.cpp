// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_constructions/voronoi_borders.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include "checks/expect_message.h"
#include "meshes/hostile_meshes.h"
#include "meshes/sample_meshes.h"
#include "oracles/test_oracles.h"
#include "threads/Interruption_at.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

// Voronoi diagrams and cut loci, against closed forms and exact distances.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Cells = AG::Voronoi_cells<Mesh>;

double total_area(const Cells& cells)
{
  return std::accumulate(cells.areas.begin(), cells.areas.end(), 0.);
}

double length_of_border(const Mesh& mesh, const AG::Voronoi_border<Mesh>& border)
{
  double result = 0;
  for(std::size_t i = 1; i < border.points.size(); ++i)
    result += std::sqrt(CGAL::squared_distance(position(mesh, border.points[i - 1]),
                                               position(mesh, border.points[i])));
  return result;
}

// Exact distances from single sources.
class Exact_distances
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, AG::Saddle_vertex_graph>;

public:
  Exact_distances(const Mesh& mesh, std::vector<Surface_point> sources, std::vector<double> initial)
    : m_mesh(mesh), m_sources(std::move(sources)), m_initial(std::move(initial))
  {
    m_initial.resize(m_sources.size(), 0);
    m_paths.resize(m_sources.size());
  }

  double operator()(const std::size_t source, const Face_location& p)
  {
    if(!m_paths[source])
    {
      m_paths[source] = std::make_unique<Paths>(m_mesh);
      const auto add = [&](const auto& point) { m_paths[source]->add_source_point(point); };
      add(m_sources[source]);
    }
    const double result = m_paths[source]->shortest_distance_to_source_points(p).first;
    return result < 0 ? std::numeric_limits<double>::infinity() : m_initial[source] + result;
  }

  double smallest(const Face_location& p)
  {
    double result = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < m_sources.size(); ++i)
      result = (std::min)(result, (*this)(i, p));
    return result;
  }

private:
  const Mesh& m_mesh;
  const std::vector<Surface_point> m_sources;
  std::vector<double> m_initial;
  std::vector<std::unique_ptr<Paths>> m_paths;
};

// Consecutive points lie in the face of the latter, up to the distance at which ends are joined.
void expect_points_in_faces(const Mesh& mesh, const Cells& cells)
{
  for(const auto& border : cells.borders)
    for(std::size_t i = 1; i < border.points.size(); ++i)
    {
      const Halfedge h = mesh.halfedge(border.points[i].first);
      const Kernel::Triangle_3 face(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                    mesh.point(mesh.target(mesh.next(h))));
      const Point p = position(mesh, border.points[i - 1]);
      EXPECT_LT(CGAL::squared_distance(p, face), 1e-10 * std::sqrt(face.squared_area()));
    }
}

// Points of borders are at the same distance from both sources, and nearer to no other; cells cover
// the part of the surface that is reached.
void expect_right_cells(const Mesh& mesh,
                        const Cells& cells,
                        const std::vector<Surface_point>& sources,
                        const std::vector<double>& initial = {},
                        const std::size_t step = 1)
{
  Exact_distances exact(mesh, sources, initial);
  double largest = 0, error = 0;
  for(const auto& border : cells.borders)
  {
    ASSERT_LT(border.sources[0], border.sources[1]);
    ASSERT_GE(border.points.size(), 2u);
    for(std::size_t i = 0; i < border.points.size(); i += step)
    {
      const double distance = exact.smallest(border.points[i]);
      largest = (std::max)(largest, distance);
      for(const std::size_t source : border.sources)
        error = (std::max)(error, exact(source, border.points[i]) - distance);
    }
    if(border.is_closed())
    {
      EXPECT_EQ(border.points.front(), border.points.back());
    }
  }
  EXPECT_LE(error, 1e-6 * largest);
  double area = 0;
  for(const Face f : mesh.faces())
    if(std::isfinite(exact.smallest({f, {1, 0, 0}})))
      area += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  if(area > 1e-280 && area < 1e280) // no underflow and overflow
  {
    EXPECT_NEAR(total_area(cells), area, 1e-9 * area);
  }
}

std::vector<Surface_point> random_sources(const Mesh& mesh, const std::size_t n, Random& random)
{
  std::vector<Surface_point> result;
  for(std::size_t i = 0; i < n; ++i)
    if(i % 3 == 0)
      result.emplace_back(random_vertex(mesh, random));
    else if(i % 3 == 1)
      result.emplace_back(random_face_location(mesh, random));
    else
      result.emplace_back(Edge_location(random_halfedge(mesh, random), 0.37));
  return result;
}

// Of how many cells the whole surface consists; borders are a planar graph on a sphere.
void expect_triangulation_of_sphere(const Cells& cells)
{
  std::set<std::size_t> used;
  for(const auto& triangle : cells.triangles())
    used.insert(triangle.begin(), triangle.end());
  EXPECT_EQ(used.size() + cells.triangles().size(), cells.borders.size() + 2);
  for(const auto& corner : cells.corners)
    EXPECT_EQ(corner.sources.size(), 3u);
}

TEST(VoronoiBorders, of_two_points_of_a_plane_is_their_bisector)
{
  const Mesh mesh = to_mesh(flat_grid(9, 7)); // 8 x 6 cells
  const double width = 8, height = 6;
  for(const double x : {3., 3.25, 3.8})
  {
    const std::vector<Surface_point> sources{location_at(mesh, Point(x - 1, 2.5, 0)),
                                             location_at(mesh, Point(x + 1, 2.5, 0))};
    const Cells cells = AG::voronoi_borders(mesh, sources);
    ASSERT_EQ(cells.borders.size(), 1u);
    EXPECT_EQ(cells.corners.size(), 2u);
    for(const auto& p : cells.borders[0].points)
      EXPECT_NEAR(position(mesh, p).x(), x, 1e-9);
    EXPECT_NEAR(length_of_border(mesh, cells.borders[0]), height, 1e-9);
    // the first cell is to the left
    EXPECT_NEAR(position(mesh, cells.borders[0].points.front()).y(), 0, 1e-9);
    EXPECT_NEAR(cells.areas[0], x * height, 1e-9);
    EXPECT_NEAR(cells.areas[1], (width - x) * height, 1e-9);
    EXPECT_TRUE(cells.triangles().empty());
  }
}

TEST(VoronoiBorders, of_points_with_initial_distances_is_a_hyperbola)
{
  const Mesh mesh = to_mesh(flat_grid(9, 7));
  const Point a(2.3, 3, 0), b(5.3, 3, 0); // with 3 between them
  const std::vector<Surface_point> sources{location_at(mesh, a), location_at(mesh, b)};
  const auto distances = [&](const double error) {
    return AG::voronoi_borders(
        mesh, sources,
        CGAL::parameters::initial_distances(std::vector<double>{1, 0}).chord_error(error));
  };
  const Cells cells = distances(1e-6);
  ASSERT_EQ(cells.borders.size(), 1u);
  double area = 0; // to the left of the polyline
  for(std::size_t i = 0; i < cells.borders[0].points.size(); ++i)
  {
    const Point p = position(mesh, cells.borders[0].points[i]);
    EXPECT_NEAR(1 + std::sqrt(CGAL::squared_distance(p, a)),
                std::sqrt(CGAL::squared_distance(p, b)), 1e-9);
    if(i == 0)
      continue;
    const Point q = position(mesh, cells.borders[0].points[i - 1]);
    area += (p.x() + q.x()) / 2 * (p.y() - q.y());
  }
  EXPECT_NEAR(cells.areas[0], area, 1e-5);
  // x = 3.8 - cosh(s) / 2 and y = 3 + sqrt(2) sinh(s), with y from 0 to 6
  const double s = std::asinh(3 / std::sqrt(2.));
  EXPECT_NEAR(cells.areas[0], 6 * 3.8 - std::sqrt(2.) / 4 * (std::sinh(2 * s) + 2 * s), 1e-9);
  EXPECT_NEAR(total_area(cells), 48, 1e-9);
  EXPECT_LT(distances(0.1).borders[0].points.size(), cells.borders[0].points.size());
}

double
squared_distance_from(const Mesh& mesh, const AG::Voronoi_border<Mesh>& border, const Point& p)
{
  double result = std::numeric_limits<double>::infinity();
  for(std::size_t i = 1; i < border.points.size(); ++i)
  {
    const Kernel::Segment_3 segment(position(mesh, border.points[i - 1]),
                                    position(mesh, border.points[i]));
    result = (std::min)(result, CGAL::squared_distance(segment, p));
  }
  return result;
}

TEST(VoronoiBorders, are_within_the_chord_error)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3)); // 2 x 2 cells
  const std::vector<Surface_point> sources{location_at(mesh, Point(0.5, 1, 0)),
                                           location_at(mesh, Point(1.5, 1, 0))};
  for(const double error : {0.1, 1e-3, 1e-5})
    for(const double difference : {0.1, 0.5, 0.99})
    {
      const std::vector<double> initial{0, difference};
      const Cells cells = AG::voronoi_borders(
          mesh, sources, CGAL::parameters::initial_distances(initial).chord_error(error));
      ASSERT_EQ(cells.borders.size(), 1u);
      double largest = 0;
      for(double y = 0; y <= 2; y += 1. / 1024)
      {
        // (x - 1)^2 / a^2 - (y - 1)^2 / b^2 = 1 with a = difference / 2 and a^2 + b^2 = 1 / 4
        const double a = difference / 2, squared_b = 0.25 - a * a;
        const double x = 1 + a * std::sqrt(1 + (y - 1) * (y - 1) / squared_b);
        if(x <= 2)
          largest =
              (std::max)(largest, squared_distance_from(mesh, cells.borders[0], Point(x, y, 0)));
      }
      EXPECT_LE(std::sqrt(largest), error * (1 + 1e-9) + 1e-12);
      EXPECT_LE(cells.borders[0].points.size(), 10 + 4 / std::sqrt(error));
    }
}

TEST(VoronoiBorders, runs_along_edges)
{
  const Mesh mesh = to_mesh(octahedron());
  std::vector<Vertex> poles;
  for(const Vertex v : mesh.vertices())
    if(mesh.point(v).z() != 0)
      poles.push_back(v);
  ASSERT_EQ(poles.size(), 2u);
  const Cells cells = AG::voronoi_borders(mesh, poles);
  ASSERT_EQ(cells.borders.size(), 1u);
  EXPECT_TRUE(cells.borders[0].is_closed());
  for(const auto& p : cells.borders[0].points)
    EXPECT_NEAR(position(mesh, p).z(), 0, 1e-12);
  double edges = 0;
  for(const auto e : mesh.edges())
    if(mesh.point(mesh.vertex(e, 0)).z() == 0 && mesh.point(mesh.vertex(e, 1)).z() == 0)
      edges += std::sqrt(
          CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  EXPECT_NEAR(length_of_border(mesh, cells.borders[0]), edges, 1e-9);
  EXPECT_NEAR(cells.areas[0], cells.areas[1], 1e-12);
  EXPECT_EQ(cells.neighbors(), (std::vector<std::array<std::size_t, 2>>{{0, 1}}));
}

TEST(VoronoiBorders, are_found_where_four_cells_meet)
{
  const Mesh mesh = to_mesh(flat_grid(5, 5)); // 4 x 4 cells
  std::vector<Surface_point> sources;
  for(const double y : {1., 3.})
    for(const double x : {1., 3.})
      sources.emplace_back(location_at(mesh, Point(x, y, 0)));
  const Cells cells = AG::voronoi_borders(mesh, sources);
  EXPECT_EQ(cells.borders.size(), 4u);
  EXPECT_EQ(cells.triangles().size(), 2u);
  for(const double area : cells.areas)
    EXPECT_NEAR(area, 4, 1e-12);
  const auto middle = std::find_if(cells.corners.begin(), cells.corners.end(),
                                   [](const auto& c) { return c.sources.size() == 4; });
  ASSERT_NE(middle, cells.corners.end());
  EXPECT_EQ(middle->sources, (std::vector<std::size_t>{0, 1, 3, 2})); // counterclockwise
}

// Two points of three cells each, so close to each other that they are one: no cell is repeated.
TEST(VoronoiBorders, list_cells_once_around_corners_that_are_one)
{
  using Arc = AG::internal::Border_arc;
  const Triangulation triangulation(to_mesh(fan(6)));
  const std::array<double, 3> hub{1, 0, 0}, rim{0, 0.5, 0.5};
  std::vector<Arc> arcs;
  const unsigned center = triangulation.vertex(0);
  for(unsigned h = triangulation.first_halfedge(center); h < triangulation.beyond_halfedge(center);
      ++h)
  {
    const std::size_t i = arcs.size() % 3, first = arcs.size() - i;
    const AG::internal::Face_point from{h, hub}, to{h, rim};
    const unsigned face = triangulation.first_of_face(h);
    Arc arc{face, first + (i == 1 ? 1 : 0), first + (i == 0 ? 1 : 2), {}};
    for(const auto& p : {from, to})
      arc.points.push_back(p.seen_from(triangulation, face).weight);
    if(i != 2) // around the hub, 0, 1 and 2 follow each other, and so do 3, 4 and 5
      std::reverse(arc.points.begin(), arc.points.end());
    arcs.push_back(arc);
  }
  ASSERT_EQ(arcs.size(), 6u);
  const AG::internal::Cell_network network(triangulation, arcs);
  std::size_t number_of_hubs = 0;
  for(const auto& corner : network.corners())
    if(corner.sources.size() > 2)
    {
      ++number_of_hubs;
      EXPECT_EQ(corner.sources, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
    }
  EXPECT_EQ(number_of_hubs, 1u);
}

// The triangle of three points is counterclockwise also where the cells meet at the border.
TEST(VoronoiBorders, are_counterclockwise_around_a_point_of_the_border)
{
  const Mesh mesh = to_mesh(flat_grid(9, 7));
  std::vector<Point> points{Point(2, 1, 0), Point(4, std::sqrt(5.), 0), Point(6, 1, 0)};
  do // the circle through them touches the border at (4, 0)
  {
    std::vector<Surface_point> sources;
    for(const Point& p : points)
      sources.emplace_back(location_at(mesh, p));
    const Cells cells = AG::voronoi_borders(mesh, sources);
    ASSERT_EQ(cells.triangles().size(), 1u);
    const auto [a, b, c] = cells.triangles()[0];
    EXPECT_GT(CGAL::cross_product(points[b] - points[a], points[c] - points[a]).z(), 0);
  } while(std::next_permutation(points.begin(), points.end()));
}

// However small the corner is that it cuts off.
TEST(VoronoiBorders, may_cut_off_a_corner_of_the_surface)
{
  const Mesh mesh = to_mesh(flat_grid(9, 7));
  for(const Vertex v : mesh.vertices())
    for(const double width : {1e-2, 1e-4, 1e-5})
    {
      if(CGAL::degree(v, mesh) > 3 || !mesh.is_border(v))
        continue;
      const Point corner = mesh.point(v);
      const bool is_corner = std::fmod(corner.x(), 8) == 0 && std::fmod(corner.y(), 6) == 0;
      if(!is_corner)
        continue;
      const Point far(4, 3, 0);
      const std::vector<Surface_point> sources{location_at(mesh, far), v};
      const std::vector<double> initial{0, 5 - width}; // the corner is at distance 5
      const Cells cells =
          AG::voronoi_borders(mesh, sources, CGAL::parameters::initial_distances(initial));
      ASSERT_EQ(cells.borders.size(), 1u) << v << " " << width;
      EXPECT_EQ(cells.corners.size(), 2u);
      EXPECT_GT(cells.areas[1], 0);
      for(const auto& p : cells.borders[0].points)
      {
        const Point q = position(mesh, p);
        EXPECT_NEAR(std::sqrt(CGAL::squared_distance(q, far)),
                    initial[1] + std::sqrt(CGAL::squared_distance(q, corner)), 1e-9);
      }
    }
}

TEST(VoronoiBorders, leaves_out_empty_cells)
{
  const Mesh mesh = to_mesh(flat_grid(9, 7));
  const std::vector<Surface_point> sources{location_at(mesh, Point(2.5, 3.5, 0)),
                                           location_at(mesh, Point(2.5, 3.5, 0)),
                                           location_at(mesh, Point(3.5, 3.5, 0)),
                                           location_at(mesh, Point(6.25, 3.5, 0)),
                                           Vertex(20),
                                           Vertex(20)};
  const std::vector<double> initial{0, 0, 1.5, 0.5, 0, 0};
  const Cells cells =
      AG::voronoi_borders(mesh, sources, CGAL::parameters::initial_distances(initial));
  EXPECT_GT(cells.areas[0], 1);
  EXPECT_EQ(cells.areas[1], 0);
  EXPECT_EQ(cells.areas[2], 0);
  EXPECT_GT(cells.areas[3], 1);
  EXPECT_GT(cells.areas[4], 1);
  EXPECT_EQ(cells.areas[5], 0);
  EXPECT_NEAR(total_area(cells), 48, 1e-9);
  for(const auto& border : cells.borders)
    for(const std::size_t source : border.sources)
      EXPECT_GT(cells.areas[source], 0);
  expect_right_cells(mesh, cells, sources, initial);
}

TEST(VoronoiBorders, have_equal_distances_on_generated_meshes)
{
  const std::uint64_t seed = test_seed();
  for(const Named_mesh& named : generated_meshes(seed))
  {
    SCOPED_TRACE(named.name);
    if(named.mesh.number_of_faces() == 0 || named.name == "edges of length zero")
      continue;
    Random random(seed);
    const auto sources = random_sources(named.mesh, 7, random);
    expect_right_cells(named.mesh, AG::voronoi_borders(named.mesh, sources), sources);
    std::vector<double> initial(sources.size());
    for(double& distance : initial)
      distance = random.between(0, 0.1) * size(named.mesh);
    expect_right_cells(
        named.mesh,
        AG::voronoi_borders(named.mesh, sources, CGAL::parameters::initial_distances(initial)),
        sources, initial);
  }
}

TEST(VoronoiBorders, divide_sample_meshes)
{
  for(const char* const name : {"elephant.off", "sphere966.off", "cube-meshed.off", "anchor.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    const std::uint64_t seed = test_seed();
    Random random(seed);
    for(const std::size_t n : {2u, 10u, 100u})
    {
      const auto sources = random_sources(mesh, n, random);
      const Cells cells = AG::voronoi_borders(mesh, sources);
      const double area = CGAL::Polygon_mesh_processing::area(mesh);
      EXPECT_NEAR(total_area(cells), area, 1e-9 * area);
      expect_points_in_faces(mesh, cells);
      if(n < 100)
        expect_right_cells(mesh, cells, sources, {}, 11);
      else if(std::string(name) == "sphere966.off" || std::string(name) == "cube-meshed.off")
        expect_triangulation_of_sphere(cells);
    }
  }
}

bool has_edge_without_length(const Mesh& mesh)
{
  const auto edges = mesh.edges();
  return std::any_of(edges.begin(), edges.end(), [&](const auto e) {
    return mesh.point(mesh.vertex(e, 0)) == mesh.point(mesh.vertex(e, 1));
  });
}

// Nothing if areas would be wrong.
template <typename F>
std::optional<Cells> cells_or_refusal(const F& find)
{
  try
  {
    return find();
  }
  catch(const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("areas of cells do not add up in the face with vertices"),
              std::string::npos)
        << e.what();
    return std::nullopt;
  }
}

// A unit square with a vertex very close to a corner. Its cells have the right areas, or are
// refused.
TEST(VoronoiBorders, have_areas_that_add_up_beside_vertices_that_nearly_coincide)
{
  std::size_t number_found = 0, number_refused = 0;
  for(double size = 1e-1; size > 1e-16; size /= 3)
  {
    SCOPED_TRACE(size);
    const Mesh mesh =
        to_mesh(Soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.5 * size, 0.5 * size, 0}},
                     {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}}});
    const auto expect_right = [&](const auto& find) {
      const std::optional<Cells> cells = cells_or_refusal(find);
      ++(cells ? number_found : number_refused);
      if(cells)
      {
        EXPECT_NEAR(total_area(*cells), 1, 1e-6);
        EXPECT_GE(*std::min_element(cells->areas.begin(), cells->areas.end()), 0);
      }
    };
    const auto face = [&](const int i) { return *std::next(mesh.faces().begin(), i); };
    const Face_location p{face(3), {0.17, 0.56, 0.27}}, q{face(1), {0.3, 0.5, 0.2}};
    expect_right([&] { return AG::cut_locus(mesh, p); });
    expect_right([&] { return AG::voronoi_borders(mesh, std::vector<Face_location>{p, q}); });
  }
  EXPECT_GT(number_found, 20u);
  EXPECT_GT(number_refused, 0u);
}

// Each of many windows of one face is divided by itself.
TEST(VoronoiBorders, are_interrupted_within_a_face)
{
  const Mesh mesh = to_mesh(flat_grid(2, 2));
  std::vector<Face_location> sources;
  Random random(test_seed());
  for(int i = 0; i < 200; ++i)
  {
    const double s = random.between(0.1, 0.5), t = random.between(0.1, 0.4);
    sources.push_back({*mesh.faces().begin(), {1 - s - t, s, t}});
  }
  for(const int number : {0, 5, 200, 350})
  {
    const Interruption_at interruption(number);
    EXPECT_THROW(AG::voronoi_borders(mesh, sources), std::runtime_error);
  }
}

// Faces that are nearly degenerate are not divided, so that borders may be missing there.
TEST(VoronoiBorders, are_numbers_on_hostile_meshes)
{
  for(const Hostile_mesh& hostile : accepted_meshes())
  {
    SCOPED_TRACE(hostile.name);
    for(const auto& sources : {some_vertices(hostile.mesh), some_points(hostile.mesh)})
      for(const bool is_locus : {false, true})
      {
        if(!hostile.refusal_across_faces.empty())
          continue;
        if(has_edge_without_length(hostile.mesh))
        {
          expect_message<std::invalid_argument>([&] { AG::voronoi_borders(hostile.mesh, sources); },
                                                "the edge between vertices", "has no length");
          continue;
        }
        const std::optional<Cells> found = cells_or_refusal([&] {
          return is_locus ? AG::cut_locus(hostile.mesh, sources)
                          : AG::voronoi_borders(hostile.mesh, sources);
        });
        if(!found)
          continue;
        const Cells& cells = *found;
        for(const double area : cells.areas)
          EXPECT_GE(area, 0); // infinite if it exceeds the largest number
        for(const auto& border : cells.borders)
          for(const auto& [face, weights] : border.points)
            EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, 1e-12);
      }
  }
}

TEST(VoronoiBorders, are_right_on_hostile_meshes_without_thin_faces)
{
  for(const Hostile_mesh& hostile : accepted_meshes())
  {
    SCOPED_TRACE(hostile.name);
    const auto is_any_of = [&](const std::vector<std::string>& parts) {
      return std::any_of(parts.begin(), parts.end(), [&](const std::string& part) {
        return hostile.name.find(part) != std::string::npos;
      });
    };
    if(is_any_of({"needles", "caps", "area", "zero", "place", "lying", "spike", "1e12", "from 1e",
                  "coordinates", "far from", "size"}) ||
       has_edge_without_length(hostile.mesh))
      continue;
    for(const auto& sources : {some_vertices(hostile.mesh), some_points(hostile.mesh)})
      if(!sources.empty())
        expect_right_cells(hostile.mesh, AG::voronoi_borders(hostile.mesh, sources), sources);
  }
}

TEST(VoronoiBorders, rejects_bad_input)
{
  const Mesh mesh = quiet_mesh();
  for(const double error : {0., -1., not_a_number})
    expect_message<std::invalid_argument>(
        [&] { AG::voronoi_borders(mesh, Vertex(0), CGAL::parameters::chord_error(error)); },
        "chord error", "positive");
  expect_message<std::invalid_argument>(
      [&] {
        AG::voronoi_borders(mesh, std::vector<Vertex>{Vertex(0), Vertex(99)});
      },
      "source");
  const Cells cells = AG::voronoi_borders(mesh, std::vector<Vertex>());
  EXPECT_TRUE(cells.areas.empty());
  EXPECT_TRUE(cells.borders.empty());
}

TEST(CutLocus, of_a_plane_is_empty)
{
  const Mesh mesh = to_mesh(flat_grid(9, 7));
  const Cells cells = AG::cut_locus(mesh, location_at(mesh, Point(2.3, 3.1, 0)));
  EXPECT_TRUE(cells.borders.empty());
  EXPECT_NEAR(total_area(cells), 48, 1e-9);
}

TEST(CutLocus, of_a_polyhedron_is_a_tree_with_convex_vertices_as_leaves)
{
  for(const char* const name : {"cube.off", "tetrahedron.off", "icosahedron.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    const Face_location source(Face(0), {0.25, 0.35, 0.4});
    const Cells cells = AG::cut_locus(mesh, source);
    std::map<std::size_t, int> degrees;
    for(const auto& border : cells.borders)
      for(const std::size_t corner : border.corners)
        ++degrees[corner];
    EXPECT_EQ(degrees.size(), cells.borders.size() + 1);
    std::set<Point> leaves;
    for(const auto& [corner, degree] : degrees)
      if(degree == 1)
      {
        const Point p = position(mesh, cells.corners[corner].point);
        double nearest = 1e10;
        for(const Vertex v : mesh.vertices())
          nearest = (std::min)(nearest, CGAL::squared_distance(p, mesh.point(v)));
        EXPECT_LT(nearest, 1e-14);
        leaves.insert(p);
      }
    EXPECT_EQ(leaves.size(), mesh.number_of_vertices());
    const double area = CGAL::Polygon_mesh_processing::area(mesh);
    EXPECT_NEAR(total_area(cells), area, 1e-9 * area);
  }
}

} // namespace
