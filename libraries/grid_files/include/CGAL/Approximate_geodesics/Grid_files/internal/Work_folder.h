// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_WORK_FOLDER_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_WORK_FOLDER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <boost/interprocess/sync/file_lock.hpp>

#include <string>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A folder for the files of one task at a time, which one process works on. The file `task` says
 * which it is, and appears when the other files are ready to be resumed from.
 *
 * What a process has written to mapped files is kept if it is killed. If the operating system
 * crashes, it may be kept in part; `is_intact()` tells, by the boot that `task` was written in.
 */
class Work_folder
{
public:
  // Creates the folder, unless it exists, and locks it. An empty name stands for no folder. Throws
  // std::invalid_argument if another process works there.
  explicit Work_folder(const std::string& name);

  // Returns the name of a file there; empty if there is no folder.
  std::string file(const std::string& name) const;

  // Returns whether this task was begun. Throws std::invalid_argument if another one was.
  bool has_begun(const std::string& task) const;

  // Returns whether the operating system has run without a restart since `begin()`.
  bool is_intact() const;

  // Notes that the files of this task are ready.
  void begin(const std::string& task) const;

  // Removes files of a task that has ended, and the folder if nothing else is there.
  void clear() const;

private:
  std::string m_name;
  boost::interprocess::file_lock m_lock; // the system releases it when the process ends
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_WORK_FOLDER_H
