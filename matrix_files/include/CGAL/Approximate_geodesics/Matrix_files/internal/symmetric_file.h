// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_SYMMETRIC_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_SYMMETRIC_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * A square matrix in a file. Only two square tiles at a time are in memory.
 */
template <typename T, typename File>
class Square_matrix_file
{
public:
  // `first` is the offset of the matrix in bytes.
  Square_matrix_file(File& file, const std::uint64_t first, const std::size_t size)
    : m_file(file),
      m_first(first),
      m_size(size),
      m_side((std::min)(size, std::size_t(1024))),
      m_below(m_side * m_side),
      m_above(m_side * m_side)
  {
  }

  // Replaces each entry and its transpose by the smaller of the two. The operation is idempotent.
  void make_symmetric()
  {
    for(std::size_t i = 0; i < m_size; i += m_side)
      for(std::size_t j = 0; j <= i; j += m_side)
      {
        transfer(i, j, m_below, &File::read_all);
        transfer(j, i, m_above, &File::read_all);
        take_smaller();
        transfer(i, j, m_below, &File::write);
        transfer(j, i, m_above, &File::write);
      }
  }

private:
  // Reads or writes a tile.
  template <typename Transfer>
  void transfer(const std::size_t row,
                const std::size_t column,
                std::vector<T>& square,
                const Transfer transfer_bytes)
  {
    const std::size_t width = (std::min)(m_side, m_size - column);
    for(std::size_t i = 0; i < m_side && row + i < m_size; ++i)
    {
      const std::uint64_t position = std::uint64_t(row + i) * m_size + column;
      (m_file.*transfer_bytes)(m_first + position * sizeof(T), square.data() + i * m_side,
                               width * sizeof(T));
    }
  }

  void take_smaller()
  {
    for(std::size_t i = 0; i < m_side; ++i)
      for(std::size_t j = 0; j < m_side; ++j)
      {
        T& below = m_below[i * m_side + j];
        T& above = m_above[j * m_side + i];
        below = above = little_endian((std::min)(little_endian(below), little_endian(above)));
      }
  }

  File& m_file;
  std::uint64_t m_first;
  std::size_t m_size;
  std::size_t m_side;              // of a tile
  std::vector<T> m_below, m_above; // row-major, `m_side` entries per row
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_SYMMETRIC_FILE_H
