// Lengths that are given per edge, instead of coming from coordinates: travel times in a city. The
// city is a grid of streets with a diagonal across each block, and gets an expressway.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Travel_times = Mesh::Property_map<Edge, double>;

constexpr double MINUTES_PER_STREET = 1;
constexpr double MINUTES_PER_DIAGONAL = 1.4;
constexpr double MINUTES_ON_EXPRESSWAY = 0.1;
constexpr int NUMBER_OF_BLOCKS = 60;
constexpr int ROW_OF_EXPRESSWAY = 20;

bool is_on_expressway(const Point& p) { return p.y() == ROW_OF_EXPRESSWAY; }

// Nothing says that the sides of a triangle must fit together: beside the expressway they do not.
double minutes(const Point& p, const Point& q, const bool has_expressway)
{
  if(has_expressway && is_on_expressway(p) && is_on_expressway(q))
    return MINUTES_ON_EXPRESSWAY;
  return p.x() == q.x() || p.y() == q.y() ? MINUTES_PER_STREET : MINUTES_PER_DIAGONAL;
}

void travel(const Mesh& mesh, const Travel_times times)
{
  const Vertex home(0), office(NUMBER_OF_BLOCKS); // the ends of the lowest row
  std::vector<Point> route;
  const double length = CGAL::approximate_geodesic_path(
      mesh, std::back_inserter(route), home, office, CGAL::parameters::edge_length_map(times));
  std::cout << length << " minutes, past " << route.size() << " crossings, "
            << std::count_if(route.begin(), route.end(), is_on_expressway) << " of them in row "
            << ROW_OF_EXPRESSWAY << "\n";
}

int main()
{
  Mesh mesh;
  const bool triangulated = true;
  CGAL::make_grid(NUMBER_OF_BLOCKS, NUMBER_OF_BLOCKS, mesh, triangulated);
  const Travel_times times = mesh.add_property_map<Edge, double>("e:minutes").first;
  for(const bool has_expressway : {false, true})
  {
    for(const Edge e : mesh.edges())
      times[e] =
          minutes(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)), has_expressway);
    std::cout << (has_expressway ? "With the expressway:    " : "Without the expressway: ");
    travel(mesh, times);
  }
  return EXIT_SUCCESS;
}
