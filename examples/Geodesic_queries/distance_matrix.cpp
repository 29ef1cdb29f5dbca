// Distances between points that are spread evenly, in memory, and the two that are farthest apart.

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

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
  std::vector<Mesh::Vertex_index> points;
  AG::farthest_point_sampling(mesh, std::back_inserter(points), 100);

  // paths across faces, at most 10 % longer than possible; all cores, if there is TBB
  AG::Dense_rows<float> distances;
  CGAL::approximate_geodesic_distance_matrix(
      mesh, distances, points,
      CGAL::parameters::targets(points).epsilon(0.1).symmetric(true).concurrency_tag(
          CGAL::Parallel_if_available_tag()));

  std::size_t a = 0, b = 0;
  for(std::size_t i = 0; i < distances.number_of_rows(); ++i)
    for(std::size_t j = 0; j < distances.number_of_columns(); ++j)
      if(distances(i, j) > distances(a, b))
      {
        a = i;
        b = j;
      }
  std::cout << "Of " << points.size() << " points, " << points[a] << " and " << points[b]
            << " are farthest apart: " << distances(a, b) << ".\n";
  return EXIT_SUCCESS;
}
