#ifndef GEODESIC_MATRIX_PROCESSES_H
#define GEODESIC_MATRIX_PROCESSES_H

#include <CGAL/Approximate_geodesics/Matrix_files/Process_team.h>

#ifdef GEODESIC_MATRIX_WITH_MPI
#include <CGAL/Approximate_geodesics/Matrix_files/Mpi_team.h>

#include <mpi.h>
#endif

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <vector>

#ifdef GEODESIC_MATRIX_WITH_MPI

// The processes that MPI has started, of which only the first one prints, but for errors.
class Processes
{
  using Team = CGAL::Approximate_geodesics::Mpi_team;

public:
  Processes(int argc, char* argv[])
  {
    int level = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &level);
    if(level < MPI_THREAD_SERIALIZED)
    {
      std::cerr << "geodesic_matrix: this MPI cannot be called by several threads in turn\n";
      abort();
    }
    m_team = std::make_unique<Team>();
    if(rank() > 0)
      for(std::ostream* const out : {&std::cout, &std::clog})
        out->rdbuf(nullptr);
  }

  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  ~Processes()
  {
    m_team.reset();
    MPI_Finalize();
  }

  std::size_t rank() const { return m_team->rank(); }
  std::size_t size() const { return m_team->size(); }

  // Replaces the values by those of the first process.
  void share(std::vector<std::uint64_t>& values) { m_team->share(values); }

  double sum(const double value) const { return reduced(value, MPI_SUM); }
  double maximum(const double value) const { return reduced(value, MPI_MAX); }

  // Returns the team that computes a file. A single process does not need MPI for it.
  CGAL::Approximate_geodesics::Process_team& team()
  {
    if(size() > 1)
      return *m_team;
    return m_single;
  }

  // Ends all processes: the others would wait for this one.
  [[noreturn]] static void abort()
  {
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    std::exit(EXIT_FAILURE);
  }

private:
  static double reduced(const double value, const MPI_Op operation)
  {
    double result = value;
    MPI_Allreduce(&value, &result, 1, MPI_DOUBLE, operation, MPI_COMM_WORLD);
    return result;
  }

  std::unique_ptr<Team> m_team;
  CGAL::Approximate_geodesics::Single_process m_single;
};

#else

// One process, as the program was built without MPI.
class Processes
{
public:
  Processes(int /* argc */, char* /* argv */[]) {}

  std::size_t rank() const { return 0; }
  std::size_t size() const { return 1; }
  void share(std::vector<std::uint64_t>& /* values */) {}
  double sum(const double value) const { return value; }
  double maximum(const double value) const { return value; }

  CGAL::Approximate_geodesics::Process_team& team() { return m_single; }

  [[noreturn]] static void abort() { std::exit(EXIT_FAILURE); }

private:
  CGAL::Approximate_geodesics::Single_process m_single;
};

#endif

#endif // GEODESIC_MATRIX_PROCESSES_H
