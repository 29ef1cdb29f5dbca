// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_constructions/shorten_loop.h>

#include "checks/expect_message.h"
#include "meshes/developed_surfaces.h"
#include "meshes/hostile_meshes.h"
#include "meshes/random_soups.h"
#include "meshes/sample_meshes.h"
#include "paths/closed_curves.h"

#include <CGAL/Curves_on_surface_topology.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Loops that are shortened, and shortest loops through a point.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Loop = AG::Geodesic_loop<Mesh>;

const double circle = 8 * std::atan(1.);

// A closed polyline in terms of the mesh that is locally shortest, and has its length.
void expect_geodesic(const Mesh& mesh, const Loop& loop)
{
  ASSERT_GT(loop.points.size(), 2u);
  EXPECT_EQ(loop.points.front(), loop.points.back());
  EXPECT_NEAR(length_of(mesh, loop.points), loop.length, 1e-12 * loop.length);
  EXPECT_LT(largest_slack(mesh, loop.points), 1e-9 * loop.length);
}

double length_of_halfedges(const Mesh& mesh, const std::vector<Halfedge>& curve)
{
  double result = 0;
  for(const Halfedge h : curve)
    result += length_of(mesh, {mesh.source(h), mesh.target(h)});
  return result;
}

// ----- closed forms

// A loop once around a mesh whose vertices are in rings, that changes between rings.
std::vector<Vertex> winding_loop(const std::size_t columns, const std::size_t rings, Random& random)
{
  std::vector<Vertex> result;
  const std::size_t first = random.below(rings);
  std::size_t j = first;
  const auto add = [&](const std::size_t i) {
    result.push_back(Vertex(static_cast<Mesh::size_type>(i % columns + columns * j)));
  };
  for(std::size_t i = 0; i < columns; ++i)
  {
    add(i);
    for(std::size_t steps = random.below(3); steps > 0; --steps)
    {
      j = random.below(2) == 0 ? j + (j + 1 < rings ? 1 : 0) : j - (j > 0 ? 1 : 0);
      add(i);
    }
  }
  for(add(columns); j != first; add(columns))
    j += j < first ? 1 : std::size_t(-1);
  return result;
}

template <typename F>
void on_developed(const Developed_surface& surface, F f)
{
  const Developed_mesh m(surface);
  const std::vector<double> lengths = lengths_of(surface, m.mesh);
  f(m.mesh, CGAL::parameters::edge_length_map(boost::make_iterator_property_map(
                lengths.begin(), get(boost::edge_index, m.mesh))));
}

TEST(Loops, around_a_cylinder_have_its_circumference)
{
  Random random(test_seed());
  for(int i = 0; i < 20; ++i)
    on_developed(cylinder(9, 6, 0.8, 0.7, random), [&](const Mesh& mesh, const auto& np) {
      const Loop loop = AG::shorten_loop(mesh, winding_loop(9, 7, random), np);
      EXPECT_NEAR(loop.length, 9 * 0.8, 1e-11);
      const Loop shortest = AG::shortest_loop_through(mesh, random_face_location(mesh, random), np);
      EXPECT_NEAR(shortest.length, 9 * 0.8, 1e-11);
    });
}

TEST(Loops, around_a_cylinder_twice_have_twice_its_circumference)
{
  Random random(test_seed());
  on_developed(cylinder(5, 4, 0.8, 0.7, random), [&](const Mesh& mesh, const auto& np) {
    std::vector<Vertex> twice = winding_loop(5, 5, random);
    twice.insert(twice.end(), twice.begin(), twice.end());
    EXPECT_NEAR(AG::shorten_loop(mesh, twice, np).length, 8, 1e-11);
  });
}

// The shortest vector of the lattice.
double shortest_vector(const Place& u, const Place& v)
{
  double result = std::numeric_limits<double>::infinity();
  for(int i = -9; i <= 9; ++i)
    for(int j = -9; j <= 9; ++j)
      if(i != 0 || j != 0)
        result = (std::min)(result,
                            static_cast<double>(std::hypot(i * u.x + j * v.x, i * u.y + j * v.y)));
  return result;
}

