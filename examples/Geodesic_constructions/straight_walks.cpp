// Straight ahead from a vertex in twelve directions, and back again by the logarithmic map, which
// is also a chart of the surface: here, it carries a checkerboard.

#include <CGAL/Geodesic_constructions/logarithmic_map.h>
#include <CGAL/Geodesic_constructions/trace_geodesic.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace AG = CGAL::Approximate_geodesics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

using Tracer = AG::Geodesic_tracer<Mesh>;

// Writes walks from a vertex as polylines.
bool write_walks(const Tracer& tracer,
                 const Vertex start,
                 const double length,
                 const std::string& name)
{
  constexpr int number_of_walks = 12;
  const double full_angle = 8 * std::atan(1.);
  std::ofstream out(name);
  out.precision(17);
  for(int i = 0; i < number_of_walks; ++i)
  {
    const double angle = full_angle * i / number_of_walks;
    const Tracer::Walk walk =
        tracer.trace(start, AG::Tangent_vector{std::cos(angle), std::sin(angle)}, length);
    out << walk.points.size();
    for(const AG::Surface_point<Mesh>& p : walk.points)
      out << "  " << tracer.point_3(p);
    out << "\n";
  }
  return bool(out);
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty() ||
     !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "No triangle mesh could be read from " << filename << "\n";
    return EXIT_FAILURE;
  }
  const Vertex start(0);

  // the direction and the length of a shortest path to each vertex
  const auto vectors = mesh.add_property_map<Vertex, AG::Tangent_vector>("v:logarithm").first;
  AG::logarithmic_map(mesh, vectors, start);

  const Tracer tracer(mesh); // reads the mesh once for all walks
  double largest = 0;
  std::size_t number_of_ends = 0;
  for(const Vertex v : mesh.vertices())
  {
    const double length = std::hypot(vectors[v].x, vectors[v].y);
    if(!(length > 0 && std::isfinite(length)))
      continue;
    largest = (std::max)(largest, length);
    const Tracer::Walk walk = tracer.trace(start, vectors[v], length);
    const Point end = tracer.point_3(walk.points.back());
    if(CGAL::squared_distance(end, mesh.point(v)) < 1e-18 * length * length)
      ++number_of_ends;
  }
  std::cout << "Straight walks from vertex " << start << " end at " << number_of_ends
            << " other vertices. Shortest paths to the rest bend at vertices.\n";

  const auto colors = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  const double side = largest / 12;
  for(const Vertex w : mesh.vertices())
  {
    const double column = std::floor(vectors[w].x / side), row = std::floor(vectors[w].y / side);
    const bool is_dark = std::fmod(std::abs(column + row), 2) == 1;
    colors[w] = is_dark ? CGAL::IO::Color(60, 90, 160) : CGAL::IO::Color(235, 235, 225);
  }
  if(!CGAL::IO::write_PLY("straight_walks.ply", mesh) ||
     !write_walks(tracer, start, largest / 2, "straight_walks.polylines.txt"))
  {
    std::cerr << "Cannot write straight_walks.ply or straight_walks.polylines.txt\n";
    return EXIT_FAILURE;
  }
  std::cout << "A checkerboard around vertex " << start
            << " is in straight_walks.ply, and walks from it in straight_walks.polylines.txt.\n";
  return EXIT_SUCCESS;
}
