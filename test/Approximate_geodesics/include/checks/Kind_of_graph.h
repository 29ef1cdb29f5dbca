// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_KIND_OF_GRAPH_H
#define APPROXIMATE_GEODESICS_TEST_KIND_OF_GRAPH_H

#include "oracles/test_oracles.h"

#include <functional>
#include <string>

namespace geodesics_test {

// A graph with its parameters.
template <typename GeodesicGraph>
struct Kind_of_graph
{
  using Graph = GeodesicGraph;

  std::string name;
  std::function<Graph(Triangulation)> make;
  double epsilon = infinity;   // the bound, if there is one
  double deviation = 0;        // relative, of distances that were found in another order
  double asymmetry = 1e-12;    // relative, of distances there and back
  double rounding_of_arcs = 0; // relative, of an edge or a chain of arcs along it
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_KIND_OF_GRAPH_H