TEST(Loops, on_a_flat_torus_are_vectors_of_its_lattice)
{
  Random random(test_seed());
  int number_of_shortest = 0;
  for(int i = 0; i < 40; ++i)
  {
    const std::size_t columns = 3 + random.below(6), rows = 3 + random.below(6);
    const Place u{random.between(2, 5), random.between(-1, 1)},
        v{random.between(-3, 3), random.between(2, 5)};
    on_developed(flat_torus(columns, rows, u, v, random), [&](const Mesh& mesh, const auto& np) {
      const Loop loop = AG::shorten_loop(mesh, winding_loop(columns, rows, random), np);
      EXPECT_NEAR(loop.length, static_cast<double>(std::hypot(u.x, u.y)), 1e-11);
      const Loop shortest = AG::shortest_loop_through(mesh, random_surface_point(mesh, random), np);
      EXPECT_GT(shortest.length, shortest_vector(u, v) - 1e-11);
      number_of_shortest += shortest.length < shortest_vector(u, v) + 1e-11 ? 1 : 0;
    });
  }
  EXPECT_GE(number_of_shortest, 36); // edges of coarse meshes can miss the class
}

TEST(Loops, around_the_hole_of_a_torus_are_its_inner_polygon)
{
  for(const auto& [n, m] : {std::pair(12, 8), std::pair(31, 20), std::pair(48, 30)})
  {
    const Mesh mesh =
        to_mesh(torus(std::size_t(n), std::size_t(m), 3, 1)); // j + m i: m / 2 is inside
    std::vector<Vertex> outer;
    for(int i = 0; i < n; ++i)
      outer.push_back(Vertex(static_cast<Mesh::size_type>(i * m)));
    const Loop loop = AG::shorten_loop(mesh, outer);
    EXPECT_NEAR(loop.length, 2 * n * 2 * std::sin(circle / 2 / n), 1e-11);
    expect_geodesic(mesh, loop);
    const Loop shortest = AG::shortest_loop_through(mesh, Vertex(0));
    EXPECT_LE(shortest.length, 2 * m * std::sin(circle / 2 / m) + 1e-12);
  }
}

// A surface of revolution around the z axis, of length 10, with rings of 24 vertices.
template <typename F>
Mesh tube(const std::size_t rings, F radius)
{
  Soup result = closed_rings(rings, 24, [&](const double i, const double j) {
    const double part = i / static_cast<double>(rings - 1), r = radius(part);
    return Point(r * std::cos(circle * j / 24), r * std::sin(circle * j / 24), 10 * part);
  });
  result.triangles.resize(2 * 24 * (rings - 1)); // open
  return to_mesh(result);
}

// However little the radius changes, they get there.
TEST(Loops, slide_to_the_narrowest_place)
{
  const auto length_from_wide_end = [](const auto& radius) {
    const Mesh mesh = tube(101, radius);
    std::vector<Vertex> ring;
    for(Mesh::size_type v = 24; v < 48; ++v)
      ring.push_back(Vertex(v));
    return AG::shorten_loop(mesh, ring).length / (48 * std::sin(circle / 48));
  };
  EXPECT_NEAR(length_from_wide_end([](double z) { return 1 - 0.1 * z; }), 0.9, 1e-12);
  EXPECT_NEAR(length_from_wide_end([](double z) { return 1 - 1e-5 * z; }), 1 - 1e-5, 1e-12);
  EXPECT_NEAR(length_from_wide_end([](double z) { return 0.7 + std::pow(z - 0.5, 2); }), 0.7,
              1e-12);
  EXPECT_NEAR(length_from_wide_end([](double z) { return std::sqrt(1.01 - z * z); }), 0.1, 1e-12);
}

TEST(Loops, that_take_too_many_steps_are_reported)
{
  const Mesh mesh = tube(41, [](const double z) { return 1 - 0.5 * z; });
  const Triangulation t(mesh);
  AG::Path ring;
  for(std::size_t i = 0; i <= 24; ++i)
    ring.points.push_back(AG::Intrinsic_point::at_vertex(t.vertex(24 + i % 24)));
  EXPECT_NEAR(AG::Loop_straightener(t).shortened(ring).length, 24 * std::sin(circle / 48), 1e-12);
  expect_message<std::runtime_error>([&] { AG::Loop_straightener(t, 0).shortened(ring); },
                                     "the loop is not locally shortest after 0 steps");
}

