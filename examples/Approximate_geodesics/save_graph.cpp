// A graph that is built once, by several threads if possible, and read from a file from then on.

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

namespace AG = CGAL::Approximate_geodesics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Shortest_paths = AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>;

void build_and_save(const Mesh& mesh, const std::string& graph_file)
{
  CGAL::Real_timer timer;
  timer.start();
  const AG::Discrete_geodesic_graph graph(
      AG::Intrinsic_triangulation(mesh),
      CGAL::parameters::epsilon(0.1).concurrency_tag(CGAL::Parallel_if_available_tag()));
  std::cout << "Built in " << timer.time() << " s: " << graph.number_of_arcs() << " arcs.\n";
  std::ofstream out(graph_file, std::ios::binary);
  graph.save(out); // throws if it cannot be written
}

AG::Discrete_geodesic_graph load(const Mesh& mesh, const std::string& graph_file)
{
  CGAL::Real_timer timer;
  timer.start();
  std::ifstream in(graph_file, std::ios::binary);
  AG::Discrete_geodesic_graph graph =
      AG::Discrete_geodesic_graph::load(in, AG::Intrinsic_triangulation(mesh));
  std::cout << "Read in " << timer.time() << " s.\n";
  return graph;
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
  const std::string graph_file = "save_graph.bin";
  build_and_save(mesh, graph_file);

  Shortest_paths shortest_paths(mesh, load(mesh, graph_file));
  const Vertex first = *mesh.vertices().begin();
  const Vertex last(mesh.number_of_vertices() - 1);
  shortest_paths.add_source_point(first);
  std::cout << "From " << first << " to " << last << " it is "
            << shortest_paths.shortest_distance_to_source_points(last).first << ".\n";

  // the file belongs to this mesh and to no other
  mesh.point(last) = Kernel::Point_3(0, 0, 0);
  try
  {
    load(mesh, graph_file);
    return EXIT_FAILURE;
  }
  catch(const std::invalid_argument& e)
  {
    std::cout << "After a vertex has moved: " << e.what() << ".\n";
    return EXIT_SUCCESS;
  }
}
