// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_FREE_LENGTHS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_FREE_LENGTHS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_nodes.h>

#include <array>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The lengths of arcs in a Steiner graph that cost nothing, in place of `Costs`; all others are
 * infinite. No arc is left out between two sides of a face, as none of them is worse by its cost.
 */
template <typename Costs>
class Free_lengths : public Steiner_view
{
public:
  static constexpr bool are_symmetric = Costs::are_symmetric;

  // Labels of nodes that no path has reached.
  struct No_labels
  {
    static Index predecessor(Node /* node */) { return null_index; }
  };

  explicit Free_lengths(const Costs& costs) : Steiner_view(costs), m_costs(costs) {}

  double along(const Index h, const bool is_forward) const
  {
    const bool is_free = m_triangulation.length(h) == 0 || m_costs.along(h, is_forward) == 0;
    return is_free ? 1 : infinity;
  }

  std::array<Plane_vector, 3> corners(const Index h) const { return m_costs.corners(h); }

  double across(const Index h, const Plane_vector step) const
  {
    return m_costs.across(h, step) == 0 ? length(step) : infinity;
  }

  // The arcs from the source of `h` across the face to the left of `h`.
  template <typename F>
  void expand_corner(const Node /* source */, const Index h, F& f) const
  {
    if(may_be_free(h))
      visit(h, 0, 1, f);
  }

  // The arcs from a viewpoint across a face.
  template <typename Labels, typename F>
  void expand_face(const Viewpoint& view, const Face& face, const Labels& /* labels */, F& f) const
  {
    if(!may_be_free(face[0]))
      return;
    const double part = view.from_source / (view.from_source + view.from_target);
    const auto corner = corners(face[0]);
    const Plane_vector start = corner[0] + part * (corner[1] - corner[0]);
    offer(m_nodes.at_corner(m_triangulation.target(face[1]), face[2]),
          across(face[0], corner[2] - start), f);
    visit(face[0], part, 1, f);
    visit(face[0], part, 2, f);
  }

  // There are none back across a face, as no path has crossed it.
  template <typename Labels, typename F>
  void expand_back(const Viewpoint&, const Face&, Node /* origin */, const Labels&, F&) const
  {
  }

private:
  // Whether some arcs across the face to the left of `h` may cost nothing.
  bool may_be_free(const Index h) const
  {
    return !Costs::are_symmetric || m_triangulation.weight(h) == 0;
  }

  // The arcs to the points of another side, 1 or 2, from the part `part` of `h`.
  template <typename F>
  void visit(const Index h, const double part, const std::size_t side, F& f) const
  {
    const auto corner = corners(h);
    const Plane_vector start = corner[0] + part * (corner[1] - corner[0]);
    const Plane_vector first = corner[side], last = corner[(side + 1) % 3];
    m_nodes.for_each_node_on_edge(m_triangulation.halfedges_of_face(h)[side],
                                  [&](const Node node, const double t) {
                                    offer(node, across(h, first + t * (last - first) - start), f);
                                  });
  }

  const Costs m_costs;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_FREE_LENGTHS_H
