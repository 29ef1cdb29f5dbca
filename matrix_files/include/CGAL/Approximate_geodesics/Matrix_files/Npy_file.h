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
 * A dense distance matrix in a NPY file. `numpy.load(file, mmap_mode="r")` maps it into memory
 * without reading it. Each thread buffers one block of rows: 16 MB, or a single row if that is
 * longer.
 *
 * The file appears under its name only when it is complete. Until then, the data is in `FILE.part`,
 * and the journal `FILE.journal` lists the blocks of rows that are on disk, with their checksums.
 * If the computation ends early, because of a visitor, an error, or a kill, the same call resumes
 * it: blocks that do not match their checksums are computed again, and the resulting file is
 * bitwise identical for any number of threads and processes. Resuming is rejected if the mesh, the
 * graph, the bound, the points, or the type of distances differ.
 *
 * \tparam T the type of distances, `double` or `float`; distances are rounded to it, and are
 *         infinite for columns that were not reached
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

  /// sets the name of the file, which is opened when the computation starts. The journal is updated
  /// when a block is complete, but at most once every `seconds_between_commits`. A kill loses the
  /// blocks completed since the last update and those in progress, which have at most 64 rows each.
  explicit Npy_file(std::string file, const double seconds_between_commits = 1)
    : Base(std::move(file), seconds_between_commits)
  {
  }

  /// sets the name of a file that the processes of `team` compute jointly; each of them makes the
  /// same calls.
  /// \warning `team` is referred to, not copied.
  Npy_file(std::string file, Team& team, const double seconds_between_commits = 1)
    : Base(std::move(file), team, seconds_between_commits)
  {
  }

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
   * \throws std::invalid_argument if the file exists already, another program is computing it, or
   *         the journal is damaged or belongs to another computation. The message names the
   *         difference.
   * \throws std::runtime_error if there is not enough disk space, or writing fails. The message
   *         gives the reason. Completed blocks are kept.
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

  /// returns the next block to compute.
  using Base::next_block;

  /// returns the number of completed rows, including those of other processes and of earlier runs.
  using Base::number_of_rows_done;

  /// completes the file if all rows are available.
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

  // Whether a block matches its checksum in the journal.
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
    this->team().wait(); // the file must be resized before the first write
  }

  // Writes the header last, because no checksum covers it. Returns the name of the file.
  std::string complete(const bool is_noted)
  {
    if(is_noted)
      check_length();
    else if(this->plan().is_symmetric())
      this->blocks().note_all(); // the checksums become invalid
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

  // The checksums are invalid once symmetrization has begun, so only the length can be checked.
  void check_length() const
  {
    const std::string part = this->names().part();
    if(!std::filesystem::exists(part) || std::filesystem::file_size(part) != length())
      internal::reject(part + " is missing or has the wrong length; " +
                       internal::Matrix_journal::remedy());
  }

  std::uint64_t m_first = 0; // offset of the distances in bytes
  std::uint64_t m_length_of_row = 0;
  std::unique_ptr<typename Team::File> m_data;
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_NPY_FILE_H
