// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_NPZ_WRITER_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_NPZ_WRITER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Zip_writer.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/npy_header.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Writes an archive of arrays in the format of `numpy.savez`. Arrays are written in pieces and are
 * never held in memory. Errors and limits are as in `Zip_writer`.
 */
class Npz_writer
{
public:
  explicit Npz_writer(const std::string& file, const std::uint64_t limit = Zip_writer::LIMIT)
    : m_archive(file, limit)
  {
  }

  // Begins an array of elements of type T. Its elements must follow in row-major order.
  template <typename T>
  void begin(const std::string& name, const std::vector<std::uint64_t>& shape)
  {
    begin(name, npy_type<T>(), sizeof(T), shape);
  }

  // Appends numbers, converted to T.
  template <typename T, typename Number>
  void append_as(const Number* numbers, std::size_t size)
  {
    std::array<char, 1024 * sizeof(T)> piece;
    while(size > 0)
    {
      const std::size_t size_of_piece = std::min<std::size_t>(size, 1024);
      char* out = piece.data();
      for(std::size_t i = 0; i < size_of_piece; ++i)
      {
        const auto bytes = to_bytes(static_cast<T>(numbers[i]));
        out = std::copy(bytes.begin(), bytes.end(), out);
      }
      m_archive.append(piece.data(), size_of_piece * sizeof(T));
      numbers += size_of_piece;
      size -= size_of_piece;
    }
  }

  template <typename T>
  void append(const T* numbers, const std::size_t size)
  {
    append_as<T>(numbers, size);
  }

  void end() { m_archive.end(); }

  // Writes a one-dimensional array.
  template <typename T>
  void write(const std::string& name, const std::vector<T>& numbers)
  {
    begin<T>(name, {numbers.size()});
    append(numbers.data(), numbers.size());
    end();
  }

  // Writes a byte string as a zero-dimensional array.
  void write_text(const std::string& name, const std::string& text)
  {
    begin(name, "|S" + std::to_string(text.size()), text.size(), {});
    m_archive.append(text);
    end();
  }

  void finish() { m_archive.finish(); }

private:
  void begin(const std::string& name,
             const std::string& descr,
             const std::uint64_t size_of_element,
             const std::vector<std::uint64_t>& shape)
  {
    const std::string header = npy_header(descr, shape);
    const std::uint64_t size =
        std::accumulate(shape.begin(), shape.end(), size_of_element, std::multiplies<>());
    m_archive.begin(name + ".npy", header.size() + size);
    m_archive.append(header);
  }

  Zip_writer m_archive;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_NPZ_WRITER_H
