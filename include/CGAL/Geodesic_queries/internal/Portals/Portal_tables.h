// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_TABLES_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_TABLES_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Geodesic_queries/internal/Portals/Portal_part.h>
#include <CGAL/Geodesic_queries/internal/Portals/Two_way_arcs.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Labels of all vertices, and tables of all parts. Distances are those of `Portal_scale`.
 */
class Portal_tables
{
public:
  using Node = Two_way_arcs::Node;

  Portal_tables() = default;

  Portal_tables(std::vector<Portal_part> parts,
                const std::size_t number_of_vertices,
                const Portal_scale& scale,
                const double epsilon)
    : m_scale(scale), m_epsilon(epsilon)
  {
    count_labels(parts, number_of_vertices);
    std::vector<std::uint32_t> number_of_levels(number_of_vertices);
    for(Portal_part& part : parts)
    {
      add(part, number_of_levels);
      part = {};
    }
  }

  double epsilon() const { return m_epsilon; }
  std::size_t number_of_vertices() const { return m_part.size(); }
  std::size_t number_of_labels() const { return m_distance.size(); }

  std::size_t memory() const
  {
    return memory_of(m_parts, m_part, m_place, m_first_level, m_first_label, m_portal, m_distance,
                     m_table);
  }

  // Returns an interval that contains the distance, in units of the graph.
  std::pair<double, double> interval(const Node v, const Node w) const
  {
    if(v == w)
      return {0, 0};
    std::uint32_t part = common_part(v, w);
    if(part == no_parent)
      return {infinity, infinity};
    const double factor = (1 + m_epsilon) * (1 + ROUNDING_OF_COVER);
    double within = infinity;
    if(m_parts[part].is_last)
    {
      within = distance_in(m_parts[part], v, w);
      part = m_parts[part].parent;
    }
    // a larger sum, along a path that leaves the last part, does not lower the lower end
    const double sum = smallest_sum(part, v, w, static_cast<float>(within * factor));
    const double lower = (std::min)(within, sum / factor);
    constexpr double smallest = 16. * std::numeric_limits<float>::denorm_min();
    return {m_scale.label((std::max)(lower - smallest, 0.) / (1 + ROUNDING)),
            m_scale.label((std::min)(within, sum) * (1 + ROUNDING))};
  }

private:
  friend class Portal_file;

  static constexpr std::uint32_t no_parent = Portal_part::no_parent;

  // Relative, of sums of distances in single precision, and of what is compared with them.
  static constexpr double ROUNDING = 1. / (1 << 22), ROUNDING_OF_COVER = 1. / (1 << 19);

  // Where the table of a part is, and how many rows it has.
  struct Part
  {
    std::size_t first_in_table, size;
    std::uint32_t parent, depth;
    bool is_last;
  };

  // Makes room for them: `m_first_label` gets the sums.
  void count_labels(const std::vector<Portal_part>& parts, const std::size_t number_of_vertices)
  {
    m_part.resize(number_of_vertices);
    m_place.resize(number_of_vertices);
    m_first_level.resize(number_of_vertices + 1);
    std::size_t size_of_tables = 0;
    for(const Portal_part& part : parts)
    {
      size_of_tables += part.table.size();
      for(std::size_t i = 0; i < part.labels.size(); ++i)
        ++m_first_level[std::size_t(part.vertices[i]) + 1];
    }
    for(std::size_t i = 1; i < m_first_level.size(); ++i)
      m_first_level[i] += m_first_level[i - 1];
    m_first_label.resize(m_first_level.back() + 1);
    std::vector<std::uint32_t> number_of_levels(number_of_vertices);
    for(const Portal_part& part : parts)
      for(std::size_t i = 0; i < part.labels.size(); ++i)
      {
        const Node v = part.vertices[i];
        m_first_label[m_first_level[v] + number_of_levels[v]++ + 1] = part.labels[i].size();
      }
    for(std::size_t i = 1; i < m_first_label.size(); ++i)
      m_first_label[i] += m_first_label[i - 1];
    m_portal.resize(m_first_label.back());
    m_distance.resize(m_first_label.back());
    m_parts.reserve(parts.size());
    m_table.reserve(size_of_tables);
  }

  void add(const Portal_part& part, std::vector<std::uint32_t>& number_of_levels)
  {
    for(std::size_t i = 0; i < part.vertices.size(); ++i)
    {
      const Node v = part.vertices[i];
      m_part[v] = static_cast<std::uint32_t>(m_parts.size());
      m_place[v] = static_cast<std::uint32_t>(i);
      if(part.is_last)
        continue;
      std::size_t label = m_first_label[m_first_level[v] + number_of_levels[v]++];
      for(const Portal_label& l : part.labels[i])
      {
        m_portal[label] = static_cast<std::uint16_t>(l.portal);
        m_distance[label++] = l.distance;
      }
    }
    m_parts.push_back({m_table.size(), part.size, part.parent, part.depth, part.is_last});
    m_table.insert(m_table.end(), part.table.begin(), part.table.end());
  }

  // Returns the smallest part that both are in, or `no_parent`.
  std::uint32_t common_part(const Node v, const Node w) const
  {
    std::uint32_t a = m_part[v], b = m_part[w];
    while(a != b)
    {
      std::uint32_t& deeper = m_parts[a].depth > m_parts[b].depth ? a : b;
      if(m_parts[deeper].parent == no_parent)
        return no_parent;
      deeper = m_parts[deeper].parent;
    }
    return a;
  }

  float distance_in(const Part& part, const Node v, const Node w) const
  {
    const std::size_t i = (std::max)(m_place[v], m_place[w]),
                      j = (std::min)(m_place[v], m_place[w]);
    return m_table[part.first_in_table + i * (i - 1) / 2 + j];
  }

  // At the separators of a part and of those around it. Returns `result` if no sum is smaller.
  float smallest_sum(std::uint32_t part, const Node v, const Node w, float result) const
  {
    while(part != no_parent)
    {
      lower_sum(m_parts[part], v, w, result);
      part = m_parts[part].parent;
    }
    return result;
  }

  // Labels are sorted, so that those that are too far end a loop.
  void lower_sum(const Part& part, const Node v, const Node w, float& smallest) const
  {
    const std::size_t* const of_v = m_first_label.data() + m_first_level[v] + part.depth;
    const std::size_t* const of_w = m_first_label.data() + m_first_level[w] + part.depth;
    for(std::size_t i = of_v[0]; i < of_v[1]; ++i)
    {
      if(m_distance[i] + m_distance[of_w[0]] >= smallest)
        return;
      const float* const row = m_table.data() + part.first_in_table + m_portal[i] * part.size;
      for(std::size_t j = of_w[0]; j < of_w[1]; ++j)
      {
        const float sum = m_distance[i] + m_distance[j];
        if(sum >= smallest)
          break;
        smallest = (std::min)(smallest, sum + row[m_portal[j]]);
      }
    }
  }

  Portal_scale m_scale;
  double m_epsilon = 0;
  std::vector<Part> m_parts;              // each after its parent
  std::vector<std::uint32_t> m_part;      // of each vertex, the deepest one
  std::vector<std::uint32_t> m_place;     // of a vertex in its last part
  std::vector<std::size_t> m_first_level; // of each vertex, in the next array
  std::vector<std::size_t> m_first_label; // at each separator around it, the largest part first
  std::vector<std::uint16_t> m_portal;    // of each label
  std::vector<float> m_distance;          // of each label, increasing
  std::vector<float> m_table;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_TABLES_H
