// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MAKE_SOLVER_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MAKE_SOLVER_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Directional_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Directional_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Steiner_graph.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Optional_points.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_graph.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_graph_of.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <istream>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

template <typename Graph>
std::unique_ptr<Solver_graph> solver_graph(Graph graph)
{
  return std::make_unique<Solver_graph_of<Graph>>(std::move(graph));
}

// The requested error bound.
struct Bound_of_graph
{
  std::optional<double> epsilon;
  bool accepts_weaker = false;
  std::size_t maximum_number_of_points = 0; // selects the default
};

// The Steiner points for a bound, or none.
template <typename Placement>
Optional_points<Placement> optional_points(const Bound_of_graph& bound)
{
  if(!bound.epsilon)
    return Optional_points<Placement>(std::nullopt);
  if(*bound.epsilon == 0)
    reject("epsilon is 0, but there are no exact distances with face weights, directional costs or "
           "barriers; give a number above 0");
  return Optional_points<Placement>(
      Placement(parameters::epsilon(*bound.epsilon).accept_weaker_bound(bound.accepts_weaker)));
}

// Returns the graph for a bound, or the edge graph if there is no bound. A saved graph is read.
inline std::unique_ptr<Solver_graph> make_solver_graph(Intrinsic_triangulation triangulation,
                                                       const Bound_of_graph& bound,
                                                       std::istream* const saved)
{
  if(triangulation.has_directional_costs())
  {
    using Points = Optional_points<Directional_points>;
    return solver_graph(Directional_graph<Points>(std::move(triangulation),
                                                  optional_points<Directional_points>(bound), false,
                                                  bound.maximum_number_of_points));
  }
  if(triangulation.has_weights() || triangulation.has_barriers())
  {
    using Points = Optional_points<Geometric_points>;
    return solver_graph(Steiner_graph<Points>(std::move(triangulation),
                                              optional_points<Geometric_points>(bound),
                                              bound.maximum_number_of_points));
  }
  if(!bound.epsilon)
    return solver_graph(Edge_graph(std::move(triangulation)));
  if(*bound.epsilon == 0)
    return solver_graph(Saddle_vertex_graph(std::move(triangulation)));
  if(saved != nullptr)
    return solver_graph(Discrete_geodesic_graph::load(*saved, std::move(triangulation)));
  return solver_graph(Discrete_geodesic_graph(
      std::move(triangulation),
      parameters::epsilon(*bound.epsilon).concurrency_tag(Parallel_if_available_tag())));
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MAKE_SOLVER_GRAPH_H
