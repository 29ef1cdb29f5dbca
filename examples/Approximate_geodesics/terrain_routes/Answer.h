#ifndef TERRAIN_ROUTES_ANSWER_H
#define TERRAIN_ROUTES_ANSWER_H

#include "Costs.h"
#include "Isochrones.h"
#include "Options.h"
#include "Search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

// A path to a target.
struct Route
{
  Grid_cell target;
  double cost;
  double length = 0;
  std::vector<Grid_point> points; // in columns and rows
};

// What was found, and is written.
class Answer
{
public:
  Answer(const Costs& costs,
         const Options& options,
         const std::vector<Grid_cell>& sources,
         const std::vector<Grid_cell>& targets)
    : m_costs(costs), m_search(costs, options, sources, "from_sources")
  {
    if(options.writes_corridor)
      m_search_back.emplace(costs, options, targets, "to_targets");
    for(const Grid_cell& target : targets)
      m_routes.push_back(route_to(target));
    for(std::size_t row = 0; row < frame().rows; ++row)
      m_search.for_each_distance(row, [&](std::size_t, const double cost) {
        m_number_reached += cost < std::numeric_limits<double>::infinity();
        if(std::isfinite(cost))
          m_largest_cost = std::max(m_largest_cost, cost);
      });
    if(options.has_isochrones() || options.draws)
      find_isochrones(options);
  }

  const Raster_frame& frame() const { return m_costs.frame(); }
  const Costs& costs() const { return m_costs; }
  const Search& search() const { return m_search; }
  const std::vector<Route>& routes() const { return m_routes; }
  const Isochrones& isochrones() const { return *m_isochrones; }
  std::size_t number_reached() const { return m_number_reached; }
  double largest_cost() const { return m_largest_cost; }

  // Returns the costs of a row.
  const std::vector<double>& cost_row(const std::size_t row)
  {
    m_row.resize(frame().columns);
    m_search.for_each_distance(
        row, [&](const std::size_t column, const double cost) { m_row[column] = cost; });
    return m_row;
  }

  // Returns what the cheapest path costs that passes each cell of a row: there, and on from there.
  const std::vector<double>& corridor_row(const std::size_t row)
  {
    cost_row(row);
    m_search_back->for_each_distance(
        row, [&](const std::size_t column, const double cost) { m_row[column] += cost; });
    return m_row;
  }

  // Returns the directions to the nodes before each cell of a row.
  const std::vector<double>& back_link_row(const std::size_t row)
  {
    m_row.assign(frame().columns, std::numeric_limits<double>::infinity());
    m_search.for_each_predecessor(row, [&](const std::size_t column, const Grid_place& place) {
      const Grid_point p = m_search.position({column, row, 0}), q = m_search.position(place);
      const Grid_shape& shape = m_costs.shape();
      const double degrees =
          std::atan2((q.x - p.x) * shape.cell_width, (p.y - q.y) * shape.cell_height) * 180 /
          std::acos(-1.);
      m_row[column] = degrees < 0 ? degrees + 360 : degrees;
    });
    return m_row;
  }

  void remove_work_files()
  {
    m_search.remove_files();
    if(m_search_back)
      m_search_back->remove_files();
  }

private:
  Route route_to(const Grid_cell& target) const
  {
    Route result{target, m_search.distance(target), 0, {}};
    for(const Grid_place& place : m_search.path(target))
    {
      const Grid_point p = m_search.position(place);
      if(!result.points.empty())
        result.length += std::hypot((p.x - result.points.back().x) * m_costs.shape().cell_width,
                                    (p.y - result.points.back().y) * m_costs.shape().cell_height);
      result.points.push_back(p);
    }
    return result;
  }

  void find_isochrones(const Options& options)
  {
    constexpr std::size_t number_in_pictures = 15;
    std::vector<double> values = options.isochrones;
    if(values.empty())
    {
      const std::size_t number = options.number_of_isochrones.value_or(number_in_pictures);
      for(std::size_t i = 1; i <= number; ++i)
        values.push_back(m_largest_cost * static_cast<double>(i) / static_cast<double>(number + 1));
    }
    m_isochrones.emplace(values);
    for(std::size_t row = 0; row < frame().rows; ++row)
      m_isochrones->add_row(cost_row(row));
  }

  const Costs& m_costs;
  Search m_search;
  std::optional<Search> m_search_back;
  std::vector<Route> m_routes;
  std::optional<Isochrones> m_isochrones;
  std::size_t m_number_reached = 0;
  double m_largest_cost = 0;
  std::vector<double> m_row;
};

#endif // TERRAIN_ROUTES_ANSWER_H
