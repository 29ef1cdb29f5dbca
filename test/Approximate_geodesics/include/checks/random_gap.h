// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_RANDOM_GAP_H
#define APPROXIMATE_GEODESICS_TEST_RANDOM_GAP_H

#include "checks/test_random.h"

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>

#include <cmath>

namespace geodesics_test {

// What a key may be farther than the last one extracted: nothing, a little, as much as in a search,
// and sometimes more than any arc.
inline double random_gap(const CGAL::Approximate_geodesics::Arc_lengths& arcs, Random& random)
{
  switch(random.below(6))
  {
  case 0:
    return 0;
  case 1:
    return arcs.shortest * random.between(0, 1);
  case 2:
    return arcs.longest;
  case 3: // any order of magnitude
    return arcs.longest * std::pow(2., -random.between(0, 60));
  default:
    return random.between(0, 2 * arcs.mean);
  }
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_RANDOM_GAP_H
