// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_CSR_WRITER_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_CSR_WRITER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Npz_writer.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Zip_writer.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

struct Size_of_csr
{
  std::uint64_t rows;
  std::uint64_t columns;
  std::uint64_t entries;
};

/*
 * Writes a sparse matrix in CSR format for `scipy.sparse.load_npz`. Call `begin_rows()`,
 * `begin_columns()` and `begin_values()` in any order, once each; append all elements of an array
 * before the next array begins. Errors and limits are as in `Npz_writer`.
 */
class Csr_writer
{
public:
  Csr_writer(const std::string& file,
             const Size_of_csr& size,
             const std::uint64_t limit = Zip_writer::LIMIT)
    : m_arrays(file, limit), m_size(size)
  {
  }

  void begin_rows()
  {
    begin_indices("indptr", m_size.rows + 1);
    const std::uint64_t begin = 0;
    append_indices(&begin, 1);
  }

  // Appends the number of entries of each row.
  void append_rows(const std::uint32_t* lengths, const std::size_t number)
  {
    for(std::size_t i = 0; i < number; ++i)
    {
      m_end_of_row += lengths[i];
      append_indices(&m_end_of_row, 1);
    }
  }

  void begin_columns() { begin_indices("indices", m_size.entries); }

  void append_columns(const std::uint32_t* columns, const std::size_t number)
  {
    append_indices(columns, number);
  }

  template <typename T>
  void begin_values()
  {
    end();
    m_arrays.begin<T>("data", {m_size.entries});
    m_has_begun = true;
  }

  template <typename T>
  void append_values(const T* values, const std::size_t number)
  {
    m_arrays.append(values, number);
  }

  void finish()
  {
    end();
    CGAL_assertion_msg(m_end_of_row == m_size.entries, "all entries are in a row");
    m_arrays.write("shape", std::vector<std::int64_t>{static_cast<std::int64_t>(m_size.rows),
                                                      static_cast<std::int64_t>(m_size.columns)});
    m_arrays.write_text("format", "csr");
    m_arrays.finish();
  }

private:
  // SciPy uses 32-bit indices wherever possible.
  bool are_indices_long() const
  {
    return std::max(m_size.columns, m_size.entries) >
           static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  }

  void begin_indices(const std::string& name, const std::uint64_t number)
  {
    end();
    if(are_indices_long())
      m_arrays.begin<std::int64_t>(name, {number});
    else
      m_arrays.begin<std::int32_t>(name, {number});
    m_has_begun = true;
  }

  template <typename Index>
  void append_indices(const Index* indices, const std::size_t number)
  {
    if(are_indices_long())
      m_arrays.append_as<std::int64_t>(indices, number);
    else
      m_arrays.append_as<std::int32_t>(indices, number);
  }

  void end()
  {
    if(m_has_begun)
      m_arrays.end();
    m_has_begun = false;
  }

  Npz_writer m_arrays;
  Size_of_csr m_size;
  std::uint64_t m_end_of_row = 0;
  bool m_has_begun = false;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_CSR_WRITER_H
