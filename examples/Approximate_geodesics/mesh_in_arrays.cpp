// A mesh that is two arrays, which are not copied: a terrain of a million points, or as many as the
// argument says, in single precision.

#include <CGAL/Approximate_geodesics/Mesh/Triangle_soup_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

using Points = std::vector<std::array<float, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

void make_terrain(const std::uint32_t side, Points& points, Triangles& triangles)
{
  for(std::uint32_t y = 0; y < side; ++y)
    for(std::uint32_t x = 0; x < side; ++x)
      points.push_back({float(x), float(y), 5 * std::sin(float(x) / 9) * std::cos(float(y) / 7)});
  for(std::uint32_t y = 0; y + 1 < side; ++y)
    for(std::uint32_t x = 0; x + 1 < side; ++x)
    {
      const std::uint32_t a = y * side + x, b = a + side;
      triangles.push_back({a, a + 1, b + 1});
      triangles.push_back({a, b + 1, b});
    }
}

int main(int argc, char* argv[])
{
  const double number_of_points = argc > 1 ? std::strtod(argv[1], nullptr) : 1e6;
  if(!(number_of_points >= 1 && number_of_points <= 3e8))
  {
    std::cerr << "The number of points must be from 1 to 300000000, not " << argv[1] << ".\n";
    return EXIT_FAILURE;
  }
  Points points;
  Triangles triangles;
  make_terrain(static_cast<std::uint32_t>(std::sqrt(number_of_points)), points, triangles);

  const CGAL::Approximate_geodesics::Triangle_soup_mesh mesh(points, triangles);
  std::vector<double> distances(points.size());
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  const auto corner = mesh.vertex(0);
  CGAL::approximate_geodesic_distances(mesh, map, corner);
  std::cout << "Along edges, the opposite corner is at distance " << distances.back() << ".\n";
  CGAL::approximate_geodesic_distances(mesh, map, corner, CGAL::parameters::epsilon(0.1));
  std::cout << "Across faces, it is at distance " << distances.back() << ".\n";
  return EXIT_SUCCESS;
}
