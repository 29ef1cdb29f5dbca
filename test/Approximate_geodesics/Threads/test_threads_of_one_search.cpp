// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "checks/graphs_of_all_kinds.h"
#include "checks/test_recorder.h"
#include "meshes/hostile_meshes.h"
#include "meshes/surface_points.h"
#include "threads/Interruption_at.h"
#include "threads/numbers_of_threads.h"

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

// Threads that take part in one search across faces: their number changes nothing, to the last bit.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Arcs = Lazy_discrete_geodesic_graph::Arcs;

// A queue that remembers how many nodes it has handed out at a time.
struct Watched_queue : AG::Adaptive_bucket_queue
{
  using AG::Adaptive_bucket_queue::Adaptive_bucket_queue;

  Batch extract_round(const std::size_t largest_batch)
  {
    const Batch result = AG::Adaptive_bucket_queue::extract_round(largest_batch);
    EXPECT_LE(result.size(), largest_batch);
    largest_round = (std::max)(largest_round, result.size());
    return result;
  }

  std::size_t largest_round = 0;
};

// What a call of the function writes.
struct Written
{
  std::vector<double> distances;
  std::vector<std::size_t> nearest;
  std::vector<Vertex> predecessors;

  bool operator==(const Written& other) const
  {
    return have_same_bits(distances, other.distances) && nearest == other.nearest &&
           predecessors == other.predecessors;
  }
};

class One_search_by_threads : public testing::Test
{
protected:
  static constexpr double epsilon = 0.1;

  One_search_by_threads() : m_mesh(to_mesh(terrain(90, 70, m_random))) // more than one block
  {
    for(int i = 0; i < 60; ++i) // so that fronts are long
      m_sources.push_back(random_face_location(m_mesh, m_random));
    m_sources.push_back(Vertex(7));
    m_sources.push_back(Vertex(2345));
  }

  template <typename NamedParameters>
  Written written(const NamedParameters& np) const
  {
    const std::size_t size = m_mesh.number_of_vertices();
    Written result{std::vector<double>(size), std::vector<std::size_t>(size),
                   std::vector<Vertex>(size)};
    const auto map = [&](auto& values) {
      return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, m_mesh));
    };
    CGAL::approximate_geodesic_distances(
        m_mesh, map(result.distances), m_sources,
        parameters::combine(np, parameters::nearest_source_map(map(result.nearest))
                                    .predecessor_map(map(result.predecessors))));
    return result;
  }

  // Calls `find(np)`, where several threads take part, for several numbers of them, and expects
  // the same from all. Returns it, and what one thread finds by itself.
  template <typename Find>
  auto same_from_all(const Find& find) const
  {
    using Found = decltype(find(with_concurrency(CGAL::Sequential_tag())));
    std::vector<Found> found;
    for_each_number_of_threads([&](const auto& np) { found.push_back(find(np)); });
    for(std::size_t i = 2; i < found.size(); ++i)
      EXPECT_TRUE(found[i] == found[1]) << i;
    return std::make_pair(found.back(), found.front());
  }

  Random m_random{test_seed()};
  const Mesh m_mesh;
  std::vector<Surface_point> m_sources;
};

// Two searches with the same bound and another order.
void expect_within_bound(const std::vector<double>& a,
                         const std::vector<double>& b,
                         const double epsilon)
{
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_LE(a[i], (1 + epsilon) * b[i]);
    EXPECT_LE(b[i], (1 + epsilon) * a[i]);
  }
}

TEST_F(One_search_by_threads, gives_the_same_by_any_number)
{
  const auto [found, alone] =
      same_from_all([&](const auto& np) { return written(np.epsilon(epsilon)); });
  expect_within_bound(found.distances, alone.distances, epsilon);
}

TEST_F(One_search_by_threads, ends_at_the_same_place)
{
  const double largest = 4;
  const auto [found, alone] = same_from_all(
      [&](const auto& np) { return written(np.epsilon(epsilon).maximum_distance(largest)); });
  EXPECT_GT(std::count(found.distances.begin(), found.distances.end(), infinity), 100);
  for(std::size_t i = 0; i < found.distances.size(); ++i)
    EXPECT_TRUE(found.distances[i] <= largest || found.distances[i] == infinity);

  const std::vector<Vertex> targets = {Vertex(3000), Vertex(11)};
  const auto [to_targets, alone_to_targets] =
      same_from_all([&](const auto& np) { return written(np.epsilon(epsilon).targets(targets)); });
  for(const Vertex v : targets)
    EXPECT_LE(to_targets.distances[v], (1 + epsilon) * alone_to_targets.distances[v]);
}

