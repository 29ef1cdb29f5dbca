// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_constructions/offset_curves.h>

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "meshes/surface_points.h"
#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"
#include "threads/Interruption_at.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

// Curves and regions of a mesh as sources, and curves at constant distance from them.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

using Curve = AG::Source_curve<Mesh>;
using Offset = AG::Offset_curve<Point>;
using Segment = Kernel::Segment_3;

// A plane, where the points of the segment from (5, 5) to (14, 8) are the source.
class Offset_curves : public testing::Test
{
protected:
  double distance(const Point& p) const
  {
    return std::sqrt(CGAL::squared_distance(p, Kernel::Segment_3(Point(5, 5, 0), Point(14, 8, 0))));
  }

  static Vertex at(const unsigned x, const unsigned y) { return Vertex(x + 20 * y); }

  Mesh m_mesh = to_mesh(flat_grid(20, 14));
  Curve m_curve{{at(5, 5), at(14, 8)}};
};

TEST_F(Offset_curves, have_the_distance_everywhere)
{
  for(const double step : {0.05, 0.3, 1.})
  {
    SCOPED_TRACE(step);
    std::vector<Offset> curves;
    AG::offset_curves(m_mesh, m_curve, std::vector<double>{step, 2 * step, 3 * step},
                      std::back_inserter(curves));
    ASSERT_EQ(curves.size(), 3u);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Offset& c = curves[i];
      EXPECT_DOUBLE_EQ(c.distance, step * double(i + 1));
      EXPECT_TRUE(c.is_closed);
      double length = 0, area = 0;
      for(std::size_t j = 0; j < c.points.size(); ++j)
      {
        const Point p = c.points[j], q = c.points[(j + 1) % c.points.size()];
        EXPECT_NEAR(distance(p), c.distance, 0.01 * step);
        EXPECT_NEAR(distance(CGAL::midpoint(p, q)), c.distance, 0.01 * step);
        length += std::sqrt(CGAL::squared_distance(p, q));
        area += (p.x() * q.y() - p.y() * q.x()) / 2;
      }
      const double pi = std::acos(-1.), straight = std::sqrt(90.);
      EXPECT_NEAR(length, 2 * straight + 2 * pi * c.distance, 0.02 * length);
      EXPECT_GT(area, 0); // the source is on the left
      EXPECT_NEAR(area, 2 * straight * c.distance + pi * c.distance * c.distance, 0.02 * area);
    }
  }
}

// Behind the corner of an L, offsets are circles around it, which are far smaller than their
// distance.
TEST(Offset_curves_around_a_corner, have_the_distance_everywhere)
{
  Soup soup = flat_grid(13, 13);
  const Point corner(6, 6, 0);
  const auto is_outside = [&](const auto& triangle) {
    double x = 0, y = 0;
    for(const std::size_t v : triangle)
    {
      x += soup.points[v].x() / 3;
      y += soup.points[v].y() / 3;
    }
    return x > corner.x() && y < corner.y();
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_outside),
                       soup.triangles.end());
  constexpr double step = 2;
  std::vector<Offset> curves;
  AG::offset_curves(to_mesh(soup), Vertex(6), std::vector<double>{step, 3.2 * step, 5 * step},
                    std::back_inserter(curves));
  std::size_t number = 0;
  for(const Offset& c : curves)
    for(std::size_t i = 1; i < c.points.size(); ++i)
      for(const Point& p : {c.points[i], CGAL::midpoint(c.points[i - 1], c.points[i])})
        if(p.x() > corner.x() && p.y() > corner.y())
        {
          const double rest = std::sqrt(CGAL::squared_distance(p, corner));
          EXPECT_NEAR(corner.y() + rest, c.distance, 0.01 * step) << p;
          ++number;
        }
  EXPECT_GT(number, 10u);
}

