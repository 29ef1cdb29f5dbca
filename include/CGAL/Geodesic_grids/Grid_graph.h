// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_GRID_GRAPH_H
#define CGAL_GEODESIC_GRIDS_GRID_GRAPH_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Geodesic_costs/internal/Free_ways.h>
#include <CGAL/Geodesic_costs/internal/Slope_limit.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/Grid_vector.h>
#include <CGAL/Geodesic_grids/internal/Cell_storage.h>
#include <CGAL/Geodesic_grids/internal/Grid_border.h>
#include <CGAL/Geodesic_grids/internal/Grid_lines.h>
#include <CGAL/Geodesic_grids/internal/Grid_metric.h>
#include <CGAL/Geodesic_grids/internal/Line_costs.h>
#include <CGAL/Geodesic_grids/internal/Line_slopes.h>
#include <CGAL/Geodesic_grids/internal/Slope_costs.h>
#include <CGAL/Geodesic_grids/internal/read_cells.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicGridsGrids
 *
 * The graph of a regular grid of cells, each of which has a friction, a cost per unit of length; or
 * a height; or both. It is a graph for rasters: no mesh is built, and no arcs are stored.
 *
 * The first nodes are the centers of the cells, in the order of values. Straight lines join them to
 * the centers of other cells, up to 15 columns and rows away; they cost their lengths within the
 * cells that they cross, times the friction there. Where cells have the same friction, distances
 * are at most 0.3 % too large in all directions, if the width of a cell is half to twice its
 * height; `error_on_equal_cells()` returns this bound for any shape. Between cells of different
 * friction, where cheapest paths bend at sides, there is no bound.
 *
 * With `heights`, lines are on the surface. Heights are those of the centers, and are interpolated
 * where a line crosses a row or a column of centers; slopes between these points are constant.
 * Lengths are those in space. A cost function of the slope, as `Hiking_time`, replaces the cost of
 * a unit of length; slopes that are so steep that zigzags cost less are climbed in zigzags, whose
 * costs count. Slopes steeper than 4 always are, in zigzags of at most 4; this makes costs up to
 * 3.1 % too large where functions do not fall beyond 4. A cost function of cell and direction, as
 * `Drift_time`, does not need heights; lines cost what it returns in each cell for their own
 * direction. Costs of a function of the slope are interpolated between slopes that are 1/2000
 * apart. This makes them at most `error_of_slopes()` too large. There is no bound otherwise, as
 * cheapest paths on a surface bend between centers, too.
 *
 * An infinite cost of a slope forbids straight lines of this slope, and is met by zigzags. With the
 * named parameter `max_slope`, there are no lines that are steeper anywhere, and no zigzags in
 * their place. A line has the slopes of the triangles between centers that it crosses; where the
 * two ways to divide four centers into triangles differ, it keeps the limit on both. So a wall that
 * is one cell wide is a wall. Paths still bend at centers: a slope that is steeper than the limit
 * is crossed on lines along it that are not, if it is at most 10 times as steep and cells are
 * square. Directions at the limit are few: on a plane of slope 1, paths are up to 23 % too long.
 * Cells whose steepness itself is too much, whatever the direction, need infinite friction.
 *
 * With the named parameter `epsilon`, there are also nodes at the corners of cells, and on their
 * sides, in the geometric progressions of `Geometric_points`, and straight arcs between all nodes
 * at the border of a cell, and its center. Then paths between centers cost at most
 * \f$1 + \varepsilon\f$ times as much as the cheapest ones in the plane, whatever the friction.
 *
 * Of the paths that cost the same, as cells are free, searches return one whose free parts are
 * shortest. Cells of infinite friction cannot be entered, nor those whose friction is `no_data`;
 * paths may run along their sides. No path leads between two of them that touch at a corner, so
 * that a diagonal row of cells is a barrier. Neither are there lines whose costs are infinite, or
 * overflow a `double` on heights or by a function.
 *
 * On a periodic grid, lines go on from the last column to the first one. Heights, friction and
 * costs are those of the cells there.
 *
 * The graph takes 8 bytes per cell, 8 more for a height, and a table of arcs that all cells share.
 * With \f$\varepsilon = 0.1\f$, square cells have 15 points on a side, so there are 32 nodes per
 * cell.
 *
 * \cgalModels{GeodesicGraph}
 */
