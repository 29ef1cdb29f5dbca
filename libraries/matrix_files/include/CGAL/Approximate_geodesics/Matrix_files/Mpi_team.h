// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_MPI_TEAM_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_MPI_TEAM_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrix_files/Process_team.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

// Serializes MPI calls, as required by `MPI_THREAD_SERIALIZED`.
inline std::mutex& mpi_mutex()
{
  static std::mutex result;
  return result;
}

// Each process opens the file separately, so that syncing is not a collective operation.
class Mpi_file : public Process_team::File
{
public:
  explicit Mpi_file(const std::string& name) : m_name(name)
  {
    check(MPI_File_open(MPI_COMM_SELF, name.c_str(), MPI_MODE_RDWR, MPI_INFO_NULL, &m_file),
          "opened for writing");
  }

  Mpi_file(const Mpi_file&) = delete;
  Mpi_file& operator=(const Mpi_file&) = delete;
  ~Mpi_file() override { MPI_File_close(&m_file); }

  void write(std::uint64_t offset, const void* const data, std::size_t size) override
  {
    const std::lock_guard lock(mpi_mutex());
    const char* bytes = static_cast<const char*>(data);
    while(size > 0)
    {
      constexpr std::size_t most = (std::numeric_limits<int>::max)();
      MPI_Status status;
      check(MPI_File_write_at(m_file, static_cast<MPI_Offset>(offset), bytes,
                              static_cast<int>((std::min)(size, most)), MPI_BYTE, &status),
            "written");
      int written = 0;
      MPI_Get_count(&status, MPI_BYTE, &written);
      if(written <= 0)
        throw std::runtime_error("Approximate_geodesics: " + m_name + " cannot be written");
      offset += static_cast<std::uint64_t>(written);
      bytes += written;
      size -= static_cast<std::size_t>(written);
    }
  }

  void sync() override
  {
    const std::lock_guard lock(mpi_mutex());
    check(MPI_File_sync(m_file), "flushed to disk");
  }

private:
  void check(const int error, const std::string& verb) const
  {
    if(error == MPI_SUCCESS)
      return;
    std::array<char, MPI_MAX_ERROR_STRING> text;
    int length = 0;
    MPI_Error_string(error, text.data(), &length);
    throw std::runtime_error("Approximate_geodesics: " + m_name + " cannot be " + verb + ": " +
                             std::string(text.data(), static_cast<std::size_t>(length)));
  }

  std::string m_name;
  MPI_File m_file = MPI_FILE_NULL;
};

} // namespace internal

/*!
 * \ingroup PkgGeodesicLibrariesMatrices
 *
 * The processes of an MPI communicator, on one or several machines, which jointly compute a file of
 * distances. Each process takes blocks of rows from a shared counter and writes them to the same
 * file. The class is in a header, and not compiled, so that it fits any implementation of MPI.
 *
 * All processes must make the same calls. If one process throws or is killed, the others wait for
 * it; the program then has to terminate all of them, for example with `MPI_Abort()`. Completed
 * blocks are kept.
 *
 * `CGAL/Approximate_geodesics.h` does not include this header, as it requires MPI.
 */
class Mpi_team : public Process_team
{
public:
  /// constructs a team from the processes of `communicator`. This is a collective operation.
  /// \pre MPI is initialized, with `MPI_THREAD_SERIALIZED` or higher if `CGAL::Parallel_tag` is
  /// used.
  explicit Mpi_team(const MPI_Comm communicator = MPI_COMM_WORLD)
  {
    MPI_Comm_dup(communicator, &m_communicator); // separates our messages from the caller's
    MPI_Comm_rank(m_communicator, &m_rank);
    MPI_Comm_size(m_communicator, &m_size);
    MPI_Win_allocate(m_rank == 0 ? sizeof(std::uint64_t) : 0, sizeof(std::uint64_t), MPI_INFO_NULL,
                     m_communicator, &m_counter, &m_window);
    MPI_Win_lock_all(0, m_window);
  }

  Mpi_team(const Mpi_team&) = delete;
  Mpi_team& operator=(const Mpi_team&) = delete;

  /// releases the communicator and the counter. This is a collective operation. During stack
  /// unwinding it does nothing, so that the exception handler can call `MPI_Abort()`.
  ~Mpi_team() override
  {
    if(std::uncaught_exceptions() > m_number_of_exceptions)
      return;
    MPI_Win_unlock_all(m_window);
    MPI_Win_free(&m_window);
    MPI_Comm_free(&m_communicator);
  }

  /// returns the rank of this process, counted from 0.
  std::size_t rank() const override { return static_cast<std::size_t>(m_rank); }

  /// returns the number of processes.
  std::size_t size() const override { return static_cast<std::size_t>(m_size); }

  /// waits until all processes have called this function.
  void wait() override { MPI_Barrier(m_communicator); }

  /// broadcasts the values of process 0 to all processes.
  void share(std::vector<std::uint64_t>& values) override
  {
    std::uint64_t size = values.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, m_communicator);
    values.resize(static_cast<std::size_t>(size));
    broadcast(values.data(), size, MPI_UINT64_T);
  }

  /// broadcasts the text of process 0 to all processes.
  void share(std::string& text) override
  {
    std::uint64_t size = text.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, m_communicator);
    text.resize(static_cast<std::size_t>(size));
    broadcast(text.data(), size, MPI_CHAR);
  }

  /// restarts the ticket counter at 0. This is a collective operation.
  void restart_tickets() override
  {
    wait();
    if(m_rank == 0)
      exchange(0, MPI_REPLACE);
    wait();
  }

  /// returns the next ticket. Tickets are unique among all threads and processes.
  std::uint64_t next_ticket() override { return exchange(1, MPI_SUM); }

  /// opens a file in this process, with MPI's functions.
  std::unique_ptr<File> open(const std::string& name) override
  {
    return std::make_unique<internal::Mpi_file>(name);
  }

private:
  // Returns the previous value of the counter.
  std::uint64_t exchange(const std::uint64_t value, const MPI_Op operation)
  {
    const std::lock_guard lock(internal::mpi_mutex());
    std::uint64_t result = 0;
    MPI_Fetch_and_op(&value, &result, MPI_UINT64_T, 0, 0, operation, m_window);
    MPI_Win_flush(0, m_window);
    return result;
  }

  // MPI limits the count of a message to `int`.
  template <typename T>
  void broadcast(T* data, std::uint64_t size, const MPI_Datatype type)
  {
    constexpr std::uint64_t most = (std::numeric_limits<int>::max)();
    for(; size > most; size -= most, data += most)
      MPI_Bcast(data, static_cast<int>(most), type, 0, m_communicator);
    MPI_Bcast(data, static_cast<int>(size), type, 0, m_communicator);
  }

  const int m_number_of_exceptions = std::uncaught_exceptions();
  MPI_Comm m_communicator = MPI_COMM_NULL;
  int m_rank = 0;
  int m_size = 1;
  std::uint64_t* m_counter = nullptr; // of process 0
  MPI_Win m_window = MPI_WIN_NULL;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_MPI_TEAM_H
