// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_NODE_QUESTIONS_H
#define APPROXIMATE_GEODESICS_TEST_NODE_QUESTIONS_H

#include "checks/test_recorder.h"

#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_costs.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Questions to a workspace that has answered many: it must answer as a new object does, whatever it
// was asked before. What differs is returned as a text, so that tests and fuzzers can use it.

namespace geodesics_test {

// A number in [0, 1]. `choices` are random numbers, or what a fuzzer thinks up.
template <typename Choices>
double chosen_part(Choices& choices)
{
  constexpr std::size_t steps = 1024;
  return static_cast<double>(choices.below(steps + 1)) / steps;
}

template <typename Choices>
bool chosen(Choices& choices, const std::size_t one_in)
{
  return choices.below(one_in) == 0;
}

// Empty if two numbers have the same bits, or differ by at most a part of the first one.
inline std::string
difference(const char* what, const double found, const double expected, const double part = 0)
{
  if(found == expected || (found <= (1 + part) * expected && expected <= (1 + part) * found))
    return {};
  const auto text = [](const double x) {
    return CGAL::Approximate_geodesics::internal::text_of(x);
  };
  return std::string(what) + ": " + text(found) + " for " + text(expected);
}

// What is known of a graph and a queue.
struct Answer_kind
{
  double deviation = 0;              // relative, of distances that were found in another order
  double deviation_of_pairs = 0;     // the same for those that were found by other means
  bool keeps_order = true;           // whether the queue does not adapt to what was searched before
  bool has_initial_distances = true; // whether sources have some
};

/*
 * Questions to a search of a graph about nodes. Arcs of the graph may change between two questions.
 */
template <typename Search>
class Node_questions
{
  using Graph = typename Search::Graph;
  using Node = typename Search::Node;
  using Seeds = std::vector<typename Search::Seed>;
  using Stop_rule = typename Search::Stop_rule;

  static constexpr double unreached = std::numeric_limits<double>::infinity();

public:
  Node_questions(const Graph& graph, const Answer_kind& kind)
    : m_graph(graph), m_used(graph), m_kind(kind)
  {
  }

  // Asks a question of any kind, and returns what differs.
  template <typename Choices>
  std::string ask(Choices& choices)
  {
    switch(choices.below(7))
    {
    case 0:
      return about_all(choices);
    case 1:
      return about_targets(choices);
    case 2:
      return with_visitor(choices);
    case 3:
    case 4:
      return with_heuristic(choices);
    case 5:
      return about_more(choices);
    default:
      return about_rest(choices);
    }
  }

private:
  // Asks for results in the middle of a run.
  struct Asking_recorder : Recorder<Node>
  {
    Asking_recorder(const Recorder<Node>& recorder, const Search& the_search)
      : Recorder<Node>(recorder), search(the_search)
    {
    }

    void on_settled(const Node settled_node, const double distance)
    {
      constexpr std::size_t turn = 7;
      if(this->settled.size() % turn == 3)
      {
        search.predecessor(settled_node);
        search.source(settled_node);
      }
      Recorder<Node>::on_settled(settled_node, distance);
    }

    const Search& search;
  };

  template <typename Choices>
  Node node(Choices& choices) const
  {
    return static_cast<Node>(choices.below(m_graph.number_of_nodes()));
  }

  template <typename Choices>
  Seeds seeds(Choices& choices) const
  {
    Seeds result;
    for(std::size_t i = chosen(choices, 16) ? 0 : 1 + choices.below(3); i > 0; --i)
      result.push_back(
          {node(choices),
           m_kind.has_initial_distances && chosen(choices, 2) ? chosen_part(choices) : 0, i});
    return result;
  }

  // Those at nodes that paths lead through. Where there is a label already, others are no starts.
  Seeds through_nodes(Seeds all) const
  {
    CGAL::Approximate_geodesics::internal::Labels labels(m_graph.number_of_nodes());
    const auto is_dead_end = [&](const typename Search::Seed& seed) {
      bool result = true;
      const auto on_arcs = [&](auto&&...) { result = false; };
      labels.set(seed.node, 0, seed.node); // reached from somewhere
      m_graph.for_each_arc(seed.node, labels, on_arcs);
      labels.discard(seed.node);
      return result;
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_dead_end), all.end());
    return all;
  }

  template <typename Choices>
  Stop_rule limit(Choices& choices) const
  {
    return {chosen(choices, 2) ? unreached : 4 * chosen_part(choices), {}, {}};
  }

  template <typename Choices>
  std::string about_all(Choices& choices)
  {
    const Seeds s = seeds(choices);
    const Stop_rule stop = limit(choices);
    Search fresh(m_graph);
    m_used.run(s, stop, no_visitor);
    fresh.run(s, stop, no_visitor);
    return compare_all(fresh);
  }

  template <typename Choices>
  std::string about_targets(Choices& choices)
  {
    const Seeds s = seeds(choices);
    Stop_rule stop = limit(choices);
    stop.targets = {node(choices), node(choices)};
    Search fresh(m_graph);
    m_used.run(s, stop, no_visitor);
    fresh.run(s, stop, no_visitor);
    std::string result = m_kind.keeps_order ? compare_all(fresh) : std::string();
    for(const Node target : stop.targets)
      result += compare(fresh, target);
    return result;
  }

