// Many sources, one after the other, on a mesh that is prepared once: along edges, across faces,
// and the same code with CGAL's exact class, for which another type is all that it takes.

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace AG = CGAL::Approximate_geodesics;
using Along_edges = AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph>;
using Across_faces = AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>;
using Exact =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

// The distances from each of the sources to all vertices, and the time that they took.
template <typename Shortest_paths>
std::vector<double>
run(const std::string& title, const Mesh& mesh, const std::vector<Vertex>& sources)
{
  CGAL::Real_timer timer;
  timer.start();
  Shortest_paths shortest_paths(mesh);
  std::vector<double> result;
  for(const Vertex source : sources)
  {
    shortest_paths.remove_all_source_points();
    shortest_paths.add_source_point(source);
    for(const Vertex v : mesh.vertices())
      result.push_back(shortest_paths.shortest_distance_to_source_points(v).first);
  }
  std::cout << title << ": " << timer.time() << " s for " << sources.size() << " sources\n";
  return result;
}

void print_errors(const std::string& title,
                  const std::vector<double>& distances,
                  const std::vector<double>& exact)
{
  double sum = 0, largest = 0;
  std::size_t number = 0;
  for(std::size_t i = 0; i < exact.size(); ++i)
    if(exact[i] > 0) // that of a vertex that cannot be reached is -1, in all classes
    {
      const double error = distances[i] / exact[i] - 1;
      sum += error;
      largest = (std::max)(largest, error);
      ++number;
    }
  std::cout << title << " are longer by " << 100 * sum / static_cast<double>(number)
            << " % on average, and by " << 100 * largest << " % at most.\n";
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

  std::vector<Vertex> sources;
  for(const Vertex v : mesh.vertices())
    if(v.idx() % (mesh.number_of_vertices() / 5 + 1) == 0)
      sources.push_back(v);
  const std::vector<double> along_edges = run<Along_edges>("Along edges ", mesh, sources);
  const std::vector<double> across_faces = run<Across_faces>("Across faces", mesh, sources);
  const std::vector<double> exact = run<Exact>("Exact       ", mesh, sources);
  print_errors("Paths along edges", along_edges, exact);
  print_errors("Paths across faces", across_faces, exact);
  return EXIT_SUCCESS;
}
