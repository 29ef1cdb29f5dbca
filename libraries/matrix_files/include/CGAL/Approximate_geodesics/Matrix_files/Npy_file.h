// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrix_files/Process_team.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesMatrices
 *
 * A dense distance matrix in a NPY file. `numpy.load(file, mmap_mode="r")` maps it into memory
 * without reading it. Each thread buffers one block of rows: 16 MB, or a single row if that is
 * longer.
 *
 * The file appears under its name only when it is complete. Until then, the folder `FILE.part` has
 * the data, and a marker with a checksum for each finished block of rows. If the computation ends
 * early, because of a visitor, an error, or a kill, the same call resumes it: only the blocks in
 * progress, which have at most 64 rows each, are lost. Blocks that do not match their checksums are
 * computed again, and the resulting file is bitwise identical for any number of threads and
 * processes. Resuming is rejected if the mesh, the graph, the bound, the points, or the type of
 * distances differ. The empty file `FILE.lock` is locked while a program computes the matrix; a
 * killed program leaves it, and the next one removes it.
 *
 * \tparam T the type of distances, `double` or `float`; distances are rounded to it, and are
 *         infinite for columns that were not reached
 *
 * \cgalModels{DistanceRowSink}
 */
template <typename T = double>
class Npy_file : public internal::Matrix_file
{
public:
  /// \name Creation
  /// @{

  /// sets the name of the file, which is opened when the computation starts.
  explicit Npy_file(const std::string& file) : Matrix_file(file, nullptr) {}

  /// sets the name of a file that the processes of `team` compute jointly; each of them makes the
  /// same calls.
  /// \warning `team` is referred to, not copied.
  Npy_file(const std::string& file, Process_team& team) : Matrix_file(file, &team) {}

  /// @}

  /// returns the size of the file of a matrix, in bytes.
  static std::uint64_t length(const std::size_t number_of_rows, const std::size_t number_of_columns)
  {
    return header(number_of_rows, number_of_columns).size() +
           std::uint64_t(sizeof(T)) * number_of_rows * number_of_columns;
  }

  /// \name Row Sink
  /// @{

  /// the distances of a block of rows.
  using Block = std::vector<T>;

  /// symmetric matrices are supported.
  static constexpr bool can_be_symmetric = true;

  /*!
   * opens the files, and determines which blocks are missing.
   *
   * \throws std::invalid_argument if the file exists already, it is being computed already, or
   *         `FILE.part` is damaged or belongs to another computation. The message names the
   *         difference.
   * \throws std::runtime_error if there is not enough disk space, or writing fails. The message
   *         gives the reason. Completed blocks are kept.
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

  /// completes the file if all rows are available.
  bool finish(bool /* is_done */) { return Matrix_file::finish(); }

  /// @}

private:
  static std::string header(std::size_t number_of_rows, std::size_t number_of_columns);

  std::uint64_t offset(const std::size_t row) const { return m_first + row * m_length_of_row; }
  std::uint64_t length() const { return offset(plan().number_of_rows()); }

  void prepare_result(const std::string& name) const override;
  bool is_intact(std::size_t block) const override;
  bool is_being_changed() const override;
  void close() override;
  void complete() override;

  std::uint64_t m_first = 0; // offset of the distances in bytes
  std::uint64_t m_length_of_row = 0;
  std::unique_ptr<Process_team::File> m_data;
};

extern template class Npy_file<double>;
extern template class Npy_file<float>;

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_FILE_H
