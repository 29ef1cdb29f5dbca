// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes a file of distances, as tests wish that end programs, or let several of them work
// together. Arguments are of the form name=value:
//
//   file      the file; needed
//   kind      one of those of kinds_of_matrix_files()
//   side      of the mesh, in vertices
//   radius    the maximum distance
//   threads   how many there are
//   seed      of the mesh
//   seed.1    of the mesh of process 1, and so on
//   signal    which this process gives itself
//   rows      when that many rows are done
//   process   which the signal is for
//   pause     after each block, in seconds
//   abort     whether an error ends all processes: 0 or 1

#include "files/matrix_job.h"

#ifdef APPROXIMATE_GEODESICS_TEST_MPI
#include <CGAL/Approximate_geodesics/Matrix_files/Mpi_team.h>
#endif

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <string>
#include <thread>

namespace {

using namespace geodesics_test;

#ifdef APPROXIMATE_GEODESICS_TEST_MPI
using Team = AG::Mpi_team;

class Environment
{
public:
  Environment() { MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &m_provided); }
  ~Environment() { MPI_Finalize(); }
  static void end_others() { MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE); }

private:
  int m_provided;
};
#else
using Team = AG::Single_process;

struct Environment
{
  static void end_others() {}
};
#endif

class Arguments
{
public:
  explicit Arguments(const int argc, char** const argv)
  {
    for(int i = 1; i < argc; ++i)
    {
      const std::string text = argv[i];
      const std::size_t end = text.find('=');
      m_values[text.substr(0, end)] = text.substr(end + 1);
    }
  }

  std::string text(const std::string& name, const std::string& otherwise) const
  {
    const auto value = m_values.find(name);
    return value == m_values.end() ? otherwise : value->second;
  }

  double number(const std::string& name, const double otherwise) const
  {
    return std::stod(text(name, std::to_string(otherwise)));
  }

  std::size_t size(const std::string& name, const std::size_t otherwise) const
  {
    return std::stoul(text(name, std::to_string(otherwise)));
  }

private:
  std::map<std::string, std::string> m_values;
};

bool compute(const Arguments& arguments, Team& team)
{
  const std::size_t seed = arguments.size("seed", 5), rank = team.rank();
  Matrix_job job(arguments.size("side", 33), arguments.size("seed." + std::to_string(rank), seed));
  job.maximum_distance = std::stod(arguments.text("radius", "inf"));

  const int signal = static_cast<int>(arguments.size("signal", 0));
  const std::size_t rows = arguments.size("rows", 0);
  const std::chrono::duration<double> pause(arguments.number("pause", 0));
  bool is_to_come = signal != 0 && rank == arguments.size("process", 0);
  Matrix_watcher watcher([&](const std::size_t number_done) {
    if(is_to_come && number_done >= rows)
    {
      is_to_come = false;
      std::raise(signal);
    }
    std::this_thread::sleep_for(pause);
    return true;
  });
  return Matrix_file_job{arguments.text("kind", "npy"), arguments.text("file", ""),
                         static_cast<int>(arguments.size("threads", 1))}
      .compute(job, watcher, team);
}

} // namespace

int main(int argc, char** argv)
{
  const Environment environment;
  const Arguments arguments(argc, argv);
  Team team; // whose end waits for the others
  try
  {
    return compute(arguments, team) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << std::endl;
    if(arguments.size("abort", 1) == 1)
      environment.end_others();
    return EXIT_FAILURE;
  }
}
