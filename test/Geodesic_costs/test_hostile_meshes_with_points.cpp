// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_everything.h"
#include "checks/expect_message.h"
#include "fixtures/expect_distances_on_fan.h"
#include "meshes/Cut_mesh.h"
#include "meshes/test_weights.h"
#include "peers/Published_geometric_points.h"

#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/Geodesic_costs/equal_parts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// Graphs with points on edges, on meshes that are as bad as they get: also with weights and
// barriers like that.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST(Hostile_meshes, equally_spaced_points)
{
  expect_everything<AG::Steiner_graph<AG::Fixed_number_of_points>>(
      parameters::number_of_points_per_edge(3), {});
}

TEST(Hostile_meshes, geometric_points)
{
  expect_everything<AG::Steiner_graph<AG::Geometric_points>>(lenient_parameters(0.5), {});
}

// ----- other placements

// By the index of the vertex.
template <typename Graph>
std::vector<double> distances_from(const Vertex source, Basic_mesh_search<Graph>& search)
{
  std::vector<double> result(search.mesh().num_vertices(), infinity);
  search.search().run_from(search.node(source));
  for(const Vertex v : search.mesh().vertices())
    result[v.idx()] = search.search().distance(search.node(v));
  return result;
}

template <typename Placement>
void expect_distances(Known_distances& known, const Placement& placement)
{
  const Mesh& mesh = known.mesh;
  Basic_mesh_search<Steiner_graph<Placement>> search(
      mesh, Steiner_graph<Placement>(Triangulation(mesh), placement));
  ASSERT_LE(search.graph().number_of_points(), 3000u) << "leave this mesh out";
  const Bound bound = bound_of(search.graph());
  for(const Surface_point& source : some_vertices(mesh))
  {
    const std::vector<double> found = distances_from(std::get<Vertex>(source), search);
    for(const Vertex v : mesh.vertices())
      expect_distance(found[v.idx()] < infinity ? found[v.idx()] : -1, known, bound, source, v);
  }
}

// Where a placement wants more points than there is time for: arcs are as many as pairs of them.
const std::set<std::string> many_equally_dense_points = {"thousands of components"};
const std::set<std::string> many_published_points = {"needles of 1e3",
                                                     "caps of 1e3",
                                                     "needles of 1e6",
                                                     "caps of 1e6",
                                                     "needles of 1e9",
                                                     "caps of 1e9",
                                                     "needles of 1e12",
                                                     "caps of 1e12",
                                                     "needles of 1e200",
                                                     "caps of 1e200",
                                                     "faces without area",
                                                     "faces with hardly any area",
                                                     "edges of length zero",
                                                     "a spike",
                                                     "edges from 1 to 1e12",
                                                     "edges from 1e-30 to 1",
                                                     "edges from 1e-60 to 1",
                                                     "edges from 1e-120 to 1",
                                                     "isolated vertices among faces",
                                                     "thousands of components",
                                                     "a Klein bottle, cut"};

std::set<std::string> and_refused(std::set<std::string> names)
{
  names.insert(refused_across_faces().begin(), refused_across_faces().end());
  return names;
}

TEST(Hostile_meshes, equally_dense_points)
{
  for_accepted_meshes(and_refused(many_equally_dense_points), [](Known_distances& known) {
    Long longest = 0;
    for(const Long length : known.lengths_of_edges())
      longest = (std::max)(longest, length);
    const double smallest = std::numeric_limits<double>::denorm_min(); // where all lengths are zero
    expect_distances(known, AG::Points_at_interval((std::max)(double(longest / 4), smallest)));
  });
}

TEST(Hostile_meshes, published_points)
{
  for_accepted_meshes(and_refused(many_published_points), [](Known_distances& known) {
    expect_distances(known, AG::Published_geometric_points(2));
  });
}

// ----- weights

struct Kind_of_weights
{
  std::string name;
  Weights weights; // of one face after the other, again and again
  std::set<std::string> left_out = {};
};

const std::vector<Kind_of_weights> kinds_of_weights = {
    {"free", {0}},
    {"forbidden", {infinity}},
    {"1e-300", {1e-300}},
    {"1e300", {1e300}},
    {"free, forbidden or neither", {0, 1, 1, infinity, 2}},
    {"1 and 1e-300", {1, 1, 1e-300}, {"needles of 1e200", "a part of size 1e-120"}},
    {"1 and 1e300", {1, 1e300, 1}, {"needles of 1e200", "a part of size 1e-120"}}};

Weights weights_of_faces(const Mesh& mesh, const Kind_of_weights& kind)
{
  Weights result(mesh.num_faces());
  for(std::size_t i = 0; i < result.size(); ++i)
    result[i] = kind.weights[i % kind.weights.size()];
  return result;
}

// Costs in the graph that has the same points, and all arcs, against those of the package.
class Cost_check
{
public:
  Cost_check(const Known_distances& known, const Weights& weights)
    : m_mesh(known.mesh),
      m_weights(weights),
      m_rounding(largest_finite(weights) * known.error_of_flat_faces() +
                 Long(std::numeric_limits<double>::denorm_min()))
  {
  }

  void expect_costs(const std::vector<Surface_point>& sources) const
  {
    const Long_steiner_graph reference(m_mesh, m_weights, number_of_points);
    Search search(m_mesh, Graph(Triangulation(m_mesh, with_weights(m_weights)), placement()));
    for(const Surface_point& source : sources)
      expect_same(distances_from(std::get<Vertex>(source), search),
                  reference.graph().distances(std::get<Vertex>(source).idx()));
  }

