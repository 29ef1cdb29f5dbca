// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One call with everything included, on surfaces of many kinds: along edges, within a bound, and
// exact, beside std::priority_queue, Boost's Dijkstra, and CGAL's heat method and exact class. See
// --help.

#include "measuring/Errors.h"
#include "measuring/child_process.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Terrain.h"
#include "meshes/lattices.h"
#include "meshes/needles.h"
#include "meshes/surfaces.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Boost_dijkstra.h"
#include "peers/Exact_search.h"
#include "peers/searches_of_arrays.h"

#ifdef CGAL_EIGEN3_ENABLED
#include "peers/Heat_search.h"
#endif

#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace parameters = CGAL::parameters;

using Map = Mesh::Property_map<Vertex, double>;

// ----- surfaces

struct Surface
{
  std::string name;
  std::function<Mesh()> make;
};

// Faces of these are far longer than wide.
static Mesh strip(const std::size_t side) { return helix(side * side / 2); }
static Mesh gear(const std::size_t side) { return extruded(side * side / 2, 1, 0.1); }
static Mesh hills(const std::size_t side) { return terrain(side); }

static std::vector<Surface> surfaces(const Options& options)
{
  using Numbers = std::vector<std::size_t>;
  std::vector<Surface> result;
  for(const std::string& name : options.meshes)
    result.push_back({short_name(name), [name] { return read_mesh(name); }});
  const auto add = [&](const std::string& name, Mesh (*make)(std::size_t), const Numbers& sides) {
    for(const std::size_t side : options.is_quick ? Numbers{20} : sides)
      result.push_back({name, [make, side] { return make(side); }});
  };
  const Numbers usual{100, 250};
  add("flat", flat_lattice, usual);
  add("wavy", wavy_lattice, usual);
  add("jittered", nearly_flat, usual);
  add("sphere", subdivided_sphere, usual);
  add("jittered sphere", jittered_sphere, usual);
  add("noisy sphere", noisy_sphere, usual);
  add("cylinder", cylinder, usual);
  add("cone", cone, usual);
  add("heights in meters", height_field, usual);
  add("long box", long_box, usual);
  add("strip", strip, usual);
  add("gear", gear, usual);
  add("terrain", hills, {100, 316, 1000});
  add("rough terrain", rough_terrain, {100, 316, 1000});
  return result;
}

// ----- contestants

// CGAL's exact class has a minute, and is not asked on meshes of more vertices, where it takes
// gigabytes, too.
static constexpr unsigned SECONDS_FOR_CLASS = 60;
static constexpr std::size_t LARGEST_FOR_CLASS = 60000;

// Distances from a vertex by the exact class, which cannot be told to stop, with the time at the
// end; nothing if there is no answer.
static std::vector<double>
distances_of_class(const std::string& name, const Mesh& mesh, const Vertex source)
{
  const std::size_t n = mesh.number_of_vertices();
  try
  {
    if(n > LARGEST_FOR_CLASS)
      throw std::runtime_error("not asked on more than " + std::to_string(LARGEST_FOR_CLASS) +
                               " vertices");
    return numbers_from_child(n + 1, SECONDS_FOR_CLASS, [&](double* const result) {
      result[n] = seconds_of([&] {
        Exact_search search(mesh);
        search.run(source);
        for(const Vertex v : mesh.vertices())
          result[v.idx()] = search.distance(v);
      });
    });
  }
  catch(const std::runtime_error& error)
  {
    std::cerr << "The exact class on " << name << ": " << error.what() << "\n";
    return {};
  }
}

// All contestants take turns, on one surface.
class Surface_benchmark
{
public:
  Surface_benchmark(const Surface& surface, const std::size_t number_of_rounds)
    : m_name(surface.name), m_mesh(surface.make()), m_boost(m_mesh)
  {
    std::cerr << m_name << ", " << m_mesh.number_of_vertices() << " vertices ...\n";
    const bool is_large = m_mesh.number_of_vertices() > 500000; // and one round takes long enough
    m_sources = random_sources(m_mesh, is_large ? 1 : number_of_rounds);
    for(const double epsilon : {ALONG_EDGES, 0.1, 0.01, 0.})
      add_call(epsilon);
    add_peers();
    m_contest.add([&](const auto round) { collect_errors(m_sources[round]); });
    m_contest.run(m_sources.size());
    compare_with_class(m_sources.front());
  }

