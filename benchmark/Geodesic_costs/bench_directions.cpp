// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What costs that depend on the direction cost to compute, beside a weight per face, and how far
// off they are, on a terrain. See --help.

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Terrain.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Curvature_points.h"
#include "peers/searches_of_arrays.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/property_map.h>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Node = AG::Intrinsic_triangulation::Index;
using AG::Directional_points;
using AG::Fixed_number_of_points;
template <typename Placement>
using Search = AG::Propagation<AG::Directional_graph<Placement>>;

static constexpr std::size_t SOURCES_OF_ERRORS = 3;
static constexpr std::size_t NUMBER_OF_POINTS = 48; // of the reference
static constexpr double EPSILON = 0.02;

// One kind of costs.
class Directions_benchmark
{
public:
  template <typename Cost>
  Directions_benchmark(std::string name, const Mesh& mesh, const Cost& cost)
    : m_name(std::move(name)),
      m_mesh(mesh),
      m_triangulation(
          mesh, CGAL::parameters::face_weight_map(AG::directional_cost(cost)).epsilon(EPSILON / 4)),
      m_sampled([&mesh, cost](const double epsilon) {
        const auto without_formula = [&](const auto f, const auto& d) { return cost(f, d); };
        return AG::Intrinsic_triangulation(
            mesh, CGAL::parameters::face_weight_map(AG::directional_cost(without_formula))
                      .epsilon(epsilon));
      }),
      m_expected(SOURCES_OF_ERRORS * mesh.number_of_vertices(),
                 std::numeric_limits<double>::infinity())
  {
    lower_costs(Fixed_number_of_points(NUMBER_OF_POINTS));
    lower_costs(Directional_points(EPSILON));
  }

  static Table empty_table()
  {
    return Table({"costs", "points", "parameter", "points/edge", "by curvature", "build s",
                  "search ms", "search : std::priority_queue", "mean %", "largest %", "least",
                  "largest : bound"});
  }

  void add_to(Table& table, const std::vector<Vertex>& sources) const
  {
    for(const std::size_t number : {0u, 1u, 3u})
      add_row(table, "equally spaced", double(number), Fixed_number_of_points(number), sources);
    for(const double epsilon : {0.5, 0.2, 0.1})
      add_row(table, "for the bound", epsilon, Directional_points(epsilon), sources);
  }

  static std::string description_of_reference()
  {
    return "the cheaper of " + std::to_string(NUMBER_OF_POINTS) +
           " equally spaced points and those for " + Table::text_of(EPSILON, 2);
  }

private:
  Node node(const Vertex v) const { return m_triangulation.vertex(v.idx()); }

  std::vector<Vertex> sources_of_errors() const
  {
    return first_and_random(random_sources(m_mesh, SOURCES_OF_ERRORS));
  }

  template <typename Placement>
  void lower_costs(const Placement& placement)
  {
    const AG::Directional_graph<Placement> graph(m_triangulation, placement);
    Search<Placement> search(graph);
    auto cost = m_expected.begin();
    for(const Vertex source : sources_of_errors())
    {
      search.run_from(node(source));
      for(const Vertex v : m_mesh.vertices())
      {
        *cost = (std::min)(*cost, search.distance(node(v)));
        ++cost;
      }
    }
  }

  template <typename Placement>
  Errors errors(Search<Placement>& search) const
  {
    Errors result;
    auto cost = m_expected.begin();
    for(const Vertex source : sources_of_errors())
    {
      search.run_from(node(source));
      for(const Vertex v : m_mesh.vertices())
        result.add(search.distance(node(v)), *cost++);
    }
    return result;
  }

