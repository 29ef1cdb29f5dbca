// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_MATRIX_COMPUTATION_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_MATRIX_COMPUTATION_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The sources and targets of a distance matrix.
struct Matrix_points
{
  std::vector<Intrinsic_point> sources; // by row
  std::vector<Intrinsic_point> targets; // by column
  bool are_targets_given;               // otherwise all vertices
};

// Limits of the searches for the rows of a distance matrix.
struct Row_limits
{
  double maximum_distance = infinity;
  std::size_t number_of_nearest = 0;    // columns; 0: all
  std::vector<Intrinsic_point> targets; // if any, a search may stop after them

  // Whether a search may reach a small part of the columns only.
  bool are_given() const { return number_of_nearest > 0 || maximum_distance < infinity; }
};

/*
 * The target points of the columns of a distance matrix, and the extraction of their distances
 * after a search.
 */
template <typename Graph>
class Matrix_columns
{
  using Column = Distance_row::Column;
  using Index = Intrinsic_triangulation::Index;

public:
  // A column per point, in the given order. The graph is referred to, not copied.
  Matrix_columns(const Graph& graph, const std::vector<Intrinsic_point>& points)
  {
    m_vertices.reserve(points.size());
    for(const Intrinsic_point& p : points)
    {
      if(!p.is_vertex())
        m_columns_of_points.push_back(static_cast<Column>(m_vertices.size()));
      m_vertices.push_back(p.vertex);
    }
    sort_by_vertex(graph.triangulation().number_of_vertices());
    std::vector<Intrinsic_point> points_of_columns;
    for(const Column column : m_columns_of_points)
    {
      points_of_columns.push_back(points[column]);
      std::vector<Last_arc>& arcs = m_arcs.emplace_back();
      if constexpr(!Run_of<Graph>::attaches_by_labels)
        attach_target(graph, points[column])
            .for_each_node([&](const auto node, const double length) {
              arcs.push_back({node, length});
            });
    }
    m_points = Points_by_face(graph.triangulation(), std::move(points_of_columns));
  }

  std::size_t size() const { return m_vertices.size(); }
  bool are_vertices() const { return m_columns_of_points.empty(); }

  // Returns the number of columns whose target is a node.
  std::size_t number_at(const Index node) const
  {
    return is_vertex(node) ? m_first_at[node + 1] - m_first_at[node] : 0;
  }

  // Writes the distances of all columns.
  template <typename SurfaceSearch>
  void write_all(const SurfaceSearch& search, Distance_row& row) const
  {
    const auto& nodes = search.search();
    if(are_vertices())
      row.set_all([&](const Column c) { return nodes.distance(m_vertices[c]); });
    else
    {
      row.set_all([&](const Column c) {
        return m_vertices[c] == null_index ? infinity : nodes.distance(m_vertices[c]);
      });
      write_points(search, row);
    }
  }

  // Writes the distances of reached columns only. Columns of vertices take time proportional to the
  // number of reached nodes.
  template <typename SurfaceSearch>
  void write_reached(const SurfaceSearch& search, Distance_row& row) const
  {
    for(const Index node : search.search().reached_nodes())
      for(std::size_t i = 0; i < number_at(node); ++i)
        set(m_columns[m_first_at[node] + i], search.search().distance(node), row);
    write_points(search, row);
  }

private:
  bool is_vertex(const Index node) const { return node + std::size_t(1) < m_first_at.size(); }

  static void set(const Column column, const double distance, Distance_row& row)
  {
    if(distance < infinity)
      row.set(column, distance);
  }

