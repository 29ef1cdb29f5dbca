// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that must not compile, each below the message that the compiler has to print for it.

#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>

#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

void make_grids_wrongly()
{
  // epsilon: there is no bound on heights, or with costs that depend on the direction
  AG::Grid_graph(AG::Grid_shape(), 1, parameters::heights(std::vector<double>()).epsilon(0.1));

  // a cost function of the slope needs the named parameter heights
  AG::Grid_graph(AG::Grid_shape(), 1,
                 parameters::face_weight_map(AG::directional_cost(AG::Hiking_time())));

  // max_slope needs the named parameter heights
  AG::Grid_graph(AG::Grid_shape(), 1, parameters::max_slope(0.3));
}
