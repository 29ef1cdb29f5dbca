// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"

#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <type_traits>
#include <vector>

// What rows and plans are, and what sinks, function objects and visitors are told.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using AG::Distance_matrix_plan;
using AG::Distance_matrix_progress;
using Columns = std::vector<Distance_row::Column>;
using Values = std::vector<double>;

// ----- rows

Values values_of(const Distance_row& row) { return {row.begin(), row.end()}; }

TEST(Distance_row, is_empty_at_first)
{
  EXPECT_EQ(Distance_row().size(), 0u);
  EXPECT_TRUE(Distance_row().reached().empty());
  EXPECT_EQ(values_of(Distance_row(3)), Values(3, infinity));
  EXPECT_TRUE(Distance_row(3).reached().empty());
}

// Few columns are sorted, and of many, all are looked at.
TEST(Distance_row, lists_what_was_set_in_ascending_order)
{
  Random random(test_seed());
  for(const std::size_t size : {1u, 40u, 2000u})
    for(const std::size_t number : {0u, 1u, 5u, 62u, 63u, 1000u})
    {
      Distance_row row(size);
      std::set<Distance_row::Column> expected;
      for(std::size_t i = 0; i < number; ++i)
      {
        const auto column = static_cast<Distance_row::Column>(random.below(size));
        row.set(column, double(i));
        expected.insert(column);
        EXPECT_EQ(row[column], double(i));
        if(i % 3 == 0) // in between, too
        {
          EXPECT_EQ(row.reached(), Columns(expected.begin(), expected.end()));
        }
      }
      EXPECT_EQ(row.reached(), Columns(expected.begin(), expected.end()));
    }
}

TEST(Distance_row, lists_what_was_set_for_all_columns)
{
  Distance_row row(100);
  const auto even = [](const Distance_row::Column c) { return c % 2 == 0 ? c / 2. : infinity; };
  row.set_all(even);
  EXPECT_EQ(row[14], 7);
  EXPECT_EQ(row[15], infinity);
  EXPECT_EQ(row.reached().size(), 50u);
  EXPECT_EQ(row.reached().back(), 98u);
  row.set_all(even);
  row.set(15, 3); // one that was not reached, and one that was
  row.set(14, 4);
  Columns expected;
  for(Distance_row::Column c = 0; c < 100; ++c)
    if(c % 2 == 0 || c == 15)
      expected.push_back(c);
  EXPECT_EQ(row.reached(), expected);
}

TEST(Distance_row, forgets_everything)
{
  const auto one = [](Distance_row::Column) { return 1.; };
  const auto none = [](Distance_row::Column) { return infinity; };
  const std::vector<std::function<void(Distance_row&)>> fillings{
      [](Distance_row& row) { row.set(7, 2); },
      [](Distance_row& row) {
        row.set(7, 2);
        row.set(3, 0);
        EXPECT_EQ(row.reached(), (Columns{3, 7}));
        row.set(3, 1);
      },
      [&](Distance_row& row) { row.set_all(one); },
      [&](Distance_row& row) {
        row.set_all(one);
        EXPECT_EQ(row.reached().size(), row.size());
      },
      [&](Distance_row& row) {
        row.set_all(one);
        row.set(0, 5);
      },
      [&](Distance_row& row) { row.set_all(none); }};
  Distance_row row(90);
  for(const auto& first : fillings)
    for(const auto& second : fillings)
    {
      Distance_row fresh(90);
      second(fresh);
      first(row);
      row.clear();
      EXPECT_EQ(values_of(row), Values(90, infinity));
      EXPECT_TRUE(row.reached().empty());
      second(row);
      EXPECT_EQ(values_of(row), values_of(fresh));
      EXPECT_EQ(row.reached(), fresh.reached());
      row.clear();
    }
}

// ----- plans

Distance_matrix_plan
plan_of(const std::size_t rows, const std::size_t columns, const double radius = infinity)
{
  std::vector<std::size_t> order(rows);
  std::iota(order.rbegin(), order.rend(), std::size_t(0));
  return Distance_matrix_plan(order, columns, radius);
}

