// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_KEPT_LABEL_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_KEPT_LABEL_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Grid_files/Grid_window.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A distance in a file, and whether the node is open: whether arcs from it have to be followed
 * since its distance fell, which the sign bit tells. Zeros, as a new file has them, stand for
 * infinity.
 */
class Kept_label
{
public:
  double distance() const { return from_bits((m_bits & ~SIGN) ^ bits_of(INFINITE)); }
  bool is_open() const { return (m_bits & SIGN) != 0; }

  void set_open(const double distance) { m_bits = (bits_of(distance) ^ bits_of(INFINITE)) | SIGN; }
  // Opens a node that is to be reached again: its distance is now an upper bound.
  void open_above() { set_open(std::nextafter(distance(), INFINITE)); }
  void close() { m_bits &= ~SIGN; }

private:
  static constexpr double INFINITE = std::numeric_limits<double>::infinity();
  static constexpr std::uint64_t SIGN = std::uint64_t(1) << 63;

  static std::uint64_t bits_of(const double d)
  {
    std::uint64_t result;
    std::memcpy(&result, &d, sizeof(result));
    return result;
  }

  static double from_bits(const std::uint64_t bits)
  {
    double result;
    std::memcpy(&result, &bits, sizeof(result));
    return result;
  }

  std::uint64_t m_bits = 0;
};

/*
 * The predecessor of a node in a file: its place, relative to that of the node. Zeros stand for
 * none.
 */
class Kept_predecessor
{
public:
  static constexpr std::size_t LARGEST_REACH = 127, LARGEST_SLOT = 65535;

  bool exists() const { return m_bits != 0; }

  void set(const Grid_place& predecessor, const Grid_place& place)
  {
    const auto columns = static_cast<std::uint32_t>(predecessor.column + CENTER - place.column);
    const auto rows = static_cast<std::uint32_t>(predecessor.row + CENTER - place.row);
    m_bits = columns << 24 | rows << 16 | static_cast<std::uint32_t>(predecessor.slot);
  }

  // \pre It exists.
  Grid_place place(const Grid_place& place) const
  {
    return {place.column + (m_bits >> 24) - CENTER, place.row + (m_bits >> 16 & 255) - CENTER,
            m_bits & 65535};
  }

private:
  static constexpr std::size_t CENTER = 128;

  std::uint32_t m_bits = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_KEPT_LABEL_H