TEST_F(One_search_by_threads, finds_the_same_paths)
{
  using Path = std::vector<Point>;
  const auto [found, alone] = same_from_all([&](const auto& np) {
    Path path;
    const double length = CGAL::approximate_geodesic_path(
        m_mesh, std::back_inserter(path), m_sources.front(), Vertex(6000), np.epsilon(epsilon));
    EXPECT_NEAR(length_of(path), length, 1e-9 * length);
    return path;
  });
  expect_within_bound({length_of(found)}, {length_of(alone)}, epsilon);
}

// Arcs that are kept do not depend on the order: distances are those in the built graph.
TEST_F(One_search_by_threads, finds_the_distances_of_the_built_graph)
{
  const auto built = discrete_geodesic_graph(epsilon).make(Triangulation(m_mesh));
  AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph> expected(m_mesh, built);
  expected.add_source_points(m_sources.begin(), m_sources.end());
  for_each_number_of_threads([&](const auto& np) {
    const Lazy_discrete_geodesic_graph graph(Triangulation(m_mesh, np), np.epsilon(epsilon),
                                             Arcs::KEPT);
    AG::Propagation<Lazy_discrete_geodesic_graph, Watched_queue> search(graph);
    std::vector<AG::Seed> seeds;
    for(Node v = 0; v < 90; ++v)
      seeds.push_back({v, 0});
    search.run(seeds);
    // or threads have nothing to do
    EXPECT_EQ(search.queue().largest_round > Watched_queue::LARGEST_BATCH, graph.is_parallel());
    AG::Propagation<Discrete_geodesic_graph> other(built);
    other.run(seeds);
    EXPECT_TRUE(have_same_bits(distances_of_nodes(search), distances_of_nodes(other)));
  });
}

// Of many nodes that are expanded at a time, some get shorter paths over others. If they were
// expanded again, all of their arcs would be looked for.
TEST_F(One_search_by_threads, looks_for_few_arcs_in_vain)
{
  const auto graded = [](const std::size_t side, const double di, const double dj) {
    return AG::Intrinsic_triangulation(
        to_mesh(grid(side, side, [&](const double i, const double j) {
          return Point(std::exp(i / di) * std::cos(j / dj), std::exp(i / di) * std::sin(j / dj), 0);
        })));
  };
  const auto arcs_per_node = [&](const AG::Intrinsic_triangulation& t, const Node source,
                                 const auto& np) {
    const Lazy_discrete_geodesic_graph graph(t, np.epsilon(epsilon));
    AG::Propagation<Lazy_discrete_geodesic_graph> search(graph);
    search.collect_statistics(true);
    search.run_from(source);
    return static_cast<double>(search.statistics().relaxations) /
           static_cast<double>(graph.number_of_nodes());
  };
  const auto alone = with_concurrency(CGAL::Sequential_tag());
  const auto together = with_concurrency(CGAL::Parallel_tag());
  const AG::Intrinsic_triangulation even = graded(300, 100, 100);
  EXPECT_LT(arcs_per_node(even, 0, together) / arcs_per_node(even, 0, alone), 1.05);
  const AG::Intrinsic_triangulation uneven = graded(150, 30, 40); // sizes of faces vary far more
  const double fewest = arcs_per_node(uneven, 22400, alone);
  EXPECT_LT(fewest, 26.5); // 28.1 if no node waits
  EXPECT_LT(arcs_per_node(uneven, 22400, together) / fewest, 1.5);
}

TEST_F(One_search_by_threads, counts_what_one_thread_counts)
{
  std::vector<std::size_t> relaxations, pops;
  for_each_number_of_threads([&](const auto& np) {
    const Lazy_discrete_geodesic_graph graph(Triangulation(m_mesh), np.epsilon(epsilon));
    AG::Propagation<Lazy_discrete_geodesic_graph> search(graph);
    search.collect_statistics(true);
    search.run_from(0);
    relaxations.push_back(search.statistics().relaxations);
    pops.push_back(search.statistics().pops);
  });
  for(std::size_t i = 2; i < pops.size(); ++i)
  {
    EXPECT_EQ(relaxations[i], relaxations[1]);
    EXPECT_EQ(pops[i], pops[1]);
  }
  EXPECT_GT(relaxations.back(), m_mesh.number_of_halfedges() / 2);
}