class Grid_graph
{
public:
  /// the number of a node.
  using Node = std::uint32_t;

  /*!
   * builds the graph of a grid.
   *
   * \tparam FrictionRange a model of `ConstRange` whose value type is a number type, or such a type
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param shape the numbers of columns and rows, and the size of a cell
   * \param friction the costs per unit of length, row by row, not negative: `0` for cells that are
   *        free, infinity or `no_data` for cells that cannot be entered; or one number for all,
   *        whatever `no_data` is
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{epsilon}
   *     \cgalParamDescription{paths in the graph cost at most \f$1 + \varepsilon\f$ times as much
   *                           as the cheapest ones in the plane; not with any of the other
   *                           parameters, nor on a geographic or periodic grid, for which there is
   *                           no bound}
   *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
   *     \cgalParamDefault{no bound: there are only lines between centers}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{heights}
   *     \cgalParamDescription{the heights of the centers, row by row, in the unit of lengths; cells
   *                           whose height is `no_data` cannot be entered}
   *     \cgalParamType{a model of `ConstRange` whose value type is a number type, or a
   *                    `std::reference_wrapper` of one, which is not copied}
   *     \cgalParamDefault{the plane}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{face_weight_map}
   *     \cgalParamDescription{`directional_cost(f)`: the cost of a unit of length on the surface,
   *                           which friction multiplies. `f(slope)` is a function of the slope, in
   *                           units of height per horizontal unit, and needs `heights`.
   *                           `f(cell, direction)` is a model of `DirectionalCostFunction` whose
   *                           faces are of type `Grid_cell`, and directions of type `Grid_vector`.
   *                           It is called during searches, from several threads if there are
   *                           several, and without heights also when the graph is built.}
   *     \cgalParamType{`Directional_cost<F>`}
   *     \cgalParamDefault{lengths}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{max_slope}
   *     \cgalParamDescription{the steepest slope, uphill and downhill, that lines may have, in
   *                           units of height per horizontal unit, up to rounding; needs
   *                           `heights`}
   *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
   *     \cgalParamDefault{infinity: there is no limit}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{direction_to_source}
   *     \cgalParamDescription{whether costs are those of paths to the sources}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`false`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if there are no cells, the size of a cell is not a finite number
   *         above `0`, there are not as many values as cells, a friction or a cost is negative or
   *         not a number, a finite friction or the length of a line is not below 1e150, a height is
   *         not below 1e100, `epsilon` is not a finite number above `0`, `max_slope` is negative or
   *         not a number, latitudes are not from 90 to -90 degrees, the ellipsoid has no size above
   *         `0`, or a periodic grid has fewer than 31 columns or, in degrees, does not span 360 of
   *         them. Searches throw it if a function of cell and direction returns such a cost then.
   * \throws std::length_error if there are more than \f$2^{32} - 1\f$ nodes, or more than 1000
   *         points on a side.
   *
   * Run time and memory are \cgalBigO{n} for `n` cells, plus the square of the number of points on
   * the border of a cell.
   */
  template <typename FrictionRange, typename NamedParameters = parameters::Default_named_parameters>
  Grid_graph(const Grid_shape& shape,
             const FrictionRange& friction,
             [[maybe_unused]] const NamedParameters& np = parameters::default_values())
    : m_shape(checked(shape)), m_metric(m_shape), m_storage(m_shape)
  {
    static_assert(
        !internal::ignores_any<NamedParameters, internal_np::epsilon_t, internal_np::heights_t,
                               internal_np::face_weight_t, internal_np::max_slope_t,
                               internal_np::direction_to_source_t>,
        "Grid_graph reads the named parameters epsilon, heights, face_weight_map, max_slope and "
        "direction_to_source only");
    static_assert(!internal::is_given<NamedParameters, internal_np::max_slope_t> ||
                      internal::is_given<NamedParameters, internal_np::heights_t>,
                  "max_slope needs the named parameter heights");
    constexpr bool has_costs =
        internal::is_any_given<NamedParameters, internal_np::heights_t, internal_np::face_weight_t>;
    m_lines = internal::Grid_lines(m_storage.stride(), m_metric, has_costs);
    if constexpr(internal::is_given<NamedParameters, internal_np::epsilon_t>)
    {
      static_assert(!has_costs,
                    "epsilon: there is no bound on heights, or with costs that depend on the "
                    "direction; use Directional_graph on a mesh");
      if(m_metric.is_geographic())
        internal::reject(
            "there is an epsilon, and cells are in degrees; there is no bound for them");
      if(m_shape.is_periodic)
        internal::reject("there is an epsilon, and the grid is periodic; there is no bound then");
      m_border = internal::Grid_border(m_shape, internal::checked_epsilon(np));
    }
    check_number_of_nodes();
    m_friction = internal::read_friction(m_shape, friction);
    if constexpr(has_costs)
      m_costs = internal::read_line_costs(m_shape, m_storage, m_friction, np);
    m_slopes = internal::Line_slopes(m_lines, static_cast<std::ptrdiff_t>(m_storage.stride()),
                                     internal::slope_limit(np));
    m_friction = m_storage.kept(std::move(m_friction));
    summarize();
  }

