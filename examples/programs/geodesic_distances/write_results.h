#ifndef GEODESIC_DISTANCES_WRITE_RESULTS_H
#define GEODESIC_DISTANCES_WRITE_RESULTS_H

#include "Vtp_file.h"
#include "colors.h"
#include "results.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

// What viewers show in a color of its own, in place of infinity.
inline std::vector<double> with_nan(std::vector<double> numbers)
{
  for(double& number : numbers)
    number = std::isfinite(number) ? number : std::numeric_limits<double>::quiet_NaN();
  return numbers;
}

inline CGAL::IO::Color
color_of_distance(const double distance, const double largest, const bool is_uniform)
{
  if(!std::isfinite(distance))
    return CGAL::IO::gray();
  const double part = largest > 0 ? std::abs(distance) / largest : 0;
  const Color c = is_uniform ? color_of(part, uniform_colors) : color_of(part, rainbow);
  const auto byte = [](const double x) { return static_cast<unsigned char>(255 * x); };
  return CGAL::IO::Color(byte(c[0]), byte(c[1]), byte(c[2]));
}

inline void
write_ply(std::ostream& out, Mesh mesh, const Results& results, const bool has_uniform_colors)
{
  using Vertex = Mesh::Vertex_index;
  const std::vector<double> distances = with_nan(results.distances);
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  auto quality = mesh.add_property_map<Vertex, float>("v:quality").first; // MeshLab reads no double
  auto color = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(const Vertex v : mesh.vertices())
  {
    distance[v] = distances[v];
    quality[v] = static_cast<float>(distances[v]);
    color[v] = color_of_distance(distances[v], (std::max)(results.largest, -results.smallest),
                                 has_uniform_colors);
  }
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, mesh);
}

inline void write_vtp(std::ostream& out, const Mesh& mesh, const Results& results)
{
  Vtp_file vtp;
  for(const auto v : mesh.vertices())
    vtp.add_point(mesh.point(v));
  for(const auto f : mesh.faces())
  {
    std::vector<std::int64_t> corners;
    for(const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      corners.push_back(std::int64_t(v));
    vtp.polygons.add(corners);
  }
  vtp.add_array_of_points("distance", with_nan(results.distances));
  vtp.add_array_of_points("nearest_source", results.nearest_sources);
  vtp.write(out);
}

// The sources as points, and the paths as lines: `source` and `target` are the positions of these
// among all of them, or -1 if they have none, and `name` is that of the source or the target.
inline void write_paths_vtp(std::ostream& out, const Results& results)
{
  Vtp_file vtp;
  std::vector<double> lengths;
  std::vector<std::int64_t> sources, targets;
  std::vector<std::string> names = results.names_of_sources;
  for(const Mesh::Point& source : results.sources)
  {
    sources.push_back(std::int64_t(sources.size()));
    vtp.vertices.add(std::vector<std::int64_t>{vtp.add_point(source)});
    lengths.push_back(0);
    targets.push_back(-1);
  }
  for(std::size_t i = 0; i < results.paths.size(); ++i)
    if(!results.paths[i].points.empty())
    {
      vtp.add_line(results.paths[i].points);
      lengths.push_back(results.paths[i].length);
      sources.push_back(results.paths[i].position_of_source);
      targets.push_back(std::int64_t(i));
      names.push_back(results.paths[i].target);
    }
  vtp.add_array_of_cells("length", lengths);
  vtp.add_array_of_cells("source", sources);
  vtp.add_array_of_cells("target", targets);
  vtp.add_texts_of_cells("name", names);
  vtp.write(out);
}

inline void write_lines_vtp(std::ostream& out, const std::vector<Isoline>& lines)
{
  Vtp_file vtp;
  std::vector<double> distances;
  for(const Isoline& line : lines)
  {
    vtp.add_line(line.points);
    distances.push_back(line.distance);
  }
  vtp.add_array_of_cells("distance", distances);
  vtp.write(out);
}

inline void write_polyline(std::ostream& out, const std::vector<Mesh::Point>& points)
{
  out << points.size();
  for(const Mesh::Point& point : points)
    out << ' ' << point;
  out << '\n';
}

inline void write_offset_polylines(std::ostream& out, const Results& results)
{
  for(const Isoline& offset : results.offsets)
    write_polyline(out, offset.points);
}

// A line per target, whether there is a path or not.
inline void write_polylines(std::ostream& out, const Results& results)
{
  for(const Path_result& path : results.paths)
    if(path.points.empty())
      out << "inf\n";
    else
      write_polyline(out, path.points);
}

inline constexpr const char* HEADER_OF_CSV = "vertex,x,y,z,distance,nearest_source";

// A line per vertex of the file.
inline void write_csv(std::ostream& out, const Mesh_of_file& mesh, const Results& results)
{
  out << HEADER_OF_CSV << '\n';
  for(std::size_t v = 0; v < mesh.vertices.number(); ++v)
  {
    const Mesh::Point& p = mesh.mesh.point(Mesh::Vertex_index(Mesh::size_type(v)));
    out << v << ',' << p.x() << ',' << p.y() << ',' << p.z() << ',' << results.distances[v] << ','
        << results.nearest_sources[v] << '\n';
  }
}

#endif // GEODESIC_DISTANCES_WRITE_RESULTS_H
