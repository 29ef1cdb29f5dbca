// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_with_points.h"
#include "fixtures/Properties.h"
#include "meshes/random_soups.h"
#include "meshes/test_weights.h"
#include "oracles/test_oracles.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace {

using namespace geodesics_test;

Method method_with_points(const std::size_t number)
{
  return method(graph_with_spaced_points(number));
}

TEST_P(Properties, more_points_are_never_worse_if_the_others_are_among_them)
{
  const Triangulation triangulation(m_mesh, with_weights(random_weights(m_mesh, m_random, 0.2, 5)));
  const Vertex s = random_source();
  Values last = method_with_points(0).on(m_mesh, triangulation)({{s}});
  for(const std::size_t number : {1u, 3u, 7u})
  {
    const Values found = method_with_points(number).on(m_mesh, triangulation)({{s}});
    expect_at_most(found, last, 1e-14);
    last = found;
  }
}

TEST_P(Properties, no_points_make_the_edge_graph)
{
  const Triangulation triangulation(m_mesh);
  const Vertex s = random_source();
  EXPECT_TRUE(have_same_bits(method_with_points(0).on(m_mesh, triangulation)({{s}}),
                             method(edge_graph()).on(m_mesh, triangulation)({{s}})));
}

TEST_P(Properties, without_a_face_nothing_is_nearer)
{
  const Vertex s = random_source();
  Weights weights(m_mesh.number_of_faces(), 1);
  const Triangulation whole(m_mesh, with_weights(weights));
  for(int i = 0; i < 4; ++i)
    weights[m_random.below(weights.size())] = infinity;
  const Triangulation rest(m_mesh, with_weights(weights));
  const Barriers barriers = random_barriers(m_mesh, 0.2, m_random);
  const Triangulation divided(m_mesh, with_barriers(barriers));
  for(const Method& m : {method_with_points(1), method_with_points(4),
                         method(graph_with_points("geometric points", lenient_points(0.5), 0.5))})
  {
    SCOPED_TRACE(m.name);
    const Values distances = m.on(m_mesh, whole)({{s}});
    expect_at_most(distances, m.on(m_mesh, rest)({{s}}), tolerance(m));
    expect_at_most(distances, m.on(m_mesh, divided)({{s}}), tolerance(m));
  }
}

TEST_P(Properties, costs_grow_with_weights)
{
  const Vertex s = random_source();
  const Weights weights = random_weights(m_mesh, m_random, 0.2, 5, 0.05);
  Weights twice = weights, larger = weights;
  for(double& w : twice)
    w *= 2;
  for(double& w : larger)
    w *= m_random.between(1, 2);
  const Triangulation once(m_mesh, with_weights(weights));
  for(const std::size_t number : {0u, 1u, 4u})
  {
    SCOPED_TRACE(testing::Message() << number << " points");
    const Method m = method_with_points(number);
    const Values costs = m.on(m_mesh, once)({{s}});
    Values expected = costs;
    for(double& c : expected)
      c *= 2;
    EXPECT_TRUE(
        have_same_bits(m.on(m_mesh, Triangulation(m_mesh, with_weights(twice)))({{s}}), expected));
    expect_at_most(costs, m.on(m_mesh, Triangulation(m_mesh, with_weights(larger)))({{s}}), 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(On_small_meshes,
                         Properties,
                         testing::ValuesIn(random_meshes(random_small_soup,
                                                         seeds_of_small_soups())));
INSTANTIATE_TEST_SUITE_P(On_larger_meshes,
                         Properties,
                         testing::ValuesIn(random_meshes(random_large_soup,
                                                         seeds_of_large_soups())));

} // namespace
