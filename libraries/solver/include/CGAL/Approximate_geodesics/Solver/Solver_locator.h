// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_LOCATOR_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_LOCATOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_locations.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/aabb_traits.h>
#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL::Approximate_geodesics {
namespace internal {

// The points of a mesh, scaled by a power of two, without rounding, so that squared distances
// neither overflow nor underflow.
class Scaled_points
{
  using Point = Simple_cartesian<double>::Point_3;
  using Mesh = Solver::Mesh;

public:
  using key_type = Mesh::Vertex_index;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;

  Scaled_points() = default;

  explicit Scaled_points(const Mesh& mesh) : m_mesh(&mesh)
  {
    double largest = 0;
    for(const auto v : vertices(mesh))
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

} // namespace internal

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The nearest points of the surface of a `Solver` to points in space. Its header is not part of
 * `Solver.h`, because CGAL's AABB tree takes long to compile.
 *
 * All `const` member functions are thread-safe.
 */
class Solver_locator
{
  using Kernel = Simple_cartesian<double>;
  using Mesh = Solver::Mesh;
  using Locations = Surface_locations<Mesh>;
  using Primitive = AABB_face_graph_triangle_primitive<Mesh, internal::Scaled_points>;
  using Tree = AABB_tree<AABB_traits_3<Kernel, Primitive>>;

public:
  /// A point of the surface.
  struct Location
  {
    std::int64_t face;                 ///< its face
    std::array<double, 3> coordinates; ///< its barycentric coordinates in the face
    double distance;                   ///< its distance from the point in space
  };

  /// builds a tree of the faces, of about 200 bytes each. The solver is referred to, not copied.
  /// \throws std::invalid_argument if the mesh has no faces.
  explicit Solver_locator(const Solver& solver) : m_mesh(solver.mesh()), m_points(m_mesh)
  {
    if(m_mesh.number_of_faces() == 0)
      internal::reject("the mesh has no faces to locate points in");
    Locations::build_aabb_tree(m_mesh, m_tree, m_points);
    const double origin[] = {0, 0, 0};
    nearest(0, origin); // the first query completes the tree, and is not thread-safe
  }

  Solver_locator(const Solver_locator&) = delete;
  Solver_locator& operator=(const Solver_locator&) = delete;

  /*!
   * writes the nearest points of the surface to points in space. Barycentric coordinates of at most
   * 1e-10 become zero, so that points on edges and vertices are there exactly.
   *
   * \param points the coordinates of the points, three each
   * \param number their number
   * \param result receives a `Location` per point
   * \param watch is called during the run
   *
   * \throws std::invalid_argument if a coordinate is not finite, or more than 1e100 times as large
   *         as those of the mesh.
   * \throws Solver_interrupted if the watch ends the call.
   */
  template <typename OutputIterator>
  OutputIterator locate(const double* const points,
                        const std::size_t number,
                        OutputIterator result,
                        const Solver_watch& watch = Solver_watch()) const
  {
    constexpr std::size_t points_between_calls = 1024;
    for(std::size_t i = 0; i < number; ++i)
    {
      if(i % points_between_calls == 0 && watch.go_further && !watch.go_further())
        throw Solver_interrupted();
      *result++ = nearest(i, points + 3 * i);
    }
    return result;
  }

private:
  Location nearest(const std::size_t number, const double* const p) const
  {
    const Kernel::Point_3 point(m_points.scaled(p[0]), m_points.scaled(p[1]),
                                m_points.scaled(p[2]));
    // also for NaN; squares of greater numbers would be less accurate than the coordinates
    if(!(std::abs(point.x()) + std::abs(point.y()) + std::abs(point.z()) <= 1e100))
      internal::reject("point " + std::to_string(number) + " is (" + internal::text_of(p[0]) +
                       ", " + internal::text_of(p[1]) + ", " + internal::text_of(p[2]) +
                       "); coordinates must be finite, and at most 1e100 times as large as those "
                       "of the mesh");
    const auto [face, weights] = Locations::locate(point, m_tree, m_mesh, m_points);
    const auto found = Locations::point(face, weights, m_mesh, m_points);
    return {static_cast<std::int64_t>(face),
            {weights[0], weights[1], weights[2]},
            m_points.unscaled(std::sqrt(CGAL::squared_distance(point, found)))};
  }

  const Mesh& m_mesh;
  internal::Scaled_points m_points;
  Tree m_tree;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_LOCATOR_H
