// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_SECTORS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_SECTORS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The sectors that barriers divide the surroundings of vertices into. A vertex where there are at
 * least two is called divided: no path leads through it from one sector to another. The border
 * divides as barriers do, but only where there is a barrier as well: a vertex where two parts of
 * the surface touch is none otherwise. Sectors are numbered from 0, those of a vertex in a row.
 */
class Sectors
{
public:
  using Index = Intrinsic_triangulation::Index;
  static constexpr Index null_index = Intrinsic_triangulation::null_index;

  Sectors() = default;

  explicit Sectors(const Intrinsic_triangulation& triangulation)
  {
    if(triangulation.has_barriers())
      for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
        divide(triangulation, v);
  }

  bool is_empty() const { return m_first_halfedge.empty(); }
  Index number_of_sectors() const { return static_cast<Index>(m_first_halfedge.size()); }

  // the vertex of a sector
  Index vertex(const Index sector) const { return m_vertex[sector]; }

  // The first halfedge of a sector: going counterclockwise from there, the faces to the left are
  // those of the sector, up to the next halfedge that is a barrier or at the border.
  Index first_halfedge(const Index sector) const { return m_first_halfedge[sector]; }

  // the first one of a vertex, and the one after the last; the same if it is not divided
  Index first_sector(const Index v) const
  {
    return static_cast<Index>(std::lower_bound(m_vertex.begin(), m_vertex.end(), v) -
                              m_vertex.begin());
  }
  Index beyond_sector(const Index v) const
  {
    return static_cast<Index>(std::upper_bound(m_vertex.begin(), m_vertex.end(), v) -
                              m_vertex.begin());
  }

  // The sector of `v` that the face to the left of `h` is in, or null_index if `v` is not divided.
  // \pre `h` starts from `v`.
  Index sector(const Index v, const Index h) const
  {
    const Index first = first_sector(v), beyond = beyond_sector(v);
    if(first == beyond)
      return null_index;
    const auto begin = m_first_halfedge.begin();
    const auto next = std::upper_bound(begin + first, begin + beyond, h);
    return next == begin + first ? beyond - 1 : static_cast<Index>(next - begin) - 1;
  }

  std::size_t memory() const
  {
    return sizeof(Index) * (m_vertex.capacity() + m_first_halfedge.capacity());
  }

private:
  void divide(const Intrinsic_triangulation& triangulation, const Index v)
  {
    const std::size_t number_before = m_vertex.size();
    bool has_barrier = false;
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
    {
      const bool is_at_border = triangulation.is_border(triangulation.opposite(h));
      has_barrier = has_barrier || triangulation.is_barrier(h);
      if(!triangulation.is_border(h) && (is_at_border || triangulation.is_barrier(h)))
      {
        m_vertex.push_back(v);
        m_first_halfedge.push_back(h);
      }
    }
    if(!has_barrier || m_vertex.size() < number_before + 2) // nothing is divided
    {
      m_vertex.resize(number_before);
      m_first_halfedge.resize(number_before);
    }
  }

  std::vector<Index> m_vertex; // per sector, ascending
  std::vector<Index> m_first_halfedge;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_SECTORS_H
