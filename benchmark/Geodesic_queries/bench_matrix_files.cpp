// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Distance matrices in files: what typical jobs take, and all pairs of a surface with as many
// vertices as that of a brain has in practice. See --help.

#include "measuring/child_process.h"
#include "measuring/measure.h"
#include "measuring/resident_memory.h"
#include "measuring/threads.h"
#include "meshes/Mesh.h"
#include "meshes/Sphere.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Csr_file.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Npy_file.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <boost/program_options.hpp>

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

static constexpr double EPSILON = 0.1;
static constexpr unsigned SECONDS_AT_MOST = 3600;
static constexpr double MEGABYTE = 1e6;
static constexpr double MEMORY_PER_THREAD = 64 * MEGABYTE; // is not to be exceeded

using Graph = AG::Discrete_geodesic_graph;

// What one computation takes.
struct Job_costs
{
  double seconds; // without building the graph
  double length;  // of the file, in bytes
  double graph;   // bytes
  double peak;    // of memory beside the mesh, in bytes
};

// The bytes of a file, or of the files of a folder.
static double length_on_disk(const std::filesystem::path& file)
{
  if(!std::filesystem::is_directory(file))
    return double(std::filesystem::file_size(file));
  double result = 0;
  for(const auto& entry : std::filesystem::directory_iterator(file))
    result += double(entry.file_size());
  return result;
}

// Files in a folder that are gone when they were measured.
class Job_runner
{
public:
  Job_runner(const Mesh& mesh, const std::string& folder) : m_mesh(mesh), m_folder(folder) {}

  const Mesh& mesh() const { return m_mesh; }

  // `job(graph, file)` writes a file. It runs in a process of its own, with the graph built there.
  template <typename Job>
  Job_costs run(Job job) const
  {
    const std::filesystem::path file = m_folder / "bench_matrix_files.out";
    std::filesystem::remove_all(file);
    release_free_memory();
    const std::vector<double> numbers =
        numbers_from_child(3, SECONDS_AT_MOST, [&](double* const result) {
          const double before = resident_memory();
          const Graph graph(AG::Intrinsic_triangulation(m_mesh), parameters::epsilon(EPSILON));
          result[0] = seconds_of([&] { job(graph, file.string()); });
          result[1] = double(graph.memory());
          result[2] = peak_memory() - before;
        });
    const double length = length_on_disk(file);
    std::filesystem::remove_all(file);
    return {numbers[0], length, numbers[1], numbers[2]};
  }

private:
  const Mesh& m_mesh;
  std::filesystem::path m_folder;
};

using Numbers = std::vector<std::size_t>; // of vertices

static Numbers all_vertices(const Mesh& mesh)
{
  return {mesh.vertices().begin(), mesh.vertices().end()};
}

// ----- typical jobs

class Jobs_benchmark
{
public:
  explicit Jobs_benchmark(const Job_runner& runner)
    : m_runner(runner),
      m_table({"job", "distances", "s", "us/distance", "peak MB", "graph MB", "file MB"})
  {
  }

  const Table& table() const { return m_table; }

  void add_rows(const std::size_t number)
  {
    const auto vertices = random_sources(m_runner.mesh(), number);
    const Numbers sources(vertices.begin(), vertices.end());
    add_dense(std::to_string(number) + " x all", sources, all_vertices(m_runner.mesh()));
  }

  void add_farthest_points(const std::size_t number)
  {
    std::vector<Vertex> points;
    AG::farthest_point_sampling(m_runner.mesh(), std::back_inserter(points), number,
                                parameters::epsilon(EPSILON));
    const Numbers numbers(points.begin(), points.end());
    add_dense(std::to_string(number) + " x " + std::to_string(number) + " farthest points", numbers,
              numbers);
  }

  void add_patches(const double radius)
  {
    const auto np = parameters::epsilon(EPSILON).maximum_distance(radius);
    AG::Radius_rows<float> rows; // tell how many entries there are
    CGAL::approximate_geodesic_distance_matrix(m_runner.mesh(), rows, m_runner.mesh().vertices(),
                                               np);
    add_sparse(
        "radius " + Table::text_of(radius, 2) + " around all", parameters::maximum_distance(radius),
        [](auto&) {}, double(rows.number_of_entries()));
  }

