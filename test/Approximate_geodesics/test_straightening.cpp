// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "exact_distances.h"
#include "sample_meshes.h"
#include "test_oracles.h"
#include "test_weights.h"

#include <CGAL/Approximate_geodesics/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Place.h>
#include <CGAL/Approximate_geodesics/internal/Straightening.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Paths that are made locally shortest.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Discrete_geodesic_graph;
using AG::Place;
using AG::internal::Path;
using AG::internal::Straightening;
using CGAL::parameters::epsilon;
using Index = Triangulation::Index;
using Vector = Kernel::Vector_3;

const double pi = 4 * std::atan(1.);

double norm(const Vector& v) { return std::sqrt(v.squared_length()); }

// of the triangle with these corners, at `q`
double angle(const Point& p, const Point& q, const Point& r)
{
  const Vector a = p - q, b = r - q;
  return std::atan2(norm(CGAL::cross_product(a, b)), CGAL::scalar_product(a, b));
}

// A mesh and its triangulation, with paths whose lengths are those of the mesh.
class Surface
{
public:
  template <typename... NamedParameters>
  explicit Surface(const Mesh& mesh, const NamedParameters&... np)
    : m_mesh(mesh), m_triangulation(m_mesh, np...)
  {
  }

  const Mesh& mesh() const { return m_mesh; }
  const Triangulation& triangulation() const { return m_triangulation; }

  Place place(const std::size_t v) const { return Place::at_vertex(m_triangulation.vertex(v)); }

  Index halfedge(const std::size_t v, const std::size_t w) const
  {
    const Index a = m_triangulation.vertex(v), b = m_triangulation.vertex(w);
    for(Index h = m_triangulation.first_halfedge(a); h < m_triangulation.beyond_halfedge(a); ++h)
      if(m_triangulation.target(h) == b)
        return h;
    return Triangulation::null_index;
  }

  Point point(const Index v) const
  {
    return m_mesh.point(Vertex(static_cast<Mesh::size_type>(m_triangulation.index(v))));
  }

  Point point(const Place& p) const
  {
    if(p.is_vertex())
      return point(p.vertex);
    const Point a = point(m_triangulation.source(p.halfedge));
    const Point b = point(m_triangulation.target(p.halfedge));
    if(p.is_on_edge())
      return a + p.t * (b - a);
    const Point c = point(m_triangulation.target(m_triangulation.next(p.halfedge)));
    return a + p.t * (b - a) + p.s * (c - a);
  }

  double length(const std::vector<Place>& points) const
  {
    double result = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
      result += norm(point(points[i]) - point(points[i - 1]));
    return result;
  }

  // in the unit of the mesh
  Path shortened(const std::vector<Place>& points) const
  {
    Path result =
        Straightening(m_triangulation).shortened({points, length(points) / m_triangulation.unit()});
    result.length *= m_triangulation.unit();
    return result;
  }

  Path shortened(const std::vector<std::size_t>& vertices) const
  {
    std::vector<Place> points;
    for(const std::size_t v : vertices)
      points.push_back(place(v));
    return shortened(points);
  }

private:
  const Mesh m_mesh;
  const Triangulation m_triangulation;
};

/*
 * Whether a path is locally shortest, from coordinates. There are no parallel edges, and points of
 * the path that follow each other are not at the same place.
 */
class Local_check
{
public:
  explicit Local_check(const Surface& surface)
    : m_surface(surface), m_triangulation(surface.triangulation())
  {
  }

  // How much is missing to an angle of pi, at most, on any side of a vertex that is open; and by
  // how much the angle at an edge differs from it.
  double largest_defect(const std::vector<Place>& points) const
  {
    double result = 0;
    for(std::size_t i = 1; i + 1 < points.size(); ++i)
    {
      const auto &before = points[i - 1], &after = points[i + 1];
      const double defect = points[i].is_vertex() ? defect_at_vertex(before, points[i], after)
                                                  : defect_at_edge(before, points[i], after);
      result = (std::max)(result, defect);
    }
    return result;
  }

private:
  double defect_at_edge(const Place& before, const Place& p, const Place& after) const
  {
    const Point end = m_surface.point(m_triangulation.target(p.halfedge));
    const Point q = m_surface.point(p);
    return std::abs(pi - angle(m_surface.point(before), q, end) -
                    angle(end, q, m_surface.point(after)));
  }

