// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_EXACT_WINDOWS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_EXACT_WINDOWS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Lines_of_sight.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/angles_at_vertex.h>

#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The windows of a saddle vertex graph after a search, when all labels are known: what is seen of
 * the surface from a tip, through the sides of faces. Shortest paths are straight from a tip on, so
 * that windows tell the distances of all points. This is all that queries need to know of the graph
 * and its run; they get windows as `Sight`s, in the plane of the face ahead, with the tip at the
 * origin. Lengths are in units of the triangulation.
 *
 * `Search` is a `Propagation` of the graph. It is referred to, and has to have ended.
 */
template <typename Search>
class Exact_windows
{
public:
  explicit Exact_windows(const Search& search)
    : m_triangulation(search.graph().triangulation()),
      m_run(search.graph_run()),
      m_labels(search.labels())
  {
  }

  // Follows windows only where they may see a shortest path. A visitor that derives from it has
  // `on_vertex()`, and what else `Sight_expansion` shall notify it of.
  struct Visitor : Sight_visitor_base
  {
    static constexpr bool knows_arrivals = true;

    double bound(const Index v) const { return windows.m_labels.distance(v); }
    double label(const Index v) const { return windows.m_labels.distance(v); }
    const Arrival& arrival(const Index v) const { return windows.m_run.arrival(v); }
    bool has_predecessor(const Index v) const
    {
      return windows.m_labels.predecessor(v) != null_index;
    }

    const Exact_windows& windows;
  };

  // The label of a vertex.
  double label(const Index v) const { return m_labels.distance(v); }

  // Whether a vertex is a tip of windows: it is a source, or paths may bend there.
  bool is_tip(const Index v) const
  {
    return m_labels.is_reached(v) &&
           (m_run.arrival(v).is_none() || m_run.tables().bends.is_possible(v));
  }

  // Calls `f(h, slope)` for the halfedges from a vertex, if it is known how paths arrive there,
  // with the change of the distance per length along `h`.
  template <typename F>
  void for_each_slope(const Index v, F f) const
  {
    const Arrival& arrival = m_run.arrival(v);
    if(!arrival.is_none() && (arrival.is_along_halfedge() || arrival.has_direction()))
      Bend_sectors(m_triangulation, m_run.tables().steps, v)
          .for_each_cosine(arrival, [&](const Index h, const double cosine) { f(h, -cosine); });
  }

  // Calls `on_corner(h, right, left)` for the faces around a tip that paths enter from there, to
  // the left of `h`, which is the x axis, with the directions between which they do; and follows
  // the windows through the opposite sides of these faces.
  template <typename OnCorner, typename WindowVisitor>
  void follow_from_vertex(const Index v, OnCorner on_corner, WindowVisitor& visitor) const
  {
    const Vertex_sights sights(m_triangulation, m_run.tables());
    const auto no_edge = [](Index) {};
    sights.for_each_corner(v, m_run.arrival(v), no_edge,
                           [&](const Index h, const Plane_vector right, const Plane_vector left) {
                             if(m_run.tables().steps[h].has_face())
                               on_corner(h, right, left);
                           });
    Sight_expansion<WindowVisitor> expansion(m_run.tables(), label(v), visitor);
    sights.for_each(v, m_run.arrival(v), no_edge,
                    [&](const Sight& sight, const Index left_end, const Index right_end) {
                      expansion.look(sight, left_end, right_end);
                    });
  }

  // Calls `on_side(side, p, start, end)` for the sides of the faces that contain a point, which is
  // `p` there, and the origin; and follows the windows through these sides. The point is not a
  // vertex; paths start there with the given label.
  template <typename OnSide, typename WindowVisitor>
  void follow_from_point(const Intrinsic_point& point,
                         const double label,
                         OnSide on_side,
                         WindowVisitor& visitor) const
  {
    const Lines_of_sight lines(m_triangulation, m_run.tables(), point);
    lines.for_each_side(on_side);
    Sight_expansion<WindowVisitor> expansion(m_run.tables(), label, visitor);
    lines.for_each_sight([&](const Sight& sight, const Index left_end, const Index right_end) {
      expansion.look(sight, left_end, right_end);
    });
  }

private:
  using Labels = std::decay_t<decltype(std::declval<const Search&>().labels())>;

  const Intrinsic_triangulation& m_triangulation;
  const typename Search::Run& m_run;
  const Labels& m_labels;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_EXACT_WINDOWS_H
