// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether the discrete geodesic graphs keep within epsilon, and whether the exact distances of the
// package are those of CGAL's exact class, on all sample meshes. See --help.

#include "measuring/Errors.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Exact_case.h"
#include "peers/Exact_class_comparison.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

static constexpr double SHOWN = 0.1; // the epsilon that has a row per mesh
static constexpr double FINEST = 0.01;

// One graph with one epsilon, on all meshes.
class Trial
{
public:
  Trial(std::string graph, const double epsilon) : m_graph(std::move(graph)), m_epsilon(epsilon) {}

  double epsilon() const { return m_epsilon; }

  // on the last mesh
  const Errors& errors() const { return m_errors; }
  double arcs_per_vertex() const { return m_arcs_per_vertex; }
  bool holds() const { return m_wrong.count == 0; }

  template <typename Graph>
  void run(const Exact_case& expected)
  {
    const Graph graph(AG::Intrinsic_triangulation(expected.mesh()),
                      CGAL::parameters::epsilon(m_epsilon));
    if constexpr(std::is_same_v<Graph, AG::Discrete_geodesic_graph>)
      m_arcs_per_vertex = double(graph.number_of_arcs()) / double(graph.number_of_nodes());
    AG::Propagation<Graph> search(graph);
    m_errors = Errors();
    m_wrong = Violations();
    for(std::size_t i = 0; i < expected.sources().size(); ++i)
    {
      search.run_from(graph.triangulation().vertex(expected.sources()[i].idx()));
      compare(expected, i, search);
    }
    m_means.push_back(m_errors.mean());
    m_number_of_distances += m_errors.count();
    m_number_of_violations += m_wrong.count;
    m_least = (std::min)(m_least, m_errors.least());
    m_largest = (std::max)(m_largest, m_errors.largest());
  }

  static std::vector<std::string> header()
  {
    return {"epsilon", "graph",          "meshes",    "distances",
            "mean %",  "largest mean %", "largest %", "largest : epsilon",
            "least",   "violations"};
  }

  void add_to(Table& table) const
  {
    const double sum = std::accumulate(m_means.begin(), m_means.end(), 0.);
    table.add_row()
        .add(m_epsilon, 2)
        .add(m_graph)
        .add(double(m_means.size()), 0)
        .add(double(m_number_of_distances), 0)
        .add(sum / double(m_means.size()) * 100, 4)
        .add(*std::max_element(m_means.begin(), m_means.end()) * 100, 4)
        .add(m_largest * 100, 3)
        .add(m_largest / m_epsilon, 3)
        .add(Table::scientific(m_least))
        .add(double(m_number_of_violations), 0);
  }

  static std::vector<std::string> header_of_violations()
  {
    return {"mesh", "epsilon", "graph", "source", "vertex", "exact", "error"};
  }

  // the worst one on the last mesh
  void add_violation_to(Table& table, const std::string& mesh) const
  {
    table.add_row()
        .add(mesh)
        .add(m_epsilon, 2)
        .add(m_graph)
        .add(std::to_string(m_wrong.source.idx()))
        .add(std::to_string(m_wrong.vertex.idx()))
        .add(Table::scientific(m_wrong.exact))
        .add(Table::scientific(m_wrong.error));
  }

private:
  // how many there are, and the worst one
  struct Violations
  {
    std::size_t count = 0;
    Vertex source, vertex;
    double exact = 0;
    double error = 0;
  };

  bool is_allowed(const double error) const
  {
    return error >= -Exact_case::ROUNDING && error <= m_epsilon;
  }

  template <typename Search>
  void compare(const Exact_case& expected, const std::size_t i, const Search& search)
  {
    for(const Vertex v : expected.mesh().vertices())
    {
      const double exact = expected.distance(i, v);
      const double error =
          m_errors.add(search.distance(search.graph().triangulation().vertex(v.idx())), exact);
      if(is_allowed(error))
        continue;
      ++m_wrong.count;
      if(!(std::abs(error) <= std::abs(m_wrong.error)))
        m_wrong = {m_wrong.count, expected.sources()[i], v, exact, error};
    }
  }