  double defect_at_vertex(const Place& before, const Place& p, const Place& after) const
  {
    const Index v = p.vertex;
    const auto [first, first_angle] = direction(v, before);
    const auto [second, second_angle] = direction(v, after);
    const double one =
        first == second && first_angle <= second_angle
            ? second_angle - first_angle
            : sum_of_corners(v, first, second, second_angle > 0) - first_angle + second_angle;
    const double other =
        first == second && second_angle <= first_angle
            ? first_angle - second_angle
            : sum_of_corners(v, second, first, first_angle > 0) - second_angle + first_angle;
    return (std::max)(pi - one, pi - other);
  }

  bool is_wall(const Index h) const
  {
    return m_triangulation.is_border(h) || m_triangulation.is_border(m_triangulation.opposite(h)) ||
           m_triangulation.is_barrier(h);
  }

  double corner(const Index h) const
  {
    const Index g = m_triangulation.next(h);
    return angle(m_surface.point(m_triangulation.target(h)),
                 m_surface.point(m_triangulation.source(h)),
                 m_surface.point(m_triangulation.target(g)));
  }

  // counterclockwise; infinity if there is a wall in between
  double
  sum_of_corners(const Index v, const Index from, const Index to, const bool crosses_to) const
  {
    double result = 0;
    Index h = from;
    do
    {
      if(m_triangulation.is_border(h) || (h != from && is_wall(h)))
        return infinity;
      result += corner(h);
      h = m_triangulation.counterclockwise(v, h);
    } while(h != to);
    return crosses_to && is_wall(to) ? infinity : result;
  }

  // the halfedge from `v` to the right of a point, and the angle between them
  std::pair<Index, double> direction(const Index v, const Place& p) const
  {
    for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v); ++h)
      if(p.is_vertex() ? m_triangulation.target(h) == p.vertex
                       : p.is_on_edge() && is_edge(h, p.halfedge))
        return {h, 0};
    for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v); ++h)
      if(!m_triangulation.is_border(h) && is_in_face_of(h, p))
        return {h, angle(m_surface.point(m_triangulation.target(h)), m_surface.point(v),
                         m_surface.point(p))};
    ADD_FAILURE() << "the points do not share a face";
    return {m_triangulation.first_halfedge(v), 0};
  }

  bool is_edge(const Index h, const Index g) const
  {
    return h == g || h == m_triangulation.opposite(g);
  }

  bool is_in_face_of(const Index h, const Place& p) const
  {
    const Index g = m_triangulation.next(h), k = m_triangulation.next(g);
    if(p.is_in_face())
      return p.halfedge == h || p.halfedge == g || p.halfedge == k;
    return is_edge(g, p.halfedge);
  }

  const Surface& m_surface;
  const Triangulation& m_triangulation;
};

// The paths in a graph from one vertex to some others.
template <typename GeodesicGraph>
std::vector<Path> paths_from(const GeodesicGraph& graph, const Index source, const Index step)
{
  AG::Propagation<GeodesicGraph> search(graph);
  search.run(source);
  std::vector<Path> result;
  for(Index v = 0; v < graph.number_of_nodes(); v += step)
    if(v != source && search.is_reached(v))
      result.push_back(AG::internal::find_path(search, v));
  return result;
}

void expect_same_ends(const Path& path, const Path& other)
{
  for(const auto& [p, q] : {std::pair{path.points.front(), other.points.front()},
                            std::pair{path.points.back(), other.points.back()}})
  {
    EXPECT_EQ(p.vertex, q.vertex);
    EXPECT_EQ(p.halfedge, q.halfedge);
    EXPECT_EQ(p.t, q.t);
    EXPECT_EQ(p.s, q.s);
  }
}

bool is_repeated(const Place& p, const Place& q)
{
  return p.is_vertex() ? p.vertex == q.vertex : p.halfedge == q.halfedge && p.t == q.t;
}

