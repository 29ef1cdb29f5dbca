// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_MAPPED_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_MAPPED_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Bytes in a file, of which parts are mapped into memory. What is written to them survives the
 * process, however it ends. Without a name, they are in memory.
 */
class Mapped_file
{
public:
  enum class Mode
  {
    NEW, // all bytes are zero
    EXISTING
  };

  // A part of the file, in memory as long as the object lives.
  class Part
  {
  public:
    template <typename T>
    T* data() const
    {
      return static_cast<T*>(m_address);
    }

  private:
    friend Mapped_file;
    boost::interprocess::mapped_region m_region; // empty if the file is in memory
    void* m_address = nullptr;
  };

  // Reserves room on disk for the whole file, so that no later write can fail. Throws
  // std::runtime_error if there is not enough, or the file cannot be written; std::invalid_argument
  // if an existing file has another size.
  Mapped_file(const std::string& name, std::uint64_t size, Mode mode);

  Part part(std::uint64_t offset, std::size_t size) const;

private:
  boost::interprocess::file_mapping m_file;
  boost::interprocess::mapped_region m_memory; // of all bytes, if there is no file
  bool m_is_in_memory;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_MAPPED_FILE_H
