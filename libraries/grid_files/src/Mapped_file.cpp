// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Grid_files/internal/Mapped_file.h>

#include "fail_to.h"

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <boost/interprocess/anonymous_shared_memory.hpp>
#include <boost/interprocess/exceptions.hpp>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#define APPROXIMATE_GEODESICS_POSIX
#include <fcntl.h>
#include <unistd.h>
#endif

namespace CGAL::Approximate_geodesics::internal {
namespace {

namespace fs = std::filesystem;
namespace bi = boost::interprocess;

// Writing to a mapped page that has no room on disk would end the process.
void reserve([[maybe_unused]] const std::string& name, [[maybe_unused]] const std::uint64_t size)
{
#ifdef __linux__
  const int file = ::open(name.c_str(), O_RDWR | O_CLOEXEC);
  errno = file < 0 ? errno : ::posix_fallocate(file, 0, static_cast<off_t>(size));
  const int reason = errno;
  if(file >= 0)
    ::close(file);
  errno = reason;
  if(reason != 0)
    fail_to("written", name);
#else
  std::ofstream out(name, std::ios::binary);
  const std::string zeros(std::size_t(1) << 20, '\0');
  for(std::uint64_t i = 0; i < size && out; i += zeros.size())
    out.write(zeros.data(),
              static_cast<std::streamsize>((std::min)(std::uint64_t(zeros.size()), size - i)));
  out.close();
  if(!out)
    fail_to("written", name);
#endif
}

void create(const std::string& name, const std::uint64_t size)
{
  errno = 0;
  if(!std::ofstream(name, std::ios::binary))
    fail_to("written", name);
  try
  {
    reserve(name, size);
  }
  catch(...)
  {
    std::error_code ignored;
    fs::remove(name, ignored);
    throw;
  }
}

void check_size(const std::string& name, const std::uint64_t size)
{
  std::error_code error;
  const std::uint64_t found = fs::file_size(name, error);
  if(error)
    reject(name + " cannot be read: " + error.message());
  if(found != size)
    reject(name + " has " + std::to_string(found) + " bytes in place of " + std::to_string(size));
}

} // namespace

Mapped_file::Mapped_file(const std::string& name, const std::uint64_t size, const Mode mode)
  : m_is_in_memory(name.empty())
{
  try
  {
    if(m_is_in_memory)
    {
      bi::anonymous_shared_memory(static_cast<std::size_t>(size)).swap(m_memory);
      return;
    }
    if(mode == Mode::NEW)
      create(name, size);
    check_size(name, size);
    bi::file_mapping(name.c_str(), bi::read_write).swap(m_file);
  }
  catch(const bi::interprocess_exception& e)
  {
    errno = e.get_native_error();
    fail_to("mapped", m_is_in_memory ? "memory" : name);
  }
}

Mapped_file::Part Mapped_file::part(const std::uint64_t offset, const std::size_t size) const
{
  Part result;
  if(m_is_in_memory)
    result.m_address = static_cast<char*>(m_memory.get_address()) + offset;
  else
    try
    {
      bi::mapped_region(m_file, bi::read_write, static_cast<bi::offset_t>(offset), size)
          .swap(result.m_region);
      result.m_address = result.m_region.get_address();
    }
    catch(const bi::interprocess_exception& e)
    {
      errno = e.get_native_error();
      fail_to("mapped", m_file.get_name());
    }
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal
