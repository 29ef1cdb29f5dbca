// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_TILED_GRID_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_TILED_GRID_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Grid_files/Grid_window.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Grid_nodes.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Label_files.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Tile_graph.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Tile_progress.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/first_predecessors.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_costs/internal/continued_runs.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*
 * The algorithm
 *
 * Tiles partition the nodes of a grid. A label is open if arcs from its node still have to be
 * followed. The tile with the smallest open label is settled: `Propagation` continues from its open
 * labels on the graph of a window, which is the tile and a margin that all its arcs end in. It
 * follows arcs from nodes of the tile only, so labels fall in the tile and in the margin; those in
 * the margin are open labels of other tiles then. The search ends when no tile has an open label.
 *
 * This is Dijkstra's algorithm with another order of expansion, and the labels do not depend on it.
 *
 * Labels are kept in mapped files, and are lengths of paths at any time. A tile is settled in two
 * passes: the first one lowers labels and opens them, the second one closes those of the tile. A
 * process that is killed between any two writes leaves labels open that need not be, and none
 * closed that must not be.
 */

/*!
 * \ingroup PkgGeodesicLibrariesGridFiles
 *
 * A search on a grid that need not fit in memory. Distances have the same bits as those of
 * `Propagation` on one graph of the whole grid.
 *
 * The graph is built for windows, one at a time: tiles with a margin. Distances and predecessors
 * are in files of a folder, 12 bytes per node. A process can be killed at any time; another one
 * with the same task, and tiles of any size, resumes the search. It also does so after a crash of
 * the operating system, but then follows all arcs again that were followed before.
 *
 * Memory is that of `Propagation` and a graph on one window, plus 12 bytes per node of a window for
 * the parts of files that are mapped.
 *
 * \tparam GraphOfWindow a function object that returns, for a `Grid_window`, a graph of its cells
 *         with the numbers of nodes and the member functions of `Grid_graph`. It is called with
 *         windows of any size from one cell on. Arcs between nodes must not depend on the window;
 *         those of `Grid_graph` do not, with heights and costs either, if `Grid_shape::rows_before`
 *         and `rows_after` are set on geographic grids, and cost functions are those of the cells
 *         of the whole grid.
 */
template <typename GraphOfWindow>
class Tiled_grid_search
{
public:
  /// the graph of a window.
  using Graph = std::decay_t<std::invoke_result_t<const GraphOfWindow&, const Grid_window&>>;

  /*!
   * prepares a search, or resumes one.
   *
   * \param columns,rows the size of the grid
   * \param graph_of_window builds graphs; it is referred to, not copied
   * \param sources the cells where paths start; one that cannot be entered has the distance `0`,
   *        and no other cell is reached from it
   * \param tile_side the number of columns and rows of a tile, except for the last ones
   * \param folder where to keep labels; it is created if needed. An empty name stands for memory
   * \param costs a text that identifies the costs: a search with another one is not resumed
   * \param is_periodic whether columns go round, as those of `Grid_shape::is_periodic`. Then a
   *        window that is not as wide as the grid can extend beyond the last column, to the first
   *        ones; the graph of one as wide as the grid is periodic.
   *
   * \throws std::invalid_argument if a source does not exist, `tile_side` is `0`, another search
   *         has been begun in the folder, or another process uses it.
   * \throws std::runtime_error if files cannot be written, for instance because the disk is full.
   */
  Tiled_grid_search(const std::size_t columns,
                    const std::size_t rows,
                    const GraphOfWindow& graph_of_window,
                    const std::vector<Grid_cell>& sources,
                    const std::size_t tile_side,
                    const std::string& folder = "",
                    const std::string& costs = "",
                    const bool is_periodic = false)
    : m_columns(columns),
      m_rows(rows),
      m_is_periodic(is_periodic),
      m_side(checked_side(columns, rows, tile_side)),
      m_graph_of_window(graph_of_window)
  {
    measure_places();
    m_tile_columns = (columns + m_side - 1) / m_side;
    m_smallest_open.resize(m_tile_columns * ((rows + m_side - 1) / m_side), internal::infinity);
    m_has_labels.resize(number_of_tiles());
    m_labels.emplace(m_nodes, folder, task(sources, costs));
    if(!m_labels->is_intact())
      reopen_labels();
    if(m_labels->is_new() || !m_labels->is_intact())
      for(const Grid_cell& source : sources)
        m_labels->open_source({source.column, source.row, 0});
    m_labels->begin();
    find_open_labels();
  }