// What holds for all paths on all meshes; lengths are in the unit of the triangulation.
void expect_sound(const Triangulation& t, const Path& path, const Path& shorter)
{
  const double length = AG::internal::length_of_segments(t, path.points);
  const double sum = AG::internal::length_of_segments(t, shorter.points);
  EXPECT_LE(shorter.length, length);
  EXPECT_NEAR(shorter.length, sum, sum * 1e-12);
  ASSERT_FALSE(shorter.points.empty());
  expect_same_ends(path, shorter);
  for(std::size_t i = 0; i < shorter.points.size(); ++i)
  {
    const Place& p = shorter.points[i];
    EXPECT_TRUE(p.is_vertex() || (p.t >= 0 && p.t <= 1));
    EXPECT_TRUE(i == 0 || !is_repeated(shorter.points[i - 1], p));
  }
}

void expect_idempotent(const Triangulation& t, const Path& path)
{
  const Path again = Straightening(t).shortened(path);
  EXPECT_NEAR(again.length, path.length, path.length * 1e-12);
  EXPECT_EQ(again.points.size(), path.points.size());
  for(std::size_t i = 0; i < (std::min)(again.points.size(), path.points.size()); ++i)
  {
    EXPECT_EQ(again.points[i].vertex, path.points[i].vertex);
    EXPECT_NEAR(again.points[i].t, path.points[i].t, 1e-9);
  }
}

// ----- closed forms

TEST(Straightening, finds_straight_lines_in_the_plane)
{
  const std::size_t columns = 13, rows = 11;
  const Surface surface(to_mesh(flat_grid(columns, rows)));
  const Graph graph{surface.triangulation()};
  for(const std::size_t source : {0u, 5u, 70u, 142u})
    for(const Path& path : paths_from(graph, surface.place(source).vertex, 1))
    {
      const Path straight = surface.shortened(path.points);
      const Point p = surface.point(straight.points.front());
      const Point q = surface.point(straight.points.back());
      EXPECT_NEAR(straight.length, norm(q - p), 1e-12 * norm(q - p));
      for(const Place& place : straight.points)
        EXPECT_NEAR(norm(CGAL::cross_product(surface.point(place) - p, q - p)), 0, 1e-9);
      Path in_unit = straight;
      in_unit.length /= surface.triangulation().unit();
      expect_idempotent(surface.triangulation(), in_unit);
    }
}

Soup cube()
{
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 0, 1),
           Point(1, 0, 1), Point(1, 1, 1), Point(0, 1, 1)},
          {{0, 2, 1},
           {0, 3, 2},
           {4, 5, 6},
           {4, 6, 7},
           {0, 1, 5},
           {0, 5, 4},
           {1, 2, 6},
           {1, 6, 5},
           {2, 3, 7},
           {2, 7, 6},
           {3, 0, 4},
           {3, 4, 7}}};
}