  /// returns the graph whose costs are those of the opposite direction: where distances are from
  /// the sources, they are to the sources there, and vice versa. Both graphs have the same nodes.
  Grid_graph reversed() const
  {
    Grid_graph result = *this;
    result.m_costs = m_costs.reversed();
    return result;
  }

  /// \name Graph
  /// @{

  /// returns the number of nodes. Some numbers beyond those of the centers stand for no node; they
  /// have no arcs.
  std::size_t number_of_nodes() const
  {
    return m_shape.number_of_cells() + number_of_blocks() * m_border.size_of_block();
  }

  /// returns `1`.
  double unit() const { return 1; }

  /// returns a summary of the costs of arcs, an estimate.
  Arc_lengths arc_lengths() const { return m_arc_lengths; }

  /// returns an upper bound of the number of arcs of a node.
  std::size_t maximum_degree() const
  {
    return m_lines.lines().size() + 4 * (m_border.number_of_slots() + 1);
  }

  /// calls `f(target, cost)` for arcs from `node`, or `f(first, costs, number)` for arcs to
  /// consecutive nodes. Arcs from a border back into the cell that the path arrives through are
  /// left out, as the node before is joined to their targets itself; so are lines on heights that
  /// cannot be part of a cheapest path, as far as labels tell.
  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    if(node >= m_shape.number_of_cells())
      for_each_arc_from_border(place(node), labels.predecessor(node), f);
    else if(const Grid_cell cell = m_shape.cell(node); is_open(cell))
    {
      // on planes, all of them: a path straight through a center has other rounding errors
      if(m_costs.are_flat())
        for_each_line(cell, f);
      else
        for_each_worthwhile_line(cell, labels, f);
      if(m_border.size_of_block() > 0)
        for_each_arc_across(cell, m_border.number_of_slots(), friction(cell), f);
    }
  }

  /// returns whether there may be arcs that cost nothing.
  bool has_free_arcs() const { return m_smallest_cost == 0; }

  /// calls `f(target, length)` for the arcs from `node` that cost nothing, or `f(first, lengths,
  /// number)` for arcs to consecutive nodes.
  template <typename F>
  void for_each_free_arc(const Node node, bool /* starts */, F f) const
  {
    if(node >= m_shape.number_of_cells())
    {
      if(const Place place = this->place(node); is_passable(place))
        for_each_cell_at(place, [&](const Grid_cell& cell, const std::size_t slot) {
          if(friction(cell) == 0)
            for_each_arc_across(cell, slot, 1, f);
        });
    }
    else if(const Grid_cell cell = m_shape.cell(node); is_open(cell))
    {
      for_each_line_in_grid(cell, [&](const internal::Grid_lines::Line& line, const Node target) {
        const double scale = this->scale(cell, line);
        if(cost(cell, line, scale) == 0)
          f(target, m_costs.length(m_lines, line, m_storage.place(cell), scale));
      });
      if(m_border.size_of_block() > 0 && friction(cell) == 0)
        for_each_arc_across(cell, m_border.number_of_slots(), 1, f);
    }
  }

  /// @}

  /// \name Cells
  /// @{

  /// returns the shape of the grid.
  const Grid_shape& shape() const { return m_shape; }

  /// returns the node at the center of a cell.
  /// \throws std::invalid_argument if there is no such cell.
  Node node(const Grid_cell& cell) const
  {
    return static_cast<Node>(internal::checked_index(m_shape, cell, "the"));
  }

  /// returns the friction of a cell, infinity if it cannot be entered.
  /// \pre The cell exists.
  double friction(const Grid_cell& cell) const { return m_friction[m_storage.place(cell)]; }

  /// returns the height of a cell, `0` if there are no heights.
  /// \pre The cell exists, and can be entered.
  double height(const Grid_cell& cell) const
  {
    return m_costs.has_heights() ? m_costs.heights()[m_storage.place(cell)] : 0;
  }

  /// returns the smallest friction of all cells that can be entered, or `0` if there are none.
  double smallest_friction() const { return m_smallest_friction; }

  /// returns a lower bound of the cost of all paths between two nodes, for A* searches: that of a
  /// straight line where all costs are smallest. It is `0` for a function of cells and directions
  /// on heights or in degrees, as its costs are not known.
  double lower_bound(const Node from, const Node to) const
  {
    const Grid_point p = position(from), q = position(to);
    double x = std::abs(p.x - q.x);
    if(m_shape.is_periodic)
      x = (std::min)(x, m_shape.width() - x);
    return m_smallest_cost *
           std::hypot(x * m_metric.smallest().width / m_shape.cell_width,
                      (p.y - q.y) * m_metric.smallest().height / m_shape.cell_height);
  }

  /// returns where a node is, in the unit of the sizes of cells.
  Grid_point position(const Node node) const
  {
    if(node < m_shape.number_of_cells())
      return m_shape.center(m_shape.cell(node));
    const Place place = this->place(node);
    const Grid_point& p = m_border.position_in_block(place.in_block);
    return {static_cast<double>(place.cell.column) * m_shape.cell_width + p.x,
            static_cast<double>(place.cell.row) * m_shape.cell_height + p.y};
  }

  /// returns how many columns or rows away from its ends an arc reads cells, at most.
  static constexpr std::size_t largest_reach() { return internal::Grid_lines::LARGEST_REACH; }

  /// returns the largest relative error of distances where all cells have the same friction, and no
  /// heights. On a geographic grid, it is that in the metric of the latitude.
  double error_on_equal_cells() const { return m_lines.error_on_equal_cells(); }

  /// returns the largest relative error of costs by slope, due to interpolation between slopes of
  /// at most 4, as far as four slopes in each interval show; `0` if there is no such function.
  double error_of_slopes() const { return m_costs.error_of_slopes(); }

  /// returns whether costs may depend on the direction: whether there are heights or a cost
  /// function.
  bool has_directions() const { return !m_costs.are_flat(); }

  /// returns the number of bytes that the graph takes.
  std::size_t memory() const
  {
    return internal::memory_of(m_friction, m_metric, m_lines, m_border, m_costs, m_slopes);
  }

  /// @}

