// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_EDGE_LENGTHS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_EDGE_LENGTHS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Reads and checks edge lengths without overflow or underflow: see the remark on units at
// `Intrinsic_triangulation`. Computes the shapes of thin faces in double-double arithmetic.

namespace CGAL::Approximate_geodesics::internal {

// A power of two that scales `extent` to about 2^200 without rounding. Products of four lengths
// then do not overflow, and lengths may be smaller than the extent by a factor of more than 1e300.
class Scale
{
public:
  // Bound on the scaled distance of two points within the extent.
  static constexpr double LARGEST_DISTANCE = 0x1p203;

  explicit Scale(const double extent)
    : m_exponent(extent > 0 ? (std::max)(std::ilogb(extent) - 200, SMALLEST_EXPONENT) : 0),
      m_half_way(std::ldexp(1., -(m_exponent / 2))),
      m_rest(std::ldexp(1., -(m_exponent - m_exponent / 2)))
  {
  }

  double unit() const { return std::ldexp(1., m_exponent); }

  // In two steps, because a single factor could overflow.
  double reduce(const double x) const { return x * m_half_way * m_rest; }

private:
  static constexpr int SMALLEST_EXPONENT = -1074; // of a denormalized double

  int m_exponent;
  double m_half_way;
  double m_rest;
};

// Returns the length of a vector without underflow.
inline double accurate_length(const Space_vector& way)
{
  const double squared = dot(way, way);

  constexpr double smallest_accurate = 1e-280; // below it, squares may underflow
  if(squared > smallest_accurate)
    return std::sqrt(squared);

  const double largest = (std::max)({std::abs(way[0]), std::abs(way[1]), std::abs(way[2])});
  if(largest == 0)
    return 0;
  const Scale scale(largest); // `std::hypot()` is slower and rounds differently
  const Space_vector scaled = {scale.reduce(way[0]), scale.reduce(way[1]), scale.reduce(way[2])};
  return std::sqrt(dot(scaled, scaled)) * scale.unit();
}

using Space_points = std::vector<Space_vector, Uninitialized_allocator<Space_vector>>;

// The edge length of each halfedge, in a unit that is a power of two.
struct Edge_lengths
{
  std::vector<double> of_halfedge;
  double unit = 1;
  Space_points points; // of vertices, in that unit; empty if lengths were given