  template <typename SurfaceSearch>
  void write_points(const SurfaceSearch& search, Distance_row& row) const
  {
    if(are_vertices())
      return;
    if constexpr(Run_of<Graph>::attaches_by_labels)
      for(std::size_t i = 0; i < m_columns_of_points.size(); ++i)
        set(m_columns_of_points[i], search.distance(m_points[i]), row);
    else
    {
      const double unit = search.graph().unit();
      const Source_point& source = search.sources().front();
      std::vector<double> distances(m_columns_of_points.size(), infinity);
      for(std::size_t i = 0; i < distances.size(); ++i)
        for(const auto& [node, length] : m_arcs[i])
          distances[i] = (std::min)(distances[i], search.search().distance(node) + length * unit);
      if(!source.point.is_vertex()) // straight segments to the points
        search.graph()
            .attach(source.point)
            .for_each_point(m_points, [&](const std::size_t i, const double length) {
              distances[i] = (std::min)(distances[i], source.distance + length * unit);
            });
      for(std::size_t i = 0; i < distances.size(); ++i)
        set(m_columns_of_points[i], search.is_known(distances[i]) ? distances[i] : infinity, row);
    }
  }

  // Groups columns by vertex: several columns may have the same target.
  void sort_by_vertex(const std::size_t number_of_vertices)
  {
    m_first_at.assign(number_of_vertices + 1, 0);
    for(const Index v : m_vertices)
      if(v != null_index)
        ++m_first_at[v + 1];
    std::partial_sum(m_first_at.begin(), m_first_at.end(), m_first_at.begin());
    m_columns.resize(m_first_at.back());
    std::vector<Column> next(m_first_at.begin(), m_first_at.end() - 1);
    for(std::size_t c = 0; c < size(); ++c)
      if(m_vertices[c] != null_index)
        m_columns[next[m_vertices[c]]++] = static_cast<Column>(c);
  }

  std::vector<Index> m_vertices;  // by column; null_index if not a vertex
  std::vector<Column> m_first_at; // by vertex, into m_columns
  std::vector<Column> m_columns;  // grouped by vertex

  // Columns whose targets are not vertices. Points are attached to the graph once for all rows,
  // unless attachment depends on the search.
  std::vector<Column> m_columns_of_points;
  Points_by_face m_points;
  std::vector<std::vector<Last_arc>> m_arcs; // by point, in units of the graph
};

// What the rows of a distance matrix are computed from. Nothing is copied.
template <typename Graph>
struct Matrix_input
{
  const Graph& graph;
  const Matrix_points& points;
  const Matrix_columns<Graph>& columns;
  const Row_limits& limits;
};

// Stops a search when the wanted number of columns is settled, including all ties of the last one.
template <typename Columns>
class Nearest_columns_visitor : public Geodesic_visitor_base
{
public:
  Nearest_columns_visitor(const Columns& columns, const std::size_t wanted)
    : m_columns(columns), m_wanted(wanted)
  {
  }

  template <typename Node>
  void on_settled(const Node node, const double distance)
  {
    m_is_done = m_is_done || (m_number >= m_wanted && distance > m_farthest);
    const std::size_t number = m_columns.number_at(node);
    if(m_number < m_wanted && number > 0)
      m_farthest = distance;
    m_number += number;
  }

  bool go_further() const { return !m_is_done; }

  // Whether the wanted number of columns was settled.
  bool is_enough() const { return m_number >= m_wanted; }
  double farthest() const { return m_farthest; }

private:
  const Columns& m_columns;
  std::size_t m_wanted;
  std::size_t m_number = 0;
  double m_farthest = 0;
  bool m_is_done = false;
};

/*
 * Computes rows of a distance matrix, one by one: the workspace of a thread.
 */
template <typename Graph>
class Row_search
{
public:
  using Input = Matrix_input<Graph>;

  explicit Row_search(const Input& input);

  // Returns the distances from a source. The reference is valid until the next call.
  const Distance_row& find(std::size_t row);

private:
  bool search_nearest(const Intrinsic_point& source, double distance);

  const Input m_input;
  Surface_search<Graph> m_search;
  Distance_row m_row;
  double m_expected_distance = infinity; // of the nearest columns
};

// Not in the class, as those of `Surface_search`.

template <typename Graph>
Row_search<Graph>::Row_search(const Input& input)
  : m_input(input), m_search(input.graph), m_row(input.columns.size())
{
}

