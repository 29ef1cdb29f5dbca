// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include "checks/expect_message.h"
#include "checks/graphs_of_all_kinds.h"
#include "checks/test_random.h"
#include "meshes/sample_meshes.h"
#include "oracles/long_double_distances.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace geodesics_test;
namespace AG = CGAL::Approximate_geodesics;
using AG::internal::Apex_position;
using Exact = CGAL::Exact_rational;
using Exact_vector = std::array<Exact, 3>;
using Index = Triangulation::Index;

constexpr double tolerance = 1e-12;

// ----- triangles in space

Point random_point(Random& random, const double extent)
{
  const auto coordinate = [&] { return random.between(-extent, extent); };
  const double x = coordinate(), y = coordinate();
  return Point(x, y, coordinate());
}

Kernel::Vector_3 random_direction(Random& random)
{
  const Kernel::Vector_3 result = random_point(random, 1) - CGAL::ORIGIN;
  return result / std::sqrt(result.squared_length());
}

// Vertices with three numbers in a row are the corners of a face.
struct Triangles
{
  Soup soup;

  void add(const Point& p, const Point& q, const Point& r)
  {
    const std::size_t first = soup.points.size();
    soup.points.insert(soup.points.end(), {p, q, r});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
};

// Caps with acute and obtuse corners at the base, and needles with any angle at the short edge.
Soup thin_triangles(const double aspect, Random& random)
{
  Triangles result;
  for(int i = 0; i < 200; ++i)
  {
    const Point p = random_point(random, 1);
    const Kernel::Vector_3 u = random_direction(random), v = random_direction(random);
    const double along = random.between(-0.9, 1.9);
    result.add(p, p + u, p + along * u + v / aspect);
    result.add(p + u, p, p + v / aspect);
  }
  return result.soup;
}

// ----- the shape that a face has

Exact_vector exact_difference(const Point& p, const Point& q)
{
  return {Exact(p.x()) - Exact(q.x()), Exact(p.y()) - Exact(q.y()), Exact(p.z()) - Exact(q.z())};
}

Exact dot(const Exact_vector& a, const Exact_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Exact squared_area(const Exact_vector& a, const Exact_vector& b)
{
  return dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b);
}

// The face to the left of a halfedge, with rational numbers only.
struct Exact_shape
{
  Exact_shape(const Point& source, const Point& target, const Point& apex)
  {
    const Exact_vector base = exact_difference(target, source);
    const Exact_vector left = exact_difference(apex, source);
    const Exact_vector right = exact_difference(apex, target);
    const Exact length = dot(base, base);
    along = dot(base, left) / length;
    beyond = -dot(base, right) / length;
    squared_across = squared_area(base, left) / length / length;
    squared_left = dot(left, left) / length;
    squared_right = dot(right, right) / length;
  }

  Exact along, beyond, squared_across;
  Exact squared_left, squared_right; // lengths of the other two sides
};

double relative_error(const double found, const Exact& right, const Exact& squared_scale)
{
  const Exact error = Exact(found) - right;
  return std::sqrt(CGAL::to_double(Exact(error * error / squared_scale)));
}

// The largest errors: of `across`, relative; of the others, relative or compared to the distance
// from the end of the base in question.
struct Errors
{
  void add(const Apex_position& found, const Exact_shape& right, const bool is_relative)
  {
    const Exact square = Exact(found.across) * Exact(found.across);
    EXPECT_GE(found.across, 0);
    across =
        (std::max)(across, std::abs(CGAL::to_double(Exact(square / right.squared_across - 1))));
    along = (std::max)(
        along, relative_error(found.along, right.along,
                              is_relative ? Exact(right.along * right.along) : right.squared_left));
    beyond = (std::max)(beyond, relative_error(found.beyond, right.beyond,
                                               is_relative ? Exact(right.beyond * right.beyond)
                                                           : right.squared_right));
  }

