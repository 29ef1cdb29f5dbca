// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A search in tiles, in files that go afterwards.

#include <CGAL/Approximate_geodesics/Grid_files/Tiled_grid_search.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>

#include <cstdlib>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

int main()
{
  const auto graph_of_window = [](const AG::Grid_window& window) {
    return AG::Grid_graph(AG::Grid_shape{window.columns, window.rows},
                          std::vector<double>(window.columns * window.rows, 1));
  };
  AG::Tiled_grid_search search(100, 50, graph_of_window, {AG::Grid_cell{3, 4}}, 20,
                               "consumer_files");
  const bool is_done = search.run();
  const double distance = search.distance({83, 4});
  search.remove_files();
  return is_done && distance == 80 ? EXIT_SUCCESS : EXIT_FAILURE;
}
