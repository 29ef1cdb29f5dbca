// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CANDIDATE_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CANDIDATE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/optional_members.h>

#include <type_traits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// A path that ends with an arc just looked at.
struct Candidate
{
  double distance;
  Labels::Node node;
  Labels::Node predecessor;
};

// The same with how the path arrives.
template <typename Arrival>
struct Arriving_candidate : Candidate
{
  Arrival arrival;
};

template <typename Graph>
using Candidate_of =
    std::conditional_t<needs_bounds<Graph>, Arriving_candidate<Arrival_of<Graph>>, Candidate>;

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CANDIDATE_H
