// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_GRAPH_WITH_LINES_H
#define APPROXIMATE_GEODESICS_TEST_GRAPH_WITH_LINES_H

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace geodesics_test {

// A graph and a run as the pages of their concepts ask for, which finds lines from labels.
template <typename Graph>
class Run_with_lines : public CGAL::Approximate_geodesics::Geodesic_run_base<Graph>
{
  using Base = CGAL::Approximate_geodesics::Geodesic_run_base<Graph>;

public:
  static constexpr bool attaches_by_labels = true;

  explicit Run_with_lines(const Graph& graph) : Base(graph) {}

  template <typename F>
  void for_each_line_from(const CGAL::Approximate_geodesics::Intrinsic_point& point,
                          double /* distance */,
                          F f) const
  {
    this->graph().attach(point).for_each_node(
        [&](const auto node, const double length) { f(node, length, typename Base::Payload()); });
  }

  template <typename Labels, typename OnNode, typename OnPoint>
  void for_each_line_to(const CGAL::Approximate_geodesics::Intrinsic_point& point,
                        double /* distance */,
                        const Labels& /* labels */,
                        const CGAL::Approximate_geodesics::Points_by_face& points,
                        OnNode on_node,
                        OnPoint on_point) const
  {
    this->graph().attach(point).for_each_node(on_node);
    this->graph().attach(point).for_each_point(points, on_point);
  }
};

class Graph_with_lines
{
public:
  using Node = std::uint32_t;
  using Run = Run_with_lines<Graph_with_lines>;

  static constexpr bool arcs_are_edges = true;

  template <typename NamedParameters>
  Graph_with_lines(CGAL::Approximate_geodesics::Intrinsic_triangulation triangulation,
                   const NamedParameters& np)
    : m_edges(std::move(triangulation), np)
  {
  }

  std::size_t number_of_nodes() const { return m_edges.number_of_nodes(); }
  double unit() const { return m_edges.unit(); }
  CGAL::Approximate_geodesics::Arc_lengths arc_lengths() const { return m_edges.arc_lengths(); }
  const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation() const
  {
    return m_edges.triangulation();
  }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    m_edges.for_each_arc(node, labels, f);
  }

  CGAL::Approximate_geodesics::Lines_in_faces
  attach(const CGAL::Approximate_geodesics::Intrinsic_point& point) const
  {
    return m_edges.attach(point);
  }

private:
  CGAL::Approximate_geodesics::Edge_graph m_edges;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_GRAPH_WITH_LINES_H
