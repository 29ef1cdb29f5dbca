// The surface divided among several sources: every vertex belongs to the nearest one.

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

// `number` vertices, evenly spaced in the mesh's numbering (which says little of the surface)
std::vector<Vertex> choose_sources(const Mesh& mesh, const std::size_t number)
{
  const std::vector<Vertex> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<Vertex> result;
  for(std::size_t i = 0; i < number; ++i)
    result.push_back(vertices[i * vertices.size() / number]);
  return result;
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

  const std::vector<Vertex> sources =
      choose_sources(mesh, (std::min<std::size_t>)(12, mesh.number_of_vertices()));
  const auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;
  const auto cells = mesh.add_property_map<Vertex, int>("v:cell").first;
  CGAL::approximate_geodesic_distances(mesh, distances, sources,
                                       CGAL::parameters::nearest_source_map(cells));

  // the cell of a vertex is the position of its source among the sources, or -1 if there is none
  std::vector<std::size_t> sizes(sources.size(), 0);
  const auto colors = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(const Vertex v : mesh.vertices())
    if(cells[v] >= 0)
    {
      ++sizes[static_cast<std::size_t>(cells[v])];
      colors[v].set_hsv(360. * cells[v] / static_cast<double>(sources.size()), 70, 95);
    }

  for(std::size_t i = 0; i < sources.size(); ++i)
    std::cout << "Cell " << i << ", around vertex " << sources[i] << ", has " << sizes[i]
              << " vertices.\n";

  const std::string output = "voronoi_partition.ply";
  if(!CGAL::IO::write_PLY(output, mesh))
  {
    std::cerr << "Cannot write " << output << "\n";
    return EXIT_FAILURE;
  }
  std::cout << "The mesh with one color per cell is in " << output << ".\n";
  return EXIT_SUCCESS;
}
