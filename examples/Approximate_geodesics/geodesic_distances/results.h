#ifndef GEODESIC_DISTANCES_RESULTS_H
#define GEODESIC_DISTANCES_RESULTS_H

#include "colors.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// What is written to files.
template <typename Mesh>
struct Results
{
  using Path = std::vector<typename Mesh::Point>;

  template <typename Shortest_paths, typename Vertices>
  Results(const Mesh& mesh, Shortest_paths& shortest_paths, const Vertices& targets)
    : distances(mesh.num_vertices(), std::numeric_limits<double>::infinity())
  {
    for(const auto v : vertices(mesh))
    {
      const double distance = shortest_paths.shortest_distance_to_source_points(v).first;
      if(distance < 0)
        continue; // not reached
      distances[v] = distance;
      largest = (std::max)(largest, distance);
    }
    for(const auto target : targets)
    {
      Path path;
      shortest_paths.shortest_path_points_to_source_points(target, std::back_inserter(path));
      if(!path.empty())
        paths.push_back(path);
    }
  }

  // the distance of a vertex as a part of the largest one
  template <typename Vertex>
  double part(const Vertex v) const
  {
    return largest > 0 ? distances[v] / largest : 0;
  }

  std::vector<double> distances; // by vertex
  double largest = 0;
  std::vector<Path> paths;
};

inline std::ofstream open_file(const std::string& file,
                               const std::ios::openmode mode = std::ios::out)
{
  std::ofstream out(file, mode);
  if(!out)
    throw std::runtime_error("cannot write to " + file);
  out.precision(17);
  return out;
}

template <typename Mesh>
void write_distances(const std::string& file, Mesh mesh, const Results<Mesh>& results)
{
  using Vertex = typename Mesh::Vertex_index;
  auto distance = mesh.template add_property_map<Vertex, double>("v:distance", -1).first;
  auto color = mesh.template add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(const Vertex v : vertices(mesh))
  {
    if(!std::isfinite(results.distances[v]))
    {
      color[v] = CGAL::IO::gray();
      continue;
    }
    distance[v] = results.distances[v];
    const Color c = color_of(results.part(v));
    const auto byte = [](const double x) { return static_cast<unsigned char>(255 * x); };
    color[v] = CGAL::IO::Color(byte(c[0]), byte(c[1]), byte(c[2]));
  }
  std::ofstream out = open_file(file, std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  if(!CGAL::IO::write_PLY(out, mesh))
    throw std::runtime_error("cannot write to " + file);
}

template <typename Path>
void write_paths(const std::string& file, const std::vector<Path>& paths)
{
  std::ofstream out = open_file(file);
  for(const Path& path : paths)
  {
    out << path.size();
    for(const auto& point : path)
      out << ' ' << point;
    out << '\n';
  }
}

#endif // GEODESIC_DISTANCES_RESULTS_H
