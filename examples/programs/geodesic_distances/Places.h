#ifndef GEODESIC_DISTANCES_PLACES_H
#define GEODESIC_DISTANCES_PLACES_H

#include "../command_line/lines_of_file.h"
#include "../command_line/listed_vertices.h"
#include "../command_line/read_mesh.h"
#include "../command_line/vertex_numbers.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_locations.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/aabb_traits.h>
#include <CGAL/Geodesic_constructions/Source_curve.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// A source or a target.
struct Place
{
  std::string name; // as it was given, or the index of a random vertex
  std::vector<CGAL::Approximate_geodesics::Surface_point<Mesh>>
      points; // copies of a vertex, or one
};

// The curve through some places, which is closed if the last one is the first one.
inline CGAL::Approximate_geodesics::Source_curve<Mesh>
curve_through(const std::vector<Place>& places)
{
  CGAL::Approximate_geodesics::Source_curve<Mesh> result;
  for(const Place& place : places)
    result.points.push_back(place.points.front());
  result.is_closed = places.size() > 2 && places.front().name == places.back().name;
  if(result.is_closed)
    result.points.pop_back();
  return result;
}

// Finds the places that are given by vertex index, by x,y,z, by `random:K`, by `file:NAME`, or by
// `polyline:NAME`. The text is checked before the mesh is there.
class Place_finder
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Mesh::Point;
  using Locations = CGAL::Approximate_geodesics::Surface_locations<Mesh>;
  using AABB_tree =
      CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

public:
  // Refuses what cannot be a place on any mesh. `option` is named in errors.
  static void check(const std::string& option, const std::vector<std::string>& names)
  {
    for(const std::string& name : names)
      name_in_errors(option + ' ' + name, [&] {
        if(const auto file = text_after("file", name))
          listed_vertices(*file);
        else if(const auto polyline = text_after("polyline", name))
          points_of_polyline(*polyline);
        else if(!coordinates(name) && !number_after("random", name))
          to_vertex_index(name, ", nor x,y,z, random:K, file:NAME or polyline:NAME");
      });
  }

  // The mesh is referred to, not copied.
  Place_finder(const Mesh_of_file& mesh, const std::uint64_t seed)
    : m_file(mesh), m_mesh(mesh.mesh), m_random(seed)
  {
  }

  std::vector<Place> find(const std::string& option, const std::vector<std::string>& names)
  {
    std::vector<Place> result;
    for(const std::string& name : names)
      name_in_errors(option + ' ' + name, [&] {
        const auto add_vertex = [&](const std::size_t v) {
          result.push_back(vertex(option + ' ' + name, v));
        };
        if(const auto file = text_after("file", name))
          for(const auto v : checked_indices(listed_vertices(*file), m_file.vertices.number()))
            add_vertex(v);
        else if(const auto polyline = text_after("polyline", name))
          for(const Point& p : points_of_polyline(*polyline))
            result.push_back({text_of(p), {nearest(option + ' ' + name, p)}});
        else if(const auto point = coordinates(name))
          result.push_back({name, {nearest(option + ' ' + name, *point)}});
        else if(const auto number = number_after("random", name))
          for(const auto v : random_vertices(vertices_with_faces(m_file), *number, m_random))
            add_vertex(v);
        else
          add_vertex(to_vertex_index(name));
      });
    return result;
  }

  // The file that is read for a place, if any.
  static std::string file_of(const std::string& name)
  {
    const auto file = text_after("file", name), polyline = text_after("polyline", name);
    return file ? *file : polyline ? *polyline : std::string();
  }

private:
  static std::string text_of(const Point& p)
  {
    std::ostringstream out;
    out << p.x() << ',' << p.y() << ',' << p.z();
    return out.str();
  }

  // A line has the number of points, and then their coordinates.
  static std::vector<Point> points_of_polyline(const std::string& file)
  {
    std::vector<Point> result;
    for_each_line(file, [&](const std::vector<std::string>& words, const std::string&) {
      std::vector<double> numbers;
      for(const std::string& word : words)
      {
        char* end = nullptr;
        numbers.push_back(std::strtod(word.c_str(), &end));
        if(*end != '\0' || !std::isfinite(numbers.back()))
          throw std::invalid_argument('"' + word + "\" is not a finite number");
      }
      if(!result.empty())
        throw std::invalid_argument("there is more than one polyline");
      if(!(numbers[0] >= 1 && double(numbers.size()) == 3 * numbers[0] + 1))
        throw std::invalid_argument("the number of points must come first, and then three "
                                    "coordinates of each");
      for(std::size_t i = 1; i < numbers.size(); i += 3)
        result.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    });
    if(result.empty())
      throw std::invalid_argument("the file has no polyline");
    return result;
  }

  static std::optional<Point> coordinates(const std::string& text)
  {
    if(text.find(',') == std::string::npos)
      return std::nullopt;
    std::istringstream in(text);
    double x = 0, y = 0, z = 0;
    char first = ' ', second = ' ', rest = ' ';
    if(!(in >> x >> first >> y >> second >> z) || first != ',' || second != ',' || in >> rest)
      throw std::invalid_argument("three numbers are needed, as in 1,2.5,-3");
    return Point(x, y, z);
  }

  // Tells if no path can begin or end there.
  Place vertex(const std::string& name, const std::size_t index) const
  {
    check_vertex_index(index, m_file.vertices.number());
    if(!m_file.has_faces(index))
      std::clog << name << ": vertex " << index
                << " has no faces, so no path leads from or to it.\n";
    Place result{std::to_string(index), {}};
    for(const std::size_t v : m_file.vertices.vertices(index))
      result.points.emplace_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
    return result;
  }

  // Tells if the point is not on the surface.
  Locations::Face_location nearest(const std::string& name, const Point& point)
  {
    if(m_tree.empty())
      Locations::build_aabb_tree(m_mesh, m_tree);
    const Locations::Face_location result =
        Locations::locate(point, m_tree, m_mesh, m_mesh.points());
    const Point found = Locations::point(result.first, result.second, m_mesh);
    const auto box = CGAL::Polygon_mesh_processing::bbox(m_mesh);
    const double size =
        (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    const double distance = std::sqrt(CGAL::squared_distance(point, found));
    if(distance > 1e-6 * size)
      std::clog << name << ": the nearest point of the surface is " << found << ", " << distance
                << " away.\n";
    return result;
  }

  const Mesh_of_file& m_file;
  const Mesh& m_mesh;
  std::mt19937_64 m_random;
  AABB_tree m_tree;
};

#endif // GEODESIC_DISTANCES_PLACES_H
