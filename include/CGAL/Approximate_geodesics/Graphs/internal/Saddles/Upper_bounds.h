// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_UPPER_BOUNDS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_UPPER_BOUNDS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * For each node, a number that its distance does not exceed, or above which the distance is of no
 * interest; infinity if there is none.
 */
class Upper_bounds
{
public:
  using Node = Intrinsic_triangulation::Index;

  explicit Upper_bounds(const std::size_t number_of_nodes) : m_bound(number_of_nodes, infinity) {}

  double operator[](const Node node) const { return m_bound[node]; }

  void lower(const Node node, const double bound)
  {
    m_bound[node] = (std::min)(m_bound[node], bound);
  }

  // Does the same before the search, and lists the node.
  void add(const Node node, const double bound)
  {
    lower(node, bound);
    m_nodes.push_back(node);
  }

  // the nodes whose bounds were found before the search
  const std::vector<Node>& nodes() const { return m_nodes; }

  void discard(const Node node) { m_bound[node] = infinity; }

  // Discards the bounds of these nodes, and of the listed ones.
  void forget(const std::vector<Node>& nodes)
  {
    if(nodes.size() + m_nodes.size() > m_bound.size() / 4) // streaming beats jumping
      return forget_all();
    for(const std::vector<Node>* list : {&nodes, &static_cast<const std::vector<Node>&>(m_nodes)})
      for(const Node node : *list)
        discard(node);
    m_nodes.clear();
  }

  void forget_all()
  {
    std::fill(m_bound.begin(), m_bound.end(), infinity);
    m_nodes.clear();
  }

  std::size_t memory() const
  {
    return m_bound.capacity() * sizeof(double) + m_nodes.capacity() * sizeof(Node);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::vector<double> m_bound;
  std::vector<Node> m_nodes;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_UPPER_BOUNDS_H
