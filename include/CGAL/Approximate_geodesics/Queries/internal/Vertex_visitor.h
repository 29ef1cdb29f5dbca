// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_VISITOR_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_VISITOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Adapts a visitor of vertices to a visitor of nodes.
 */
template <typename Visitor, typename Vertices>
class Vertex_visitor
{
public:
  Vertex_visitor(Visitor& visitor, const Vertices& vertices)
    : m_visitor(visitor), m_vertices(vertices)
  {
  }

  template <typename Node>
  void on_settled(const Node node, const double distance)
  {
    if(m_vertices.is_vertex(node))
      m_visitor.on_settled(m_vertices.vertex(node), distance);
  }

  void on_progress(const std::size_t number_of_settled_nodes, const std::size_t number_of_nodes)
  {
    m_visitor.on_progress(number_of_settled_nodes, number_of_nodes);
  }

  bool go_further() { return m_visitor.go_further(); }

private:
  Visitor& m_visitor;
  const Vertices& m_vertices;
};

template <typename Visitor, typename Vertices>
Vertex_visitor<Visitor, Vertices> make_vertex_visitor(Visitor& visitor, const Vertices& vertices)
{
  return {visitor, vertices};
}

// Overload for a visitor given by reference.
template <typename Visitor, typename Vertices>
Vertex_visitor<Visitor, Vertices> make_vertex_visitor(std::reference_wrapper<Visitor>& visitor,
                                                      const Vertices& vertices)
{
  return {visitor.get(), vertices};
}

// Calls `run` with the visitor of the named parameters, adapted to nodes, or with an idle visitor.
template <typename NamedParameters, typename Vertices, typename Run>
void run_with_visitor([[maybe_unused]] const NamedParameters& np,
                      [[maybe_unused]] const Vertices& vertices,
                      Run run)
{
  if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
  {
    auto visitor = parameters::get_parameter(np, internal_np::visitor);
    run(make_vertex_visitor(visitor, vertices));
  }
  else
    run(Geodesic_visitor_base());
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_VISITOR_H
