// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_GEODESIC_VISITOR_BASE_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_GEODESIC_VISITOR_BASE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * A visitor that does nothing. A class derived from it has to define only the functions that it
 * needs; these hide those below, which are not virtual.
 *
 * \cgalModels{GeodesicVisitor}
 */
struct Geodesic_visitor_base
{
  /// does nothing.
  template <typename Vertex>
  void on_settled(const Vertex& /* vertex */, double /* distance */)
  {
  }

  /// does nothing.
  void on_progress(std::size_t /* number_of_settled_nodes */, std::size_t /* number_of_nodes */) {}

  /// returns `true`.
  bool go_further() { return true; }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_GEODESIC_VISITOR_BASE_H
