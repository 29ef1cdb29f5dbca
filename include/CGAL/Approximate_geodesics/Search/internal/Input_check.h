// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_INPUT_CHECK_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_INPUT_CHECK_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_rules.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Rejects what cannot be searched on a graph of this size and unit.
class Input_check
{
public:
  Input_check(const std::size_t number_of_nodes, const double unit)
    : m_number_of_nodes(number_of_nodes), m_unit(unit)
  {
  }

  void check(const std::vector<Seed>& seeds, const Stop_rule& stop) const
  {
    for(const Seed& seed : seeds)
    {
      check_node(seed.node, "source");
      const double distance = seed.distance / m_unit; // overflows if the mesh is tiny
      if(!(distance >= 0) || std::isinf(distance))
        reject("the distance that source node " + std::to_string(seed.node) + " starts with is " +
               text_of(seed.distance) +
               "; it must be a finite number that is not negative, nor out of proportion to the "
               "mesh");
    }
    for(const std::size_t target : stop.targets)
      check_node(target, "target");
    for(const std::vector<Last_arc>& arcs : stop.points)
      for(const Last_arc& arc : arcs)
        check_node(arc.node, "target");
    if(!(stop.maximum_distance >= 0))
      reject("the maximum distance is " + text_of(stop.maximum_distance) +
             "; it must be a number that is not negative");
  }

private:
  void check_node(const std::size_t node, const char* role) const
  {
    if(node >= m_number_of_nodes)
      reject(std::string(role) + " node " + std::to_string(node) + " does not exist: there are " +
             std::to_string(m_number_of_nodes) + " nodes");
  }

  std::size_t m_number_of_nodes;
  double m_unit;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_INPUT_CHECK_H
