// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_PORTAL_COVER_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_PORTAL_COVER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Portal_part.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Separators.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Workspaces.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Chooses the portals of vertices on a separator: a portal at the distance a from a vertex covers a
 * node of the separator at the distance b if a plus the distance between the two is at most the
 * stretch times b. All nodes of the separator are covered.
 *
 * Rows of distances, from each node of the separator, are found and used block by block. In a
 * block, the first node that is not covered gets the portal that covers it and most others.
 */
class Portal_cover
{
  using Node = Two_way_arcs::Node;
  using Searches = Workspaces<Two_way_search>;

public:
  // The vertices are those of `part`, which gets the labels. All is referred to, not copied.
  Portal_cover(Searches& searches,
               const Loop& loop,
               const Portal_scale& scale,
               const float stretch,
               const Part_nodes& separator,
               Portal_part& part,
               const std::size_t bytes_of_block = std::size_t(1) << 26)
    : m_searches(searches),
      m_loop(loop),
      m_scale(scale),
      m_stretch(stretch),
      m_separator(separator),
      m_part(part),
      m_bytes_of_block(bytes_of_block),
      m_targets(part.vertices),
      m_table(separator.size() * separator.size())
  {
    m_targets.insert(m_targets.end(), separator.begin(), separator.end());
    std::sort(m_targets.begin(), m_targets.end());
    m_targets.erase(std::unique(m_targets.begin(), m_targets.end()), m_targets.end());
  }

  void run()
  {
    label_separator();
    const std::size_t size = m_separator.size(),
                      bytes_of_row = m_part.vertices.size() * sizeof(float),
                      block = (std::max)(SMALLEST_BLOCK, m_bytes_of_block / (bytes_of_row + 1));
    for(m_first = 0; m_first < size; m_first += m_number)
    {
      m_number = (std::min)(block, size - m_first);
      find_rows();
      const std::size_t vertices = m_part.vertices.size();
      m_loop.run((vertices + LANES - 1) / LANES, [&](const std::size_t i, std::size_t) {
        cover_vertices(i * LANES, (std::min)((i + 1) * LANES, vertices));
      });
    }
    keep_portals();
  }

private:
  static constexpr std::size_t SMALLEST_BLOCK = 64;
  static constexpr std::size_t LANES = 64;           // vertices whose distances are near by
  static constexpr std::size_t MOST_CANDIDATES = 32; // of which the best one is taken
  static constexpr std::size_t MOST_PORTALS = std::size_t(1) << 16;

  // Distances from nodes of the block to the vertices.
  const float* row(const std::size_t i) const { return m_rows.data() + i * m_part.vertices.size(); }

  // Distances between a node of the separator and those of the block.
  const float* in_block(const std::size_t portal) const
  {
    return m_table.data() + portal * m_separator.size() + m_first;
  }

