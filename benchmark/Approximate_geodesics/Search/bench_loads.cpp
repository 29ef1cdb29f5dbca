// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a large mesh and many queries take in memory: a terrain of ten million faces through the
// class and the function, and ten thousand queries in a row. See --help.

#include "measuring/child_process.h"
#include "measuring/resident_memory.h"
#include "meshes/Mesh.h"
#include "meshes/Terrain.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <cstddef>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

static constexpr unsigned SECONDS_AT_MOST = 900;

// ----- a large mesh

// Runs `f`, which returns the largest distance, in a process of its own; the memory is what it
// takes beside the mesh.
template <typename F>
void add_load(const std::string& name, const Mesh& mesh, Table& table, F f)
{
  std::cerr << name << " ...\n";
  const std::vector<double> numbers =
      numbers_from_child(2, SECONDS_AT_MOST, [&](double* const result) {
        const double before = resident_memory();
        result[0] = f();
        result[1] = peak_memory() - before;
      });
  const double vertices = double(mesh.number_of_vertices());
  table.add_row()
      .add(name)
      .add(double(mesh.number_of_faces()), 0)
      .add(numbers[1] / 1e9, 2)
      .add(numbers[1] / vertices, 0)
      .add(numbers[0], 1);
}

template <typename Graph, typename NamedParameters>
double load_class(const Mesh& mesh, const NamedParameters& np)
{
  AG::Surface_mesh_shortest_path<Mesh, Graph> paths(mesh, np);
  paths.add_source_point(Vertex(0));
  return paths
      .shortest_distance_to_source_points(Vertex(Mesh::size_type(mesh.number_of_vertices() - 1)))
      .first;
}

template <typename NamedParameters>
double load_function(const Mesh& mesh, const NamedParameters& np)
{
  std::vector<double> distances(mesh.number_of_vertices());
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  CGAL::approximate_geodesic_distances(mesh, map, Vertex(0), np);
  return distances.back();
}

Table measure_large_mesh(const std::size_t side)
{
  Table table({"", "faces", "GB", "bytes/vertex", "distance"});
  const Mesh mesh = terrain(side);
  const auto along_edges = parameters::default_values();
  const auto epsilon = parameters::epsilon(0.1);
  add_load("class, along edges", mesh, table,
           [&] { return load_class<AG::Edge_graph>(mesh, along_edges); });
  add_load("function, along edges", mesh, table, [&] { return load_function(mesh, along_edges); });
  add_load("class, lazy, epsilon 0.1", mesh, table,
           [&] { return load_class<AG::Lazy_discrete_geodesic_graph>(mesh, epsilon); });
  add_load("class, built, epsilon 0.1", mesh, table,
           [&] { return load_class<AG::Discrete_geodesic_graph>(mesh, epsilon); });
  add_load("function, epsilon 0.1", mesh, table, [&] { return load_function(mesh, epsilon); });
  return table;
}

// ----- many queries

// One object that is asked again and again, from other sources each time.
template <typename Graph>
class Questioner
{
public:
  template <typename NamedParameters>
  Questioner(const Mesh& mesh, const NamedParameters& np)
    : m_paths(mesh, np), m_vertices(random_vertices(mesh, 1000, 1))
  {
  }

  void ask(const std::size_t number_of_queries)
  {
    for(std::size_t i = 0; i < number_of_queries; ++i, ++m_number)
    {
      const Vertex source = vertex(m_number), target = vertex(7 * m_number + 3);
      m_points.clear();
      m_paths.remove_all_source_points();
      m_paths.add_source_point(source);
      m_paths.shortest_path_points_to_source_points(target, std::back_inserter(m_points),
                                                    parameters::straighten(true));
      m_paths.shortest_distance(target, source);
    }
  }

private:
  Vertex vertex(const std::size_t i) const { return m_vertices[i % m_vertices.size()]; }

  AG::Surface_mesh_shortest_path<Mesh, Graph> m_paths;
  const std::vector<Vertex> m_vertices;
  std::vector<Kernel::Point_3> m_points;
  std::size_t m_number = 0;
};

// The first tenth of the queries may make arrays as large as they need to be.
template <typename Graph, typename NamedParameters>
void add_queries(const std::string& name,
                 const Mesh& mesh,
                 const std::size_t number,
                 Table& table,
                 const NamedParameters& np)
{
  std::cerr << number << " queries, " << name << " ...\n";
  const std::vector<double> numbers =
      numbers_from_child(2, SECONDS_AT_MOST, [&](double* const result) {
        const double before = resident_memory();
        Questioner<Graph> questioner(mesh, np);
        questioner.ask(number / 10);
        result[0] = resident_memory() - before;
        questioner.ask(number - number / 10);
        result[1] = resident_memory() - before;
      });
  table.add_row()
      .add(name)
      .add(double(number), 0)
      .add(numbers[0] / 1e6, 2)
      .add(numbers[1] / 1e6, 2);
}

Table measure_queries(const Mesh& mesh, const std::size_t number)
{
  Table table({"", "queries", "MB after a tenth", "MB at the end"});
  const auto epsilon = parameters::epsilon(0.1);
  add_queries<AG::Edge_graph>("along edges", mesh, number, table, parameters::default_values());
  add_queries<AG::Discrete_geodesic_graph>("built, epsilon 0.1", mesh, number, table, epsilon);
  add_queries<AG::Lazy_discrete_geodesic_graph>("lazy, epsilon 0.1", mesh, number, table, epsilon);
  add_queries<AG::Steiner_graph<AG::Fixed_number_of_points>>(
      "3 points per edge", mesh, number, table, parameters::number_of_points_per_edge(3));
  return table;
}

int main(int argc, char* argv[])
{
  const auto measure = [](const Options& options, const Report& report) {
    report.print("large_mesh", "A terrain, beside the memory of the mesh itself",
                 measure_large_mesh(options.is_quick ? 100 : 2237));
    for(const std::string& name : options.meshes)
      report.print("queries",
                   "Queries in a row on " + short_name(name) +
                       " (a straightened path and a single pair), memory beside the mesh",
                   measure_queries(read_mesh(name), options.is_quick ? 100 : 10000));
  };
  return run_benchmark(argc, argv, "bench_loads", {{"eight"}, 1, ""}, measure);
}
