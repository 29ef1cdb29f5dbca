// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_LOCAL_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_LOCAL_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Throws with the reason given by the operating system.
[[noreturn]] inline void fail_to(const std::string& verb, const std::string& file)
{
  const std::string reason = errno != 0 ? ": " + std::generic_category().message(errno) : "";
  throw std::runtime_error("Approximate_geodesics: " + file + " cannot be " + verb + reason);
}

/*
 * A file with random access. It is safe to use from several threads.
 */
class Local_file
{
public:
  // Creates the file if it does not exist.
  explicit Local_file(const std::string& name) : m_name(name)
  {
    errno = 0;
    std::ofstream(name, std::ios::binary | std::ios::app);
    m_stream.rdbuf()->pubsetbuf(nullptr, 0); // unbuffered
    m_stream.open(name, std::ios::binary | std::ios::in | std::ios::out);
    if(!m_stream)
      fail_to("opened for writing", name);
  }

  void write(const std::uint64_t offset, const void* const data, const std::size_t size)
  {
    const std::lock_guard lock(m_mutex);
    errno = 0;
    m_stream.seekp(static_cast<std::streamoff>(offset));
    m_stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
    if(!m_stream.flush())
      fail_to("written", m_name);
  }

  // Returns false if the file is too short.
  bool read(const std::uint64_t offset, void* const data, const std::size_t size)
  {
    const std::lock_guard lock(m_mutex);
    errno = 0;
    m_stream.seekg(static_cast<std::streamoff>(offset));
    m_stream.read(static_cast<char*>(data), static_cast<std::streamsize>(size));
    const bool result = bool(m_stream);
    m_stream.clear();
    return result;
  }

  // Throws if the file is too short.
  void read_all(const std::uint64_t offset, void* const data, const std::size_t size)
  {
    if(!read(offset, data, size))
      fail_to("read", m_name);
  }

  void resize(const std::uint64_t size)
  {
    std::error_code error;
    std::filesystem::resize_file(m_name, size, error);
    errno = error.value();
    if(error)
      fail_to("resized", m_name);
  }

  std::uint64_t size() const { return std::filesystem::file_size(m_name); }

  // Waits until the data is on disk, on systems that have `fsync()`.
  void sync()
  {
#if defined(__unix__) || defined(__APPLE__)
    errno = 0;
    const int descriptor = ::open(m_name.c_str(), O_WRONLY);
    const bool is_done = descriptor >= 0 && ::fsync(descriptor) == 0;
    const int reason = errno;
    if(descriptor >= 0)
      ::close(descriptor);
    errno = reason;
    if(!is_done)
      fail_to("flushed to disk", m_name);
#endif
  }

private:
  std::string m_name;
  std::fstream m_stream;
  std::mutex m_mutex; // guards the position of the stream
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_LOCAL_FILE_H
