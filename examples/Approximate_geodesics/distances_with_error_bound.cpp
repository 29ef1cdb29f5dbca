// Distances and a path that are at most 5 % longer than the shortest ones on the surface.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

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
  const Vertex source = *mesh.vertices().begin();
  const auto bound = CGAL::parameters::epsilon(0.05);

  auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;
  CGAL::approximate_geodesic_distances(mesh, distances, source, bound);
  Vertex farthest = source;
  for(const Vertex v : mesh.vertices())
    if(distances[v] > distances[farthest])
      farthest = v;
  std::cout << "The farthest vertex from " << source << " is " << farthest << ", at a distance of "
            << distances[farthest] << ".\n";

  // a path across faces has a point wherever it crosses an edge
  std::vector<Kernel::Point_3> along_edges, across_faces;
  const double longer =
      CGAL::approximate_geodesic_path(mesh, std::back_inserter(along_edges), source, farthest);
  const double shorter = CGAL::approximate_geodesic_path(mesh, std::back_inserter(across_faces),
                                                         source, farthest, bound);
  std::cout << "Along edges, a path has length " << longer << " and " << along_edges.size()
            << " points; across faces, it has length " << shorter << " and " << across_faces.size()
            << " points.\n";
  return EXIT_SUCCESS;
}
