// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_VISITOR_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_VISITOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Passes what happens to nodes on to a visitor of the mesh's vertices.
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

// a visitor that was given by reference
template <typename Visitor, typename Vertices>
Vertex_visitor<Visitor, Vertices> make_vertex_visitor(std::reference_wrapper<Visitor>& visitor,
                                                      const Vertices& vertices)
{
  return {visitor.get(), vertices};
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_VISITOR_H
