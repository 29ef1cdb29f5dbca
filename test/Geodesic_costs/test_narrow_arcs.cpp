// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/internal/Steiner/Narrow_arcs.h>

#include "checks/expect_costs.h"
#include "meshes/Random_points.h"
#include "meshes/test_meshes.h"
#include "meshes/test_weights.h"
#include "oracles/Full_graph.h"

#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// Which arcs a Steiner graph leaves out since they make small angles with sides, what the ways in
// their place cost, and that searches find all distances of the graph that is left.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::internal::Corner;
using AG::internal::Narrow_arcs;
using AG::internal::Point_row;

// ----- two sides of a corner

// Random places on a side of length 1, denser near its ends.
std::vector<float> random_row(Random& random)
{
  std::vector<double> parts(100);
  for(double& part : parts)
  {
    const double from_end = std::pow(10, random.between(-3, std::log10(0.5)));
    part = random.below(2) == 0 ? from_end : 1 - from_end;
  }
  std::sort(parts.begin(), parts.end());
  std::vector<float> result;
  for(const double part : parts)
    result.push_back(static_cast<float>(part <= 0.5 ? part : part - 1));
  return result;
}

// Two sides of a corner, of lengths 1 and 1.2.
struct Two_sides
{
  Two_sides(Random& random, const double angle_at_corner, const double angle_that_is_small)
    : corner(1, 1.2, std::sqrt(1 + 1.2 * 1.2 - 2.4 * std::cos(angle_at_corner))),
      small(angle_that_is_small),
      first(random_row(random)),
      second(random_row(random))
  {
  }

  Point_row row(const bool is_first) const
  {
    const auto& positions = is_first ? first : second;
    return {0,
            static_cast<std::uint32_t>(positions.size()),
            positions.data(),
            is_first ? 1 : 1.2,
            is_first ? 0u : 1u,
            corner,
            1};
  }

  Corner corner;
  double small;
  std::vector<float> first, second;
};

// Expects that the arc from a point of `side` to one of `row` is left out in both directions, and
// if so, that there is a way along the side of the one that is farther from the corner.
bool expect_arc_or_way(const Two_sides& sides,
                       const Point_row& side,
                       const Point_row& row,
                       const std::uint32_t i,
                       const std::uint32_t k)
{
  const Narrow_arcs there(sides.corner, std::tan(sides.small), side, row),
      back(sides.corner, std::tan(sides.small), row, side);
  const auto has_arc = [&](const std::uint32_t n) {
    return there.first(n) <= k && k < there.beyond(n);
  };
  EXPECT_EQ(has_arc(i), back.first(k) <= i && i < back.beyond(k));
  const double x = side.distance_of_node(i), y = row.distance_of_node(k);
  if(has_arc(i) || x < y)
    return !has_arc(i);
  std::uint32_t n = i;
  while(!has_arc(n))
    --n; // to the corner, which has all arcs
  const double z = side.distance_of_node(n);
  EXPECT_LE(x - z + sides.corner.distance(z, y),
            sides.corner.distance(x, y) / std::cos(sides.small / 2) * (1 + 1e-12));
  return true;
}

TEST(Narrow_arcs, are_left_out_in_both_directions_where_another_way_is_hardly_longer)
{
  Random random(test_seed());
  for(const double angle : {1e-4, 0.01, 0.3, 1., 1.5, 2., 3., 3.14})
    for(const double small : {0.05, 0.25, 0.5})
    {
      SCOPED_TRACE(angle);
      const Two_sides sides(random, angle, small);
      const Point_row side = sides.row(true), row = sides.row(false);
      std::size_t number_left_out = 0;
      for(std::uint32_t i = 0; i < side.size; ++i)
        for(std::uint32_t k = 0; k < row.size; ++k)
        {
          number_left_out += expect_arc_or_way(sides, side, row, i, k);
          expect_arc_or_way(sides, row, side, k, i);
        }
      EXPECT_GT(number_left_out, 0u);
      EXPECT_LT(number_left_out, std::size_t(side.size) * row.size);
    }
}

// ----- graphs

// Places without a bound, and arcs that are left out nevertheless.
struct Random_points_without_narrow_arcs : Random_points
{
  using Random_points::Random_points;
  double tangent_of_narrow_arcs() const { return tangent; }

  double tangent = 0.3;
};

// The points of `Geometric_points`, and all arcs.
class Geometric_points_with_all_arcs
{
public:
  using Index = Triangulation::Index;
  static constexpr bool makes_equal_parts = false;