  static Table empty_times()
  {
    return Table({"surface", "vertices", "edges ms", "0.1 ms", "0.01 ms", "exact ms", "queue ms",
                  "Boost ms", "heat ms", "class ms"});
  }

  void add_times(Table& table) const
  {
    Table::Row row = row_of(table);
    for(const std::size_t i : {EDGES, COARSE, FINE, EXACT, QUEUE, BOOST})
      row.add(seconds(i) * 1e3, 2);
    row.add_if(HAS_HEAT, HAS_HEAT ? seconds(HEAT) * 1e3 : 0, 1)
        .add_if(has_class(), m_seconds_of_class * 1e3, 0);
  }

  static Table empty_ratios()
  {
    return Table({"surface", "vertices", "edges : queue", "Boost : edges", "0.1 : queue",
                  "Boost : 0.1", "heat : 0.1", "heat : 0.01", "heat : exact", "class : exact"});
  }

  void add_ratios(Table& table) const
  {
    Table::Row row = row_of(table);
    row.add(ratio(EDGES, QUEUE), 2)
        .add(ratio(BOOST, EDGES), 2)
        .add(ratio(COARSE, QUEUE), 2)
        .add(ratio(BOOST, COARSE), 2);
    for(const std::size_t i : {COARSE, FINE, EXACT})
      row.add_if(HAS_HEAT, HAS_HEAT ? ratio(HEAT, i) : 0, 2);
    row.add_if(has_class(), m_seconds_of_class / seconds(EXACT), 1);
  }

  static Table empty_errors()
  {
    return Table({"surface", "vertices", "edges mean %", "largest %", "0.1 mean %", "largest %",
                  "0.01 mean %", "largest %", "heat mean %", "largest %", "class least",
                  "class largest"});
  }

  void add_errors(Table& table) const
  {
    Table::Row row = row_of(table);
    for(const std::size_t i : {EDGES, COARSE, FINE})
      row.add(m_errors[i].mean() * 100, 3).add(m_errors[i].largest() * 100, 2);
    const Errors& heat = m_errors[HEAT];
    row.add_if(HAS_HEAT, heat.mean() * 100, 2)
        .add_if(HAS_HEAT, (std::max)(heat.largest(), -heat.least()) * 100, 1)
        .add(has_class() ? Table::scientific(m_errors[CLASS].least()) : "-")
        .add(has_class() ? Table::scientific(m_errors[CLASS].largest()) : "-");
  }

private:
  // Numbers of contestants.
  static constexpr std::size_t EDGES = 0, COARSE = 1, FINE = 2, EXACT = 3, QUEUE = 4, BOOST = 5,
                               HEAT = 6, CLASS = 7, NUMBER = 8;
  static constexpr double ALONG_EDGES = -1; // in place of epsilon
#ifdef CGAL_EIGEN3_ENABLED
  static constexpr bool HAS_HEAT = true;
#else
  static constexpr bool HAS_HEAT = false;
#endif

  void add_call(const double epsilon)
  {
    const std::string name = "v:ours " + std::to_string(m_maps.size());
    const Map map = m_mesh.add_property_map<Vertex, double>(name).first;
    m_maps.push_back(map);
    if(epsilon == ALONG_EDGES)
      m_contest.add([=](const auto round) {
        CGAL::approximate_geodesic_distances(m_mesh, map, m_sources[round]);
      });
    else
      m_contest.add([=](const auto round) {
        CGAL::approximate_geodesic_distances(m_mesh, map, m_sources[round],
                                             parameters::epsilon(epsilon));
      });
  }

  // The queue has its arrays already.
  void add_peers()
  {
    m_triangulation.emplace(m_mesh);
    m_queue.emplace(*m_triangulation);
    m_contest.add([&](const auto round) {
      m_queue->run_from(m_triangulation->vertex(m_sources[round].idx()));
    });
    m_contest.add([&](const auto round) {
      m_boost.compute_lengths();
      m_boost.run(m_sources[round]);
    });
#ifdef CGAL_EIGEN3_ENABLED
    m_contest.add([&](const auto round) {
      m_heat.emplace(m_mesh);
      m_heat->run(m_sources[round]);
    });
#endif
  }

