// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_GRID_BORDER_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_GRID_BORDER_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Geometric_progressions.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The corners of a cell and points on its sides, the same for all cells, and the table of the
 * distances between them.
 *
 * A cell owns its first corner, and the points of the two sides there. In this order: the points of
 * the side along the row, the corner, the points of the side along the column. This is a block of
 * nodes. The border of a cell is made of its own block and of parts of three others, each without a
 * gap:
 *
 *   run 0: the whole block of the cell
 *   run 1: the corner, and the points along the column, of the next cell in the row
 *   run 2: the points along the row, and the corner, of the next cell in the column
 *   run 3: the corner of the next cell in both
 *
 * Their nodes, in this order, are the slots of a cell; one more is for the center.
 *
 * Points are in geometric progressions as on the edges of a mesh. The proof there needs that a
 * point at the distance `d` from the nearer corner is not nearer to the other sides, or to the
 * center, than `d` times the sine, which is the ratio of the sides for those that are longer. Half
 * of the shorter side takes the place of half of the radius of a star. Centers are farther than
 * this from all corners, so they are ends of paths like vertices, and the bound holds for them.
 */
class Grid_border
{
public:
  static constexpr std::size_t MAXIMUM_NUMBER_OF_POINTS_PER_SIDE = 1000;
  static constexpr std::size_t NUMBER_OF_RUNS = 4;

  // Consecutive slots, which are nodes of the block of another cell, from one of its nodes on.
  struct Run
  {
    std::size_t next_column, next_row; // 0 or 1
    std::size_t first_in_block;
    std::size_t first_slot, size;
  };

  // no points, and no corners
  Grid_border() = default;

  // Throws std::length_error if there are too many points.
  Grid_border(const Grid_shape& shape, const double epsilon)
  {
    const std::vector<double> along_row = points(shape.cell_width, shape.cell_height, epsilon);
    const std::vector<double> along_column = points(shape.cell_height, shape.cell_width, epsilon);
    m_in_row = along_row.size();
    m_in_column = along_column.size();
    for(const double x : along_row)
      m_block.push_back({x, 0});
    m_block.push_back({0, 0});
    for(const double y : along_column)
      m_block.push_back({0, y});
    m_runs = {Run{0, 0, 0, 0, m_block.size()}, Run{1, 0, m_in_row, m_block.size(), 1 + m_in_column},
              Run{0, 1, 0, m_block.size() + 1 + m_in_column, m_in_row + 1},
              Run{1, 1, m_in_row, 2 * m_block.size() + 1, 1}};
    m_number_of_slots = 2 * m_block.size() + 2;
    measure(shape);
  }

  // Returns the number of nodes that a cell owns; 0 if there are no points.
  std::size_t size_of_block() const { return m_block.size(); }

  // Returns where a node is, relative to the first corner of its cell.
  const Grid_point& position_in_block(const std::size_t i) const { return m_block[i]; }

  std::size_t number_of_slots() const { return m_number_of_slots; }
  const std::array<Run, NUMBER_OF_RUNS>& runs() const { return m_runs; }

  // Returns the distances to all slots, and to the center after them, from a slot or the center.
  const double* distances(const std::size_t slot) const
  {
    return m_distances.data() + slot * (m_number_of_slots + 1);
  }
  const std::vector<double>& distances() const { return m_distances; }

  // Calls `f(run, slot)` for all runs that have a node of a block, and its slot there.
  template <typename F>
  void for_each_run_of(const std::size_t in_block, F f) const
  {
    for(const Run& run : m_runs)
      if(in_block >= run.first_in_block && in_block < run.first_in_block + run.size)
        f(run, run.first_slot + in_block - run.first_in_block);
  }

  // Returns whether the border of a cell has this node of the block of a cell so many columns and
  // rows farther.
  bool has_node(const std::size_t columns, const std::size_t rows, const std::size_t in_block) const
  {
    if(columns > 1 || rows > 1)
      return false;
    const Run& run = m_runs[columns + 2 * rows];
    return in_block >= run.first_in_block && in_block < run.first_in_block + run.size;
  }

  bool is_corner(const std::size_t in_block) const { return in_block == m_in_row; }

  std::size_t memory() const { return memory_of(m_block, m_distances); }

private:
  // as for the points of meshes
  static constexpr double SHARE_OF_CROSSINGS = 0.65;
  static constexpr double LARGEST_START = 1. / 3;

  // Returns the distances of the points of a side from one of its ends.
  static std::vector<double> points(const double length, const double other, const double epsilon)
  {
    const double crossings = SHARE_OF_CROSSINGS * epsilon;
    const double corners = (epsilon - crossings) / (1 + crossings / 2);
    const double ratio = (std::min)(other / length, 1.);
    constexpr double rounding_of_logarithm = 2.5e-7; // of positions
    const double log_of_ratio = 2 * std::asinh(ratio * std::sqrt(crossings));
    const double start = (std::min)(corners / (2 * (1 + corners)), LARGEST_START) * ratio;
    const Geometric_progressions::End end{start, 1, log_of_ratio - rounding_of_logarithm};
    std::size_t number = MAXIMUM_NUMBER_OF_POINTS_PER_SIDE + 1;
    if(end.log_of_ratio > 0)
      number = Geometric_progressions(end, end).number_of_points();
    if(number > MAXIMUM_NUMBER_OF_POINTS_PER_SIDE)
      throw std::length_error("Approximate_geodesics: for this epsilon, cells whose sides are " +
                              text_of(length) + " and " + text_of(other) + " need more than " +
                              std::to_string(MAXIMUM_NUMBER_OF_POINTS_PER_SIDE) +
                              " points on a side");
    std::vector<float> positions(number);
    Geometric_progressions(end, end).place(positions.data());
    std::vector<double> result;
    for(const double position : positions)
      result.push_back((position < 0 ? 1 + position : position) * length);
    return result;
  }

  void measure(const Grid_shape& shape)
  {
    std::vector<Grid_point> slots;
    for(const Run& run : m_runs)
      for(std::size_t i = 0; i < run.size; ++i)
      {
        const Grid_point& p = m_block[run.first_in_block + i];
        slots.push_back({p.x + static_cast<double>(run.next_column) * shape.cell_width,
                         p.y + static_cast<double>(run.next_row) * shape.cell_height});
      }
    slots.push_back({shape.cell_width / 2, shape.cell_height / 2});
    m_distances.reserve(slots.size() * slots.size());
    for(const Grid_point& p : slots)
      for(const Grid_point& q : slots)
        m_distances.push_back(std::hypot(p.x - q.x, p.y - q.y));
  }

  std::size_t m_in_row = 0, m_in_column = 0; // points of a side
  std::vector<Grid_point> m_block;
  std::array<Run, NUMBER_OF_RUNS> m_runs = {};
  std::size_t m_number_of_slots = 0;
  std::vector<double> m_distances;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_GRID_BORDER_H