  // The halfedges to the right of sharp corners, whose faces may be thin; by block of vertices.
  std::vector<std::vector<Index>> sharp_corners;
};

template <typename Connectivity>
std::string name_of_edge(const Index h, const Connectivity& connectivity)
{
  return "edge between vertex " + std::to_string(connectivity.index(connectivity.source(h))) +
         " and vertex " + std::to_string(connectivity.index(connectivity.target(h)));
}

// Reads lengths from a property map.
template <typename TriangleMesh, typename Halfedges, typename EdgeLengthMap, typename Connectivity>
Edge_lengths given_lengths(const TriangleMesh& tmesh,
                           const Halfedges& halfedges,
                           const EdgeLengthMap& edge_length_map,
                           const Connectivity& connectivity)
{
  Edge_lengths result;
  result.of_halfedge.reserve(halfedges.size());
  double extent = 0;
  for(Index h = 0; h < halfedges.size(); ++h)
  {
    const double length = CGAL::to_double(get(edge_length_map, edge(halfedges[h], tmesh)));
    if(!(length >= 0) || std::isinf(length))
      reject("the " + name_of_edge(h, connectivity) + " has length " + text_of(length) +
             "; it must be a finite number that is not negative");
    result.of_halfedge.push_back(length + 0.0); // normalizes negative zero
    extent = (std::max)(extent, length);
  }

  const Scale scale(extent);
  result.unit = scale.unit();
  for(double& length : result.of_halfedge)
    length = scale.reduce(length);
  return result;
}

template <typename Point_3, typename Traits>
Space_vector double_point(const Point_3& p, const Traits& traits)
{
  return {CGAL::to_double(traits.compute_x_3_object()(p)),
          CGAL::to_double(traits.compute_y_3_object()(p)),
          CGAL::to_double(traits.compute_z_3_object()(p))};
}

// The points of a mesh, by the index of the vertex; none if lengths are given.
struct Mesh_points
{
  Space_points of_vertex;
  double extent = 0;                 // without isolated vertices, which do not affect lengths
  Index first_infinite = null_index; // the vertex
};

// Reads the points of vertices that are in the order of their indices, as the adjacency is. Those
// of null vertices are zero.
template <typename TriangleMesh, typename Vertices, typename NamedParameters>
Mesh_points read_points(const TriangleMesh& tmesh,
                        const Vertices& vertices,
                        const Vertex_adjacency& adjacency,
                        const NamedParameters& np)
{
  Mesh_points result;
  if constexpr(!is_given<NamedParameters, internal_np::edge_length_t>)
  { // not instantiated for meshes without points
    using Traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
    const Traits traits = parameters::choose_parameter<Traits>(
        parameters::get_parameter(np, internal_np::geom_traits));
    const auto point_map = vertex_point_map(tmesh, np);
    Space_vector extent{}; // independent maxima
    reserve_huge_pages(result.of_vertex, vertices.size());
    for(Index i = 0; i < vertices.size(); ++i)
    {
      const bool is_removed = vertices[i] == boost::graph_traits<TriangleMesh>::null_vertex();
      const Space_vector p =
          is_removed ? Space_vector{} : double_point(get(point_map, vertices[i]), traits);
      result.of_vertex.push_back(p);
      if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        result.first_infinite = (std::min)(result.first_infinite, i);
      if(adjacency.degree(i) > 0)
        for(std::size_t k = 0; k < 3; ++k)
          extent[k] = (std::max)(extent[k], std::abs(p[k]));
    }
    result.extent = (std::max)({extent[0], extent[1], extent[2]});
  }
  return result;
}

// Returns the unit and the points, in the order of the connectivity, but no lengths yet.
template <typename Connectivity>
Edge_lengths
scale_points(Mesh_points mesh_points, const Connectivity& connectivity, const Loop& loop)
{
  if(mesh_points.first_infinite != null_index)
    reject("vertex " + std::to_string(mesh_points.first_infinite) +
           " has a coordinate that is infinite or not a number");
  constexpr bool has_new_order = std::is_same_v<Connectivity, Intrinsic_triangulation>;
  const Scale scale(mesh_points.extent);
  Space_points points = std::move(mesh_points.of_vertex), other;
  if constexpr(has_new_order)
    resize_in_huge_pages(other, connectivity.number_of_vertices());
  Space_points& ordered = has_new_order ? other : points;
  loop.run_blocks(ordered.size(), [&](const std::size_t first, const std::size_t beyond) {
    for(std::size_t v = first; v < beyond; ++v)
    {
      const Space_vector& p = points[connectivity.index(static_cast<Index>(v))];
      ordered[v] = {scale.reduce(p[0]), scale.reduce(p[1]), scale.reduce(p[2])};
    }
  });
  Edge_lengths result;
  result.unit = scale.unit();
  result.points = std::move(ordered);
  return result;
}

/*
 * A double-double number, with about 32 digits: the unevaluated sum of two `double`s, where `low`
 * is at most half an ulp of `high` (T. J. Dekker, A floating-point technique for extending the
 * available precision, 1971). Without overflow and underflow, sums and products have errors of
 * about 2^-104 relative to their largest term.
 */
struct Double_double
{
  double high, low;
};

// a + b, exactly
inline Double_double exact_sum(const double a, const double b)
{
  const double sum = a + b, part_of_b = sum - a;
  return {sum, (a - (sum - part_of_b)) + (b - part_of_b)};
}

// a * b, exactly
inline Double_double exact_product(const double a, const double b)
{
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline Double_double operator-(const Double_double a) { return {-a.high, -a.low}; }

inline Double_double operator+(const Double_double a, const Double_double b)
{
  const Double_double sum = exact_sum(a.high, b.high);
  return exact_sum(sum.high, sum.low + (a.low + b.low));
}

inline Double_double operator-(const Double_double a, const Double_double b) { return a + -b; }

inline Double_double operator*(const Double_double a, const Double_double b)
{
  const Double_double product = exact_product(a.high, b.high);
  return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

using Accurate_vector = std::array<Double_double, 3>;

inline Accurate_vector accurate_difference(const Space_vector& a, const Space_vector& b)
{
  return {exact_sum(a[0], -b[0]), exact_sum(a[1], -b[1]), exact_sum(a[2], -b[2])};
}

inline double accurate_dot(const Accurate_vector& a, const Accurate_vector& b)
{
  return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).high;
}

// Returns the shape of the face with corners `p`, `q` and `r`.
inline Thin_face thin_face(const Space_vector& p, const Space_vector& q, const Space_vector& r)
{
  const std::array<Accurate_vector, 3> side{accurate_difference(q, p), accurate_difference(r, q),
                                            accurate_difference(p, r)};
  Thin_face result{};
  std::size_t longest = 0; // excluded: the error of the area grows with both sides
  std::array<double, 3> squared_length{};
  for(std::size_t i = 0; i < 3; ++i)
  {
    result.at_corner[i] = -accurate_dot(side[i], side[(i + 2) % 3]);
    squared_length[i] = accurate_dot(side[i], side[i]);
    if(squared_length[i] > squared_length[longest])
      longest = i;
  }
  const Accurate_vector &a = side[(longest + 1) % 3], &b = side[(longest + 2) % 3];
  result.doubled_area =
      accurate_length({(a[1] * b[2] - a[2] * b[1]).high, (a[2] * b[0] - a[0] * b[2]).high,
                       (a[0] * b[1] - a[1] * b[0]).high});
  return result;
}

// A halfedge, and the vector along it.
struct Halfedge_vector
{
  Index halfedge;
  Space_vector way;
  double squared_length;
};

// Adds `right` if the corner between two halfedges is sharp: the angle is almost as small as the
// smallest one of a thin face, 2.2 degrees.
inline void add_if_sharp(const Halfedge_vector& right,
                         const Halfedge_vector& left,
                         std::vector<Index>& sharp_corners)
{
  constexpr double squared_cosine = 1 - 1. / 256; // of 3.6 degrees: a margin for rounding
  constexpr double smallest = 0x1p-960;           // below it, products may underflow
  const double scalar_product = dot(right.way, left.way);
  const double product = right.squared_length * left.squared_length;
  const bool is_sharp =
      scalar_product > 0 && scalar_product * scalar_product > squared_cosine * product;
  if(is_sharp || product < smallest)
    sharp_corners.push_back(right.halfedge);
}

// Returns the first halfedges of the thin faces among those with sharp corners: of faces whose
// shapes cannot be computed accurately from lengths.
inline std::vector<Index> find_thin_faces(const std::vector<std::vector<Index>>& sharp_corners,
                                          const Intrinsic_triangulation& triangulation,
                                          const Loop& loop)
{
  std::vector<std::vector<Index>> shares(sharp_corners.size());
  loop.run(shares.size(), [&](const std::size_t i, std::size_t /* thread */) {
    for(const Index h : sharp_corners[i])
      if(!triangulation.is_border(h))
        if(const auto [a, b, c] = triangulation.halfedges_of_face(h); Thin_faces::is_thin(
               triangulation.length(a), triangulation.length(b), triangulation.length(c)))
          shares[i].push_back((std::min)({a, b, c}));
  });
  std::vector<Index> result;
  for(const std::vector<Index>& share : shares)
    result.insert(result.end(), share.begin(), share.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Computes the shapes of these faces. `points` are the vertices in the unit of the triangulation.
inline Thin_faces thin_faces(const std::vector<std::vector<Index>>& sharp_corners,
                             const Space_points& points,
                             const Intrinsic_triangulation& triangulation,
                             const Loop& loop)
{
  const std::vector<Index> faces = find_thin_faces(sharp_corners, triangulation, loop);
  std::vector<Thin_face> shapes(faces.size());
  loop.run_blocks(faces.size(), [&](const std::size_t first, const std::size_t beyond) {
    for(std::size_t i = first; i < beyond; ++i)
    {
      const auto [a, b, c] = triangulation.halfedges_of_face(faces[i]);
      shapes[i] = thin_face(points[triangulation.target(c)], points[triangulation.target(a)],
                            points[triangulation.target(b)]);
    }
  });
  Thin_faces result;
  for(std::size_t i = 0; i < faces.size(); ++i)
    result.add(triangulation.halfedges_of_face(faces[i]), shapes[i]);
  result.shrink_to_fit();
  return result;
}

// Computes lengths from points, and, for an `Intrinsic_triangulation`, which faces may be thin.
template <typename Connectivity>
Edge_lengths
straight_lengths(Mesh_points points, const Connectivity& connectivity, const Loop& loop)
{
  Edge_lengths result = scale_points(std::move(points), connectivity, loop);
  resize_in_huge_pages(result.of_halfedge, connectivity.number_of_halfedges());
  constexpr bool finds_corners = std::is_same_v<Connectivity, Intrinsic_triangulation>;
  const std::size_t size = result.points.size();
  result.sharp_corners.resize(size / Loop::SIZE_OF_BLOCK + 1);
  loop.run_blocks(size, [&](const std::size_t first, const std::size_t beyond) {
    [[maybe_unused]] std::vector<Index>& share = result.sharp_corners[first / Loop::SIZE_OF_BLOCK];
    const Connectivity& c = connectivity; // these three stay in registers
    const Space_vector* const point = result.points.data();
    double* const lengths = result.of_halfedge.data();
    for(Index v = static_cast<Index>(first); v < beyond; ++v)
    {
      [[maybe_unused]] Halfedge_vector first_side{}, last_side{};
      for(Index h = c.first_halfedge(v); h < c.beyond_halfedge(v); ++h)
      {
        const Space_vector way = difference(point[v], point[c.target(h)]);
        lengths[h] = accurate_length(way);
        if constexpr(finds_corners)
        {
          const Halfedge_vector side{h, way, dot(way, way)};
          if(h > c.first_halfedge(v))
            add_if_sharp(last_side, side, share);
          else
            first_side = side;
          last_side = side;
        }
      }
      if constexpr(finds_corners)
        if(c.degree(v) > 0)
          add_if_sharp(last_side, first_side, share);
    }
  });
  return result;
}

// Twice the sum of all edge lengths bounds the length of any simple path, so distances do not
// overflow if this sum does not.
template <typename Connectivity>
void check_sum(const Edge_lengths& lengths, const Connectivity& connectivity)
{
  const auto& l = lengths.of_halfedge; // contains each edge twice
  if(!std::isinf(Scale::LARGEST_DISTANCE * lengths.unit * static_cast<double>(l.size())))
    return;
  const auto longest = std::max_element(l.begin(), l.end());
  const std::string name = name_of_edge(static_cast<Index>(longest - l.begin()), connectivity);
  if(std::isinf(*longest * lengths.unit))
    reject("the length of the " + name + " does not fit a double");
  if(std::isinf(std::accumulate(l.begin(), l.end(), 0.) * lengths.unit))
    reject("the sum of all edge lengths exceeds half of the largest double; the longest is the " +
           name);
}

// Reads or computes the edge lengths of a mesh. `halfedges` have the order of the connectivity.
template <typename TriangleMesh,
          typename Halfedges,
          typename NamedParameters,
          typename Connectivity>
Edge_lengths read_edge_lengths([[maybe_unused]] const TriangleMesh& tmesh,
                               [[maybe_unused]] Mesh_points points,
                               [[maybe_unused]] const Halfedges& halfedges,
                               const NamedParameters& np,
                               const Connectivity& connectivity)
{
  Edge_lengths result;
  if constexpr(is_given<NamedParameters, internal_np::edge_length_t>)
    result = given_lengths(tmesh, halfedges,
                           parameters::get_parameter(np, internal_np::edge_length), connectivity);
  else
    result = straight_lengths(std::move(points), connectivity,
                              Loop::with_tag<Concurrency_tag<NamedParameters>>());
  check_sum(result, connectivity);
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_EDGE_LENGTHS_H
