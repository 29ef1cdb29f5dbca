// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_LAZY_GRAPHS_H
#define BENCHMARK_LAZY_GRAPHS_H

#include "peers/Label_pruning.h"

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_front.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

// Knows which nodes a search has expanded before, and has several of them expanded together.
template <typename Graph>
class Run_with_history : public CGAL::Approximate_geodesics::Geodesic_run_base<Graph>
{
  using Base = CGAL::Approximate_geodesics::Geodesic_run_base<Graph>;

public:
  using Node = typename Base::Node;
  using Base::Base;

  template <typename Search>
  void start(Search& /* search */)
  {
    m_is_expanded.assign(this->graph().number_of_nodes(), false);
  }

  template <typename Labels, typename Candidates>
  void expand(const Node* const nodes,
              const std::size_t number,
              const Labels& labels,
              Candidates& candidates)
  {
    constexpr std::size_t nodes_at_a_time = 32;
    for(std::size_t i = 0; i < number; i += nodes_at_a_time)
      this->graph().append_arcs(nodes + i, (std::min)(nodes_at_a_time, number - i), m_is_expanded,
                                labels, candidates);
    for(std::size_t i = 0; i < number; ++i)
      m_is_expanded[nodes[i]] = true;
  }

private:
  std::vector<bool> m_is_expanded;
};

// A lazy graph that expands cones depth first. Pruning by geometry and pruning by labels use the
// same share of epsilon.
template <bool COUNTS>
class Cones_in_turn
{
public:
  using Triangulation = CGAL::Approximate_geodesics::Intrinsic_triangulation;
  using Node = Triangulation::Index;
  using Run = Run_with_history<Cones_in_turn>;

  Cones_in_turn(Triangulation triangulation, const double epsilon)
    : m_triangulation(std::move(triangulation)), m_unfolding(m_triangulation), m_rules(epsilon)
  {
  }

  const Triangulation& triangulation() const { return m_triangulation; }
  std::size_t number_of_nodes() const { return m_triangulation.number_of_vertices(); }
  double unit() const { return m_triangulation.unit(); }
  CGAL::Approximate_geodesics::Arc_lengths arc_lengths() const
  {
    return CGAL::Approximate_geodesics::summarize_arc_lengths(m_triangulation.lengths());
  }
  void prefetch(const Node node) const
  {
    m_triangulation.prefetch(m_triangulation.first_halfedge(node));
  }

  template <typename Labels, typename Arcs>
  void append_arcs(const Node* const nodes,
                   const std::size_t number,
                   const std::vector<bool>& is_expanded,
                   const Labels& labels,
                   Arcs& arcs) const
  {
    const Expansion expansion(m_triangulation, m_unfolding, m_rules);
    for(const Node* node = nodes; node != nodes + number; ++node)
    {
      const double label = labels.distance(*node);
      const auto report = [&](const auto& arc) {
        arcs.make_room(1);
        arcs.append(true, *node, label, arc.target, arc.length);
      };
      if(is_expanded[*node])
        expansion.expand(*node, report, Counting_windows<COUNTS>(m_count));
      else
        expansion.expand(*node, report,
                         Label_pruning<COUNTS, Labels>(m_triangulation, labels, label,
                                                       m_rules.longest_detour, m_count));
    }
  }

  // Windows visited by searches.
  std::size_t number_of_windows() const { return m_count.number(); }

private:
  using Unfolding = CGAL::Approximate_geodesics::internal::Unfolding;
  using Expansion = CGAL::Approximate_geodesics::internal::Cone_expansion<Unfolding>;

  Triangulation m_triangulation;
  Unfolding m_unfolding;
  CGAL::Approximate_geodesics::internal::Cone_rules m_rules;
  Window_count<COUNTS> m_count;
};

// The lazy graph of the package with counters, which allow one search at a time only.
class Counted_cones_together : public CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph
{
public:
  using Run = Run_with_history<Counted_cones_together>;

  Counted_cones_together(CGAL::Approximate_geodesics::Intrinsic_triangulation triangulation,
                         const double epsilon)
    : Lazy_discrete_geodesic_graph(std::move(triangulation), CGAL::parameters::epsilon(epsilon)),
      m_unfolding(this->triangulation())
  {
  }

  template <typename Labels, typename Arcs>
  void append_arcs(const Node* const nodes,
                   const std::size_t number,
                   const std::vector<bool>& is_expanded,
                   const Labels& labels,
                   Arcs& arcs) const
  {
    using CGAL::Approximate_geodesics::internal::Cone_front;
    std::vector<Node> together;
    for(std::size_t i = 0; i < number; ++i)
      if(const Node node = nodes[i]; is_expanded[node])
        expand_again(node, labels, arcs);
      else
      {
        together.push_back(node);
        m_number_of_first_faces +=
            triangulation().beyond_halfedge(node) - triangulation().first_halfedge(node);
      }
    const auto expand = [&](auto is_general) {
      Cone_front<is_general, Counting_unfolding, Labels, Arcs>(triangulation(), m_unfolding,
                                                               epsilon(), labels, arcs, m_memory)
          .expand(together.data(), together.size());
    };
    if(CGAL::Approximate_geodesics::internal::needs_general_front(triangulation()))
      expand(std::true_type());
    else
      expand(std::false_type());
  }

  // Windows visited by searches.
  std::size_t number_of_windows() const
  {
    return m_unfolding.count.number() - m_number_of_first_faces + m_count.number();
  }

private:
  using Unfolding = CGAL::Approximate_geodesics::internal::Unfolding;

  // Counts the visited faces: those around a node, and the face behind each window.
  struct Counting_unfolding : Unfolding
  {
    using Unfolding::Unfolding;

    decltype(auto) operator[](const Node h) const
    {
      count.add(1);
      return Unfolding::operator[](h);
    }

    Window_count<true> count;
  };

  template <typename Labels, typename Arcs>
  void expand_again(const Node node, const Labels& labels, Arcs& arcs) const
  {
    using namespace CGAL::Approximate_geodesics::internal;
    const Unfolding& unfolding = m_unfolding;
    const Cone_rules rules =
        Cone_rules(epsilon()).farther(Cone_rules::share_of_ends_beside_labels(epsilon()));
    Cone_expansion<Unfolding>(triangulation(), unfolding, rules)
        .expand(
            node,
            [&](const Straight_arc& arc) {
              arcs.make_room(1);
              arcs.append(true, node, labels.distance(node), arc.target, arc.length);
            },
            Counting_windows<true>(m_count));
  }

  Counting_unfolding m_unfolding;
  Window_count<true> m_count;
  mutable std::size_t m_number_of_first_faces = 0;
  mutable CGAL::Approximate_geodesics::internal::Front_memory m_memory;
};

#endif // BENCHMARK_LAZY_GRAPHS_H