TEST(Distance_matrix_plan, has_each_row_in_one_block)
{
  for(const std::size_t rows : {0u, 1u, 2u, 511u, 512u, 513u, 1023u, 1024u, 5000u, 100001u})
    for(const std::size_t columns : {0u, 1u, 1000u, 100000000u})
      for(const double radius : {0., 1., infinity})
      {
        const Distance_matrix_plan plan = plan_of(rows, columns, radius);
        EXPECT_EQ(plan.number_of_rows(), rows);
        EXPECT_EQ(plan.number_of_columns(), columns);
        EXPECT_EQ(plan.maximum_distance(), radius);
        EXPECT_FALSE(plan.is_symmetric());
        std::size_t next = rows; // in the order given
        for(std::size_t block = 0; block < plan.number_of_blocks(); ++block)
        {
          const auto rows_of_block = plan.rows_of_block(block);
          EXPECT_TRUE(block + 1 == plan.number_of_blocks()
                          ? rows_of_block.size() > 0 &&
                                rows_of_block.size() <= plan.rows_per_block()
                          : rows_of_block.size() == plan.rows_per_block());
          for(const std::size_t row : rows_of_block)
            ASSERT_EQ(row, --next);
        }
        EXPECT_EQ(next, 0u);
      }
}

// There are enough for many threads, and a block of long rows does not take much memory.
TEST(Distance_matrix_plan, has_blocks_of_moderate_size)
{
  EXPECT_EQ(plan_of(500, 10).rows_per_block(), 1u);
  EXPECT_GT(plan_of(10000, 10).rows_per_block(), 1u);
  EXPECT_GE(plan_of(10000, 10).number_of_blocks(), 512u);
  EXPECT_LE(plan_of(1000000000 / 1000, 10).rows_per_block(), 64u);
  const Distance_matrix_plan of_long_rows = plan_of(100000, 1000000);
  EXPECT_LE(of_long_rows.rows_per_block() * 1000000 * sizeof(double), std::size_t(16) << 20);
  EXPECT_GT(plan_of(100000, 1000000, 1).rows_per_block(), of_long_rows.rows_per_block());
}

// ----- sinks

// One that notes what it is told. Blocks are dealt out by the sink itself if it is asked to resume.
class Noting_sink
{
public:
  struct Block
  {
    std::vector<std::size_t> rows;
  };

  void start(const Distance_matrix_plan& plan)
  {
    ++number_of_starts;
    m_plan = &plan;
    matrix.assign(plan.number_of_rows(), {});
  }

  void collect(Block& block, const std::size_t row, const Distance_row& distances)
  {
    EXPECT_EQ(distances.size(), m_plan->number_of_columns());
    EXPECT_TRUE(matrix[row].empty());
    matrix[row].assign(distances.begin(), distances.end());
    block.rows.push_back(row);
  }

  void add(const std::size_t number, Block& block)
  {
    const auto rows = m_plan->rows_of_block(number);
    EXPECT_EQ(block.rows, std::vector<std::size_t>(rows.begin(), rows.end()));
    EXPECT_TRUE(blocks.insert(number).second);
    block.rows.clear();
  }

  bool finish(const bool is_done)
  {
    EXPECT_EQ(blocks.size() == m_plan->number_of_blocks(), is_done);
    ++number_of_finishes;
    return answer && is_done;
  }

  Matrix matrix;
  std::set<std::size_t> blocks;
  int number_of_starts = 0, number_of_finishes = 0;
  bool answer = true;

private:
  const Distance_matrix_plan* m_plan = nullptr;
};

class Row_sinks : public testing::Test
{
protected:
  Random m_random{test_seed()};
  const Mesh m_mesh = to_mesh(terrain(6, 5, m_random));
  const std::vector<Surface_point> m_sources = random_surface_points(m_mesh, 1100, m_random);
};

TEST_F(Row_sinks, get_every_row_once_in_the_blocks_of_the_plan)
{
  Noting_sink sink;
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, sink, m_sources));
  EXPECT_EQ(sink.matrix, dense_matrix(m_mesh, m_sources));
  EXPECT_EQ(sink.number_of_starts, 1);
  EXPECT_EQ(sink.number_of_finishes, 1);
  EXPECT_LT(sink.blocks.size(), m_sources.size()); // a block has several rows
}

TEST_F(Row_sinks, say_whether_all_is_done)
{
  Noting_sink sink;
  sink.answer = false;
  EXPECT_FALSE(CGAL::approximate_geodesic_distance_matrix(m_mesh, sink, m_sources));
}

TEST_F(Row_sinks, are_started_and_finished_without_rows)
{
  Noting_sink sink;
  EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, sink, std::vector<Vertex>()));
  EXPECT_EQ(sink.number_of_starts, 1);
  EXPECT_EQ(sink.number_of_finishes, 1);
}

