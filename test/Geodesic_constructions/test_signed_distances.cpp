// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/approximate_geodesic_distances.h>

#include "checks/expect_message.h"
#include "meshes/surface_points.h"
#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"
#include "paths/closed_curves.h"

#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_constructions/Source_curve.h>
#include <CGAL/Geodesic_costs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

// Distances from curves, negative to the left of them.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

using Closed_or_open_curve = AG::Source_curve<Mesh>;
using Curves_with_sides = std::vector<Closed_or_open_curve>;

template <typename Sources, typename NamedParameters>
std::vector<double>
signed_distances(const Mesh& mesh, const Sources& sources, const NamedParameters& np)
{
  std::vector<double> result(mesh.num_vertices());
  CGAL::approximate_geodesic_distances(
      mesh, boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh)),
      sources, np.signed_distances(true));
  return result;
}

template <typename Sources>
std::vector<double> signed_distances(const Mesh& mesh, const Sources& sources)
{
  return signed_distances(mesh, sources, parameters::epsilon(0));
}

// A plane.
class Signed_distances : public testing::Test
{
protected:
  static constexpr unsigned columns = 21, rows = 17;

  Vertex at(const unsigned x, const unsigned y) const { return Vertex(x + columns * y); }

  Surface_point point(const double x, const double y) const
  {
    return location_at(m_mesh, Point(x, y, 0));
  }

  Closed_or_open_curve polygon(const std::vector<Point>& corners) const
  {
    Closed_or_open_curve result{{}, true};
    for(const Point& p : corners)
      result.points.push_back(point(p.x(), p.y()));
    return result;
  }

  template <typename Sources>
  void refuse(const Sources& sources, const char* const text) const
  {
    expect_message<std::invalid_argument>([&] { signed_distances(m_mesh, sources); }, text);
  }

  const Mesh m_mesh = to_mesh(flat_grid(columns, rows));
  const Closed_or_open_curve m_square{{at(5, 4), at(12, 4), at(12, 11), at(5, 11)}, true};
};

// The distance to a polygon of corners in counterclockwise order, negative inside.
double signed_distance(const Point& p, const std::vector<Point>& corners)
{
  double smallest = infinity;
  bool is_inside = false;
  for(std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()];
    smallest = (std::min)(smallest, std::sqrt(CGAL::squared_distance(p, Kernel::Segment_3(a, b))));
    if((a.y() > p.y()) != (b.y() > p.y()) &&
       p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      is_inside = !is_inside;
  }
  return is_inside ? -smallest : smallest;
}

TEST_F(Signed_distances, are_negative_inside_of_a_polygon)
{
  const std::vector<Point> corners{Point(3.3, 2.2, 0),   Point(16.1, 5.7, 0), Point(9.4, 7.3, 0),
                                   Point(14.6, 14.9, 0), Point(4.9, 11.2, 0), Point(7.3, 8.1, 0)};
  const std::vector<Point> reversed(corners.rbegin(), corners.rend());
  const auto found = signed_distances(m_mesh, polygon(corners)),
             on_the_other_side = signed_distances(m_mesh, polygon(reversed));
  for(const Vertex v : m_mesh.vertices())
  {
    EXPECT_NEAR(found[v.idx()], signed_distance(m_mesh.point(v), corners), 1e-9) << v;
    EXPECT_NEAR(on_the_other_side[v.idx()], -found[v.idx()], 1e-9) << v;
  }
}

TEST_F(Signed_distances, are_those_of_all_graphs)
{
  const auto expect_signs = [&](const auto& np) {
    const auto found = signed_distances(m_mesh, m_square, np);
    for(const Vertex v : m_mesh.vertices())
    {
      const Point p = m_mesh.point(v);
      const double inside =
          (std::min)((std::min)(p.x() - 5, 12 - p.x()), (std::min)(p.y() - 4, 11 - p.y()));
      EXPECT_EQ(found[v.idx()]<0, inside> 0) << v;
      EXPECT_EQ(found[v.idx()] == 0, inside == 0) << v;
    }
  };
  expect_signs(parameters::epsilon(1.));
  expect_signs(parameters::signed_distances(true)); // along edges
  expect_signs(parameters::signed_distances(true).number_of_points_per_edge(2));
}

