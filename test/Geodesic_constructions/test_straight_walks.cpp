// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_constructions/trace_geodesic.h>

#include "checks/expect_message.h"
#include "meshes/developed_surfaces.h"
#include "meshes/hostile_meshes.h"
#include "meshes/random_soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

// Walks straight ahead, and vectors that are transported.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Tangent_vector;
using Space_vector = Kernel::Vector_3;
using Walk = AG::Geodesic_walk<Mesh>;

const double pi = 4 * std::atan(1.);

Tangent_vector at_angle(const double angle, const double length = 1)
{
  return {length * std::cos(angle), length * std::sin(angle)};
}

double angle_between(const Tangent_vector& a, const Tangent_vector& b)
{
  return std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

Tangent_vector opposite(const Tangent_vector& v) { return {-v.x, -v.y}; }

double gap(const Mesh& mesh, const Surface_point& p, const Point& q)
{
  return std::sqrt(CGAL::squared_distance(position(mesh, p), q));
}

Mesh unit_cube()
{
  Soup result;
  for(std::size_t i = 0; i < 8; ++i)
    result.points.push_back(Point(i % 2, i / 2 % 2, i / 4));
  for(const auto& [a, b, c, d] : std::vector<std::array<std::size_t, 4>>{
          {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
  {
    result.triangles.push_back({a, b, c});
    result.triangles.push_back({a, c, d});
  }
  return to_mesh(result);
}

// ----- closed forms

TEST(StraightWalks, in_a_plane_are_segments)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(grid(12, 9, [&](const double i, const double j) {
    // less than a quarter, so that no face is folded over
    return Point(i + random.between(-0.2, 0.2), j + random.between(-0.2, 0.2), 0);
  }));
  const AG::Geodesic_tracer tracer(mesh);
  for(int i = 0; i < 300; ++i)
  {
    const Surface_point start = random_surface_point(mesh, random);
    const double angle = random.between(0, 2 * pi), length = random.between(0, 8);
    const Space_vector way(std::cos(angle), std::sin(angle), 0);
    const Tangent_vector tangent = tracer.tangent_vector(start, way);
    if(tangent.x == 0 && tangent.y == 0)
      continue;
    const Walk walk = tracer.trace(start, way, length);
    EXPECT_TRUE(walk.meets_border || walk.length == length);
    EXPECT_NEAR(length_of(mesh, walk.points), walk.length, 1e-12);
    const Space_vector first = tracer.vector_3(start, tangent);
    if(CGAL::scalar_product(first, way) > 1 - 1e-9) // else, it was projected to the border
    {
      EXPECT_LT(gap(mesh, walk.points.back(), position(mesh, start) + walk.length * way), 1e-11);
      if(!walk.meets_border)
      {
        const Space_vector last = tracer.vector_3(walk.points.back(), walk.direction);
        EXPECT_LT(std::sqrt((last - way).squared_length()), 1e-11);
      }
    }
  }
}

// A surface without coordinates, with its planes.
class Developed_walks
{
  using Length_map =
      boost::iterator_property_map<std::vector<double>::const_iterator,
                                   boost::property_map<Mesh, boost::edge_index_t>::const_type>;
  using Parameters = decltype(CGAL::parameters::edge_length_map(std::declval<const Length_map&>()));

public:
  explicit Developed_walks(Developed_surface surface)
    : m(std::move(surface)), m_lengths(lengths_of(m.surface, m.mesh))
  {
  }

  Walk walk(const Face_location& start, const double angle, const double length) const
  {
    const auto& corners = m.surface.places[start.first.idx()];
    const Long x = corners[1].x - corners[0].x, y = corners[1].y - corners[0].y;
    return trace(start, at_angle(angle - static_cast<double>(std::atan2(y, x))), length);
  }

  template <typename Start>
  Walk trace(const Start& start, const Tangent_vector& direction, const double length) const
  {
    return AG::trace_geodesic(m.mesh, start, direction, length, parameters());
  }

  template <typename Path>
  Tangent_vector transport(const Path& path, const Tangent_vector& vector) const
  {
    return AG::parallel_transport(m.mesh, path, vector, parameters());
  }

  Face_location location(const Surface_point& p) const
  {
    if(const auto* const v = std::get_if<Vertex>(&p))
      return m.corner(*v);
    if(const auto* const location = std::get_if<Face_location>(&p))
      return *location;
    const auto& [h, t] = std::get<Edge_location>(p);
    return m.mesh.is_border(h)
               ? AG::internal::location_in_face(m.mesh.opposite(h), 1 - t, 0, m.mesh)
               : AG::internal::location_in_face(h, t, 0, m.mesh);
  }

  Place place(const Surface_point& p) const { return m.place(location(p)); }

  const Developed_mesh m;

private:
  Parameters parameters() const
  {
    return CGAL::parameters::edge_length_map(
        Length_map(m_lengths.begin(), get(boost::edge_index, m.mesh)));
  }

  const std::vector<double> m_lengths;
};

// Inside faces, where the frame is that of the layout.
Face_location inner_location(const Mesh& mesh, Random& random)
{
  Face_location result = random_face_location(mesh, random);
  for(double& weight : result.second)
    weight = (weight + 0.01) / 1.03;
  return result;
}

void expect_straight(const Developed_walks& walks, Random& random)
{
  for(int i = 0; i < 100; ++i)
  {
    const Face_location start = inner_location(walks.m.mesh, random);
    const double angle = random.between(0, 2 * pi), length = random.between(0, 10);
    const Walk walk = walks.walk(start, angle, length);
    Place end = walks.m.place(start);
    end.x += walk.length * std::cos(angle);
    end.y += walk.length * std::sin(angle);
    EXPECT_LT(walks.m.surface.distance(end, walks.place(walk.points.back())), 1e-11);
    EXPECT_TRUE(walk.meets_border || walk.length == length);
  }
}

TEST(StraightWalks, on_a_flat_torus_are_straight)
{
  Random random(test_seed());
  const Developed_walks walks(flat_torus(9, 7, {5, 1}, {-1, 4}, random));
  expect_straight(walks, random);
}

TEST(StraightWalks, on_a_cylinder_are_straight_and_end_at_its_border)
{
  Random random(test_seed());
  const Developed_walks walks(cylinder(9, 5, 0.8, 0.7, random));
  expect_straight(walks, random);
  for(int i = 0; i < 50; ++i)
  {
    const Face_location start = inner_location(walks.m.mesh, random);
    const double angle = random.between(0.3, pi - 0.3);
    const Walk walk = walks.walk(start, angle, 1e6);
    EXPECT_TRUE(walk.meets_border);
    const double to_border = 3.5 - static_cast<double>(walks.m.place(start).y);
    EXPECT_NEAR(walk.length, to_border / std::sin(angle), 1e-11);
  }
}

TEST(StraightWalks, on_a_cone_are_straight_where_it_is_unrolled)
{
  Random random(test_seed());
  for(const double total_angle : {0.7, 2., 5., 2 * pi, 7.5, 14.})
  {
    const Developed_walks walks(cone(5, total_angle, 0.2, random));
    for(int i = 0; i < 60; ++i)
    {
      const Face_location start = inner_location(walks.m.mesh, random);
      const double angle = random.between(0, 2 * pi);
      const Walk walk = walks.walk(start, angle, random.between(0, 6));
      const Place p = walks.m.place(start);
      const double x = static_cast<double>(p.x), y = static_cast<double>(p.y);
      const double end_x = x + walk.length * std::cos(angle),
                   end_y = y + walk.length * std::sin(angle);
      const double turn = std::atan2(x * end_y - y * end_x, x * end_x + y * end_y);
      const double r = std::hypot(end_x, end_y),
                   first = static_cast<double>(p.plane) + std::atan2(y, x);
      // modulo the total angle, which `distance` takes
      const Place end{r, 0, first + turn + 4 * Long(total_angle)};
      EXPECT_LT(walks.m.surface.distance(end, walks.place(walk.points.back())), 1e-10)
          << total_angle;
    }
  }
}

TEST(StraightWalks, around_a_cube_come_back_to_their_start)
{
  const Mesh cube = unit_cube();
  const AG::Geodesic_tracer tracer(cube);
  for(const Halfedge h : cube.halfedges())
  {
    const double edge =
        std::sqrt(CGAL::squared_distance(cube.point(cube.source(h)), cube.point(cube.target(h))));
    if(edge > 1.1) // a diagonal of a side
      continue;
    const Edge_location middle(h, 0.5), other(h, 0.3);
    // across four sides, and across all six
    for(const auto& [start, angle, length] :
        {std::tuple(other, pi / 2, 4.), std::tuple(middle, pi / 4, 3 * std::sqrt(2.)),
         std::tuple(middle, 3 * pi / 4, 3 * std::sqrt(2.))})
    {
      const Walk walk = tracer.trace(start, at_angle(angle), length);
      EXPECT_LT(gap(cube, walk.points.back(), position(cube, start)), 1e-12);
      EXPECT_EQ(walk.length, length);
      const Space_vector first = tracer.vector_3(start, at_angle(angle)),
                         last = tracer.vector_3(walk.points.back(), walk.direction);
      EXPECT_NEAR(first.squared_length(), last.squared_length(), 1e-9);
      const auto beyond = [&cube, &tracer](const auto& from, const double way,
                                           const double further) {
        return position(cube, tracer.trace(from, at_angle(way), further).points.back());
      };
      EXPECT_LT(std::sqrt(CGAL::squared_distance(beyond(start, angle, length + 0.25),
                                                 beyond(start, angle, 0.25))),
                1e-12);
    }
  }
}

// Half the angle of the vertex on each side.
TEST(StraightWalks, leave_the_same_angle_on_both_sides_of_a_vertex)
{
  Random random(test_seed());
  for(const double total_angle : {0.7, 5., 2 * pi, 7.5, 14.})
  {
    const Developed_walks walks(cone(4, total_angle, 0.2, random));
    const double scale = 2 * pi / total_angle;
    for(int i = 0; i < 20; ++i)
    {
      const double angle = random.between(0, 2 * pi); // scaled
      const Walk away = walks.trace(Vertex(0), at_angle(angle), 2.5);
      const Walk through = walks.trace(away.points.back(), opposite(away.direction), 5);
      const Walk beyond = walks.trace(Vertex(0), at_angle(angle + pi), 2.5);
      EXPECT_LT(walks.m.surface.distance(walks.place(through.points.back()),
                                         walks.place(beyond.points.back())),
                1e-9)
          << total_angle << ' ' << scale;
      EXPECT_TRUE(
          std::count(through.points.begin(), through.points.end(), Surface_point(Vertex(0))) == 1);
    }
  }
}

// ----- at the border

TEST(StraightWalks, go_on_along_a_straight_border_and_end_at_its_corner)
{
  const Mesh mesh = to_mesh(flat_grid(9, 6));
  const AG::Geodesic_tracer tracer(mesh);
  const Walk walk = tracer.trace(Vertex(1), Space_vector(1, 0, 0), 100);
  EXPECT_TRUE(walk.meets_border);
  EXPECT_EQ(walk.length, 7);
  EXPECT_EQ(walk.points.back(), Surface_point(Vertex(8)));
  const Walk back = tracer.trace(Vertex(8), Space_vector(-1, 0, 0), 6.5);
  EXPECT_FALSE(back.meets_border);
  EXPECT_LT(gap(mesh, back.points.back(), Point(1.5, 0, 0)), 1e-15);
}

TEST(StraightWalks, pass_a_reflex_corner_of_the_border_along_its_side)
{
  Soup soup = flat_grid(5, 5); // without its upper right quarter
  const auto is_cut = [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](const std::size_t v) {
      return soup.points[v].x() >= 2 && soup.points[v].y() >= 2;
    });
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_cut),
                       soup.triangles.end());
  const Mesh mesh = to_mesh(soup);
  const AG::Geodesic_tracer tracer(mesh);
  const Walk along = tracer.trace(Vertex(14), Space_vector(-1, 0, 0), 3.5); // from (4, 2)
  EXPECT_EQ(along.length, 3.5);
  EXPECT_LT(gap(mesh, along.points.back(), Point(0.5, 2, 0)), 1e-15);
  const Walk diagonal = tracer.trace(Vertex(6), Space_vector(1, 1, 0), 3); // to (2, 2)
  EXPECT_TRUE(diagonal.meets_border);
  EXPECT_NEAR(diagonal.length, std::sqrt(2.), 1e-15);
}

