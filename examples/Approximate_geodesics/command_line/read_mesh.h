#ifndef COMMAND_LINE_READ_MESH_H
#define COMMAND_LINE_READ_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <stdexcept>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

inline Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh) || mesh.is_empty())
    throw std::runtime_error("cannot read a mesh from " + file);
  if(!CGAL::is_triangle_mesh(mesh))
  {
    std::clog << "Some faces are not triangles: they are triangulated.\n";
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  }
  return mesh;
}

#endif // COMMAND_LINE_READ_MESH_H