template <typename Graph>
const Distance_row& Row_search<Graph>::find(const std::size_t row)
{
  const auto& [graph, points, columns, limits] = m_input;
  m_row.clear();
  if(limits.number_of_nearest > 0 && columns.are_vertices())
  {
    // A search for few columns labels many nodes beyond them. Limiting the distance avoids this;
    // the estimate is that of the previous row, whose source is near. But where arcs depend on
    // labels, as with a `Run` of the graph, the range of a search affects the last bits.
    if(has_own_run<Graph> || !search_nearest(points.sources[row], m_expected_distance))
      search_nearest(points.sources[row], limits.maximum_distance);
  }
  else
  {
    Geodesic_visitor_base visitor; // as in the compiled searches
    m_search.run({{points.sources[row]}}, {limits.maximum_distance, limits.targets}, visitor);
  }
  if(limits.are_given())
    columns.write_reached(m_search, m_row);
  else
    columns.write_all(m_search, m_row);
  return m_row;
}

// Returns whether there are enough columns within `distance`.
template <typename Graph>
bool Row_search<Graph>::search_nearest(const Intrinsic_point& source, const double distance)
{
  constexpr double margin = 1.25;
  const Row_limits& limits = m_input.limits;
  Nearest_columns_visitor nearest(m_input.columns, limits.number_of_nearest);
  m_search.run({{source}}, {(std::min)(distance, limits.maximum_distance), limits.targets},
               nearest);
  m_expected_distance = nearest.is_enough() ? margin * nearest.farthest() : limits.maximum_distance;
  return nearest.is_enough() || distance >= limits.maximum_distance;
}

// Detection of the optional members of models of `DistanceRowSink`.

// Rows are received by a sink, in blocks, or by a function object, one by one.
template <typename Rows>
constexpr bool is_row_sink = is_valid<Rows&>([](auto& rows) ->
                                             typename std::decay_t<decltype(rows)>::Block* {});

// Whether a sink chooses blocks, and tells the number of rows done.
template <typename Rows>
constexpr bool chooses_blocks = is_valid<Rows&>([](auto& rows) -> decltype(rows.next_block()) {});

template <typename Rows>
constexpr bool can_be_symmetric = is_valid<Rows&, std::true_type>(
    [](auto& rows) -> std::bool_constant<std::decay_t<decltype(rows)>::can_be_symmetric> {});

template <typename Rows>
constexpr bool check_rows()
{
  using T = std::remove_reference_t<Rows>;
  constexpr bool takes_rows =
      is_row_sink<T> || std::is_invocable_v<T&, std::size_t, const Distance_row&>;
  constexpr bool can_change = !is_row_sink<T> || !std::is_const_v<T>;
  static_assert(takes_rows,
                "rows must be a row sink, such as Dense_rows, or callable with the number of a row "
                "and a `const Distance_row&`");
  static_assert(can_change, "a row sink must not be const");
  return takes_rows && can_change;
}

// Returns the number of nearest columns that a sink keeps per row; 0 means all.
template <typename Rows>
std::size_t number_of_nearest([[maybe_unused]] const Rows& rows)
{
  if constexpr(is_valid<const Rows&>([](auto& r) -> decltype(r.number_of_nearest()) {}))
    return rows.number_of_nearest();
  else
    return 0;
}

/*
 * Reports the progress to a visitor, and asks it whether to continue. The class is thread-safe: it
 * serializes calls to the visitor.
 */
template <typename Visitor>
class Matrix_progress
{
  using Clock = std::chrono::steady_clock;

public:
  Matrix_progress(Visitor& visitor,
                  const std::size_t number_of_rows,
                  const std::size_t number_done_before)
    : m_visitor(visitor), m_number_of_rows(number_of_rows), m_done_before(number_done_before)
  {
  }

  bool go_further()
  {
    check_for_interruption();
    const std::lock_guard lock(m_mutex);
    return m_visitor.go_further();
  }

  void report(const std::size_t number_done)
  {
    const std::lock_guard lock(m_mutex);
    if(number_done < m_done)
      return; // overtaken by another thread
    m_done = number_done;
    const double seconds = std::chrono::duration<double>(Clock::now() - m_start).count();
    const double rate = double(number_done - m_done_before) / seconds;
    m_visitor.on_progress({m_number_of_rows, number_done, rate,
                           rate > 0 ? double(m_number_of_rows - number_done) / rate : infinity});
  }

private:
  Visitor& m_visitor;
  std::mutex m_mutex;
  std::size_t m_number_of_rows;
  std::size_t m_done_before;
  std::size_t m_done = 0;
  Clock::time_point m_start = Clock::now();
};

