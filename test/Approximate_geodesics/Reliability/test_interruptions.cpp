// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_of_all_kinds.h"
#include "checks/test_recorder.h"
#include "meshes/surface_points.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <iterator>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

// Visitors that throw or cancel a run of the class or of a function.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Values = std::vector<double>;
using Vertex_recorder = Recorder<Vertex>;

void expect_near(const double found, const double expected, const double deviation)
{
  if(deviation == 0 || expected <= 0)
    EXPECT_EQ(found, expected);
  else
    EXPECT_NEAR(found, expected, expected * deviation);
}

std::set<Vertex> settled_by(const Vertex_recorder& recorder)
{
  std::set<Vertex> result;
  for(const auto& [vertex, distance] : recorder.settled)
    result.insert(vertex);
  return result;
}

// The class with two sources, and some places that it is asked about.
template <typename GeodesicGraph>
class Class_subject
{
public:
  using Paths = AG::Surface_mesh_shortest_path<Mesh, GeodesicGraph>;

  explicit Class_subject(const Kind_of_graph<GeodesicGraph>& kind)
    : m_mesh(to_mesh(terrain(12, 9, m_random))),
      m_deviation(kind.deviation),
      m_paths(m_mesh, kind.make(Triangulation(m_mesh)))
  {
    m_paths.add_source_point(Vertex(3));
    m_paths.add_source_point(random_face_location(m_mesh, m_random), 0.5);
    for(const Vertex v : m_mesh.vertices())
      m_points.push_back(v);
    for(int i = 0; i < 50; ++i)
      m_points.push_back(random_face_location(m_mesh, m_random));
    m_expected = distances();
  }

  Paths& paths() { return m_paths; }

  Values distances()
  {
    Values result;
    for(const Surface_point& p : m_points)
      result.push_back(m_paths.shortest_distance_to_source_points(p).first);
    return result;
  }

  // The sources that count from now on are the ones that there were, but searched again.
  void expect_all_to_be_right_again()
  {
    m_paths.remove_source_point(m_paths.add_source_point(Vertex(50)));
    const Values found = distances();
    for(std::size_t i = 0; i < found.size(); ++i)
      expect_near(found[i], m_expected[i], m_deviation);
  }

  // Those vertices were settled that count as reached, and what counts as reached is certain.
  void expect_part(const Vertex_recorder& recorder)
  {
    EXPECT_FALSE(m_paths.changed_since_last_build());
    const std::set<Vertex> settled = settled_by(recorder);
    EXPECT_LT(settled.size(), m_mesh.number_of_vertices());
    const Values found = distances();
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      if(i < m_mesh.number_of_vertices())
      {
        EXPECT_EQ(found[i] >= 0, settled.count(std::get<Vertex>(m_points[i])) == 1);
      }
      if(found[i] != -1)
        expect_near(found[i], m_expected[i], m_deviation);
    }
  }

private:
  Random m_random = Random(test_seed());
  const Mesh m_mesh;
  const double m_deviation;
  Paths m_paths;
  std::vector<Surface_point> m_points;
  Values m_expected;
};

template <typename F>
void for_each_class(F f)
{
  f(Class_subject(edge_graph()));
  f(Class_subject(lazy_graph(0.2, Lazy_discrete_geodesic_graph::Arcs::FORGOTTEN)));
  f(Class_subject(discrete_geodesic_graph(0.2)));
  with_spaced_points(1, [&](const auto& kind) { f(Class_subject(kind)); });
}

TEST(Visitor_of_the_class, can_throw_at_any_time)
{
  for_each_class([](auto&& subject) {
    for(std::size_t i = 0; i < 108; i += 1 + i / 4)
    {
      Vertex_recorder recorder;
      recorder.throw_at = i;
      EXPECT_THROW(subject.paths().build_sequence_tree(parameters::visitor(std::ref(recorder))),
                   std::runtime_error);
      EXPECT_TRUE(subject.paths().changed_since_last_build());
      subject.expect_all_to_be_right_again();
    }
  });
}

TEST(Visitor_of_the_class, can_end_the_run_at_any_time)
{
  for_each_class([](auto&& subject) {
    for(std::size_t i = 0; i < 108; i += 1 + i / 4)
    {
      Vertex_recorder recorder;
      recorder.stop_at = i;
      subject.paths().build_sequence_tree(parameters::visitor(std::ref(recorder)));
      subject.expect_part(recorder);
      subject.expect_all_to_be_right_again();
    }
  });
}

// Waits for somebody else to cancel the run, once it has settled some vertices.
struct Canceled_visitor : Vertex_recorder
{
  bool go_further()
  {
    if(settled.size() < 20)
      return true;
    waits = true;
    while(!is_canceled)
      std::this_thread::yield();
    return false;
  }

  std::atomic<bool> waits = false;
  std::atomic<bool> is_canceled = false;
};

