// What to do with distances: isolines, the gradient, a partition, and points that are spread
// evenly. draw_field.py draws the results.

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Distance_map = Mesh::Property_map<Vertex, double>;
using Cell_map = Mesh::Property_map<Face, int>;
using Gradient_map = Mesh::Property_map<Face, Vector>;
using Polyline = std::vector<Point>;

constexpr std::size_t NUMBER_OF_ISOLINES = 24, NUMBER_OF_CELLS = 20, NUMBER_OF_SAMPLES = 500;

// A line of text per polyline: the number of its points, and their coordinates.
void write_polylines(const std::string& name, const std::vector<Polyline>& polylines)
{
  std::ofstream out("distance_field_" + name + ".polylines.txt");
  out.precision(17);
  for(const Polyline& polyline : polylines)
  {
    out << polyline.size();
    for(const Point& p : polyline)
      out << "  " << p;
    out << "\n";
  }
  if(!out.flush())
    throw std::runtime_error("cannot write the polylines " + name);
}

// At equal distances between the source and the farthest vertex.
std::vector<double> isovalues(const Mesh& mesh, const Distance_map distance)
{
  double farthest = 0;
  for(const Vertex v : mesh.vertices())
    if(std::isfinite(distance[v]))
      farthest = (std::max)(farthest, distance[v]);
  std::vector<double> result;
  for(std::size_t i = 1; i < NUMBER_OF_ISOLINES; ++i)
    result.push_back(farthest * double(i) / double(NUMBER_OF_ISOLINES));
  return result;
}

// The way back to the source: unit vectors, as segments from the given vertices.
std::vector<Polyline>
directions(const Mesh& mesh, const Gradient_map gradient, const std::vector<Vertex>& vertices)
{
  std::vector<Polyline> result;
  for(const Vertex v : vertices)
  {
    Vector sum = CGAL::NULL_VECTOR;
    if(!mesh.is_isolated(v))
      for(const Face f : mesh.faces_around_target(mesh.halfedge(v)))
        if(f != Mesh::null_face())
          sum -= gradient[f];
    if(sum != CGAL::NULL_VECTOR)
      result.push_back({mesh.point(v), mesh.point(v) + sum / std::sqrt(sum.squared_length())});
  }
  return result;
}

void write_points(const Mesh& mesh, const std::vector<Vertex>& vertices)
{
  std::ofstream out("distance_field_samples.xyz");
  out.precision(17);
  for(const Vertex v : vertices)
    out << mesh.point(v) << "\n";
  if(!out.flush())
    throw std::runtime_error("cannot write distance_field_samples.xyz");
}

// The mesh with the distances, `-1` where there is none, the cells and the gradients.
void write_mesh(const Mesh& mesh,
                const Distance_map distance,
                const Cell_map cell,
                const Gradient_map gradient)
{
  std::ofstream out("distance_field.vtk");
  out.precision(9);
  out << "# vtk DataFile Version 3.0\ndistance field\nASCII\nDATASET POLYDATA\nPOINTS "
      << mesh.number_of_vertices() << " double\n";
  for(const Vertex v : mesh.vertices())
    out << mesh.point(v) << "\n";
  out << "POLYGONS " << mesh.number_of_faces() << " " << 4 * mesh.number_of_faces() << "\n";
  for(const Face f : mesh.faces())
  {
    out << 3;
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << " " << v.idx();
    out << "\n";
  }
  out << "POINT_DATA " << mesh.number_of_vertices()
      << "\nSCALARS distance double 1\nLOOKUP_TABLE default\n";
  for(const Vertex v : mesh.vertices())
    out << (std::isfinite(distance[v]) ? distance[v] : -1) << "\n";
  out << "CELL_DATA " << mesh.number_of_faces() << "\nSCALARS cell int 1\nLOOKUP_TABLE default\n";
  for(const Face f : mesh.faces())
    out << cell[f] << "\n";
  out << "VECTORS gradient double\n";
  for(const Face f : mesh.faces())
    out << gradient[f] << "\n";
  if(!out.flush())
    throw std::runtime_error("cannot write distance_field.vtk");
}

void process(Mesh& mesh)
{
  const auto np = CGAL::parameters::epsilon(0.1);

  // points that are spread evenly; the first ones of them are, too, with larger distances
  std::vector<Vertex> samples;
  const double radius =
      AG::farthest_point_sampling(mesh, std::back_inserter(samples), NUMBER_OF_SAMPLES, np);
  const std::vector<Vertex> sources(
      samples.begin(),
      samples.begin() + std::ptrdiff_t((std::min)(NUMBER_OF_CELLS, samples.size())));

  // the surface divided among these
  const Cell_map cell = mesh.add_property_map<Face, int>("f:cell").first;
  AG::voronoi_partition(mesh, cell, sources, np);

  // distances from one of them
  const Distance_map distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  CGAL::approximate_geodesic_distances(mesh, distance, sources.back(), np);
  std::vector<Polyline> isolines;
  AG::isolines(mesh, distance, isovalues(mesh, distance), std::back_inserter(isolines));
  const Gradient_map gradient = mesh.add_property_map<Face, Vector>("f:gradient").first;
  AG::gradient(mesh, distance, gradient);

  std::cout << "No vertex is farther than " << radius << " from the nearest of " << samples.size()
            << " points.\nThere are " << sources.size() << " cells and " << isolines.size()
            << " isolines.\n";
  write_mesh(mesh, distance, cell, gradient);
  write_polylines("isolines", isolines);
  write_polylines("directions", directions(mesh, gradient, samples));
  write_points(mesh, samples);
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
  try
  {
    process(mesh);
    return EXIT_SUCCESS;
  }
  catch(const std::runtime_error& e)
  {
    std::cerr << "Error: " << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