TEST(StraightWalks, end_at_once_if_they_lead_out_of_the_surface)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h))
    {
      const Walk walk = AG::trace_geodesic(mesh, Edge_location(h, 0.5), Tangent_vector{1, 1}, 1);
      EXPECT_TRUE(walk.meets_border);
      EXPECT_EQ(walk.length, 0);
      const Walk inside = AG::trace_geodesic(mesh, Edge_location(h, 0.5), Tangent_vector{0, -1}, 1);
      EXPECT_EQ(inside.length, 1);
    }
  Mesh isolated;
  const Walk none =
      AG::trace_geodesic(isolated, isolated.add_vertex(Point(1, 2, 3)), Tangent_vector{1, 0}, 1);
  EXPECT_TRUE(none.meets_border);
}

// ----- properties on any surface

// No squares, which may overflow.
double largest_length(const Mesh& mesh)
{
  const Triangulation triangulation(mesh);
  const std::vector<double>& lengths = triangulation.lengths();
  return lengths.empty() ? 0
                         : *std::max_element(lengths.begin(), lengths.end()) * triangulation.unit();
}

TEST(StraightWalks, return_to_their_start_when_they_are_reversed)
{
  const std::uint64_t seed = test_seed();
  for(const Named_mesh& named : generated_meshes(seed))
  {
    SCOPED_TRACE(named.name);
    if(named.name == "edges of length zero") // around these, walks go on in more than one direction
      continue;
    const Mesh& mesh = named.mesh;
    Random random(seed);
    const AG::Geodesic_tracer tracer(mesh);
    const double edge = largest_length(mesh);
    for(int i = 0; i < 100; ++i)
    {
      const Face_location start = inner_location(mesh, random);
      const double length = random.between(0, 10 * edge);
      const Walk walk = tracer.trace(start, at_angle(random.between(0, 2 * pi)), length);
      EXPECT_TRUE(walk.length == length || walk.meets_border);
      EXPECT_NEAR(length_of(mesh, walk.points), walk.length, 1e-12 * walk.length);
      if(walk.meets_border)
        continue;
      const Walk back = tracer.trace(walk.points.back(), opposite(walk.direction), length);
      EXPECT_EQ(back.length, length);
      EXPECT_LT(gap(mesh, back.points.back(), position(mesh, start)), 1e-9 * edge);
    }
  }
}

