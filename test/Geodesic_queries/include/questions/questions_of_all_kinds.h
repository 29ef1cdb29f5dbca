// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_QUESTIONS_OF_ALL_KINDS_H
#define APPROXIMATE_GEODESICS_TEST_QUESTIONS_OF_ALL_KINDS_H

#include "checks/test_random.h"
#include "grids/cells.h"
#include "meshes/test_costs.h"
#include "meshes/test_meshes.h"
#include "meshes/test_weights.h"
#include "oracles/One_way_graph.h"
#include "questions/Node_questions.h"
#include "questions/Surface_questions.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Geodesic_costs.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Graphs of all kinds, and questions to workspaces for them.

namespace geodesics_test {

using CGAL::Approximate_geodesics::Intrinsic_point;

// A small mesh, with parts that cannot be reached or many paths of the same length now and then.
template <typename Choices>
Mesh chosen_mesh(Choices& choices)
{
  Random random(choices.below(60000));
  const std::size_t columns = 3 + choices.below(4), rows = 3 + choices.below(4);
  switch(choices.below(6))
  {
  case 0:
    return to_mesh(scattered_parts(random));
  case 1:
    return to_mesh(flat_grid(columns, rows));
  case 2:
    return to_mesh(fan(columns + rows));
  default:
    return to_mesh(terrain(columns, rows, random));
  }
}

/*
 * Asks questions about a mesh, for each kind of graph to two workspaces: one with an ordered queue,
 * whose answers have the same bits, and one with the default queue, which adapts to earlier runs.
 * `on_answer(kind, difference)` is called for each answer.
 */
template <typename Choices, typename OnAnswer>
class Questions_of_all_kinds
{
  template <typename Graph>
  using Search = CGAL::Approximate_geodesics::Guided_search<Graph>;
  template <typename Graph>
  using Ordered_search =
      CGAL::Approximate_geodesics::Guided_search<Graph,
                                                 CGAL::Approximate_geodesics::Binary_heap_queue>;
  using Steiner = Steiner_graph<Fixed_number_of_points>;

public:
  static constexpr std::size_t number_of_kinds = 8;

  Questions_of_all_kinds(Choices& choices, const OnAnswer& on_answer)
    : m_choices(choices), m_on_answer(on_answer)
  {
  }

  // Asks so many questions about a graph of this kind, to each workspace.
  void ask(const std::size_t kind, const Mesh& mesh, const std::size_t number)
  {
    const auto epsilon = CGAL::parameters::epsilon(0.3);
    switch(kind)
    {
    case 0:
      return ask("edge graph", mesh, Graph(Triangulation(mesh)), {}, number);
    case 1:
      return ask("discrete geodesic graph", mesh,
                 CGAL::Approximate_geodesics::Discrete_geodesic_graph(Triangulation(mesh), epsilon),
                 {}, number);
    case 2:
      return ask(
          "lazy graph", mesh,
          CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph(Triangulation(mesh), epsilon),
          {0.3, 0.3}, number);
    case 3:
      return ask("saddle vertex graph", mesh,
                 CGAL::Approximate_geodesics::Saddle_vertex_graph(Triangulation(mesh)),
                 {1e-12, 1e-9}, number);
    case 4:
      return ask_with_barriers(mesh, number);
    case 5:
      return ask_with_directions(mesh, number);
    case 6:
      return ask_with_one_way_arcs(mesh, number);
    default:
      return ask_on_grid(number);
    }
  }

private:
  void ask_with_barriers(const Mesh& mesh, const std::size_t number)
  {
    Weights weights(mesh.num_faces(), 1);
    Barriers barriers(mesh.num_edges());
    const bool has_weights = chosen(m_choices, 2);
    for(double& w : weights)
      w = has_weights ? weight() : 1;
    for(std::size_t i = 0; i < barriers.size(); ++i)
      barriers[i] = chosen(m_choices, 4);
    Triangulation t =
        has_weights
            ? Triangulation(mesh,
                            with_weights(weights).edge_is_constrained_map(barrier_map(barriers)))
            : Triangulation(mesh, with_barriers(barriers));
    std::vector<Node> doors;
    for(Node h = 0; h < t.number_of_halfedges(); ++h)
      if(t.is_barrier(h))
        doors.push_back(h);
    Steiner graph(std::move(t), Fixed_number_of_points(m_choices.below(3)));
    ask("Steiner graph with barriers", mesh, graph, {1e-13, 1e-13, true, false}, number, [&] {
      const auto h =
          static_cast<Node>(m_choices.below(graph.triangulation().number_of_halfedges()));
      if(!doors.empty() && chosen(m_choices, 2))
        graph.set_barriers({{doors[m_choices.below(doors.size())], chosen(m_choices, 2)}});
      else if(has_weights && !graph.triangulation().is_border(h))
        graph.set_weights({{h, weight()}});
    });
  }

