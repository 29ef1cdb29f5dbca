// What becomes of the rows of a distance matrix is up to the program: here, two numbers of each are
// kept, so that a matrix of any size takes no memory.

#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A sink: several threads bring rows at the same time, in any order, each with a block of its own.
// How far is it from each vertex to the one that is farthest away?
struct Eccentricities
{
  struct Block // what is collected by a thread, for `add()`: nothing here
  {
  };

  void start(const AG::Distance_matrix_plan& plan) { values.resize(plan.number_of_rows()); }
  void collect(Block&, const std::size_t row, const AG::Distance_row& distances)
  {
    values[row] = *std::max_element(distances.begin(), distances.end());
  }
  void add(std::size_t /* number */, Block&) {}
  bool finish(const bool is_done) { return is_done; }

  std::vector<double> values;
};

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
  const auto np = CGAL::parameters::epsilon(0.1).concurrency_tag(CGAL::Parallel_if_available_tag());

  Eccentricities eccentricities;
  CGAL::approximate_geodesic_distance_matrix(mesh, eccentricities, mesh.vertices(), np);
  const auto [center, farthest] =
      std::minmax_element(eccentricities.values.begin(), eccentricities.values.end());
  std::cout << "The center is vertex " << center - eccentricities.values.begin()
            << ", from which no other is farther away than " << *center
            << ".\nThe greatest distance of all is " << *farthest << ".\n";

  // a function object is simpler still: it gets one row after the other, in their order
  double sum = 0;
  CGAL::approximate_geodesic_distance_matrix(
      mesh,
      [&](std::size_t /* row */, const AG::Distance_row& distances) {
        sum = std::accumulate(distances.begin(), distances.end(), sum);
      },
      mesh.vertices(), np);
  const double n = double(mesh.number_of_vertices());
  std::cout << "The mean distance between two vertices is " << sum / (n * (n - 1)) << ".\n";
  return EXIT_SUCCESS;
}
