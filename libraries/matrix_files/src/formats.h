// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_MATRIX_FILES_FORMATS_H
#define APPROXIMATE_GEODESICS_MATRIX_FILES_FORMATS_H

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
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

/*
 * Fletcher's checksum: the sum of 32-bit words, and the sum of these sums, both modulo 2^64. It is
 * several times as fast as a CRC, and detects every change of a single word. It starts with the
 * number of the block, and above zero, so that neither the data of another block matches, nor zeros
 * as a crash leaves them in place of data.
 */
class Fletcher_checksum
{
public:
  explicit Fletcher_checksum(const std::size_t block) : m_sums{block + 1, 0} {}

  // \pre `size` is a multiple of 4.
  void add(const char* bytes, const std::size_t size)
  {
    for(const char* const end = bytes + size; bytes != end; bytes += sizeof(std::uint32_t))
    {
      std::uint32_t word;
      std::memcpy(&word, bytes, sizeof(word));
      m_sums[1] += m_sums[0] += word;
    }
  }

  static constexpr std::size_t SIZE = 2 * sizeof(std::uint64_t);

  // Returns both sums, as bytes.
  std::string bytes() const { return {reinterpret_cast<const char*>(m_sums), SIZE}; }

private:
  std::uint64_t m_sums[2];
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // APPROXIMATE_GEODESICS_MATRIX_FILES_FORMATS_H