  // Those of the last round.
  void collect_errors(const Vertex source)
  {
    for(const Vertex v : m_mesh.vertices())
    {
      const double exact = m_maps[EXACT][v];
      if(v == source)
        continue;
      for(const std::size_t i : {EDGES, COARSE, FINE})
        m_errors[i].add(m_maps[i][v], exact);
#ifdef CGAL_EIGEN3_ENABLED
      m_errors[HEAT].add(m_heat->distance(v), exact);
#endif
    }
  }

  void compare_with_class(const Vertex source)
  {
    const std::vector<double> theirs = distances_of_class(m_name, m_mesh, source);
    if(theirs.empty())
      return;
    m_seconds_of_class = theirs.back();
    CGAL::approximate_geodesic_distances(m_mesh, m_maps[EXACT], source, parameters::epsilon(0));
    for(const Vertex v : m_mesh.vertices())
      m_errors[CLASS].add(theirs[v.idx()], m_maps[EXACT][v]);
  }

  bool has_class() const { return m_seconds_of_class > 0; }
  double seconds(const std::size_t number) const { return m_contest.median_seconds(number); }
  double ratio(const std::size_t i, const std::size_t j) const { return m_contest.ratio(i, j); }

  Table::Row row_of(Table& table) const
  {
    Table::Row row = table.add_row();
    row.add(m_name).add(double(m_mesh.number_of_vertices()), 0);
    return row;
  }

  std::string m_name;
  Mesh m_mesh;
  std::vector<Vertex> m_sources;
  std::vector<Map> m_maps; // of calls
  std::optional<Intrinsic_triangulation> m_triangulation;
  std::optional<Priority_queue_dijkstra> m_queue;
  Boost_dijkstra m_boost;
#ifdef CGAL_EIGEN3_ENABLED
  std::optional<Heat_search> m_heat;
#endif
  Contest m_contest;
  std::array<Errors, NUMBER> m_errors;
  double m_seconds_of_class = 0;
};

static void compare(const Options& options, const Report& report)
{
  Table times = Surface_benchmark::empty_times(), ratios = Surface_benchmark::empty_ratios(),
        errors = Surface_benchmark::empty_errors();
  for(const Surface& surface : surfaces(options))
  {
    const Surface_benchmark benchmark(surface, options.number_of_rounds);
    benchmark.add_times(times);
    benchmark.add_ratios(ratios);
    benchmark.add_errors(errors);
  }
  report.print("surfaces",
               "One call with everything included, along edges, with epsilon 0.1 and 0.01, and "
               "exact; std::priority_queue along edges of arrays that are there; Boost's Dijkstra "
               "on the mesh with its lengths; CGAL's heat method and exact class (medians of " +
                   std::to_string(options.number_of_rounds) +
                   " sources; the class, and meshes of a million vertices: one)",
               times);
  report.print("surfaces_ratios", "Ratios of these times", ratios);
  report.print("surfaces_errors",
               "Errors against the exact distances; those of the exact class as they are, not in "
               "percent",
               errors);
  std::cout << "-: the exact class is not asked on more than " << LARGEST_FOR_CLASS
            << " vertices, where it takes gigabytes and more than a minute, and has "
            << SECONDS_FOR_CLASS << " s on smaller ones.\n";
}

static void write_all(const Options& options, const std::string& folder)
{
  for(const Surface& surface : surfaces(options))
  {
    const Mesh mesh = surface.make();
    std::string name =
        folder + "/" + surface.name + " " + std::to_string(mesh.number_of_vertices()) + ".off";
    std::replace(name.begin() + std::ptrdiff_t(folder.size()), name.end(), ' ', '_');
    if(!CGAL::IO::write_polygon_mesh(name, mesh, parameters::stream_precision(17)))
      throw std::runtime_error("cannot write " + name);
  }
}

int main(int argc, char* argv[])
{
  std::string folder;
  More_options more;
  more.add_options()("write", boost::program_options::value(&folder),
                     "only write the meshes to this folder, for other programs");
  const auto run = [&](const Options& options, const Report& report) {
    folder.empty() ? compare(options, report) : write_all(options, folder);
  };
  return run_benchmark(argc, argv, "bench_surfaces", {usual_meshes(), 3, ""}, run, more);
}
