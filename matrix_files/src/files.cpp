// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files.h"

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <boost/interprocess/exceptions.hpp>
#include <boost/interprocess/sync/file_lock.hpp>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace CGAL::Approximate_geodesics {

std::unique_ptr<Process_team::File> Single_process::open(const std::string& name)
{
  return std::make_unique<internal::Local_file>(name);
}

namespace internal {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to(const std::string& verb, const std::string& file)
{
  const std::string reason = errno != 0 ? ": " + std::generic_category().message(errno) : "";
  throw std::runtime_error("Approximate_geodesics: " + file + " cannot be " + verb + reason);
}

/*
 * A locked file. POSIX locks belong to a process: they do not exclude other objects of the same
 * process, and closing any descriptor of a file releases them. So the process lists its own.
 */
class File_lock
{
public:
  File_lock(const std::string& name, const std::string& subject)
    : m_name(fs::weakly_canonical(fs::absolute(name)).string()) // the same before it exists
  {
    const std::lock_guard guard(s_mutex);
    if(s_locked.count(m_name) > 0)
      reject(subject + " is already being computed by another object of this program");
    if(is_something_else(name)) // which would be emptied, and removed
      reject(name + " exists, but is not a lock; delete it, or choose another name");
    write_file(name, "");
    m_lock = boost::interprocess::file_lock(name.c_str());
    if(!try_lock() || !fs::exists(name)) // the file vanishes if the owner just ended
      reject(subject + " is already being computed by another program");
    s_locked.insert(m_name);
  }

  ~File_lock()
  {
    std::error_code ignored;
    fs::remove(m_name, ignored);
    const std::lock_guard guard(s_mutex);
    m_lock = boost::interprocess::file_lock(); // before another object opens the file
    s_locked.erase(m_name);
  }

private:
  // Whether there is something by this name that no program that was killed has left.
  static bool is_something_else(const std::string& name)
  {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(name, error);
    if(!fs::exists(status) || !fs::is_regular_file(status))
      return fs::exists(status);
    const std::uintmax_t size = fs::file_size(name, error);
    return !error && size > 0; // its owner may just end
  }

  // Succeeds on file systems without locks.
  bool try_lock()
  {
    try
    {
      return m_lock.try_lock();
    }
    catch(const boost::interprocess::interprocess_exception&)
    {
      return true;
    }
  }

  inline static std::mutex s_mutex;
  inline static std::set<std::string> s_locked;

  std::string m_name; // canonical
  boost::interprocess::file_lock m_lock;
};

} // namespace

std::string read_file(const std::string& name)
{
  std::ifstream in(name, std::ios::binary | std::ios::ate);
  std::string result(in ? static_cast<std::size_t>(in.tellg()) : 0, '\0');
  in.seekg(0);
  in.read(result.data(), static_cast<std::streamsize>(result.size()));
  return in ? result : "";
}

void write_file(const std::string& name, const std::string& contents)
{
  errno = 0;
  std::ofstream out(name, std::ios::binary);
  if(!out)
    fail_to("opened for writing", name);
  out.write(contents.data(), static_cast<std::streamsize>(contents.size()));
  out.close(); // when network file systems may tell that the disk is full
  if(!out)
    fail_to("written", name);
}

void create_folder(const std::string& name)
{
  std::error_code error;
  fs::create_directory(name, error);
  errno = error.value();
  if(error)
    fail_to("created", name);
}

void sync_to_disk([[maybe_unused]] const std::string& name)
{
#if defined(__unix__) || defined(__APPLE__)
  errno = 0;
  const int descriptor = ::open(name.c_str(), O_RDONLY);
  const bool is_done = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int reason = errno;
  if(descriptor >= 0)
    ::close(descriptor);
  // Some file systems cannot sync folders. A folder that files are written to may be unreadable.
  constexpr int of_folders[] = {EACCES, EBADF, EINVAL, ENOSYS, ENOTSUP};
  std::error_code ignored;
  if(!is_done &&
     std::find(std::begin(of_folders), std::end(of_folders), reason) != std::end(of_folders) &&
     fs::is_directory(name, ignored))
    return;
  errno = reason;
  if(!is_done)
    fail_to("flushed to disk", name);
#endif
}

void resize_file(const std::string& name, const std::uint64_t length)
{
  std::error_code error;
  fs::resize_file(name, length, error);
  errno = error.value();
  if(error)
    fail_to("resized", name);
}

std::shared_ptr<void> lock_file(const std::string& name, const std::string& subject)
{
  return std::make_shared<File_lock>(name, subject);
}

Local_file::Local_file(const std::string& name) : m_name(name)
{
  errno = 0;
  m_stream.rdbuf()->pubsetbuf(nullptr, 0); // unbuffered
  m_stream.open(name, std::ios::binary | std::ios::in | std::ios::out);
  if(!m_stream)
    fail_to("opened for writing", name);
}

void Local_file::write(const std::uint64_t offset, const void* const data, const std::size_t size)
{
  const std::lock_guard lock(m_mutex);
  errno = 0;
  m_stream.seekp(static_cast<std::streamoff>(offset));
  m_stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  if(!m_stream.flush())
    fail_to("written", m_name);
}

} // namespace internal
} // namespace CGAL::Approximate_geodesics
