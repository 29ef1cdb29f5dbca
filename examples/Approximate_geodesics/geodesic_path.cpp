// A shortest path between two vertices, written to a file as a polyline.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

// A polyline is a line of text: the number of its points, and their coordinates.
bool write_polyline(const std::string& filename, const std::vector<Point>& points)
{
  std::ofstream out(filename);
  out.precision(17);
  out << points.size();
  for(const Point& p : points)
    out << "  " << p;
  out << "\n";
  out.close();
  return out.good();
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty() ||
     !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "No triangle mesh could be read from " << filename << "\n";
    return EXIT_FAILURE;
  }

  // from one end of the model to the other
  const auto [leftmost, rightmost] = std::minmax_element(
      mesh.vertices().begin(), mesh.vertices().end(),
      [&](const Vertex v, const Vertex w) { return mesh.point(v).x() < mesh.point(w).x(); });
  const Vertex source = *leftmost, target = *rightmost;

  std::vector<Point> points;
  const double length =
      CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source, target);
  if(points.empty())
  {
    std::cerr << "Vertices " << source << " and " << target << " are not connected.\n";
    return EXIT_FAILURE;
  }

  const double air_line = std::sqrt(CGAL::squared_distance(points.front(), points.back()));
  std::cout << "The path from vertex " << source << " to vertex " << target << " has "
            << points.size() << " points and a length of " << length << ";\n"
            << "the straight line through the air has " << air_line << ".\n";

  const std::string output = "geodesic_path.polylines.txt";
  if(!write_polyline(output, points))
  {
    std::cerr << "Cannot write " << output << "\n";
    return EXIT_FAILURE;
  }
  std::cout << "The path is in " << output << ".\n";
  return EXIT_SUCCESS;
}
