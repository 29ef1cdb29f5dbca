// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_MATRIX_FILES_FLETCHER_CHECKSUM_H
#define APPROXIMATE_GEODESICS_MATRIX_FILES_FLETCHER_CHECKSUM_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

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

#endif // APPROXIMATE_GEODESICS_MATRIX_FILES_FLETCHER_CHECKSUM_H