// It touches the corners of the hole.
TEST(Loops, around_a_hole_end_at_the_border)
{
  Random random(test_seed());
  Soup soup = grid(9, 9, [&](const double i, const double j) { return Point(i, j, 0); });
  const auto is_cut = [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](const std::size_t v) {
      const Point& p = soup.points[v];
      return p.x() >= 3 && p.x() <= 6 && p.y() >= 2 && p.y() <= 4;
    });
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_cut),
                       soup.triangles.end());
  const Mesh mesh = to_mesh(soup);
  std::vector<Halfedge> border;
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h) && mesh.source(h) == Vertex(0))
      for(Halfedge g = h; border.empty() || g != h; g = mesh.next(g))
        border.push_back(g);
  const Loop loop = AG::shorten_loop(mesh, border);
  EXPECT_NEAR(loop.length, 10, 1e-12);
  EXPECT_LT(largest_slack(mesh, loop.points), 1e-11);
  EXPECT_NEAR(AG::shortest_loop_through(mesh, Vertex(0)).length, // along two tangents
              std::hypot(6, 2) + 2 + 3 + std::hypot(3, 4), 1e-12);
}

// ----- loops that contract

TEST(Loops, contract_to_a_point_on_a_sphere_and_a_disk)
{
  Random random(test_seed());
  for(const Mesh& mesh : {to_mesh(sphere(24, 15)), to_mesh(terrain(14, 12, random))})
    for(int i = 0; i < 60; ++i)
    {
      const std::vector<Halfedge> curve = random_closed_curve(mesh, random, 1 + random.below(60));
      const Loop loop = AG::shorten_loop(mesh, curve);
      const bool is_geodesic = loop.points.size() > 2 && largest_slack(mesh, loop.points) < 1e-9;
      EXPECT_TRUE(loop.is_point() || is_geodesic); // terrain may have necks
      EXPECT_EQ(loop.length == 0, loop.is_point());
      const Loop none = AG::shortest_loop_through(mesh, random_surface_point(mesh, random));
      EXPECT_TRUE(none.points.empty() && std::isinf(none.length));
    }
}

TEST(Loops, of_one_point_or_one_face_are_points)
{
  const Mesh mesh = to_mesh(sphere(12, 9));
  EXPECT_TRUE(AG::shorten_loop(mesh, std::vector<Vertex>{Vertex(3)}).is_point());
  for(const Face f : mesh.faces())
  {
    const std::vector<Face_location> inside{
        {f, {0.2, 0.3, 0.5}}, {f, {0.7, 0.1, 0.2}}, {f, {0.1, 0.8, 0.1}}};
    EXPECT_TRUE(AG::shorten_loop(mesh, inside).is_point());
    std::vector<Halfedge> sides;
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      sides.push_back(h);
    EXPECT_TRUE(AG::shorten_loop(mesh, sides).is_point());
  }
}

// Around the apex of a cone, where its angle is less than pi, and each loop has a corner.
TEST(Loops, slip_off_a_spike)
{
  Random random(test_seed());
  for(const double total_angle : {0.05, 0.7, 2., 3.})
    on_developed(cone(5, total_angle, 0.2, random), [&](const Mesh& mesh, const auto& np) {
      std::vector<Halfedge> border;
      for(const Halfedge h : mesh.halfedges())
        if(mesh.is_border(h) && border.empty())
          for(Halfedge g = h; border.empty() || g != h; g = mesh.next(g))
            border.push_back(g);
      const Loop loop = AG::shorten_loop(mesh, border, np);
      EXPECT_TRUE(loop.is_point());
    });
}

// ----- surfaces with handles