private:
  static constexpr Node null_node = (std::numeric_limits<Node>::max)();

  // A node at the border of cells: its block, and its place there.
  struct Place
  {
    Grid_cell cell; // or one beyond the last one of a row or a column
    std::size_t in_block;
  };

  static const Grid_shape& checked(const Grid_shape& shape)
  {
    constexpr std::size_t largest = (std::numeric_limits<Node>::max)();
    internal::check_has_cells(shape.columns, shape.rows);
    internal::checked_positive(shape.cell_width, "the width of a cell");
    internal::checked_positive(shape.cell_height, "the height of a cell");
    if(shape.columns > largest || shape.rows > largest / shape.columns)
      refuse_size();
    constexpr std::size_t least = internal::Cell_storage::LEAST_COLUMNS_OF_PERIODIC_GRID;
    if(shape.is_periodic && shape.columns < least)
      internal::reject("the grid is periodic and has " + std::to_string(shape.columns) +
                       " columns; there must be at least " + std::to_string(least));
    return shape;
  }

  [[noreturn]] static void refuse_size()
  {
    throw std::length_error("Approximate_geodesics: the grid has more than 2^32 - 1 nodes");
  }

  void check_number_of_nodes() const
  {
    constexpr std::size_t largest = (std::numeric_limits<Node>::max)();
    if(m_border.size_of_block() > 0 &&
       number_of_blocks() > (largest - m_shape.number_of_cells()) / m_border.size_of_block())
      refuse_size();
  }

  // Estimates costs of arcs from the lengths of all, and the friction of all cells; or from a
  // sample.
  void summarize()
  {
    internal::Arc_length_summary friction, lengths;
    for(const double f : m_friction)
      if(f < internal::infinity)
        friction.add(f);
    for(const internal::Grid_lines::Line& line : m_lines.lines())
      lengths.add(line.length);
    for(const double length : m_border.distances())
      if(length > 0)
        lengths.add(length);
    const Arc_lengths a = friction.result(), b = lengths.result();
    m_smallest_friction = a.shortest;
    m_is_uniform = a.shortest == a.longest && friction.number_of_arcs() == m_friction.size();
    m_arc_lengths = {a.shortest * b.shortest, a.mean * b.mean, a.longest * b.longest};
    constexpr double too_large = 1e150;
    if(!(b.longest < too_large && a.longest < too_large))
      internal::reject("the sizes of cells, or their friction, are too large");
    if(!m_costs.are_flat())
      summarize_costs();
    m_smallest_cost = m_smallest_friction * m_costs.smallest();
  }

  void summarize_costs()
  {
    constexpr std::size_t sample_size = 1000;
    internal::Arc_length_summary costs;
    const std::size_t number = m_shape.number_of_cells();
    for(std::size_t i = 0; i < number; i += 1 + number / sample_size)
      if(const Grid_cell cell = m_shape.cell(i); friction(cell) < internal::infinity)
        add_costs(cell, costs);
    m_arc_lengths = costs.result();
    // on heights, and where the metric varies, there are other directions than those of lines
    if(m_costs.depend_on_cells() && !m_costs.has_heights() && !m_metric.is_geographic())
      m_costs.set_smallest_of_cells(smallest_cost_of_cells());
  }

  // The blocks of all cells, and of those beyond the last ones of rows and columns.
  std::size_t number_of_blocks() const { return (m_shape.columns + 1) * (m_shape.rows + 1); }

  Place place(const Node node) const
  {
    const std::size_t i = node - m_shape.number_of_cells();
    const std::size_t block = i / m_border.size_of_block();
    const std::size_t stride = m_shape.columns + 1;
    return {{block % stride, block / stride}, i % m_border.size_of_block()};
  }

  // Whether there is such a cell, and it can be entered. Numbers below 0 have wrapped around.
  bool is_open(const Grid_cell& cell) const
  {
    return cell.column < m_shape.columns && cell.row < m_shape.rows &&
           friction(cell) < internal::infinity;
  }

  // Whether paths lead through a node: not if it is a corner where only two cells are open, which
  // have no common side.
  bool is_passable(const Place& place) const
  {
    if(!m_border.is_corner(place.in_block))
      return true;
    const auto [column, row] = place.cell;
    const bool a = is_open({column, row}), b = is_open({column - 1, row}),
               c = is_open({column, row - 1}), d = is_open({column - 1, row - 1});
    return !(a == d && b == c && a != b);
  }

  // Whether a node is at the border of a cell, or its center.
  bool has_node(const Grid_cell& cell, const Node node) const
  {
    if(node == null_node)
      return false;
    if(node < m_shape.number_of_cells())
      return node == m_shape.index(cell);
    const Place place = this->place(node);
    return m_border.has_node(place.cell.column - cell.column, place.cell.row - cell.row,
                             place.in_block);
  }

  // The path arrives across a cell that contains the predecessor, or along its side. If two cells
  // contain both nodes, it is the one of lower friction.
  template <typename F>
  void for_each_arc_from_border(const Place& place, const Node predecessor, F& f) const
  {
    if(!is_passable(place))
      return;
    double friction_before = internal::infinity;
    for_each_cell_at(place, [&](const Grid_cell& cell, std::size_t /* slot */) {
      if(has_node(cell, predecessor))
        friction_before = (std::min)(friction_before, friction(cell));
    });
    for_each_cell_at(place, [&](const Grid_cell& cell, const std::size_t slot) {
      if(friction(cell) > friction_before || !has_node(cell, predecessor))
        for_each_arc_across(cell, slot, friction(cell), f);
    });
  }

  // Calls `f(cell, slot)` for the cells that can be entered from a node at their border.
  template <typename F>
  void for_each_cell_at(const Place& place, F f) const
  {
    m_border.for_each_run_of(
        place.in_block, [&](const internal::Grid_border::Run& run, const std::size_t slot) {
          // beyond the grid if there is no cell
          const Grid_cell cell{place.cell.column - run.next_column, place.cell.row - run.next_row};
          if(is_open(cell))
            f(cell, slot);
        });
  }

  // Calls `f(line, target)` for the lines from a cell that end in the grid.
  template <typename F>
  void for_each_line_in_grid(const Grid_cell& cell, const F& f) const
  {
    for(const internal::Grid_lines::Line& line : m_lines.lines())
    {
      // numbers below 0 wrap around
      const std::size_t row = cell.row + static_cast<std::size_t>(line.rows);
      std::size_t column = cell.column + static_cast<std::size_t>(line.columns);
      if(m_shape.is_periodic && column >= m_shape.columns)
        column += line.columns < 0 ? m_shape.columns : 0 - m_shape.columns;
      if(column < m_shape.columns && row < m_shape.rows)
        f(line, static_cast<Node>(m_shape.index({column, row})));
    }
  }

  // Returns where the values of the last cell of a line are kept, or copies of them, from those of
  // its first one.
  std::size_t end_of_line(const std::size_t from, const internal::Grid_lines::Line& line) const
  {
    return from + static_cast<std::size_t>(line.rows) * m_storage.stride() +
           static_cast<std::size_t>(line.columns); // numbers below 0 wrap around
  }

  template <typename F>
  void for_each_line(const Grid_cell& cell, F& f) const
  {
    const double* const friction = m_friction.data() + m_storage.place(cell);
    for_each_line_in_grid(cell, [&](const internal::Grid_lines::Line& line, const Node target) {
      if(const double cost = scale(cell, line) * m_lines.cost(line, friction);
         cost < internal::infinity)
        f(target, cost);
    });
  }

  // Leaves out lines whose costs are so large, by the slope between their ends, that they cannot
  // lower the label of their target.
  template <typename Labels, typename F>
  void for_each_worthwhile_line(const Grid_cell& cell, const Labels& labels, F& f) const
  {
    constexpr double rounding = 1e-12; // of sums
    const std::size_t from = m_storage.place(cell);
    const double distance = labels.distance(static_cast<Node>(m_shape.index(cell)));
    for_each_line_in_grid(cell, [&](const internal::Grid_lines::Line& line, const Node target) {
      const std::size_t to = end_of_line(from, line);
      if(!(m_friction[to] < internal::infinity))
        return;
      const double scale = this->scale(cell, line);
      const double least = m_costs.lower_bound(from, to, scale * line.length);
      if(distance + (1 - rounding) * m_smallest_friction * least >= labels.distance(target))
        return;
      if(const double cost = this->cost(cell, line, scale); cost < internal::infinity)
        f(target, cost);
    });
  }

  // Returns the length of a line from a cell, relative to that of the table.
  double scale(const Grid_cell& cell, const internal::Grid_lines::Line& line) const
  {
    return m_metric.is_geographic() ? internal::Grid_lines::scale(line, sides(cell, line)) : 1;
  }

  // Returns the sides of cells for a line from a cell.
  const internal::Grid_metric::Sides& sides(const Grid_cell& cell,
                                            const internal::Grid_lines::Line& line) const
  {
    return m_metric.between(cell.row, cell.row + static_cast<std::size_t>(line.rows));
  }

  // Returns the cost of a line from a cell; infinity if it is too steep, or blocked.
  double
  cost(const Grid_cell& cell, const internal::Grid_lines::Line& line, const double scale) const
  {
    const std::size_t from = m_storage.place(cell);
    if(m_costs.are_flat())
      return scale * m_lines.cost(line, m_friction.data() + from);
    if(m_slopes.are_limited() &&
       !m_slopes.allow(static_cast<std::size_t>(&line - m_lines.lines().data()),
                       m_costs.heights().data() + from, scale))
      return internal::infinity;
    if(m_costs.depend_on_cells())
      return m_costs.cost_by_cells(m_lines, line, m_storage, from, sides(cell, line),
                                   m_friction.data());
    if(m_is_uniform)
      return m_costs.cost_if_uniform(m_lines, line, from, scale, m_smallest_friction);
    return m_costs.cost(m_lines, line, from, scale, m_friction.data());
  }

  // Adds the costs of the lines from a cell that are finite.
  void add_costs(const Grid_cell& cell, internal::Arc_length_summary& costs) const
  {
    for_each_line_in_grid(cell, [&](const internal::Grid_lines::Line& line, Node /* target */) {
      if(const double cost = this->cost(cell, line, scale(cell, line)); cost < internal::infinity)
        costs.add(cost);
    });
  }

  // Returns the smallest cost of a unit of length in all directions of lines, by the function of
  // cells; 0 if no cell can be entered in any.
  double smallest_cost_of_cells() const
  {
    double result = internal::infinity;
    for(std::size_t i = 0; i < m_shape.number_of_cells(); ++i)
    {
      internal::check_for_interruption_at(i);
      const Grid_cell cell = m_shape.cell(i);
      if(friction(cell) < internal::infinity)
        for(const internal::Grid_lines::Line& line : m_lines.lines())
          result = (std::min)(result, m_costs.cost_in_cell(cell, line, m_metric.between(0, 0)));
    }
    return result < internal::infinity ? result : 0;
  }

  // Calls `f` for the arcs from a slot of a cell, or its center, to all slots, and the center, by
  // this friction.
  template <typename F>
  void for_each_arc_across(const Grid_cell& cell,
                           const std::size_t slot,
                           const double friction,
                           F& f) const
  {
    const double* const distances = m_border.distances(slot);
    for(const internal::Grid_border::Run& run : m_border.runs())
    {
      const std::size_t block =
          (cell.row + run.next_row) * (m_shape.columns + 1) + cell.column + run.next_column;
      const std::size_t first =
          m_shape.number_of_cells() + block * m_border.size_of_block() + run.first_in_block;
      for_each_arc_to(static_cast<Node>(first), distances + run.first_slot, run.size, friction, f);
    }
    f(static_cast<Node>(m_shape.index(cell)), friction * distances[m_border.number_of_slots()]);
  }

  template <typename F>
  static void for_each_arc_to(const Node first,
                              const double* const distances,
                              const std::size_t number,
                              const double friction,
                              F& f)
  {
    constexpr std::size_t size_of_part = 32;
    std::array<double, size_of_part> costs;
    for(std::size_t i = 0; i < number; i += size_of_part)
    {
      const std::size_t size = (std::min)(size_of_part, number - i);
      for(std::size_t k = 0; k < size; ++k)
        costs[k] = friction * distances[i + k];
      f(static_cast<Node>(first + i), costs.data(), size);
    }
  }

  Grid_shape m_shape;
  internal::Grid_metric m_metric;
  internal::Cell_storage m_storage;
  internal::Grid_lines m_lines;
  internal::Grid_border m_border;
  internal::Line_costs m_costs;
  internal::Line_slopes m_slopes;
  std::vector<double> m_friction; // as kept; infinity for cells that cannot be entered
  Arc_lengths m_arc_lengths;
  double m_smallest_friction = 0;
  double m_smallest_cost = 0; // per unit of length
  bool m_is_uniform = false;  // whether all cells have the same friction
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_GRIDS_GRID_GRAPH_H
