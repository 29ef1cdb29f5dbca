// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_FILE_LOCK_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_FILE_LOCK_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Local_file.h>

#include <boost/interprocess/exceptions.hpp>
#include <boost/interprocess/sync/file_lock.hpp>

#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <system_error>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The names of the files that this process has locked. POSIX locks belong to a process: they do not
 * exclude other objects of the same process, and closing any descriptor of a file releases them.
 */
class Locked_names
{
public:
  // Returns whether the name was inserted, that is, whether it was absent.
  static bool insert(const std::string& name)
  {
    const std::lock_guard lock(s_mutex);
    return s_names.insert(name).second;
  }

  static void erase(const std::string& name)
  {
    const std::lock_guard lock(s_mutex);
    s_names.erase(name);
  }

private:
  inline static std::mutex s_mutex;
  inline static std::set<std::string> s_names;
};

/*
 * Ensures that a single program computes a file. The operating system releases the lock when the
 * process ends, even if it is killed; the lock file itself remains after a kill.
 */
class File_lock
{
public:
  // `subject` names the computed file in messages.
  File_lock(const std::string& file, const std::string& subject)
    : m_file(file), m_name(std::filesystem::weakly_canonical(file).string())
  {
    if(!Locked_names::insert(m_name))
      reject(subject + " is already being computed by another object of this program");
    try
    {
      lock(subject);
    }
    catch(...)
    {
      give_up();
      throw;
    }
  }

  File_lock(const File_lock&) = delete;
  File_lock& operator=(const File_lock&) = delete;

  ~File_lock()
  {
    std::error_code ignored;
    std::filesystem::remove(m_file, ignored);
    give_up();
  }

private:
  void give_up()
  {
    m_lock = boost::interprocess::file_lock(); // before another object opens the file
    Locked_names::erase(m_name);
  }

  void lock(const std::string& subject)
  {
    {
      const Local_file made_if_none(m_file); // must be closed before locking
    }
    m_lock = boost::interprocess::file_lock(m_file.c_str());
    if(!try_lock() || !std::filesystem::exists(m_file)) // the file vanishes if the owner just ended
      reject(subject + " is already being computed by another program");
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

  std::string m_file;
  std::string m_name; // canonical
  boost::interprocess::file_lock m_lock;
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_FILE_LOCK_H