// Whatever they are, walks end, and have the length that they say.
TEST(StraightWalks, on_hostile_meshes_end_and_have_their_length)
{
  for(const Hostile_mesh& row : accepted_meshes())
  {
    SCOPED_TRACE(row.name);
    if(!row.refusal_across_faces.empty())
      continue;
    const Mesh& mesh = row.mesh;
    const double length = (std::min)(3 * largest_length(mesh), 1e308);
    const AG::Geodesic_tracer tracer(mesh, CGAL::parameters::number_of_iterations(20000));
    std::vector<Surface_point> starts = some_points(mesh);
    for(const Surface_point& p : some_vertices(mesh))
      starts.push_back(p);
    for(const Surface_point& start : starts)
      for(const double angle : {0., 0.1, pi / 2, 2.5, pi, 5.})
      {
        const Walk walk = tracer.trace(start, at_angle(angle), length);
        EXPECT_TRUE(walk.length >= 0 && walk.length <= length);
        EXPECT_NEAR(std::hypot(walk.direction.x, walk.direction.y), 1, 1e-12);
        for(const Surface_point& p : walk.points)
          if(const auto* const location = std::get_if<Face_location>(&p))
          {
            for(const double weight : location->second)
              EXPECT_TRUE(weight >= 0 && weight <= 1);
          }
        for(std::size_t i = 1; i < walk.points.size(); ++i)
          EXPECT_TRUE(mesh.number_of_faces() == 0 ||
                      share_a_face(mesh, walk.points[i - 1], walk.points[i]));
        const Tangent_vector moved = tracer.transport(walk.points, Tangent_vector{3, 4});
        EXPECT_NEAR(std::hypot(moved.x, moved.y), 5, 1e-12);
      }
  }
}

