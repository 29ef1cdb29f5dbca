// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_TRIANGULATION_CHANGES_H
#define CGAL_GEODESIC_COSTS_TRIANGULATION_CHANGES_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicCostsChanges
 *
 * A new weight of a face of an `Intrinsic_triangulation`.
 */
struct Weight_change
{
  /// a halfedge with the face to its left.
  std::uint32_t halfedge;

  /// what a path in the face costs per unit of length, in the unit of the mesh: not negative;
  /// infinity if paths must not enter the face.
  double weight;
};

/*!
 * \ingroup PkgGeodesicCostsChanges
 *
 * Whether a barrier of an `Intrinsic_triangulation` is to be there or lifted, as a door that is
 * closed or open.
 */
struct Barrier_change
{
  /// a halfedge of the edge.
  std::uint32_t halfedge;

  /// whether paths must not cross the edge.
  bool is_barrier;
};

namespace internal {

/*
 * Changes weights and barriers of a triangulation.
 */
class Triangulation_changes
{
public:
  explicit Triangulation_changes(Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  // Calls `f(halfedge, before, after)` for each change.
  template <typename F>
  void set_weights(const std::vector<Weight_change>& changes, F f)
  {
    for(const Weight_change& change : changes)
      check(change);
    if(!m_triangulation.has_weights())
    {
      std::vector<double> ones(m_triangulation.number_of_halfedges());
      for(Index h = 0; h < m_triangulation.number_of_halfedges(); ++h)
        ones[h] = m_triangulation.weight(h);
      m_triangulation.set_weights({std::move(ones), 1});
    }
    for(const Weight_change& change : changes)
    {
      const double before = m_triangulation.weight(change.halfedge);
      const double after = in_weight_unit(change.weight);
      for(const Index h : m_triangulation.halfedges_of_face(change.halfedge))
        m_triangulation.m_weight[h] = after;
      f(change.halfedge, before, after);
    }
  }

  void set_barriers(const std::vector<Barrier_change>& changes)
  {
    for(const Barrier_change& change : changes)
      check(change);
    m_triangulation.m_is_lifted.resize(m_triangulation.m_is_barrier.size());
    for(const Barrier_change& change : changes)
      for(const Index h : {change.halfedge, m_triangulation.opposite(change.halfedge)})
        m_triangulation.m_is_lifted[h] = !change.is_barrier;
  }

private:
  void check(const Weight_change& change) const
  {
    const Index h = change.halfedge;
    if(h >= m_triangulation.number_of_halfedges() || m_triangulation.is_border(h))
      reject("a weight is given for the face to the left of halfedge " + std::to_string(h) +
             ", which does not exist");
    if(!(change.weight >= 0))
      reject(m_triangulation.name_of_face(h) + " gets weight " + text_of(change.weight) +
             "; it must be a number that is not negative, or infinity");
    // bounds the sum over all edges, whose lengths are at most 2^203 units
    const double cost =
        in_weight_unit(change.weight) * 0x1p204 * m_triangulation.number_of_halfedges();
    const double unit = m_triangulation.unit() * m_triangulation.weight_unit();
    const double largest = (std::max)(cost, cost * unit);
    if(std::isinf(largest) && !std::isinf(change.weight))
      reject(m_triangulation.name_of_face(h) + " gets weight " + text_of(change.weight) +
             ", which is too large beside the other weights and the lengths of the mesh. Use "
             "infinity for faces that paths must not enter.");
  }

  void check(const Barrier_change& change) const
  {
    const Index h = change.halfedge;
    if(h >= m_triangulation.number_of_halfedges())
      reject("a barrier is to change at halfedge " + std::to_string(h) + ", which does not exist");
    if(!m_triangulation.is_barrier(h))
      reject("the edge between vertices " + name_of_vertex(m_triangulation.source(h)) + " and " +
             name_of_vertex(m_triangulation.target(h)) +
             " is to become a barrier or to be lifted; only those edges can that were barriers "
             "when the graph was built, and are not at the border");
  }

  std::string name_of_vertex(const Index v) const
  {
    return std::to_string(m_triangulation.index(v));
  }

  double in_weight_unit(const double weight) const
  {
    return weight > 0
               ? (std::max)(weight / m_triangulation.weight_unit(), Face_weights::SMALLEST_WEIGHT)
               : 0;
  }

  Intrinsic_triangulation& m_triangulation;
};

} // namespace internal

/*!
 * \ingroup PkgGeodesicCostsChanges
 *
 * changes the weights of some faces. The unit of weights stays the same, so a weight that is less
 * than \f$10^{-307}\f$ of it is raised to that.
 *
 * \throws std::invalid_argument if a halfedge does not exist or is at the border, or if a weight is
 *         negative, not a number, or so large that costs might overflow a `double`. Then no weight
 *         has changed.
 *
 * Run time is linear in the number of changes. At the first call for a triangulation without
 * weights, it is \cgalBigO{n}.
 */
inline void set_weights(Intrinsic_triangulation& triangulation,
                        const std::vector<Weight_change>& changes)
{
  internal::Triangulation_changes(triangulation)
      .set_weights(changes, [](auto /* halfedge */, double /* before */, double /* after */) {});
}

/*!
 * \ingroup PkgGeodesicCostsChanges
 *
 * lifts barriers, or puts them back. Only edges that were barriers at construction can change.
 *
 * \throws std::invalid_argument if a halfedge does not exist or is not on such an edge. Then no
 *         barrier has changed.
 *
 * Run time is linear in the number of changes; at the first call, it is \cgalBigO{n}.
 */
inline void set_barriers(Intrinsic_triangulation& triangulation,
                         const std::vector<Barrier_change>& changes)
{
  internal::Triangulation_changes(triangulation).set_barriers(changes);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_TRIANGULATION_CHANGES_H