  template <typename Placement>
  void add_row(Table& table,
               const std::string& points,
               const double parameter,
               const Placement& placement,
               const std::vector<Vertex>& sources) const
  {
    AG::Intrinsic_triangulation copy = m_triangulation; // takes time that does not count
    std::optional<AG::Directional_graph<Placement>> graph;
    const double build_seconds = seconds_of([&] { graph.emplace(std::move(copy), placement); });
    Search<Placement> search(*graph);
    Priority_queue_dijkstra priority_queue(m_triangulation);
    const Errors errors = this->errors(search); // which makes room in the workspace
    Contest contest;
    contest.add([&](const auto round) { search.run_from(node(sources[round])); });
    contest.add([&](const auto round) { priority_queue.run_from(node(sources[round])); });
    contest.run(sources.size());
    const double bound = graph->epsilon();
    table.add_row()
        .add(m_name)
        .add(points)
        .add(parameter, bound < 1 ? 1 : 0)
        .add(double(graph->number_of_points()) / double(m_triangulation.number_of_edges()), 2)
        .add_if(bound < 1, bound < 1 ? points_by_curvature(bound) : 0, 2)
        .add(build_seconds, 3)
        .add(contest.median_seconds(0) * 1e3, 2)
        .add(contest.ratio(0, 1), 2)
        .add(errors.mean() * 100, 3)
        .add(errors.largest() * 100, 3)
        .add(Table::scientific(errors.least()))
        .add_if(bound < 1, errors.largest() / bound, 3);
  }

  // Returns the points per edge that the curvature of gauges would ask for.
  double points_by_curvature(const double epsilon) const
  {
    const AG::Intrinsic_triangulation sampled = m_sampled(epsilon);
    return double(Curvature_points(sampled, epsilon).number_of_points()) /
           double(sampled.number_of_edges());
  }

  std::string m_name;
  const Mesh& m_mesh;
  AG::Intrinsic_triangulation m_triangulation;
  std::function<AG::Intrinsic_triangulation(double)> m_sampled; // without formulas
  std::vector<double> m_expected; // costs of all vertices from the first source, and so on
};

// Single calls on a mesh: with a weight per face, with costs that have a formula, and with those
// that have none.
static Table table_of_calls(const Mesh& mesh, const std::vector<Vertex>& sources)
{
  Table table({"points/edge", "weights us/vertex", "walking", "walking : weights", "a current",
               "a current : weights", "sampled", "sampled : weights"});
  std::vector<double> weights;
  for(const auto f : mesh.faces())
    weights.push_back(1 + double(f.idx() % 7) / 10);
  std::vector<double> distances(mesh.number_of_vertices());
  const auto drift =
      boost::static_property_map<Kernel::Vector_3, Mesh::Face_index>(Kernel::Vector_3(0.5, 0, 0));
  const auto sampled = [hiking = AG::Hiking_time()](const auto f, const auto& d) {
    return hiking(f, d);
  };
  for(const int number : {1, 3})
  {
    Contest contest;
    const auto add = [&](const auto& weight_map) {
      contest.add([&, weight_map](const auto round) {
        CGAL::approximate_geodesic_distances(
            mesh,
            boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh)),
            sources[round],
            CGAL::parameters::face_weight_map(weight_map).number_of_points_per_edge(number));
      });
    };
    add(CGAL::make_property_map(weights));
    add(AG::directional_cost(AG::Hiking_time()));
    add(AG::directional_cost(AG::Drift_time(drift, 1)));
    add(AG::directional_cost(sampled));
    contest.run(sources.size());
    const double per_vertex = 1e6 / double(mesh.number_of_vertices());
    auto row = table.add_row();
    row.add(double(number), 0).add(contest.median_seconds(0) * per_vertex, 2);
    for(const std::size_t i : {1u, 2u, 3u})
      row.add(contest.median_seconds(i) * per_vertex, 2).add(contest.ratio(i, 0), 2);
  }
  return table;
}

// ----- pairs of faces

