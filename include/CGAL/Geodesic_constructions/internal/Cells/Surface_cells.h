// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_SURFACE_CELLS_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_SURFACE_CELLS_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_constructions/internal/Cells/Cell_network.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The cells of the sources of an exact search: all windows of the surface, sorted by face, and the
 * cells of each face. A border along an edge is in neither of its faces: there, the smallest
 * distances on the two sides are those of different cells.
 */
class Surface_cells
{
  using Search = Surface_search<Saddle_vertex_graph>;

public:
  Surface_cells(const Search& search, const Cell_options& options)
    : m_triangulation(search.graph().triangulation()),
      m_options(options),
      m_areas(search.sources().size(), 0),
      m_owners(m_triangulation),
      m_first_parts(m_triangulation.number_of_halfedges(), NONE),
      m_cells(m_triangulation, m_options, m_areas, m_area_errors, m_arcs, m_parts)
  {
    find_windows(search);
    divide_faces();
    check_areas();
    for(std::size_t i = m_parts.size(); i-- > 0;)
      m_first_parts[m_parts[i].halfedge] = i;
    for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
    {
      check_for_interruption_at(h);
      const Index opposite = m_triangulation.opposite(h);
      if(h < opposite && !m_triangulation.is_border(h) && !m_triangulation.is_border(opposite))
        compare_sides(h, opposite);
    }
  }

  // In units of the triangulation.
  const std::vector<double>& areas() const { return m_areas; }

  const std::vector<Border_arc>& arcs() const { return m_arcs; }

private:
  static constexpr std::size_t NONE = Network_border::NONE;

  // Windows within cells matter only if borders there are wanted.
  void find_windows(const Search& search)
  {
    const Exact_windows windows(search.search());
    Face_windows found(m_triangulation, windows, m_owners);
    if(!m_options.within_cells)
    {
      for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
        if(!m_triangulation.is_border(h) && m_triangulation.first_of_face(h) == h)
          m_owners.set(h, source_of_vertices(h, search.search()));
      follow_windows(search, windows, found);
    }
    found.fix_owners();
    follow_windows(search, windows, found);
    m_windows = std::move(found).windows();
  }

  template <typename Nodes>
  std::size_t source_of_vertices(const Index h, const Nodes& nodes) const
  {
    const auto source = [&](const Index side) -> std::size_t {
      const Index v = m_triangulation.source(side);
      return nodes.labels().is_reached(v) ? nodes.source(v) : NONE;
    };
    const auto sides = m_triangulation.halfedges_of_face(h);
    const std::size_t result = source(sides[0]);
    return source(sides[1]) == result && source(sides[2]) == result ? result : NONE;
  }

  // Nearest tips first, so that most of the later windows are seen to be useless at once.
  template <typename Windows, typename WindowsOfFaces>
  static void follow_windows(const Search& search, const Windows& windows, WindowsOfFaces& found)
  {
    for(std::size_t i = 0; i < search.sources().size(); ++i)
      if(const Source_point& s = search.sources()[i];
         !s.point.is_vertex() && search.nearest(s.point).source == i)
        found.add_point(s.point, s.distance / search.graph().triangulation().unit(), i);
    std::vector<std::pair<double, Index>> tips;
    for(Index v = 0; v < search.graph().triangulation().number_of_vertices(); ++v)
      if(windows.is_tip(v))
        tips.emplace_back(windows.label(v), v);
    std::sort(tips.begin(), tips.end());
    for(const auto& tip : tips)
    {
      check_for_interruption();
      found.add_vertex(tip.second, search.source(tip.second));
    }
  }

  // Faces that only one source reaches are not divided, unless borders within cells are wanted.
  void divide_faces()
  {
    for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
      if(m_owners[h] != NONE && m_triangulation.first_of_face(h) == h)
        fill(h, m_owners[h]);
    std::vector<std::pair<Index, Index>> order; // faces, and numbers of windows
    order.reserve(m_windows.size());
    for(std::size_t i = 0; i < m_windows.size(); ++i)
      order.emplace_back(m_triangulation.first_of_face(m_windows[i].halfedge),
                         static_cast<Index>(i));
    std::sort(order.begin(), order.end());
    std::vector<Face_window> windows;
    for(auto it = order.begin(); it != order.end();)
    {
      check_for_interruption();
      const Index h = it->first;
      windows.clear();
      for(; it != order.end() && it->first == h; ++it)
        windows.push_back(m_windows[it->second]);
      const std::size_t source = windows.front().source;
      const bool has_one_source = std::all_of(
          windows.begin(), windows.end(), [&](const Face_window& w) { return w.source == source; });
      if(has_one_source && !m_options.within_cells)
        fill(h, source);
      else
        m_cells.divide(h, windows.begin(), windows.end());
    }
  }