/*
 * Computes the rows of a distance matrix with one or several threads, each of which has a `Search`.
 * Sinks receive blocks of rows as they are completed; function objects receive single rows in
 * order.
 */
template <typename Search, typename Rows, typename Visitor>
class Matrix_computation
{
public:
  // All are referred to, not copied.
  Matrix_computation(const typename Search::Input& input,
                     const Distance_matrix_plan& plan,
                     Rows& rows,
                     Visitor& visitor)
    : m_input(input),
      m_plan(plan),
      m_rows(rows),
      m_progress(visitor, plan.number_of_rows(), number_done())
  {
  }

  // Returns false if the visitor stopped the computation.
  bool run(const Loop& loop)
  {
    loop.run(m_plan.number_of_blocks(),
             [this](std::size_t /* block */, std::size_t /* thread */) { work(); });
    return !m_is_stopped;
  }

private:
  // The first iteration of a thread computes rows until none are left; further iterations find
  // none.
  void work()
  {
    if(m_is_finished || m_is_stopped)
      return;
    try
    {
      Search search(m_input);
      if constexpr(is_row_sink<Rows>)
        compute_blocks(search);
      else
        compute_rows(search);
      m_is_finished = true;
    }
    catch(...)
    {
      stop();
      throw;
    }
  }

  void compute_blocks(Search& search)
  {
    typename Rows::Block block;
    while(const std::optional<std::size_t> number = next_block())
    {
      const auto rows = m_plan.rows_of_block(*number);
      for(const std::size_t row : rows)
      {
        if(!goes_further())
          return;
        m_rows.collect(block, row, search.find(row));
      }
      m_rows.add(*number, block);
      m_done += rows.size();
      m_progress.report(number_done());
    }
  }

  std::optional<std::size_t> next_block()
  {
    if constexpr(chooses_blocks<Rows>)
      return m_rows.next_block();
    else
    {
      const std::size_t number = m_next++;
      return number < m_plan.number_of_blocks() ? std::optional(number) : std::nullopt;
    }
  }

  std::size_t number_done() const
  {
    if constexpr(chooses_blocks<Rows>)
      return m_rows.number_of_rows_done();
    else
      return m_done;
  }

  void compute_rows(Search& search)
  {
    for(std::size_t row = m_next++; row < m_plan.number_of_rows(); row = m_next++)
      if(!goes_further() || !hand_over(row, search.find(row)))
        return;
  }

  // Rows are assigned in order, so the thread with the next row never waits: there is no deadlock.
  bool hand_over(const std::size_t row, const Distance_row& distances)
  {
    {
      std::unique_lock lock(m_mutex);
      m_turn.wait(lock, [&] { return m_done == row || m_is_stopped; });
    }
    if(m_is_stopped)
      return false;
    m_rows(row, distances);
    m_progress.report(row + 1);
    {
      const std::lock_guard lock(m_mutex);
      ++m_done;
    }
    m_turn.notify_all();
    return true;
  }

  bool goes_further()
  {
    if(!m_is_stopped && !m_progress.go_further())
      stop();
    return !m_is_stopped;
  }

  void stop()
  {
    {
      const std::lock_guard lock(m_mutex); // otherwise a thread about to wait could miss it
      m_is_stopped = true;
    }
    m_turn.notify_all();
  }

  const typename Search::Input& m_input;
  const Distance_matrix_plan& m_plan;
  Rows& m_rows;

  std::atomic<std::size_t> m_next{0}; // a row or a block
  std::atomic<std::size_t> m_done{0}; // completed rows
  Matrix_progress<Visitor> m_progress;
  std::atomic<bool> m_is_finished{false};
  std::atomic<bool> m_is_stopped{false};
  std::mutex m_mutex;
  std::condition_variable m_turn;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_MATRIX_COMPUTATION_H