TEST_F(One_search_by_threads, may_be_interrupted)
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Lazy_discrete_geodesic_graph>;
  for_each_number_of_threads([&](const auto& np) {
    Paths paths(m_mesh, np.epsilon(epsilon));
    paths.add_source_points(m_sources.begin(), m_sources.end());
    const auto distances = [&] {
      std::vector<double> result;
      for(const Vertex v : m_mesh.vertices())
        result.push_back(paths.shortest_distance_to_source_points(v).first);
      return result;
    };
    const std::vector<double> expected = distances();

    Recorder<Vertex> recorder;
    recorder.throw_at = 3000;
    EXPECT_THROW(paths.build_sequence_tree(parameters::visitor(std::ref(recorder))),
                 std::runtime_error);
    recorder = Recorder<Vertex>();
    recorder.stop_at = 3000;
    paths.build_sequence_tree(parameters::visitor(std::ref(recorder)));
    EXPECT_GE(recorder.settled.size(), 3000u);
    EXPECT_LT(recorder.settled.size(), m_mesh.number_of_vertices());
    for(const auto& [v, d] : recorder.settled)
      EXPECT_LE(d, (1 + epsilon) * expected[v]);

    paths.remove_all_source_points();
    paths.add_source_points(m_sources.begin(), m_sources.end());
    expect_within_bound(distances(), expected, epsilon);
  });
}

// Sights that threads have deferred when one of them throws do not wait for the next search.
TEST_F(One_search_by_threads, forgets_the_sights_of_an_interrupted_run)
{
  for_each_number_of_threads([&](const auto& np) {
    const Saddle_vertex_graph graph(Triangulation(m_mesh), np);
    AG::Propagation<Saddle_vertex_graph> search(graph), fresh(graph);
    fresh.run_from(6299);
    const std::vector<double> expected = distances_of_nodes(fresh);
    int number = 5;
    for(bool is_interrupted = true; is_interrupted; number *= 2)
    {
      const auto run = [&] {
        const Interruption_at interruption(number);
        search.run_from(0);
      };
      try
      {
        run();
        is_interrupted = false;
      }
      catch(const std::runtime_error&)
      {
      }
      search.run_from(6299);
      expect_within_bound(distances_of_nodes(search), expected, 1e-12);
    }
    EXPECT_GT(number, 50);
  });
}

TEST_F(One_search_by_threads, refuses_the_same)
{
  std::vector<double> lengths;
  for(const auto e : m_mesh.edges())
    lengths.push_back(CGAL::sqrt(CGAL::squared_distance(m_mesh.point(m_mesh.vertex(e, 0)),
                                                        m_mesh.point(m_mesh.vertex(e, 1)))));
  lengths[9876] *= 10;
  const auto map =
      boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, m_mesh));
  std::vector<double> distances(m_mesh.number_of_vertices(), -1);
  const auto distance_map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
  for_each_number_of_threads([&](const auto& np) {
    expect_message<std::invalid_argument>(
        [&] {
          CGAL::approximate_geodesic_distances(m_mesh, distance_map, Vertex(0),
                                               np.epsilon(epsilon).edge_length_map(map));
        },
        "triangle inequality");
    EXPECT_EQ(std::count(distances.begin(), distances.end(), -1),
              static_cast<std::ptrdiff_t>(distances.size()));
  });
}

// Lengths, and the shapes of thin faces, which are all over the mesh.
TEST(Triangulation_by_threads, is_the_same)
{
  Random random(test_seed());
  const Mesh mesh =
      to_mesh(with_caps(terrain(60, 50, random), [&] { return random.between(0.1, 0.9); }));
  const Triangulation expected(mesh);
  ASSERT_GT(expected.number_of_vertices(), AG::internal::Loop::SIZE_OF_BLOCK);
  ASSERT_GT(expected.thin_faces().number_of_faces(), 1000u);
  for_each_number_of_threads([&](const auto& np) {
    const Triangulation found(mesh, np);
    EXPECT_TRUE(have_same_bits(found.lengths(), expected.lengths()));
    ASSERT_EQ(found.thin_faces().number_of_faces(), expected.thin_faces().number_of_faces());
    for(Node h = 0; h < expected.number_of_halfedges(); ++h)
      if(!expected.is_border(h))
      {
        const auto a = found.thin_faces().find(found.halfedges_of_face(h));
        const auto b = expected.thin_faces().find(expected.halfedges_of_face(h));
        ASSERT_EQ(a.has_value(), b.has_value());
        EXPECT_EQ(a.value_or(AG::internal::Thin_face{}).doubled_area,
                  b.value_or(AG::internal::Thin_face{}).doubled_area);
      }
  });
}

