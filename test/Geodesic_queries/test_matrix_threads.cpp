// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"
#include "threads/numbers_of_threads.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

// Distance matrices that several threads compute, and what ends them early, by one thread or
// several.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

// Tells if two threads are in the same place.
class One_at_a_time
{
public:
  template <typename F>
  void enter(F f)
  {
    EXPECT_FALSE(m_is_inside.exchange(true));
    std::this_thread::yield();
    f();
    m_is_inside = false;
  }

private:
  std::atomic<bool> m_is_inside{false};
};

struct Failure : std::runtime_error
{
  Failure() : std::runtime_error("as ordered") {}
};

class Matrix_threads : public testing::Test
{
protected:
  std::vector<Surface_point> sources(const std::size_t number)
  {
    return random_surface_points(m_mesh, number, m_random);
  }

  // What a function object gets.
  template <typename NamedParameters>
  Matrix matrix_by_calls(const std::vector<Surface_point>& sources, const NamedParameters& np) const
  {
    Matrix result;
    One_at_a_time one;
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(
        m_mesh,
        [&](const std::size_t row, const Distance_row& distances) {
          one.enter([&] {
            EXPECT_EQ(row, result.size());
            result.emplace_back(distances.begin(), distances.end());
          });
        },
        sources, np));
    return result;
  }

  Random m_random{test_seed()};
  const Mesh m_mesh = to_mesh(terrain(9, 8, m_random));
};

TEST_F(Matrix_threads, find_the_same_distances)
{
  for(const std::size_t number : {0u, 1u, 2u, 5u, 1100u})
  {
    const auto sources = this->sources(number);
    const Matrix expected = dense_matrix(m_mesh, sources);
    for_each_number_of_threads([&](const auto& np) {
      EXPECT_TRUE(are_the_same(dense_matrix(m_mesh, sources, np), expected));
      EXPECT_TRUE(are_the_same(radius_entries(m_mesh, sources, np.maximum_distance(2)),
                               within(2, expected)));
      EXPECT_TRUE(are_the_same(nearest_entries(4, m_mesh, sources, np),
                               nearest_of(4, within(infinity, expected))));
      EXPECT_TRUE(are_the_same(matrix_by_calls(sources, np), expected));
    });
  }
}

TEST_F(Matrix_threads, find_the_same_in_both_directions)
{
  const auto sources = this->sources(150);
  const auto both = parameters::epsilon(0.5).targets(sources).symmetric(true);
  const Matrix expected = dense_matrix(m_mesh, sources, both);
  for_each_number_of_threads([&](const auto& tag) {
    const auto np = tag.epsilon(0.5).targets(sources).symmetric(true);
    EXPECT_TRUE(are_the_same(dense_matrix(m_mesh, sources, np), expected));
    EXPECT_TRUE(are_the_same(radius_entries(m_mesh, sources, np), within(infinity, expected)));
  });
}

TEST_F(Matrix_threads, find_the_same_exact_distances)
{
  const auto vertices = vertices_of(m_mesh);
  const Matrix expected = dense_matrix(m_mesh, vertices, parameters::epsilon(0));
  for_each_number_of_threads([&](const auto& tag) {
    EXPECT_TRUE(are_the_same(dense_matrix(m_mesh, vertices, tag.epsilon(0)), expected));
  });
}

#ifdef CGAL_LINKED_WITH_TBB
// A graph whose searches use all threads is searched from one source after the other.
TEST_F(Matrix_threads, may_belong_to_the_graph)
{
  const AG::Saddle_vertex_graph graph(Triangulation(m_mesh),
                                      parameters::concurrency_tag(CGAL::Parallel_tag()));
  const auto sources = intrinsic_points(m_mesh, graph.triangulation(), this->sources(20));
  const Matrix expected = dense_matrix(graph, sources);
  for_each_number_of_threads([&](const auto& tag) {
    EXPECT_TRUE(are_the_same(dense_matrix(graph, sources, tag), expected));
  });
}
#endif

TEST_F(Matrix_threads, need_no_columns)
{
  const auto sources = this->sources(50);
  const std::vector<Vertex> none;
  for_each_number_of_threads([&](const auto& tag) {
    EXPECT_EQ(matrix_by_calls(sources, tag.targets(none)), Matrix(sources.size()));
  });
}

// ----- visitors

struct Watching_visitor : AG::Distance_matrix_visitor_base
{
  void on_progress(const AG::Distance_matrix_progress& p)
  {
    one.enter([&] {
      EXPECT_GE(p.number_done, number_done);
      EXPECT_LE(p.number_done, p.number_of_rows);
      EXPECT_GE(p.rows_per_second, 0);
      EXPECT_GE(p.seconds_left, 0);
      number_done = p.number_done;
    });
  }

  bool go_further()
  {
    bool result = true;
    one.enter([&] { result = !is_canceled && number_of_questions++ < last_question; });
    return result;
  }

  One_at_a_time one;
  std::atomic<bool> is_canceled{false};
  std::size_t number_done = 0, number_of_questions = 0;
  std::size_t last_question = static_cast<std::size_t>(-1);
};

TEST_F(Matrix_threads, tell_a_visitor_one_after_the_other)
{
  const auto sources = this->sources(1100);
  for_each_number_of_threads([&](const auto& tag) {
    Watching_visitor visitor;
    Dense_rows<> rows;
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, sources,
                                                           tag.visitor(std::ref(visitor))));
    EXPECT_EQ(visitor.number_done, sources.size());
    EXPECT_EQ(visitor.number_of_questions, sources.size());
  });
}