// Not all of them: offsets cut corners where several shortest paths meet.
TEST(Offset_curves_on_terrain, have_the_distance_nearly_everywhere)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(24, 20, random));
  AG::Surface_mesh_shortest_path<Mesh, AG::Saddle_vertex_graph> exact(mesh);
  const Vertex start(2 + 24 * 3), end(17 + 24 * 15);
  for(const Curve& source : {Curve{{start, end}}, Curve{{start}}})
  {
    exact.remove_all_source_points();
    exact.add_source_curve(source);
    std::vector<Offset> curves;
    constexpr double step = 0.4;
    AG::offset_curves(mesh, source, std::vector<double>{step, 2 * step, 5 * step, 6 * step},
                      std::back_inserter(curves));
    ASSERT_GE(curves.size(), 4u);
    std::size_t number = 0, number_within = 0;
    for(const Offset& c : curves)
      for(const Point& p : c.points)
      {
        const auto [face, weights] = location_at(mesh, p);
        const double distance = exact.shortest_distance_to_source_points(face, weights).first;
        ++number;
        number_within += std::abs(distance - c.distance) <= 0.01 * step ? 1 : 0;
        EXPECT_NEAR(distance, c.distance, 0.5 * step);
      }
    EXPECT_GT(double(number_within), 0.97 * double(number)) << number;
  }
}

// A plane with random straight sources, whose distances are known.
class Offset_curves_of_several_sources : public testing::Test
{
protected:
  static constexpr double SIZE = 11, STEP = 0.1;

  void compute_from_points(const std::size_t number)
  {
    std::vector<AG::Surface_point<Mesh>> sources;
    for(const Segment& s : add_segments(number, 0))
      sources.push_back(location_at(m_mesh, s.source()));
    compute(sources);
  }

  void compute_from_segments(const std::size_t number)
  {
    std::vector<Curve> sources;
    for(const Segment& s : add_segments(number, 1.5))
      sources.push_back({{location_at(m_mesh, s.source()), location_at(m_mesh, s.target())}});
    compute(sources);
  }

  const std::vector<Segment>& add_segments(const std::size_t number, const double length)
  {
    for(std::size_t i = 0; i < number; ++i)
    {
      const auto coordinate = [&] { return m_random.between(length, SIZE - length); };
      const auto shift = [&] { return m_random.between(-length, length); };
      const Point p(coordinate(), coordinate(), 0);
      m_segments.emplace_back(p, Point(p.x() + shift(), p.y() + shift(), 0));
    }
    return m_segments;
  }

  template <typename Sources>
  void compute(const Sources& sources)
  {
    std::vector<double> distances;
    for(int i = 1; i <= 30; ++i)
      distances.push_back(i * STEP);
    AG::offset_curves(m_mesh, sources, distances, std::back_inserter(m_curves));
  }

  static double distance(const Point& p, const Segment& s)
  {
    return std::sqrt(CGAL::squared_distance(p, s));
  }

  // To the nearest source, and to the second nearest.
  std::pair<double, double> distances(const Point& p) const
  {
    std::vector<double> all{infinity, infinity};
    for(const Segment& s : m_segments)
      all.push_back(distance(p, s));
    std::partial_sort(all.begin(), all.begin() + 2, all.end());
    return {all[0], all[1]};
  }

  void expect_distances_off_medial_axis() const
  {
    for(const Offset& c : m_curves)
      for(std::size_t i = 0; i < c.points.size(); ++i)
      {
        const auto [first, second] = distances(c.points[i]);
        if(second > first + 0.1 * STEP)
        {
          EXPECT_NEAR(first, c.distance, 0.01 * STEP) << c.points[i];
        }
        if(i > 0)
          expect_distance_of_middle(c.points[i - 1], c.points[i], c.distance);
      }
  }

  // Distances are convex along a segment that does not cross the medial axis.
  void expect_distance_of_middle(const Point& p, const Point& q, const double level) const
  {
    const double at_middle = distances(CGAL::midpoint(p, q)).first;
    if(at_middle <= (std::max)(distances(p).first, distances(q).first))
    {
      EXPECT_NEAR(at_middle, level, 0.01 * STEP) << p << ", " << q;
    }
  }

  double distance_from_curves(const Point& p, const double level) const
  {
    double result = infinity;
    for(const Offset& c : m_curves)
      if(c.distance == level)
        for(std::size_t j = c.is_closed ? 0 : 1; j < c.points.size(); ++j)
          result = (std::min)(
              result,
              distance(p, Segment(c.points[j == 0 ? c.points.size() - 1 : j - 1], c.points[j])));
    return result;
  }

