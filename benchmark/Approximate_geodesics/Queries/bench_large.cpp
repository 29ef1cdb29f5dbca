// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Large meshes in arrays: time and memory per vertex of one call, of its steps, of reading a file,
// and of building a graph. See --help.

#include "measuring/child_process.h"
#include "measuring/measure.h"
#include "measuring/resident_memory.h"
#include "meshes/mesh_arrays.h"
#include "output/Options.h"
#include "output/Table.h"

#include <sys/resource.h>
#include <unistd.h>

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangle_soup_mesh.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

using Soup_mesh =
    AG::Triangle_soup_mesh<decltype(Mesh_arrays::points), decltype(Mesh_arrays::triangles)>;
using Make_arrays = std::function<Mesh_arrays()>;

static constexpr unsigned SECONDS_AT_MOST = 3600;

// ----- one call, and its steps

// Times in seconds, memory in bytes.
struct Figures
{
  double vertices, pairing, reading, preparing, searching, call, system;
  double arrays, mesh, graph, workspace, peak;

  static constexpr std::size_t number = 12;
};

// The time that the operating system has taken, which clears memory before a process gets it.
double seconds_of_system()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_stime.tv_sec) + 1e-6 * double(usage.ru_stime.tv_usec);
}

template <typename Graph>
AG::Intrinsic_triangulation read(const Soup_mesh& mesh)
{
  if constexpr(std::is_same_v<Graph, AG::Edge_graph>) // as a call does
  {
    const auto np = parameters::default_values();
    AG::Intrinsic_triangulation result;
    AG::internal::Triangulation_builder<Soup_mesh, std::decay_t<decltype(np)>>(result, mesh, np)
        .try_to_build_edges();
    return result;
  }
  else
    return AG::Intrinsic_triangulation(mesh);
}

template <typename Graph, typename NamedParameters>
void measure_steps(const Soup_mesh& mesh,
                   const std::size_t source,
                   const NamedParameters& np,
                   Figures& result)
{
  std::unique_ptr<AG::Intrinsic_triangulation> triangulation;
  std::unique_ptr<Graph> graph;
  std::unique_ptr<AG::Propagation<Graph>> search;
  result.reading = seconds_of(
      [&] { triangulation = std::make_unique<AG::Intrinsic_triangulation>(read<Graph>(mesh)); });
  result.preparing = seconds_of([&] {
    graph = std::make_unique<Graph>(std::move(*triangulation), np);
    search = std::make_unique<AG::Propagation<Graph>>(*graph);
  });
  result.searching = seconds_of([&] { search->run_from(graph->triangulation().vertex(source)); });
  result.graph = double(graph->memory());
  result.workspace = double(search->memory());
}

// In a process of its own, for its peak of memory.
template <typename Graph, typename NamedParameters>
Figures
measure_call(const Make_arrays& make_arrays, const std::size_t round, const NamedParameters& np)
{
  const std::vector<double> numbers =
      numbers_from_child(Figures::number, SECONDS_AT_MOST, [&](double* const written) {
        release_free_memory();
        const double before = resident_memory();
        const Mesh_arrays arrays = make_arrays();
        std::vector<double> distances(arrays.points.size());
        std::mt19937_64 random(round);
        const std::size_t source = random() % distances.size();
        Figures result;
        const double system = seconds_of_system();
        std::unique_ptr<Soup_mesh> mesh;
        result.pairing = seconds_of(
            [&] { mesh = std::make_unique<Soup_mesh>(arrays.points, arrays.triangles); });
        const auto map =
            boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, *mesh));
        result.call = result.pairing + seconds_of([&] {
                        CGAL::approximate_geodesic_distances(*mesh, map, mesh->vertex(source), np);
                      });
        result.system = seconds_of_system() - system;
        result.peak = peak_memory() - before;
        result.vertices = double(arrays.points.size());
        result.arrays = arrays.memory() + double(distances.size() * sizeof(double));
        result.mesh = double(mesh->memory());
        measure_steps<Graph>(*mesh, source, np, result);
        *reinterpret_cast<Figures*>(written) = result;
      });
  return *reinterpret_cast<const Figures*>(numbers.data());
}

