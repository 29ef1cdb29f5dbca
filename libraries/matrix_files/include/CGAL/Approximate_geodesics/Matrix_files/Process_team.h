// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_PROCESS_TEAM_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_PROCESS_TEAM_H

#include <CGAL/license/Approximate_geodesics.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesMatrices
 *
 * The processes that jointly compute a file of distances, on one machine or on several that share a
 * file system. Each of them makes the same calls. Derived classes are `Single_process` and
 * `Mpi_team`.
 */
class Process_team
{
public:
  /// An existing file that all processes write to, at disjoint offsets. All functions throw
  /// `std::runtime_error` if they fail.
  class File
  {
  public:
    virtual ~File() = default;

    /// writes bytes. It may be called by several threads.
    virtual void write(std::uint64_t offset, const void* data, std::size_t size) = 0;

    /// waits until all bytes written by this process are on disk.
    virtual void sync() = 0;
  };

  virtual ~Process_team() = default;

  /// returns the rank of this process, counted from 0.
  virtual std::size_t rank() const = 0;

  /// returns the number of processes.
  virtual std::size_t size() const = 0;

  /// waits until all processes have called this function.
  virtual void wait() = 0;

  /// replaces the values by those of process 0. This is a collective operation.
  virtual void share(std::vector<std::uint64_t>& values) = 0;

  /// replaces the text by that of process 0. This is a collective operation.
  virtual void share(std::string& text) = 0;

  /// restarts the ticket counter at 0. This is a collective operation.
  virtual void restart_tickets() = 0;

  /// returns the next ticket. Tickets are unique among all threads and processes.
  virtual std::uint64_t next_ticket() = 0;

  /// opens a file in this process.
  virtual std::unique_ptr<File> open(const std::string& name) = 0;
};

/*!
 * \ingroup PkgGeodesicLibrariesMatrices
 *
 * A team of one process.
 */
class Single_process : public Process_team
{
public:
  /// returns the rank of this process: 0.
  std::size_t rank() const override { return 0; }

  /// returns the number of processes: 1.
  std::size_t size() const override { return 1; }

  /// does nothing.
  void wait() override {}

  /// does nothing.
  void share(std::vector<std::uint64_t>& /* values */) override {}

  /// does nothing.
  void share(std::string& /* text */) override {}

  /// restarts the ticket counter at 0.
  void restart_tickets() override { m_next = 0; }

  /// returns the next ticket.
  std::uint64_t next_ticket() override { return m_next++; }

  /// opens a file.
  std::unique_ptr<File> open(const std::string& name) override;

private:
  std::atomic<std::uint64_t> m_next{0};
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_PROCESS_TEAM_H
