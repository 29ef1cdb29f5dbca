// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_PORTAL_BUILDER_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_PORTAL_BUILDER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Portal_cover.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Portal_part.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Separators.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Two_way_arcs.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Workspaces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Divides a graph by nested separators, and chooses portals on them. Threads share the work on the
 * few large parts, and later take different parts; nothing depends on that.
 */
class Portal_builder
{
  using Node = Two_way_arcs::Node;

public:
  // The first nodes, so many, are vertices.
  Portal_builder(const Two_way_arcs& arcs,
                 const std::size_t number_of_vertices,
                 const double stretch,
                 const Loop& loop)
    : m_arcs(arcs),
      m_number_of_vertices(number_of_vertices),
      m_stretch(static_cast<float>(stretch)),
      m_loop(loop),
      m_scale(arcs.arc_lengths().longest),
      m_searches(arcs)
  {
  }

  const Portal_scale& scale() const { return m_scale; }

  // Returns the parts, each after its parent.
  std::vector<Portal_part> run()
  {
    std::vector<Portal_part> result;
    std::vector<Open_part> open, next;
    for(Part_nodes& nodes : connected_parts(m_arcs))
      add_open(std::move(nodes), Portal_part::no_parent, open);
    for(std::uint32_t depth = 0; !open.empty(); ++depth)
    {
      const std::size_t first = result.size();
      result.resize(first + open.size());
      const bool is_few = open.size() < FEW_PARTS;
      const Loop none, &outer = is_few ? none : m_loop, &inner = is_few ? m_loop : none;
      outer.run(open.size(), [&](const std::size_t i, std::size_t) {
        result[first + i].depth = depth;
        label(open[i], inner, result[first + i]);
      });
      next.clear();
      for(std::size_t i = 0; i < open.size(); ++i)
        for(Part_nodes& side : open[i].sides)
          add_open(std::move(side), static_cast<std::uint32_t>(first + i), next);
      open.swap(next);
    }
    return result;
  }

private:
  static constexpr std::size_t FEW_PARTS = 8;
  // Of vertices. Below, labels would take more memory than all distances.
  static constexpr std::size_t SIZE_OF_LAST_PART = 96;
  // Of vertices. Below, a part is not divided by a separator of more than a third of it.
  static constexpr std::size_t SIZE_TO_DIVIDE = 1024;

  struct Open_part
  {
    Part_nodes nodes;
    std::uint32_t parent;
    std::array<Part_nodes, 2> sides; // after it was divided
  };

  // Leaves out parts without vertices.
  void add_open(Part_nodes nodes, const std::uint32_t parent, std::vector<Open_part>& open) const
  {
    if(std::any_of(nodes.begin(), nodes.end(), [&](const Node n) { return is_vertex(n); }))
      open.push_back({std::move(nodes), parent, {}});
  }

  bool is_vertex(const Node node) const { return node < m_number_of_vertices; }

  void label(Open_part& open, const Loop& loop, Portal_part& part)
  {
    check_for_interruption();
    part.parent = open.parent;
    std::copy_if(open.nodes.begin(), open.nodes.end(), std::back_inserter(part.vertices),
                 [this](const Node n) { return is_vertex(n); });
    std::sort(part.vertices.begin(), part.vertices.end());
    Part_nodes separator;
    if(part.vertices.size() > SIZE_OF_LAST_PART)
      separator = divide(open, part.vertices.size());
    open.nodes = {};
    part.is_last = open.sides[0].empty() && open.sides[1].empty();
    if(part.is_last)
      tabulate(loop, part);
    else
      Portal_cover(m_searches, loop, m_scale, m_stretch, separator, part).run();
  }

  // Returns a separator, and sets the two sides; both stay empty if it is not worth it.
  Part_nodes divide(Open_part& open, const std::size_t number_of_vertices)
  {
    const auto search = m_searches.borrow();
    const std::size_t size = open.nodes.size();
    Separator separator(m_arcs, *search, std::move(open.nodes));
    if(number_of_vertices > SIZE_TO_DIVIDE || 3 * separator.nodes().size() < size)
      open.sides = {std::move(separator.side(0)), std::move(separator.side(1))};
    return std::move(separator.nodes());
  }

  // Finds the distances between all vertices of a last part.
  void tabulate(const Loop& loop, Portal_part& part)
  {
    const Part_nodes& vertices = part.vertices;
    part.size = vertices.size();
    part.table.resize(part.size * (part.size - 1) / 2);
    loop.run(part.size, [&](const std::size_t i, std::size_t) {
      check_for_interruption();
      const auto search = m_searches.borrow();
      const Part_nodes targets(vertices.begin(),
                               vertices.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      search->run({Seed{vertices[i]}}, Stop_rule{std::numeric_limits<double>::infinity(), targets});
      for(std::size_t j = 0; j < i; ++j)
        part.table[i * (i - 1) / 2 + j] = m_scale.stored(search->labels().distance(vertices[j]));
    });
  }

  const Two_way_arcs& m_arcs;
  std::size_t m_number_of_vertices;
  float m_stretch;
  const Loop& m_loop;
  Portal_scale m_scale;
  Workspaces<Two_way_search> m_searches;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_PORTAL_BUILDER_H
