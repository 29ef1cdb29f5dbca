// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/sample_meshes.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/config.h>

#include <algorithm>
#include <filesystem>

namespace geodesics_test {

// Reads a mesh that comes with CGAL; the mesh stays empty if it cannot be read.
Mesh sample_mesh(const std::string& name)
{
  Mesh result;
  if(!CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), result))
    result.clear();
  return result;
}

// The names of all files that come with CGAL and hold a mesh in a format that it reads.
std::vector<std::string> names_of_sample_files()
{
  std::vector<std::string> result;
  for(const auto& file : std::filesystem::directory_iterator(CGAL::data_file_path("meshes")))
  {
    const std::string extension = file.path().extension().string();
    if(extension == ".off" || extension == ".ply" || extension == ".stl")
      result.push_back(file.path().filename().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace geodesics_test
