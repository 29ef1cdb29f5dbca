// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A distance matrix in a file by one process, and by two, one thread each; and whether one, two and
// three of them write the same bits. To be started by `mpirun -n 3`. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Sphere.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Mpi_team.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Npy_file.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <boost/program_options.hpp>

#include <mpi.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

static constexpr double EPSILON = 0.1;
static constexpr int MOST = 3; // processes

static int rank()
{
  int result = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &result);
  return result;
}

// Waits for all processes, asleep: MPI's own functions take a core meanwhile, which is another's.
static void wait_for_all()
{
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  int is_done = 0;
  while(MPI_Test(&request, &is_done, MPI_STATUS_IGNORE) == MPI_SUCCESS && is_done == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

// The first processes of all.
class First_ranks
{
public:
  explicit First_ranks(const int number)
  {
    MPI_Comm_split(MPI_COMM_WORLD, rank() < number ? 0 : MPI_UNDEFINED, rank(), &m_communicator);
  }

  First_ranks(const First_ranks&) = delete;
  First_ranks& operator=(const First_ranks&) = delete;

  ~First_ranks()
  {
    if(is_one())
      MPI_Comm_free(&m_communicator);
  }

  // whether this process is one of them
  bool is_one() const { return m_communicator != MPI_COMM_NULL; }

  MPI_Comm communicator() const { return m_communicator; }

private:
  MPI_Comm m_communicator = MPI_COMM_NULL;
};

// All processes make the same calls; the first one measures.
class Rank_benchmark
{
public:
  Rank_benchmark(const Mesh& mesh, const std::size_t number_of_sources, const std::string& folder)
    : m_graph(AG::Intrinsic_triangulation(mesh), parameters::epsilon(EPSILON)),
      m_file(std::filesystem::path(folder) / "bench_matrix_over_ranks.npy")
  {
    const auto vertices = random_sources(mesh, number_of_sources);
    m_sources.assign(vertices.begin(), vertices.end());
  }

  void run(const std::size_t number_of_rounds)
  {
    for(const int number : {1, 2})
      m_contest.add([this, number](auto) { compute(number); });
    m_contest.run(number_of_rounds);
    const std::string expected = content(1);
    for(int number = 2; number <= MOST; ++number)
      m_is_same = content(number) == expected && m_is_same;
    if(rank() == 0)
      std::filesystem::remove(m_file);
  }

  Table table() const
  {
    Table result({"rows", "columns", "one process s", "two processes s", "one : two", "same bits"});
    result.add_row()
        .add(double(m_sources.size()), 0)
        .add(double(m_graph.triangulation().number_of_vertices()), 0)
        .add(m_contest.median_seconds(0), 3)
        .add(m_contest.median_seconds(1), 3)
        .add(m_contest.ratio(0, 1), 2)
        .add(m_is_same ? "yes" : "no");
    return result;
  }

private:
  void compute(const int number_of_processes)
  {
    wait_for_all();
    if(rank() == 0)
      std::filesystem::remove(m_file);
    const First_ranks ranks(number_of_processes);
    if(!ranks.is_one())
      return;
    AG::Mpi_team team(ranks.communicator());
    CGAL::approximate_geodesic_distance_matrix(m_graph, AG::Npy_file<float>(m_file.string(), team),
                                               m_sources);
  }

  // for the first process
  std::string content(const int number_of_processes)
  {
    compute(number_of_processes);
    if(rank() != 0)
      return {};
    std::ifstream in(m_file, std::ios::binary);
    std::string result{std::istreambuf_iterator<char>(in), {}};
    if(result.size() < sizeof(float) * m_sources.size())
      throw std::runtime_error("the file of " + std::to_string(number_of_processes) +
                               " processes is too short");
    return result;
  }

  AG::Discrete_geodesic_graph m_graph;
  std::vector<std::size_t> m_sources;
  std::filesystem::path m_file;
  Contest m_contest;
  bool m_is_same = true;
};

int main(int argc, char* argv[])
{
  namespace po = boost::program_options;
  MPI_Init(&argc, &argv);
  std::string folder;
  More_options more;
  more.add_options()("folder", po::value(&folder)->default_value("."),
                     "where the file is, until it is measured");
  const auto measure = [&](const Options& options, const Report& report) {
    int number_of_processes = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &number_of_processes);
    if(number_of_processes < MOST)
      throw std::invalid_argument("start it by mpirun -n " + std::to_string(MOST));
    Rank_benchmark benchmark(sphere(options.is_quick ? 10 : 57), options.is_quick ? 20 : 2000,
                             folder);
    benchmark.run(options.number_of_rounds);
    if(rank() == 0)
      report.print(
          "matrix_ranks",
          "A file of distances on a sphere, epsilon 0.1, float, by processes of one thread "
          "each; the same bits are those by 1, 2 and 3 (medians of " +
              std::to_string(options.number_of_rounds) + " rounds)",
          benchmark.table());
    wait_for_all();
  };
  const int status =
      run_benchmark(argc, argv, "bench_matrix_over_ranks", {{}, 5, ""}, measure, more);
  if(status != EXIT_SUCCESS)
    MPI_Abort(MPI_COMM_WORLD, status); // or the others would wait
  MPI_Finalize();
  return status;
}