Soup tetrahedron()
{
  return {{Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1)},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

TEST(Straightening, unfolds_cubes)
{
  const Surface surface(to_mesh(cube()));
  EXPECT_NEAR(surface.shortened({0, 1, 2, 6}).length, std::sqrt(5.), 1e-12);
  EXPECT_NEAR(surface.shortened({0, 1, 6}).length, std::sqrt(5.), 1e-12);
  EXPECT_NEAR(surface.shortened({3, 0, 1}).length, std::sqrt(2.), 1e-12);
  EXPECT_NEAR(surface.shortened({0, 1}).length, 1, 1e-12);
  EXPECT_NEAR(surface.shortened({0, 1, 2, 3}).length, 1, 1e-12);
  EXPECT_NEAR(surface.shortened({0, 1, 0, 1}).length, 1, 1e-12); // to and fro
  EXPECT_EQ(surface.shortened({0, 1, 0}).length, 0);
  EXPECT_EQ(surface.shortened({0, 1, 2, 0}).length, 0);
}

// From the middle of a face to that of the face beside it, by way of the third vertex.
TEST(Straightening, unfolds_tetrahedra)
{
  const Surface surface(to_mesh(tetrahedron()));
  const double third = 1. / 3;
  const Place p = Place::in_face(surface.halfedge(0, 1), third, third);
  const Place q = Place::in_face(surface.halfedge(0, 2), third, third);
  const double side = std::sqrt(8.), height = side * std::sqrt(3.) / 2;
  for(const std::size_t by : {0, 2})
    EXPECT_NEAR(surface.shortened({p, surface.place(by), q}).length, 2 * height / 3, 1e-12);
  // by way of the vertex that is farthest: first along one edge, then over another face
  const Path path = surface.shortened({p, surface.place(1), surface.place(3), q});
  EXPECT_NEAR(path.length, 2 * height / 3, 1e-12);
}

TEST(Straightening, unrolls_cylinders)
{
  const std::size_t columns = 25, rows = 9;
  const double step = pi / 20, chord = 2 * std::sin(step / 2);
  const Surface surface(to_mesh(grid(columns, rows, [&](const double i, const double j) {
    return Point(std::cos(step * i), std::sin(step * i), 0.1 * j);
  })));
  const Graph graph{surface.triangulation()};
  for(const Path& path : paths_from(graph, surface.place(0).vertex, 1))
  {
    const Path straight = surface.shortened(path.points);
    const std::size_t source = surface.triangulation().index(path.points.front().vertex);
    const auto i = static_cast<double>(source % columns), j = static_cast<double>(source / columns);
    const double expected = std::hypot(chord * i, 0.1 * j);
    EXPECT_NEAR(straight.length, expected, 1e-12 * expected);
  }
}

// A cone of several rings, with the apex 0.
Soup ringed_cone(const std::size_t meridians, const std::size_t rings, const double height)
{
  Soup result{{Point(0, 0, height)}, {}};
  for(std::size_t j = 1; j <= rings; ++j)
    for(std::size_t i = 0; i < meridians; ++i)
    {
      const double r = static_cast<double>(j) / static_cast<double>(rings);
      const double a = 2 * pi * static_cast<double>(i) / static_cast<double>(meridians);
      result.points.push_back(Point(r * std::cos(a), r * std::sin(a), height * (1 - r)));
    }
  for(std::size_t i = 0; i < meridians; ++i)
  {
    std::size_t a = 1 + i, b = 1 + (i + 1) % meridians;
    result.triangles.push_back({0, a, b});
    for(std::size_t j = 1; j < rings; ++j, a += meridians, b += meridians)
    {
      result.triangles.push_back({a, a + meridians, b + meridians});
      result.triangles.push_back({a, b + meridians, b});
    }
  }
  return result;
}

// A path that goes round the apex, for once or more often, gets to one of the two ways that are
// straight in the unrolled cone.
TEST(Straightening, unrolls_cones)
{
  const std::size_t meridians = 12, rings = 4;
  const double height = 1.5, slant = std::hypot(1, height) * 3 / 4;
  const Surface surface(to_mesh(ringed_cone(meridians, rings, height)));
  const double chord = 2 * std::sin(pi / meridians) * 3 / 4;
  const double step = 2 * std::asin(chord / 2 / slant);
  const auto length = [&](const std::size_t steps) {
    return 2 * slant * std::sin(static_cast<double>(steps) * step / 2);
  };
  for(std::size_t steps = 1; steps < 4 * meridians; ++steps)
  {
    SCOPED_TRACE(steps);
    std::vector<std::size_t> vertices;
    for(std::size_t i = 0; i <= steps; ++i)
      vertices.push_back(1 + 2 * meridians + i % meridians);
    const double found = surface.shortened(vertices).length;
    const double one = length(steps % meridians), other = length(meridians - steps % meridians);
    EXPECT_LE((std::min)(std::abs(found - one), std::abs(found - other)), 1e-12);
    std::reverse(vertices.begin(), vertices.end());
    EXPECT_NEAR(surface.shortened(vertices).length, found, 1e-12);
  }
}

// ----- borders, barriers, saddles

constexpr std::size_t side_of_l = 13, corner_of_l = 6;

// a square without its quarter where both coordinates are above 6
Mesh l_shape()
{
  Soup soup = flat_grid(side_of_l, side_of_l);
  const auto is_outside = [&](const auto& t) {
    const Point center = CGAL::centroid(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    return center.x() > corner_of_l && center.y() > corner_of_l;
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_outside),
                       soup.triangles.end());
  return to_mesh(soup);
}

double length_in_l_shape(const Point& p, const Point& q)
{
  const Point corner(corner_of_l, corner_of_l, 0);
  const Point &low = p.y() < q.y() ? p : q, &high = p.y() < q.y() ? q : p;
  const bool is_around = CGAL::cross_product(high - low, corner - low).z() > 0 &&
                         low.x() > corner.x() && high.y() > corner.y();
  return is_around ? norm(corner - p) + norm(q - corner) : norm(q - p);
}

TEST(Straightening, goes_round_the_corners_of_a_border)
{
  const Surface surface(l_shape());
  const Graph graph{surface.triangulation()};
  for(const std::size_t source : {3 + 12 * side_of_l, 12 + 2 * side_of_l, 0 * side_of_l,
                                  12 + 6 * side_of_l, 6 + 12 * side_of_l})
    for(const Path& path : paths_from(graph, surface.place(source).vertex, 1))
    {
      const Path straight = surface.shortened(path.points);
      const double expected = length_in_l_shape(surface.point(straight.points.front()),
                                                surface.point(straight.points.back()));
      EXPECT_NEAR(straight.length, expected, 1e-12 * expected);
    }
}

TEST(Straightening, follows_a_border)
{
  const Surface surface(l_shape());
  std::vector<std::size_t> vertices;
  for(std::size_t j = 12; j > corner_of_l; --j)
    vertices.push_back(corner_of_l + j * side_of_l);
  for(std::size_t i = corner_of_l; i <= 12; ++i)
    vertices.push_back(i + corner_of_l * side_of_l);
  const Path path = surface.shortened(vertices);
  EXPECT_NEAR(path.length, 12, 1e-12);
  EXPECT_EQ(path.points.size(), 13u);
}

// A wall is a line of barriers, with a path along one side of it, round its end, and to the other.
TEST(Straightening, does_not_cross_barriers)
{
  const std::size_t columns = 9;
  const Mesh mesh = to_mesh(flat_grid(columns, columns));
  Barriers barriers(mesh.num_edges());
  for(const Edge e : mesh.edges())
  {
    const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    barriers[e.idx()] = p.x() == 4 && q.x() == 4 && p.y() <= 6 && q.y() <= 6;
  }
  const Surface surface(mesh, CGAL::parameters::edge_is_constrained_map(barrier_map(barriers)));
  const auto at = [&](const std::size_t i, const std::size_t j) { return i + j * columns; };
  const auto length = [&](const std::vector<std::size_t>& vertices) {
    const Path path = surface.shortened(vertices);
    EXPECT_LE(Local_check(surface).largest_defect(path.points), 1e-9);
    return path.length;
  };
  EXPECT_NEAR(length({at(3, 5), at(3, 6), at(4, 6), at(4, 5), at(5, 5)}), 2 * std::sqrt(2.), 1e-12);
  EXPECT_NEAR(length({at(3, 5), at(4, 5), at(4, 6), at(5, 6), at(5, 5)}), 2 * std::sqrt(2.), 1e-12);
  EXPECT_NEAR(length({at(4, 2), at(4, 3), at(4, 4), at(5, 4), at(5, 3)}), std::sqrt(2.), 1e-12);
  EXPECT_NEAR(length({at(3, 2), at(4, 3), at(4, 4), at(4, 5), at(3, 5)}), 3, 1e-12);
  EXPECT_NEAR(length({at(3, 4), at(4, 4), at(4, 5), at(4, 6), at(4, 5), at(5, 5)}),
              std::sqrt(5.) + std::sqrt(2.), 1e-12);
  EXPECT_NEAR(length({at(4, 0), at(4, 1), at(4, 2), at(4, 3), at(4, 4), at(4, 5), at(4, 6)}), 6,
              1e-12);
}

// A hub whose neighbours are high and low by turns.
TEST(Straightening, goes_through_saddles)
{
  Soup soup = fan(12);
  for(std::size_t i = 1; i < soup.points.size(); ++i)
    soup.points[i] = soup.points[i] + Vector(0, 0, i % 2 == 0 ? 0.5 : -0.5);
  const Surface surface(to_mesh(soup));
  const Path through_hub = surface.shortened({1, 0, 7});
  EXPECT_EQ(through_hub.points.size(), 3u);
  EXPECT_NEAR(through_hub.length, 2 * std::sqrt(1.25), 1e-12);
  EXPECT_NEAR(surface.shortened({1, 2, 3, 4, 5, 6, 7}).length, 2 * std::sqrt(1.25), 1e-12);
  EXPECT_LT(surface.shortened({1, 0, 3}).length, 2 * std::sqrt(1.25) - 0.01);
}

// ----- all meshes

template <typename GeodesicGraph>
void expect_sound_paths(const Surface& surface, const GeodesicGraph& graph, const bool is_regular)
{
  const Triangulation& t = surface.triangulation();
  const Index step = 1 + t.number_of_vertices() / 50;
  for(const Index source : {Index(0), t.number_of_vertices() / 2})
    for(const Path& path : paths_from(graph, source, step))
    {
      const Path shorter = Straightening(t).shortened(path);
      expect_sound(t, path, shorter);
      if(is_regular)
      {
        expect_idempotent(t, shorter);
        EXPECT_LE(Local_check(surface).largest_defect(shorter.points), 1e-9);
      }
    }
}

TEST(Straightening, never_makes_a_path_longer)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    const Surface surface(mesh);
    const bool is_regular = name == "terrain" || name == "sphere" || name == "cone" ||
                            name == "random soup" || name == "another random soup";
    expect_sound_paths(surface, Graph(surface.triangulation()), is_regular);
    expect_sound_paths(surface, Discrete_geodesic_graph(surface.triangulation(), epsilon(0.1)),
                       is_regular);
  }
}

