// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/random_soups.h"
#include "meshes/sample_meshes.h"
#include "meshes/soup_meshes.h"
#include "meshes/test_weights.h"
#include "oracles/test_oracles.h"

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace geodesics_test;

template <typename AnyMesh>
auto weights_of(const AnyMesh& mesh, const Weights& weights)
{
  return CGAL::parameters::face_weight_map(
      boost::make_iterator_property_map(weights.begin(), get(boost::face_index, mesh)));
}

void expect_same_bits_with_weights(const Soup& soup, Random& random)
{
  const Mesh mesh = to_mesh(soup);
  const Soup_mesh arrays = on_arrays(soup);
  const std::size_t source = soup.triangles.empty() ? 0 : soup.triangles.front()[1];
  const Weights weights = random_weights(mesh, random, 0.5, 4, 0.1);
  EXPECT_TRUE(have_same_bits(
      distances_from_vertex(arrays, source,
                            weights_of(arrays, weights).number_of_points_per_edge(1)),
      distances_from_vertex(mesh, source, weights_of(mesh, weights).number_of_points_per_edge(1))));
}

TEST(Triangle_soup_mesh, has_the_same_bits_as_a_mesh_with_links_and_weights)
{
  Random random(test_seed());
  for(const std::uint64_t seed : seeds_of_small_soups())
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_same_bits_with_weights(random_small_soup(seed), random);
  }
}

TEST(Triangle_soup_mesh, has_the_same_bits_with_weights_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  Random random(test_seed());
  for(const std::string name : {"elephant.off", "eight.off", "mannequin-devil.off"})
  {
    SCOPED_TRACE(name);
    expect_same_bits_with_weights(soup_of(sample_mesh(name)), random);
  }
}

} // namespace