std::vector<Named_mesh> meshes_with_handles(Random& random)
{
  const auto noisy = [&](const Soup& soup, const double size) {
    return to_mesh(soup.transformed([&](const Point& p) {
      return p + Kernel::Vector_3(random.between(-size, size), random.between(-size, size),
                                  random.between(-size, size));
    }));
  };
  std::vector<Named_mesh> result{{"coarse torus", to_mesh(torus(3, 3, 3, 1))},
                                 {"torus", to_mesh(torus(24, 15, 3, 1))},
                                 {"thin torus", to_mesh(torus(60, 5, 3, 0.1))},
                                 {"fat torus", to_mesh(torus(20, 40, 3, 2.9))},
                                 {"noisy torus", noisy(torus(24, 15, 3, 1), 0.2)},
                                 {"knot", to_mesh(torus_knot(120, 9))},
                                 {"noisy knot", noisy(torus_knot(120, 9), 0.05)}};
#ifdef CGAL_DATA_DIR
  for(const char* const name : {"knot1", "holes", "rotor", "pipe", "anchor", "eight",
                                "couplingdown", "joint", "elephant-with-holes", "helmet"})
    result.push_back({name, sample_mesh(name + std::string(".off"))});
#endif
  return result;
}

struct Length_of_halfedge
{
  using Weight_t = double;

  double operator()(const Halfedge h) const
  {
    return std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  }

  const Mesh& mesh;
};

std::vector<Halfedge> halfedges_of(const CGAL::Surface_mesh_topology::Path_on_surface<Mesh>& path)
{
  std::vector<Halfedge> result;
  for(std::size_t i = 0; i < path.length(); ++i)
    result.push_back(path.get_ith_real_dart(i));
  return result;
}

TEST(Loops, are_never_longer_than_cycles_of_edges)
{
  Random random(test_seed());
  for(const Named_mesh& named : meshes_with_handles(random))
  {
    SCOPED_TRACE(named.name);
    const Mesh& mesh = named.mesh;
    const Length_of_halfedge length{mesh};
    const CGAL::Surface_mesh_topology::Curves_on_surface_topology<Mesh> topology(mesh);
    const auto check = [&](const std::vector<Halfedge>& cycle) {
      double sum = 0;
      for(const Halfedge h : cycle)
        sum += length(h);
      const Loop loop = AG::shorten_loop(mesh, cycle);
      EXPECT_LE(loop.length, sum * (1 + 1e-12));
      expect_geodesic(mesh, loop);
      return sum;
    };
    if(mesh.number_of_vertices() < 600) // it is quadratic
      check(halfedges_of(topology.compute_shortest_non_contractible_cycle(length)));
    for(int i = 0; i < 2; ++i)
    {
      const Vertex v = random_vertex(mesh, random);
      const double cycle =
          check(halfedges_of(topology.compute_shortest_non_contractible_cycle_with_base_point(
              mesh.opposite(mesh.halfedge(v)), length)));
      const Loop through = AG::shortest_loop_through(mesh, v);
      EXPECT_LE(through.length, cycle * (1 + 1e-12));
      EXPECT_NEAR(length_of(mesh, through.points), through.length, 1e-12 * cycle);
      EXPECT_EQ(through.points.front(), Surface_point(v));
      EXPECT_EQ(through.points.back(), Surface_point(v));
    }
  }
}

TEST(Loops, of_any_class_are_shortened_to_geodesics)
{
  Random random(test_seed());
  for(const Named_mesh& named : meshes_with_handles(random))
  {
    SCOPED_TRACE(named.name);
    for(int i = 0; i < 5; ++i)
    {
      const std::vector<Halfedge> curve =
          random_closed_curve(named.mesh, random, 1 + random.below(200));
      const Loop loop = AG::shorten_loop(named.mesh, curve);
      if(!loop.is_point())
        expect_geodesic(named.mesh, loop);
    }
  }
}

// In a flat cap, both ends of its longest side and the vertex on it are on the same line.
void check_loop_across_caps(const int times_with_caps, Random& random)
{
  const std::size_t around = 3 + random.below(12), across = 3 + random.below(9);
  Soup soup = torus(around, across, 3, 1);
  for(int i = 0; i < times_with_caps; ++i)
    soup = with_caps(soup, [&] { return random.between(1e-9, 0.3); });
  const Mesh mesh = to_mesh(soup);
  const std::vector<Halfedge> curve = random_closed_curve(mesh, random, 1 + random.below(300));
  const Loop loop = AG::shorten_loop(mesh, curve);
  EXPECT_LE(loop.length, length_of_halfedges(mesh, curve));
  if(!loop.is_point())
    expect_geodesic(mesh, loop);
}

