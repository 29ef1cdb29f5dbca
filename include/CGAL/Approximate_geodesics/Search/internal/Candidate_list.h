// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CANDIDATE_LIST_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CANDIDATE_LIST_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/internal/Candidate.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/optional_members.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The paths along arcs that are shorter than labels say. Memory is kept when the list is cleared.
 */
template <typename Graph>
class Candidate_list
{
  using Node = Labels::Node;

public:
  using Candidate = Candidate_of<Graph>;

  std::size_t size() const { return m_size; }
  const Candidate& operator[](const std::size_t i) const { return m_memory[i]; }
  void clear() { m_size = 0; }

  std::size_t memory() const { return m_memory.capacity() * sizeof(Candidate); }

  // Looks at the arcs of a node that `visit(visitor)` visits: all are written down, and one that
  // does not lower the label of its end is overwritten by the next one. No branch depends on a
  // distance.
  template <typename Counter, typename Visit>
  void append(const Graph& graph,
              const Node node,
              const double* const distances, // labels
              const Counter& counter,
              const Visit& visit)
  {
    Candidate* end = end_with_room(graph);
    visit(Arc_visitor<Counter>{*this, graph, counter, distances, distances[node], node, end});
    m_size = static_cast<std::size_t>(end - m_memory.data());
  }

  // The same for several nodes, whose arcs the graph finds together.
  template <typename Counter, typename Labels>
  void append_together(const Graph& graph,
                       const Node* const nodes,
                       const std::size_t number,
                       const Labels& labels,
                       const Counter& counter)
  {
    Arc_writer<Counter> writer{*this, counter, labels.distances(), m_memory.data() + m_size};
    graph.append_arcs(nodes, number, labels, writer);
    m_size = static_cast<std::size_t>(writer.end - m_memory.data());
  }

private:
  template <typename Counter>
  struct Arc_writer
  {
    void make_room(const std::size_t number)
    {
      list.m_size = static_cast<std::size_t>(end - list.m_memory.data());
      end = list.end_with_room(number + 1); // one is written in vain
    }

    void append(const bool is_arc,
                const Node node,
                const double distance,
                const Node target,
                const double length)
    {
      counter.on_relaxations(is_arc ? 1 : 0);
      CGAL_assertion(end < list.m_memory.data() + list.m_memory.size());
      static_cast<internal::Candidate&>(*end) = {distance + length, target, node};
      end += static_cast<std::ptrdiff_t>(is_arc & (distance + length < distances[target]));
    }

    Candidate_list& list;
    const Counter& counter;
    const double* distances; // labels
    Candidate* end;
  };

  template <typename Counter>
  struct Arc_visitor
  {
    void operator()(const Node target, const double length) const
    {
      if constexpr(!has_maximum_degree<Graph>)
        end = list.with_room_at(end, graph);
      end = append(end, target, length);
    }

    // an arc that arrives in a certain way
    template <typename Arrival>
    void operator()(const Node target, const double length, const Arrival& arrival) const
    {
      Candidate* const position = list.with_room_at(end, graph);
      end = append(position, target, length);
      position->arrival = arrival;
    }

    // arcs to consecutive nodes
    void operator()(const Node first, const double* const lengths, const std::size_t number) const
    {
      if constexpr(!has_maximum_degree<Graph>)
        for(std::size_t i = 0; i < number; ++i)
          (*this)(first + static_cast<Node>(i), lengths[i]);
      else
      {
        Candidate* beyond = end; // kept in a register
        for(std::size_t i = 0; i < number; ++i)
          beyond = append(beyond, first + static_cast<Node>(i), lengths[i]);
        end = beyond;
      }
    }

    Candidate* append(Candidate* const position, const Node target, const double length) const
    {
      counter.on_relaxations(1);
      CGAL_assertion(position < list.m_memory.data() + list.m_memory.size());
      static_cast<internal::Candidate&>(*position) = {distance + length, target, node};
      return position + static_cast<std::ptrdiff_t>(position->distance < distances[target]);
    }

    Candidate_list& list;
    const Graph& graph;
    const Counter& counter;
    const double* distances; // labels
    double distance;
    Node node;
    Candidate*& end;
  };

  // Returns where the next candidates go. There is room for those of a node if the graph knows how
  // many these may be, or for one.
  Candidate* end_with_room([[maybe_unused]] const Graph& graph)
  {
    if constexpr(has_maximum_degree<Graph>)
      return end_with_room(graph.maximum_degree());
    else
      return end_with_room(std::size_t(1));
  }

  Candidate* end_with_room(const std::size_t room)
  {
    if(m_memory.size() < m_size + room)
      m_memory.resize(2 * (m_size + room));
    return m_memory.data() + m_size;
  }

  // Makes room for one more, which may move those that are there.
  Candidate* with_room_at(const Candidate* const end, const Graph& graph)
  {
    m_size = static_cast<std::size_t>(end - m_memory.data());
    return end_with_room(graph);
  }

  std::vector<Candidate> m_memory;
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CANDIDATE_LIST_H