TEST(StraightWalks, end_after_the_largest_number_of_faces)
{
  const Mesh mesh = to_mesh(sphere(24, 15));
  const Walk walk = AG::trace_geodesic(mesh, Vertex(7), Tangent_vector{1, 0.3}, 1e300,
                                       CGAL::parameters::number_of_iterations(1000));
  EXPECT_FALSE(walk.meets_border);
  EXPECT_GT(walk.length, 10);
  EXPECT_LT(walk.points.size(), 1003u);
  EXPECT_NEAR(length_of(mesh, walk.points), walk.length, 1e-10);
}

// ----- vectors

TEST(TangentVectors, are_converted_to_space_and_back)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(8, 7, random));
  const AG::Geodesic_tracer tracer(mesh);
  for(int i = 0; i < 300; ++i)
  {
    Surface_point p = random_face_location(mesh, random);
    if(i % 3 == 1)
      p = Edge_location(random_halfedge(mesh, random), random.between(0.1, 0.9));
    else if(i % 3 == 2)
      p = random_vertex(mesh, random);
    const Tangent_vector v = at_angle(random.between(0, 2 * pi), 3);
    const Walk walk = tracer.trace(p, v, 1e-3);
    if(walk.meets_border || walk.points.size() > 2) // it leaves the face
      continue;
    const Space_vector in_space = tracer.vector_3(p, v);
    EXPECT_NEAR(std::sqrt(in_space.squared_length()), 3, 1e-12);
    const Space_vector step = position(mesh, walk.points.back()) - position(mesh, p);
    EXPECT_LT(std::sqrt((in_space * 1e-3 / 3 - step).squared_length()), 1e-12);
    EXPECT_LT(gap(mesh, p, tracer.point_3(p)), 1e-14);
    const Tangent_vector back = tracer.tangent_vector(p, in_space);
    EXPECT_LT(std::hypot(back.x - v.x, back.y - v.y), 1e-9);
  }
}