  /// the functor of a temporary would not live long enough.
  Tiled_grid_search(std::size_t columns,
                    std::size_t rows,
                    const GraphOfWindow&& graph_of_window,
                    const std::vector<Grid_cell>& sources,
                    std::size_t tile_side,
                    const std::string& folder = "",
                    const std::string& costs = "",
                    bool is_periodic = false) = delete;

  /*!
   * settles tiles until all distances are final, or the visitor stops that.
   *
   * \param visitor a model of `GeodesicVisitor`; it is told of progress, in thousandths of tiles,
   *        and asked whether to go further before each tile
   *
   * \return whether all distances are final.
   */
  template <typename Visitor = Geodesic_visitor_base>
  bool run(Visitor&& visitor = Visitor())
  {
    while(const std::optional<std::size_t> tile = next_tile())
    {
      if(!visitor.go_further())
        return false;
      settle(*tile, visitor);
      ++m_number_of_visits;
    }
    return true;
  }

  /*!
   * makes predecessors independent of tiles, and of what was resumed, as distances are: of several
   * paths with the same cost, takes the one whose last node comes first, in the order of rows,
   * columns and slots. It follows all arcs once, so it takes about as long as `run()`. Where arcs
   * cost nothing, predecessors stay as they were found: unlike those of `Propagation`, paths are
   * not the shortest of those that cost the same.
   *
   * \param visitor as for `run()`
   *
   * \return whether all tiles have been processed.
   *
   * \pre `run()` has returned `true`.
   */
  template <typename Visitor = Geodesic_visitor_base>
  bool order_ties(Visitor&& visitor = Visitor())
  {
    for(std::size_t index = 0; index < number_of_tiles(); ++index)
    {
      if(!visitor.go_further())
        return false;
      order_ties_in(index, visitor);
    }
    return true;
  }

  /// calls `f(column, distance)` for all cells of a row: infinity for those that cannot be reached.
  template <typename F>
  void for_each_distance(const std::size_t row, F f) const
  {
    const internal::Label_files::Rows rows = m_labels->rows(row, 1);
    for(std::size_t column = 0; column < m_columns; ++column)
      f(column, rows.label({column, row, 0}).distance());
  }

  /// calls `f(column, predecessor)` for those cells of a row that have been reached from a node:
  /// the place of the node.
  template <typename F>
  void for_each_predecessor(const std::size_t row, F f) const
  {
    const internal::Label_files::Rows rows = m_labels->rows(row, 1);
    for(std::size_t column = 0; column < m_columns; ++column)
      if(const Grid_place p{column, row, 0}; rows.predecessor(p).exists())
        f(column, m_nodes.in_grid(rows.predecessor(p).place(p)));
  }

  /// returns the distance of a cell, infinity if it cannot be reached.
  double distance(const Grid_cell& cell) const
  {
    return m_labels->rows(cell.row, 1).label({cell.column, cell.row, 0}).distance();
  }

