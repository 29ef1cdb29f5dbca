// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact cells of random points of a mesh: the time of voronoi_borders(), and what it is of the time
// of the exact distances from the same points.

#include <CGAL/Approximate_geodesics/Queries/voronoi_borders.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Location = AG::Face_location<Mesh>;

std::vector<Location> random_points(const Mesh& mesh, const std::size_t number)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  std::uniform_int_distribution<Mesh::size_type> face(0, mesh.number_of_faces() - 1);
  std::vector<Location> result;
  while(result.size() < number)
  {
    const double t = part(random), s = part(random);
    if(t + s <= 1)
      result.push_back({Mesh::Face_index(face(random)), {1 - t - s, t, s}});
  }
  return result;
}

template <typename F>
double smallest_time(const F& f)
{
  double result = std::numeric_limits<double>::infinity();
  for(int i = 0; i < 5; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    f();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    result = (std::min)(result, time.count());
  }
  return result;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off"),
                                  mesh))
    return EXIT_FAILURE;
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  std::cout << "sources  distances, s  cells, s  ratio  borders\n";
  for(const std::size_t number : {10u, 100u, 1000u})
  {
    const std::vector<Location> sources = random_points(mesh, number);
    std::size_t borders = 0;
    const double search = smallest_time([&] {
      CGAL::approximate_geodesic_distances(mesh, distance, sources, CGAL::parameters::epsilon(0));
    });
    const double cells =
        smallest_time([&] { borders = AG::voronoi_borders(mesh, sources).borders.size(); });
    std::cout << number << "  " << search << "  " << cells << "  " << cells / search << "  "
              << borders << "\n";
  }
}