  void add_nearest(const std::size_t number)
  {
    add_sparse(
        std::to_string(number) + " nearest of all", parameters::default_values(),
        [number](auto& file) { file.keep_nearest(number); },
        double(number) * double(m_runner.mesh().number_of_vertices()));
  }

private:
  void add_dense(const std::string& name, const Numbers& sources, const Numbers& targets)
  {
    std::cerr << name << " ...\n";
    const Job_costs costs = m_runner.run([&](const Graph& graph, const std::string& file) {
      CGAL::approximate_geodesic_distance_matrix(graph, AG::Npy_file<float>(file), sources,
                                                 parameters::targets(targets));
    });
    add(name, costs, double(sources.size()) * double(targets.size()));
  }

  template <typename NamedParameters, typename Prepare>
  void add_sparse(const std::string& name,
                  const NamedParameters& np,
                  const Prepare prepare,
                  const double number_of_entries)
  {
    std::cerr << name << " ...\n";
    const Numbers sources = all_vertices(m_runner.mesh());
    const Job_costs costs = m_runner.run([&](const Graph& graph, const std::string& name_of_file) {
      AG::Csr_file<float> file(name_of_file);
      prepare(file);
      CGAL::approximate_geodesic_distance_matrix(graph, file, sources, np);
    });
    add(name, costs, number_of_entries);
  }

  void add(const std::string& name, const Job_costs& costs, const double number_of_distances)
  {
    m_table.add_row()
        .add(name)
        .add(number_of_distances, 0)
        .add(costs.seconds, 2)
        .add(costs.seconds / number_of_distances * 1e6, 3)
        .add(costs.peak / MEGABYTE, 1)
        .add(costs.graph / MEGABYTE, 1)
        .add(costs.length / MEGABYTE, 1);
  }

  const Job_runner& m_runner;
  Table m_table;
};

static Table measure_jobs(const Job_runner& runner, const bool is_quick)
{
  Jobs_benchmark benchmark(runner);
  benchmark.add_farthest_points(is_quick ? 20 : 1000);
  benchmark.add_rows(is_quick ? 20 : 500);
  for(const double radius : {0.05, 0.2}) // of a sphere of radius 1
    benchmark.add_patches(radius);
  for(const unsigned number : {10u, 100u})
    benchmark.add_nearest(number);
  return benchmark.table();
}

// ----- all pairs

static Table measure_all_pairs(const Job_runner& runner)
{
  Table table({"threads", "minutes", "MB/s", "us/distance", "graph MB", "peak MB",
               "beside the graph MB/thread", "at most 64"});
  const Numbers vertices = all_vertices(runner.mesh());
  const double distances = double(vertices.size()) * double(vertices.size());
  for(std::size_t threads = 1; threads <= (HAS_THREADS ? 2 : 1); ++threads)
  {
    std::cerr << "All pairs, threads: " << threads << " ...\n";
    const Job_costs costs = runner.run([&](const Graph& graph, const std::string& file) {
      with_threads(threads, [&](auto tag) {
        CGAL::approximate_geodesic_distance_matrix(graph, AG::Npy_file<float>(file), vertices,
                                                   parameters::concurrency_tag(tag));
      });
    });
    const double beside = (costs.peak - costs.graph) / double(threads);
    table.add_row()
        .add(double(threads), 0)
        .add(costs.seconds / 60, 2)
        .add(costs.length / MEGABYTE / costs.seconds, 1)
        .add(costs.seconds / distances * 1e6, 4)
        .add(costs.graph / MEGABYTE, 1)
        .add(costs.peak / MEGABYTE, 1)
        .add(beside / MEGABYTE, 1)
        .add(beside <= MEMORY_PER_THREAD ? "yes" : "no");
  }
  return table;
}

int main(int argc, char* argv[])
{
  namespace po = boost::program_options;
  bool wants_all_pairs = false;
  std::string folder;
  More_options more;
  po::options_description_easy_init add = more.add_options();
  add("all-pairs", po::bool_switch(&wants_all_pairs),
      "all pairs of the sphere, too: 4.2 GB on the disk, for minutes");
  add("folder", po::value(&folder)->default_value("."), "where files are, until they are measured");
  const auto measure = [&](const Options& options, const Report& report) {
    const Mesh mesh = sphere(options.is_quick ? 10 : 57);
    const Job_runner runner(mesh, folder);
    const std::string where =
        " on a sphere of " + std::to_string(mesh.number_of_vertices()) + " vertices, epsilon 0.1, ";
    report.print("matrix_jobs", "Files of distances" + where + "float, by one thread",
                 measure_jobs(runner, options.is_quick));
    if(wants_all_pairs || options.is_quick)
      report.print("matrix_all_pairs", "All pairs" + where + "into one file of float",
                   measure_all_pairs(runner));
  };
  return run_benchmark(argc, argv, "bench_matrix_files", {{}, 1, ""}, measure, more);
}
