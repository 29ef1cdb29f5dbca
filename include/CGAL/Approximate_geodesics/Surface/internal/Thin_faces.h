// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_THIN_FACES_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_THIN_FACES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * What says all of the shape of a face, where the lengths of its sides do not: to be divided by two
 * of these.
 */
struct Thin_face
{
  // for each corner, the scalar product of the two sides, as vectors that start there
  std::array<double, 3> at_corner;
  double doubled_area;
};

/*
 * The shapes of a mesh's thin faces. A cap, whose corners are nearly in line, has a height that is
 * as small as the rounding errors of its sides, or smaller; and at the short edge of a needle, the
 * angles depend on the difference of the two long ones.
 *
 * A face takes 36 bytes, and if there is one, 128 halfedges take 4 more, to find it.
 */
class Thin_faces
{
public:
  using Halfedges = std::array<Index, 3>; // of a face, one after the other

  bool is_empty() const { return m_halfedge.empty(); }

  // Whether the shape of a triangle with these sides is to be known better than they tell it. They
  // have relative errors of about 3 * 2^-53. Where this is false, those of the height, and of the
  // position of a corner seen from another one, are below 1e-12.
  static bool is_thin(const double a, const double b, const double c)
  {
    constexpr double worst = 4096;        // times the error of a side
    constexpr double smallest = 0x1p-900; // below, products may have lost bits to underflow
    const double smaller = (std::min)(a, b), larger = (std::max)(a, b);
    const double x = (std::max)(larger, c), z = (std::min)(smaller, c);
    const double y = (std::max)(smaller, (std::min)(larger, c));
    const double size = z * (x + (y + z));
    // Heron's formula multiplies these differences, whose errors are those of the sides
    return 2 * size > worst * ((z - (x - y)) * (z + (x - y))) && size > smallest;
  }

  // Adds the shape of the face with these halfedges, whose corners are their sources.
  // \pre The first one has the smallest number, and a larger one than those of the faces before.
  void add(const Halfedges& halfedges, const Thin_face& face)
  {
    const std::size_t block = halfedges[0] / SIZE_OF_BLOCK;
    while(m_first_of_block.size() <= block)
      m_first_of_block.push_back(static_cast<Index>(m_halfedge.size()));
    m_halfedge.push_back(halfedges[0]);
    m_face.push_back(face);
    m_has_extreme_needles = m_has_extreme_needles || is_extreme_needle(face);
  }

  // Whether there are needles so long that the ends of their short sides, where they are laid out
  // far from the origin, say too little of the directions of these sides.
  bool has_extreme_needles() const { return m_has_extreme_needles; }

  void shrink_to_fit()
  {
    m_first_of_block.shrink_to_fit();
    m_halfedge.shrink_to_fit();
    m_face.shrink_to_fit();
  }

  // The shape of the face with these halfedges, whose corners are their sources, if it is there.
  std::optional<Thin_face> find(const Halfedges& halfedges) const
  {
    const auto first = std::min_element(halfedges.begin(), halfedges.end());
    const std::size_t block = *first / SIZE_OF_BLOCK;
    if(block >= m_first_of_block.size())
      return std::nullopt;
    const auto beyond = block + 1 < m_first_of_block.size()
                            ? m_halfedge.begin() + m_first_of_block[block + 1]
                            : m_halfedge.end();
    const auto found =
        std::lower_bound(m_halfedge.begin() + m_first_of_block[block], beyond, *first);
    if(found == beyond || *found != *first)
      return std::nullopt;
    Thin_face result = m_face[static_cast<std::size_t>(found - m_halfedge.begin())];
    std::rotate(result.at_corner.begin(),
                result.at_corner.begin() + (halfedges.begin() - first + 3) % 3,
                result.at_corner.end());
    return result;
  }

  std::size_t number_of_faces() const { return m_face.size(); }

  std::size_t memory() const
  {
    return (m_first_of_block.capacity() + m_halfedge.capacity()) * sizeof(Index) +
           m_face.capacity() * sizeof(Thin_face);
  }

private:
  static constexpr Index SIZE_OF_BLOCK = 128; // so many halfedges

  static bool is_extreme_needle(const Thin_face& face)
  {
    constexpr double largest_aspect = 0x1p20; // of a needle, squared sides of which are these sums
    const auto [a, b, c] = face.at_corner;
    const auto [shortest, longest] = std::minmax({a + b, b + c, c + a});
    return longest > largest_aspect * largest_aspect * shortest;
  }

  std::vector<Index> m_first_of_block; // the number of its first face
  std::vector<Index> m_halfedge;       // of each face, the one with the smallest number
  std::vector<Thin_face> m_face;       // from that on
  bool m_has_extreme_needles = false;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_THIN_FACES_H
