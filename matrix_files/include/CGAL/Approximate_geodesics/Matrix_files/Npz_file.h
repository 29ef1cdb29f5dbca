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
 * The distances up to `maximum_distance`, or the smallest ones of each row, in a file that SciPy
 * reads: `scipy.sparse.load_npz(file)`. The entries of a row are those of `Radius_rows` or
 * `Nearest_rows`, in the same order.
 *
 * The file is there when it is complete. Until then, what was computed is in `FILE.part`, and a
 * journal, `FILE.journal`, names the blocks of rows that are on the disk, with their checksums. If
 * the computation ends early, by a visitor, an error, or a kill, the same call goes on with it: it
 * reads what is there, computes again what is not as the journal says, and gives the same file to
 * the last bit, by any number of threads and processes. It refuses to go on with a file of another
 * mesh, graph, bound, list of points or type of distances.
 * At the end, the disk must have room for all entries once more.
 *
 * \tparam T the type of distances, `double` or `float`, to which they are rounded
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

  /// names the file. It is opened when the computation starts. If this process is killed, the
  /// blocks are lost that threads are at, of 64 rows at most, and those that were completed since
  /// the last record: records are written when a block is complete, but not more often than every
  /// `seconds_between_commits`.
  explicit Npz_file(std::string file, const double seconds_between_commits = 1)
    : Base(std::move(file), seconds_between_commits)
  {
  }

  /// names a file that several processes compute together, all of which make the same calls.
  /// \warning `team` is referred to, not copied.
  Npz_file(std::string file, Team& team, const double seconds_between_commits = 1)
    : Base(std::move(file), team, seconds_between_commits)
  {
  }

  /// keeps that number of distances of each row only, the smallest ones. \pre `number > 0`
  void keep_nearest(const std::size_t number)
  {
    m_number_of_nearest = internal::checked_number_of_nearest(number);
  }

  /// @}

  /// \name What a Sink Does
  /// @{

  /// the entries of some rows.
  using Block = internal::Sparse_block<T>;

  /// returns the number of entries that a row has at most, or `0` if there is no such number.
  std::size_t number_of_nearest() const { return m_number_of_nearest; }

  /*!
   * opens the files, and finds out what is there.
   *
   * \throws std::invalid_argument if the file is there already, another program computes it, the
   *         journal is damaged, or belongs to another computation. The message tells what differs.
   * \throws std::runtime_error if the disk has not enough room, or the system refuses to write.
   *         The message tells the reason. What was computed before is kept.
   */
  void start(const Distance_matrix_plan& plan)
  {
    internal::Sparse_parts<T> parts(this->names(), plan);
    Base::start(
        plan, "NPZ", false,
        [&](const std::size_t rank, const auto& record) { return parts.is_there(rank, record); },
        [](std::size_t) {}); // who knows how many entries there will be?
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

  /// gives the block that is to be computed next.
  using Base::next_block;

  /// returns the number of rows that are done, by any process, now or before.
  using Base::number_of_rows_done;

  /// completes the file, if all rows are there.
  bool finish(bool /* is_done */)
  {
    const bool result = this->blocks().finish(
        [this] { m_data->sync(); },
        [this](const typename Base::Journals& journals) {
          internal::Sparse_parts<T> parts(this->names(), this->plan());
          for(const auto& journal : journals)
            for(const internal::Block_record& record : journal.contents.records)
              parts.add(journal.rank, record); // if it is still there
          parts.put_together(this->names().copy());
          internal::Local_file(this->names().copy()).sync(); // before the parts go
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
