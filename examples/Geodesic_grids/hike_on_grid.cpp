// A hiker on a raster of heights: times to all cells, a route over the hills, and lines of equal
// time.

#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_grids.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

int main()
{
  const AG::Grid_shape shape{
      200, 150, 30, 30, {}}; // columns, rows, and the size of a cell in meters
  std::vector<double> heights;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
  {
    const AG::Grid_point p = shape.center(shape.cell(i));
    heights.push_back(400 + 250 * std::sin(p.x / 700) * std::cos(p.y / 500));
  }
  const auto hiking =
      CGAL::parameters::heights(heights).face_weight_map(AG::directional_cost(AG::Hiking_time()));

  const AG::Grid_cell hut{20, 20}, summit{180, 120};
  std::vector<double> seconds;
  CGAL::approximate_geodesic_distances_on_grid(shape, 1, std::back_inserter(seconds), hut, hiking);
  std::cout << "to the summit: " << seconds[shape.index(summit)] / 60 << " minutes\n";

  std::vector<AG::Grid_point> route;
  const double there = CGAL::approximate_geodesic_path_on_grid(shape, 1, std::back_inserter(route),
                                                               hut, summit, hiking);
  const double back = CGAL::approximate_geodesic_path_on_grid(shape, 1, std::back_inserter(route),
                                                              summit, hut, hiking);
  std::cout << "there: " << there / 60 << " minutes, and back: " << back / 60 << "\n";

  std::vector<std::vector<AG::Grid_point>> lines;
  for(const double minutes : {30., 60., 90.})
    AG::isolines_on_grid(shape, seconds, 60 * minutes, std::back_inserter(lines));
  std::cout << lines.size() << " lines of equal time\n";
}
