// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What one search of the lazy graph looks at, and what that costs: with cones that are followed one
// after the other, and with those of many vertices advancing together. See --help.

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/surfaces.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Exact_case.h"
#include "peers/lazy_graphs.h"

#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using AG::Intrinsic_triangulation;
using AG::Lazy_discrete_geodesic_graph;

// What searches from all sources of a case look at, and their errors.
struct Figures
{
  double windows = 0, arcs = 0; // per vertex
  Errors errors = {};
};

// Whether both found as many arcs, but for those that rounding decides on: compilers round
// otherwise in a program that counts.
bool are_alike(const std::size_t a, const std::size_t b)
{
  return std::abs(double(a) - double(b)) <= 0.02 * double(a);
}

// `counted` finds what `timed` finds, and counts windows.
template <typename Timed, typename Counted>
Figures figures(const Timed& timed, const Counted& counted, const Exact_case& expected)
{
  Figures result;
  AG::Propagation<Timed> search(timed);
  AG::Propagation<Counted> counting_search(counted);
  search.collect_statistics(true);
  counting_search.collect_statistics(true);
  for(std::size_t i = 0; i < expected.sources().size(); ++i)
  {
    const auto source = timed.triangulation().vertex(expected.sources()[i].idx());
    search.run_from(source);
    counting_search.run_from(source);
    if(!are_alike(search.statistics().relaxations, counting_search.statistics().relaxations))
      throw std::logic_error("what was counted is not what was timed");
    result.arcs += double(search.statistics().relaxations);
    for(const Vertex v : expected.mesh().vertices())
      result.errors.add(search.distance(timed.triangulation().vertex(v.idx())),
                        expected.distance(i, v));
  }
  const double number = double(timed.number_of_nodes()) * double(expected.sources().size());
  result.windows = double(counted.number_of_windows()) / number;
  result.arcs /= number;
  return result;
}

void expect_bound(const Figures& figures, const double epsilon)
{
  if(figures.errors.largest() > epsilon || figures.errors.least() < -Exact_case::ROUNDING)
    throw std::logic_error("a distance is out of bounds");
}

std::vector<std::string> header(const std::string& first)
{
  std::vector<std::string> result = {first, "vertices"};
  for(const std::string way : {"in turn", "together"})
    for(const std::string figure :
        {"windows/vertex", "us/vertex", "ns/window", "arcs/vertex", "mean %", "largest %"})
      result.push_back(way + " " + figure);
  result.push_back("ratio of times");
  return result;
}

void add_figures(Table::Row& row, const Figures& figures, const double microseconds)
{
  row.add(figures.windows, 1)
      .add(microseconds, 3)
      .add(microseconds * 1e3 / figures.windows, 1)
      .add(figures.arcs, 1)
      .add(100 * figures.errors.mean(), 4)
      .add(100 * figures.errors.largest(), 2);
}

void compare(Table::Row& row, const Exact_case& expected, const double epsilon)
{
  const double n = double(expected.mesh().number_of_vertices());
  const Intrinsic_triangulation triangulation(expected.mesh());
  const Cones_in_turn<false> in_turn(triangulation, epsilon);
  const Lazy_discrete_geodesic_graph together(triangulation, parameters::epsilon(epsilon));
  AG::Propagation<Cones_in_turn<false>> search_in_turn(in_turn);
  AG::Propagation<Lazy_discrete_geodesic_graph> search_together(together);
  const auto source = [&](const std::size_t round) {
    return triangulation.vertex(expected.sources()[round].idx());
  };
  Contest contest;
  contest.add([&](const auto round) { search_in_turn.run_from(source(round)); });
  contest.add([&](const auto round) { search_together.run_from(source(round)); });
  contest.run(expected.sources().size());

  const Figures before = figures(in_turn, Cones_in_turn<true>(triangulation, epsilon), expected);
  const Figures now = figures(together, Counted_cones_together(triangulation, epsilon), expected);
  expect_bound(before, epsilon);
  expect_bound(now, epsilon);
  row.add(n, 0);
  add_figures(row, before, contest.median_seconds(0) / n * 1e6);
  add_figures(row, now, contest.median_seconds(1) / n * 1e6);
  row.add(contest.ratio(0, 1), 2);
}

void compare_meshes(const Options& options, const Report& report)
{
  Table table(header("mesh"));
  const auto run = [&](const std::string& name, const Mesh& mesh) {
    std::cerr << name << ", " << mesh.number_of_vertices() << " vertices ...\n";
    Table::Row row = table.add_row();
    row.add(short_name(name));
    compare(row, Exact_case(name, mesh, random_sources(mesh, options.number_of_rounds)), 0.1);
  };
  for(const std::string& name : options.meshes)
    run(name, read_mesh(name));
  const std::size_t side = options.is_quick ? 20 : 200;
  run("nearly flat", nearly_flat(side));
  run("noisy", noisy_sphere(side));
  run("long box", long_box(side));
  report.print("lazy_windows",
               "One search of the lazy graph, epsilon = 0.1, with cones that are followed in turn "
               "and together (times as medians of " +
                   std::to_string(options.number_of_rounds) + ")",
               table);
}

// A first answer, with everything included.
void answer(const Mesh& mesh, const Vertex source, const double epsilon)
{
  const Lazy_discrete_geodesic_graph graph(Intrinsic_triangulation(mesh),
                                           parameters::epsilon(epsilon));
  AG::Propagation<Lazy_discrete_geodesic_graph>(graph).run_from(
      graph.triangulation().vertex(source.idx()));
}

void compare_epsilons(const std::string& name, const Options& options, const Report& report)
{
  const std::vector<double> epsilons = {0.5, 0.1, 0.01};
  const Mesh mesh = read_mesh(name);
  const Exact_case expected(name, mesh, random_sources(mesh, options.number_of_rounds));
  Contest contest;
  for(const double epsilon : epsilons)
    contest.add(
        [&, epsilon](const auto round) { answer(mesh, expected.sources()[round], epsilon); });
  contest.add([&](auto) { Intrinsic_triangulation triangulation(mesh); });
  contest.run(options.number_of_rounds);

  auto columns = header("epsilon");
  columns.insert(columns.end(), {"reading ms", "everything ms", "to epsilon 0.1"});
  Table table(columns);
  for(std::size_t i = 0; i < epsilons.size(); ++i)
  {
    Table::Row row = table.add_row();
    row.add(epsilons[i], 2);
    compare(row, expected, epsilons[i]);
    row.add(contest.median_seconds(epsilons.size()) * 1e3, 1)
        .add(contest.median_seconds(i) * 1e3, 1)
        .add(contest.ratio(i, 1), 2);
  }
  report.print("lazy_windows_by_epsilon",
               "The same on " + short_name(name) +
                   " for several epsilons; a first answer with everything included",
               table);
}

int main(int argc, char* argv[])
{
  const auto measure = [](const Options& options, const Report& report) {
    compare_meshes(options, report);
    compare_epsilons(options.is_quick ? "elephant" : "bunny00", options, report);
  };
  Options defaults{{"armadillo", "bunny00", "refined_elephant", "armadillo+1", "bunny00+1",
                    "refined_elephant+1", "fandisk_large", "anchor_dense", "couplingdown", "rotor",
                    "mech-holes-shark"},
                   7,
                   ""};
  return run_benchmark(argc, argv, "bench_lazy_windows", defaults, measure);
}