  // Barriers are borders of the mesh that is cut along them.
  void expect_costs(const std::vector<Surface_point>& sources, const Barriers& barriers) const
  {
    const Cut_mesh cut(m_mesh, barriers);
    const Long_steiner_graph reference(cut.mesh(), m_weights, number_of_points);
    const auto np = with_weights(m_weights).edge_is_constrained_map(barrier_map(barriers));
    Search search(m_mesh, Graph(Triangulation(m_mesh, np), placement()));
    for(const Surface_point& source : sources)
    {
      std::vector<Long> expected(m_mesh.num_vertices(), infinity);
      for(const Vertex copy : cut.copies(std::get<Vertex>(source)))
        lower(expected, reference.graph().distances(copy.idx()), cut);
      expect_same(distances_from(std::get<Vertex>(source), search), expected);
    }
  }

private:
  using Graph = Steiner_graph<Fixed_number_of_points>;
  using Search = Basic_mesh_search<Graph>;

  static constexpr std::size_t number_of_points = 3;

  static Fixed_number_of_points placement() { return Fixed_number_of_points(number_of_points); }

  void
  lower(std::vector<Long>& costs, const std::vector<Long>& of_copies, const Cut_mesh& cut) const
  {
    for(const Vertex v : m_mesh.vertices())
      for(const Vertex copy : cut.copies(v))
        costs[v.idx()] = (std::min)(costs[v.idx()], of_copies[copy.idx()]);
  }

  void expect_same(const std::vector<double>& found, const std::vector<Long>& expected) const
  {
    for(const Vertex v : m_mesh.vertices())
    {
      const double cost = found[v.idx()];
      const Long wanted = expected[v.idx()];
      ASSERT_EQ(cost == infinity, wanted == infinity) << "at " << v;
      if(cost < infinity)
      {
        EXPECT_LE(std::abs(cost - wanted), Long(1e-12) * wanted + m_rounding)
            << cost << " instead of " << wanted << " at " << v;
      }
    }
  }

  const Mesh& m_mesh;
  const Weights& m_weights;
  const Long m_rounding;
};

// Costs beyond the largest number are refused.
bool do_fit(const Known_distances& known, const Weights& weights)
{
  Long result = 0;
  for(const Long length : known.lengths_of_edges())
    result += 2 * length * Long(largest_finite(weights));
  return result < (std::numeric_limits<double>::max)();
}

TEST(Hostile_weights, are_those_of_costs)
{
  for(const Kind_of_weights& kind : kinds_of_weights)
    for_accepted_meshes(refused_across_faces(), [&](Known_distances& known) {
      if(kind.left_out.count(known.row.name) > 0)
        return;
      SCOPED_TRACE(kind.name);
      const Weights weights = weights_of_faces(known.mesh, kind);
      const Cost_check check(known, weights);
      if(do_fit(known, weights))
        check.expect_costs(some_vertices(known.mesh));
      else
        expect_message<std::invalid_argument>([&] { check.expect_costs({}); }, "are too large");
    });
}

TEST(Hostile_weights, go_with_barriers)
{
  Random random(5);
  // cutting parts such vertices
  const std::set<std::string> parted = {"a pinched vertex", "removed elements", "a loop"};
  for_accepted_meshes(and_refused(parted), [&](Known_distances& known) {
    const Weights weights(known.mesh.num_faces(), 1);
    const Cost_check check(known, weights);
    for(const double share : {0.3, 1.})
      check.expect_costs(some_vertices(known.mesh), random_barriers(known.mesh, share, random));
  });
}

// Between points that are no vertices, and along paths.
TEST(Hostile_weights, give_costs_to_all_points)
{
  for(const Kind_of_weights& kind : kinds_of_weights)
    for_accepted_meshes(refused_across_faces(), [&](Known_distances& known) {
      SCOPED_TRACE(kind.name);
      const Weights weights = weights_of_faces(known.mesh, kind);
      if(!do_fit(known, weights))
        return;
      Shortest_paths<Steiner_graph<Fixed_number_of_points>> paths(
          known.mesh, with_weights(weights).number_of_points_per_edge(2));
      const std::vector<Surface_point> points = some_points(known.mesh);
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        paths.set_sources({points[i]});
        for(std::size_t j = 0; j < points.size(); ++j)
        {
          const double cost = paths.distance(points[j]),
                       pair = paths.pair_distance(points[i], points[j]);
          const Found_path path = paths.path(points[j], false);
          EXPECT_TRUE(cost == -1 || (cost >= 0 && cost < infinity)) << cost;
          EXPECT_NEAR(pair, cost, 1e-12 * std::abs(cost));
          EXPECT_EQ(cost == -1, path.points.empty()) << i << ' ' << j;
          EXPECT_LE(std::abs(path.length - cost),
                    1e-12 * std::abs(cost) +
                        largest_finite(weights) * double(known.error_of_flat_faces()) +
                        std::numeric_limits<double>::denorm_min());
        }
      }
    });
}

TEST(Hostile_meshes, vertex_with_very_many_neighbors_and_points)
{
  expect_distances_on_fan<AG::Steiner_graph<AG::Fixed_number_of_points>>(
      1000, parameters::number_of_points_per_edge(1));
}

} // namespace
