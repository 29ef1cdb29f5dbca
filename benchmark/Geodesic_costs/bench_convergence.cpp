// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How errors of Steiner graphs fall as points get more. See --help.

#include "measuring/Steiner_trial.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Exact_case.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

// The exponent of the power law that fits best, from the number `first` on.
static double
fitted_slope(const std::vector<double>& x, const std::vector<double>& y, const std::size_t first)
{
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for(std::size_t i = first; i < x.size(); ++i)
  {
    const double u = std::log(x[i]), v = std::log(y[i]);
    sum_x += u;
    sum_y += v;
    sum_xx += u * u;
    sum_xy += u * v;
  }
  const double n = double(x.size() - first);
  return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

// How errors fall as points get more.
class Convergence_benchmark
{
public:
  explicit Convergence_benchmark(const Exact_case& expected)
    : m_name(expected.name()),
      m_trials(steiner_trials(AG::Intrinsic_triangulation(expected.mesh()),
                              {1, 2, 3, 5, 8, 16, 32, 64},
                              {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005}))
  {
    for(Steiner_trial& trial : m_trials)
      trial.find_errors(expected);
  }

  static Table empty_table_of_errors()
  {
    return Table({"mesh", "points", "parameter", "nodes/vertex", "mean %", "largest %"});
  }

  static Table empty_table_of_slopes()
  {
    return Table({"mesh", "points", "against", "mean", "mean of finer half", "largest",
                  "largest of finer half"});
  }

  void add_errors_to(Table& table) const
  {
    for(const Steiner_trial& trial : m_trials)
      table.add_row()
          .add(m_name)
          .add(trial.name())
          .add(trial.parameter(), trial.name() == SPACED ? 0 : 3)
          .add(trial.nodes_per_vertex(), 2)
          .add(trial.errors().mean() * 100, 5)
          .add(trial.errors().largest() * 100, 4);
  }

  void add_slopes_to(Table& table) const
  {
    const auto parameter = [](const Steiner_trial& trial) { return trial.parameter(); };
    const auto number_of_parts = [](const Steiner_trial& trial) { return trial.parameter() + 1; };
    const auto nodes = [](const Steiner_trial& trial) { return trial.nodes_per_vertex(); };
    add_slope(table, SPACED, "m", parameter);
    add_slope(table, SPACED, "m + 1", number_of_parts);
    add_slope(table, GEOMETRIC, "epsilon", parameter);
    add_slope(table, SPACED, "nodes/vertex", nodes);
    add_slope(table, GEOMETRIC, "nodes/vertex", nodes);
  }

private:
  template <typename F>
  void add_slope(Table& table, const std::string& name, const std::string& against, F f) const
  {
    std::vector<double> x, mean, largest;
    for(const Steiner_trial& trial : m_trials)
      if(trial.name() == name)
      {
        x.push_back(f(trial));
        mean.push_back(trial.errors().mean());
        largest.push_back(trial.errors().largest());
      }
    Table::Row row = table.add_row();
    row.add(m_name).add(name).add(against);
    for(const std::vector<double>& errors : {mean, largest})
      for(const std::size_t first : {std::size_t(0), x.size() / 2})
        row.add(fitted_slope(x, errors, first), 2);
  }

  std::string m_name;
  std::vector<Steiner_trial> m_trials;
};

int main(int argc, char* argv[])
{
  const auto measure_convergence = [](const Options& options, const Report& report) {
    Table errors = Convergence_benchmark::empty_table_of_errors();
    Table slopes = Convergence_benchmark::empty_table_of_slopes();
    for(const std::string& name : options.meshes)
    {
      const Convergence_benchmark benchmark(first_and_random_case(name, options.number_of_rounds));
      benchmark.add_errors_to(errors);
      benchmark.add_slopes_to(slopes);
    }
    report.print("steiner_convergence", "How errors fall as points get more", errors);
    report.print("steiner_slopes", "Exponents of the power laws that fit these errors", slopes);
  };
  Options defaults{{"elephant", "anchor"}, 3, ""}; // the latter has needles among its faces
  defaults.quick_meshes = defaults.meshes;         // the figure shows both
  return run_benchmark(argc, argv, "bench_convergence", defaults, measure_convergence);
}
