#ifndef TERRAIN_ROUTES_ISOCHRONES_H
#define TERRAIN_ROUTES_ISOCHRONES_H

#include <CGAL/Approximate_geodesics/Graphs/Grid_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

using CGAL::Approximate_geodesics::Grid_point;

// Lines of equal values of a raster, by marching squares between the centers of cells. Values come
// row by row. Lines end beside cells without a value. They are in columns and rows.
class Isochrones
{
public:
  using Line = std::vector<Grid_point>;

  explicit Isochrones(std::vector<double> values)
    : m_values(std::move(values)), m_contours(m_values.size())
  {
  }

  const std::vector<double>& values() const { return m_values; }

  void add_row(const std::vector<double>& row)
  {
    if(m_number_of_rows++ > 0)
      for(std::size_t column = 0; column + 1 < row.size(); ++column)
        add_square(column, {m_row[column], m_row[column + 1], row[column + 1], row[column]});
    m_row = row;
  }

  // Returns the lines of the value with this index.
  std::vector<Line> lines(const std::size_t index) const
  {
    std::vector<Line> result;
    Contour contour = m_contours[index];
    std::vector<std::uint64_t> edges;
    for(const auto& [edge, crossing] : contour)
      edges.push_back(edge);
    std::sort(edges.begin(), edges.end());
    for(const bool is_open : {true, false}) // closed ones may begin anywhere
      for(const std::uint64_t edge : edges)
        if(const auto crossing = contour.find(edge);
           crossing != contour.end() && (!is_open || crossing->second.number_of_neighbors == 1))
          result.push_back(take_line(contour, edge));
    return result;
  }

private:
  // Where a line crosses the edge between two centers, and the edges that it goes on to.
  struct Crossing
  {
    Grid_point point;
    std::array<std::uint64_t, 2> neighbors = {};
    int number_of_neighbors = 0;
  };

  using Contour = std::unordered_map<std::uint64_t, Crossing>;
  using Corners = std::array<double, 4>; // of a square between centers, in a circle

  void add_square(const std::size_t column, const Corners& corners)
  {
    for(const double value : corners)
      if(!std::isfinite(value))
        return;
    for(std::size_t i = 0; i < m_values.size(); ++i)
      add_square(m_contours[i], m_values[i], column, corners);
  }

  void add_square(Contour& contour,
                  const double value,
                  const std::size_t column,
                  const Corners& corners) const
  {
    std::array<int, 4> crossed = {};
    std::size_t number = 0;
    for(std::size_t side = 0; side < 4; ++side)
      if((corners[side] < value) != (corners[(side + 1) % 4] < value))
        crossed[number++] = static_cast<int>(side);
    if(number == 2)
      add_segment(contour, value, column, corners, crossed[0], crossed[1]);
    if(number < 4)
      return;
    // a saddle: lines go round the corners that differ from the middle
    const double middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
    const int first = (middle < value) == (corners[0] < value) ? 0 : 3;
    add_segment(contour, value, column, corners, first, (first + 1) % 4);
    add_segment(contour, value, column, corners, (first + 2) % 4, (first + 3) % 4);
  }

  void add_segment(Contour& contour,
                   const double value,
                   const std::size_t column,
                   const Corners& corners,
                   const int side,
                   const int other_side) const
  {
    const std::uint64_t a = edge(column, side), b = edge(column, other_side);
    for(const auto& [from, to, of] : {std::make_tuple(a, b, side), {b, a, other_side}})
    {
      Crossing& crossing = contour[from];
      crossing.point = point(value, column, corners, of);
      crossing.neighbors[static_cast<std::size_t>(crossing.number_of_neighbors++)] = to;
    }
  }

  // A number for the edge of a square: two for each center, that to the right and that downward.
  std::uint64_t edge(const std::size_t column, const int side) const
  {
    const std::uint64_t row = m_number_of_rows - (side == 2 ? 1 : 2);
    constexpr int bits_of_columns = 32;
    return ((row << bits_of_columns) + column + (side == 1 ? 1 : 0)) << 1 |
           static_cast<std::uint64_t>(side % 2);
  }

  Grid_point
  point(const double value, const std::size_t column, const Corners& corners, const int side) const
  {
    static constexpr std::array<std::array<double, 2>, 4> places{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    const auto first = static_cast<std::size_t>(side);
    const std::size_t last = (first + 1) % 4;
    const double t = (value - corners[first]) / (corners[last] - corners[first]);
    const auto between = [&](const std::size_t axis) {
      return places[first][axis] + t * (places[last][axis] - places[first][axis]);
    };
    return {static_cast<double>(column) + 0.5 + between(0),
            static_cast<double>(m_number_of_rows) - 1.5 + between(1)};
  }

  static Line take_line(Contour& contour, const std::uint64_t first)
  {
    Line result;
    for(std::uint64_t edge = first; true;)
    {
      const Crossing crossing = contour.at(edge);
      result.push_back(crossing.point);
      contour.erase(edge);
      const auto* next = crossing.neighbors.begin();
      const auto* const beyond = next + crossing.number_of_neighbors;
      while(next != beyond && contour.count(*next) == 0)
        ++next;
      if(next != beyond)
      {
        edge = *next;
        continue;
      }
      if(result.size() > 2 && crossing.number_of_neighbors == 2)
        result.push_back(result.front()); // it is closed
      return result;
    }
  }

  std::vector<double> m_values;
  std::vector<Contour> m_contours;
  std::vector<double> m_row; // the last one
  std::size_t m_number_of_rows = 0;
};

#endif // TERRAIN_ROUTES_ISOCHRONES_H