TEST(Straightening, copes_with_faces_without_area)
{
  Random random(test_seed());
  for(std::size_t i = 0; i < 20; ++i)
  {
    const auto part = [&] { return 0.25 * static_cast<double>(1 + random.below(3)); };
    const Surface surface(to_mesh(with_caps(with_caps(flat_grid(6, 5), part), part)));
    expect_sound_paths(surface, Graph(surface.triangulation()), false);
    expect_sound_paths(surface, Discrete_geodesic_graph(surface.triangulation(), epsilon(0.1)),
                       false);
  }
}

TEST(Straightening, copes_with_lengths_that_fit_no_surface)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(12, 12, random));
  std::vector<double> lengths(mesh.num_edges());
  for(double& length : lengths)
    length = random.below(4) == 0 ? 0 : std::pow(10, random.between(-12, 2));
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  const Graph graph(Triangulation(mesh, CGAL::parameters::edge_length_map(map)));
  for(Index source = 0; source < 140; source += 20)
    for(const Path& path : paths_from(graph, source, 1))
      expect_sound(graph.triangulation(), path,
                   Straightening(graph.triangulation()).shortened(path));
}

TEST(Straightening, leaves_points_alone)
{
  const Surface surface(to_mesh(cube()));
  EXPECT_TRUE(surface.shortened(std::vector<Place>()).points.empty());
  for(const Place& p : {surface.place(3), Place::on_edge(surface.halfedge(0, 1), 0.25),
                        Place::in_face(surface.halfedge(0, 1), 0.25, 0.25)})
  {
    const Path path = surface.shortened({p});
    ASSERT_EQ(path.points.size(), 1u);
    EXPECT_EQ(path.length, 0);
    EXPECT_EQ(path.points.front().halfedge, p.halfedge);
  }
}