  void check_areas() const
  {
    constexpr double rounding = 1e-6; // more would be seen
    if(!(m_area_errors.sum <= rounding * m_area_errors.area))
      reject("areas of cells do not add up in " + m_triangulation.name_of_face(m_area_errors.face) +
             ": rounding errors are too large there, as vertices nearly coincide, or faces have "
             "nearly no area");
  }

  void fill(const Index h, const std::size_t source)
  {
    const Face_layout layout(m_triangulation, h);
    const double area = cross(layout.edge(0, 1), layout.edge(1, 2)) / 2;
    m_areas[source] += area;
    m_area_errors.area += area;
    m_owners.set(h, source);
  }

  // The parts of a side, as seen from `h`.
  std::vector<Side_part> parts(const Index side, const Index h) const
  {
    if(m_owners[side] != NONE)
      return {{h, 0, 1, {0, 0}, infinity, m_owners[side]}};
    std::vector<Side_part> result;
    for(std::size_t i = m_first_parts[side]; i < m_parts.size() && m_parts[i].halfedge == side; ++i)
      result.push_back(m_parts[i]);
    if(side != h)
    {
      std::reverse(result.begin(), result.end());
      for(Side_part& p : result)
        p = {h,       1 - p.end, 1 - p.begin, {m_triangulation.length(h) - p.tip.x, -p.tip.y},
             p.label, p.source};
    }
    return result;
  }

  // Adds borders along an edge.
  void compare_sides(const Index h, const Index opposite)
  {
    const std::size_t left_source = m_owners[h], right_source = m_owners[opposite];
    if(left_source != NONE && left_source == right_source)
      return;
    constexpr double smallest_part = 2e-6;
    const std::vector<Side_part> left = parts(h, h), right = parts(opposite, h);
    for(auto p = left.begin(), q = right.begin(); p != left.end() && q != right.end();)
    {
      const double begin = (std::max)(p->begin, q->begin), end = (std::min)(p->end, q->end);
      if(end - begin > smallest_part && is_border(*p, *q, (begin + end) / 2))
        add_arc(h, begin, end, p->source, q->source);
      ++(p->end < q->end ? p : q);
    }
  }

  bool is_border(const Side_part& p, const Side_part& q, const double part) const
  {
    const double x = part * m_triangulation.length(p.halfedge);
    const bool has_tips = p.label < infinity && q.label < infinity;
    if(has_tips && !are_equal(p.distance(x), q.distance(x)))
      return false;
    if(p.source != q.source)
      return true;
    const Plane_vector point{x, 0};
    return m_options.within_cells && differ_in_direction(point - p.tip, point - q.tip);
  }

  void add_arc(const Index h,
               const double begin,
               const double end,
               const std::size_t left,
               const std::size_t right)
  {
    const Index first = m_triangulation.first_of_face(h);
    const auto point = [&](const double part) {
      const Face_point p =
          Face_point::on_edge(h, (std::clamp)(part, 0., 1.)).seen_from(m_triangulation, first);
      return p.weight;
    };
    if(left < right)
      m_arcs.push_back({first, left, right, {point(begin), point(end)}});
    else
      m_arcs.push_back({first, right, left, {point(end), point(begin)}});
  }

  const Intrinsic_triangulation& m_triangulation;
  const Cell_options m_options;
  std::vector<double> m_areas;
  Area_errors m_area_errors;
  std::vector<Face_window> m_windows;
  Face_owners m_owners; // NONE if there are several
  std::vector<Border_arc> m_arcs;
  std::vector<Side_part> m_parts;         // those of a side after each other
  std::vector<std::size_t> m_first_parts; // by halfedge
  Face_cells m_cells;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_SURFACE_CELLS_H
