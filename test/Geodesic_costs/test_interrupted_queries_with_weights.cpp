// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_with_points.h"
#include "fixtures/Interrupted_query.h"
#include "meshes/test_weights.h"

#include <gtest/gtest.h>

namespace {

using namespace geodesics_test;

template <typename GeodesicGraph>
class Interrupted_weighted_query : public Interrupted_query<GeodesicGraph>
{
public:
  using Interrupted_query<GeodesicGraph>::Interrupted_query;

  void expect_survival_of_new_weights() const
  {
    const Weights weights =
        weights_by_place(this->m_mesh, [](const Point& p) { return 1 + p.x(); });
    const auto cost = [](auto& q) {
      return q.paths->shortest_distance_to_source_points(Vertex(62)).first;
    };
    auto example = this->query();
    const double before = cost(example);
    example.paths->set_face_weights(weight_map(weights));
    const double after = cost(example);
    this->expect_survival_of(
        [&](auto& q) {
          q.paths->shortest_distance(this->m_source, this->m_target); // to have more to forget
          q.paths->build_sequence_tree();
          q.paths->set_face_weights(weight_map(weights));
        },
        [&](auto& q) { // not a mixture
          const double found = cost(q), expected = found < (before + after) / 2 ? before : after;
          EXPECT_NEAR(found, expected, 1e-12 * expected);
        });
  }
};

TEST(Interrupted_queries, of_a_steiner_graph)
{
  const Interrupted_weighted_query<Steiner_graph<Fixed_number_of_points>> query(
      graph_with_spaced_points(2));
  query.expect_survival_of_all();
  query.expect_survival_of_new_weights();
}

} // namespace
