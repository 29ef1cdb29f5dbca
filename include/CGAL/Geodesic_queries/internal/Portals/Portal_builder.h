// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_BUILDER_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_BUILDER_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Geodesic_queries/internal/Portals/Portal_cover.h>
#include <CGAL/Geodesic_queries/internal/Portals/Portal_part.h>
#include <CGAL/Geodesic_queries/internal/Portals/Separators.h>
#include <CGAL/Geodesic_queries/internal/Portals/Two_way_arcs.h>
#include <CGAL/Geodesic_queries/internal/Workspaces.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Divides a graph by nested separators, and chooses portals on them. Threads share the work on a
 * large part, and take different ones of the others; nothing depends on that.
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
      m_scale(arcs.arc_lengths().longest)
  {
  }

  const Portal_scale& scale() const { return m_scale; }

  // Returns the parts, each after its parent.
  std::vector<Portal_part> run()
  {
    std::vector<Portal_part> result;
    Part_nodes all(m_arcs.number_of_nodes());
    std::iota(all.begin(), all.end(), Node(0));
    std::vector<Open_part> open = pieces(m_arcs, all, {});
    for(std::uint32_t depth = 0; !open.empty(); ++depth)
    {
      const std::size_t first = result.size();
      result.resize(first + open.size());
      for(std::size_t i = 0; i < open.size(); ++i)
      {
        result[first + i].parent = open[i].parent;
        result[first + i].depth = depth;
      }
      label_all(open, result.data() + first);
      std::vector<Open_part> next;
      for(std::size_t i = 0; i < open.size(); ++i)
        for(Open_part& piece : open[i].pieces)
        {
          piece.parent = static_cast<std::uint32_t>(first + i);
          next.push_back(std::move(piece));
        }
      open.swap(next);
    }
    return result;
  }

private:
  // Of nodes, as a part of all. Above, threads work on one part at a time.
  static constexpr std::size_t LARGE_PART = 8;
  // Of vertices. Below, labels would take more memory than all distances.
  static constexpr std::size_t SIZE_OF_LAST_PART = 96;
  // Of vertices. Below, a part is not divided by a separator of more than a third of it.
  static constexpr std::size_t SIZE_TO_DIVIDE = 1024;

  struct Open_part
  {
    Part_nodes nodes;  // of the graph, sorted, so that vertices come first
    Two_way_arcs arcs; // between these
    std::uint32_t parent = Portal_part::no_parent;
    std::vector<Open_part> pieces = {}; // after it was divided
  };

  // Returns the connected pieces that have vertices. `nodes` are the numbers of nodes in the graph.
  std::vector<Open_part>
  pieces(const Two_way_arcs& arcs, const Part_nodes& nodes, const Part_nodes& separator) const
  {
    const std::vector<Part_nodes> parts = connected_parts(arcs, separator);
    Part_nodes place(arcs.number_of_nodes(), Two_way_search::null_node);
    for(const Part_nodes& part : parts)
      for(std::size_t i = 0; i < part.size(); ++i)
        place[part[i]] = static_cast<Node>(i);
    std::vector<Open_part> result;
    for(const Part_nodes& part : parts)
    {
      if(nodes[part.front()] >= m_number_of_vertices)
        continue;
      Part_nodes numbers;
      numbers.reserve(part.size());
      for(const Node node : part)
        numbers.push_back(nodes[node]);
      result.push_back({std::move(numbers), Two_way_arcs(arcs, part, place)});
    }
    return result;
  }

  void label_all(std::vector<Open_part>& open, Portal_part* const parts)
  {
    const auto is_large = [&](const std::size_t i) {
      return open[i].nodes.size() > m_arcs.number_of_nodes() / LARGE_PART;
    };
    for(std::size_t i = 0; i < open.size(); ++i)
      if(is_large(i))
        label(open[i], m_loop, parts[i]);
    m_loop.run(open.size(), [&](const std::size_t i, std::size_t) {
      if(!is_large(i))
        label(open[i], Loop(), parts[i]);
    });
  }

  void label(Open_part& open, const Loop& loop, Portal_part& part) const
  {
    check_for_interruption();
    part.vertices.assign(open.nodes.begin(), std::lower_bound(open.nodes.begin(), open.nodes.end(),
                                                              m_number_of_vertices));
    Workspaces<Two_way_search> searches(open.arcs);
    Part_nodes separator;
    if(part.vertices.size() > SIZE_OF_LAST_PART)
      separator = divide(open, part.vertices.size(), searches);
    part.is_last = open.pieces.empty();
    if(part.is_last)
      tabulate(searches, loop, part);
    else
      Portal_cover(searches, loop, m_scale, m_stretch, separator, part).run();
  }

  // Returns a separator, and finds the pieces; there are none if it is not worth it.
  Part_nodes divide(Open_part& open,
                    const std::size_t number_of_vertices,
                    Workspaces<Two_way_search>& searches) const
  {
    Part_nodes separator = std::move(Separator(open.arcs, *searches.borrow()).nodes());
    if(number_of_vertices > SIZE_TO_DIVIDE || 3 * separator.size() < open.nodes.size())
      open.pieces = pieces(open.arcs, open.nodes, separator);
    return separator;
  }

  // Finds the distances between all vertices of a last part.
  void tabulate(Workspaces<Two_way_search>& searches, const Loop& loop, Portal_part& part) const
  {
    part.size = part.vertices.size();
    part.table.resize(part.size * (part.size - 1) / 2);
    loop.run(part.size - 1, [&](const std::size_t i, std::size_t) {
      check_for_interruption();
      const auto search = searches.borrow();
      search->run_from(static_cast<Node>(i + 1));
      const double* const distances = search->labels().distances();
      std::transform(distances, distances + i + 1, part.table.data() + i * (i + 1) / 2,
                     [this](const double d) { return m_scale.stored(d); });
    });
  }

  const Two_way_arcs& m_arcs;
  std::size_t m_number_of_vertices;
  float m_stretch;
  const Loop& m_loop;
  Portal_scale m_scale;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_BUILDER_H
