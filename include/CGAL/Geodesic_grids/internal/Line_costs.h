// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_LINE_COSTS_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_LINE_COSTS_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/Grid_vector.h>
#include <CGAL/Geodesic_grids/internal/Cell_storage.h>
#include <CGAL/Geodesic_grids/internal/Grid_lines.h>
#include <CGAL/Geodesic_grids/internal/Grid_metric.h>
#include <CGAL/Geodesic_grids/internal/Slope_costs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The costs of lines by heights, or by a function of cell and direction, or both, times friction.
 */
class Line_costs
{
public:
  // The cost per unit of length in a direction of the search.
  using Cell_function = std::function<double(const Grid_cell&, const Grid_vector&)>;

  // friction only
  Line_costs() = default;

  Line_costs(std::vector<double> heights, Slope_costs slopes)
    : m_heights(std::move(heights)), m_slopes(std::move(slopes))
  {
  }

  // Heights may be empty.
  Line_costs(std::vector<double> heights, Cell_function function)
    : m_heights(std::move(heights)), m_function(std::move(function))
  {
  }

  // Returns the costs of the opposite direction.
  Line_costs reversed() const
  {
    Line_costs result = *this;
    result.m_slopes = m_slopes.reversed();
    if(depend_on_cells())
      result.m_function = [function = m_function](const Grid_cell& cell, const Grid_vector& d) {
        return function(cell, -d);
      };
    return result;
  }

  bool has_heights() const { return !m_heights.empty(); }
  const std::vector<double>& heights() const { return m_heights; }
  bool depend_on_cells() const { return static_cast<bool>(m_function); }

  // Whether costs are only lengths times friction.
  bool are_flat() const { return !has_heights() && !depend_on_cells(); }

  double error_of_slopes() const { return m_slopes.error(); }

  // Returns a lower bound of the cost per unit of horizontal length, without friction.
  double smallest() const { return depend_on_cells() ? m_smallest_of_cells : m_slopes.smallest(); }
  void set_smallest_of_cells(const double cost) { m_smallest_of_cells = cost; }

  // Returns a lower bound of the cost of a line of this length.
  double lower_bound(const std::size_t from, const std::size_t to, const double length) const
  {
    if(depend_on_cells())
      return length * m_smallest_of_cells;
    return length * m_slopes.lower_bound((m_heights[to] - m_heights[from]) / length);
  }

  // Returns the cost per unit of length of a cell, in the direction of a line on a plane.
  double cost_in_cell(const Grid_cell& cell,
                      const Grid_lines::Line& line,
                      const Grid_metric::Sides& sides) const
  {
    return checked_cost(cell, direction(line, sides, 0));
  }

  // Returns the length of a line on the surface; the line has this length relative to its own one.
  double length(const Grid_lines& lines,
                const Grid_lines::Line& line,
                const std::size_t from,
                const double scale) const
  {
    if(!has_heights())
      return scale * line.length;
    double result = 0, last_height = m_heights[from];
    for(std::size_t k = line.first_piece; k < line.beyond_piece; ++k)
    {
      const Grid_lines::Piece& piece = lines.pieces()[k];
      const double next = end_height(piece, m_heights.data() + from);
      result += std::hypot(scale * piece.length, next - last_height);
      last_height = next;
    }
    return result;
  }

  // Returns the cost of a line if all cells have the same friction, with the bits of `cost()`. The
  // line has this length relative to its own one.
  double cost_if_uniform(const Grid_lines& lines,
                         const Grid_lines::Line& line,
                         const std::size_t from,
                         const double scale,
                         const double friction) const
  {
    return sum_over_pieces(lines, line, from, scale,
                           [=](const auto& piece, std::size_t) { return piece.length * friction; });
  }

  // Returns the cost of a line from a cell, by the friction of cells; infinity if it is blocked.
  double cost(const Grid_lines& lines,
              const Grid_lines::Line& line,
              const std::size_t from,
              const double scale,
              const double* const friction) const
  {
    if(Grid_lines::is_blocked_at_corner(line, friction + from))
      return infinity;
    return sum_over_pieces(lines, line, from, scale,
                           [&](const Grid_lines::Piece& piece, const std::size_t first_part) {
                             return weight_of_piece(lines, piece, first_part, friction + from);
                           });
  }