  void ask_with_directions(const Mesh& mesh, const std::size_t number)
  {
    Random random(m_choices.below(1000));
    const auto slants = random_slants(mesh, random, 0.8);
    const Barriers barriers = random_barriers(mesh, 0.2, random);
    const auto cost = cost_of_faces(slants);
    const Dense_graph graph(
        Triangulation(mesh, with_cost(cost).edge_is_constrained_map(barrier_map(barriers))),
        Fixed_number_of_points(1));
    const Answer_kind kind{1e-13, 1e-13, true, false};
    if(chosen(m_choices, 2))
      ask("directional graph", mesh, graph, kind, number);
    else
      ask("reversed directional graph", mesh, graph.reversed(), kind, number);
  }

  void ask_with_one_way_arcs(const Mesh& mesh, const std::size_t number)
  {
    const double asymmetry = chosen(m_choices, 2) ? std::numeric_limits<double>::infinity() : 0;
    ask("graph with one-way arcs", mesh, One_way_graph(Triangulation(mesh), asymmetry, m_choices),
        {0, 0, true, false}, number);
  }

  void ask_on_grid(const std::size_t number)
  {
    const Grid_shape shape{5, 4, 1, 1, {}};
    Random random(m_choices.below(1000));
    const Grid_graph graph(shape, random_friction(random, shape));
    ask_about_nodes("grid", graph, {}, number, [] {});
  }

  double weight()
  {
    return chosen(m_choices, 8)   ? 0
           : chosen(m_choices, 8) ? std::numeric_limits<double>::infinity()
                                  : 0.5 + chosen_part(m_choices);
  }

  template <typename Graph>
  void ask(const char* name,
           const Mesh& mesh,
           const Graph& graph,
           const Answer_kind& kind,
           const std::size_t number)
  {
    ask(name, mesh, graph, kind, number, [] {});
  }

  // Asks about points, and about nodes if their distances do not depend on the search. Calls
  // `change()` now and then, which may change arcs.
  template <typename Graph, typename Change>
  void ask(const char* name,
           const Mesh& mesh,
           const Graph& graph,
           const Answer_kind& kind,
           const std::size_t number,
           const Change& change)
  {
    if constexpr(CGAL::Approximate_geodesics::internal::has_asymmetry<Graph>)
      ask_about_nodes(name, graph, kind, number / 2, change);
    const auto positions = positions_of(mesh, graph.triangulation());
    Answer_kind adapting = kind;
    adapting.keeps_order = false;
    Surface_questions<Ordered_search<Graph>> ordered(graph, points(graph), positions, kind);
    Surface_questions<Search<Graph>> others(graph, points(graph), positions, adapting);
    for(std::size_t i = 0; i < number; ++i)
    {
      if(chosen(m_choices, 16))
        change();
      if(chosen(m_choices, 24))
      {
        ordered.prepare(1 + m_choices.below(4));
        others.prepare(1 + m_choices.below(4));
      }
      m_on_answer(name, ordered.ask(m_choices));
      m_on_answer(name, others.ask(m_choices));
    }
  }

  template <typename Graph, typename Change>
  void ask_about_nodes(const char* name,
                       const Graph& graph,
                       const Answer_kind& kind,
                       const std::size_t number,
                       const Change& change)
  {
    using CGAL::Approximate_geodesics::Binary_heap_queue;
    using CGAL::Approximate_geodesics::Propagation;
    Answer_kind adapting = kind;
    adapting.keeps_order = false;
    Node_questions<Propagation<Graph, Binary_heap_queue>> ordered(graph, kind);
    Node_questions<Propagation<Graph>> others(graph, adapting);
    for(std::size_t i = 0; i < number; ++i)
    {
      if(chosen(m_choices, 16))
        change();
      m_on_answer(name, ordered.ask(m_choices));
      m_on_answer(name, others.ask(m_choices));
    }
  }

  template <typename Graph>
  std::vector<Intrinsic_point> points(const Graph& graph)
  {
    const Triangulation& t = graph.triangulation();
    std::vector<Intrinsic_point> result;
    for(Node v = 0; v < t.number_of_vertices(); ++v)
      result.push_back(Intrinsic_point::at_vertex(v));
    for(std::size_t i = 0; i < t.number_of_vertices() / 2; ++i)
    {
      const auto h = static_cast<Node>(m_choices.below(t.number_of_halfedges()));
      const double part = 0.1 + 0.4 * chosen_part(m_choices);
      result.push_back(t.is_border(h) || chosen(m_choices, 2)
                           ? Intrinsic_point::on_edge(h, part)
                           : Intrinsic_point::in_face(h, part, part / 2));
    }
    return result;
  }

  static CGAL::Approximate_geodesics::Vertex_positions positions_of(const Mesh& mesh,
                                                                    const Triangulation& t)
  {
    using CGAL::Approximate_geodesics::Vertex_positions;
    return Vertex_positions(t, [&](const Node v) {
      const Point& p = mesh.point(Vertex(static_cast<Mesh::size_type>(t.index(v))));
      return Vertex_positions::Position{p.x(), p.y(), p.z()};
    });
  }

  Choices& m_choices;
  const OnAnswer& m_on_answer;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_QUESTIONS_OF_ALL_KINDS_H