// Two faces beside one edge, on a plane of this slope, which is turned. The last two vertices are
// the ends of a path that crosses the edge once.
static Mesh random_pair(std::mt19937& random, const double slope)
{
  const auto between = [&](const double low, const double high) {
    return low + (high - low) * double(random()) / 4294967296.;
  };
  const double turn = between(0, 6.28), run = 1 / std::hypot(1, slope);
  Mesh mesh;
  const auto add = [&](const double x, const double y) {
    const double along = x * std::sin(turn) + y * std::cos(turn);
    return mesh.add_vertex(
        {x * std::cos(turn) - y * std::sin(turn), along * run, along * run * slope});
  };
  const Vertex v = add(0, 0), u = add(1, 0);
  const double x = between(0.3, 0.7), y = between(0.05, 0.4);
  const Vertex left = add(x, y), right = add(between(0.3, 0.7), -between(0.05, 0.4));
  mesh.add_face(v, u, left);
  mesh.add_face(u, v, right);
  return mesh;
}

template <typename Placement>
double cost_between_last(const AG::Directional_graph<Placement>& graph)
{
  Search<Placement> search(graph);
  search.run_from(graph.triangulation().vertex(2));
  return search.distance(graph.triangulation().vertex(3));
}

// How much of the bound paths take that cross one edge: there, no choice of several crossings makes
// up for a point in the middle between two others.
template <typename Cost>
void add_pairs(Table& table,
               const std::string& name,
               const Cost& cost,
               const double slope,
               const bool is_quick)
{
  constexpr std::size_t number_of_points = 1000; // of the reference
  constexpr double bound = 0.1;
  std::mt19937 random(1);
  double points = 0, largest = 0;
  const int number_of_pairs = is_quick ? 20 : 250;
  for(int i = 0; i < number_of_pairs; ++i)
  {
    const AG::Intrinsic_triangulation pair(
        random_pair(random, slope),
        CGAL::parameters::face_weight_map(AG::directional_cost(cost)).epsilon(bound));
    const AG::Directional_graph<> graph(pair, Directional_points(bound));
    const AG::Directional_graph<Fixed_number_of_points> reference(
        pair, Fixed_number_of_points(number_of_points));
    points += double(graph.number_of_points()) / number_of_pairs;
    largest = (std::max)(largest, cost_between_last(graph) / cost_between_last(reference) - 1);
  }
  table.add_row().add(name).add(slope, 2).add(points, 1).add(largest / bound, 2);
}

int main(int argc, char* argv[])
{
  const auto measure = [](const Options& options, const Report& report) {
    const Mesh mesh = terrain(options.is_quick ? 6 : 25, 1, 0.2);
    const std::vector<Vertex> sources = random_sources(mesh, options.number_of_rounds);
    Table table = Directions_benchmark::empty_table();
    Table pairs({"costs", "slope", "points/edge", "largest : bound"});
    const auto add = [&](const std::string& name, const auto& cost, const double slope) {
      Directions_benchmark(name, mesh, cost).add_to(table, sources);
      add_pairs(pairs, name, cost, slope, options.is_quick);
    };
    using Vector = Kernel::Vector_3;
    add("walking, time", AG::Hiking_time(), 0.2);
    add("walking, energy", AG::Walking_energy(), 0.2);
    const auto drift =
        boost::static_property_map<Vector, Mesh::Face_index>(Vector(0.5, 0, 0)); // of speed 1
    add("a current", AG::Drift_time(drift, 1), 0);
    using Tensor = std::array<double, 6>;
    add("a tensor",
        AG::Tensor_cost(
            boost::static_property_map<Tensor, Mesh::Face_index>(Tensor{1, 0.5, 0, 4, 0, 1})),
        0);
    report.print("direction_calls",
                 "Single calls with costs that depend on the direction, beside a weight per face "
                 "(microseconds per vertex, medians of " +
                     std::to_string(sources.size()) + " sources)",
                 table_of_calls(terrain(options.is_quick ? 20 : 200, 1, 0.2), sources));
    report.print("directions",
                 "Costs that depend on the direction, on a terrain, and " +
                     Directions_benchmark::description_of_reference() + " (medians of " +
                     std::to_string(sources.size()) + " sources, errors of " +
                     std::to_string(SOURCES_OF_ERRORS) + ")",
                 table);
    report.print("directional_pairs",
                 "Random pairs of faces, paths across one edge, for a bound of 0.1", pairs);
  };
  return run_benchmark(argc, argv, "bench_directions", {{}, 11, ""}, measure);
}
