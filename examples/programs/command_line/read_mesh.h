#ifndef COMMAND_LINE_READ_MESH_H
#define COMMAND_LINE_READ_MESH_H

#include "Repaired_soup.h"
#include "Vertices_of_file.h"
#include "files.h"
#include "first_in_same_place.h"
#include "mesh_of_triangles.h"

#include <CGAL/Approximate_geodesics/Solver/read_soup.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

// The number of connected components, without vertices that have no faces.
inline std::size_t number_of_components(const Mesh& mesh)
{
  std::vector<Mesh::size_type> parents(mesh.number_of_vertices()); // of a disjoint-set forest
  std::iota(parents.begin(), parents.end(), Mesh::size_type(0));
  const auto root = [&](Mesh::size_type v) {
    while(parents[v] != v)
      v = parents[v] = parents[parents[v]];
    return v;
  };
  for(const auto e : mesh.edges())
    parents[root(mesh.vertex(e, 0))] = root(mesh.vertex(e, 1));
  const auto is_root = [&](const Mesh::Vertex_index v) {
    return parents[v] == v && !mesh.is_isolated(v);
  };
  return static_cast<std::size_t>(
      std::count_if(mesh.vertices_begin(), mesh.vertices_end(), is_root));
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

// A triangle mesh, and which of its elements are those of the file that it was made of.
struct Mesh_of_file
{
  Mesh mesh;
  Vertices_of_file vertices;
  std::size_t number_of_faces = 0;        // in the file
  std::vector<std::size_t> faces_of_file; // of the faces of the mesh; none if they are the same

  std::size_t face_of_file(const Mesh::Face_index f) const
  {
    return faces_of_file.empty() ? std::size_t(f) : faces_of_file[f];
  }

  // The vertex of the mesh that has faces of a vertex of the file, if that has any.
  Mesh::Vertex_index vertex(const std::size_t number) const
  {
    return Mesh::Vertex_index(Mesh::size_type(vertices.vertex(number)));
  }

  bool has_faces(const std::size_t number) const { return !mesh.is_isolated(vertex(number)); }
};

// The numbers in the file of vertices that have faces, each place once.
inline std::vector<std::uint64_t> vertices_with_faces(const Mesh_of_file& mesh)
{
  std::vector<std::uint64_t> result;
  for(std::size_t i = 0; i < mesh.vertices.number(); ++i)
    if(mesh.vertices.vertex(i) == i && mesh.has_faces(i))
      result.push_back(i);
  return result;
}

// Notes which faces the parts of others belong to.
struct Tracker_of_faces : CGAL::Polygon_mesh_processing::Triangulate_faces::Default_visitor<Mesh>
{
  explicit Tracker_of_faces(std::vector<std::size_t>& the_numbers) : numbers(&the_numbers) {}

  void before_subface_creations(const Mesh::Face_index f) { number = (*numbers)[f]; }

  void after_subface_created(const Mesh::Face_index f)
  {
    numbers->resize((std::max)(numbers->size(), std::size_t(f) + 1));
    (*numbers)[f] = number;
  }

  std::vector<std::size_t>* numbers;
  std::size_t number = 0;
};

inline void triangulate(Mesh_of_file& result)
{
  std::clog << "Some faces are not triangles: they are triangulated.\n";
  CGAL::Polygon_mesh_processing::triangulate_faces(
      result.mesh, CGAL::parameters::visitor(Tracker_of_faces(result.faces_of_file)));
}

// Repairs what the file has, and says what is done.
inline void
make_mesh_by_repair(Mesh_of_file& result, const std::string& file, Repaired_soup<Mesh::Point> soup)
{
  if(soup.polygons.empty())
    throw std::runtime_error("the mesh in " + file + " has no face with three vertices");
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons,
                                                              result.mesh);
  if(soup.is_changed())
  {
    soup.describe(std::clog);
    std::clog << "The mesh has " << result.mesh.number_of_faces()
              << " faces, and this number of connected components: "
              << number_of_components(result.mesh) << ".\n";
  }
  result.vertices = std::move(soup.vertices);
  result.faces_of_file = std::move(soup.faces_of_file);
  if(!CGAL::is_triangle_mesh(result.mesh))
    triangulate(result);
}

// They are reached from nowhere, which could be taken for a failure.
inline void tell_of_vertices_without_faces(const Mesh_of_file& mesh)
{
  std::size_t number = 0, first = 0;
  for(std::size_t i = mesh.vertices.number(); i-- > 0;)
    if(!mesh.has_faces(i))
    {
      ++number;
      first = i;
    }
  if(number > 0)
    std::clog << "Vertices without faces, which no path leads to: " << number << ", such as vertex "
              << first << ".\n";
}

// Says what is done to a file that is not a triangle mesh as it is.
inline Mesh_of_file read_mesh(const std::string& file)
{
  check_readable(file);
  std::vector<Mesh::Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  CGAL::Approximate_geodesics::read_soup(file, points, polygons);
  check_coordinates(points, file);
  if(polygons.empty())
    throw std::runtime_error("the mesh in " + file + " has no faces");
  Mesh_of_file result;
  result.number_of_faces = polygons.size();
  std::vector<std::size_t> first_there = first_in_same_place(points);
  std::optional<Mesh> clean;
  if(first_there.empty())
    clean = mesh_of_triangles<Mesh>(points, polygons);
  if(clean)
  {
    result.mesh = std::move(*clean);
    result.vertices = Vertices_of_file(points.size());
  }
  else
    make_mesh_by_repair(result, file, {std::move(points), std::move(polygons), first_there});
  tell_of_vertices_without_faces(result);
  return result;
}

#endif // COMMAND_LINE_READ_MESH_H
