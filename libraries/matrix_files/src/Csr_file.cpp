// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/Csr_file.h>

#include "files.h"
#include "formats.h"

#include <CGAL/Geodesic_queries/Rows_in_memory.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {
namespace {

using Column = Distance_row::Column;

/*
 * A one-dimensional array in a NPY file.
 */
template <typename T>
class Npy_array
{
public:
  Npy_array(const std::string& file, const std::uint64_t length)
    : m_header(npy_header(npy_type<T>(), {length})), m_file((write_file(file, m_header), file))
  {
  }

  // Writes numbers from an index on.
  template <typename Number>
  void write(const std::uint64_t index, const Number* const numbers, const std::size_t size)
  {
    const std::vector<T> converted(numbers, numbers + size);
    m_file.write(m_header.size() + index * sizeof(T), converted.data(), size * sizeof(T));
  }

  void sync() { m_file.sync(); }

private:
  std::string m_header;
  Local_file m_file;
};

/*
 * Writes a sparse matrix, whose rows may come in any order.
 */
template <typename T, typename Index>
class Csr_arrays
{
public:
  // `starts` are the indices of the first entries of rows, and of the end.
  Csr_arrays(const std::string& folder,
             const std::vector<std::uint64_t>& starts,
             const std::size_t number_of_columns)
    : m_starts(starts),
      m_data(folder + "/data.npy", starts.back()),
      m_indices(folder + "/indices.npy", starts.back()),
      m_indptr(folder + "/indptr.npy", starts.size()),
      m_shape(folder + "/shape.npy", 2)
  {
    m_indptr.write(0, starts.data(), starts.size());
    const std::size_t shape[] = {starts.size() - 1, number_of_columns};
    m_shape.write(0, shape, 2);
  }

  void write(const std::size_t row, const Column* const columns, const T* const distances)
  {
    const auto size = static_cast<std::size_t>(m_starts[row + 1] - m_starts[row]);
    m_indices.write(m_starts[row], columns, size);
    m_data.write(m_starts[row], distances, size);
  }

  void sync()
  {
    m_data.sync();
    m_indices.sync();
    m_indptr.sync();
    m_shape.sync();
  }

private:
  const std::vector<std::uint64_t>& m_starts;
  Npy_array<T> m_data;
  Npy_array<Index> m_indices, m_indptr;
  Npy_array<std::int64_t> m_shape;
};

// Calls `write(arrays)`, where `arrays.write(row, columns, distances)` writes a row. SciPy uses
// 32-bit indices wherever possible.
template <typename T, typename Write>
void write_csr(const std::string& folder,
               const std::vector<std::uint64_t>& starts,
               const std::size_t number_of_columns,
               const Write& write)
{
  const auto write_arrays = [&](auto arrays) {
    write(arrays);
    arrays.sync();
  };
  constexpr std::uint64_t most = (std::numeric_limits<std::int32_t>::max)();
  if((std::max<std::uint64_t>)(number_of_columns, starts.back()) > most)
    write_arrays(Csr_arrays<T, std::int64_t>(folder, starts, number_of_columns));
  else
    write_arrays(Csr_arrays<T, std::int32_t>(folder, starts, number_of_columns));
}

template <typename V>
void append(const std::vector<V>& values, std::string& bytes)
{
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(V));
}

// Moves on behind the values.
template <typename V>
void extract(const char*& bytes, const std::size_t size, std::vector<V>& values)
{
  values.resize(size);
  std::copy_n(bytes, size * sizeof(V), reinterpret_cast<char*>(values.data()));
  bytes += size * sizeof(V);
}

} // namespace
} // namespace internal

template <typename T>
void Csr_file<T>::keep_nearest(const std::size_t number)
{
  m_number_of_nearest = internal::checked_number_of_nearest(number);
}

template <typename T>
void Csr_file<T>::start(const Distance_matrix_plan& plan)
{
  Matrix_file::start(plan, sizeof(T) + 32, 0); // the number of entries is unknown
}

