// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_SAVE_NPZ_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_SAVE_NPZ_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Sparse_rows.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Csr_writer.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * writes a sparse matrix to a NPZ file for `scipy.sparse.load_npz()`.
 *
 * \tparam T the type of distances, `double` or `float`
 * \param rows the matrix
 * \param file the name of the file
 *
 * \throws std::runtime_error if the file cannot be written. The message gives the reason.
 *
 * Run time is linear in the numbers of rows and entries.
 */
template <typename T>
void save_npz(const Sparse_rows<T>& rows, const std::string& file)
{
  const std::size_t number_of_rows = rows.number_of_rows(), entries = rows.number_of_entries();
  std::vector<std::uint32_t> lengths;
  lengths.reserve(number_of_rows);
  for(std::size_t row = 0; row < number_of_rows; ++row)
    lengths.push_back(static_cast<std::uint32_t>(rows.columns(row).size()));
  internal::Csr_writer writer(file, {number_of_rows, rows.number_of_columns(), entries});
  writer.begin_rows();
  writer.append_rows(lengths.data(), number_of_rows);
  writer.begin_columns();
  for(std::size_t row = 0; row < number_of_rows; ++row)
    writer.append_columns(rows.columns(row).begin(), lengths[row]);
  writer.template begin_values<T>();
  for(std::size_t row = 0; row < number_of_rows; ++row)
    writer.append_values(rows.distances(row).begin(), lengths[row]);
  writer.finish();
}

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_SAVE_NPZ_H
