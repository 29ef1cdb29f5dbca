// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_SAME_FROM_ALL_THREADS_H
#define APPROXIMATE_GEODESICS_TEST_SAME_FROM_ALL_THREADS_H

#include "checks/Kind_of_graph.h"
#include "meshes/surface_points.h"
#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <thread>
#include <vector>

// What several threads may do at the same time gives what one thread gives alone. The thread
// sanitizer says whether they may.

namespace geodesics_test {

using Values = std::vector<double>;
constexpr std::size_t number_of_threads = 4;

// Calls `task(i)` for `i` below the number of threads in one thread after the other, and then in
// all of them at the same time.
template <typename Task>
void expect_same_from_all_threads(Task task)
{
  std::vector<Values> expected, found(number_of_threads);
  for(std::size_t i = 0; i < number_of_threads; ++i)
    expected.push_back(task(i));
  std::vector<std::thread> threads;
  for(std::size_t i = 0; i < number_of_threads; ++i)
    threads.emplace_back([&, i] { found[i] = task(i); });
  for(std::thread& thread : threads)
    thread.join();
  for(std::size_t i = 0; i < number_of_threads; ++i)
    EXPECT_TRUE(have_same_bits(found[i], expected[i])) << "thread " << i;
}

inline Mesh mesh_for_threads()
{
  Random random(test_seed());
  return to_mesh(terrain(25, 20, random));
}

// Distances from a few sources that are different in each thread, and that others have, too.
template <typename GeodesicGraph>
Values distances_for_thread(const GeodesicGraph& graph, const std::size_t thread)
{
  Values result;
  for(const std::size_t source : {3 * thread, std::size_t(77), 13 + 20 * thread})
  {
    CGAL::Approximate_geodesics::Propagation<GeodesicGraph> search(graph);
    search.run_from(static_cast<typename GeodesicGraph::Node>(source));
    const Values found = distances_of_nodes(search);
    result.insert(result.end(), found.begin(), found.end());
    result.push_back(static_cast<double>(search.source(7)));
  }
  return result;
}

// The first thread uses the object, and the others its graph.
template <typename GeodesicGraph>
void expect_graph_to_be_shared(const Kind_of_graph<GeodesicGraph>& kind)
{
  using Paths = CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh, GeodesicGraph>;
  const Mesh mesh = mesh_for_threads();
  Random random(test_seed());
  const Face_location source = random_face_location(mesh, random);
  Paths paths(mesh, kind.make(Triangulation(mesh)));
  const auto ask = [&] {
    paths.remove_all_source_points();
    paths.add_source_point(source);
    Values result;
    for(const Vertex v : {Vertex(5), Vertex(499)})
    {
      std::vector<Point> points;
      result.push_back(
          paths.shortest_path_points_to_source_points(v, std::back_inserter(points)).first);
      result.push_back(paths.shortest_distance(v, source));
      result.push_back(static_cast<double>(points.size()));
    }
    return result;
  };
  expect_same_from_all_threads(
      [&](const std::size_t i) { return i == 0 ? ask() : distances_for_thread(paths.graph(), i); });
}

class Threads_with_a_mesh : public testing::Test
{
protected:
  auto map(Values& distances) const
  {
    distances.resize(m_mesh.number_of_vertices());
    return boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
  }

  static Vertex vertex(const std::size_t i) { return Vertex(static_cast<Mesh::size_type>(i)); }

  const Mesh m_mesh = mesh_for_threads();
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_SAME_FROM_ALL_THREADS_H
