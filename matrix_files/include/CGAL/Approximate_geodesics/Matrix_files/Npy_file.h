// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Bulk_checksum.h>
#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Single_process.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Local_file.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file_base.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_journal.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/npy_header.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/symmetric_file.h>

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
 * A distance matrix in a file that NumPy reads: `numpy.load(file, mmap_mode="r")` opens it at once,
 * whatever its length. Memory is that for a block of rows per thread: 16 MB, or a row if that is
 * longer.
 *
 * The file is there when it is complete. Until then, what was computed is in `FILE.part`, and a
 * journal, `FILE.journal`, names the blocks of rows that are on the disk, with their checksums. If
 * the computation ends early, by a visitor, an error, or a kill, the same call goes on with it: it
 * reads what is there, computes again what is not as the journal says, and gives the same file to
 * the last bit, by any number of threads and processes. It refuses to go on with a file of another
 * mesh, graph, bound, list of points or type of distances.
 *
 * \tparam T the type of distances, `double` or `float`, to which they are rounded; infinity stands
 *         for columns that were not reached
 * \tparam Team a model of `ProcessTeam`
 *
 * \cgalModels{DistanceRowSink}
 */
template <typename T = double, typename Team = Single_process>
class Npy_file : public internal::Matrix_file_base<T, Team>
{
  using Base = internal::Matrix_file_base<T, Team>;

public:
  /// \name Creation
  /// @{

  /// names the file. It is opened when the computation starts. If this process is killed, the
  /// blocks are lost that threads are at, of 64 rows at most, and those that were completed since
  /// the last record: records are written when a block is complete, but not more often than every
  /// `seconds_between_commits`.
  explicit Npy_file(std::string file, const double seconds_between_commits = 1)
    : Base(std::move(file), seconds_between_commits)
  {
  }

  /// names a file that several processes compute together, all of which make the same calls.
  /// \warning `team` is referred to, not copied.
  Npy_file(std::string file, Team& team, const double seconds_between_commits = 1)
    : Base(std::move(file), team, seconds_between_commits)
  {
  }

  /// @}

  /// returns the length of the file of a matrix, in bytes.
  static std::uint64_t length(const std::size_t number_of_rows, const std::size_t number_of_columns)
  {
    return header(number_of_rows, number_of_columns).size() +
           std::uint64_t(sizeof(T)) * number_of_rows * number_of_columns;
  }

  /// \name What a Sink Does
  /// @{

  /// the distances of some rows.
  using Block = std::vector<T>;

  /// distances of both directions can be compared.
  static constexpr bool can_be_symmetric = true;

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
    m_first = header(plan.number_of_rows(), plan.number_of_columns()).size();
    m_length_of_row = std::uint64_t(sizeof(T)) * plan.number_of_columns();
    Base::start(
        plan, "NPY", plan.is_symmetric(),
        [this](std::size_t, const auto& record) { return is_there(record); },
        [this](const std::size_t number_of_rows) {
          this->check_space(number_of_rows * m_length_of_row);
        });
    if(this->blocks().is_anything_missing())
      open();
  }

  /// appends a row to a block.
  void collect(Block& block, std::size_t /* row */, const Distance_row& distances) const
  {
    block.reserve(distances.size() * this->plan().rows_per_block());
    for(const double distance : distances)
      block.push_back(internal::little_endian(static_cast<T>(distance)));
  }

  /// writes a block.
  void add(const std::size_t number, Block& block)
  {
    const char* bytes = reinterpret_cast<const char*>(block.data());
    for(const std::size_t row : this->plan().rows_of_block(number))
    {
      m_data->write(offset(row), bytes, m_length_of_row);
      bytes += m_length_of_row;
    }
    this->blocks().note({number, 0, block.size() * sizeof(T), checksum(block)},
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
    const bool result =
        this->blocks().finish([this] { m_data->sync(); },
                              [this](const typename Base::Journals& journals) {
                                return complete(Base::Blocks::are_all_there(journals));
                              });
    m_data.reset();
    return result;
  }

  /// @}

private:
  static std::string header(const std::size_t number_of_rows, const std::size_t number_of_columns)
  {
    return internal::npy_header(internal::npy_type<T>(), {number_of_rows, number_of_columns});
  }

  static std::uint64_t checksum(const Block& block)
  {
    internal::Bulk_checksum result;
    result.add(block);
    return result.value();
  }

  std::uint64_t offset(const std::size_t row) const { return m_first + row * m_length_of_row; }

  // Whether a block is as the journal says.
  bool is_there(const internal::Block_record& record) const
  {
    if(!std::filesystem::exists(this->names().part()))
      return false;
    internal::Local_file file(this->names().part());
    const auto rows = this->plan().rows_of_block(static_cast<std::size_t>(record.block));
    Block block(rows.size() * this->plan().number_of_columns());
    char* bytes = reinterpret_cast<char*>(block.data());
    for(const std::size_t row : rows)
    {
      if(!file.read(offset(row), bytes, m_length_of_row))
        return false;
      bytes += m_length_of_row;
    }
    return checksum(block) == record.checksum;
  }

  std::uint64_t length() const
  {
    return length(this->plan().number_of_rows(), this->plan().number_of_columns());
  }

  void open()
  {
    m_data = std::make_unique<typename Team::File>(this->names().part());
    if(this->team().rank() == 0)
      m_data->resize(length());
    this->team().wait(); // nobody writes before the file has its length
  }

  // The header comes last, as no checksum tells whether it is still there. Returns the name.
  std::string complete(const bool is_noted)
  {
    if(is_noted)
      check_length();
    else if(this->plan().is_symmetric())
      this->blocks().note_all(); // checksums are of no use any more
    internal::Local_file file(this->names().part());
    const std::string text =
        header(this->plan().number_of_rows(), this->plan().number_of_columns());
    file.write(0, text.data(), text.size());
    if(this->plan().is_symmetric())
      internal::Square_matrix_file<T, internal::Local_file>(file, m_first,
                                                            this->plan().number_of_columns())
          .make_symmetric();
    file.sync();
    return this->names().part();
  }

  // All that can be told of distances that were being made symmetric.
  void check_length() const
  {
    const std::string part = this->names().part();
    if(!std::filesystem::exists(part) || std::filesystem::file_size(part) != length())
      internal::reject(part + " is not as it was left; " + internal::Matrix_journal::remedy());
  }

  std::uint64_t m_first = 0; // byte of the distances
  std::uint64_t m_length_of_row = 0;
  std::unique_ptr<typename Team::File> m_data;
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_FILE_H
