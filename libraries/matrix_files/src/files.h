// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_MATRIX_FILES_FILES_H
#define APPROXIMATE_GEODESICS_MATRIX_FILES_FILES_H

#include <CGAL/Approximate_geodesics/Matrix_files/Process_team.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <mutex>
#include <string>

// Files of the operating system. Functions that fail throw, with the reason of the system.

namespace CGAL::Approximate_geodesics::internal {

// Returns the contents of a file; empty if it cannot be read.
std::string read_file(const std::string& name);

// Creates or replaces a file.
void write_file(const std::string& name, const std::string& contents);

// Creates a folder, unless it exists.
void create_folder(const std::string& name);

// Waits until a file or a folder is on disk, on systems that have `fsync()`.
void sync_to_disk(const std::string& name);

// Changes the length of an existing file.
void resize_file(const std::string& name, std::uint64_t length);

/*
 * Creates a file and locks it until the result is destroyed, so that `subject` is computed once at
 * a time. The operating system releases the lock when the process ends, even if it is killed; the
 * file itself remains after a kill.
 */
std::shared_ptr<void> lock_file(const std::string& name, const std::string& subject);

/*
 * An existing file to write to. It is safe to use from several threads.
 */
class Local_file : public Process_team::File
{
public:
  explicit Local_file(const std::string& name);
  void write(std::uint64_t offset, const void* data, std::size_t size) override;
  void sync() override { sync_to_disk(m_name); }

private:
  std::string m_name;
  std::fstream m_stream;
  std::mutex m_mutex; // guards the position of the stream
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // APPROXIMATE_GEODESICS_MATRIX_FILES_FILES_H
