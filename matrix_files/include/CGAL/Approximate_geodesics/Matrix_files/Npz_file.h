// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPZ_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPZ_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Sparse_block.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/nearest_columns.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Single_process.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Local_file.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file_base.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_journal.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Sparse_parts.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * A sparse distance matrix in a NPZ file, for `scipy.sparse.load_npz(file)`: the distances up to
 * `maximum_distance`, or the smallest ones of each row. The entries of a row are those of
 * `Radius_rows` or `Nearest_rows`, in the same order.
 *
 * The file appears under its name only when it is complete. Until then, the data is in `FILE.part`,
 * and the journal `FILE.journal` lists the blocks of rows that are on disk, with their checksums.
 * If the computation ends early, because of a visitor, an error, or a kill, the same call resumes
 * it: blocks that do not match their checksums are computed again, and the resulting file is
 * bitwise identical for any number of threads and processes. Resuming is rejected if the mesh, the
 * graph, the bound, the points, or the type of distances differ. Completing the file temporarily
 * needs disk space for a second copy of all entries.
 *
 * \tparam T the type of distances, `double` or `float`; distances are rounded to it
 * \tparam Team a model of `ProcessTeam`
 *
 * \cgalModels{DistanceRowSink}
 */
template <typename T = double, typename Team = Single_process>
class Npz_file : public internal::Matrix_file_base<T, Team>
{
  using Base = internal::Matrix_file_base<T, Team>;

public:
  /// \name Creation
  /// @{

  /// sets the name of the file, which is opened when the computation starts. The journal is updated
  /// when a block is complete, but at most once every `seconds_between_commits`. A kill loses the
  /// blocks completed since the last update and those in progress, which have at most 64 rows each.
  explicit Npz_file(std::string file, const double seconds_between_commits = 1)
    : Base(std::move(file), seconds_between_commits)
  {
  }

  /// sets the name of a file that the processes of `team` compute jointly; each of them makes the
  /// same calls.
  /// \warning `team` is referred to, not copied.
  Npz_file(std::string file, Team& team, const double seconds_between_commits = 1)
    : Base(std::move(file), team, seconds_between_commits)
  {
  }

  /// keeps only the `number` smallest distances of each row. \pre `number > 0`
  void keep_nearest(const std::size_t number)
  {
    m_number_of_nearest = internal::checked_number_of_nearest(number);
  }

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
   * \throws std::invalid_argument if the file exists already, another program is computing it, or
   *         the journal is damaged or belongs to another computation. The message names the
   *         difference.
   * \throws std::runtime_error if there is not enough disk space, or writing fails. The message
   *         gives the reason. Completed blocks are kept.
   */
  void start(const Distance_matrix_plan& plan)
  {
    internal::Sparse_parts<T> parts(this->names(), plan);
    Base::start(
        plan, "NPZ", false,
        [&](const std::size_t rank, const auto& record) { return parts.is_there(rank, record); },
        [](std::size_t) {}); // the number of entries is unknown
    if(!this->blocks().is_anything_missing())
      return;
    m_data = std::make_unique<internal::Local_file>(this->names().part(this->team().rank()));
    m_end = m_data->size();
  }

  /// appends a row to a block.
  void collect(Block& block, const std::size_t row, const Distance_row& distances) const
  {
    block.append(row,
                 m_number_of_nearest > 0 ? internal::nearest_columns(distances, m_number_of_nearest)
                                         : distances.reached(),
                 distances);
  }

  /// writes a block.
  void add(const std::size_t number, Block& block)
  {
    const std::vector<char> bytes = internal::Sparse_parts<T>::bytes(block);
    const std::uint64_t offset = m_end.fetch_add(bytes.size());
    m_data->write(offset, bytes.data(), bytes.size());
    this->blocks().note({number, offset, bytes.size(), internal::Sparse_parts<T>::checksum(bytes)},
                        [this] { m_data->sync(); });
    block.clear();
  }

  /// returns the next block to compute.
  using Base::next_block;

  /// returns the number of completed rows, including those of other processes and of earlier runs.
  using Base::number_of_rows_done;

  /// completes the file if all rows are available.
  bool finish(bool /* is_done */)
  {
    const bool result = this->blocks().finish(
        [this] { m_data->sync(); },
        [this](const typename Base::Journals& journals) {
          internal::Sparse_parts<T> parts(this->names(), this->plan());
          for(const auto& journal : journals)
            for(const internal::Block_record& record : journal.contents.records)
              parts.add(journal.rank, record); // throws if it was modified
          parts.put_together(this->names().copy());
          internal::Local_file(this->names().copy()).sync(); // before the parts are removed
          return this->names().copy();
        });
    m_data.reset();
    return result;
  }

  /// @}

private:
  std::size_t m_number_of_nearest = 0;
  std::unique_ptr<internal::Local_file> m_data; // of this process
  std::atomic<std::uint64_t> m_end{0};
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPZ_FILE_H
