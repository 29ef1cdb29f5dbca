// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/failing_allocation.h"
#include "checks/graphs_of_all_kinds.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <vector>

// Objects that are asked again and again do not take more and more memory.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

struct Memory
{
  std::ptrdiff_t number_of_allocations;
  std::size_t bytes;
};

// One that is asked for paths and single pairs, from other sources each time.
template <typename GeodesicGraph>
class Questioner
{
public:
  explicit Questioner(const Kind_of_graph<GeodesicGraph>& kind)
    : m_mesh(to_mesh(terrain(6, 5, m_random))), m_paths(m_mesh, kind.make(Triangulation(m_mesh)))
  {
  }

  Memory ask(const std::size_t number_of_times)
  {
    for(std::size_t i = 0; i < number_of_times; ++i)
    {
      const Vertex source = random_vertex(m_mesh, m_random),
                   target = random_vertex(m_mesh, m_random);
      m_points.clear();
      m_paths.remove_all_source_points();
      m_paths.add_source_point(source);
      m_paths.shortest_path_points_to_source_points(target, std::back_inserter(m_points),
                                                    CGAL::parameters::straighten(true));
      m_paths.shortest_distance(target, source);
    }
    return {Allocations::number_alive(), m_paths.graph().memory() + m_paths.search().memory()};
  }

private:
  Random m_random = Random(test_seed());
  const Mesh m_mesh;
  AG::Surface_mesh_shortest_path<Mesh, GeodesicGraph> m_paths;
  std::vector<Point> m_points;
};

TEST(Repeated_queries, do_not_make_memory_grow)
{
  for_each_graph(0.2, [](const auto& kind) {
    Questioner questioner(kind);
    const Memory before = questioner.ask(100), after = questioner.ask(500);
    // arrays may still be doubled when a rare query comes, and no more
    EXPECT_LE(after.number_of_allocations, before.number_of_allocations + 10);
    EXPECT_LE(after.bytes, 2 * before.bytes);
  });
}

} // namespace
