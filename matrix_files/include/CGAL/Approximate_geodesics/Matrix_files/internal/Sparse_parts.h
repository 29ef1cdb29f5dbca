// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_SPARSE_PARTS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_SPARSE_PARTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Bulk_checksum.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Sparse_block.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Csr_writer.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Local_file.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file_names.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_journal.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The blocks of a sparse matrix, which each process has appended to its own file. A block stores
 * the number of entries of each row, the columns of all entries, and their distances.
 */
template <typename T>
class Sparse_parts
{
  using Column = typename Sparse_block<T>::Column;

public:
  // Both arguments are referred to, not copied.
  Sparse_parts(const Matrix_file_names& names, const Distance_matrix_plan& plan)
    : m_names(names), m_plan(plan), m_rows(plan.number_of_rows())
  {
  }

  static std::vector<char> bytes(const Sparse_block<T>& block)
  {
    std::vector<char> result;
    append(block.numbers_of_entries, result);
    append(block.columns, result);
    append(block.distances, result);
    return result;
  }

  static std::uint64_t checksum(const std::vector<char>& bytes)
  {
    Bulk_checksum result;
    result.add(bytes);
    return result.value();
  }

  // Whether a block matches its checksum in the journal.
  bool is_there(const std::size_t rank, const Block_record& record)
  {
    if(!std::filesystem::exists(m_names.part(rank)) ||
       record.offset + record.size > file(rank).size())
      return false;
    std::vector<char> bytes(static_cast<std::size_t>(record.size));
    return file(rank).read(record.offset, bytes.data(), bytes.size()) &&
           checksum(bytes) == record.checksum;
  }

  // Verifies a block, and locates the entries of its rows.
  void add(const std::size_t rank, const Block_record& record)
  {
    if(!is_there(rank, record))
      throw std::runtime_error(
          "Approximate_geodesics: " + m_names.part(rank) +
          " was modified by another program; repeat the call to recompute the modified rows");
    const auto rows = m_plan.rows_of_block(static_cast<std::size_t>(record.block));
    std::vector<std::uint32_t> numbers(rows.size());
    read(rank, record.offset, numbers);
    const std::uint64_t first = record.offset + numbers.size() * sizeof(std::uint32_t);
    std::uint64_t number = 0;
    for(const std::uint32_t n : numbers)
      number += n;
    std::uint64_t i = 0;
    for(std::size_t r = 0; r < rows.size(); ++r)
    {
      m_rows[*(rows.begin() + static_cast<std::ptrdiff_t>(r))] = {
          rank, numbers[r], first + i * sizeof(Column),
          first + number * sizeof(Column) + i * sizeof(T)};
      i += numbers[r];
    }
  }

  // Writes all rows, in order, to a NPZ file for SciPy.
  void put_together(const std::string& name)
  {
    std::vector<std::uint32_t> numbers;
    std::uint64_t number_of_entries = 0;
    for(const Row& row : m_rows)
    {
      numbers.push_back(row.number_of_entries);
      number_of_entries += row.number_of_entries;
    }
    Csr_writer writer(name, {m_rows.size(), m_plan.number_of_columns(), number_of_entries});
    writer.begin_rows();
    writer.append_rows(numbers.data(), numbers.size());
    writer.begin_columns();
    for_each_row<Column>(&Row::columns, [&](const std::vector<Column>& columns) {
      writer.append_columns(columns.data(), columns.size());
    });
    writer.begin_values<T>();
    for_each_row<T>(&Row::distances, [&](const std::vector<T>& distances) {
      writer.append_values(distances.data(), distances.size());
    });
    writer.finish();
  }

private:
  // The location of the entries of a row.
  struct Row
  {
    std::size_t rank;
    std::uint32_t number_of_entries;
    std::uint64_t columns;   // offset in bytes
    std::uint64_t distances; // offset in bytes
  };

  template <typename V>
  static void append(const std::vector<V>& values, std::vector<char>& bytes)
  {
    const char* const first = reinterpret_cast<const char*>(values.data());
    bytes.insert(bytes.end(), first, first + values.size() * sizeof(V));
  }

  Local_file& file(const std::size_t rank)
  {
    std::unique_ptr<Local_file>& result = m_files[rank];
    if(!result)
      result = std::make_unique<Local_file>(m_names.part(rank));
    return *result;
  }

  template <typename V>
  void read(const std::size_t rank, const std::uint64_t offset, std::vector<V>& values)
  {
    file(rank).read_all(offset, values.data(), values.size() * sizeof(V));
  }

  template <typename V, typename F>
  void for_each_row(const std::uint64_t Row::*const offset, F f)
  {
    std::vector<V> values;
    for(const Row& row : m_rows)
    {
      values.resize(row.number_of_entries);
      read(row.rank, row.*offset, values);
      f(values);
    }
  }

  const Matrix_file_names& m_names;
  const Distance_matrix_plan& m_plan;
  std::vector<Row> m_rows;
  std::map<std::size_t, std::unique_ptr<Local_file>> m_files; // by rank
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_SPARSE_PARTS_H
