// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRIX_FILES_FILE_LOCK_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRIX_FILES_FILE_LOCK_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Matrix_files/Local_file.h>

#include <boost/interprocess/exceptions.hpp>
#include <boost/interprocess/sync/file_lock.hpp>

#include <filesystem>
#include <string>
#include <system_error>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Says that a program is at work. It does so by a lock of the system, which goes when the program
 * does, however that ends. The file goes as well, unless the program is killed.
 */
class File_lock
{
public:
  // `subject` is what the work is about.
  File_lock(const std::string& file, const std::string& subject) : m_file(file)
  {
    {
      const Local_file made_if_none(file); // to close it later would give up the lock
    }
    m_lock = boost::interprocess::file_lock(file.c_str());
    if(!try_lock() || !std::filesystem::exists(file)) // or that program has ended just now
      reject(subject + " is being computed by another program");
  }

  File_lock(const File_lock&) = delete;
  File_lock& operator=(const File_lock&) = delete;

  ~File_lock()
  {
    std::error_code ignored;
    std::filesystem::remove(m_file, ignored);
  }

private:
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
  boost::interprocess::file_lock m_lock;
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRIX_FILES_FILE_LOCK_H