// The call that takes the median time.
template <typename Graph, typename NamedParameters>
Figures
measure_calls(const Make_arrays& make_arrays, const std::size_t rounds, const NamedParameters& np)
{
  std::vector<Figures> all;
  for(std::size_t round = 0; round < rounds; ++round)
    all.push_back(measure_call<Graph>(make_arrays, round, np));
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(rounds / 2);
  std::nth_element(all.begin(), middle, all.end(),
                   [](const Figures& f, const Figures& g) { return f.call < g.call; });
  return *middle;
}

class Call_benchmark
{
public:
  Call_benchmark()
    : m_table({"mesh", "vertices", "paths", "pair ns", "read ns", "prepare ns", "search ns",
               "one call ns", ": first mesh", "system ns", "without it : first mesh", "arrays B",
               "mesh B", "graph B", "workspace B", "peak B"})
  {
  }

  template <typename Graph, typename NamedParameters>
  void add(const std::string& name,
           const std::string& paths,
           const Make_arrays& make_arrays,
           const std::size_t rounds,
           const NamedParameters& np)
  {
    std::cerr << name << ", " << paths << " ...\n";
    const Figures f = measure_calls<Graph>(make_arrays, rounds, np);
    const Figures& first = m_first.try_emplace(paths, f).first->second;
    const auto ratio = [&](const double seconds, const double seconds_of_first) {
      return seconds / f.vertices / (seconds_of_first / first.vertices);
    };
    Table::Row row = m_table.add_row();
    row.add(name).add(f.vertices, 0).add(paths);
    for(const double seconds : {f.pairing, f.reading, f.preparing, f.searching, f.call})
      row.add(seconds / f.vertices * 1e9, 1);
    row.add(ratio(f.call, first.call), 2);
    row.add(f.system / f.vertices * 1e9, 1);
    row.add(ratio(f.call - f.system, first.call - first.system), 2);
    for(const double bytes : {f.arrays, f.mesh, f.graph, f.workspace, f.peak})
      row.add(bytes / f.vertices, 1);
  }

  const Table& table() const { return m_table; }

private:
  Table m_table;
  std::map<std::string, Figures> m_first; // of the first mesh, by paths
};

// ----- a file

// A file that is removed in the end.
struct Removed_file
{
  ~Removed_file()
  {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }

  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("bench_large_" + std::to_string(getpid()) + ".ply");
};

// Reads a binary PLY file into arrays.
void measure_file(const std::string& name, const Make_arrays& make_arrays, Table& table)
{
  std::cerr << name << ", from a file ...\n";
  const Removed_file temporary;
  const std::string file = temporary.path.string();
  const auto write = [&](double*) {
    const Mesh_arrays arrays = make_arrays();
    if(!CGAL::IO::write_PLY(file, arrays.points, arrays.triangles,
                            parameters::use_binary_mode(true)))
      throw std::runtime_error("cannot write " + file);
  };
  const auto read = [&](double* const result) {
    release_free_memory();
    const double before = resident_memory();
    Mesh_arrays arrays;
    result[0] = seconds_of([&] { AG::read_soup(file, arrays.points, arrays.triangles); });
    result[1] = double(arrays.points.size());
    result[2] = arrays.memory();
    result[3] = peak_memory() - before;
  };
  numbers_from_child(1, SECONDS_AT_MOST, write);
  const double bytes_of_file = double(std::filesystem::file_size(temporary.path));
  const std::vector<double> numbers = numbers_from_child(4, SECONDS_AT_MOST, read);
  const double vertices = numbers[1];
  table.add_row()
      .add(name)
      .add(vertices, 0)
      .add(numbers[0] / vertices * 1e9, 1)
      .add(bytes_of_file / vertices, 1)
      .add(numbers[2] / vertices, 1)
      .add(numbers[3] / vertices, 1)
      .add(numbers[3] / numbers[2], 2);
}

// ----- a graph for many queries

