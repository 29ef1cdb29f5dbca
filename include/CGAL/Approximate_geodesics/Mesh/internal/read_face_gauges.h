// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_READ_FACE_GAUGES_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_READ_FACE_GAUGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_layout.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Gauges/Face_gauges.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Gauges/Gauge_samples.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// An orthonormal basis of the plane of a face: the first vector is along a side, the second points
// toward the third vertex. For a degenerate face, any plane through the side is used.
struct Face_frame
{
  Face_frame(const Space_vector& side, const Space_vector& to_third)
  {
    constexpr double no_area = 1e-14;
    x = normalized(side, {1, 0, 0});
    const Space_vector third = normalized(to_third, x);
    const Space_vector across = linear_combination(third, -dot(third, x), x);
    if(dot(across, across) > no_area * no_area)
      y = normalized(linear_combination(across, -dot(across, x), x), x);
    else
    {
      std::size_t smallest = 0;
      for(const std::size_t i : {std::size_t(1), std::size_t(2)})
        smallest = std::abs(x[i]) < std::abs(x[smallest]) ? i : smallest;
      Space_vector axis{0, 0, 0};
      axis[smallest] = 1;
      y = normalized(linear_combination(axis, -dot(axis, x), x), x);
    }
  }

  Space_vector operator()(const Plane_vector v) const
  {
    return {v.x * x[0] + v.y * y[0], v.x * x[1] + v.y * y[1], v.x * x[2] + v.y * y[2]};
  }

  Space_vector x, y;

private:
  static Space_vector normalized(const Space_vector& v, const Space_vector& if_zero)
  {
    const double largest = (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if(!(largest > 0))
      return if_zero;
    const Space_vector w{v[0] / largest, v[1] / largest, v[2] / largest};
    const double length = std::sqrt(dot(w, w));
    return {w[0] / length, w[1] / length, w[2] / length};
  }
};

/*
 * Reads the gauges of the faces of a mesh from a function of faces and directions. `halfedges` has
 * the order of the triangulation.
 */
template <typename TriangleMesh, typename Halfedges, typename VertexPointMap, typename Cost>
class Gauge_reader
{
  using Index = Intrinsic_triangulation::Index;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using Vector_3 = typename Kernel::Vector_3;
  using FT = typename Kernel::FT;

public:
  Gauge_reader(const TriangleMesh& tmesh,
               const Halfedges& halfedges,
               const VertexPointMap& point_map,
               const Cost& cost,
               const Intrinsic_triangulation& triangulation)
    : m_mesh(tmesh),
      m_halfedges(halfedges),
      m_point_map(point_map),
      m_cost(cost),
      m_triangulation(triangulation)
  {
  }

  Face_gauges read(const double tolerance) const
  {
    Face_gauges result;
    Gauge_samples samples; // whose memory serves all faces
    result.reserve(m_halfedges.size(), m_triangulation.number_of_faces());
    for(Index h = 0; h < m_halfedges.size(); ++h)
    {
      if(m_triangulation.is_border(h))
        continue;
      const auto sides = m_triangulation.halfedges_of_face(h);
      if(h == *std::min_element(sides.begin(), sides.end()))
        add_face(h, tolerance, samples, result);
    }
    result.normalize(m_triangulation.unit());
    check_sum(result);
    return result;
  }

private:
  void add_face(Index h, const double tolerance, Gauge_samples& samples, Face_gauges& result) const
  {
    for(const Index side : m_triangulation.halfedges_of_face(h))
      if(m_triangulation.length(side) > m_triangulation.length(h))
        h = side;
    const Face_layout layout(m_triangulation, h); // the x axis is along the longest side
    std::array<Plane_vector, 3> sides;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Plane_vector way = layout.corner((i + 1) % 3) - layout.corner(i);
      const double distance = length(way);
      sides[i] = distance > 0 ? (1 / distance) * way : Plane_vector{0, 0};
    }
    const auto halfedges = m_triangulation.halfedges_of_face(h);
    const Face_frame frame(vector_along(halfedges[0]), backward(vector_along(halfedges[2])));
    const auto f = face(m_halfedges[h], m_mesh);
    samples.sample(sides, tolerance, [&](const Plane_vector v) {
      const Space_vector d = frame(v);
      const double cost = m_cost(f, Vector_3(FT(d[0]), FT(d[1]), FT(d[2])));
      if(!(cost >= 0))
        refuse(h, d, cost);
      return cost + 0.0; // normalizes negative zero
    });
    result.add(halfedges, sides, samples);
  }

  Space_vector vector_along(const Index h) const
  {
    const auto way = get(m_point_map, target(m_halfedges[h], m_mesh)) -
                     get(m_point_map, source(m_halfedges[h], m_mesh));
    return {CGAL::to_double(way.x()), CGAL::to_double(way.y()), CGAL::to_double(way.z())};
  }

  static Space_vector backward(const Space_vector& v) { return {-v[0], -v[1], -v[2]}; }

  [[noreturn]] void refuse(const Index h, const Space_vector& d, const double cost) const
  {
    reject(m_triangulation.name_of_face(h) + " has cost " + text_of(cost) + " in the direction " +
           text_of(d[0]) + ", " + text_of(d[1]) + ", " + text_of(d[2]) +
           "; it must be a number that is not negative, or infinity");
  }

  // Throws if the cost of a path could overflow.
  void check_sum(const Face_gauges& gauges) const
  {
    std::vector<double> largest(gauges.number_of_faces(), 0);
    for(Index f = 0; f < gauges.number_of_faces(); ++f)
      for(auto s = gauges.first_sector(f); s != gauges.beyond_sector(f); ++s)
        if(s->is_finite())
          largest[f] = (std::max)(largest[f], length(s->functional));
    double sum = 0;
    for(Index h = 0; h < m_halfedges.size(); ++h)
      if(!m_triangulation.is_border(h))
        sum += largest[gauges.face(h)] * m_triangulation.length(h);
    if(!(sum * (m_triangulation.unit() * gauges.unit()) < Face_gauges::infinity))
      reject(
          "the costs and the lengths of the mesh are too large: the cost of a path would be more "
          "than a double can hold. Use infinity for directions that paths must not take.");
  }

  const TriangleMesh& m_mesh;
  const Halfedges& m_halfedges;
  const VertexPointMap& m_point_map;
  const Cost& m_cost;
  const Intrinsic_triangulation& m_triangulation;
};

// Returns the relative sampling error allowed for gauges of convex functions.
template <typename NamedParameters>
double sampling_tolerance([[maybe_unused]] const NamedParameters& np)
{
  constexpr double by_default = 0.01, share = 0.1;
  if constexpr(is_given<NamedParameters, internal_np::epsilon_t>)
    return (std::min)(by_default,
                      share * value_of_number(parameters::get_parameter(np, internal_np::epsilon)));
  else
    return by_default;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_READ_FACE_GAUGES_H
