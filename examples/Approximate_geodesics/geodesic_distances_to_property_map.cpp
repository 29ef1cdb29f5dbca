// Distances from one vertex to all the others, in a property map of the mesh.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

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
  const auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;
  CGAL::approximate_geodesic_distances(mesh, distances, source);

  // a vertex in another connected component than the source is infinitely far away
  std::size_t number_of_reached = 0;
  Vertex farthest = source;
  for(const Vertex v : mesh.vertices())
    if(std::isfinite(distances[v]))
    {
      ++number_of_reached;
      if(distances[v] > distances[farthest])
        farthest = v;
    }

  std::cout << "From vertex " << source << ", " << number_of_reached << " of "
            << mesh.number_of_vertices() << " vertices can be reached.\n"
            << "The farthest is vertex " << farthest << " at (" << mesh.point(farthest)
            << "), at a distance of " << distances[farthest] << ".\n";
  return EXIT_SUCCESS;
}
