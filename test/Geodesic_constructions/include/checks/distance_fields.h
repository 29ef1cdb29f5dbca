// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_DISTANCE_FIELDS_H
#define APPROXIMATE_GEODESICS_TEST_DISTANCE_FIELDS_H

#include "oracles/straight_lines.h"
#include "oracles/test_oracles.h"

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <vector>

// Functions on the vertices of a mesh, and what is made of them.

namespace geodesics_test {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Vector = Kernel::Vector_3;
using Polyline = std::vector<Point>;

// A function of the vertices as a property map.
template <typename F>
auto at_vertices(F f)
{
  return boost::make_function_property_map<Vertex, double>(f);
}

// A function of the points of `mesh`, which is referred to.
template <typename F>
auto at_points(const Mesh& mesh, F f)
{
  return at_vertices([&mesh, f](const Vertex v) { return double(f(mesh.point(v))); });
}

inline auto from_vector(const std::vector<double>& values)
{
  return at_vertices([&values](const Vertex v) { return values[v.idx()]; });
}

inline std::array<Vertex, 3> corners(const Mesh& mesh, const Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

template <typename Map>
std::vector<Polyline> isolines(const Mesh& mesh, const Map& map, const std::vector<double>& values)
{
  std::vector<Polyline> result;
  AG::isolines(mesh, map, values, std::back_inserter(result));
  return result;
}

inline bool is_closed(const Polyline& polyline) { return polyline.front() == polyline.back(); }

inline double length(const std::vector<Polyline>& polylines)
{
  double result = 0;
  for(const Polyline& polyline : polylines)
    for(std::size_t i = 1; i < polyline.size(); ++i)
      result += distance_in_space(polyline[i - 1], polyline[i]);
  return result;
}

inline testing::AssertionResult are_clean(const std::vector<Polyline>& polylines)
{
  for(const Polyline& polyline : polylines)
    if(polyline.size() < 2 ||
       std::adjacent_find(polyline.begin(), polyline.end()) != polyline.end())
      return testing::AssertionFailure() << "a polyline has repeated points, or just one";
  return testing::AssertionSuccess();
}

// The lengths of the isoline in all faces, added up face by face.
inline double
length_in_faces(const Mesh& mesh, const std::vector<double>& values, const double isovalue)
{
  double result = 0;
  for(const Face f : mesh.faces())
  {
    Polyline ends;
    const std::array<Vertex, 3> v = corners(mesh, f);
    bool is_reached = true;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Vertex a = v[i], b = v[(i + 1) % 3];
      const double x = values[a.idx()], y = values[b.idx()];
      is_reached = is_reached && std::isfinite(x);
      if((x >= isovalue) != (y >= isovalue))
        ends.push_back(CGAL::barycenter(mesh.point(b), (isovalue - x) / (y - x), mesh.point(a)));
    }
    if(is_reached && !ends.empty())
      result += distance_in_space(ends.at(0), ends.at(1));
  }
  return result;
}

template <typename Map>
std::vector<Vector> gradients(const Mesh& mesh, const Map& map)
{
  std::map<Face, Vector> found;
  AG::gradient(mesh, map, boost::make_assoc_property_map(found));
  std::vector<Vector> result;
  for(const Face f : mesh.faces())
    result.push_back(found.at(f));
  return result;
}

template <typename NamedParameters = parameters::Default_named_parameters>
std::vector<int> partition(const Mesh& mesh,
                           const std::vector<Vertex>& sources,
                           const NamedParameters& np = parameters::default_values())
{
  std::map<Face, int> found;
  AG::voronoi_partition(mesh, boost::make_assoc_property_map(found), sources, np);
  std::vector<int> result;
  for(const Face f : mesh.faces())
    result.push_back(found.at(f));
  return result;
}

struct Sample
{
  std::vector<Vertex> points;
  double radius = 0;
};

template <typename... NamedParameters>
Sample sample(const Mesh& mesh,
              const std::vector<Vertex>& sources,
              const std::size_t number,
              const NamedParameters&... np)
{
  Sample result;
  result.radius =
      AG::farthest_point_sampling(mesh, std::back_inserter(result.points), number, sources, np...);
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_DISTANCE_FIELDS_H
