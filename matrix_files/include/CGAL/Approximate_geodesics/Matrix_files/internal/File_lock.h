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
 * The names of files that this program has locked. Systems tell programs apart by their locks, and
 * not the objects of one; and who closes a file gives up all locks that his program has of it.
 */
class Locked_names
{
public:
  // Returns whether the name was not there.
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
 * Says that a program is at work. It does so by a lock of the system, which goes when the program
 * does, however that ends. The file goes as well, unless the program is killed.
 */
class File_lock
{
public:
  // `subject` is what the work is about.
  File_lock(const std::string& file, const std::string& subject)
    : m_file(file), m_name(std::filesystem::weakly_canonical(file).string())
  {
    if(!Locked_names::insert(m_name))
      reject(subject + " is being computed by this program already, for another object");
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
    m_lock = boost::interprocess::file_lock(); // closes the file before another object opens it
    Locked_names::erase(m_name);
  }

  void lock(const std::string& subject)
  {
    {
      const Local_file made_if_none(m_file); // to close it later would give up the lock
    }
    m_lock = boost::interprocess::file_lock(m_file.c_str());
    if(!try_lock() || !std::filesystem::exists(m_file)) // or that program has ended just now
      reject(subject + " is being computed by another program");
  }

  // Some file systems have no locks.
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
  std::string m_name; // the same for all names of the file
  boost::interprocess::file_lock m_lock;
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_FILE_LOCK_H