// A small mesh is searched by one thread, which is faster: the results are those of one thread.
TEST(Small_search_by_threads, is_that_of_one)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(20, 15, random));
  for(const double largest_error : {0., 0.1})
  {
    std::vector<double> expected;
    for_each_number_of_threads([&](const auto& np) {
      std::vector<double> found(mesh.number_of_vertices());
      CGAL::approximate_geodesic_distances(
          mesh, boost::make_iterator_property_map(found.begin(), get(boost::vertex_index, mesh)),
          Vertex(7), np.epsilon(largest_error));
      if(expected.empty())
        expected = found;
      EXPECT_TRUE(have_same_bits(found, expected));
    });
  }
  for_each_number_of_threads([&](const auto& np) {
    EXPECT_FALSE(Lazy_discrete_geodesic_graph(Triangulation(mesh), np.epsilon(0.1)).is_parallel());
    EXPECT_FALSE(Saddle_vertex_graph(Triangulation(mesh), np).is_parallel());
  });
}

#ifdef CGAL_LINKED_WITH_TBB
// A thread that waits for another one's last turn has time to start on something else.
TEST(Loop_of_threads, takes_up_nothing_else_while_it_waits)
{
  const auto loop = AG::internal::Loop::with_tag<CGAL::Parallel_tag>();
  std::atomic<std::size_t> number_of_turns(0);
  const tbb::global_control more_than_cores(tbb::global_control::max_allowed_parallelism, 4);
  tbb::enumerable_thread_specific<bool> is_inside(false);
  tbb::task_arena(4).execute([&] {
    tbb::parallel_for(0, 60, [&](const int) {
      bool& is_here = is_inside.local();
      EXPECT_FALSE(is_here);
      is_here = true;
      loop.run(5, [&](const std::size_t i, const std::size_t thread) {
        EXPECT_LT(thread, 4u);
        std::this_thread::sleep_for(std::chrono::microseconds(200 * i));
        ++number_of_turns;
      });
      is_here = false;
    });
  });
  EXPECT_EQ(number_of_turns, 300u);
}

// In a loop of the user's, who gives each thread a workspace of its own. A thread that waits for
// others must not start on another source meanwhile: it would search in the same workspace.
TEST_F(One_search_by_threads, may_be_part_of_another_loop)
{
  using Graph = Lazy_discrete_geodesic_graph;
  using Search = AG::Propagation<Graph>;
  const Graph graph(Triangulation(m_mesh),
                    parameters::epsilon(epsilon).concurrency_tag(CGAL::Parallel_tag()));
  const auto seeds_of = [](const std::size_t i) {
    std::vector<AG::Seed> result;
    for(std::size_t k = 0; k < 90; ++k)
      result.push_back({static_cast<Node>(90 * i + k), 0});
    return result;
  };
  constexpr std::size_t number = 20;
  std::vector<std::vector<double>> found(number);
  const tbb::global_control more_than_cores(tbb::global_control::max_allowed_parallelism, 4);
  tbb::enumerable_thread_specific<Search> searches([&] { return Search(graph); });
  tbb::task_arena(4).execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, number, 1), [&](const auto& range) {
      for(std::size_t i = range.begin(); i < range.end(); ++i)
      {
        searches.local().run(seeds_of(i));
        found[i] = distances_of_nodes(searches.local());
      }
    });
  });
  for(std::size_t i = 0; i < number; ++i)
  {
    Search alone(graph);
    alone.run(seeds_of(i));
    EXPECT_EQ(found[i].size(), m_mesh.number_of_vertices());
    // buckets adapt from run to run, and so does the order of lazy searches
    expect_within_bound(found[i], distances_of_nodes(alone), epsilon);
  }
}
#endif

} // namespace