TEST_F(Signed_distances, tell_the_inside_of_a_curve_in_a_face)
{
  const std::vector<Point> corners{Point(7.5, 7.1, 0), Point(7.9, 7.2, 0), Point(7.8, 7.6, 0)};
  const auto found = signed_distances(m_mesh, polygon(corners));
  const auto reversed =
      signed_distances(m_mesh, polygon(std::vector<Point>(corners.rbegin(), corners.rend())));
  for(const Vertex v : m_mesh.vertices())
  {
    EXPECT_NEAR(found[v.idx()], signed_distance(m_mesh.point(v), corners), 1e-9);
    EXPECT_NEAR(reversed[v.idx()], -found[v.idx()], 1e-9);
  }
}

TEST_F(Signed_distances, have_a_curve_from_border_to_border_between_them)
{
  const Closed_or_open_curve through_vertices{{at(0, 3), at(20, 3)}};
  const auto found = signed_distances(m_mesh, through_vertices);
  for(const Vertex v : m_mesh.vertices())
    EXPECT_NEAR(found[v.idx()], 3 - m_mesh.point(v).y(), 1e-9);
  const Closed_or_open_curve across{{point(20, 9.3), point(10.2, 9.3), point(0, 9.3)}};
  const auto other = signed_distances(m_mesh, across);
  for(const Vertex v : m_mesh.vertices())
    EXPECT_NEAR(other[v.idx()], m_mesh.point(v).y() - 9.3, 1e-9);
}

TEST_F(Signed_distances, are_those_between_several_curves)
{
  const Closed_or_open_curve hole{{at(7, 6), at(7, 9), at(10, 9), at(10, 6)}, true};
  const auto found = signed_distances(m_mesh, Curves_with_sides{m_square, hole});
  EXPECT_NEAR(found[at(6, 7).idx()], -1, 1e-9); // between them
  EXPECT_NEAR(found[at(8, 8).idx()], 1, 1e-9);
  EXPECT_NEAR(found[at(2, 7).idx()], 3, 1e-9);
  const Closed_or_open_curve wrong{{at(7, 6), at(10, 6), at(10, 9), at(7, 9)}, true};
  refuse(Curves_with_sides{m_square, wrong}, "the sources have no two sides");
}

TEST_F(Signed_distances, are_zero_in_a_region_of_any_size)
{
  const AG::Source_region<Mesh> part{{*m_mesh.faces_begin()}}; // with a corner of the mesh
  for(const double distance : signed_distances(m_mesh, part))
    EXPECT_GE(distance, 0);
  const Mesh closed = to_mesh(sphere(8, 5));
  for(const Mesh* const mesh : {&m_mesh, &closed})
  {
    const AG::Source_region<Mesh> all{{mesh->faces().begin(), mesh->faces().end()}};
    for(const double distance : signed_distances(*mesh, all))
      EXPECT_EQ(distance, 0);
  }
}

TEST_F(Signed_distances, are_infinite_where_nothing_is_reached)
{
  Mesh mesh = m_mesh;
  mesh.add_face(mesh.add_vertex(Point(0, 0, 9)), mesh.add_vertex(Point(1, 0, 9)),
                mesh.add_vertex(Point(0, 1, 9)));
  const auto found = signed_distances(mesh, m_square, parameters::epsilon(0).maximum_distance(1.5));
  EXPECT_EQ(found[at(8, 8).idx()], infinity);
  EXPECT_EQ(found[at(0, 0).idx()], infinity);
  EXPECT_EQ(found.back(), infinity);
  EXPECT_NEAR(found[at(6, 7).idx()], -1, 1e-9);
}

TEST_F(Signed_distances, of_the_class_have_signs_too)
{
  AG::Surface_mesh_shortest_path<Mesh, AG::Lazy_discrete_geodesic_graph> paths(
      m_mesh, parameters::epsilon(0.1));
  paths.add_source_curve(m_square);
  std::vector<double> found(m_mesh.num_vertices());
  const auto map =
      boost::make_iterator_property_map(found.begin(), get(boost::vertex_index, m_mesh));
  paths.shortest_distances_to_source_points(map, parameters::signed_distances(true));
  EXPECT_NEAR(found[at(8, 7).idx()], -3, 0.3);
  EXPECT_NEAR(found[at(8, 1).idx()], 3, 0.3);
  paths.add_source_point(at(0, 0));
  expect_message<std::invalid_argument>(
      [&] { paths.shortest_distances_to_source_points(map, parameters::signed_distances(true)); },
      "source 1 has no sides, as it is a point");
}

