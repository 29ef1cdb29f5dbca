#ifndef TERRAIN_ROUTES_SURFACE_LENGTHS_H
#define TERRAIN_ROUTES_SURFACE_LENGTHS_H

#include "Costs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Lengths of straight lines between nodes, on the surface that the graph of heights has.

// Returns the vector between two nodes, in the unit of lengths.
inline Grid_point vector_between(const Costs& costs, const Grid_point& p, const Grid_point& q)
{
  // rows matter in degrees, where nodes are centers
  const auto& sides =
      costs.metric().between(static_cast<std::size_t>(p.y), static_cast<std::size_t>(q.y));
  return {(q.x - p.x) * sides.width, (q.y - p.y) * sides.height};
}

// The heights around a line between two centers.
class Height_profile
{
public:
  Height_profile(const Costs& costs, const Grid_point& p, const Grid_point& q)
    : m_first_x(std::floor(std::min(p.x, q.x))),
      m_window(window(costs, p, q)),
      m_heights(costs.heights(m_window))
  {
  }

  // Returns the height on a row or a column of centers, interpolated between two of them. If one
  // has no height, it is that of the other one, about.
  double operator()(const Grid_point& p) const
  {
    const double x = p.x - 0.5 - m_first_x, y = p.y - 0.5 - static_cast<double>(m_window.first_row);
    double sum = 0, weights = 0;
    for(std::size_t row = 0; row < m_window.rows; ++row)
      for(std::size_t column = 0; column < m_window.columns; ++column)
      {
        const double height = m_heights[row * m_window.columns + column];
        const double weight = std::max(0., 1 - std::abs(x - static_cast<double>(column))) *
                              std::max(0., 1 - std::abs(y - static_cast<double>(row)));
        if(weight > 0 && !std::isnan(height))
        {
          sum += weight * height;
          weights += weight;
        }
      }
    return sum / weights;
  }

private:
  static Grid_window window(const Costs& costs, const Grid_point& p, const Grid_point& q)
  {
    const auto first = [](const double a, const double b) {
      return static_cast<std::size_t>(std::min(a, b));
    };
    const auto columns = static_cast<double>(costs.shape().columns);
    const double first_x = std::min(p.x, q.x);
    const double in_grid = first_x - columns * std::floor(first_x / columns);
    const auto number = [](const double a, const double b) {
      return static_cast<std::size_t>(std::abs(a - b)) + 1;
    };
    return {first(in_grid, columns - 1), first(p.y, q.y), number(p.x, q.x), number(p.y, q.y)};
  }

  double m_first_x; // of the window; it may be beyond the raster, if this goes round
  Grid_window m_window;
  std::vector<double> m_heights;
};

// Returns where a line between centers crosses rows and columns of centers, relative to its length.
inline std::vector<double> cuts_of_line(const Grid_point& p, const Grid_point& q)
{
  std::vector<double> result{1};
  for(const double extent : {std::abs(q.x - p.x), std::abs(q.y - p.y)})
    for(double i = 1; i < extent; ++i)
      result.push_back(i / extent);
  std::sort(result.begin(), result.end());
  return result;
}

inline double length_between(const Costs& costs, const Grid_point& p, const Grid_point& q)
{
  const Grid_point vector = vector_between(costs, p, q);
  const double length = std::hypot(vector.x, vector.y);
  if(!costs.has_heights())
    return length;
  const Height_profile height(costs, p, q);
  double result = 0, last_cut = 0, last_height = height(p);
  for(const double cut : cuts_of_line(p, q))
  {
    const double next = height({p.x + cut * (q.x - p.x), p.y + cut * (q.y - p.y)});
    result += std::hypot((cut - last_cut) * length, next - last_height);
    last_cut = cut;
    last_height = next;
  }
  return result;
}

inline double height_at(const Costs& costs, const Grid_point& center)
{
  return Height_profile(costs, center, center)(center);
}

#endif // TERRAIN_ROUTES_SURFACE_LENGTHS_H