  explicit Geometric_points_with_all_arcs(const double epsilon) : m_points(epsilon) {}

  void prepare(const Triangulation& t, const std::size_t largest) { m_points.prepare(t, largest); }
  std::size_t number_of_points(const Triangulation& t, const Index h) const
  {
    return m_points.number_of_points(t, h);
  }
  void place(const Triangulation& t, const Index h, float* positions, const std::size_t n) const
  {
    m_points.place(t, h, positions, n);
  }
  double epsilon(const Triangulation& t) const { return m_points.epsilon(t); }
  std::size_t memory() const { return m_points.memory(); }

private:
  Geometric_points m_points;
};

TEST(Steiner_graph, finds_the_cheapest_of_all_paths_without_narrow_arcs)
{
  Random random(test_seed());
  std::size_t number_of_others = 0;
  for(const double angle : {0.5, 0.01})
    for(const Soup& soup : thin_soups(angle))
      for(const double range : {1., 3.})
      {
        SCOPED_TRACE(angle);
        const Mesh mesh = to_mesh(soup);
        const double extreme = range > 1 ? 0.2 : 0; // weights 0 and infinity, of each
        const Weights weights = random_weights(mesh, random, 1, range, extreme);
        const Random_points_without_narrow_arcs points(220, random.below(1000));
        const auto graph = steiner_graph(mesh, weights, points);
        const Full_graph reference(mesh, graph);
        const auto with_all_arcs =
            steiner_graph(mesh, weights, static_cast<const Random_points&>(points));
        AG::Propagation<Steiner_graph<Random_points_without_narrow_arcs>> search(graph);
        AG::Propagation<Steiner_graph<Random_points>> search_of_all(with_all_arcs);
        for(std::size_t i = 0; i < 2; ++i)
        {
          const Node source = static_cast<Node>(random.below(graph.number_of_nodes()));
          search.run_from(source);
          search_of_all.run_from(source);
          expect_about_the_same(distances_of_nodes(search), reference.distances(source),
                                rounding_of_costs);
          const double longest = 1 / std::cos(std::atan(points.tangent) / 2);
          for(Node n = 0; n < graph.number_of_nodes(); ++n)
          {
            const double found = search.distance(n), least = search_of_all.distance(n);
            EXPECT_LE(found, least * longest * (1 + rounding_of_costs));
            EXPECT_GE(found, least * (1 - rounding_of_costs));
            number_of_others += found > least * (1 + rounding_of_costs);
          }
        }
      }
  EXPECT_GT(number_of_others, 0u);
}

// The costs of vertices, and how many arcs the search looks at.
template <typename Placement>
std::vector<double> costs_and_arcs(const Mesh& mesh,
                                   const Weights& weights,
                                   const Placement& placement,
                                   const Vertex source,
                                   std::size_t& number_of_arcs)
{
  const auto graph = steiner_graph(mesh, weights, placement);
  AG::Propagation<Steiner_graph<Placement>> search(graph);
  search.collect_statistics(true);
  search.run_from(graph.triangulation().vertex(source.idx()));
  number_of_arcs += search.statistics().relaxations;
  std::vector<double> result;
  for(const Vertex v : mesh.vertices())
    result.push_back(search.distance(graph.triangulation().vertex(v.idx())));
  return result;
}

TEST(Geometric_points, leave_out_arcs_that_hardly_matter)
{
  Random random(test_seed());
  std::size_t arcs = 0, all_arcs = 0;
  for(const double epsilon : {1., 0.1})
    for(const double angle : {0.05, 2e-3})
      for(const Soup& soup : thin_soups(angle))
      {
        const Mesh mesh = to_mesh(soup);
        const Weights weights = random_weights(mesh, random, 1, 4);
        for(const Vertex source : mesh.vertices())
        {
          const auto found = costs_and_arcs(mesh, weights, Geometric_points(epsilon), source, arcs);
          const auto all = costs_and_arcs(mesh, weights, Geometric_points_with_all_arcs(epsilon),
                                          source, all_arcs);
          for(std::size_t i = 0; i < found.size(); ++i)
          {
            EXPECT_GE(found[i], all[i] * (1 - rounding_of_costs));
            EXPECT_LE(found[i], all[i] * (1 + epsilon / 8));
          }
        }
      }
  EXPECT_NE(arcs, all_arcs); // or none was left out
}

} // namespace