TEST_F(Signed_distances, are_refused_where_there_are_no_two_sides)
{
  refuse(at(0, 0), "signed distances need curves as sources");
  refuse(Closed_or_open_curve{{at(4, 4)}}, "source 0 has no sides, as it is a point");
  refuse(Closed_or_open_curve{{at(4, 4), at(9, 4)}},
         "source 0 has no two sides: it is not closed, and ends inside the surface");
  refuse(Closed_or_open_curve{{at(0, 4), at(9, 4)}}, "source 0 has no two sides");
  refuse(Curves_with_sides{m_square, {{at(15, 4), at(17, 9)}}}, "source 1 has no two sides");
  refuse(Closed_or_open_curve{{at(4, 4), at(9, 4)}, true}, // there and back
         "the sources have no two sides: their left side is connected with their right side");
  refuse(Closed_or_open_curve{{at(3, 3), at(9, 9), at(9, 3), at(3, 9)}, true}, // an eight
         "the sources have no two sides");
}

// Those of gores: see the distances from the equator without signs.
TEST(Signed_distances_on_sphere, are_negative_to_the_north_of_an_equator_that_goes_east)
{
  const std::size_t meridians = 16, parallels = 9;
  const Mesh mesh = to_mesh(sphere(meridians, parallels));
  Closed_or_open_curve equator{{}, true};
  for(std::size_t i = 0; i < meridians; ++i)
    equator.points.push_back(Vertex(static_cast<unsigned>(2 + 4 * meridians + i)));
  const bool goes_east = [&] {
    const Point a = mesh.point(Vertex(2 + 4 * meridians)),
                b = mesh.point(Vertex(3 + 4 * meridians));
    return a.x() * b.y() - a.y() * b.x() > 0;
  }();
  std::vector<double> heights(1, 0.);
  const auto middle = [&](const std::size_t j) {
    return CGAL::midpoint(mesh.point(Vertex(static_cast<unsigned>(2 + j * meridians))),
                          mesh.point(Vertex(static_cast<unsigned>(3 + j * meridians))));
  };
  for(std::size_t j = 4; j-- > 0;)
    heights.push_back(heights.back() + std::sqrt(CGAL::squared_distance(middle(j + 1), middle(j))));
  const auto found = signed_distances(mesh, equator);
  for(std::size_t j = 0; j < parallels; ++j)
    for(std::size_t i = 0; i < meridians; ++i)
    {
      const Vertex v(static_cast<unsigned>(2 + j * meridians + i));
      const double height = heights[j < 4 ? 4 - j : j - 4];
      const bool is_left = (mesh.point(v).z() > 0) == goes_east;
      EXPECT_NEAR(found[v.idx()], is_left ? -height : height, 1e-9) << v;
    }
}

TEST(Signed_distances_on_cone, are_negative_around_the_apex)
{
  const std::size_t valence = 12;
  const Mesh mesh = to_mesh(fan(valence, 2));
  Closed_or_open_curve ring{{}, true};
  for(unsigned i = 1; i <= valence; ++i)
    ring.points.push_back(Edge_location(mesh.halfedge(Vertex(0), Vertex(i)), 0.5));
  const double edge = std::sqrt(5.), side = 2 * std::sin(std::acos(-1.) / double(valence));
  const double height = std::sqrt(edge * edge - side * side / 4);
  const auto found = signed_distances(mesh, ring);
  EXPECT_NEAR(found[0], -height / 2, 1e-9);
  for(std::size_t i = 1; i <= valence; ++i)
    EXPECT_NEAR(found[i], edge / 2, 1e-9);
}

TEST(Signed_distances_on_torus, are_refused_if_a_curve_does_not_separate_it)
{
  constexpr unsigned around = 12, across = 9;
  const Mesh mesh = to_mesh(torus(around, across, 3, 1));
  Closed_or_open_curve meridian{{}, true}, opposite{{}, true}; // rings 0 and 6
  for(unsigned i = 0; i < across; ++i)
  {
    meridian.points.push_back(Vertex(i));
    opposite.points.push_back(Vertex((across - i) % across + 6 * across));
  }
  expect_message<std::invalid_argument>([&] { signed_distances(mesh, meridian); },
                                        "the sources have no two sides");
  const auto found = signed_distances(mesh, Curves_with_sides{meridian, opposite}); // both do
  const bool is_first_half_left = found[across] < 0;
  for(const Vertex v : mesh.vertices())
  {
    const std::size_t ring = v.idx() / across;
    EXPECT_EQ(found[v.idx()] == 0, ring % 6 == 0) << v;
    EXPECT_EQ(found[v.idx()] < 0, ring % 6 != 0 && (ring < 6) == is_first_half_left) << v;
  }
}

} // namespace