TEST(ParallelTransport, around_an_apex_turns_by_the_angle_defect)
{
  Random random(test_seed());
  for(const double total_angle : {0.7, 2., 5., 7.5})
  {
    const Developed_walks walks(cone(4, total_angle, 0.2, random));
    const Mesh& mesh = walks.m.mesh;
    std::vector<Surface_point> path; // across the edges around the apex, counterclockwise
    for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(Vertex(0))))
      path.push_back(Edge_location(h, 0.4));
    std::reverse(path.begin(), path.end());
    path.push_back(path.front());
    const Tangent_vector before = at_angle(1.2, 3), after = walks.transport(path, before);
    EXPECT_NEAR(std::hypot(after.x, after.y), 3, 1e-12);
    EXPECT_NEAR(std::remainder(angle_between(before, after) - (2 * pi - total_angle), 2 * pi), 0,
                1e-10)
        << total_angle;
  }
}

TEST(ParallelTransport, keeps_directions_of_walks_and_angles)
{
  const std::uint64_t seed = test_seed();
  for(const Named_mesh& named : generated_meshes(seed))
  {
    SCOPED_TRACE(named.name);
    if(named.name == "edges of length zero" || named.name == "two triangles" ||
       named.name == "parallel edges") // two points may have two faces in common
      continue;
    Random random(seed);
    const AG::Geodesic_tracer tracer(named.mesh);
    for(int i = 0; i < 60; ++i)
    {
      const Surface_point start = random_surface_point(named.mesh, random);
      const Tangent_vector v = at_angle(random.between(0, 2 * pi));
      const Walk walk = tracer.trace(start, v, random.between(0, 3 * largest_length(named.mesh)));
      const Tangent_vector moved = tracer.transport(walk.points, v),
                           other = tracer.transport(walk.points, at_angle(0.7));
      EXPECT_NEAR(angle_between(at_angle(0.7), v), angle_between(other, moved), 1e-9);
      EXPECT_NEAR(angle_between(walk.direction, moved), 0, 1e-9);
    }
  }
}

// ----- bad input

TEST(StraightWalks, reject_bad_input)
{
  const Mesh mesh = quiet_mesh();
  const AG::Geodesic_tracer tracer(mesh);
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const auto expect = [](const auto& f, const std::string& text) {
    expect_message<std::invalid_argument>(f, text);
  };
  const Tangent_vector x{1, 0};
  for(const double length : {-1., nan, infinite})
    expect([&] { tracer.trace(Vertex(0), x, length); }, "the length is");
  expect([&] { tracer.trace(Vertex(0), Tangent_vector{0, 0}, 1); }, "the direction has no part");
  expect([&] { tracer.trace(Vertex(6), Space_vector(0, 0, 1), 1); }, "the direction has no part");
  expect([&] { tracer.trace(Vertex(0), Tangent_vector{nan, 0}, 1); }, "the direction is nan, 0");
  expect([&] { tracer.trace(Vertex(0), Space_vector(0, infinite, 1), 1); }, "the direction is 0");
  expect([&] { tracer.trace(Vertex(99), x, 1); }, "start: vertex 99 is not in the mesh");
  expect([&] { AG::Geodesic_tracer(mesh, CGAL::parameters::number_of_iterations(-1)); },
         "the number of iterations is -1; it must not be negative");
  expect([&] { tracer.transport(std::vector<Vertex>(), x); }, "the path has no points");
  expect(
      [&] {
        tracer.transport(std::vector<Vertex>{Vertex(0), Vertex(19)}, x);
      },
      "points 0 and 1 of the path, counted from 0, lie in no common face");
  expect(
      [&] {
        tracer.transport(std::vector<Vertex>{Vertex(0), Vertex(99)}, x);
      },
      "point of the path 1");
  EXPECT_EQ(tracer.trace(Vertex(0), x, 0).points.size(), 1u);
}

} // namespace
