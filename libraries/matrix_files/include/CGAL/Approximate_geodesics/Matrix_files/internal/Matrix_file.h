// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrix_files/Process_team.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_identity.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The common base of matrix files: the part folder, from which a computation is resumed after any
 * process ends at any time.
 *
 *   FILE.part/result    the matrix, which is moved to FILE when it is complete
 *   FILE.part/identity  the fingerprint of the computation
 *   FILE.part/N         marks block N as complete; it has the checksum of the block
 *   FILE.lock           locked while a program computes FILE
 *
 * A marker is written after its block. The system may write both to the disk in any order: a block
 * that does not match its checksum is missing. The identity is renamed to its name after `result`
 * is created, and is the last entry to be removed: without `result`, it shows that FILE is
 * complete.
 */
class Matrix_file
{
public:
  Matrix_file(const Matrix_file&) = delete;
  Matrix_file& operator=(const Matrix_file&) = delete;

  std::optional<std::size_t> next_block();
  std::size_t number_of_rows_done() const { return m_rows_done; }

protected:
  using Path = std::filesystem::path;

  // The team is referred to, not copied. Without one, the process works alone.
  Matrix_file(Path file, Process_team* team);
  virtual ~Matrix_file() = default;

  // Finds the missing blocks. Collective. `kind` distinguishes the formats of files.
  void start(const Distance_matrix_plan& plan, std::uint64_t kind, std::uint64_t bytes_per_row);

  // Marks a block as complete.
  void mark(std::size_t block, const std::string& contents_of_marker);

  // Completes the file if all blocks are. Collective. Returns whether the file is complete.
  bool finish();

  Process_team& team() const { return *m_team; }
  const Distance_matrix_plan& plan() const { return *m_plan; }
  bool is_anything_missing() const { return !m_missing.empty(); }
  std::string in_part(const std::string& name) const { return (m_part / name).string(); }
  std::string result() const { return in_part("result"); }
  std::string marker(const std::size_t block) const { return in_part(std::to_string(block)); }

  // The end of messages about a damaged part folder.
  std::string remedy() const;

private:
  // These are called in process 0 only, except for `close()`.

  // Creates the matrix without rows, or gives an existing one the right length.
  virtual void prepare_result(const std::string& name) const = 0;

  // Whether a block matches the checksum of its marker.
  virtual bool is_intact(std::size_t block) const = 0;

  // Whether an earlier run ended while it made the matrix symmetric: then all blocks are complete,
  // and their checksums may be invalid.
  virtual bool is_being_changed() const = 0;

  // Closes the files of this process.
  virtual void close() = 0;

  // Completes the matrix when all blocks are.
  virtual void complete() = 0;

  template <typename F>
  void on_first(const F& f);
  std::vector<std::uint64_t> find_missing(std::uint64_t bytes_per_row);
  std::vector<std::uint64_t> missing_blocks() const;
  bool are_all_blocks_marked() const;
  bool has_part() const;
  void create_part() const;
  void check_identity() const;
  void check_is_not_there() const;
  void check_space(std::uint64_t bytes) const;
  void check_team();
  void remove_part() const;
  std::size_t number_of_rows(const std::vector<std::uint64_t>& blocks) const;
  Path with_suffix(const char* suffix) const;
  Path folder() const;

  Path m_file;
  Path m_part;
  std::unique_ptr<Process_team> m_own_team; // if none was given
  Process_team* m_team;
  const Distance_matrix_plan* m_plan = nullptr;
  Matrix_identity m_identity;
  std::shared_ptr<void> m_lock; // process 0 only
  bool m_was_complete = false;  // process 0 only: at start()
  std::vector<std::uint64_t> m_missing;
  std::size_t m_rows_before = 0;
  std::atomic<std::size_t> m_rows_done{0};
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_FILE_H
