// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_SIGHT_COUNTING_GRAPH_H
#define BENCHMARK_SIGHT_COUNTING_GRAPH_H

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Face_steps.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Saddle_run.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Vertex_sights.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <utility>

// A saddle vertex graph that counts windows. It finds the same arcs in the same order. The counters
// allow one search at a time only.
class Sight_counting_graph : public CGAL::Approximate_geodesics::Saddle_vertex_graph
{
public:
  explicit Sight_counting_graph(CGAL::Approximate_geodesics::Intrinsic_triangulation triangulation)
    : Saddle_vertex_graph(std::move(triangulation)),
      m_steps(this->triangulation()),
      m_bends(this->triangulation(), m_steps)
  {
  }

  // Since construction.
  std::size_t number_of_sights() const { return m_number_of_sights; }

  class Run : public Saddle_vertex_graph::Run
  {
  public:
    explicit Run(const Sight_counting_graph& graph)
      : Saddle_vertex_graph::Run(graph), m_graph(&graph)
    {
    }

    template <typename Labels, typename Candidates>
    void expand(const Node* const nodes,
                const std::size_t number,
                const Labels& labels,
                Candidates& candidates)
    {
      for(const Node* node = nodes; node != nodes + number; ++node)
        m_graph->for_each_arc(*node, Known<Labels>{*this, labels},
                              [&](const Node target, const double length, const auto& arrival) {
                                candidates.make_room(1);
                                candidates.append(true, *node, labels.distance(*node), target,
                                                  length, arrival);
                              });
    }

  private:
    const Sight_counting_graph* m_graph;
  };

  template <typename Known, typename F>
  void for_each_arc(const Node node, const Known& known, F f) const
  {
    namespace internal = CGAL::Approximate_geodesics::internal;
    Visitor<Known, F> visitor{{{}, known, f}, m_number_of_sights};
    internal::Sight_expansion<Visitor<Known, F>> expansion(m_steps, m_bends, known.label(node),
                                                           visitor);
    internal::Vertex_sights(triangulation(), m_steps, m_bends)
        .for_each(
            node, known.arrival(node),
            [&](const Node h) {
              f(triangulation().target(h), triangulation().length(h), internal::Arrival::along(h));
            },
            [&](const internal::Sight& sight, const Node left_end, const Node right_end) {
              expansion.look(sight, left_end, right_end);
            });
  }

private:
  template <typename Known, typename F>
  struct Visitor : CGAL::Approximate_geodesics::internal::Arc_visitor<Known, F>
  {
    static constexpr bool wants_sights = true;

    void on_sight(const CGAL::Approximate_geodesics::internal::Sight&) { ++number_of_sights; }

    std::size_t& number_of_sights;
  };

  CGAL::Approximate_geodesics::internal::Face_steps m_steps;
  CGAL::Approximate_geodesics::internal::Bends m_bends;
  mutable std::size_t m_number_of_sights = 0;
};

#endif // BENCHMARK_SIGHT_COUNTING_GRAPH_H
