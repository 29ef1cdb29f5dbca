// Runs that end early, beyond a distance or at some targets, and how little they visit.

#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

// Vertices are settled in the order of their distances, each of them once.
struct Counter : CGAL::Approximate_geodesics::Geodesic_visitor_base
{
  std::size_t number_of_settled = 0;
  double radius = 0;

  void on_settled(const Vertex, const double distance)
  {
    ++number_of_settled;
    radius = distance;
  }
};

void print_figures(const std::string& title, const Counter& counter)
{
  std::cout << title << ": " << counter.number_of_settled << " vertices within a distance of "
            << counter.radius << "\n";
}

int main(int argc, char* argv[])
{
  namespace parameters = CGAL::parameters;

  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty() ||
     !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "No triangle mesh could be read from " << filename << "\n";
    return EXIT_FAILURE;
  }
  const Vertex source = *mesh.vertices().begin();
  const auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;

  // the visitor is given by reference, as a copy would keep the figures to itself
  Counter all;
  CGAL::approximate_geodesic_distances(mesh, distances, source, parameters::visitor(std::ref(all)));
  print_figures("No limit", all);

  Counter nearby;
  CGAL::approximate_geodesic_distances(
      mesh, distances, source,
      parameters::maximum_distance(all.radius / 10).visitor(std::ref(nearby)));
  print_figures("A tenth of the greatest distance", nearby);

  // what that run did not reach has an infinite distance now; take some of the others as targets
  std::vector<Vertex> targets;
  for(const Vertex v : mesh.vertices())
    if(v != source && std::isfinite(distances[v]) && targets.size() < 3)
      targets.push_back(v);
  Counter until_targets;
  CGAL::approximate_geodesic_distances(
      mesh, distances, source, parameters::targets(targets).visitor(std::ref(until_targets)));
  print_figures("Until " + std::to_string(targets.size()) + " targets are certain", until_targets);
  for(const Vertex target : targets)
    std::cout << "- target " << target << " is at a distance of " << distances[target] << "\n";
  return EXIT_SUCCESS;
}
