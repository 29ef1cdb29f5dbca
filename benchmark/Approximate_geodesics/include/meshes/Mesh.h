// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_MESH_H
#define BENCHMARK_MESH_H

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

// A mesh is given as a file, or as a sample mesh of CGAL without folder and extension; the suffix
// "+2" means two steps of Loop subdivision. Scans have small components and non-manifold vertices:
// CGAL repairs them, and only the largest connected component is kept.

// The end of the name without subdivision; file names may contain a plus sign.
inline std::size_t position_of_plus(const std::string& name)
{
  const std::size_t plus = name.rfind('+');
  const bool is_number =
      plus + 1 < name.size() && name.find_first_not_of("0123456789", plus + 1) == std::string::npos;
  return plus != std::string::npos && is_number ? plus : name.size();
}

inline std::string file_of(const std::string& name)
{
  const std::string file = name.substr(0, position_of_plus(name));
  return std::ifstream(file) ? file : CGAL::data_file_path("meshes/" + file + ".off");
}

inline unsigned number_of_subdivisions(const std::string& name)
{
  const std::size_t plus = position_of_plus(name);
  return plus == name.size() ? 0 : static_cast<unsigned>(std::stoul(name.substr(plus + 1)));
}

// The name without folder and extension.
inline std::string short_name(const std::string& name)
{
  const std::size_t plus = position_of_plus(name);
  return std::filesystem::path(name.substr(0, plus)).stem().string() + name.substr(plus);
}

// Returns the mesh files.
inline std::vector<std::string> all_sample_meshes()
{
  std::vector<std::string> result;
  for(const auto& entry : std::filesystem::directory_iterator(CGAL::data_file_path("meshes")))
    if(entry.path().extension() == ".off")
      result.push_back(entry.path().string());
  std::sort(result.begin(), result.end());
  return result;
}

inline Mesh read_mesh(const std::string& name)
{
  std::cerr << "Reading " << name << " ...\n";
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(file_of(name), mesh) || mesh.is_empty())
    throw std::runtime_error("cannot read a mesh from " + name);
  PMP::keep_largest_connected_components(mesh, 1);
  if(number_of_subdivisions(name) > 0)
    CGAL::Subdivision_method_3::Loop_subdivision(
        mesh, CGAL::parameters::number_of_iterations(number_of_subdivisions(name)));
  mesh.collect_garbage();
  return mesh;
}

// Vertices depend on the seed.
inline std::vector<Vertex>
random_vertices(const Mesh& mesh, const std::size_t count, const unsigned seed)
{
  std::mt19937_64 random(seed);
  std::vector<Vertex> result;
  while(result.size() < count)
    result.push_back(Vertex(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices())));
  return result;
}

inline std::vector<Vertex> random_sources(const Mesh& mesh, const std::size_t count)
{
  return random_vertices(mesh, count, 1);
}

// Given at least one random source, returns the first vertex of the mesh and all sources except
// one.
inline std::vector<Vertex> first_and_random(std::vector<Vertex> sources)
{
  sources.front() = Vertex(0);
  return sources;
}

#endif // BENCHMARK_MESH_H