// Calls `run(visitor)`, and cancels it in another thread.
template <typename Run>
void cancel(Run run)
{
  Canceled_visitor visitor;
  std::thread other([&] {
    while(!visitor.waits)
      std::this_thread::yield();
    visitor.is_canceled = true;
  });
  run(visitor);
  other.join();
}

TEST(Visitor_of_the_class, can_be_told_to_by_another_thread)
{
  for_each_class([](auto&& subject) {
    cancel([&](Canceled_visitor& visitor) {
      subject.paths().build_sequence_tree(parameters::visitor(std::ref(visitor)));
      EXPECT_GE(visitor.settled.size(), 20u);
      subject.expect_part(visitor);
    });
    subject.expect_all_to_be_right_again();
  });
}

// ----- functions

class Watched_function : public testing::Test
{
protected:
  template <typename T>
  auto map(std::vector<T>& values) const
  {
    values.resize(m_mesh.number_of_vertices());
    return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, m_mesh));
  }

  Watched_function() : m_mesh(to_mesh(terrain(12, 9, m_random)))
  {
    CGAL::approximate_geodesic_distances(m_mesh, map(m_expected), Vertex(3));
    CGAL::approximate_geodesic_distances(m_mesh, map(m_expected_bounded), Vertex(3),
                                         parameters::epsilon(0.1));
  }

  // Vertices that were not settled are at infinite distance, and there are some.
  void
  expect_part(const Values& found, const Values& expected, const Vertex_recorder& recorder) const
  {
    const std::set<Vertex> settled = settled_by(recorder);
    EXPECT_LT(settled.size(), m_mesh.number_of_vertices());
    for(const Vertex v : m_mesh.vertices())
      EXPECT_EQ(found[v], settled.count(v) == 1 ? expected[v] : infinity);
  }

  Random m_random = Random(test_seed());
  const Mesh m_mesh;
  Values m_expected, m_expected_bounded;
};

TEST_F(Watched_function, writes_to_no_map_if_the_visitor_throws)
{
  for(std::size_t i = 0; i < 108; i += 1 + i / 4)
  {
    Vertex_recorder recorder;
    recorder.throw_at = i;
    Values distances(108, -1);
    std::vector<std::size_t> sources(108, 99);
    std::vector<Vertex> predecessors(108, Vertex(99));
    const auto with_visitor = parameters::nearest_source_map(map(sources))
                                  .predecessor_map(map(predecessors))
                                  .visitor(std::ref(recorder));
    const auto run = [&](const auto& np) {
      recorder.settled.clear();
      EXPECT_THROW(CGAL::approximate_geodesic_distances(m_mesh, map(distances), Vertex(3), np),
                   std::runtime_error);
      EXPECT_EQ(distances, Values(108, -1));
      EXPECT_EQ(sources, std::vector<std::size_t>(108, 99));
      EXPECT_EQ(predecessors, std::vector<Vertex>(108, Vertex(99)));
    };
    run(with_visitor);
    run(parameters::combine(with_visitor, parameters::epsilon(0.1)));
  }
}

// Vertices that were not settled have neither source nor predecessor.
TEST_F(Watched_function, tells_what_is_certain_if_the_visitor_ends_the_run)
{
  for(std::size_t i = 0; i < 108; i += 1 + i / 4)
  {
    Vertex_recorder recorder;
    recorder.stop_at = i;
    Values distances, bounded;
    std::vector<std::size_t> sources;
    std::vector<Vertex> predecessors;
    CGAL::approximate_geodesic_distances(m_mesh, map(distances), Vertex(3),
                                         parameters::nearest_source_map(map(sources))
                                             .predecessor_map(map(predecessors))
                                             .visitor(std::ref(recorder)));
    expect_part(distances, m_expected, recorder);
    const std::set<Vertex> settled = settled_by(recorder);
    for(const Vertex v : m_mesh.vertices())
    {
      const bool is_settled = settled.count(v) == 1;
      EXPECT_EQ(sources[v], is_settled ? 0 : Search::null_source);
      EXPECT_EQ(predecessors[v] == Mesh::null_vertex(), !is_settled);
    }
    recorder.settled.clear();
    CGAL::approximate_geodesic_distances(m_mesh, map(bounded), Vertex(3),
                                         parameters::epsilon(0.1).visitor(std::ref(recorder)));
    expect_part(bounded, m_expected_bounded, recorder);
  }
}

TEST_F(Watched_function, can_be_canceled_by_another_thread)
{
  cancel([&](Canceled_visitor& visitor) {
    Values distances;
    CGAL::approximate_geodesic_distances(m_mesh, map(distances), Vertex(3),
                                         parameters::visitor(std::ref(visitor)));
    EXPECT_GE(visitor.settled.size(), 20u);
    expect_part(distances, m_expected, visitor);
  });
  cancel([&](Canceled_visitor& visitor) {
    std::vector<Point> points;
    EXPECT_EQ(CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), Vertex(3),
                                              Vertex(107), parameters::visitor(std::ref(visitor))),
              infinity);
    EXPECT_TRUE(points.empty());
  });
}

} // namespace