TEST_F(Matrix_threads, end_if_a_visitor_wants_it)
{
  const auto sources = this->sources(300);
  for_each_number_of_threads([&](const auto& tag) {
    for(const std::size_t last : {0u, 1u, 100u, 299u})
    {
      Watching_visitor first, second;
      first.last_question = second.last_question = last;
      Dense_rows<> rows;
      EXPECT_FALSE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, sources,
                                                              tag.visitor(std::ref(first))));
      EXPECT_EQ(rows.number_of_rows(), 0u);
      std::size_t number = 0;
      EXPECT_FALSE(CGAL::approximate_geodesic_distance_matrix(
          m_mesh, [&](const std::size_t row, const Distance_row&) { EXPECT_EQ(row, number++); },
          sources, tag.visitor(std::ref(second))));
      EXPECT_LE(number, last);
      EXPECT_EQ(second.number_done, number);
    }
  });
}

// Whoever cancels is not one of the threads that compute.
TEST_F(Matrix_threads, end_if_another_thread_wants_it)
{
  const std::vector<Vertex> sources(100000, Vertex(5)); // they would take a second
  for_each_number_of_threads([&](const auto& tag) {
    Watching_visitor visitor;
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      visitor.is_canceled = true;
    });
    const auto nothing = [](std::size_t, const Distance_row&) {};
    EXPECT_FALSE(CGAL::approximate_geodesic_distance_matrix(
        m_mesh, nothing, sources, tag.epsilon(0).visitor(std::ref(visitor))));
    other.join();
    EXPECT_LT(visitor.number_done, sources.size());
  });
}

// ----- exceptions

TEST_F(Matrix_threads, end_if_a_function_object_throws)
{
  const auto sources = this->sources(200);
  for_each_number_of_threads([&](const auto& tag) {
    for(const std::size_t last : {0u, 1u, 77u, 199u})
    {
      std::size_t number = 0;
      const auto fail = [&](const std::size_t row, const Distance_row&) {
        EXPECT_EQ(row, number++); // nor is it called again afterwards
        if(row == last)
          throw Failure();
      };
      EXPECT_THROW(CGAL::approximate_geodesic_distance_matrix(m_mesh, fail, sources, tag), Failure);
      EXPECT_EQ(number, last + 1);
    }
  });
}

TEST_F(Matrix_threads, end_if_a_visitor_throws)
{
  struct Failing_visitor : AG::Distance_matrix_visitor_base
  {
    void on_progress(const AG::Distance_matrix_progress& p)
    {
      if(p.number_done >= number && fails_on_progress)
        throw Failure();
    }
    bool go_further()
    {
      if(++number_of_questions == number && !fails_on_progress)
        throw Failure();
      return true;
    }
    bool fails_on_progress;
    std::size_t number, number_of_questions = 0;
  };
  const auto sources = this->sources(200);
  const Matrix expected = dense_matrix(m_mesh, sources);
  Dense_rows<> rows;
  for_each_number_of_threads([&](const auto& tag) {
    for(const bool fails_on_progress : {false, true})
      for(const std::size_t number : {1u, 50u, 200u})
      {
        Failing_visitor visitor{{}, fails_on_progress, number};
        const auto np = tag.visitor(visitor);
        EXPECT_THROW(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, sources, np),
                     Failure);
        EXPECT_EQ(rows.number_of_rows(), 0u);
        const auto nothing = [](std::size_t, const Distance_row&) {};
        EXPECT_THROW(CGAL::approximate_geodesic_distance_matrix(m_mesh, nothing, sources, np),
                     Failure);
      }
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, sources, tag));
    EXPECT_TRUE(are_the_same(matrix_of(rows), expected));
  });
}

// A sink that fails in one of its functions.
struct Failing_sink
{
  enum class Place
  {
    START,
    COLLECT,
    ADD,
    FINISH,
    NONE
  };

  struct Block
  {
  };

  void start(const AG::Distance_matrix_plan&) { fail_at(Place::START); }
  void collect(Block&, const std::size_t row, const Distance_row&)
  {
    if(row == 60)
      fail_at(Place::COLLECT);
  }
  void add(const std::size_t block, Block&)
  {
    if(block == 60)
      fail_at(Place::ADD);
  }
  bool finish(const bool is_done)
  {
    EXPECT_TRUE(is_done); // what has failed does not come here
    fail_at(Place::FINISH);
    return is_done;
  }

  void fail_at(const Place here)
  {
    if(here == place)
      throw Failure();
  }

  Place place = Place::NONE;
};

TEST_F(Matrix_threads, end_if_a_sink_throws)
{
  using Place = Failing_sink::Place;
  const auto sources = this->sources(200);
  for_each_number_of_threads([&](const auto& tag) {
    Failing_sink sink;
    for(const Place place : {Place::START, Place::COLLECT, Place::ADD, Place::FINISH})
    {
      sink.place = place;
      EXPECT_THROW(CGAL::approximate_geodesic_distance_matrix(m_mesh, sink, sources, tag), Failure);
    }
    sink.place = Place::NONE;
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, sink, sources, tag));
  });
}

#ifdef CGAL_LINKED_WITH_TBB
// Threads that wait for those of the inner loop must not begin with rows of the outer one.
TEST_F(Matrix_threads, may_be_used_by_a_function_object_itself)
{
  const auto sources = this->sources(100);
  const auto few = this->sources(30);
  const Matrix expected = dense_matrix(m_mesh, few);
  for_each_number_of_threads([&](const auto& tag) {
    std::size_t number = 0;
    const auto compute = [&](const std::size_t row, const Distance_row&) {
      EXPECT_EQ(row, number++);
      EXPECT_TRUE(are_the_same(
          dense_matrix(m_mesh, few, parameters::concurrency_tag(CGAL::Parallel_tag())), expected));
    };
    EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, compute, sources, tag));
    EXPECT_EQ(number, sources.size());
  });
}
#endif

} // namespace
