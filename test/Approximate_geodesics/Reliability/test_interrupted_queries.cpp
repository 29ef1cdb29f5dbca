// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/failing_allocation.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/surface_points.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <memory>
#include <vector>

// Member functions of the class that end for want of memory.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

template <typename GeodesicGraph>
struct Class_query
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, GeodesicGraph>;

  std::unique_ptr<Paths> paths;
  std::vector<Point> points = {}; // what a function has written, and returned
  double length = 0;
};

// An object with two sources, and what it is asked for.
template <typename GeodesicGraph>
class Interrupted_query
{
  using Paths = typename Class_query<GeodesicGraph>::Paths;
  using Operation = std::function<void(Class_query<GeodesicGraph>&)>;

public:
  explicit Interrupted_query(const Kind_of_graph<GeodesicGraph>& kind)
    : m_mesh(to_mesh(terrain(9, 7, m_random))), m_kind(kind)
  {
  }

  void expect_survival_of_construction() const
  {
    expect_survival<Class_query<GeodesicGraph>>(
        {[] { return Class_query<GeodesicGraph>(); },
         [&](Class_query<GeodesicGraph>& query) {
           query.paths = std::make_unique<Paths>(m_mesh, m_kind.make(Triangulation(m_mesh)));
         },
         [&](Class_query<GeodesicGraph>& query) {
           query.paths->add_source_point(m_source);
           return values(query);
         },
         [](Class_query<GeodesicGraph>& query) { EXPECT_EQ(query.paths, nullptr); }});
  }

  void expect_survival_of(
      const Operation& operation, const Operation& check = [](auto&) {}) const
  {
    expect_survival<Class_query<GeodesicGraph>>(
        {[&] { return query(); }, operation,
         [&](Class_query<GeodesicGraph>& query) { return values(query); },
         [&](Class_query<GeodesicGraph>& query) {
           EXPECT_EQ(query.paths->number_of_source_points(), 2u);
           EXPECT_TRUE(query.points.empty());
           check(query);
         },
         m_kind.deviation});
  }

  void expect_survival_of_all() const
  {
    expect_survival_of_construction();
    expect_survival_of([&](auto& q) { q.paths->add_source_point(Vertex(60)); });
    expect_survival_of([&](auto& q) { q.paths->add_source_point(m_target, 0.25); });
    expect_survival_of([&](auto& q) { q.paths->build_sequence_tree(); });
    expect_survival_of(
        [&](auto& q) { q.length = q.paths->shortest_distance_to_source_points(m_target).first; });
    expect_survival_of([&](auto& q) {
      q.length =
          q.paths->shortest_path_points_to_source_points(Vertex(62), std::back_inserter(q.points))
              .first;
    });
    expect_survival_of([&](auto& q) { q.length = q.paths->shortest_distance(m_source, m_target); });
    expect_survival_of([&](auto& q) {
      q.length = q.paths->shortest_path_points(m_source, m_target, std::back_inserter(q.points));
    });
  }

  void expect_survival_of_limited_runs() const
  {
    const std::vector<Surface_point> targets = {m_target};
    expect_survival_of([&](auto& q) {
      q.paths->build_sequence_tree(parameters::targets(targets).maximum_distance(5));
    });
  }

  void expect_survival_of_straightening() const
  {
    expect_survival_of([&](auto& q) {
      q.length = q.paths
                     ->shortest_path_points_to_source_points(
                         Vertex(62), std::back_inserter(q.points), parameters::straighten(true))
                     .first;
    });
    expect_survival_of([&](auto& q) {
      q.length = q.paths->shortest_path_points(m_source, m_target, std::back_inserter(q.points),
                                               parameters::straighten(true));
    });
  }

  void expect_survival_of_new_weights() const
  {
    const Weights weights = weights_by_place(m_mesh, [](const Point& p) { return 1 + p.x(); });
    const auto cost = [](auto& q) {
      return q.paths->shortest_distance_to_source_points(Vertex(62)).first;
    };
    auto example = query();
    const double before = cost(example);
    example.paths->set_face_weights(weight_map(weights));
    const double after = cost(example);
    expect_survival_of(
        [&](auto& q) {
          q.paths->shortest_distance(m_source, m_target); // to have more to forget
          q.paths->build_sequence_tree();
          q.paths->set_face_weights(weight_map(weights));
        },
        [&](auto& q) { // not a mixture
          const double found = cost(q), expected = found < (before + after) / 2 ? before : after;
          EXPECT_NEAR(found, expected, 1e-12 * expected);
        });
  }

private:
  Class_query<GeodesicGraph> query() const
  {
    Class_query<GeodesicGraph> result{
        std::make_unique<Paths>(m_mesh, m_kind.make(Triangulation(m_mesh)))};
    result.points.reserve(100);
    result.paths->add_source_point(Vertex(3));
    result.paths->add_source_point(m_source, 0.5);
    return result;
  }

  Values values(Class_query<GeodesicGraph>& query) const
  {
    Values result = {query.length};
    for(const Point& p : query.points) // without signs, as differences are relative
      result.insert(result.end(), {std::abs(p.x()), std::abs(p.y()), p.z()});
    for(const Vertex v : m_mesh.vertices())
      result.push_back(query.paths->shortest_distance_to_source_points(v).first);
    return result;
  }

  Random m_random = Random(test_seed());
  const Mesh m_mesh;
  const Kind_of_graph<GeodesicGraph> m_kind;
  const Face_location m_source = random_face_location(m_mesh, m_random);
  const Surface_point m_target = random_face_location(m_mesh, m_random);
};

TEST(Interrupted_queries, of_the_edge_graph)
{
  const Interrupted_query query(edge_graph());
  query.expect_survival_of_all();
  query.expect_survival_of_limited_runs();
  query.expect_survival_of_straightening();
}

TEST(Interrupted_queries, of_a_discrete_geodesic_graph)
{
  const Interrupted_query query(discrete_geodesic_graph(0.3));
  query.expect_survival_of_all();
  query.expect_survival_of_straightening();
}

TEST(Interrupted_queries, of_a_steiner_graph)
{
  const Interrupted_query query(graph_with_spaced_points(2));
  query.expect_survival_of_all();
  query.expect_survival_of_new_weights();
}

} // namespace
