// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_DISTANCES_TO_CURVES_H
#define APPROXIMATE_GEODESICS_TEST_DISTANCES_TO_CURVES_H

#include "meshes/surface_points.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Curves on a triangulation, and what distances from them must be.

namespace geodesics_test {

using CGAL::Approximate_geodesics::Intrinsic_curve;
using CGAL::Approximate_geodesics::Intrinsic_point;
using CGAL::Approximate_geodesics::Intrinsic_triangulation;
using CGAL::Approximate_geodesics::Surface_search;
using Polyline_on_surface = std::vector<Intrinsic_point>;

// A random vertex, point on an edge, or point in a face.
inline Intrinsic_point random_intrinsic_point(const Intrinsic_triangulation& t, Random& random)
{
  std::size_t h = random.below(t.number_of_halfedges());
  while(t.is_border(static_cast<unsigned>(h)))
    h = random.below(t.number_of_halfedges());
  const auto halfedge = static_cast<unsigned>(h);
  const std::size_t kind = random.below(3);
  if(kind == 0)
    return Intrinsic_point::at_vertex(t.source(halfedge));
  if(kind == 1)
    return Intrinsic_point::on_edge(halfedge, random.between(0.01, 0.99));
  const double part = random.between(0.01, 0.98);
  return Intrinsic_point::in_face(halfedge, part, random.between(0.005, 0.995 - part));
}

// Random points that are joined by shortest paths; fewer if there are none.
template <typename Graph>
Polyline_on_surface random_polyline(const Graph& graph, const std::size_t number, Random& random)
{
  Surface_search<Graph> search(graph);
  Polyline_on_surface result{random_intrinsic_point(graph.triangulation(), random)};
  for(std::size_t i = 1; i < number; ++i)
  {
    const Intrinsic_point last = result.back();
    search.run_to(last, {{random_intrinsic_point(graph.triangulation(), random)}});
    const Polyline_on_surface path = search.find_path(last).points;
    if(!path.empty())
      result.insert(result.end(), path.begin() + 1, path.end());
  }
  return result;
}

// The point of the segment from `p` to `q` at the part `t` of the way.
inline Intrinsic_point point_between(const Intrinsic_triangulation& triangulation,
                                     const Intrinsic_point& p,
                                     const Intrinsic_point& q,
                                     const double t)
{
  Intrinsic_point result = p;
  CGAL::Approximate_geodesics::internal::for_each_segment(
      triangulation, p, q, [&](const auto& segment) { result = segment.point(triangulation, t); });
  return result;
}

// The smallest distance to a polyline, after a search from a single point: samples, and a search in
// nested intervals around the best ones. Between neighboring samples, distances are nearly convex.
template <typename Search>
double distance_to_polyline(const Search& search, const Polyline_on_surface& polyline)
{
  const Intrinsic_triangulation& t = search.graph().triangulation();
  constexpr int parts = 6;
  double best = search.distance(polyline.front());
  const auto at = [&](const std::size_t i, const double part) {
    return search.distance(point_between(t, polyline[i], polyline[i + 1], part));
  };
  struct Sample_of_curve
  {
    double distance;
    std::size_t segment;
    double part;
  };
  std::vector<Sample_of_curve> samples;
  for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
    for(int k = 0; k <= parts; ++k)
      samples.push_back({at(i, double(k) / parts), i, double(k) / parts});
  std::sort(samples.begin(), samples.end(), [](const Sample_of_curve& a, const Sample_of_curve& b) {
    return a.distance < b.distance;
  });
  samples.resize((std::min)(samples.size(), std::size_t(4)));
  for(const Sample_of_curve& s : samples)
  {
    double low = (std::max)(0., s.part - 1. / parts), high = (std::min)(1., s.part + 1. / parts);
    for(int step = 0; step < 45; ++step)
    {
      const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
      const double at_a = at(s.segment, a), at_b = at(s.segment, b);
      best = (std::min)({best, at_a, at_b});
      (at_a < at_b ? high : low) = at_a < at_b ? b : a;
    }
  }
  return best;
}

// Expects that the path from `p` ends on the curve, and that its length is the distance; or a
// message that it cannot be traced across nearly degenerate faces.
template <typename Search>
void expect_path_to_curve(const Search& search, const Intrinsic_point& p, const double tolerance)
{
  const auto answer = search.nearest(p);
  if(!answer.is_reached())
    return;
  CGAL::Approximate_geodesics::Path path;
  try
  {
    path = search.find_path(p);
  }
  catch(const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("cannot be traced"), std::string::npos) << e.what();
    return;
  }
  ASSERT_FALSE(path.points.empty());
  EXPECT_NEAR(path.length, answer.distance, tolerance * answer.distance + tolerance * 1e-9);
  EXPECT_TRUE(path.points.back().is_same(answer.start, search.graph().triangulation()));
  EXPECT_LE(search.distance(path.points.back()), tolerance * (1 + answer.distance));
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_DISTANCES_TO_CURVES_H
