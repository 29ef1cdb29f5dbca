// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_PARTS_OF_MESHES_H
#define APPROXIMATE_GEODESICS_TEST_PARTS_OF_MESHES_H

#include "checks/expect_message.h"
#include "meshes/hostile_meshes.h"
#include "meshes/surface_points.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/iterator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <vector>

namespace geodesics_test {

constexpr double rounding_of_lengths = 1e-12;

// ----- meshes large enough for parts

// A terrain with holes, and with vertices between fans of faces that only they connect.
inline Soup perforated_terrain(const std::size_t columns, const std::size_t rows, Random& random)
{
  Soup result = terrain(columns, rows, random);
  std::vector<std::size_t> holes;
  for(std::size_t f = 0; f < result.triangles.size(); ++f)
    if(random.below(5) == 0)
      holes.push_back(f);
  return without_faces(result, holes);
}

// As `to_mesh()`, which accepts no vertex between several fans: all their borders are linked.
inline Mesh to_mesh_with_fans(const Soup& soup)
{
  Mesh result;
  for(const Point& p : soup.points)
    result.add_vertex(p);
  for(const auto& t : soup.triangles)
  {
    const auto v = [&](const std::size_t i) { return Vertex(static_cast<Mesh::size_type>(t[i])); };
    EXPECT_NE(result.add_face(v(0), v(1), v(2)), Mesh::null_face());
  }
  return result;
}

inline std::vector<Named_mesh> large_meshes()
{
  Random random(test_seed());
  std::vector<Named_mesh> result;
  result.push_back({"terrain", to_mesh(terrain(60, 50, random))});
  result.push_back({"perforated", to_mesh_with_fans(perforated_terrain(70, 60, random))});
  result.push_back({"sphere", to_mesh(sphere(60, 50))});
  result.push_back({"flat grid", to_mesh(flat_grid(50, 50))});
  return result;
}

// A point close to another one, or any one.
inline Surface_point random_target(const Mesh& mesh, const Surface_point& source, Random& random)
{
  const double radius = random.between(0, 0.15) * size(mesh);
  for(int i = 0; i < 300; ++i)
  {
    const Surface_point result = random_surface_point(mesh, random);
    if(CGAL::squared_distance(position(mesh, source), position(mesh, result)) < radius * radius)
      return result;
  }
  return random_surface_point(mesh, random);
}

// ----- functions that read all, or a part

inline auto without_part(const double epsilon)
{
  return CGAL::parameters::epsilon(epsilon).visitor(
      CGAL::Approximate_geodesics::Geodesic_visitor_base());
}

// without a look at the points, where squares of coordinates do not fit a `double`
template <typename NamedParameters>
double bare_length(const Mesh& mesh, const Vertex s, const Vertex t, const NamedParameters& np)
{
  return CGAL::approximate_geodesic_path(mesh, CGAL::Emptyset_iterator(), s, t, np);
}

template <typename Source, typename Target, typename NamedParameters>
double length_of_path(const Mesh& mesh,
                      const Source& source,
                      const Target& target,
                      const NamedParameters& np)
{
  std::vector<Point> points;
  const double result =
      CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source, target, np);
  EXPECT_EQ(points.empty(), std::isinf(result));
  if(!points.empty())
  {
    EXPECT_NEAR(length_of(points), result, rounding_of_lengths * (result + size(mesh)));
  }
  return result;
}

// The first part that is searched, if any.
template <typename TriangleMesh, typename Source, typename Target, typename NamedParameters>
auto part_between(const TriangleMesh& mesh,
                  const Source& source,
                  const Target& target,
                  const NamedParameters& np)
{
  namespace internal = CGAL::Approximate_geodesics::internal;
  std::optional<internal::Mesh_part<TriangleMesh>> result;
  internal::Part_to_read(mesh, np).between(source, target, [&](const auto& part, double) {
    result = part;
    return std::optional<double>(0);
  });
  return result;
}

inline void expect_same_length(const double a, const double b, const Mesh& mesh)
{
  EXPECT_EQ(std::isinf(a), std::isinf(b));
  if(std::isfinite(b))
  {
    EXPECT_NEAR(a, b, rounding_of_lengths * (b + size(mesh)));
  }
}

template <typename Sources, typename NamedParameters>
std::vector<double>
distances_from(const Mesh& mesh, const Sources& sources, const NamedParameters& np)
{
  std::vector<double> result(mesh.num_vertices(), -1);
  CGAL::approximate_geodesic_distances(
      mesh, boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh)),
      sources, np);
  return result;
}

// Calls `f(mesh, source, target)` for random points of all large meshes.
template <typename F>
void for_each_random_pair(F f)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : large_meshes())
  {
    SCOPED_TRACE(name);
    for(int i = 0; i < 10; ++i)
    {
      const Surface_point source = random_surface_point(mesh, random);
      f(mesh, source, random_target(mesh, source, random));
    }
  }
}

// ----- bad input

class Bad_part : public testing::Test
{
protected:
  template <typename... Texts>
  void expect_rejection(const Mesh& mesh, const Texts&... texts) const
  {
    for(const double epsilon : {0., 0.1})
      expect_message<std::invalid_argument>(
          [&] { length_of_path(mesh, near, near_too, CGAL::parameters::epsilon(epsilon)); },
          texts...);
    expect_message<std::invalid_argument>(
        [&] { distances_from(mesh, near, CGAL::parameters::maximum_distance(2.5)); }, texts...);
  }

  static constexpr Mesh::size_type n = 50;
  static Vertex at(const Mesh::size_type i, const Mesh::size_type j) { return Vertex(i + n * j); }

  const Vertex near = at(10, 10), near_too = at(12, 10);
  Mesh m_mesh = to_mesh(flat_grid(n, n));
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_PARTS_OF_MESHES_H
