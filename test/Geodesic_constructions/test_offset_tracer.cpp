// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_constructions/internal/Offsets/Offset_tracer.h>

#include "checks/expect_message.h"
#include "meshes/hostile_meshes.h"
#include "oracles/distances_to_curves.h"
#include "threads/Interruption_at.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

// How offset curves are traced: with how much work, and in which unit.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Search_from_curve = AG::Surface_search<AG::Saddle_vertex_graph>;

// A curve divides faces around it into parts that are far smaller. Those of a needle follow each
// other: there are as many as on a long side.
TEST(Offset_tracer, takes_no_more_triangles_the_longer_needles_are)
{
  constexpr std::size_t most_parts = 60 * 4096;
  for(const double aspect : {1e4, 1e6, 1e8})
  {
    SCOPED_TRACE(aspect);
    const AG::Saddle_vertex_graph graph(Triangulation(to_mesh(needles(aspect))));
    const Intrinsic_triangulation& t = graph.triangulation();
    Polyline_on_surface column;
    for(std::size_t v = 3; v < 28; v += 7)
      column.push_back(Intrinsic_point::at_vertex(t.vertex(v)));
    Search_from_curve search(graph);
    AG::run_from_curves(search, {{{column}}});
    const double width = 3 / aspect, step = 0.01;
    AG::internal::Offset_tracer tracer(search, {width / 1e3, width / 2}, step, most_parts);
    EXPECT_NO_THROW(tracer.trace());
  }
}

// Two faces, and a circle with so small a step that they would be divided into millions of parts.
class Offset_tracer_of_square : public testing::Test
{
protected:
  Offset_tracer_of_square() { m_search.run({{Intrinsic_point::at_vertex(0)}}); }

  void trace() { AG::internal::Offset_tracer(m_search, {0.1}, 1e-12).trace(); }

  const AG::Saddle_vertex_graph m_graph{Triangulation(to_mesh(flat_grid(2, 2)))};
  Search_from_curve m_search{m_graph};
};

TEST_F(Offset_tracer_of_square, names_the_face_if_there_would_be_too_many_parts)
{
  const std::size_t most = (1 << 18) + (1 << 12) * 2;
  expect_message<std::length_error>([&] { trace(); },
                                    "more than " + std::to_string(most) + " parts",
                                    "in the face with vertices");
}

TEST_F(Offset_tracer_of_square, is_interrupted_at_each_of_many_checks)
{
  for(const int number : {0, 1, 10, 50})
  {
    const Interruption_at interruption(number);
    EXPECT_THROW(trace(), std::runtime_error);
  }
}

// Lines from a point of the plane, which are divided at each of 22,500 vertices.
TEST(Offset_tracer, is_interrupted_while_one_distance_is_found)
{
  const AG::Saddle_vertex_graph graph{Triangulation(to_mesh(flat_grid(150, 150)))};
  const auto point = Intrinsic_point::in_face(0, 0.3, 0.3);
  const auto find = [&] {
    graph.attach(point).for_each_line(
        0, [](auto) { return infinity; }, AG::Points_by_face(),
        [](auto, double, const AG::internal::Arrival&) {}, [](std::size_t, double) {});
  };
  for(const int number : {0, 3})
  {
    const Interruption_at interruption(number);
    EXPECT_THROW(find(), std::runtime_error);
  }
}

std::size_t number_of_points(const Soup& soup, const double unit)
{
  const Mesh mesh = to_mesh(scaled(soup, unit));
  const AG::Saddle_vertex_graph graph{Triangulation(mesh)};
  Search_from_curve search(graph);
  search.run({{Intrinsic_point::at_vertex(graph.triangulation().vertex(0))}});
  AG::internal::Offset_tracer tracer(search, {0.1 * unit, 2.5 * unit}, 1e-4 * unit);
  std::size_t result = 0;
  for(const auto& line : tracer.trace())
    result += line.points.size();
  return result;
}

// Squares of lengths are infinite or zero where the length of an edge is one of these.
TEST(Offset_tracer, divides_faces_alike_in_any_unit)
{
  const Soup soup = flat_grid(4, 3);
  const std::size_t expected = number_of_points(soup, 1);
  EXPECT_GT(expected, 100u);
  for(const int exponent : {-1000, 1000})
    EXPECT_EQ(number_of_points(soup, std::ldexp(1., exponent)), expected) << exponent;
}

Intrinsic_triangulation::Index halfedge_between(const Intrinsic_triangulation& t,
                                                const Intrinsic_triangulation::Index v,
                                                const Intrinsic_triangulation::Index w)
{
  Intrinsic_triangulation::Index h = t.first_halfedge(v);
  while(t.target(h) != w)
    ++h;
  return h;
}

// A needle and a large face share an edge that is 10^7 times as long as the distance. Parts of it
// end alike on both sides.
TEST(Offset_tracer, joins_faces_along_edges_that_are_divided_often)
{
  const double length = 1e7;
  for(const double width : {0.3, 20.})
    for(const double distance : {2., 5., 15.})
    {
      SCOPED_TRACE(::testing::Message() << width << " " << distance);
      const Soup soup{{{0, 0, 0}, {length, 0, 0}, {length / 2, length, 0}, {0, -width, 0}},
                      {{0, 1, 2}, {0, 3, 1}}};
      const AG::Saddle_vertex_graph graph{Triangulation(to_mesh(soup))};
      const Intrinsic_triangulation& t = graph.triangulation();
      Search_from_curve search(graph);
      search.run({{Intrinsic_point::on_edge(halfedge_between(t, t.vertex(0), t.vertex(1)), 0.3)}});
      AG::internal::Offset_tracer tracer(search, {distance}, 1.5);
      EXPECT_EQ(tracer.trace().size(), 1u);
    }
}

} // namespace
