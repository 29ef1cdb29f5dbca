// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_READ_FACE_WEIGHTS_H
#define CGAL_GEODESIC_COSTS_READ_FACE_WEIGHTS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_costs/internal/Face_gauges.h>
#include <CGAL/Geodesic_costs/internal/Slope_limit.h>
#include <CGAL/Geodesic_costs/internal/cost_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

namespace internal {
// Scales weights by a power of two, without rounding, so that products with lengths neither
// overflow nor underflow: the largest finite weight is then in [1, 2), or smaller if the unit of
// costs would underflow.
inline void normalize(Face_weights& weights, const double unit_of_lengths)
{
  double largest = 0;
  for(const double w : weights.of_halfedge)
    largest = std::isinf(w) ? largest : (std::max)(largest, w);
  if(largest == 0)
    return;
  const int exponent = exponent_of_costs(largest, unit_of_lengths);
  weights.unit = std::ldexp(1., exponent);
  for(double& w : weights.of_halfedge)
    if(w > 0)
      // stays positive, and not denormalized, which would be slow
      w = (std::max)(std::ldexp(w, -exponent), Face_weights::SMALLEST_WEIGHT);
}

// Throws if the cost of a path, at most `cost` in the given unit, could overflow.
inline void check_cost(const double cost,
                       const double unit,
                       const std::string& kind,
                       const std::string& what_is_impassable)
{
  if(!std::isfinite(cost * unit))
    reject("the " + kind + " and the lengths of the mesh are too large: the cost of a path would " +
           "exceed the largest double. Use infinity for " + what_is_impassable + '.');
}

// Reads the weights of the faces of a mesh. `halfedges` has the order of the triangulation.
template <typename TriangleMesh, typename Halfedges, typename FaceWeightMap>
Face_weights weights_of_faces(const TriangleMesh& tmesh,
                              const Halfedges& halfedges,
                              const FaceWeightMap& face_weight_map,
                              const Intrinsic_triangulation& triangulation)
{
  Face_weights result;
  result.of_halfedge.resize(halfedges.size(), infinity);
  for(Index h = 0; h < halfedges.size(); ++h)
  {
    if(is_border(halfedges[h], tmesh))
      continue;
    const double weight = CGAL::to_double(get(face_weight_map, face(halfedges[h], tmesh)));
    if(!(weight >= 0))
      reject(triangulation.name_of_face(h) + " has weight " + text_of(weight) +
             "; it must be a number that is not negative, or infinity");
    result.of_halfedge[h] = weight + 0.0; // normalizes negative zero
  }
  normalize(result, triangulation.unit());
  double cost_of_all_edges = 0; // once per face, which also covers path ends inside faces
  for(Index h = 0; h < halfedges.size(); ++h)
    if(!std::isinf(result.of_halfedge[h]))
      cost_of_all_edges += result.of_halfedge[h] * triangulation.length(h);
  check_cost(cost_of_all_edges, triangulation.unit() * result.unit, "weights",
             "faces that paths must not enter");
  return result;
}

// An orthonormal basis of the plane of a face: the first vector is along a side, the second points
// toward the third vertex. For a degenerate face, any plane through the side is used.
struct Face_frame
{
  Face_frame(const Space_vector& side, const Space_vector& to_third)
  {
    constexpr double no_area = 1e-14;
    x = normalized(side, {1, 0, 0});
    const Space_vector third = normalized(to_third, x);
    Space_vector across = linear_combination(third, -dot(third, x), x);
    if(!(dot(across, across) > no_area * no_area))
    {
      std::size_t smallest = 0;
      for(const std::size_t i : {std::size_t(1), std::size_t(2)})
        smallest = std::abs(x[i]) < std::abs(x[smallest]) ? i : smallest;
      across = {0, 0, 0};
      across[smallest] = 1;
    }
    y = normalized(linear_combination(across, -dot(across, x), x), x);
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

// Throws if the cost of a path could overflow.
inline void check_cost(const Face_gauges& gauges, const Intrinsic_triangulation& triangulation)
{
  double sum = 0;
  for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(!triangulation.is_border(h))
      sum += gauges.largest_cost(gauges.face(h)) * triangulation.length(h);
  check_cost(sum, triangulation.unit() * gauges.unit(), "costs",
             "directions that paths must not take");
}

// Returns unit vectors along the sides of a face: zero if a side has no length.
inline std::array<Plane_vector, 3> directions_of_sides(const Face_layout& layout)
{
  std::array<Plane_vector, 3> result;
  for(std::size_t i = 0; i < 3; ++i)
    result[i] = direction_of(layout.corner((i + 1) % 3) - layout.corner(i));
  return result;
}

inline Index longest_side(Index h, const Intrinsic_triangulation& triangulation)
{
  for(const auto side : triangulation.halfedges_of_face(h))
    if(triangulation.length(side) > triangulation.length(h))
      h = side;
  return h;
}

// Returns a cost. Throws an error if it is negative or not a number.
inline double checked_cost(const double cost,
                           const Intrinsic_triangulation& triangulation,
                           const Index h,
                           const Space_vector& direction)
{
  if(!(cost >= 0))
    reject(triangulation.name_of_face(h) + " has cost " + text_of(cost) + " in the direction " +
           text_of(direction) + "; it must be a number that is not negative, or infinity");
  return cost + 0.0; // normalizes negative zero
}

// Appends the directions of a plane that are as steep as the limit, up to sign; `rises` are those
// of its axes. Returns false if there are none, or all that the limit allows are too close together
// for a gauge.
inline bool
add_steepest(const Slope_limit limit, const Plane_vector rises, std::vector<Plane_vector>& result)
{
  constexpr double smallest_sine = 1e-6;
  if(!Face_gauges::has_steep_directions(limit, rises))
    return false;
  const double cosine = limit.largest_sine() / length(rises); // of the angle with the steepest one
  if(!(cosine > smallest_sine))
    return false;
  const double sine = std::sqrt((std::max)(1 - cosine * cosine, 0.));
  for(const double s : {sine, -sine})
    result.push_back(turned_left(direction_of(rises), {cosine, s}));
  return true;
}

// Reads the gauges of the faces of a mesh from a function of faces and directions. `halfedges` has
// the order of the triangulation. The x axis of the plane of a face is along its longest side.
// Where the function has no formula, it is sampled; zigzags keep the limit of the slope, too.
template <typename TriangleMesh, typename Halfedges, typename VertexPointMap, typename Cost>
class Gauge_reader
{
  using Kernel =
      typename Kernel_traits<typename boost::property_traits<VertexPointMap>::value_type>::Kernel;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

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

  Face_gauges read(const Slope_limit limit, const double tolerance)
  {
    m_limit = limit;
    m_tolerance = tolerance;
    m_result.reserve(m_halfedges.size(), m_triangulation.number_of_faces());
    for(Index h = 0; h < m_halfedges.size(); ++h)
      if(!m_triangulation.is_border(h) && h == m_triangulation.first_of_face(h))
        add_face(longest_side(h, m_triangulation));
    m_result.normalize(m_triangulation.unit());
    check_cost(m_result, m_triangulation);
    return std::move(m_result);
  }

private:
  void add_face(const Index first)
  {
    const Halfedge base = m_halfedges[first];
    const Face_frame frame(vector_along(base), vector_along(opposite(prev(base, m_mesh), m_mesh)));
    const auto sides = directions_of_sides(Face_layout(m_triangulation, first));
    if(const auto formula = Cost_formulas{frame.x, frame.y}.of(m_cost, face(base, m_mesh)))
      m_result.add(m_triangulation.halfedges_of_face(first), sides, formula);
    else
    {
      sample(first, frame, sides);
      m_result.add(m_triangulation.halfedges_of_face(first), sides, m_samples);
    }
    m_result.limit(m_limit, rises(frame));
  }

  void sample(const Index first, const Face_frame& frame, const std::array<Plane_vector, 3>& sides)
  {
    const auto f = face(m_halfedges[first], m_mesh);
    m_directions.assign(sides.begin(), sides.end());
    const bool is_limited = add_steepest(m_limit, rises(frame), m_directions);
    m_samples.sample(m_directions, m_tolerance, [&](const Plane_vector v) {
      if(is_limited && !Face_gauges::is_allowed(m_limit, rises(frame), v))
        return infinity;
      const Space_vector d = frame(v);
      return checked_cost(m_cost(f, vector_3<Kernel>(d)), m_triangulation, first, d);
    });
  }

  // Returns those of the axes of a plane.
  static Plane_vector rises(const Face_frame& frame) { return {frame.x[2], frame.y[2]}; }

  Space_vector vector_along(const Halfedge h) const
  {
    return space_vector(get(m_point_map, target(h, m_mesh)) - get(m_point_map, source(h, m_mesh)));
  }

  const TriangleMesh& m_mesh;
  const Halfedges& m_halfedges;
  const VertexPointMap& m_point_map;
  const Cost& m_cost;
  const Intrinsic_triangulation& m_triangulation;
  Slope_limit m_limit;
  double m_tolerance = 0;
  Face_gauges m_result;
  Gauge_samples m_samples;                // their memory is reused
  std::vector<Plane_vector> m_directions; // likewise
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

} // namespace internal

/*!
 * \ingroup PkgGeodesicCostsGraphs
 *
 * reads the weights of the faces of a mesh, for replacing the weights of a graph.
 *
 * \param tmesh the mesh from which `triangulation` was built
 * \param triangulation the triangulation
 * \param face_weight_map a property map with the faces of `tmesh` as keys and a number type
 *        convertible by `CGAL::to_double()` as value type: the cost per unit of length
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters":
 *           `vertex_index_map`, if one was given to the triangulation
 *
 * \throws std::invalid_argument if a weight is negative or NaN, if costs overflow a `double`, or if
 *         the number of vertices or halfedges of `tmesh` differs from that of `triangulation`.
 *
 * Run time is \cgalBigO{n} for `n` vertices.
 */
template <typename TriangleMesh,
          typename FaceWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Face_weights read_face_weights(const TriangleMesh& tmesh,
                               const Intrinsic_triangulation& triangulation,
                               const FaceWeightMap& face_weight_map,
                               const NamedParameters& np = parameters::default_values())
{
  Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np), triangulation);
  translation.check_size();
  translation.list_vertices();
  const auto halfedges =
      internal::halfedges_in_groups(translation.vertex_list(), triangulation, tmesh);
  return internal::weights_of_faces(tmesh, halfedges, face_weight_map, triangulation);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_READ_FACE_WEIGHTS_H
