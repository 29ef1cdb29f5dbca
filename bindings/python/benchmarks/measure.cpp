// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures in C++ what compare.py measures in Python, and prints the shortest times in seconds.
//
// Usage: measure MESH EPSILON NUMBER_OF_SEARCHES NUMBER_OF_ROWS REPETITIONS

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Shortest_paths = AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>;

template <typename F>
double shortest_time(const int repetitions, F f)
{
  double result = std::numeric_limits<double>::infinity();
  for(int i = 0; i < repetitions; ++i)
  {
    CGAL::Real_timer timer;
    timer.start();
    f();
    result = (std::min)(result, timer.time());
  }
  return result;
}

// as many vertices as wanted, at equal steps
std::vector<Mesh::Vertex_index> some_vertices(const Mesh& mesh, const std::size_t number)
{
  std::vector<Mesh::Vertex_index> result;
  for(std::size_t i = 0; i < number; ++i)
    result.emplace_back(static_cast<Mesh::size_type>(i * mesh.number_of_vertices() / number));
  return result;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 6 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "Usage: measure MESH EPSILON NUMBER_OF_SEARCHES NUMBER_OF_ROWS REPETITIONS\n";
    return EXIT_FAILURE;
  }
  const std::size_t number_of_searches = std::stoul(argv[3]), number_of_rows = std::stoul(argv[4]);
  const int repetitions = std::stoi(argv[5]);
  Shortest_paths paths(mesh, CGAL::parameters::epsilon(std::stod(argv[2])));

  std::vector<double> distances(mesh.number_of_vertices());
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  const auto search = [&](const std::size_t number, const int times) {
    return shortest_time(times, [&] {
      for(const auto v : some_vertices(mesh, number))
      {
        paths.remove_all_source_points();
        paths.add_source_point(v);
        paths.shortest_distances_to_source_points(map);
      }
    });
  };
  std::cout << search(1, static_cast<int>(number_of_searches)) << ' '
            << search(number_of_searches, repetitions) << ' ';

  std::vector<std::size_t> sources;
  for(const auto v : some_vertices(mesh, number_of_rows))
    sources.push_back(v);
  std::cout << shortest_time(repetitions, [&] {
    AG::Dense_rows<double> rows;
    CGAL::approximate_geodesic_distance_matrix(paths.graph(), rows, sources);
  }) << '\n';
  return EXIT_SUCCESS;
}