  std::string m_graph;
  double m_epsilon;
  double m_arcs_per_vertex = 0;
  Errors m_errors; // on the last mesh, as the next
  Violations m_wrong;
  std::vector<double> m_means; // per mesh
  std::size_t m_number_of_distances = 0;
  std::size_t m_number_of_violations = 0;
  double m_least = std::numeric_limits<double>::infinity();
  double m_largest = -std::numeric_limits<double>::infinity();
};

// The exact distances of the package and of CGAL's exact class, on all meshes.
class Exact_trial
{
public:
  Exact_trial()
    : m_differences({"mesh", "differ", "exact class wrong", "ours wrong", "largest difference",
                     "source", "vertex", "ours", "exact class"}),
      m_not_compared({"mesh", "why"})
  {
  }

  // Nothing if the class does not come to an end.
  std::optional<Exact_class_comparison> run(const Exact_case& ours, const Limits& limits)
  {
    try
    {
      const Exact_class_comparison result(ours, limits);
      ++m_number_of_meshes;
      m_number_of_distances += result.number_of_distances();
      if(result.number_of_differences() > 0)
        add_difference(ours.name(), result);
      else
        m_largest = (std::max)(m_largest, result.largest().relative);
      return result;
    }
    catch(const std::exception& e)
    {
      m_not_compared.add_row().add(ours.name()).add(e.what());
      return {};
    }
  }

  void print(const Report& report) const
  {
    Table summary({"meshes", "distances", "meshes that differ", "largest difference of others"});
    summary.add_row()
        .add(double(m_number_of_meshes), 0)
        .add(double(m_number_of_distances), 0)
        .add(double(m_number_of_differing_meshes), 0)
        .add(Table::scientific(m_largest));
    report.print("exact_class", "Exact distances, and those of CGAL's exact class", summary);
    if(!m_differences.is_empty())
      report.print("differences",
                   "Where they differ, how many distances are proved to be too long by a shorter "
                   "path, and the largest difference",
                   m_differences);
    if(!m_not_compared.is_empty())
      report.print("not_compared", "Where the exact class does not come to an end", m_not_compared);
  }

private:
  void add_difference(const std::string& name, const Exact_class_comparison& comparison)
  {
    ++m_number_of_differing_meshes;
    const Exact_class_comparison::Difference& largest = comparison.largest();
    m_differences.add_row()
        .add(name)
        .add(double(comparison.number_of_differences()), 0)
        .add(double(comparison.number_of_theirs_too_long()), 0)
        .add(double(comparison.number_of_ours_too_long()), 0)
        .add(Table::scientific(largest.relative))
        .add(std::to_string(largest.source.idx()))
        .add(std::to_string(largest.vertex.idx()))
        .add(largest.ours, 6)
        .add(largest.theirs, 6);
  }

  Table m_differences;
  Table m_not_compared;
  std::size_t m_number_of_meshes = 0;
  std::size_t m_number_of_distances = 0;
  std::size_t m_number_of_differing_meshes = 0;
  double m_largest = 0; // on meshes where no difference is larger than rounding
};

// All graphs on all meshes.
class Validation_benchmark
{
public:
  Validation_benchmark()
    : m_per_mesh({"mesh", "vertices", "arcs/vertex", "mean %", "largest %", "least", "lazy mean %",
                  "lazy largest %", "lazy least", "exact class wrong", "ours wrong",
                  "largest difference", "holds"}),
      m_violations(Trial::header_of_violations()),
      m_left_out({"mesh", "why"})
  {
    for(const double epsilon : {0.2, SHOWN, 0.05, FINEST})
    {
      m_built.emplace_back("built", epsilon);
      m_lazy.emplace_back("lazy", epsilon);
    }
  }