// The memory that building takes at its largest, reading included, beside that of the graph.
void measure_building(const std::string& name, const Make_arrays& make_arrays, Table& table)
{
  std::cerr << name << ", built ...\n";
  const std::vector<double> numbers =
      numbers_from_child(4, SECONDS_AT_MOST, [&](double* const result) {
        const Mesh_arrays arrays = make_arrays();
        const Soup_mesh mesh(arrays.points, arrays.triangles);
        release_free_memory();
        const double before = resident_memory();
        AG::Discrete_geodesic_graph graph;
        result[0] = seconds_of([&] {
          graph = AG::Discrete_geodesic_graph(AG::Intrinsic_triangulation(mesh),
                                              parameters::epsilon(0.1));
        });
        result[1] = double(arrays.points.size());
        result[2] = double(graph.memory());
        result[3] = peak_memory() - before;
      });
  const double vertices = numbers[1];
  table.add_row()
      .add(name)
      .add(vertices, 0)
      .add(numbers[0] / vertices * 1e9, 1)
      .add(numbers[2] / vertices, 1)
      .add(numbers[3] / vertices, 1)
      .add(numbers[3] / numbers[2], 2);
}

// ----- all

struct Sizes
{
  std::vector<std::size_t> vertices{1'000'000, 10'000'000};
  std::size_t largest_across_faces = 10'000'000, largest_built = 1'000'000;
};

struct Tables
{
  Call_benchmark calls;
  Table files{{"mesh", "vertices", "ns", "file B", "arrays B", "peak B", "peak : arrays"}};
  Table built{{"mesh", "vertices", "ns", "graph B", "peak B", "peak : graph"}};
};

void measure(const std::string& name,
             const std::size_t number_of_vertices,
             const Make_arrays& make_arrays,
             const std::size_t rounds,
             const Sizes& sizes,
             Tables& tables)
{
  const std::size_t r = number_of_vertices <= 2'000'000 ? rounds : 1;
  tables.calls.add<AG::Edge_graph>(name, "edges", make_arrays, r, parameters::default_values());
  if(number_of_vertices > sizes.largest_across_faces)
    return;
  tables.calls.add<AG::Lazy_discrete_geodesic_graph>(name, "epsilon 0.1", make_arrays, r,
                                                     parameters::epsilon(0.1));
  measure_file(name, make_arrays, tables.files);
  if(number_of_vertices <= sizes.largest_built)
    measure_building(name, make_arrays, tables.built);
}

int main(int argc, char* argv[])
{
  Sizes sizes;
  More_options more;
  namespace po = boost::program_options;
  more.add_options()("vertices", po::value(&sizes.vertices)->multitoken(),
                     "the sizes of wavy terrains, 1000000 and 10000000 if not given; 100000000 "
                     "take 18 GB")(
      "across-faces", po::value(&sizes.largest_across_faces),
      "the largest number of vertices for epsilon 0.1 and for files, 10000000 if not given")(
      "built", po::value(&sizes.largest_built),
      "the largest number of vertices for a built graph, 1000000 if not given");
  const auto measure_all = [&](const Options& options, const Report& report) {
    Tables tables;
    if(options.is_quick)
      sizes.vertices = {2'000, 8'000};
    for(const std::size_t n : sizes.vertices)
      measure(
          "wavy terrain", n, [=] { return wavy_terrain(n); }, options.number_of_rounds, sizes,
          tables);
    for(const std::string& name : options.meshes)
    {
      const Mesh_arrays arrays = arrays_of(read_mesh(name));
      measure(
          short_name(name), arrays.points.size(), [&] { return arrays; }, options.number_of_rounds,
          sizes, tables);
    }
    report.print("large", "One call, per vertex", tables.calls.table());
    report.print("large_files", "Binary PLY files read into arrays, per vertex", tables.files);
    report.print("large_built", "Discrete geodesic graphs for epsilon 0.1, per vertex",
                 tables.built);
  };
  return run_benchmark(argc, argv, "bench_large", {{}, 3, ""}, measure_all, more);
}
