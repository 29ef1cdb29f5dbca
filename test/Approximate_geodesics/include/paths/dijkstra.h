// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_DIJKSTRA_H
#define APPROXIMATE_GEODESICS_TEST_DIJKSTRA_H

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace geodesics_test {

// Dijkstra's algorithm as in a textbook, sharing nothing with what is tested: the distances of all
// nodes, of type `Number`, infinity where there is no path. `for_each_arc(node, f)` calls
// `f(target, length)`.
template <typename Number, typename ForEachArc>
std::vector<Number> textbook_distances(const std::size_t number_of_nodes,
                                       const std::size_t source,
                                       const ForEachArc& for_each_arc)
{
  std::vector<Number> result(number_of_nodes, std::numeric_limits<Number>::infinity());
  using Node_at = std::pair<Number, std::size_t>; // a distance
  std::priority_queue<Node_at, std::vector<Node_at>, std::greater<>> queue;
  result[source] = 0;
  queue.push({0, source});
  while(!queue.empty())
  {
    const auto [distance, node] = queue.top();
    queue.pop();
    if(distance > result[node])
      continue;
    for_each_arc(node, [&, d = distance](const std::size_t target, const Number length) {
      if(!(d + length < result[target]))
        return;
      result[target] = d + length;
      queue.push({d + length, target});
    });
  }
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_DIJKSTRA_H
