// Distances between many vertices of a mesh, into a file, from the command line: see --help.

#include "../command_line/Interruption.h"
#include "../command_line/Stopwatch.h"
#include "../command_line/read_mesh.h"
#include "../command_line/run_program.h"
#include "Options.h"
#include "Processes.h"
#include "Progress_line.h"
#include "Report.h"
#include "Threads.h"
#include "Vertex_choice.h"
#include "estimate.h"
#include "matrix.h"
#include "vertex_files.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <type_traits>

using CGAL::Approximate_geodesics::Discrete_geodesic_graph;
using CGAL::Approximate_geodesics::Edge_graph;
using CGAL::Approximate_geodesics::Intrinsic_triangulation;
using CGAL::Approximate_geodesics::Saddle_vertex_graph;

// What is wanted, and who works on it.
struct Job
{
  const Options& options;
  Vertex_choice sources;
  Vertex_choice targets;
  Processes& processes;
  std::size_t threads;
};

// Checks early what would otherwise fail after the graph was built.
void check_files(const Options& options)
{
  const bool is_begun = std::filesystem::exists(options.output + ".part");
  if(is_begun && !options.may_resume)
    throw std::invalid_argument("--resume no: " + options.output +
                                ".part belongs to an unfinished run; delete it to restart");
  for(const std::string& file : {options.output, file_of_rows(options), file_of_columns(options)})
    if(std::filesystem::exists(file))
      throw std::invalid_argument(file + " already exists; remove it, or choose another name");
}

// The first process chooses for all, whatever their processors and libraries are.
Matrix_vertices choose_vertices(const Job& job, const Mesh_of_file& mesh)
{
  Matrix_vertices result;
  if(job.processes.rank() == 0)
  {
    const Options& o = job.options;
    result.sources = job.sources.choose(mesh, o.seed, o.epsilon);
    result.targets =
        o.targets == o.sources ? result.sources : job.targets.choose(mesh, o.seed, o.epsilon);
  }
  job.processes.share(result.sources);
  job.processes.share(result.targets);
  return result;
}

// The matrix has the distances of one of the parts of such a vertex.
void tell_of_cuts(const Vertices_of_file& vertices, const Matrix_vertices& numbers)
{
  for(const Vertex_choice::Indices* const indices : {&numbers.sources, &numbers.targets})
    for(const std::uint64_t number : *indices)
      if(vertices.is_cut(number))
      {
        std::clog << "At some vertices, such as " << number
                  << ", faces do not form a surface. Distances are those of some of its faces, and "
                     "can be too large, or infinite.\n";
        return;
      }
}

// Returns the exit code. Vertices have their numbers in the mesh, and in the file.
template <typename T, typename Graph>
int compute(const Job& job,
            const Graph& graph,
            const Matrix_vertices& vertices,
            const Matrix_vertices& numbers,
            Report& report)
{
  bool is_complete = false;
  const Stopwatch stopwatch;
  std::size_t number_done = 0;
  {
    Progress_line progress;
    is_complete = write_matrix<T>(job.options, graph, vertices, job.processes, progress);
    report.rows_computed = job.processes.sum(double(progress.number_begun()));
    number_done = progress.number_done();
  }
  report.seconds_to_compute = stopwatch.seconds();
  if(is_complete)
  {
    if(job.processes.rank() == 0)
      write_vertex_files(job.options, numbers);
    report.print(job.options, numbers, job.processes);
    return EXIT_SUCCESS;
  }
  std::clog << "Stopped after about " << number_done << " of " << vertices.sources.size()
            << " rows; the same command resumes the run.\n";
  const int signal = Interruption::signal();
  return signal != 0 ? 128 + signal : EXIT_FAILURE; // as shells do
}

template <typename Graph, typename... NamedParameters>
int run(const Job& job, const NamedParameters&... np)
{
  Report report;
  report.threads = job.threads;
  Stopwatch stopwatch;
  const auto lap = [&] {
    const double result = stopwatch.seconds();
    stopwatch.restart();
    return result;
  };
  Mesh_of_file mesh = read_mesh(job.options.input);
  report.seconds_to_read = lap();
  const Matrix_vertices numbers = choose_vertices(job, mesh);
  const Matrix_vertices vertices = vertices_in_mesh(numbers, mesh.vertices);
  tell_of_cuts(mesh.vertices, numbers);
  report.seconds_to_choose = lap();
  const Graph graph(Intrinsic_triangulation(mesh.mesh), np...);
  mesh = Mesh_of_file(); // whose memory is of no more use
  report.seconds_to_build = lap();

  const auto finish = [&](const auto zero) {
    using T = std::decay_t<decltype(zero)>;
    if(!job.options.only_estimates)
      return compute<T>(job, graph, vertices, numbers, report);
    print_estimate<T>(job.options, graph, vertices, job.threads, job.processes.size());
    return EXIT_SUCCESS;
  };
  return job.options.type == "float32" ? finish(0.f) : finish(0.);
}

int run_on_graph(const Job& job)
{
  if(!job.options.epsilon)
    return run<Edge_graph>(job);
  if(*job.options.epsilon == 0)
    return run<Saddle_vertex_graph>(job);
  return run<Discrete_geodesic_graph>(job, CGAL::parameters::epsilon(*job.options.epsilon)
                                               .concurrency_tag(CGAL::Parallel_if_available_tag()));
}

int run(const Options& options, Processes& processes)
{
  if(processes.rank() == 0 && !options.only_estimates)
    check_files(options);
  Threads threads(options.threads);
  const Job job{options, Vertex_choice("--sources", options.sources),
                Vertex_choice("--targets", options.targets), processes, threads.number()};
  return threads.run([&] { return run_on_graph(job); });
}

int main(int argc, char* argv[])
{
  Processes processes(argc, argv);
  std::string name = "geodesic_matrix";
  if(processes.size() > 1)
    name +=
        ": process " + std::to_string(processes.rank()) + " of " + std::to_string(processes.size());
  bool is_computing = false;
  const int result = run_program(name, [&] {
    Options options;
    try
    {
      options = parse_options(argc, argv);
    }
    catch(const std::exception&) // all processes find the same
    {
      if(processes.rank() == 0)
        throw;
      return EXIT_FAILURE;
    }
    if(options.asks_for_help)
      return EXIT_SUCCESS;
    is_computing = true;
    const int code = run(options, processes);
    is_computing = false;
    return code;
  });
  if(is_computing && processes.size() > 1) // the others would wait for this one
    processes.abort();
  return result;
}
