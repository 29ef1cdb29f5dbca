// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_CSR_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_CSR_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrix_files/Process_team.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesMatrices
 *
 * A sparse distance matrix on disk, in compressed sparse row format: the distances up to
 * `maximum_distance`, or the smallest ones of each row. The entries of a row are those of
 * `Radius_rows` or `Nearest_rows`, in the same order.
 *
 * The matrix is a folder of the four NPY files `data`, `indices`, `indptr` and `shape`, which NumPy
 * maps into memory without reading them:
 *
 * \code{.py}
 * arrays = [numpy.load(f"{folder}/{name}.npy", mmap_mode="r")
 *           for name in ("data", "indices", "indptr", "shape")]
 * matrix = scipy.sparse.csr_matrix(tuple(arrays[:3]), shape=arrays[3])
 * \endcode
 *
 * The folder appears under its name only when it is complete. Until then, the folder `FOLDER.part`
 * has the finished blocks of rows, with their checksums. An interrupted computation is resumed as
 * that of a `Npy_file`, and the resulting files are bitwise identical in the same cases.
 * Completing the matrix temporarily needs disk space for a second copy of all entries.
 *
 * \tparam T the type of distances, `double` or `float`; distances are rounded to it
 *
 * \cgalModels{DistanceRowSink}
 */
template <typename T = double>
class Csr_file : public internal::Matrix_file
{
public:
  /// \name Creation
  /// @{

  /// sets the name of the folder, which is made when the computation ends.
  explicit Csr_file(const std::string& folder) : Matrix_file(folder, nullptr) {}

  /// sets the name of a folder that the processes of `team` compute jointly; each of them makes the
  /// same calls.
  /// \warning `team` is referred to, not copied.
  Csr_file(const std::string& folder, Process_team& team) : Matrix_file(folder, &team) {}

  /// keeps only the `number` smallest distances of each row. \pre `number > 0`
  void keep_nearest(std::size_t number);

  /// @}

  /// \name Row Sink
  /// @{

  /// the entries of a block of rows.
  using Block = internal::Sparse_block<T>;

  /// returns the maximum number of entries per row, or `0` if it is not limited.
  std::size_t number_of_nearest() const { return m_number_of_nearest; }

  /*!
   * opens the files, and determines which blocks are missing.
   *
   * \throws std::invalid_argument if the folder exists already, it is being computed already, or
   *         `FOLDER.part` is damaged or belongs to another computation. The message names the
   *         difference.
   * \throws std::runtime_error if writing fails. The message gives the reason. Completed blocks are
   *         kept.
   */
  void start(const Distance_matrix_plan& plan);

  /// appends a row to a block.
  void collect(Block& block, std::size_t row, const Distance_row& distances) const;

  /// writes a block.
  void add(std::size_t number, Block& block);

  /// returns the next block to compute.
  using internal::Matrix_file::next_block;

  /// returns the number of completed rows, including those of other processes and of earlier runs.
  using internal::Matrix_file::number_of_rows_done;

  /// completes the matrix if all rows are available.
  bool finish(bool /* is_done */) { return Matrix_file::finish(); }

  /// @}

private:
  Block read(std::size_t number) const;
  Block read_intact(std::size_t number) const;
  void prepare_result(const std::string& name) const override;
  bool is_intact(std::size_t block) const override;
  bool is_being_changed() const override { return false; }
  void close() override {}
  void complete() override;

  std::size_t m_number_of_nearest = 0;
};

/*!
 * \ingroup PkgGeodesicLibrariesMatrices
 *
 * writes a sparse matrix to a folder, in the format of `Csr_file`. The folder is created if it does
 * not exist; files of these names are replaced.
 *
 * \tparam T the type of distances, `double` or `float`
 * \param rows the matrix
 * \param folder the name of the folder
 *
 * \throws std::runtime_error if a file cannot be written. The message gives the reason.
 *
 * Run time is linear in the numbers of rows and entries.
 */
template <typename T>
void save_csr(const Sparse_rows<T>& rows, const std::string& folder);

extern template class Csr_file<double>;
extern template class Csr_file<float>;

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_CSR_FILE_H
