// The exact Voronoi diagram of points on a surface: its borders as polylines, and its dual
// triangles.

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/voronoi_borders.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace PMP = CGAL::Polygon_mesh_processing;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;

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

  std::vector<Vertex> sources;
  AG::farthest_point_sampling(mesh, std::back_inserter(sources), 60);
  const auto cells = AG::voronoi_borders(mesh, sources);

  std::ofstream lines("exact_cells.polylines.txt");
  for(const auto& border : cells.borders)
  {
    lines << border.points.size();
    for(const auto& point : border.points)
      lines << "  " << PMP::construct_point(point, mesh);
    lines << "\n";
  }
  std::cout << cells.borders.size() << " borders, which meet at " << cells.corners.size()
            << " corners, are in exact_cells.polylines.txt.\n"
            << "The areas of the cells add up to "
            << std::accumulate(cells.areas.begin(), cells.areas.end(), 0.) << ".\n"
            << "The dual triangulation has " << cells.triangles().size() << " triangles.\n";
}
