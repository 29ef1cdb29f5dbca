// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_SEARCHES_OF_ARRAYS_H
#define BENCHMARK_SEARCHES_OF_ARRAYS_H

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

// Reference searches on the same adjacency arrays. Like the package, they keep their arrays between
// runs.

using CGAL::Approximate_geodesics::Intrinsic_triangulation;
using Index = Intrinsic_triangulation::Index;

// A lower bound on the run time of searches that visit every arc, in a straightforward
// implementation. It depends on branch prediction, and so on the mesh.
class Breadth_first_search
{
public:
  explicit Breadth_first_search(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation),
      m_level(triangulation.number_of_vertices()),
      m_queue(triangulation.number_of_vertices())
  {
  }

  void run_from(const Index source)
  {
    constexpr Index unseen = (std::numeric_limits<Index>::max)();
    std::fill(m_level.begin(), m_level.end(), unseen);
    std::size_t first = 0, beyond = 0;
    m_level[source] = 0;
    m_queue[beyond++] = source;
    while(first < beyond)
    {
      const Index v = m_queue[first++];
      const Index end = m_triangulation.beyond_halfedge(v);
      for(Index h = m_triangulation.first_halfedge(v); h < end; ++h)
      {
        const Index w = m_triangulation.target(h);
        if(m_level[w] == unseen)
        {
          m_level[w] = m_level[v] + 1;
          m_queue[beyond++] = w;
        }
      }
    }
  }

private:
  const Intrinsic_triangulation& m_triangulation;
  std::vector<Index> m_level;
  std::vector<Index> m_queue;
};

// The textbook implementation.
class Priority_queue_dijkstra
{
  using Entry = std::pair<double, Index>;

public:
  explicit Priority_queue_dijkstra(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation), m_distance(triangulation.number_of_vertices())
  {
  }

  void run_from(const Index source)
  {
    std::fill(m_distance.begin(), m_distance.end(), std::numeric_limits<double>::infinity());
    m_distance[source] = 0;
    m_queue.push({0, source});
    while(!m_queue.empty())
    {
      const auto [distance, v] = m_queue.top();
      m_queue.pop();
      if(m_distance[v] < distance)
        continue;
      const Index end = m_triangulation.beyond_halfedge(v);
      for(Index h = m_triangulation.first_halfedge(v); h < end; ++h)
      {
        const Index w = m_triangulation.target(h);
        const double candidate = distance + m_triangulation.length(h);
        if(candidate < m_distance[w])
        {
          m_distance[w] = candidate;
          m_queue.push({candidate, w});
        }
      }
    }
  }

  // In units of the triangulation.
  double distance(const Index v) const { return m_distance[v]; }

private:
  const Intrinsic_triangulation& m_triangulation;
  std::vector<double> m_distance;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

#endif // BENCHMARK_SEARCHES_OF_ARRAYS_H
