// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_LABEL_FILES_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_LABEL_FILES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Grid_files/Grid_window.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Grid_nodes.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Kept_label.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Mapped_file.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Work_folder.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The labels and predecessors of all nodes of a grid, row by row, in files.
 */
class Label_files
{
public:
  // Several rows in memory.
  class Rows
  {
  public:
    Kept_label& label(const Grid_place& p) const { return m_labels.data<Kept_label>()[index(p)]; }
    Kept_predecessor& predecessor(const Grid_place& p) const
    {
      return m_predecessors.data<Kept_predecessor>()[index(p)];
    }

    // Calls `f(place)` for all places of these columns.
    template <typename F>
    void for_each_place(const std::size_t first_column, const std::size_t columns, F f) const
    {
      for(std::size_t row = 0; row < m_rows; ++row)
        for(std::size_t column = 0; column < columns; ++column)
          for(std::size_t slot = 0; slot < m_slots; ++slot)
            f(Grid_place{first_column + column, m_first_row + row, slot});
    }

  private:
    friend Label_files;

    std::size_t index(const Grid_place& p) const
    {
      return ((p.row - m_first_row) * m_columns + p.column) * m_slots + p.slot;
    }

    std::size_t m_first_row, m_rows, m_columns, m_slots;
    Mapped_file::Part m_labels, m_predecessors;
  };

  // Files of the task are used if there are some. An empty name of the folder stands for memory.
  Label_files(const Grid_nodes& nodes, const std::string& folder, std::string task)
    : m_nodes(nodes),
      m_folder(folder),
      m_task(std::move(task)),
      m_is_new(!m_folder.has_begun(m_task)),
      m_is_intact(m_is_new || m_folder.is_intact()),
      m_labels(open("labels", sizeof(Kept_label))),
      m_predecessors(open("predecessors", sizeof(Kept_predecessor)))
  {
  }

  // Returns whether there were no files of this task.
  bool is_new() const { return m_is_new; }

  // Returns whether all that was written is in the files.
  bool is_intact() const { return m_is_intact; }

  void open_source(const Grid_place& source) const
  {
    rows(source.row, 1).label(source).set_open(0);
  }

  // Notes that labels are open where they have to be.
  void begin() const
  {
    if(m_is_new || !m_is_intact)
      m_folder.begin(m_task);
  }

  Rows rows(const std::size_t first_row, const std::size_t number) const
  {
    const std::size_t size_of_row = m_nodes.columns() * m_nodes.number_of_slots();
    Rows result;
    result.m_first_row = first_row;
    result.m_rows = number;
    result.m_columns = m_nodes.columns();
    result.m_slots = m_nodes.number_of_slots();
    const auto part = [&](const Mapped_file& file, const std::size_t size_of_entry) {
      const std::size_t size = size_of_row * size_of_entry;
      return file.part(static_cast<std::uint64_t>(first_row) * size, number * size);
    };
    result.m_labels = part(m_labels, sizeof(Kept_label));
    result.m_predecessors = part(m_predecessors, sizeof(Kept_predecessor));
    return result;
  }

  void remove() const { m_folder.clear(); }

private:
  Mapped_file open(const char* const name, const std::size_t size_of_entry) const
  {
    const std::uint64_t size_of_row = m_nodes.columns() * m_nodes.number_of_slots() * size_of_entry;
    return Mapped_file(m_folder.file(name), size_of_row * m_nodes.rows(),
                       m_is_new ? Mapped_file::Mode::NEW : Mapped_file::Mode::EXISTING);
  }

  Grid_nodes m_nodes;
  Work_folder m_folder;
  std::string m_task;
  bool m_is_new, m_is_intact;
  Mapped_file m_labels, m_predecessors;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_LABEL_FILES_H