// ----- visitors

// Notes progress; and ends the computation after so many questions.
struct Noting_visitor : AG::Distance_matrix_visitor_base
{
  void on_progress(const Distance_matrix_progress& p) { progress.push_back(p); }
  bool go_further() { return number_of_questions++ < last_question; }

  std::vector<Distance_matrix_progress> progress = {};
  std::size_t number_of_questions = 0;
  std::size_t last_question = static_cast<std::size_t>(-1);
};

// One that has half of the blocks already.
class Resuming_sink : public Noting_sink
{
public:
  void start(const Distance_matrix_plan& plan)
  {
    Noting_sink::start(plan);
    m_plan = &plan;
    for(std::size_t block = 1; block < plan.number_of_blocks(); block += 2)
    {
      blocks.insert(block);
      m_rows_done += plan.rows_of_block(block).size();
    }
    number_done_before = m_rows_done;
  }

  std::optional<std::size_t> next_block()
  {
    const std::size_t number = 2 * m_next++;
    return number < m_plan->number_of_blocks() ? std::optional(number) : std::nullopt;
  }

  void add(const std::size_t number, Block& block)
  {
    Noting_sink::add(number, block);
    m_rows_done += m_plan->rows_of_block(number).size();
  }

  std::size_t number_of_rows_done() const { return m_rows_done; }

  std::size_t number_done_before = 0;

private:
  const Distance_matrix_plan* m_plan = nullptr;
  std::size_t m_next = 0, m_rows_done = 0;
};

void expect_sensible_progress(const std::vector<Distance_matrix_progress>& progress,
                              const std::size_t number_of_rows)
{
  ASSERT_FALSE(progress.empty());
  std::size_t last = 0;
  for(const Distance_matrix_progress& p : progress)
  {
    EXPECT_EQ(p.number_of_rows, number_of_rows);
    EXPECT_GT(p.number_done, last);
    EXPECT_GT(p.rows_per_second, 0);
    EXPECT_GE(p.seconds_left, 0);
    EXPECT_TRUE(std::isfinite(p.seconds_left));
    EXPECT_NEAR(p.seconds_left * p.rows_per_second, double(number_of_rows - p.number_done),
                1e-6 * double(number_of_rows));
    last = p.number_done;
  }
  EXPECT_EQ(last, number_of_rows);
  EXPECT_EQ(progress.back().seconds_left, 0);
}

TEST_F(Row_sinks, have_progress)
{
  Noting_visitor visitor;
  const auto np = parameters::targets(std::vector<Vertex>{Vertex(3)}).visitor(std::ref(visitor));
  Noting_sink sink;
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, sink, m_sources, np));
  expect_sensible_progress(visitor.progress, m_sources.size());
  EXPECT_EQ(visitor.progress.size(), sink.blocks.size());
  visitor.progress.clear();
  const auto nothing = [](std::size_t, const Distance_row&) {};
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, nothing, m_sources, np));
  expect_sensible_progress(visitor.progress, m_sources.size());
  EXPECT_EQ(visitor.progress.size(), m_sources.size());
}

// Rows that were there before count as done, but not for the rate.
TEST_F(Row_sinks, may_have_rows_already)
{
  Noting_visitor visitor;
  Resuming_sink sink;
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, sink, m_sources,
                                                         parameters::visitor(std::ref(visitor))));
  expect_sensible_progress(visitor.progress, m_sources.size());
  EXPECT_GT(visitor.progress.front().number_done, sink.number_done_before);
  const Matrix expected = dense_matrix(m_mesh, m_sources);
  std::size_t number = 0;
  for(std::size_t row = 0; row < expected.size(); ++row)
    if(!sink.matrix[row].empty())
    {
      EXPECT_EQ(sink.matrix[row], expected[row]);
      ++number;
    }
  EXPECT_EQ(number, m_sources.size() - sink.number_done_before);
}

TEST_F(Row_sinks, are_told_if_a_visitor_ends_the_computation)
{
  for(const std::size_t last : {0u, 1u, 17u, 1099u})
  {
    Noting_visitor visitor;
    visitor.last_question = last;
    const auto np = parameters::visitor(std::ref(visitor));
    Noting_sink sink;
    EXPECT_FALSE(CGAL::approximate_geodesic_distance_matrix(m_mesh, sink, m_sources, np));
    EXPECT_EQ(sink.number_of_finishes, 1);
    EXPECT_EQ(visitor.number_of_questions, last + 1); // it is not asked again
  }
}

