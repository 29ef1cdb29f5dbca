// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files.h"

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#define APPROXIMATE_GEODESICS_POSIX
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#else
#include <boost/interprocess/sync/file_lock.hpp>
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

#ifdef APPROXIMATE_GEODESICS_POSIX

// An open file; negative if that failed.
class Descriptor
{
public:
  Descriptor(const std::string& name, const int flags)
    : m_number(::open(name.c_str(), flags | O_CLOEXEC, 0666))
  {
  }

  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  ~Descriptor()
  {
    if(m_number >= 0)
      ::close(m_number);
  }

  operator int() const { return m_number; }

private:
  int m_number;
};

// The lock belongs to the open file, not to the process, so it excludes other threads, too.
class Open_lock
{
public:
  explicit Open_lock(const std::string& name) : m_file(name, O_RDWR | O_CREAT | O_NOFOLLOW)
  {
    if(m_file < 0)
      fail_to("opened for writing", name);
  }

  // Succeeds on file systems without locks.
  bool try_lock() { return ::flock(m_file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

  bool is_named(const std::string& name) const
  {
    struct stat opened, named;
    return ::fstat(m_file, &opened) == 0 && ::lstat(name.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
  }

private:
  Descriptor m_file;
};

#else

class Open_lock
{
public:
  explicit Open_lock(const std::string& name)
    : m_lock((write_file(name, ""), boost::interprocess::file_lock(name.c_str())))
  {
  }

  bool try_lock() { return m_lock.try_lock(); }
  bool is_named(const std::string& /* name */) const { return true; } // open files are not removed

private:
  boost::interprocess::file_lock m_lock;
};

#endif

/*
 * A locked file, which is removed before it is unlocked. A process that opened it earlier may lock
 * it later, and has to open its successor then.
 */
class File_lock
{
public:
  File_lock(const std::string& name, const std::string& subject)
    : m_name(fs::absolute(name).string())
  {
    constexpr int most_attempts = 100; // some file systems have no stable inode numbers
    for(int i = 0; i < most_attempts && !(m_lock && m_lock->is_named(name)); ++i)
    {
      if(is_something_else(name)) // would be removed
        reject(name + " exists, but is not a lock; delete it, or choose another name");
      errno = 0;
      m_lock.emplace(name);
      if(!m_lock->try_lock())
        reject(subject + " is already being computed, by this program or another one");
    }
  }

  ~File_lock()
  {
    std::error_code ignored;
    fs::remove(m_name, ignored);
  }

private:
  // Whether there is something by this name that is not left by a killed program.
  static bool is_something_else(const std::string& name)
  {
    std::error_code error; // its owner may just remove it
    const fs::file_status status = fs::symlink_status(name, error);
    return fs::exists(status) &&
           (!fs::is_regular_file(status) || (fs::file_size(name, error) > 0 && !error));
  }

  std::string m_name; // also if the current folder changes
  std::optional<Open_lock> m_lock;
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
#ifdef APPROXIMATE_GEODESICS_POSIX
  errno = 0;
  const Descriptor file(name, O_RDONLY);
  if(file >= 0 && ::fsync(file) == 0)
    return;
  // Some file systems cannot sync folders. A folder that files are written to may be unreadable.
  constexpr int of_folders[] = {EACCES, EBADF, EINVAL, ENOSYS, ENOTSUP};
  const int reason = errno;
  std::error_code ignored;
  if(std::find(std::begin(of_folders), std::end(of_folders), reason) != std::end(of_folders) &&
     fs::is_directory(name, ignored))
    return;
  errno = reason;
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
