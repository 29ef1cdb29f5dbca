// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_FILE_NAMES_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_FILE_NAMES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The names of the auxiliary files that exist while FILE is computed:
 *
 *   FILE.part, FILE.part.1, ...        computed data, joint or per process
 *   FILE.journal, FILE.journal.1, ...  completed blocks of rows, per process
 *   FILE.new                           the result, if it is assembled from parts
 *   FILE.lock                          locked while a program computes FILE
 */
class Matrix_file_names
{
public:
  // existing files of all runs, by rank
  using By_rank = std::map<std::size_t, std::string>;

  explicit Matrix_file_names(std::string file) : m_file(std::move(file)) {}

  const std::string& file() const { return m_file; }
  std::string part(const std::size_t rank = 0) const { return of_process("part", rank); }
  std::string journal(const std::size_t rank) const { return of_process("journal", rank); }
  std::string copy() const { return m_file + ".new"; }
  std::string lock() const { return m_file + ".lock"; }

  By_rank parts() const { return those_there("part"); }
  By_rank journals() const { return those_there("journal"); }

  std::string folder() const
  {
    const std::filesystem::path path(m_file);
    return path.has_parent_path() ? path.parent_path().string() : ".";
  }

private:
  std::string of_process(const std::string& kind, const std::size_t rank) const
  {
    return m_file + '.' + kind + (rank == 0 ? "" : '.' + std::to_string(rank));
  }

  By_rank those_there(const std::string& kind) const
  {
    namespace fs = std::filesystem;
    const std::string first = fs::path(m_file).filename().string() + '.' + kind;
    By_rank result;
    for(const fs::directory_entry& entry : fs::directory_iterator(folder()))
    {
      const std::string name = entry.path().filename().string();
      if(name.compare(0, first.size(), first) != 0)
        continue;
      const std::string rest = name.substr(first.size());
      if(rest.empty())
        result[0] = part_of_folder(name);
      else if(rest[0] == '.' && is_number(rest.substr(1)))
        result[std::stoul(rest.substr(1))] = part_of_folder(name);
    }
    return result;
  }

  std::string part_of_folder(const std::string& name) const
  {
    return (std::filesystem::path(m_file).parent_path() / name).string();
  }

  static bool is_number(const std::string& text)
  {
    return !text.empty() && text.size() < 10 &&
           text.find_first_not_of("0123456789") == std::string::npos;
  }

  std::string m_file;
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_FILE_NAMES_H
