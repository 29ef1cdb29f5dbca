// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The edge graph and the adaptive bucket queue against Boost's Dijkstra on the mesh, Dijkstra with
// std::priority_queue and breadth-first search on the same arrays; and one call of the free
// function against Boost's, with everything included. Prints the ratios: see --help.

#include "Table.h"
#include "measure.h"
#include "peers.h"

#include <CGAL/Approximate_geodesics/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Propagation.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/program_options.hpp>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Distance_map = Mesh::Property_map<Vertex, double>;
using Length_map = Mesh::Property_map<Mesh::Edge_index, double>;

void compute_lengths(const Mesh& mesh, const Length_map& lengths)
{
  for(const auto e : edges(mesh))
  {
    const auto h = halfedge(e, mesh);
    lengths[e] =
        std::sqrt(CGAL::squared_distance(mesh.point(source(h, mesh)), mesh.point(target(h, mesh))));
  }
}

void boost_dijkstra(const Mesh& mesh,
                    const Vertex source,
                    const Length_map& lengths,
                    const Distance_map& distances)
{
  boost::dijkstra_shortest_paths(mesh, source,
                                 boost::weight_map(lengths)
                                     .distance_map(distances)
                                     .vertex_index_map(get(boost::vertex_index, mesh))
                                     .predecessor_map(boost::dummy_property_map()));
}

std::vector<Vertex> random_sources(const Mesh& mesh, const std::size_t count)
{
  std::mt19937_64 random(1);
  std::vector<Vertex> result;
  while(result.size() < count)
    result.push_back(Vertex(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices())));
  return result;
}

Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh) || mesh.is_empty())
    throw std::runtime_error("cannot read a mesh from " + file);
  return mesh;
}

std::string name_of(const std::string& file)
{
  const std::size_t start = file.find_last_of('/') + 1;
  return file.substr(start, file.find_last_of('.') - start);
}

class Edge_graph_benchmark
{
public:
  Edge_graph_benchmark(const std::string& file, const std::size_t number_of_rounds)
    : m_name(name_of(file)),
      m_mesh(read_mesh(file)),
      m_sources(random_sources(m_mesh, number_of_rounds)),
      m_graph(AG::Intrinsic_triangulation(m_mesh)),
      m_lengths(m_mesh.add_property_map<Mesh::Edge_index, double>("e:length").first),
      m_distances(m_mesh.add_property_map<Vertex, double>("v:distance").first)
  {
    compute_lengths(m_mesh, m_lengths);
  }

  void compare_searches(Table& table)
  {
    AG::Propagation<AG::Edge_graph> search(m_graph);
    Breadth_first_search breadth_first(m_graph.triangulation());
    Priority_queue_dijkstra priority_queue(m_graph.triangulation());
    Contest contest;
    const auto ours = contest.add([&](const auto round) { search.run(node(round)); });
    const auto floor = contest.add([&](const auto round) { breadth_first.run(node(round)); });
    const auto heap = contest.add([&](const auto round) { priority_queue.run(node(round)); });
    const auto boost = contest.add([&](const auto round) {
      boost_dijkstra(m_mesh, m_sources[round], m_lengths, m_distances);
    });
    contest.run(m_sources.size(), 10);
    check(search);

    const double vertices = m_mesh.number_of_vertices();
    table.add_row()
        .add(m_name)
        .add(vertices, 0)
        .add(contest.median_seconds(ours) * 1e3, 3)
        .add(contest.median_seconds(floor) * 1e3, 3)
        .add(contest.median_seconds(heap) * 1e3, 3)
        .add(contest.median_seconds(boost) * 1e3, 3)
        .add(contest.ratio(boost, ours), 2)
        .add(contest.ratio(heap, ours), 2)
        .add(contest.ratio(ours, floor), 2)
        .add(static_cast<double>(m_graph.memory() + search.memory()) / vertices, 1);
  }

