// The program of the README: distances and a path on a mesh.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh) ||
     mesh.is_empty())
    return EXIT_FAILURE;
  const Vertex source(0), target(mesh.number_of_vertices() - 1);
  const auto within_5_percent = CGAL::parameters::epsilon(0.05);

  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  CGAL::approximate_geodesic_distances(mesh, distance, source, within_5_percent);
  std::cout << source << " to " << target << ": " << distance[target] << "\n";

  std::vector<Point> path;
  const double length = CGAL::approximate_geodesic_path(mesh, std::back_inserter(path), source,
                                                        target, within_5_percent);
  std::cout << "a path of " << path.size() << " points and length " << length << "\n";
}
