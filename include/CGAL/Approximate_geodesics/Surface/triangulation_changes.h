// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_TRIANGULATION_CHANGES_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_TRIANGULATION_CHANGES_H

#include <CGAL/license/Approximate_geodesics.h>

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

/// \cond SKIP_IN_MANUAL

// The member functions of `Intrinsic_triangulation` for changes.

inline void Intrinsic_triangulation::set_weights(const std::vector<Weight_change>& changes)
{
  set_weights(changes, [](Index /* halfedge */, double /* before */, double /* after */) {});
}

template <typename F>
void Intrinsic_triangulation::set_weights(const std::vector<Weight_change>& changes, F f)
{
  for(const Weight_change& change : changes)
    check(change);
  if(!has_weights())
  {
    std::vector<double> ones(number_of_halfedges());
    for(Index h = 0; h < number_of_halfedges(); ++h)
      ones[h] = weight(h);
    set_weights({std::move(ones), 1});
  }
  for(const Weight_change& change : changes)
  {
    const double before = weight(change.halfedge), after = in_weight_unit(change.weight);
    for(const Index h : halfedges_of_face(change.halfedge))
      m_weight[h] = after;
    f(change.halfedge, before, after);
  }
}

inline void Intrinsic_triangulation::set_barriers(const std::vector<Barrier_change>& changes)
{
  for(const Barrier_change& change : changes)
    check(change);
  m_is_lifted.resize(m_is_barrier.size());
  for(const Barrier_change& change : changes)
    for(const Index h : {change.halfedge, opposite(change.halfedge)})
      m_is_lifted[h] = !change.is_barrier;
}

inline void Intrinsic_triangulation::check(const Weight_change& change) const
{
  const Index h = change.halfedge;
  if(h >= number_of_halfedges() || is_border(h))
    internal::reject("a weight is given for the face to the left of halfedge " + std::to_string(h) +
                     ", which does not exist");
  if(!(change.weight >= 0))
    internal::reject(name_of_face(h) + " gets weight " + internal::text_of(change.weight) +
                     "; it must be a number that is not negative, or infinity");
  // bounds the sum over all edges, whose lengths are at most 2^203 units
  const double cost = in_weight_unit(change.weight) * 0x1p204 * number_of_halfedges();
  const double largest = (std::max)(cost, cost * (m_unit * m_weight_unit));
  if(std::isinf(largest) && !std::isinf(change.weight))
    internal::reject(name_of_face(h) + " gets weight " + internal::text_of(change.weight) +
                     ", which is too large beside the other weights and the lengths of the "
                     "mesh. Use infinity for faces that paths must not enter.");
}

inline void Intrinsic_triangulation::check(const Barrier_change& change) const
{
  const Index h = change.halfedge;
  if(h >= number_of_halfedges())
    internal::reject("a barrier is to change at halfedge " + std::to_string(h) +
                     ", which does not exist");
  if(!is_barrier(h))
    internal::reject("the edge between vertices " + std::to_string(index(source(h))) + " and " +
                     std::to_string(index(target(h))) +
                     " is to become a barrier or to be lifted; only those edges can that were "
                     "barriers when the graph was built, and are not at the border");
}

inline double Intrinsic_triangulation::in_weight_unit(const double weight) const
{
  return weight > 0 ? (std::max)(weight / m_weight_unit, Face_weights::SMALLEST_WEIGHT) : 0;
}

/// \endcond

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_TRIANGULATION_CHANGES_H