  void run(const std::string& name, const std::size_t number_of_sources, const Limits& limits)
  {
    try
    {
      run(Exact_case(name, number_of_sources), limits);
    }
    catch(const std::exception& e)
    {
      m_left_out.add_row().add(short_name(name)).add(e.what());
    }
  }

  void print(const Report& report) const
  {
    if(!m_violations.is_empty())
      report.print("violations", "WRONG: the worst violations of epsilon", m_violations);
    if(!m_per_mesh.is_empty())
      report.print("validation", "Relative errors on all meshes", summary());
    report.print("validation_meshes",
                 "Relative errors for epsilon = " + Table::text_of(SHOWN, 1) +
                     "; how many distances the exact class and the package's exact graph had too "
                     "long, how much they differ, and whether every epsilon holds",
                 m_per_mesh);
    m_exact.print(report);
    if(!m_left_out.is_empty())
      report.print("left_out", "Left out", m_left_out);
  }

private:
  void run(const Exact_case& expected, const Limits& limits)
  {
    const auto comparison = m_exact.run(expected, limits);
    bool holds = !comparison || comparison->number_of_ours_too_long() == 0;
    for(std::size_t i = 0; i < m_built.size(); ++i)
    {
      m_built[i].run<AG::Discrete_geodesic_graph>(expected);
      m_lazy[i].run<AG::Lazy_discrete_geodesic_graph>(expected);
      for(const Trial* const trial : {&m_built[i], &m_lazy[i]})
        if(!trial->holds())
        {
          holds = false;
          trial->add_violation_to(m_violations, expected.name());
        }
    }
    add_row(expected, comparison, holds);
  }

  void add_row(const Exact_case& expected,
               const std::optional<Exact_class_comparison>& comparison,
               const bool holds)
  {
    const auto is_shown = [](const Trial& trial) { return trial.epsilon() == SHOWN; };
    const Trial& built = *std::find_if(m_built.begin(), m_built.end(), is_shown);
    const Trial& lazy = *std::find_if(m_lazy.begin(), m_lazy.end(), is_shown);
    Table::Row row = m_per_mesh.add_row();
    row.add(expected.name())
        .add(double(expected.mesh().number_of_vertices()), 0)
        .add(built.arcs_per_vertex(), 1);
    for(const Errors& errors : {built.errors(), lazy.errors()})
      row.add(errors.mean() * 100, 4)
          .add(errors.largest() * 100, 3)
          .add(Table::scientific(errors.least()));
    if(comparison)
      row.add(double(comparison->number_of_theirs_too_long()), 0)
          .add(double(comparison->number_of_ours_too_long()), 0)
          .add(Table::scientific(comparison->largest().relative));
    else
      row.add("-").add("-").add("-");
    row.add(holds ? "yes" : "NO");
  }

  Table summary() const
  {
    Table result(Trial::header());
    for(const auto& trials : {m_built, m_lazy})
      for(const Trial& trial : trials)
        trial.add_to(result);
    return result;
  }

  std::vector<Trial> m_built, m_lazy; // one per epsilon
  Exact_trial m_exact;
  Table m_per_mesh;
  Table m_violations;
  Table m_left_out;
};

int main(int argc, char* argv[])
{
  Limits limits;
  const auto validate = [&](const Options& options, const Report& report) {
    Validation_benchmark benchmark;
    for(const std::string& name : options.meshes.empty() ? all_sample_meshes() : options.meshes)
      benchmark.run(name, options.number_of_rounds, limits);
    benchmark.print(report);
  };
  namespace po = boost::program_options;
  More_options more;
  more.add_options()("seconds", po::value(&limits.seconds)->default_value(limits.seconds),
                     "for the exact class, per mesh");
  more.add_options()("faces", po::value(&limits.faces)->default_value(limits.faces),
                     "of the largest mesh that the exact class is asked to do");
  Options defaults{{}, 3, ""};
  defaults.quick_meshes = {"anchor", "elephant", "mesh_with_border"};
  return run_benchmark(argc, argv, "bench_validation", defaults, validate, more);
}