template <typename T>
void Csr_file<T>::collect(Block& block, const std::size_t row, const Distance_row& distances) const
{
  block.append(row,
               m_number_of_nearest > 0 ? internal::nearest_columns(distances, m_number_of_nearest)
                                       : distances.reached(),
               distances);
}

// The marker of a block has its entries: the numbers of entries of rows, columns, and distances.
template <typename T>
void Csr_file<T>::add(const std::size_t number, Block& block)
{
  std::string bytes;
  internal::append(block.numbers_of_entries, bytes);
  internal::append(block.columns, bytes);
  internal::append(block.distances, bytes);
  internal::Fletcher_checksum checksum(number);
  checksum.add(bytes.data(), bytes.size());
  mark(number, checksum.bytes() + bytes);
  block.clear();
}

// Returns a block without rows if its checksum does not match.
template <typename T>
typename Csr_file<T>::Block Csr_file<T>::read(const std::size_t number) const
{
  const auto rows = plan().rows_of_block(number);
  const std::string bytes = internal::read_file(marker(number));
  const std::size_t first = internal::Fletcher_checksum::SIZE;
  const std::size_t columns = first + rows.size() * sizeof(std::uint32_t);
  if(bytes.size() < columns || bytes.size() % sizeof(std::uint32_t) != 0)
    return {};
  internal::Fletcher_checksum checksum(number);
  checksum.add(bytes.data() + first, bytes.size() - first);
  if(bytes.compare(0, first, checksum.bytes()) != 0)
    return {};
  Block result;
  const std::size_t size = (bytes.size() - columns) / (sizeof(internal::Column) + sizeof(T));
  const char* at = bytes.data() + first;
  internal::extract(at, rows.size(), result.numbers_of_entries);
  internal::extract(at, size, result.columns);
  internal::extract(at, size, result.distances);
  result.rows.assign(rows.begin(), rows.end());
  return result;
}

template <typename T>
void Csr_file<T>::prepare_result(const std::string& name) const
{
  internal::create_folder(name);
}

template <typename T>
bool Csr_file<T>::is_intact(const std::size_t block) const
{
  return !read(block).rows.empty();
}

template <typename T>
typename Csr_file<T>::Block Csr_file<T>::read_intact(const std::size_t number) const
{
  Block result = read(number);
  if(result.rows.empty())
    throw std::runtime_error("Approximate_geodesics: " + marker(number) +
                             " was modified by another program; repeat the call to recompute it");
  return result;
}

template <typename T>
void Csr_file<T>::complete()
{
  std::vector<std::uint64_t> starts(plan().number_of_rows() + 1);
  for(std::size_t number = 0; number < plan().number_of_blocks(); ++number)
  {
    const Block block = read_intact(number);
    for(std::size_t i = 0; i < block.rows.size(); ++i)
      starts[block.rows[i] + 1] = block.numbers_of_entries[i];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  internal::write_csr<T>(result(), starts, plan().number_of_columns(), [&](auto& arrays) {
    for(std::size_t number = 0; number < plan().number_of_blocks(); ++number)
    {
      const Block block = read_intact(number);
      std::size_t from = 0;
      for(std::size_t i = 0; i < block.rows.size(); from += block.numbers_of_entries[i++])
        arrays.write(block.rows[i], block.columns.data() + from, block.distances.data() + from);
    }
  });
}

template <typename T>
void save_csr(const Sparse_rows<T>& rows, const std::string& folder)
{
  std::vector<std::uint64_t> starts{0};
  for(std::size_t row = 0; row < rows.number_of_rows(); ++row)
    starts.push_back(starts.back() + rows.columns(row).size());
  internal::create_folder(folder);
  internal::write_csr<T>(folder, starts, rows.number_of_columns(), [&](auto& arrays) {
    for(std::size_t row = 0; row < rows.number_of_rows(); ++row)
      arrays.write(row, rows.columns(row).begin(), rows.distances(row).begin());
  });
}

template class Csr_file<double>;
template class Csr_file<float>;
template void save_csr(const Sparse_rows<double>&, const std::string&);
template void save_csr(const Sparse_rows<float>&, const std::string&);

} // namespace CGAL::Approximate_geodesics