  // One that stops the run, or throws.
  template <typename Choices>
  std::string with_visitor(Choices& choices)
  {
    const Seeds s = seeds(choices);
    const Stop_rule stop = limit(choices);
    const std::size_t last = choices.below(m_graph.number_of_nodes() + 1);
    Recorder<Node> recorder;
    (chosen(choices, 2) ? recorder.throw_at : recorder.stop_at) = last;
    Search fresh(m_graph);
    const auto run = [&](Search& search) {
      Recorder<Node> visitor = recorder;
      search.run(s, stop, visitor);
    };
    const bool has_thrown = throws(
        [&](Search& search) {
          Asking_recorder visitor{recorder, search};
          search.run(s, stop, visitor);
        },
        m_used);
    std::string result = has_thrown == throws(run, fresh) ? "" : "another one has thrown; ";
    return result + (has_thrown || m_kind.keeps_order ? compare_all(fresh) : std::string());
  }

  // Lower bounds of any kind that are not consistent: parts of the distances. They may throw, too.
  template <typename Choices>
  std::string with_heuristic(Choices& choices)
  {
    const Seeds s = seeds(choices);
    Stop_rule stop = limit(choices);
    const Node target = node(choices);
    stop.targets = {target};
    const std::vector<double> bounds = bounds_to(target, choices);
    const std::size_t most = chosen(choices, 4) ? choices.below(60) : Recorder<Node>::never;
    const auto run = [&](Search& search) {
      std::size_t number = 0;
      search.run_toward(s, stop, [&](const Node n) {
        if(number++ == most)
          throw std::runtime_error("from the heuristic");
        return bounds[n];
      });
    };
    Search fresh(m_graph), unguided(m_graph);
    if(throws(run, m_used))
      return all_is_unreached();
    const bool has_thrown = throws(run, fresh); // if it expands more nodes
    std::string result = !has_thrown          ? compare(fresh, target)
                         : m_kind.keeps_order ? "a new one has thrown; "
                                              : "";
    unguided.run(s, stop, no_visitor);
    return result + difference("without heuristic", m_used.distance(target),
                               unguided.distance(target), m_kind.deviation);
  }

  // More seeds, and a repair, which continue the last run.
  template <typename Choices>
  std::string about_more(Choices& choices)
  {
    Seeds s = through_nodes(seeds(choices));
    if(chosen(choices, 2))
      m_used.repair(s);
    else
    {
      m_used.run(s);
      const Seeds more = through_nodes(seeds(choices));
      m_used.run_further(more);
      s.insert(s.end(), more.begin(), more.end());
    }
    Search fresh(m_graph);
    fresh.run(s);
    return compare_distances(fresh);
  }

  // A part of the labels, all of whose nodes are open.
  template <typename Choices>
  std::string about_rest(Choices& choices)
  {
    const Seeds s = through_nodes(seeds(choices));
    Search part(m_graph), fresh(m_graph);
    fresh.run(s);
    if constexpr(!CGAL::Approximate_geodesics::internal::has_own_run<Graph>)
    {
      part.run(s, {2 + 2 * chosen_part(choices), {}, {}}, no_visitor);
      m_used.resume([&](const auto& set) {
        for(Node n = 0; n < m_graph.number_of_nodes(); ++n)
          if(part.is_reached(n))
            set(n, part.distance(n), part.predecessor(n), true);
      });
    }
    else
      m_used.run(s);
    return compare_distances(fresh);
  }

  // ----- answers

  std::string compare(const Search& fresh, const Node n) const
  {
    const std::size_t source = m_used.source(n), expected = fresh.source(n);
    std::string result = difference("distance", m_used.distance(n), fresh.distance(n),
                                    m_kind.keeps_order ? 0 : m_kind.deviation);
    if(m_kind.keeps_order ? source != expected
                          : (source == Search::null_source) != (expected == Search::null_source))
      result += "source: " + std::to_string(source) + " for " + std::to_string(expected);
    if(m_kind.keeps_order && m_used.predecessor(n) != fresh.predecessor(n))
      result += "predecessor: " + std::to_string(m_used.predecessor(n));
    return result.empty() ? result : "node " + std::to_string(n) + ": " + result + "; ";
  }

  std::string compare_all(const Search& fresh) const
  {
    std::string result;
    for(Node n = 0; n < m_graph.number_of_nodes(); ++n)
      result += compare(fresh, n);
    return result;
  }

  std::string compare_distances(const Search& fresh) const
  {
    std::string result;
    for(Node n = 0; n < m_graph.number_of_nodes(); ++n)
      result += difference("distance", m_used.distance(n), fresh.distance(n), m_kind.deviation);
    return result;
  }

  std::string all_is_unreached() const
  {
    return m_used.reached_nodes().empty() ? compare_all(Search(m_graph))
                                          : "nodes are reached after an exception; ";
  }

  static bool throws(const std::function<void(Search&)>& run, Search& search)
  {
    try
    {
      run(search);
      return false;
    }
    catch(const std::runtime_error&)
    {
      return true;
    }
  }

  template <typename Choices>
  std::vector<double> bounds_to(const Node target, Choices& choices) const
  {
    const bool are_consistent = chosen(choices, 3);
    const double common_part = chosen_part(choices);
    std::vector<double> result;
    Search search(m_graph);
    for(Node n = 0; n < m_graph.number_of_nodes(); ++n)
    {
      search.run({{n}}, {unreached, {target}, {}}, no_visitor);
      const double part = are_consistent ? common_part : chosen_part(choices);
      result.push_back(part > 0 ? part * search.labels().distance(target) : 0);
    }
    return result;
  }

  static inline CGAL::Approximate_geodesics::Geodesic_visitor_base no_visitor;

  const Graph& m_graph;
  Search m_used;
  Answer_kind m_kind;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_NODE_QUESTIONS_H