  // A vertex of the separator covers all by itself.
  void label_separator()
  {
    const Part_nodes& vertices = m_part.vertices;
    m_part.labels.resize(vertices.size());
    m_part.is_in_separator.resize(vertices.size());
    std::vector<std::pair<Node, std::uint32_t>> places;
    for(const Node node : m_separator)
      places.emplace_back(node, static_cast<std::uint32_t>(places.size()));
    std::sort(places.begin(), places.end());
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      const auto place =
          std::lower_bound(places.begin(), places.end(), std::make_pair(vertices[i], 0u));
      if(place == places.end() || place->first != vertices[i])
        continue;
      m_part.is_in_separator[i] = true;
      m_part.labels[i] = {{place->second, 0}};
    }
  }

  void find_rows()
  {
    const Part_nodes& vertices = m_part.vertices;
    m_rows.resize(m_number * vertices.size());
    m_loop.run(m_number, [&](const std::size_t i, std::size_t) {
      check_for_interruption();
      const auto search = m_searches.borrow();
      search->run({Seed{m_separator[m_first + i]}},
                  Stop_rule{std::numeric_limits<double>::infinity(), m_targets});
      const auto stored = [&](const Node n) {
        return m_scale.stored(search->labels().distance(n));
      };
      std::transform(vertices.begin(), vertices.end(), m_rows.data() + i * vertices.size(), stored);
      std::transform(m_separator.begin(), m_separator.end(),
                     m_table.data() + (m_first + i) * m_separator.size(), stored);
    });
  }

  void cover_vertices(const std::size_t first, const std::size_t beyond)
  {
    check_for_interruption();
    std::vector<float> columns(LANES * m_number), limits(m_number);
    for(std::size_t i = 0; i < m_number; ++i)
      for(std::size_t v = first; v < beyond; ++v)
        columns[(v - first) * m_number + i] = row(i)[v];
    for(std::size_t v = first; v < beyond; ++v)
      if(!m_part.is_in_separator[v])
        cover_vertex(columns.data() + (v - first) * m_number, limits.data(), m_part.labels[v]);
  }

  // `limit` of a node is the largest sum that covers it, or negative if it is covered.
  void
  cover_vertex(const float* const distance, float* const limit, std::vector<Portal_label>& portals)
  {
    for(std::size_t i = 0; i < m_number; ++i)
      limit[i] = m_stretch * distance[i];
    for(const Portal_label& portal : portals)
      mark_covered(portal, limit);
    for(std::size_t i = 0; i < m_number; ++i)
      if(limit[i] >= 0)
      {
        const std::size_t best = best_portal(i, distance, limit);
        portals.push_back({static_cast<std::uint32_t>(m_first + best), distance[best]});
        mark_covered(portals.back(), limit);
      }
  }

  void mark_covered(const Portal_label& portal, float* const limit) const
  {
    const float* const between = in_block(portal.portal);
    for(std::size_t i = 0; i < m_number; ++i)
      limit[i] = between[i] <= limit[i] - portal.distance ? -1 : limit[i];
  }

  std::size_t number_covered(const std::size_t i, const float distance, const float* limit) const
  {
    const float* const between = in_block(m_first + i);
    std::uint32_t result = 0;
    for(std::size_t j = 0; j < m_number; ++j)
      result += between[j] <= limit[j] - distance ? 1 : 0;
    return result;
  }

  // Returns the node of the block that covers node `i` and most others.
  std::size_t
  best_portal(const std::size_t i, const float* const distance, const float* const limit) const
  {
    std::vector<std::size_t> candidates;
    for(std::size_t j = 0; j < m_number; ++j)
      if(in_block(m_first + j)[i] <= limit[i] - distance[j])
        candidates.push_back(j);
    std::size_t result = i, most = number_covered(i, distance[i], limit);
    const std::size_t stride = candidates.size() / MOST_CANDIDATES + 1;
    for(std::size_t j = 0; j < candidates.size(); j += stride)
    {
      const std::size_t candidate = candidates[j],
                        number = number_covered(candidate, distance[candidate], limit);
      if(number > most)
      {
        most = number;
        result = candidate;
      }
    }
    return result;
  }

  // Numbers the portals, and keeps the distances between them, the same in both directions.
  void keep_portals()
  {
    const std::size_t size = m_separator.size();
    std::vector<std::uint32_t> number(size);
    for(const auto& portals : m_part.labels)
      for(const Portal_label& portal : portals)
        number[portal.portal] = 1;
    std::vector<std::size_t> kept;
    for(std::size_t i = 0; i < size; ++i)
      if(number[i] > 0)
      {
        number[i] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(i);
      }
    if(kept.size() > MOST_PORTALS)
      throw std::length_error(name_of_package() + "Portal_labels: a separator has " +
                              std::to_string(kept.size()) + " portals, and more than " +
                              std::to_string(MOST_PORTALS) + " are not supported");
    m_part.size = kept.size();
    m_part.table.reserve(kept.size() * kept.size());
    for(const std::size_t i : kept)
      for(const std::size_t j : kept)
        m_part.table.push_back((std::max)(m_table[i * size + j], m_table[j * size + i]));
    for(auto& portals : m_part.labels)
      sort_and_number(number, portals);
  }

  static void sort_and_number(const std::vector<std::uint32_t>& number,
                              std::vector<Portal_label>& portals)
  {
    for(Portal_label& portal : portals)
      portal.portal = number[portal.portal];
    std::sort(portals.begin(), portals.end(), [](const Portal_label& a, const Portal_label& b) {
      return std::make_pair(a.distance, a.portal) < std::make_pair(b.distance, b.portal);
    });
    portals.shrink_to_fit();
  }

  Searches& m_searches;
  const Loop& m_loop;
  const Portal_scale& m_scale;
  float m_stretch;
  const Part_nodes& m_separator;
  Portal_part& m_part;
  std::size_t m_bytes_of_block;
  Part_nodes m_targets;
  std::vector<float> m_table;            // between all nodes of the separator
  std::size_t m_first = 0, m_number = 0; // nodes of the block
  std::vector<float> m_rows;             // of the block
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_PORTAL_COVER_H
