// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_RECORDER_H
#define APPROXIMATE_GEODESICS_TEST_RECORDER_H

#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>

#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace geodesics_test {

// A visitor that remembers what it was told, and interrupts the run when it was told so.
template <typename Vertex>
struct Recorder
{
  void on_settled(const Vertex v, const double distance)
  {
    if(settled.size() == throw_at)
      throw std::runtime_error("from the visitor");
    settled.push_back({v, distance});
  }

  void on_progress(const std::size_t number_settled, const std::size_t number_of_nodes)
  {
    progress.push_back({number_settled, number_of_nodes});
  }

  bool go_further()
  {
    ++questions;
    return settled.size() < stop_at;
  }

  static constexpr std::size_t never = (std::numeric_limits<std::size_t>::max)();

  std::size_t throw_at = never;
  std::size_t stop_at = never;
  std::vector<std::pair<Vertex, double>> settled = {};
  std::vector<std::pair<std::size_t, std::size_t>> progress = {};
  std::size_t questions = 0;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_RECORDER_H
