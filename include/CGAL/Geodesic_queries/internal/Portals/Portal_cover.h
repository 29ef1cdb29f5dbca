// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_COVER_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_COVER_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_queries/internal/Portals/Portal_part.h>
#include <CGAL/Geodesic_queries/internal/Portals/Separators.h>
#include <CGAL/Geodesic_queries/internal/Workspaces.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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
 * block, the first node that is not covered gets a portal that covers it and many others: the best
 * of the portals of the vertex before, or of a few others if none of these covers it.
 */
class Portal_cover
{
  using Searches = Workspaces<Two_way_search>;

public:
  // Searches are those of a connected part, whose first nodes are its vertices. `part` gets the
  // labels. All is referred to, not copied.
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
      m_number_of_vertices(part.vertices.size()),
      m_part(part),
      m_bytes_of_block(bytes_of_block),
      m_is_in_separator(m_number_of_vertices),
      m_table(separator.size() * separator.size())
  {
  }

  void run()
  {
    label_separator();
    const std::size_t size = m_separator.size(), vertices = m_number_of_vertices,
                      block = (std::max)(SMALLEST_BLOCK,
                                         m_bytes_of_block / (vertices * sizeof(float) + 1));
    for(m_first = 0; m_first < size; m_first += m_number)
    {
      m_number = (std::min)(block, size - m_first);
      find_rows();
      m_loop.run((vertices + LANES - 1) / LANES, [&](const std::size_t i, std::size_t) {
        cover_vertices(i * LANES, (std::min)((i + 1) * LANES, vertices));
      });
    }
    keep_portals();
  }

private:
  static constexpr std::size_t SMALLEST_BLOCK = 64;
  static constexpr std::size_t LANES = 64;          // vertices whose distances are near by
  static constexpr std::size_t MOST_CANDIDATES = 8; // of which the best one is taken
  static constexpr std::size_t MOST_PORTALS = std::size_t(1) << 16;

  // Distances from nodes of the block to the vertices.
  float* row(const std::size_t i) { return m_rows.data() + i * m_number_of_vertices; }

  // Distances between a node of the separator and those of the block.
  const float* in_block(const std::size_t portal) const
  {
    return m_table.data() + portal * m_separator.size() + m_first;
  }

  // A vertex of the separator covers all by itself.
  void label_separator()
  {
    m_part.labels.resize(m_number_of_vertices);
    for(std::size_t i = 0; i < m_separator.size(); ++i)
      if(const auto node = m_separator[i]; node < m_number_of_vertices)
      {
        m_is_in_separator[node] = true;
        m_part.labels[node] = {{static_cast<std::uint32_t>(i), 0}};
      }
  }

  void find_rows()
  {
    m_rows.resize(m_number * m_number_of_vertices);
    m_loop.run(m_number, [&](const std::size_t i, std::size_t) {
      check_for_interruption();
      const auto search = m_searches.borrow();
      search->run_from(m_separator[m_first + i]);
      const double* const distances = search->labels().distances();
      std::transform(distances, distances + m_number_of_vertices, row(i),
                     [this](const double d) { return m_scale.stored(d); });
      std::transform(m_separator.begin(), m_separator.end(),
                     m_table.data() + (m_first + i) * m_separator.size(),
                     [&](const auto node) { return m_scale.stored(distances[node]); });
    });
    // the same in both directions, as sums may be rounded differently
    const std::size_t size = m_separator.size();
    for(std::size_t i = m_first; i < m_first + m_number; ++i)
      for(std::size_t j = 0; j < i; ++j)
      {
        float &there = m_table[i * size + j], &back = m_table[j * size + i];
        there = back = (std::max)(there, back);
      }
  }

  void cover_vertices(const std::size_t first, const std::size_t beyond)
  {
    check_for_interruption();
    std::vector<float> columns(LANES * m_number), limits(m_number);
    for(std::size_t i = 0; i < m_number; ++i)
      for(std::size_t v = first; v < beyond; ++v)
        columns[(v - first) * m_number + i] = row(i)[v];
    std::vector<std::size_t> hints; // portals of the vertex before, as nodes of the block
    for(std::size_t v = first; v < beyond; ++v)
      if(!m_is_in_separator[v])
        cover_vertex(columns.data() + (v - first) * m_number, limits.data(), hints,
                     m_part.labels[v]);
  }

  // `limit` of a node is the largest sum that covers it, or negative if it is covered.
  void cover_vertex(const float* const distance,
                    float* const limit,
                    std::vector<std::size_t>& hints,
                    std::vector<Portal_label>& portals)
  {
    const std::size_t number_before = portals.size();
    for(std::size_t i = 0; i < m_number; ++i)
      limit[i] = m_stretch * distance[i];
    for(const Portal_label& portal : portals)
      mark_covered(portal, limit);
    for(std::size_t i = 0; i < m_number; ++i)
      if(limit[i] >= 0)
      {
        const std::size_t best = best_portal(i, distance, limit, hints);
        portals.push_back({static_cast<std::uint32_t>(m_first + best), distance[best]});
        mark_covered(portals.back(), limit);
      }
    hints.clear();
    for(std::size_t i = number_before; i < portals.size(); ++i)
      hints.push_back(portals[i].portal - m_first);
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

  // Returns a node of the block that covers node `i` and many others.
  std::size_t best_portal(const std::size_t i,
                          const float* const distance,
                          const float* const limit,
                          const std::vector<std::size_t>& hints) const
  {
    std::vector<std::size_t> candidates;
    const float* const between = in_block(m_first + i);
    const auto add = [&](const std::size_t j) {
      if(between[j] <= limit[i] - distance[j])
        candidates.push_back(j);
    };
    std::for_each(hints.begin(), hints.end(), add);
    if(candidates.empty())
      for(std::size_t j = 0; j < m_number; ++j)
        add(j);
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

  // Numbers the portals, and keeps the distances between them.
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
        m_part.table.push_back(m_table[i * size + j]);
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
  std::size_t m_number_of_vertices;
  Portal_part& m_part;
  std::size_t m_bytes_of_block;
  std::vector<bool> m_is_in_separator;   // for each vertex
  std::vector<float> m_table;            // between all nodes of the separator
  std::size_t m_first = 0, m_number = 0; // nodes of the block
  std::vector<float> m_rows;             // of the block
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_COVER_H