TEST(Loops, across_flat_caps_are_geodesics)
{
  Random random(test_seed());
  for(int i = 0; i < 200; ++i)
    check_loop_across_caps(1 + i % 2, random);
}

// A path around the tip of a cap may make a full turn. Two of these loops stay bent if rounding can
// take it for none.
TEST(Loops, make_full_turns_around_tips_of_caps)
{
  Random random(2);
  for(int i = 0; i < 200; ++i)
    check_loop_across_caps(1, random);
}

// A loop does not depend on where it begins.
TEST(Loops, through_points_of_a_loop_are_not_longer)
{
  Random random(test_seed());
  for(const Named_mesh& named : meshes_with_handles(random))
  {
    SCOPED_TRACE(named.name);
    const Loop loop =
        AG::shortest_loop_through(named.mesh, random_face_location(named.mesh, random));
    std::vector<Surface_point> points = loop.points;
    points.pop_back();
    const std::size_t middle = points.size() / 2;
    EXPECT_LE(AG::shortest_loop_through(named.mesh, points[middle]).length,
              loop.length * (1 + 1e-9));
    const Loop shortened = AG::shorten_loop(named.mesh, points);
    EXPECT_LE(shortened.length, loop.length * (1 + 1e-12));
    expect_geodesic(named.mesh, shortened);
  }
}

// ----- properties on any surface

TEST(Loops, on_hostile_meshes_end_and_are_not_longer_than_before)
{
  Random random(test_seed());
  for(const Hostile_mesh& row : accepted_meshes())
  {
    SCOPED_TRACE(row.name);
    const Mesh& mesh = row.mesh;
    if(!row.refusal_across_faces.empty() || mesh.number_of_halfedges() == 0)
      continue;
    for(int i = 0; i < 10; ++i)
    {
      const std::vector<Halfedge> curve = random_closed_curve(mesh, random, 1 + random.below(40));
      const double length = length_of_halfedges(mesh, curve);
      const Loop loop = AG::shorten_loop(mesh, curve);
      EXPECT_TRUE(loop.length >= 0 && loop.length <= length * (1 + 1e-9));
      EXPECT_FALSE(loop.points.empty());
      for(std::size_t k = 1; k < loop.points.size(); ++k)
        EXPECT_TRUE(mesh.number_of_faces() == 0 ||
                    share_a_face(mesh, loop.points[k - 1], loop.points[k]));
    }
    for(const Surface_point& p : some_points(mesh))
    {
      const Loop loop = AG::shortest_loop_through(mesh, p);
      EXPECT_TRUE(loop.length >= 0);
      EXPECT_EQ(loop.points.empty(), std::isinf(loop.length));
    }
  }
}

// ----- bad input

TEST(Loops, reject_bad_input)
{
  const Mesh mesh = quiet_mesh();
  const auto expect = [&](const auto& curve, const std::string& text) {
    expect_message<std::invalid_argument>([&] { AG::shorten_loop(mesh, curve); }, text);
  };
  expect(std::vector<Vertex>(), "the loop has no points");
  expect(std::vector<Vertex>{Vertex(0), Vertex(1), Vertex(19)},
         "points 1 and 2 of the loop, counted from 0, lie in no common face");
  expect(std::vector<Vertex>{Vertex(0), Vertex(1), Vertex(2)},
         "points 2 and 0 of the loop, counted from 0, lie in no common face");
  expect(std::vector<Vertex>{Vertex(0), Vertex(99)}, "point of the loop 1 (counted from 0)");
  const Halfedge h = mesh.halfedge(Vertex(0), Vertex(1));
  expect(std::vector<Halfedge>{h, mesh.next(h)}, "halfedge 1 (counted from 0) does not end where");
  expect(std::vector<Halfedge>{h, Halfedge(9999)}, "halfedge 1 (counted from 0)");
  expect_message<std::invalid_argument>([&] { AG::shortest_loop_through(mesh, Vertex(99)); },
                                        "point: vertex 99 is not in the mesh");
}

} // namespace
