#ifndef COMMAND_LINE_READ_MESH_H
#define COMMAND_LINE_READ_MESH_H

#include "Repaired_soup.h"
#include "files.h"

#include <CGAL/Approximate_geodesics/Solver/read_soup.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

inline std::size_t number_of_components(const Mesh& mesh)
{
  std::vector<std::size_t> component(mesh.num_faces());
  return CGAL::Polygon_mesh_processing::connected_components(mesh,
                                                             CGAL::make_property_map(component));
}

// Which points are the same could not be told if some are not numbers.
inline void check_coordinates(const std::vector<Mesh::Point>& points, const std::string& file)
{
  for(std::size_t i = 0; i < points.size(); ++i)
    for(const double x : {points[i].x(), points[i].y(), points[i].z()})
      if(!std::isfinite(x))
        throw std::runtime_error("vertex " + std::to_string(i) + " of " + file + " has " +
                                 std::to_string(x) + " as a coordinate");
}

// Whether faces have to be those of the file, as something is given for each of them.
enum class Faces
{
  ANY,
  OF_THE_FILE
};

// Says what is done to a file that is not a triangle mesh as it is.
inline Mesh read_mesh(const std::string& file, const Faces faces = Faces::ANY)
{
  check_readable(file);
  std::vector<Mesh::Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  CGAL::Approximate_geodesics::read_soup(file, points, polygons);
  check_coordinates(points, file);
  if(polygons.empty())
    throw std::runtime_error("the mesh in " + file + " has no faces");
  Mesh mesh;
  const Repaired_soup<Mesh::Point> soup(std::move(points), std::move(polygons));
  if(soup.polygons.empty())
    throw std::runtime_error("the mesh in " + file + " has no face with three vertices");
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  const bool has_triangles = CGAL::is_triangle_mesh(mesh);
  if(faces == Faces::OF_THE_FILE && (soup.is_changed() || !has_triangles))
    throw std::runtime_error("the mesh in " + file +
                             " has to be repaired or triangulated, so its faces are not those of "
                             "the file, and there are no weights for them");
  if(soup.is_changed())
  {
    soup.describe(std::clog);
    std::clog << "The mesh has " << mesh.number_of_vertices() << " vertices, "
              << mesh.number_of_faces()
              << " faces, and this number of connected components: " << number_of_components(mesh)
              << ".\n";
  }
  if(!has_triangles)
  {
    std::clog << "Some faces are not triangles: they are triangulated.\n";
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  }
  return mesh;
}

#endif // COMMAND_LINE_READ_MESH_H