  double along = 0, beyond = 0, across = 0;
};

Point point_of(const Soup& soup, const Triangulation& t, const Index v)
{
  return soup.points[t.index(v)];
}

template <typename F>
void for_each_side(const Triangulation& t, F f)
{
  for(Index v = 0; v < t.number_of_vertices(); ++v)
    for(Index h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
      if(!t.is_border(h))
        f(v, h);
}

Errors errors_of_shapes(const Soup& soup, const bool is_relative)
{
  Errors result;
  const Triangulation t(to_mesh(soup));
  EXPECT_TRUE(t.is_valid());
  EXPECT_NO_THROW(t.check_triangle_inequality());
  for_each_side(t, [&](const Index v, const Index h) {
    result.add(AG::internal::apex_position(t, v, h),
               Exact_shape(point_of(soup, t, v), point_of(soup, t, t.target(h)),
                           point_of(soup, t, t.target(t.next(h)))),
               is_relative);
  });
  return result;
}

void expect_small(const Errors& errors)
{
  EXPECT_LE(errors.along, tolerance);
  EXPECT_LE(errors.beyond, tolerance);
  EXPECT_LE(errors.across, tolerance);
}

TEST(Thin_faces, have_shapes_as_exact_as_their_coordinates)
{
  Random random(test_seed());
  for(const double aspect : {1e4, 1e5, 1e6, 1e7, 1e8, 1e10, 1e12})
  {
    SCOPED_TRACE(aspect);
    const Soup soup = thin_triangles(aspect, random);
    expect_small(errors_of_shapes(soup, true));
    EXPECT_EQ(soup.triangles.size(), Triangulation(to_mesh(soup)).thin_faces().number_of_faces());
  }
}

// Some of these are thin enough to be kept, and others are not.
TEST(Thin_faces, begin_where_lengths_no_longer_do)
{
  Random random(test_seed());
  for(int i = 0; i < 20; ++i)
    expect_small(
        errors_of_shapes(thin_triangles(std::pow(10, random.between(0, 4)), random), false));
}

// ----- triangulations of the plane

// Steps from 1 down to 1 / aspect.
std::vector<double>
uneven_coordinates(const std::size_t number, const double aspect, Random& random)
{
  std::vector<double> result{0};
  while(result.size() < number)
    result.push_back(result.back() + std::pow(aspect, -random.between(0, 1)));
  return result;
}

// A parallelogram of needles, or of caps if it leans far over.
Soup uneven_grid(const double aspect, const double lean, Random& random)
{
  const std::size_t columns = 12, rows = 10;
  const std::vector<double> x = uneven_coordinates(columns, aspect, random),
                            y = uneven_coordinates(rows, aspect, random);
  return grid(columns, rows, [&](const double i, const double j) {
    const double across = y[static_cast<std::size_t>(j)];
    return Point(x[static_cast<std::size_t>(i)] + lean * across, across, 0);
  });
}

// Columns that lean by several of their widths, in a plane that is squeezed.
Soup grid_of_caps(const double aspect)
{
  return grid(12, 10, [=](const double i, const double j) {
    return Point(i - 0.45 * j, (j + 0.1 * i) / aspect, 0);
  });
}

// Every other row is of caps, with their longest sides along it.
Soup layers_of_caps(const double aspect, Random& random)
{
  constexpr std::size_t columns = 10, rows = 12;
  std::vector<double> y{0};
  while(y.size() < rows)
    y.push_back(y.back() + (y.size() % 2 == 0 ? 1 : random.between(0.3, 1) / aspect));
  return grid(columns, rows, [&](const double i, const double j) {
    const bool is_moved = i > 0 && i + 1 < columns && std::fmod(j, 2) == 1;
    return Point(is_moved ? i + 0.45 : i, y[static_cast<std::size_t>(j)], 0);
  });
}

// A disk with a small one in the middle: needles all around, with their short edges there. The
// outline of the latter is a star, with radii from the least one on.
Soup disk_in_disk(const double aspect, Random& random, const double least_radius = 1)
{
  constexpr std::size_t corners = 14;
  const double pi = 4 * std::atan(1.);
  Soup result;
  result.points.push_back(Point(0, 0, 0));
  for(const double radius : {1 / aspect, 1.})
    for(std::size_t i = 0; i < corners; ++i)
    {
      const double angle = 2 * pi * (static_cast<double>(i) + random.between(0, 0.5)) / corners;
      const double r = radius < 1 ? radius * random.between(least_radius, 1) : radius;
      result.points.push_back(Point(r * std::cos(angle), r * std::sin(angle), 0));
    }
  for(std::size_t i = 0; i < corners; ++i)
  {
    const std::size_t a = 1 + i, b = 1 + (i + 1) % corners;
    result.triangles.push_back({0, a, b});
    result.triangles.push_back({a, a + corners, b + corners});
    result.triangles.push_back({a, b + corners, b});
  }
  return result;
}

template <typename F>
void for_each_flat_mesh(F f)
{
  Random random(test_seed());
  for(const double aspect : {1e2, 1e4, 1e6, 1e8})
  {
    SCOPED_TRACE(aspect);
    f("needles", uneven_grid(aspect, 0, random));
    f("leaning", uneven_grid(aspect, 3, random));
    f("caps", grid_of_caps(aspect));
    f("layers", layers_of_caps(aspect, random));
    f("disk", disk_in_disk(aspect, random));
  }
}

bool is_inside(const Triangulation& t, const Index v)
{
  for(Index h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
    if(t.is_border(h))
      return false;
  return true;
}

TEST(Thin_faces, have_angles_that_add_up)
{
  const double pi = 4 * std::atan(1.);
  for_each_flat_mesh([&](const std::string& name, const Soup& soup) {
    SCOPED_TRACE(name);
    const Triangulation t(to_mesh(soup));
    for(Index v = 0; v < t.number_of_vertices(); ++v)
      if(is_inside(t, v))
      {
        const Index h = t.first_halfedge(v);
        EXPECT_NEAR(AG::internal::angle_of_fan(t, h, h), 2 * pi, tolerance);
      }
  });
}

// Distances in the plane are those of the coordinates. Only rounding can make others smaller: of
// lengths, and of the sides of the faces that are crossed.
template <typename Kind>
void expect_no_shortcuts(const Soup& soup, const Triangulation& t, const Kind& kind)
{
  constexpr double units_in_the_last_place = 16;
  const double longest = *std::max_element(t.lengths().begin(), t.lengths().end()) * t.unit();
  const auto graph = kind.make(t);
  CGAL::Approximate_geodesics::Propagation<typename Kind::Graph> search(graph);
  for(Index s = 0; s < t.number_of_vertices(); s += 5)
  {
    search.run_from(s);
    for(Index v = 0; v < t.number_of_vertices(); ++v)
    {
      const Long line =
          long_distance(long_point(point_of(soup, t, s)), long_point(point_of(soup, t, v)));
      EXPECT_GE(search.distance(v),
                line * (1 - Long(tolerance)) - units_in_the_last_place * 0x1p-53 * longest);
      if(v == s)
        continue;
      EXPECT_LE(search.distance(v),
                line * (1 + Long(kind.epsilon)) *
                    (1 + Long(kind.epsilon > 0 ? single_precision : tolerance)));
    }
  }
}

TEST(Thin_faces, make_no_shortcuts)
{
  for_each_flat_mesh([&](const std::string& name, const Soup& soup) {
    SCOPED_TRACE(name);
    const Triangulation t(to_mesh(soup));
    const auto check = [&](const auto& kind) {
      SCOPED_TRACE(kind.name);
      expect_no_shortcuts(soup, t, kind);
    };
    check(discrete_geodesic_graph(0.1));
    check(discrete_geodesic_graph(0.01));
    check(lazy_graph(0.1, Lazy_discrete_geodesic_graph::Arcs::FORGOTTEN));
    check(lazy_graph(0.01, Lazy_discrete_geodesic_graph::Arcs::FORGOTTEN));
    with_spaced_points(1, check);
    with_spaced_points(3, check);
    check(saddle_vertex_graph());
  });
}

// What is behind a short side that is far away is seen in a direction that has lost digits. Small
// errors are left, and none that grows with the aspect: less than the manual says of all surfaces.
TEST(Thin_faces, make_distances_too_short_by_little)
{
  constexpr double largest_error = 2e-12, diameter = 2;
  Random random(test_seed());
  double largest = 0;
  for(double aspect = 1e3; aspect < 2e9; aspect *= 2)
  {
    SCOPED_TRACE(aspect);
    const Soup soup = disk_in_disk(aspect, random, 0.1);
    const Triangulation t(to_mesh(soup));
    const auto check = [&](const auto& kind) {
      const auto graph = kind.make(t);
      AG::Propagation<typename std::decay_t<decltype(kind)>::Graph> search(graph);
      for(Index s = 0; s < t.number_of_vertices(); ++s)
      {
        search.run_from(s);
        for(Index v = 0; v < t.number_of_vertices(); ++v)
        {
          const Long line =
              long_distance(long_point(point_of(soup, t, s)), long_point(point_of(soup, t, v)));
          largest = (std::max)(largest, static_cast<double>(line - search.distance(v)) / diameter);
        }
      }
    };
    for(const double epsilon : {1., 0.1, 0.01})
    {
      check(discrete_geodesic_graph(epsilon));
      check(lazy_graph(epsilon, Lazy_discrete_geodesic_graph::Arcs::FORGOTTEN));
    }
    check(saddle_vertex_graph());
  }
  EXPECT_LE(largest, largest_error);
  std::cout << "too short by " << largest << " of the diameter" << std::endl;
}

// ----- what else measures faces

double squared_sine(const Exact_vector& a, const Exact_vector& b)
{
  return CGAL::to_double(Exact(squared_area(a, b) / (dot(a, a) * dot(b, b))));
}

TEST(Thin_faces, have_exact_corners)
{
  Random random(test_seed());
  for(const double aspect : {1e1, 1e2, 1e4, 1e6, 1e8})
  {
    SCOPED_TRACE(aspect);
    const Soup soup = thin_triangles(aspect, random);
    const Triangulation t(to_mesh(soup));
    for_each_side(t, [&](const Index v, const Index h) {
      const Point p = point_of(soup, t, v);
      const Index g = t.next(h), k = t.next(g);
      const Exact_vector a = exact_difference(point_of(soup, t, t.target(h)), p),
                         b = exact_difference(point_of(soup, t, t.target(g)), p);
      const double sine = std::sqrt(squared_sine(a, b)), along = CGAL::to_double(dot(a, b));
      const double cosine = std::copysign(std::sqrt((1 - sine) * (1 + sine)), along);
      const auto angle = AG::internal::corner_angle(t, h);
      EXPECT_NEAR(angle.y / sine, 1, tolerance);
      EXPECT_NEAR(std::atan2(angle.y, angle.x), std::atan2(sine, cosine), tolerance);
      const double opening = cosine > 0 ? 2 * sine * sine / (1 + cosine) : 2 - 2 * cosine;
      const AG::internal::Corner corner =
          AG::internal::corner_of_face(t, h, t.length(h), t.length(k), t.length(g));
      EXPECT_NEAR(corner.opening() / opening, 1, 2 * tolerance);
      const AG::internal::Face_layout layout(t, h);
      const double area = cross(layout.corner(1) - layout.corner(0), //
                                layout.corner(2) - layout.corner(0));
      EXPECT_NEAR(area / (sine * t.length(h) * t.length(k)), 1, tolerance);
    });
  }
}

// Of length one; zero, and not no number, where a side has no length.
TEST(Thin_faces, have_directions_of_their_sides)
{
  Random random(test_seed());
  Soup soup = thin_triangles(1e8, random);
  soup.append({{Point(1, 2, 3), Point(1, 2, 3), Point(2, 2, 3)}, {{0, 1, 2}}});
  const Triangulation t(to_mesh(soup));
  std::size_t number_without = 0;
  for_each_side(t, [&](const Index, const Index h) {
    const AG::internal::Face_layout layout(t, t.next(h));
    const AG::internal::Plane_vector direction = layout.direction(h);
    EXPECT_NEAR(length(direction), t.length(h) > 0 ? 1 : 0, tolerance);
    EXPECT_NEAR(dot(direction, layout.edge(2, 0)), t.length(h), tolerance * t.length(h));
    number_without += t.length(h) == 0 ? 1 : 0;
  });
  EXPECT_EQ(number_without, 1u);
}

TEST(Thin_faces, have_exact_lines)
{
  Random random(test_seed());
  for(const double aspect : {1e2, 1e4, 1e6, 1e8})
  {
    const Soup soup = thin_triangles(aspect, random);
    const Triangulation t(to_mesh(soup));
    for_each_side(t, [&](const Index v, const Index h) {
      using AG::internal::Face_point;
      const double s = random.between(0, 0.5), r = random.between(0, 0.5);
      const Face_point p{h, {1 - s - r, s, r}}, q{h, {r, 1 - s - r, s}};
      const Long_point corner = long_point(point_of(soup, t, v));
      const Long_point a = long_point(point_of(soup, t, t.target(h))) - corner,
                       b = long_point(point_of(soup, t, t.target(t.next(h)))) - corner;
      Long_point line{};
      for(std::size_t i = 0; i < 3; ++i)
        line[i] =
            (Long(q.weight[1]) - p.weight[1]) * a[i] + (Long(q.weight[2]) - p.weight[2]) * b[i];
      const double size = static_cast<double>(long_norm(a) + long_norm(b));
      EXPECT_NEAR(distance(t, p, q) * t.unit(), static_cast<double>(long_norm(line)),
                  8 * 0x1p-53 * size);
    });
  }
}

// ----- the table

bool is_finite(const Apex_position& p)
{
  return std::isfinite(p.along) && std::isfinite(p.beyond) && std::isfinite(p.across);
}

Triangulation triangulation_of_lengths(const Soup& soup, const std::vector<double>& lengths)
{
  const Mesh mesh = to_mesh(soup);
  return Triangulation(mesh, CGAL::parameters::edge_length_map(boost::make_iterator_property_map(
                                 lengths.begin(), get(boost::edge_index, mesh))));
}

TEST(Thin_faces, have_finite_shapes_however_thin_they_are)
{
  Random random(test_seed());
  const auto expect_finite = [](const Triangulation& t) {
    for_each_side(t, [&](const Index v, const Index h) {
      EXPECT_TRUE(is_finite(AG::internal::apex_position(t, v, h)));
    });
  };
  for(int exponent = 50; exponent < 1070; exponent += 10)
  {
    SCOPED_TRACE(exponent);
    const double smallest = std::ldexp(1., -exponent);
    Triangles faces;
    const Point p(0, 0, 0); // the only point where such small differences do not vanish
    for(int i = 0; i < 20; ++i)
    {
      const Kernel::Vector_3 v = smallest * random_direction(random);
      faces.add(p, p + random_direction(random), p + v);
      faces.add(p, p + v, p + 1e-5 * v);
    }
    expect_finite(Triangulation(to_mesh(faces.soup)));
    for(const double longest : {1., 1 + 0x1p-52})
      expect_finite(triangulation_of_lengths({{p, p, p}, {{0, 1, 2}}}, {1, longest, smallest}));
  }
}

// A face whose area underflows, entirely or to a few digits, among faces of size 1.
TEST(Thin_faces, are_refused_if_they_are_too_small)
{
  for(const double size : {1e-133, 1e-141, 1e-150})
    for(const bool is_closed : {false, true})
    {
      Soup soup{
          {Point(0, 0, 0), Point(size, 0, 0), Point(0.3 * size, 0.7 * size, 0), Point(1, 1, 1)},
          {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}}};
      if(is_closed)
        soup.triangles.push_back({0, 2, 3});
      const Triangulation t(to_mesh(soup));
      const auto expect_refusal = [](const auto& make_graph) {
        expect_message<std::invalid_argument>(make_graph, "too small relative to the mesh",
                                              "in the face with vertices 0, 1, 2");
      };
      expect_refusal([&] { Lazy_discrete_geodesic_graph(t, CGAL::parameters::epsilon(0.1)); });
      expect_refusal([&] { Saddle_vertex_graph graph(t); });
    }
}

TEST(Thin_faces, are_kept_if_there_are_coordinates)
{
  const Soup soup = grid_of_caps(1e6);
  const Triangulation by_coordinates(to_mesh(soup));
  const Triangulation by_lengths = triangulation_of_lengths(soup, edge_lengths(to_mesh(soup)));
  EXPECT_TRUE(by_lengths.thin_faces().is_empty());
  EXPECT_EQ(by_coordinates.thin_faces().number_of_faces(), soup.triangles.size());
  constexpr std::size_t bytes_per_face = 36, halfedges_per_number = 128;
  const std::size_t numbers = by_lengths.number_of_halfedges() / halfedges_per_number + 1;
  EXPECT_LE(by_coordinates.memory(),
            by_lengths.memory() + bytes_per_face * soup.triangles.size() + sizeof(Index) * numbers);
  EXPECT_GT(by_coordinates.memory(), by_lengths.memory());
}

TEST(Thin_faces, are_few_on_other_meshes)
{
  for(const char* name : {"elephant.off", "blobby_3cc.off"})
    EXPECT_TRUE(Triangulation(sample_mesh(name)).thin_faces().is_empty()) << name;
}

} // namespace
