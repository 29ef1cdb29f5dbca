// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "locations.h"

#include "running.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_locations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace python {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = Locator::Mesh;

// The points of a mesh, scaled by a power of two, without rounding, so that squared distances
// neither overflow nor underflow.
class Scaled_points
{
public:
  using key_type = Mesh::Vertex_index;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;

  Scaled_points() = default;

  explicit Scaled_points(const Mesh& mesh) : m_mesh(&mesh)
  {
    double largest = 0;
    for(const auto v : mesh.vertices())
      for(int i = 0; i < 3; ++i)
        largest = (std::max)(largest, std::abs(mesh.point(v)[i]));
    constexpr int most = 1000; // so that neither factor overflows
    if(largest > 0)
      m_unit = std::ldexp(1., (std::clamp)(std::ilogb(largest), -most, most));
    m_factor = 1 / m_unit;
  }

  double scaled(const double x) const { return m_factor * x; }
  double unscaled(const double x) const { return m_unit * x; }

  friend Point get(const Scaled_points& points, const Mesh::Vertex_index v)
  {
    const Point& p = points.m_mesh->point(v);
    return {points.scaled(p.x()), points.scaled(p.y()), points.scaled(p.z())};
  }

private:
  const Mesh* m_mesh = nullptr;
  double m_unit = 1, m_factor = 1;
};

} // namespace

class Locator::Tree
{
  using Locations = AG::Surface_locations<Mesh>;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh, Scaled_points>;
  using Faces = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

public:
  explicit Tree(const Mesh& mesh) : m_mesh(mesh), m_points(mesh)
  {
    if(mesh.number_of_faces() == 0)
      AG::internal::reject("the mesh has no faces to locate points in");
    Locations::build_aabb_tree(mesh, m_faces, m_points);
    const double origin[] = {0, 0, 0};
    nearest(0, origin); // the first query completes the tree, and is not thread-safe
  }

  struct Place
  {
    Locations::Face_location location;
    double distance;
  };

  Place nearest(const std::size_t number, const double* const p) const
  {
    const Point point(m_points.scaled(p[0]), m_points.scaled(p[1]), m_points.scaled(p[2]));
    // also for NaN; squares of greater numbers would be less accurate than the coordinates
    if(!(std::abs(point.x()) + std::abs(point.y()) + std::abs(point.z()) <= 1e100))
      AG::internal::reject(
          "point " + std::to_string(number) + " is (" + AG::internal::text_of(p[0]) + ", " +
          AG::internal::text_of(p[1]) + ", " + AG::internal::text_of(p[2]) +
          "); coordinates must be finite, and at most 1e100 times as large as those of the mesh");
    const auto location = Locations::locate(point, m_faces, m_mesh, m_points);
    const Point found = Locations::point(location.first, location.second, m_mesh, m_points);
    return {location, m_points.unscaled(std::sqrt(CGAL::squared_distance(point, found)))};
  }

private:
  const Mesh& m_mesh;
  Scaled_points m_points;
  Faces m_faces;
};

Locator::Locator(const Mesh& mesh)
  : m_tree(run(py::none(), [&](const auto&) { return std::make_unique<const Tree>(mesh); }))
{
}

Locator::~Locator() = default;

py::tuple Locator::locate(const Array<double>& points) const
{
  constexpr std::size_t points_between_looks = 1024;
  const py::ssize_t size = points.shape(0);
  Array<std::int64_t> faces(size);
  Array<double> coordinates({size, py::ssize_t(3)}), distances(size);
  const double* const from = points.data();
  std::int64_t* const to_faces = faces.mutable_data();
  double *const to_coordinates = coordinates.mutable_data(),
                *to_distances = distances.mutable_data();
  run(py::none(), [&](const AG::Solver_watch& watch) {
    for(std::size_t i = 0; i < static_cast<std::size_t>(size); ++i)
    {
      if(i % points_between_looks == 0 && !watch.go_further())
        throw AG::Solver_interrupted();
      const auto [location, distance] = m_tree->nearest(i, from + 3 * i);
      to_faces[i] = static_cast<std::int64_t>(location.first);
      std::copy(location.second.begin(), location.second.end(), to_coordinates + 3 * i);
      to_distances[i] = distance;
    }
  });
  return py::make_tuple(faces, coordinates, distances);
}

} // namespace python
