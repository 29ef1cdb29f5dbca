// Distances that do not cross sharp edges, which CGAL detects, and what they are without barriers.

#include <CGAL/Geodesic_costs.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Distance_map = Mesh::Property_map<Vertex, double>;

void print_figures(const std::string& title, const Mesh& mesh, const Distance_map distances)
{
  double largest = 0;
  std::size_t number_reached = 0;
  for(const Vertex v : mesh.vertices())
    if(std::isfinite(distances[v])) // infinity stands for vertices that no path leads to
    {
      largest = (std::max)(largest, distances[v]);
      ++number_reached;
    }
  std::cout << title << ": " << number_reached
            << " vertices reached, the farthest at a distance of " << largest << "\n";
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty() ||
     !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "No triangle mesh could be read from " << filename << "\n";
    return EXIT_FAILURE;
  }
  const auto is_sharp = mesh.add_property_map<Edge, bool>("e:is_sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 60, is_sharp); // degrees
  std::cout << std::count(is_sharp.begin(), is_sharp.end(), true) << " sharp edges\n";

  const Vertex source = *mesh.vertices().begin();
  const auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;
  CGAL::approximate_geodesic_distances(mesh, distances, source, CGAL::parameters::epsilon(0.1));
  print_figures("Without barriers", mesh, distances);
  CGAL::approximate_geodesic_distances(
      mesh, distances, source, CGAL::parameters::epsilon(0.1).edge_is_constrained_map(is_sharp));
  print_figures("With barriers", mesh, distances);
  return EXIT_SUCCESS;
}
