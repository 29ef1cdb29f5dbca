// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_READ_THIN_FACES_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_READ_THIN_FACES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Thin_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Computes the shapes of thin faces from coordinates in double-double arithmetic.

namespace CGAL::Approximate_geodesics::internal {

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

// Returns the area of the parallelogram spanned by `a` and `b`.
inline double accurate_area(const Accurate_vector& a, const Accurate_vector& b)
{
  return accurate_length({(a[1] * b[2] - a[2] * b[1]).high, (a[2] * b[0] - a[0] * b[2]).high,
                          (a[0] * b[1] - a[1] * b[0]).high});
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
  result.doubled_area = accurate_area(side[(longest + 1) % 3], side[(longest + 2) % 3]);
  return result;
}

/*
 * Collects candidates for thin faces while lengths are computed. The smallest angle of a thin face
 * is below 2.2 degrees.
 */
class Sharp_corners
{
public:
  using Index = Intrinsic_triangulation::Index;

  // Precondition: the connectivity of the triangulation is complete.
  explicit Sharp_corners(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  // Adds the next halfedge, counterclockwise around a vertex, and its vector `way`.
  void add(const Index h, const Space_vector& way)
  {
    const Side side{way, dot(way, way), h};
    if(m_is_first)
      m_first = side;
    else
      add_corner(m_last, side);
    m_last = side;
    m_is_first = false;
  }

  // Must be called after the last halfedge of a vertex.
  void finish()
  {
    if(!m_is_first)
      add_corner(m_last, m_first);
    m_is_first = true;
  }

  // Adds the faces that `other` has collected at other vertices of the same triangulation.
  void merge(const Sharp_corners& other)
  {
    m_faces.insert(m_faces.end(), other.m_faces.begin(), other.m_faces.end());
  }

  // Returns the first halfedge of each collected face, in increasing order.
  std::vector<Index> faces() &&
  {
    std::sort(m_faces.begin(), m_faces.end());
    m_faces.erase(std::unique(m_faces.begin(), m_faces.end()), m_faces.end());
    return std::move(m_faces);
  }

private:
  struct Side
  {
    Space_vector way;
    double squared_length;
    Index halfedge;
  };

  void add_corner(const Side& right, const Side& left)
  {
    constexpr double squared_cosine = 1 - 1. / 256; // of 3.6 degrees: a margin for rounding
    constexpr double smallest = 0x1p-960;           // below it, products may underflow
    const double scalar_product = dot(right.way, left.way);
    const double product = right.squared_length * left.squared_length;
    const bool is_sharp =
        scalar_product > 0 && scalar_product * scalar_product > squared_cosine * product;
    if((is_sharp || product < smallest) && !m_triangulation.is_border(right.halfedge))
    {
      const auto sides = m_triangulation.halfedges_of_face(right.halfedge);
      m_faces.push_back(*std::min_element(sides.begin(), sides.end()));
    }
  }

  const Intrinsic_triangulation& m_triangulation;
  std::vector<Index> m_faces;
  Side m_first{}, m_last{};
  bool m_is_first = true;
};

// Selects the thin faces among `faces`: those whose shapes cannot be computed accurately from
// lengths. Faces are given by their first halfedges, in increasing order. `points` are the vertices
// in the unit of the triangulation.
inline Thin_faces thin_faces(const std::vector<Intrinsic_triangulation::Index>& faces,
                             const std::vector<Space_vector>& points,
                             const Intrinsic_triangulation& triangulation)
{
  Thin_faces result;
  for(const auto h : faces)
  {
    const Thin_faces::Halfedges sides = triangulation.halfedges_of_face(h);
    if(Thin_faces::is_thin(triangulation.length(h), triangulation.length(sides[1]),
                           triangulation.length(sides[2])))
      result.add(sides,
                 thin_face(points[triangulation.target(sides[2])], points[triangulation.target(h)],
                           points[triangulation.target(sides[1])]));
  }
  result.shrink_to_fit();
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_READ_THIN_FACES_H
