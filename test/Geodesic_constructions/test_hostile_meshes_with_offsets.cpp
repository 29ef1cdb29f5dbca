// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_constructions/offset_curves.h>

#include "meshes/hostile_meshes.h"
#include "oracles/distances_to_curves.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

// Curves at constant distance, on meshes that are as bad as they get.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Exact_search_from_curves = AG::Surface_search<AG::Saddle_vertex_graph>;

// A point, a shortest path between two points, or a polygon of these; a point if a path cannot be
// traced.
Intrinsic_curve random_source(const AG::Saddle_vertex_graph& graph, Random& random)
{
  try
  {
    return {{random_polyline(graph, 1 + random.below(4), random)}};
  }
  catch(const std::invalid_argument&)
  {
    return {{{random_intrinsic_point(graph.triangulation(), random)}}};
  }
}

std::vector<double> some_offsets(const Exact_search_from_curves& search)
{
  double largest = 0;
  for(unsigned v = 0; v < search.graph().triangulation().number_of_vertices(); ++v)
    if(const double d = search.distance(Intrinsic_point::at_vertex(v)); d < infinity)
      largest = (std::max)(largest, d);
  std::vector<double> result;
  for(const double part : {0.01, 0.3, 0.5, 0.7, 0.99})
    if(const double d = part * largest; d > 0 && (result.empty() || d > result.back()))
      result.push_back(d);
  return result;
}

bool is_on_border(const Intrinsic_triangulation& t, const Intrinsic_point& p)
{
  const auto is_border = [&](const unsigned h) {
    return t.is_border(h) || t.is_border(t.opposite(h));
  };
  if(!p.is_vertex())
    return p.is_on_edge() && is_border(p.halfedge);
  bool result = false;
  for(unsigned h = t.first_halfedge(p.vertex); h < t.beyond_halfedge(p.vertex); ++h)
    result = result || is_border(h);
  return result;
}

// Expects that the corners of a face to the left of a piece that crosses it are nearer, and those
// to the right are farther, if the face is far from the sources: there, faces are not divided, but
// pieces may be, in the face.
// Returns the number of corners.
std::size_t expect_sides_of_piece(const Exact_search_from_curves& search,
                                  const Intrinsic_point& p,
                                  const Intrinsic_point& q,
                                  const double offset)
{
  const Intrinsic_triangulation& t = search.graph().triangulation();
  const auto is_in_face = [](const Intrinsic_point& x) {
    return !x.is_vertex() && !x.is_on_edge();
  };
  if(is_in_face(p) || is_in_face(q))
    return 0;
  std::size_t result = 0;
  AG::internal::for_each_segment(t, p, q, [&](const AG::internal::Curve_segment& segment) {
    const AG::internal::Segment_layout layout(t, segment);
    std::array<double, 3> distances;
    double longest = 0;
    for(std::size_t i = 0; i < 3; ++i)
    {
      distances[i] = search.distance(Intrinsic_point::at_vertex(layout.vertex(i)));
      longest = (std::max)(longest, t.length(layout.halfedge(i)));
    }
    if(!(*std::min_element(distances.begin(), distances.end()) > 4 * longest * t.unit()))
      return;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const double y = layout.corner(i).y, small = 1e-6 * longest;
      if(y > small)
      {
        EXPECT_LE(distances[i], offset * (1 + 1e-6));
      }
      if(y < -small)
      {
        EXPECT_GE(distances[i], offset * (1 - 1e-6));
      }
      result += std::abs(y) > small ? 1 : 0;
    }
  });
  return result;
}

// They are ordered by distance; each is closed, or ends at the border; its points follow each other
// in faces, with the sources on the left. Counts the corners that tell this.
void expect_lines(const Exact_search_from_curves& search,
                  const std::vector<double>& offsets,
                  std::size_t& number_of_corners)
{
  const Intrinsic_triangulation& t = search.graph().triangulation();
  AG::internal::Offset_tracer tracer(search, offsets, offsets.back());
  std::size_t number = 0;
  for(const auto& line : tracer.trace())
  {
    EXPECT_GE(line.number, number);
    number = line.number;
    ASSERT_LT(number, offsets.size());
    ASSERT_GT(line.points.size(), 1u);
    const std::size_t size = line.points.size();
    for(std::size_t i = line.is_closed ? 0 : 1; i < size; ++i)
    {
      const Intrinsic_point &p = line.points[(i + size - 1) % size], &q = line.points[i];
      EXPECT_FALSE(p.is_same(q, t));
      EXPECT_LT(AG::internal::shortest_segment(t, p, q).length, infinity);
      number_of_corners += expect_sides_of_piece(search, p, q, offsets[number]);
    }
    if(!line.is_closed)
    {
      EXPECT_TRUE(is_on_border(t, line.points.front()) && is_on_border(t, line.points.back()));
    }
  }
}

TEST(Hostile_meshes, have_offsets_that_are_closed_or_end_at_the_border)
{
  const std::uint64_t seed = test_seed();
  std::size_t number_of_corners = 0;
  for(const Hostile_mesh& hostile : accepted_meshes())
  {
    if(hostile.mesh.number_of_faces() == 0 || !hostile.refusal_across_faces.empty() ||
       hostile.name == "edges of length zero") // points of lines are in the same place
      continue;
    SCOPED_TRACE(hostile.name);
    Random random(seed);
    const AG::Saddle_vertex_graph graph{Triangulation(hostile.mesh)};
    for(int i = 0; i < 4; ++i)
    {
      Exact_search_from_curves search(graph);
      AG::run_from_curves(search, {random_source(graph, random)});
      const std::vector<double> offsets = some_offsets(search);
      if(!offsets.empty())
        expect_lines(search, offsets, number_of_corners);
    }
  }
  EXPECT_GT(number_of_corners, 100u);
}

// In terms of the mesh, with sources of all kinds: numbers, in order, or a documented message.
TEST(Hostile_meshes, have_offsets_of_numbers)
{
  for(const Hostile_mesh& hostile : accepted_meshes())
  {
    if(!hostile.refusal_across_faces.empty())
      continue;
    SCOPED_TRACE(hostile.name);
    const auto expect_numbers = [&](const auto& sources, const double distance) {
      std::vector<AG::Offset_curve<Point>> curves;
      try
      {
        AG::offset_curves(hostile.mesh, sources, std::vector<double>{3 * distance, distance},
                          std::back_inserter(curves));
      }
      catch(const std::invalid_argument& e)
      {
        const std::string text = e.what();
        EXPECT_TRUE(text.find("no path joins") != std::string::npos ||
                    text.find("cannot be traced") != std::string::npos)
            << text;
      }
      EXPECT_TRUE(std::is_sorted(curves.begin(), curves.end(), [](const auto& a, const auto& b) {
        return a.distance < b.distance;
      }));
      for(const auto& curve : curves)
        for(const Point& p : curve.points)
          EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
    };
    const std::vector<Surface_point> vertices = some_vertices(hostile.mesh),
                                     points = some_points(hostile.mesh);
    if(vertices.empty())
      continue;
    for(const double distance : {0.02, 0.4, 1e9})
    {
      const double d = distance * size(hostile.mesh);
      if(!(d > 0 && 3 * d < infinity))
        continue;
      expect_numbers(vertices, d);
      expect_numbers(points, d);
      expect_numbers(AG::Source_curve<Mesh>{vertices, true}, d);
      if(hostile.mesh.number_of_faces() > 0)
        expect_numbers(AG::Source_region<Mesh>{{*hostile.mesh.faces().begin()}}, d);
    }
  }
}

} // namespace