  // Returns the cost of a line by the function of cells.
  double cost_by_cells(const Grid_lines& lines,
                       const Grid_lines::Line& line,
                       const Cell_storage& storage,
                       const std::size_t from,
                       const Grid_metric::Sides& sides,
                       const double* const friction) const
  {
    if(Grid_lines::is_blocked_at_corner(line, friction + from))
      return infinity;
    const double scale = Grid_lines::scale(line, sides);
    const double* const height = m_heights.data() + (has_heights() ? from : 0);
    double result = 0, last_height = has_heights() ? *height : 0;
    std::size_t i = line.first_part;
    for(std::size_t k = line.first_piece; k < line.beyond_piece; ++k)
    {
      const Grid_lines::Piece& piece = lines.pieces()[k];
      const double next = has_heights() ? end_height(piece, height) : 0;
      const double slope = (next - last_height) * piece.inverse / scale;
      last_height = next;
      const double stretch = scale * std::sqrt(1 + slope * slope);
      if(!(stretch < infinity)) // there is no direction
        return infinity;
      const Grid_vector ahead = direction(line, sides, slope);
      for(; i < piece.beyond_part; ++i)
        result += stretch * cost_of_part(lines.parts()[i], storage, from, ahead, friction);
    }
    return result;
  }

  std::size_t memory() const { return memory_of(m_heights, m_slopes); }

private:
  // The interpolated height at the end of a piece of a line from the cell of `height`.
  static double end_height(const Grid_lines::Piece& piece, const double* const height)
  {
    const double first = height[piece.first];
    return first + piece.share * (height[piece.second] - first);
  }

  // Returns the length of a piece times friction. Rounding must not depend on cells elsewhere.
  static double weight_of_piece(const Grid_lines& lines,
                                const Grid_lines::Piece& piece,
                                const std::size_t first_part,
                                const double* const friction)
  {
    const double first = friction[lines.parts()[first_part].offset];
    bool is_uniform = true;
    double result = 0;
    for(std::size_t i = first_part; i < piece.beyond_part; ++i)
    {
      const Grid_lines::Part& part = lines.parts()[i];
      const double f = friction[part.offset];
      is_uniform = is_uniform && f == first;
      result += part.length * f;
    }
    return is_uniform ? piece.length * first : result;
  }

  // Adds up the costs of the pieces of a line. `weight(piece, first_part)` is the length of a piece
  // times friction.
  template <typename Weight>
  double sum_over_pieces(const Grid_lines& lines,
                         const Grid_lines::Line& line,
                         const std::size_t from,
                         const double scale,
                         const Weight& weight) const
  {
    const double* const height = m_heights.data() + from;
    const double inverse = 1 / scale;
    double result = 0, last_height = *height;
    std::size_t part = line.first_part;
    for(std::size_t k = line.first_piece; k < line.beyond_piece; ++k)
    {
      const Grid_lines::Piece& piece = lines.pieces()[k];
      const double next = end_height(piece, height);
      const double cost = m_slopes((next - last_height) * piece.inverse * inverse);
      const double w = weight(piece, part);
      if(!(w < infinity && cost < infinity)) // their product may not be a number
        return infinity;
      result += w * cost;
      last_height = next;
      part = piece.beyond_part;
    }
    return result * scale;
  }

  double cost_of_part(const Grid_lines::Part& part,
                      const Cell_storage& storage,
                      const std::size_t from,
                      const Grid_vector& direction,
                      const double* const friction) const
  {
    const std::size_t i = from + static_cast<std::size_t>(part.offset); // may wrap around
    if(friction[i] == infinity)
      return infinity;
    const Grid_cell cell = storage.cell(i);
    const double cost = checked_cost(cell, direction);
    return cost == infinity ? infinity : part.length * friction[i] * cost;
  }

  double checked_cost(const Grid_cell& cell, const Grid_vector& direction) const
  {
    const double cost = m_function(cell, direction);
    if(!(cost >= 0))
      reject(value_in_message("cost", cost, cell) + " in direction (" + text_of(direction.x()) +
             ", " + text_of(direction.y()) + ", " + text_of(direction.z()) +
             "); it must be a number that is not negative, or infinity");
    return cost;
  }

  // Returns the direction of a line where cells have these sides, a unit vector.
  static Grid_vector
  direction(const Grid_lines::Line& line, const Grid_metric::Sides& sides, const double slope)
  {
    const double x = static_cast<double>(line.columns) * sides.width,
                 y = static_cast<double>(line.rows) * sides.height;
    const double length = std::hypot(x, y), stretch = std::sqrt(1 + slope * slope);
    return {x / length / stretch, y / length / stretch, slope / stretch};
  }

  std::vector<double> m_heights;
  Slope_costs m_slopes;
  Cell_function m_function;
  double m_smallest_of_cells = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_LINE_COSTS_H
