// Curves at constant distance from a curve, such as tool paths, written as a polyline file.

#include <CGAL/Geodesic_constructions/offset_curves.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Offset_curve = AG::Offset_curve<Kernel::Point_3>;

double length(const Offset_curve& curve)
{
  double result = 0;
  const std::size_t n = curve.points.size(), first = curve.is_closed ? 0 : 1;
  for(std::size_t i = first; i < n; ++i)
    result += std::sqrt(CGAL::squared_distance(curve.points[(i + n - 1) % n], curve.points[i]));
  return result;
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

  // from the first vertex to the one in the middle of the numbering
  const Mesh::Vertex_index first = *mesh.vertices_begin(),
                           second(static_cast<unsigned>(mesh.number_of_vertices() / 2));
  const AG::Source_curve<Mesh> source{{first, second}};
  const double size = std::sqrt(CGAL::squared_distance(mesh.point(first), mesh.point(second)));
  std::vector<double> distances;
  for(int i = 1; i <= 50; ++i)
    distances.push_back(i * size / 50);

  std::vector<Offset_curve> curves;
  AG::offset_curves(mesh, source, distances, std::back_inserter(curves));

  std::ofstream file("offsets_of_curve.polylines.txt");
  file.precision(17);
  double sum = 0;
  for(const Offset_curve& curve : curves)
  {
    sum += length(curve);
    file << curve.points.size() + (curve.is_closed ? 1 : 0);
    for(const Kernel::Point_3& p : curve.points)
      file << ' ' << p;
    if(curve.is_closed)
      file << ' ' << curve.points.front();
    file << '\n';
  }
  std::cout << curves.size() << " curves of length " << sum
            << " are in offsets_of_curve.polylines.txt\n";
  return file ? EXIT_SUCCESS : EXIT_FAILURE;
}