// ----- ends of every kind

// A point of a face at a vertex, or of an edge there.
Place near_vertex(const Triangulation& t, const Index v, Random& random)
{
  Index h = t.first_halfedge(v) + static_cast<Index>(random.below(t.degree(v)));
  const bool is_on_edge = random.below(2) == 0 || t.is_border(h);
  const double part = random.between(0.1, 0.4), other = random.between(0.1, 0.4);
  if(is_on_edge)
    return random.below(2) == 0 ? Place::on_edge(h, part) : Place::on_edge(t.opposite(h), other);
  const std::size_t turns = random.below(3); // the vertex can be any of the three
  for(std::size_t i = 0; i < turns; ++i)
    h = t.next(h);
  return Place::in_face(h, part, other);
}

TEST(Straightening, starts_and_ends_anywhere)
{
  Random random(test_seed());
  const Surface surface(to_mesh(terrain(30, 20, random)));
  const Triangulation& t = surface.triangulation();
  const Graph graph{t};
  for(const Index source : {0u, 77u, 301u, 599u})
    for(Path path : paths_from(graph, source, 7))
    {
      path.points.insert(path.points.begin(), near_vertex(t, path.points.front().vertex, random));
      path.points.push_back(near_vertex(t, path.points.back().vertex, random));
      const Path shorter = Straightening(t).shortened(path);
      expect_sound(t, path, shorter);
      expect_idempotent(t, shorter);
      EXPECT_LE(Local_check(surface).largest_defect(shorter.points), 1e-9);
      EXPECT_NEAR(surface.length(shorter.points), shorter.length * t.unit(), 1e-9);
    }
}

