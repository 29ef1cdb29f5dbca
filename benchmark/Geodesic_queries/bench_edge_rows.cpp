// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Rows of distances along edges, as compare_with_scipy.py asks for them: it gets the graph, the
// sources and the distances as files, and the time for each line that it sends.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Sphere.h"

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Npy_file.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

template <typename T>
static void write(const std::vector<T>& numbers, const std::string& file)
{
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(numbers.data()),
            std::streamsize(numbers.size() * sizeof(T)));
  if(!out.flush())
    throw std::runtime_error("cannot write " + file);
}

// The edges of the mesh with their lengths, as a sparse matrix with a row and a column per vertex.
static void write_edges(const Mesh& mesh, const std::string& prefix)
{
  std::vector<std::uint32_t> degrees, columns;
  std::vector<double> lengths;
  for(const Vertex v : mesh.vertices())
  {
    degrees.push_back(std::uint32_t(mesh.degree(v)));
    for(const Vertex w : vertices_around_target(mesh.halfedge(v), mesh))
    {
      columns.push_back(w);
      lengths.push_back(std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w))));
    }
  }
  write(degrees, prefix + "degrees");
  write(columns, prefix + "columns");
  write(lengths, prefix + "lengths");
}

static void answer(const std::string& name, const std::size_t number, const std::string& prefix)
{
  const bool is_sphere = name.rfind("sphere", 0) == 0;
  const Mesh mesh = is_sphere ? sphere(std::stoul(name.substr(6))) : read_mesh(name);
  const auto vertices = random_sources(mesh, number);
  const std::vector<std::size_t> sources(vertices.begin(), vertices.end());
  const AG::Edge_graph graph{AG::Intrinsic_triangulation(mesh)};
  write_edges(mesh, prefix);
  CGAL::approximate_geodesic_distance_matrix(graph, AG::Npy_file<double>(prefix + "rows.npy"),
                                             sources);
  for(const std::size_t source : sources)
    std::cout << source << ' ';
  std::cout << std::endl;
  for(std::string line; std::getline(std::cin, line);)
  {
    AG::Dense_rows<double> rows;
    std::cout << seconds_of([&] {
      CGAL::approximate_geodesic_distance_matrix(graph, rows, sources);
    }) << std::endl;
  }
}

int main(int argc, char* argv[])
{
  try
  {
    if(argc != 4)
    {
      std::cerr << "Usage: bench_edge_rows MESH|sphereN NUMBER_OF_SOURCES PREFIX_OF_FILES\n";
      return EXIT_FAILURE;
    }
    answer(argv[1], std::stoul(argv[2]), argv[3]);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "bench_edge_rows: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
