// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_HEADER_H
#define APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_HEADER_H

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// NumPy's name of a number type, in the byte order of this machine.
template <typename T>
std::string npy_type()
{
  static_assert(std::is_arithmetic_v<T> && (sizeof(T) == 4 || sizeof(T) == 8));
  const char kind = std::is_floating_point_v<T> ? 'f' : std::is_signed_v<T> ? 'i' : 'u';
  const char order = boost::endian::order::native == boost::endian::order::little ? '<' : '>';
  return std::string(1, order) + kind + std::to_string(sizeof(T));
}

// The header of a NPY file, version 1.0, for an array in row-major order.
inline std::string npy_header(const std::string& descr, const std::vector<std::uint64_t>& shape)
{
  constexpr std::size_t alignment = 64, length_of_prefix = 10;
  std::string text = "{'descr': '" + descr + "', 'fortran_order': False, 'shape': (";
  for(std::size_t i = 0; i < shape.size(); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
  text += shape.size() == 1 ? ",), }" : "), }"; // Python's tuple syntax
  text.append(alignment - 1 - (length_of_prefix + text.size()) % alignment, ' ');
  text += '\n';
  const char length[] = {static_cast<char>(text.size() % 256),
                         static_cast<char>(text.size() / 256)};
  return std::string("\x93NUMPY\1\0", 8) + std::string(length, 2) + text;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_HEADER_H
