// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_MPI_TEAM_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_MPI_TEAM_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Mpi_file.h>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * The processes of an MPI communicator, on one or several machines, which jointly compute a file of
 * distances. Each process takes blocks of rows from a shared counter and writes them to the same
 * file.
 *
 * All processes must make the same calls. If one process throws or is killed, the others wait for
 * it; the program then has to terminate all of them, for example with `MPI_Abort()`. Completed
 * blocks are kept.
 *
 * `CGAL/Approximate_geodesics.h` does not include this header, as it requires MPI.
 *
 * \cgalModels{ProcessTeam}
 */
class Mpi_team
{
public:
  /// the file type, for concurrent writes by all processes.
  using File = internal::Mpi_file;

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
  ~Mpi_team()
  {
    if(std::uncaught_exceptions() > m_number_of_exceptions)
      return;
    MPI_Win_unlock_all(m_window);
    MPI_Win_free(&m_window);
    MPI_Comm_free(&m_communicator);
  }

  /// returns the rank of this process, counted from 0.
  std::size_t rank() const { return static_cast<std::size_t>(m_rank); }

  /// returns the number of processes.
  std::size_t size() const { return static_cast<std::size_t>(m_size); }

  /// waits until all processes have called this function.
  void wait() { MPI_Barrier(m_communicator); }

  /// broadcasts the values of process 0 to all processes.
  void share(std::vector<std::uint64_t>& values)
  {
    std::uint64_t size = values.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, m_communicator);
    values.resize(static_cast<std::size_t>(size));
    broadcast(values.data(), size, MPI_UINT64_T);
  }

  /// broadcasts the text of process 0 to all processes.
  void share(std::string& text)
  {
    std::uint64_t size = text.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, m_communicator);
    text.resize(static_cast<std::size_t>(size));
    broadcast(text.data(), size, MPI_CHAR);
  }

  /// restarts the ticket counter at 0. This is a collective operation.
  void restart_tickets()
  {
    wait();
    if(m_rank == 0)
      exchange(0, MPI_REPLACE);
    wait();
  }

  /// returns the next ticket. Tickets are unique among all threads and processes.
  std::uint64_t next_ticket() { return exchange(1, MPI_SUM); }

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

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_MPI_TEAM_H