  // Points on circles around the ends of sources, as far as these are nearest.
  void expect_complete_circles() const
  {
    constexpr int number_of_angles = 12;
    for(const Segment& s : m_segments)
      for(int i = 1; i <= 30; i += 3)
        for(int k = 0; k < number_of_angles; ++k)
        {
          const double level = i * STEP, angle = 2 * std::acos(-1.) * k / number_of_angles;
          const Point p =
              s.source() + level * Kernel::Vector_3(std::cos(angle), std::sin(angle), 0);
          const bool is_inside = (std::min)({p.x(), p.y(), SIZE - p.x(), SIZE - p.y()}) > STEP;
          const auto [first, second] = distances(p);
          if(is_inside && first > level - 1e-9 && second > level + 5 * STEP)
          {
            EXPECT_LT(distance_from_curves(p, level), 0.1 * STEP) << p << ", at " << level;
          }
        }
  }

  Random m_random{test_seed()};
  Mesh m_mesh = to_mesh(flat_grid(12, 12));
  std::vector<Segment> m_segments;
  std::vector<Offset> m_curves;
};

TEST_F(Offset_curves_of_several_sources, have_the_distance_between_few_points)
{
  compute_from_points(10);
  expect_distances_off_medial_axis();
  expect_complete_circles();
}

TEST_F(Offset_curves_of_several_sources, have_the_distance_between_many_points)
{
  compute_from_points(40);
  expect_distances_off_medial_axis();
  expect_complete_circles();
}

TEST_F(Offset_curves_of_several_sources, have_the_distance_between_segments)
{
  compute_from_segments(12);
  expect_distances_off_medial_axis();
  expect_complete_circles();
}

TEST_F(Offset_curves, are_found_at_distances_that_differ_by_rounding)
{
  std::vector<Offset> curves;
  AG::offset_curves(m_mesh, m_curve, std::vector<double>{0.3, 0.1 * 3}, std::back_inserter(curves));
  EXPECT_EQ(curves.size(), 2u);
  for(const Offset& curve : curves)
    EXPECT_TRUE(curve.is_closed);
}

TEST_F(Offset_curves, are_near_a_curve_at_very_small_distances)
{
  std::vector<Offset> curves;
  AG::offset_curves(m_mesh, m_curve, 1e-9, std::back_inserter(curves));
  for(const Offset& curve : curves)
    for(const Point& p : curve.points)
      EXPECT_LT(distance(p), 1e-3);
}

TEST_F(Offset_curves, are_near_a_region_at_very_small_distances)
{
  std::vector<Offset> curves;
  const AG::Source_region<Mesh> region{{Face(100), Face(101)}};
  AG::offset_curves(m_mesh, region, 0.01, std::back_inserter(curves));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].is_closed);
}

TEST_F(Offset_curves, repeat_no_point)
{
  std::vector<Offset> curves;
  AG::offset_curves(m_mesh, at(9, 7), std::vector<double>{1, 2, 3}, std::back_inserter(curves));
  ASSERT_EQ(curves.size(), 3u);
  for(const Offset& curve : curves)
    for(std::size_t i = 0; i < curve.points.size(); ++i)
      EXPECT_NE(curve.points[i], curve.points[(i + 1) % curve.points.size()]);
}

// A unit square. Three vertices, in no order, are on its lower side, near a corner: four faces have
// no area, and lines between them grow by no more than rounding errors.
Soup square_with_faces_without_area(const double size)
{
  return {{{0, 0, 0},
           {1, 0, 0},
           {1, 1, 0},
           {0, 1, 0},
           {0.45, 0.55, 0},
           {5.8 * size, 0, 0},
           {2.9 * size, 0, 0},
           {0.9 * size, 0, 0}},
          {{0, 5, 4},
           {1, 2, 4},
           {2, 3, 4},
           {3, 0, 4},
           {5, 1, 4},
           {5, 6, 1},
           {0, 7, 6},
           {5, 0, 6},
           {7, 1, 6},
           {0, 1, 7}}};
}

TEST(Offset_curves_beside_faces_without_area, are_found_with_few_queries)
{
  constexpr int most_checks = 100000; // one for each query of the search, and for its lines
  for(const double size : {1e-3, 1e-5, 3e-7, 1e-7, 1e-9})
  {
    SCOPED_TRACE(size);
    const Mesh mesh = to_mesh(square_with_faces_without_area(size));
    const Interruption_at limit(most_checks);
    std::vector<Offset> curves;
    AG::offset_curves(mesh, Vertex(7), 0.3, std::back_inserter(curves));
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_FALSE(curves[0].is_closed);
    EXPECT_LT(curves[0].points.size(), 1000u);
    for(const Point& p : curves[0].points)
      EXPECT_NEAR(std::hypot(p.x() - 0.9 * size, p.y()), 0.3, 0.003);
  }
}

