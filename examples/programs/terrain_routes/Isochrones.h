#ifndef TERRAIN_ROUTES_ISOCHRONES_H
#define TERRAIN_ROUTES_ISOCHRONES_H

#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/internal/Grid_isoline.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

using CGAL::Approximate_geodesics::Grid_point;

// Lines of equal values of a raster, in columns and rows: those of `isolines_on_grid()`, for a
// raster that need not fit in memory.
class Isochrones
{
public:
  using Line = std::vector<Grid_point>;

  // `row(i)` returns the values of a row.
  template <typename Row>
  Isochrones(std::vector<double> values,
             const CGAL::Approximate_geodesics::Grid_shape& raster,
             const Row& row)
    : m_values(std::move(values)), m_lines(m_values.size())
  {
    CGAL::Approximate_geodesics::Grid_shape shape{raster.columns, raster.rows, 1, 1, {}};
    shape.is_periodic = raster.is_periodic;
    std::vector<CGAL::Approximate_geodesics::internal::Grid_isoline> isolines;
    for(const double value : m_values)
      isolines.emplace_back(shape, value);
    std::vector<double> last_row = row(0);
    for(std::size_t i = 1; i < raster.rows; ++i)
    {
      const std::vector<double>& next_row = row(i);
      for(auto& isoline : isolines)
        isoline.add_squares(i - 1, last_row, next_row);
      last_row = next_row;
    }
    for(std::size_t i = 0; i < isolines.size(); ++i)
      isolines[i].write(std::back_inserter(m_lines[i]));
  }

  const std::vector<double>& values() const { return m_values; }

  // Returns the lines of the value with this index.
  const std::vector<Line>& lines(const std::size_t index) const { return m_lines[index]; }

private:
  std::vector<double> m_values;
  std::vector<std::vector<Line>> m_lines; // by values
};

#endif // TERRAIN_ROUTES_ISOCHRONES_H
