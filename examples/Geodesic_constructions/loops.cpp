// Loops around the handles of a surface: a shortest one through each of a few vertices, and the
// closed geodesics that they become when they are free to move.

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/shorten_loop.h>
#include <CGAL/Geodesic_constructions/trace_geodesic.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Loop = AG::Geodesic_loop<Mesh>;

// Writes a loop as a polyline.
void write(std::ostream& out, const AG::Geodesic_tracer<Mesh>& tracer, const Loop& loop)
{
  out << loop.points.size();
  for(const AG::Surface_point<Mesh>& p : loop.points)
    out << "  " << tracer.point_3(p);
  out << "\n";
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty() ||
     !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "No triangle mesh could be read from " << filename << "\n";
    return EXIT_FAILURE;
  }
  std::vector<Vertex> bases;
  AG::farthest_point_sampling(mesh, std::back_inserter(bases), 12);

  const AG::Geodesic_tracer<Mesh> tracer(mesh); // for positions of points
  std::ofstream fixed("loops_fixed.polylines.txt"), free("loops_free.polylines.txt");
  fixed.precision(17);
  free.precision(17);
  for(const Vertex v : bases)
  {
    const Loop loop = AG::shortest_loop_through(mesh, v);
    if(loop.points.empty())
    {
      std::cout << "All loops through " << v << " contract.\n";
      continue;
    }
    const Loop geodesic = AG::shorten_loop(mesh, loop.points);
    std::cout << "A shortest loop through " << v << " has a length of " << loop.length << ", and "
              << geodesic.length << " after it was shortened.\n";
    write(fixed, tracer, loop);
    write(free, tracer, geodesic);
  }
  if(!fixed || !free)
  {
    std::cerr << "Cannot write loops_fixed.polylines.txt or loops_free.polylines.txt\n";
    return EXIT_FAILURE;
  }
  std::cout << "They are in loops_fixed.polylines.txt and loops_free.polylines.txt.\n";
  return EXIT_SUCCESS;
}
