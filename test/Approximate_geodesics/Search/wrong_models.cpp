// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A graph and a queue that are right, unless a macro makes one of them wrong: see
// `wrong_models.cmake`.

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <array>
#include <cstddef>
#include <cstdint>

class Graph
{
public:
#if defined(WRONG_NODE)
  using Node = std::size_t;
#else
  using Node = std::uint32_t;
#endif

#if defined(WRONG_NUMBER_OF_NODES)
  std::size_t number_of_nodes(); // not const
#else
  std::size_t number_of_nodes() const;
#endif

#if !defined(WRONG_UNIT)
  double unit() const;
#endif

#if defined(WRONG_ARC_LENGTHS)
  double arc_lengths() const;
#else
  CGAL::Approximate_geodesics::Arc_lengths arc_lengths() const;
#endif

#if defined(WRONG_FOR_EACH_ARC)
  template <typename F>
  void for_each_arc(Node node, F f) const; // knows nothing of labels
#else
  template <typename Labels, typename F>
  void for_each_arc(Node, const Labels&, F) const
  {
  }
#endif
};

#if defined(WRONG_ENTRY)
struct Entry
{
  std::uint32_t node;
  double key;
};
#else
struct Entry
{
  double key;
  std::uint32_t node;
};
#endif

class Queue
{
public:
#if !defined(WRONG_CONSTRUCTOR)
  Queue(std::size_t number_of_nodes, const CGAL::Approximate_geodesics::Arc_lengths& arcs);
#endif

#if defined(WRONG_PUSH)
  void push(double key, std::uint32_t node);
#else
  void push(std::uint32_t node, double key);
#endif

#if defined(WRONG_EXTRACT_MIN)
  Entry pop();
#elif defined(WRONG_BATCH)
  Entry extract_min();
#else
  std::array<Entry, 1> extract_min();
#endif

#if !defined(WRONG_IS_EMPTY)
  bool is_empty() const;
#endif

#if defined(WRONG_IS_FINAL)
  bool is_final(std::uint32_t node) const;
#else
  bool is_final(double key) const;
#endif

#if !defined(WRONG_FOR_EACH_NODE)
  template <typename F>
  void for_each_node(F) const
  {
  }
#endif

#if !defined(WRONG_CLEAR)
  void clear();
#endif

#if !defined(WRONG_MEMORY)
  std::size_t memory() const;
#endif
};

void search(const Graph& graph)
{
  CGAL::Approximate_geodesics::Propagation<Graph, Queue> propagation(graph);
  propagation.run_from(0);
}
