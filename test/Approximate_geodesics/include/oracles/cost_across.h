// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_COST_ACROSS_H
#define APPROXIMATE_GEODESICS_TEST_COST_ACROSS_H

#include "oracles/test_oracles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace geodesics_test {

// A part of the plane between two parallel lines.
struct Layer
{
  double thickness, weight;
};

/*
 * The cost of the cheapest path across layers, and by `shift` along them. It is refracted at their
 * borders: weight times sine is the same in all of them, and not more than the smallest weight. The
 * cost as a function of this constant is concave, and largest for the one of the path. A layer
 * without thickness is a road that the path may use.
 */
inline double cost_across(const std::vector<Layer>& layers, const double shift)
{
  double low = 0, high = infinity;
  for(const Layer& layer : layers)
    high = (std::min)(high, layer.weight);
  const auto cost = [&](const double p) {
    double result = p * shift;
    for(const Layer& layer : layers)
      result += layer.thickness * std::sqrt((layer.weight - p) * (layer.weight + p));
    return result;
  };
  double best = (std::max)(cost(low), cost(high));
  constexpr double golden = 0.6180339887498949;
  for(std::size_t i = 0; i < 100; ++i)
  {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    best = (std::max)({best, cost(a), cost(b)});
    (cost(a) < cost(b) ? low : high) = cost(a) < cost(b) ? a : b;
  }
  return best;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_COST_ACROSS_H
