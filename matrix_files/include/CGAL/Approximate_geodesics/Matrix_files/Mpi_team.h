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
 * The processes of an MPI communicator, on one machine or several, which compute a file of
 * distances together. Each of them takes blocks of rows from a common counter, and writes them to
 * the one file.
 *
 * All processes have to make the same calls. If one of them throws or is killed, the others wait
 * for it: the program is to end all of them then, as `MPI_Abort()` does. What they have computed is
 * kept.
 *
 * This header is not part of `CGAL/Approximate_geodesics.h`, as it needs MPI.
 *
 * \cgalModels{ProcessTeam}
 */
class Mpi_team
{
public:
  /// a file that all processes write to.
  using File = internal::Mpi_file;

  /// the processes of `communicator`, all of which have to make such an object.
  /// \pre MPI was initialized, with `MPI_THREAD_SERIALIZED` or more if `CGAL::Parallel_tag` is
  /// given.
  explicit Mpi_team(const MPI_Comm communicator = MPI_COMM_WORLD)
  {
    MPI_Comm_dup(communicator, &m_communicator); // so that no message is taken for another one's
    MPI_Comm_rank(m_communicator, &m_rank);
    MPI_Comm_size(m_communicator, &m_size);
    MPI_Win_allocate(m_rank == 0 ? sizeof(std::uint64_t) : 0, sizeof(std::uint64_t), MPI_INFO_NULL,
                     m_communicator, &m_counter, &m_window);
    MPI_Win_lock_all(0, m_window);
  }

  Mpi_team(const Mpi_team&) = delete;
  Mpi_team& operator=(const Mpi_team&) = delete;

  /// leaves MPI as it was. All processes have to do so; where an exception ends it, nothing is
  /// done, so that whoever catches the exception can call `MPI_Abort()`.
  ~Mpi_team()
  {
    if(std::uncaught_exceptions() > m_number_of_exceptions)
      return;
    MPI_Win_unlock_all(m_window);
    MPI_Win_free(&m_window);
    MPI_Comm_free(&m_communicator);
  }

  /// returns the number of this process, counted from 0.
  std::size_t rank() const { return static_cast<std::size_t>(m_rank); }

  /// returns the number of processes.
  std::size_t size() const { return static_cast<std::size_t>(m_size); }

  /// waits until all processes have called this function.
  void wait() { MPI_Barrier(m_communicator); }

  /// replaces the values by those of process 0.
  void share(std::vector<std::uint64_t>& values)
  {
    std::uint64_t size = values.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, m_communicator);
    values.resize(static_cast<std::size_t>(size));
    broadcast(values.data(), size, MPI_UINT64_T);
  }

  /// replaces the text by that of process 0.
  void share(std::string& text)
  {
    std::uint64_t size = text.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, m_communicator);
    text.resize(static_cast<std::size_t>(size));
    broadcast(text.data(), size, MPI_CHAR);
  }

  /// deals out tickets from 0 again. All processes have to call this function.
  void restart_tickets()
  {
    wait();
    if(m_rank == 0)
      exchange(0, MPI_REPLACE);
    wait();
  }

  /// returns the number of the next ticket, which no other thread and no other process gets.
  std::uint64_t next_ticket() { return exchange(1, MPI_SUM); }

private:
  // Returns what the counter was before.
  std::uint64_t exchange(const std::uint64_t value, const MPI_Op operation)
  {
    const std::lock_guard lock(internal::mpi_mutex());
    std::uint64_t result = 0;
    MPI_Fetch_and_op(&value, &result, MPI_UINT64_T, 0, 0, operation, m_window);
    MPI_Win_flush(0, m_window);
    return result;
  }

  // MPI counts by `int`.
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