TEST_F(Offset_curves, end_at_the_border)
{
  std::vector<Offset> curves;
  AG::offset_curves(m_mesh, at(0, 0), 6.5, std::back_inserter(curves));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_FALSE(curves[0].is_closed);
  for(const Point& p : curves[0].points)
    EXPECT_NEAR(std::hypot(p.x(), p.y()), 6.5, 0.065);
}

TEST_F(Offset_curves, of_nothing_are_none)
{
  std::vector<Offset> curves;
  AG::offset_curves(m_mesh, m_curve, std::vector<double>{}, std::back_inserter(curves));
  AG::offset_curves(m_mesh, m_curve, 1000, std::back_inserter(curves));
  EXPECT_TRUE(curves.empty());
}

TEST_F(Offset_curves, are_refused_at_distances_that_are_none)
{
  std::vector<Offset> curves;
  for(const double distance : {0., -1., infinity})
    expect_message<std::invalid_argument>(
        [&] { AG::offset_curves(m_mesh, m_curve, distance, std::back_inserter(curves)); },
        "offset 0");
}

// ----- curves of a mesh

TEST_F(Offset_curves, sources_have_distances_in_the_function)
{
  std::vector<double> distances(m_mesh.num_vertices());
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
  CGAL::approximate_geodesic_distances(m_mesh, map, m_curve, parameters::epsilon(0));
  for(const Vertex v : m_mesh.vertices())
    EXPECT_NEAR(distances[v.idx()], distance(m_mesh.point(v)), 1e-9);
  CGAL::approximate_geodesic_distances(m_mesh, map, std::vector<Curve>{m_curve, {{at(0, 0)}}},
                                       parameters::epsilon(0.1));
  for(const Vertex v : m_mesh.vertices())
  {
    const Point p = m_mesh.point(v);
    const double d = (std::min)(distance(p), std::hypot(p.x(), p.y()));
    EXPECT_GE(distances[v.idx()], d - 1e-9);
    EXPECT_LE(distances[v.idx()], 1.1 * d + 1e-9);
  }
}

TEST_F(Offset_curves, sources_have_paths_in_the_function)
{
  std::vector<Point> points;
  const double length = CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), m_curve,
                                                        at(8, 12), parameters::epsilon(0));
  EXPECT_NEAR(length, distance(Point(8, 12, 0)), 1e-9);
  EXPECT_NEAR(distance(points.front()), 0, 1e-9);
  EXPECT_EQ(points.back(), Point(8, 12, 0));
}

TEST_F(Offset_curves, sources_are_those_of_the_class_beside_points_and_regions)
{
  AG::Surface_mesh_shortest_path<Mesh, AG::Saddle_vertex_graph> paths(m_mesh);
  const auto point = paths.add_source_point(at(0, 13));
  const auto curve = paths.add_source_curve(m_curve);
  const auto region = paths.add_source_region({{*m_mesh.faces_begin()}}); // (0, 0), (1, 0), (1, 1)
  const auto nearest = [&](const unsigned x, const unsigned y) {
    return paths.shortest_distance_to_source_points(at(x, y));
  };
  EXPECT_EQ(nearest(0, 12).second, point);
  EXPECT_EQ(nearest(10, 10).second, curve);
  EXPECT_NEAR(nearest(10, 10).first, distance(Point(10, 10, 0)), 1e-9);
  EXPECT_EQ(nearest(1, 0).second, region);
  EXPECT_NEAR(nearest(2, 0).first, 1, 1e-9);
  paths.remove_source_point(curve);
  EXPECT_EQ(nearest(8, 2).second, region);
}

TEST_F(Offset_curves, sources_that_are_none_are_refused)
{
  std::vector<double> distances(m_mesh.num_vertices());
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
  const auto refuse = [&](const auto& sources, const char* const text) {
    expect_message<std::invalid_argument>(
        [&] { CGAL::approximate_geodesic_distances(m_mesh, map, sources); }, text);
  };
  refuse(Curve{}, "a curve has no points");
  refuse(AG::Source_region<Mesh>{}, "a region has no faces");
  refuse(Curve{{Vertex(9999)}}, "point of a curve 0");
  m_mesh.add_vertex(Point(0, 0, 9));
  distances.resize(m_mesh.num_vertices());
  refuse(Curve{{at(0, 0), Vertex(280)}}, "no path joins points 0 and 1");
}

} // namespace