  void compare_single_calls(Table& table)
  {
    Contest contest;
    const auto ours = contest.add([&](const auto round) {
      CGAL::approximate_geodesic_distances(m_mesh, m_distances, m_sources[round]);
    });
    const auto boost = contest.add([&](const auto round) {
      compute_lengths(m_mesh, m_lengths);
      boost_dijkstra(m_mesh, m_sources[round], m_lengths, m_distances);
    });
    contest.run(m_sources.size());

    table.add_row()
        .add(m_name)
        .add(contest.median_seconds(ours) * 1e3, 3)
        .add(contest.median_seconds(boost) * 1e3, 3)
        .add(contest.ratio(ours, boost), 2);
  }

private:
  AG::Edge_graph::Node node(const std::size_t round) const
  {
    return m_graph.triangulation().vertex(m_sources[round]);
  }

  // Figures of wrong results are worth nothing. Boost ran last, from the same source.
  void check(const AG::Propagation<AG::Edge_graph>& search) const
  {
    for(const Vertex v : vertices(m_mesh))
    {
      const auto n = m_graph.triangulation().vertex(v);
      // fused multiply-add may round lengths differently in the two programs
      const bool agree =
          search.is_reached(n)
              ? std::abs(search.distance(n) - m_distances[v]) <= 1e-12 * m_distances[v]
              : m_distances[v] == (std::numeric_limits<double>::max)();
      if(!agree)
        throw std::runtime_error("the distances of vertex " + std::to_string(v) + " differ");
    }
  }

  std::string m_name;
  Mesh m_mesh;
  std::vector<Vertex> m_sources;
  AG::Edge_graph m_graph;
  Length_map m_lengths;
  Distance_map m_distances;
};

struct Options
{
  std::vector<std::string> files;
  std::size_t number_of_rounds = 101;
  std::string csv;
};

Options parse_options(const int argc, char* argv[])
{
  namespace po = boost::program_options;
  Options result;
  bool is_quick = false;
  po::options_description description("Usage: bench_edge_graph [options] [MESH ...]\n\nOptions");
  po::options_description_easy_init add = description.add_options();
  add("help,h", "print this text");
  add("quick,q", po::bool_switch(&is_quick),
      "only see whether it runs: a small mesh, three rounds");
  add("rounds,r", po::value(&result.number_of_rounds), "number of random sources (default: 101)");
  add("csv", po::value(&result.csv), "write the tables to this file, too");
  add("mesh", po::value(&result.files), "meshes (default: the bunny, the armadillo, the elephant)");
  po::positional_options_description positions;
  positions.add("mesh", -1);
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv).options(description).positional(positions).run(),
            values);
  po::notify(values);
  if(values.count("help") > 0)
  {
    std::cout << description;
    std::exit(EXIT_SUCCESS);
  }
  if(is_quick)
    result.number_of_rounds = 3;
  if(result.files.empty())
    result.files = is_quick ? std::vector<std::string>{"meshes/elephant.off"}
                            : std::vector<std::string>{"meshes/bunny00.off", "meshes/armadillo.off",
                                                       "meshes/refined_elephant.off"};
  for(std::string& file : result.files)
    if(!std::ifstream(file))
      file = CGAL::data_file_path(file); // one of CGAL's sample meshes
  return result;
}

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parse_options(argc, argv);
    Table searches({"mesh", "vertices", "bucket queue ms", "breadth first ms",
                    "std::priority_queue ms", "Boost ms", "Boost : ours", "priority_queue : ours",
                    "ours : breadth first", "bytes/vertex"});
    Table calls({"mesh", "free function ms", "Boost ms", "ours : Boost"});
    for(const std::string& file : options.files)
    {
      std::cerr << "Running " << file << " ...\n";
      Edge_graph_benchmark benchmark(file, options.number_of_rounds);
      benchmark.compare_searches(searches);
      benchmark.compare_single_calls(calls);
    }
    std::cout << "One source, graph and workspace built before (medians of "
              << options.number_of_rounds << " sources):\n\n";
    searches.print_text(std::cout);
    std::cout << "\nOne call with everything included (for Boost: the edges' lengths):\n\n";
    calls.print_text(std::cout);
    if(!options.csv.empty())
    {
      std::ofstream out(options.csv);
      searches.print_csv(out);
      out << '\n';
      calls.print_csv(out);
    }
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "bench_edge_graph: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
