// A visitor that prints how far a run has come, and ends it before it is complete.

#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

// The functions that are not needed are inherited. In an application, `go_further()` would look at
// a button or at a clock.
class Progress_printer : public CGAL::Approximate_geodesics::Geodesic_visitor_base
{
public:
  explicit Progress_printer(const std::size_t last_percentage) : m_last_percentage(last_percentage)
  {
  }

  void on_progress(const std::size_t number_of_settled_nodes, const std::size_t number_of_nodes)
  {
    m_percentage = 100 * number_of_settled_nodes / number_of_nodes;
    if(m_percentage < m_next_to_print)
      return;
    std::cout << m_percentage << " %" << std::endl;
    m_next_to_print = m_percentage + 10;
  }

  bool go_further() { return m_percentage < m_last_percentage; }

private:
  std::size_t m_last_percentage;
  std::size_t m_percentage = 0;
  std::size_t m_next_to_print = 10;
};

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
  const Vertex source = *mesh.vertices().begin();
  const auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;

  Progress_printer progress_printer(60);
  CGAL::approximate_geodesic_distances(mesh, distances, source,
                                       CGAL::parameters::visitor(std::ref(progress_printer)));

  // what is not certain when the run ends is infinite, never half right
  const auto number_of_certain =
      std::count_if(mesh.vertices().begin(), mesh.vertices().end(),
                    [&](const Vertex v) { return std::isfinite(distances[v]); });
  std::cout << "The run ended with " << number_of_certain << " of " << mesh.number_of_vertices()
            << " distances; the others are infinite.\n";
  return EXIT_SUCCESS;
}