template <typename Rows>
void expect_to_be_emptied(Rows rows, const Mesh& mesh, const std::vector<Surface_point>& sources)
{
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(mesh, rows, sources));
  const auto content = [&] {
    if constexpr(std::is_same_v<Rows, Dense_rows<>>)
      return matrix_of(rows);
    else
      return entries_of(rows);
  };
  const auto expected = content();
  Noting_visitor visitor;
  visitor.last_question = 3;
  const auto np = parameters::visitor(visitor);
  EXPECT_FALSE(CGAL::approximate_geodesic_distance_matrix(mesh, rows, sources, np));
  EXPECT_EQ(visitor.number_of_questions, 0u); // the visitor is copied
  EXPECT_EQ(rows.number_of_rows(), 0u);
  EXPECT_TRUE(content().empty());
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(mesh, rows, sources));
  EXPECT_EQ(content(), expected);
}

TEST_F(Row_sinks, in_memory_are_empty_if_a_visitor_ends_the_computation)
{
  expect_to_be_emptied(Dense_rows<>(), m_mesh, m_sources);
  expect_to_be_emptied(Radius_rows<>(), m_mesh, m_sources);
  expect_to_be_emptied(Nearest_rows<>(3), m_mesh, m_sources);
}

TEST_F(Row_sinks, of_dense_rows_may_write_to_memory_of_the_caller)
{
  const Matrix expected = dense_matrix(m_mesh, m_sources);
  std::vector<double> memory(expected.size() * expected.front().size() + 1, -1);
  Dense_rows<> rows(memory.data());
  for(int run = 0; run < 2; ++run)
  {
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, m_sources));
    EXPECT_EQ(rows.data(), memory.data());
    for(std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_TRUE(std::equal(expected[i].begin(), expected[i].end(), rows.row(i).begin()));
    EXPECT_EQ(memory.back(), -1);
  }
}

// ----- function objects

Matrix matrix_of_function_calls;

void note_row(const std::size_t row, const Distance_row& distances)
{
  EXPECT_EQ(row, matrix_of_function_calls.size());
  matrix_of_function_calls.emplace_back(distances.begin(), distances.end());
}

TEST_F(Row_sinks, may_be_functions_of_any_kind)
{
  const Matrix expected = dense_matrix(m_mesh, m_sources);
  const auto expect_calls = [&](auto&& function) {
    matrix_of_function_calls.clear();
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, function, m_sources));
    EXPECT_EQ(matrix_of_function_calls, expected);
  };
  expect_calls(note_row);
  const auto lambda = [](const std::size_t row, const Distance_row& d) { note_row(row, d); };
  expect_calls(lambda);
  expect_calls(std::function<void(std::size_t, const Distance_row&)>(note_row));
  Matrix rows;
  EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(
      m_mesh, [&](auto, const auto& d) { rows.emplace_back(d.begin(), d.end()); }, m_sources));
  EXPECT_EQ(rows, expected);
}

// They get what is reached, and in which order it is.
TEST_F(Row_sinks, may_be_functions_of_limited_rows)
{
  const Entries expected = within(2, dense_matrix(m_mesh, m_sources));
  const auto check = [&](const std::size_t row, const Distance_row& distances) {
    std::vector<Entry> entries;
    for(const auto column : distances.reached())
      entries.emplace_back(distances[column], column);
    EXPECT_EQ(entries, expected[row]);
    EXPECT_EQ(std::count(distances.begin(), distances.end(), infinity),
              std::ptrdiff_t(distances.size() - entries.size()));
  };
  EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, check, m_sources,
                                                         parameters::maximum_distance(2)));
}

TEST_F(Row_sinks, that_are_functions_get_the_first_rows_until_a_visitor_ends_it)
{
  Noting_visitor visitor;
  visitor.last_question = 9;
  std::size_t number = 0;
  const auto count = [&](const std::size_t row, const Distance_row&) { EXPECT_EQ(row, number++); };
  EXPECT_FALSE(CGAL::approximate_geodesic_distance_matrix(m_mesh, count, m_sources,
                                                          parameters::visitor(std::ref(visitor))));
  EXPECT_EQ(number, 9u);
}

} // namespace
