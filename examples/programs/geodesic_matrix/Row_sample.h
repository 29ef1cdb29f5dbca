#ifndef GEODESIC_MATRIX_ROW_SAMPLE_H
#define GEODESIC_MATRIX_ROW_SAMPLE_H

#include "../command_line/Stopwatch.h"

#include <CGAL/Geodesic_queries/Distance_matrix_types.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <numeric>
#include <optional>
#include <vector>

// A sink that has some blocks of rows computed, from everywhere in the matrix, for about a second,
// in order to tell what all of them cost. It keeps nothing.
template <typename T>
class Row_sample
{
  using Plan = CGAL::Approximate_geodesics::Distance_matrix_plan;
  using Row = CGAL::Approximate_geodesics::Distance_row;

public:
  Row_sample(const bool is_sparse, const std::size_t number_of_nearest)
    : m_is_sparse(is_sparse), m_number_of_nearest(number_of_nearest)
  {
  }

  // The results

  std::size_t number_of_rows() const { return m_number_of_rows; }
  std::size_t number_of_columns() const { return m_number_of_columns; }
  std::size_t rows_per_block() const { return m_rows_per_block; }

  double seconds_per_row() const { return m_seconds / double(m_rows_done); }
  double entries_per_row() const { return double(m_number_of_entries) / double(m_rows_done); }

  // What a sink does

  using Block = std::vector<T>;

  std::size_t number_of_nearest() const { return m_number_of_nearest; }

  void start(const Plan& plan)
  {
    m_plan = &plan;
    m_number_of_rows = plan.number_of_rows();
    m_number_of_columns = plan.number_of_columns();
    m_rows_per_block = plan.rows_per_block();
    m_stride = std::max<std::size_t>(1, plan.number_of_blocks() * 5 / 8); // far from the last one
    while(std::gcd(m_stride, plan.number_of_blocks()) > 1)
      ++m_stride;
    m_stopwatch.restart();
  }

  std::optional<std::size_t> next_block()
  {
    const std::size_t number = m_next++, size = m_plan->number_of_blocks();
    if(number >= size || (number > 0 && m_stopwatch.seconds() > 1))
      return std::nullopt;
    return number * m_stride % size;
  }

  std::size_t number_of_rows_done() const
  {
    const std::lock_guard lock(m_mutex);
    return m_rows_done;
  }

  void collect(Block& block, std::size_t /* row */, const Row& distances) const
  {
    if(!m_is_sparse)
      std::transform(distances.begin(), distances.end(), std::back_inserter(block),
                     [](const double d) { return static_cast<T>(d); });
    else
      for(const auto column : distances.reached())
        block.push_back(static_cast<T>(distances[column]));
  }

  void add(const std::size_t number, Block& block)
  {
    const std::lock_guard lock(m_mutex);
    const std::size_t rows = m_plan->rows_of_block(number).size();
    const std::size_t most = m_number_of_nearest > 0 ? m_number_of_nearest * rows : block.size();
    m_rows_done += rows;
    m_number_of_entries += (std::min)(block.size(), most);
    m_seconds = m_stopwatch.seconds();
    block.clear();
  }

  bool finish(bool /* is_done */) { return true; }

private:
  bool m_is_sparse;
  std::size_t m_number_of_nearest;
  const Plan* m_plan = nullptr;
  std::size_t m_number_of_rows = 0;
  std::size_t m_number_of_columns = 0;
  std::size_t m_rows_per_block = 0;
  std::size_t m_stride = 1;
  std::atomic<std::size_t> m_next{0};
  Stopwatch m_stopwatch;

  mutable std::mutex m_mutex;
  double m_seconds = 0;
  std::size_t m_rows_done = 0;
  std::size_t m_number_of_entries = 0;
};

#endif // GEODESIC_MATRIX_ROW_SAMPLE_H
