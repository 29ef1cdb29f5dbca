// Paths between points of the surface that are not vertices: found along edges and across faces,
// and made locally shortest.

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/aabb_traits.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
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

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Along_edges = AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph>;
using Across_faces = AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>;
using AABB_traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;

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
  Along_edges along_edges(mesh);
  Across_faces across_faces(mesh, CGAL::parameters::epsilon(0.1));

  // The points of the surface that are nearest to two points in space.
  CGAL::AABB_tree<AABB_traits> tree;
  across_faces.build_aabb_tree(tree);
  const auto box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const Kernel::Point_3 below(box.xmin(), box.ymin(), box.zmin());
  const Kernel::Point_3 above(box.xmax(), box.ymax(), box.zmax());
  const Across_faces::Face_location source = across_faces.locate(below, tree);
  const Across_faces::Face_location target = across_faces.locate(above, tree);

  const auto straighten = CGAL::parameters::straighten(true);
  std::vector<Kernel::Point_3> points;
  std::cout << "along edges:                 " << along_edges.shortest_distance(source, target)
            << "\nalong edges, straightened:   "
            << along_edges.shortest_distance(source, target, straighten)
            << "\nwithin 10 %:                 " << across_faces.shortest_distance(source, target)
            << "\nwithin 10 %, straightened:   "
            << across_faces.shortest_path_points(source, target, std::back_inserter(points),
                                                 straighten)
            << "\n";
  if(points.empty())
  {
    std::cerr << "The points are not connected.\n";
    return EXIT_FAILURE;
  }

  // a line of text: the number of the points, and their coordinates
  std::ofstream out("path_between_points.polylines.txt");
  out.precision(17);
  out << points.size();
  for(const Kernel::Point_3& p : points)
    out << "  " << p;
  out << "\n";
  out.close();
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
