// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MPI_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MPI_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Serializes MPI calls, as required by `MPI_THREAD_SERIALIZED`.
inline std::mutex& mpi_mutex()
{
  static std::mutex result;
  return result;
}

/*
 * A file that several processes write to, at disjoint offsets. Each process opens it separately, so
 * that syncing is not a collective operation.
 */
class Mpi_file
{
public:
  // Creates the file if it does not exist.
  explicit Mpi_file(const std::string& name) : m_name(name)
  {
    check(MPI_File_open(MPI_COMM_SELF, name.c_str(), MPI_MODE_RDWR | MPI_MODE_CREATE, MPI_INFO_NULL,
                        &m_file),
          "opened for writing");
  }

  Mpi_file(const Mpi_file&) = delete;
  Mpi_file& operator=(const Mpi_file&) = delete;
  ~Mpi_file() { MPI_File_close(&m_file); }

  void write(std::uint64_t offset, const void* const data, std::size_t size)
  {
    const std::lock_guard lock(mpi_mutex());
    const char* bytes = static_cast<const char*>(data);
    while(size > 0)
    {
      constexpr std::size_t most = (std::numeric_limits<int>::max)();
      const int number = static_cast<int>(size < most ? size : most);
      MPI_Status status;
      check(MPI_File_write_at(m_file, static_cast<MPI_Offset>(offset), bytes, number, MPI_BYTE,
                              &status),
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

  void resize(const std::uint64_t size)
  {
    const std::lock_guard lock(mpi_mutex());
    check(MPI_File_set_size(m_file, static_cast<MPI_Offset>(size)), "resized");
  }

  void sync()
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

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MPI_FILE_H