  /// returns the places of the nodes on the path to a cell, from the source on; none if the cell
  /// cannot be reached.
  std::vector<Grid_place> path(const Grid_cell& cell) const
  {
    std::vector<Grid_place> result;
    if(distance(cell) == internal::infinity)
      return result;
    result.push_back({cell.column, cell.row, 0});
    while(true)
    {
      const Grid_place& p = result.back();
      const internal::Kept_predecessor predecessor = m_labels->rows(p.row, 1).predecessor(p);
      if(!predecessor.exists())
        break;
      result.push_back(m_nodes.in_grid(predecessor.place(p)));
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

  /// returns where a node is, in columns and rows from the corner of the first cell.
  Grid_point position(const Grid_place& place) const
  {
    const Grid_point& p = m_positions[place.slot];
    return {static_cast<double>(place.column) + p.x, static_cast<double>(place.row) + p.y};
  }

  /// returns the number of tiles.
  std::size_t number_of_tiles() const { return m_smallest_open.size(); }

  /// returns how often tiles were settled.
  std::size_t number_of_visits() const { return m_number_of_visits; }

  /// removes the files. No other member function may be called afterwards.
  void remove_files() { m_labels->remove(); }

private:
  using Node = typename Graph::Node;
  using Rows = internal::Label_files::Rows;

  static std::size_t
  checked_side(const std::size_t columns, const std::size_t rows, const std::size_t side)
  {
    internal::check_has_cells(columns, rows);
    if(side == 0)
      internal::reject("tiles have no columns and rows");
    return (std::min)(side, (std::max)(columns, rows));
  }

  // Finds how many nodes there are at a column and a row, and where, from the graph of one cell.
  void measure_places()
  {
    static_assert(Graph::largest_reach() <= internal::Kept_predecessor::LARGEST_REACH);
    const Graph graph = m_graph_of_window(Grid_window{0, 0, 1, 1});
    constexpr std::size_t number_of_blocks = 4;
    const std::size_t size_of_block = (graph.number_of_nodes() - 1) / number_of_blocks;
    CGAL_assertion(size_of_block < internal::Kept_predecessor::LARGEST_SLOT);
    m_nodes = internal::Grid_nodes(m_columns, m_rows, size_of_block, m_is_periodic);
    for(std::size_t i = 0; i < m_nodes.number_of_slots(); ++i)
    {
      const Grid_point p = graph.position(static_cast<Node>(i));
      m_positions.push_back({p.x / graph.shape().cell_width, p.y / graph.shape().cell_height});
    }
  }

  std::string task(const std::vector<Grid_cell>& sources, const std::string& costs) const
  {
    std::string result = std::to_string(m_columns) + " columns, " + std::to_string(m_rows) +
                         " rows, " + std::to_string(m_nodes.number_of_slots()) + " nodes at each" +
                         (m_is_periodic ? ", periodic" : "") + "\ncosts: " + costs + "\nsources:";
    const Grid_shape shape{m_columns, m_rows, 1, 1, {}};
    for(const Grid_cell& source : sources)
      result += ' ' + std::to_string(internal::checked_index(shape, source, "the source"));
    return result + '\n';
  }

  std::size_t tile_of(const std::size_t column, const std::size_t row) const
  {
    return (std::min)(row, m_rows - 1) / m_side * m_tile_columns +
           (std::min)(column, m_columns - 1) / m_side;
  }

  std::optional<std::size_t> next_tile() const
  {
    const auto tile = std::min_element(m_smallest_open.begin(), m_smallest_open.end());
    if(*tile == internal::infinity)
      return {};
    return static_cast<std::size_t>(tile - m_smallest_open.begin());
  }

  // The number of tiles that have labels, but no open node.
  std::size_t number_of_closed_tiles() const
  {
    std::size_t result = 0;
    for(std::size_t i = 0; i < number_of_tiles(); ++i)
      result += m_has_labels[i] && m_smallest_open[i] == internal::infinity ? 1 : 0;
    return result;
  }

  void note_label(const Grid_place& place, const double distance, const bool is_open)
  {
    const std::size_t tile = tile_of(place.column, place.row);
    m_has_labels[tile] = true;
    if(is_open)
      m_smallest_open[tile] = (std::min)(m_smallest_open[tile], distance);
  }

  // After a crash of the operating system, files may have new labels that are closed beside old
  // ones, and labels without their predecessors. So all are found again.
  void reopen_labels()
  {
    for_each_label(
        [](const Grid_place& /* place */, internal::Kept_label& label) { label.open_above(); });
  }

  void find_open_labels()
  {
    for_each_label([&](const Grid_place& p, const internal::Kept_label& label) {
      note_label(p, label.distance(), label.is_open());
    });
  }

  // Calls `f(place, label)` for all nodes that have been reached.
  template <typename F>
  void for_each_label(const F& f)
  {
    for(std::size_t row = 0; row < m_nodes.rows(); ++row)
    {
      const Rows rows = m_labels->rows(row, 1);
      rows.for_each_place(0, m_nodes.columns(), [&](const Grid_place& p) {
        if(internal::Kept_label& label = rows.label(p); label.distance() != internal::infinity)
          f(p, label);
      });
    }
  }

  // A tile, and the window that arcs from it end in.
  struct Tile
  {
    Grid_window own, window;
  };

  Tile tile(const std::size_t index) const
  {
    const std::size_t column = index % m_tile_columns * m_side,
                      row = index / m_tile_columns * m_side;
    const std::size_t margin = Graph::largest_reach() + 1; // a graph may look at neighbors of cells
    const auto clipped = [&](const std::size_t extra) {
      const std::size_t c = column - (std::min)(column, extra), r = row - (std::min)(row, extra);
      return Grid_window{c, r, (std::min)(column + m_side + extra, m_columns) - c,
                         (std::min)(row + m_side + extra, m_rows) - r};
    };
    Tile result{clipped(0), clipped(margin)};
    if(m_is_periodic) // no column twice
    {
      const bool has_all = result.own.columns + 2 * margin >= m_columns;
      result.window.first_column = has_all ? 0 : (column + m_columns - margin) % m_columns;
      result.window.columns = has_all ? m_columns : result.own.columns + 2 * margin;
    }
    return result;
  }

  template <typename Visitor>
  void settle(const std::size_t index, Visitor& visitor)
  {
    const Tile tile = this->tile(index);
    const Graph graph = m_graph_of_window(tile.window);
    const internal::Tile_graph<Graph> tile_graph(graph, own_places(tile), tile.window, m_nodes);
    const Rows rows = m_labels->rows(tile.window.first_row, tile_graph.nodes().rows());
    internal::Tile_progress progress(visitor, number_of_closed_tiles(), number_of_tiles());
    Propagation search(tile_graph);
    search.resume([&](const auto& set) { enter_labels(tile_graph, rows, set); });
    lower_labels(tile_graph, rows, search);
    std::atomic_signal_fence(std::memory_order_seq_cst); // a process is killed before or after
    close_labels(tile_graph, rows);
    m_smallest_open[index] = internal::infinity;
  }

  // The last tiles have the nodes beyond the last column and the last row.
  Grid_window own_places(const Tile& tile) const
  {
    Grid_window result = tile.own;
    if(result.first_column + result.columns == m_columns)
      result.columns = m_nodes.columns() - result.first_column;
    if(result.first_row + result.rows == m_rows)
      result.rows = m_nodes.rows() - result.first_row;
    return result;
  }

  template <typename Set>
  void enter_labels(const internal::Tile_graph<Graph>& tile, const Rows& rows, const Set& set) const
  {
    tile.for_each_node([&](const Node node, const Grid_place& p) {
      const internal::Kept_label label = rows.label(p);
      if(label.distance() == internal::infinity)
        return;
      const internal::Kept_predecessor predecessor = rows.predecessor(p);
      set(node, label.distance(),
          predecessor.exists() ? tile.node(m_nodes.in_grid(predecessor.place(p))) : tile.null_node,
          label.is_open() && tile.owns(p));
    });
  }

  // If the process is killed after the predecessor was written, the label is still to fall.
  template <typename Search>
  void lower_labels(const internal::Tile_graph<Graph>& tile, const Rows& rows, const Search& search)
  {
    tile.for_each_node([&](const Node node, const Grid_place& p) {
      const double distance = search.distance(node);
      internal::Kept_label& label = rows.label(p);
      if(!(distance < label.distance()))
        return;
      rows.predecessor(p).set(m_nodes.beside(tile.place(search.predecessor(node)), p), p);
      std::atomic_signal_fence(std::memory_order_seq_cst);
      label.set_open(distance);
      note_label(p, distance, true);
    });
  }

  void close_labels(const internal::Tile_graph<Graph>& tile, const Rows& rows) const
  {
    tile.for_each_own_place([&](const Grid_place& p) { rows.label(p).close(); });
  }

  template <typename Visitor>
  void order_ties_in(const std::size_t index, Visitor& visitor) const
  {
    const Tile tile = this->tile(index);
    const Graph graph = m_graph_of_window(tile.window);
    internal::Tile_progress progress(visitor, index, number_of_tiles());
    const internal::Tile_graph<Graph> tile_graph(graph, own_places(tile), tile.window, m_nodes);
    const Rows rows = m_labels->rows(tile.window.first_row, tile_graph.nodes().rows());
    std::vector<double> labels(graph.number_of_nodes(), internal::infinity);
    tile_graph.for_each_node(
        [&](const Node node, const Grid_place& p) { labels[node] = rows.label(p).distance(); });
    const std::vector<Node> first = internal::first_predecessors(tile_graph, labels);
    tile_graph.for_each_node([&](const Node node, const Grid_place& p) {
      if(tile_graph.owns(p) && first[node] != tile_graph.null_node)
        rows.predecessor(p).set(m_nodes.beside(tile_graph.place(first[node]), p), p);
    });
  }

  std::size_t m_columns, m_rows;
  bool m_is_periodic;
  std::size_t m_side;
  const GraphOfWindow& m_graph_of_window;
  internal::Grid_nodes m_nodes;
  std::vector<Grid_point> m_positions; // of nodes, by slots
  std::size_t m_tile_columns = 0;
  std::vector<double> m_smallest_open; // by tiles
  std::vector<bool> m_has_labels;      // by tiles
  std::optional<internal::Label_files> m_labels;
  std::size_t m_number_of_visits = 0;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_TILED_GRID_SEARCH_H