TEST(Straightening, starts_and_ends_anywhere_in_the_plane)
{
  Random random(test_seed());
  const Surface surface(to_mesh(flat_grid(12, 9)));
  const Triangulation& t = surface.triangulation();
  const Graph graph{t};
  for(const Index source : {0u, 50u, 107u})
    for(Path path : paths_from(graph, source, 1))
    {
      path.points.insert(path.points.begin(), near_vertex(t, path.points.front().vertex, random));
      path.points.push_back(near_vertex(t, path.points.back().vertex, random));
      const Path straight = surface.shortened(path.points);
      const double expected =
          norm(surface.point(path.points.back()) - surface.point(path.points.front()));
      EXPECT_NEAR(straight.length, expected, 1e-12 * (1 + expected));
    }
}

// Next to a vertex, the part of an edge before a point can vanish when it is taken from 1.
TEST(Straightening, starts_next_to_a_vertex)
{
  const Surface surface(to_mesh(flat_grid(4, 4)));
  for(const double t : {1e-18, 1e-17, 1e-16, 1e-15})
    for(const Place start :
        {Place::on_edge(surface.halfedge(5, 6), t), Place::on_edge(surface.halfedge(6, 5), 1 - t)})
      for(const int target : {1, 4, 9, 10})
      {
        const Path path = surface.shortened({start, surface.place(5), surface.place(target)});
        EXPECT_NEAR(path.length, target == 10 ? std::sqrt(2.) : 1., 1e-12);
      }
}

// Points inside faces in the middle of a path are not kept.
TEST(Straightening, takes_points_in_faces_on_the_way)
{
  const Surface surface(to_mesh(flat_grid(4, 4)));
  const Place on_way = Place::in_face(surface.halfedge(0, 1), 0.5, 0.25);
  const Place crossing = Place::on_edge(surface.halfedge(0, 5), 0.75);
  const Path path = surface.shortened({surface.place(1), on_way, crossing, surface.place(4)});
  EXPECT_NEAR(path.length, std::sqrt(2.), 1e-12);
  EXPECT_EQ(path.points.size(), 3u);
}

// ----- exact distances

template <typename GeodesicGraph>
std::size_t number_of_exact_paths(const GeodesicGraph& graph,
                                  const std::vector<double>& exact,
                                  const Vertex source)
{
  const Triangulation& t = graph.triangulation();
  std::size_t result = 0;
  for(const Path& path : paths_from(graph, t.vertex(source.idx()), 1))
  {
    const double expected = exact[t.index(path.points.front().vertex)];
    const double length = Straightening(t).shortened(path).length * t.unit();
    EXPECT_GE(length, expected * (1 - 1e-9));
    result += length <= expected * (1 + 1e-9) ? 1 : 0;
  }
  return result;
}

TEST(Straightening, finds_most_of_the_shortest_paths)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  for(const std::string name : {"elephant.off", "cow.off", "blobby.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    ASSERT_FALSE(mesh.is_empty());
    Random random(test_seed());
    const Vertex source = random_vertex(mesh, random);
    const std::vector<double> exact = exact_distances(mesh, source);
    const auto all = static_cast<double>(mesh.num_vertices());
    const Discrete_geodesic_graph graph(Triangulation(mesh), epsilon(0.1));
    EXPECT_GT(static_cast<double>(number_of_exact_paths(graph, exact, source)), 0.85 * all);
    const Graph edges{Triangulation(mesh)};
    EXPECT_GT(static_cast<double>(number_of_exact_paths(edges, exact, source)), 0.5 * all);
  }
}

} // namespace
