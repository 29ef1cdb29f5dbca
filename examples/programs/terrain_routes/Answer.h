#ifndef TERRAIN_ROUTES_ANSWER_H
#define TERRAIN_ROUTES_ANSWER_H

#include "Costs.h"
#include "Isochrones.h"
#include "Options.h"
#include "Search.h"
#include "surface_lengths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// A path to a target, or from there to a source.
struct Route
{
  double length() const { return lengths.back(); }

  Grid_cell target;
  double cost;
  std::vector<Grid_point> points; // in columns and rows; on rasters that go round, also beyond
  std::vector<double> lengths;    // from the first point to each
  std::vector<double> heights;    // of points, if there are any
};

// What was found, and is written.
class Answer
{
public:
  Answer(const Costs& costs,
         const Options& options,
         const std::vector<Grid_cell>& sources,
         const std::vector<Grid_cell>& targets)
    : m_costs(costs),
      m_sources(sources),
      m_graphs{costs, options.goes_to_sources},
      m_graphs_onward{costs, !options.goes_to_sources},
      m_search(m_graphs, options, sources, "sources")
  {
    if(options.writes_corridor)
      m_search_onward.emplace(m_graphs_onward, options, targets, "targets");
    for(const Grid_cell& target : targets)
      m_routes.push_back(route(target));
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
  bool goes_to_sources() const { return m_graphs.goes_to_sources; }
  const Search& search() const { return m_search; }
  const std::vector<Grid_cell>& sources() const { return m_sources; }
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
    m_search_onward->for_each_distance(
        row, [&](const std::size_t column, const double cost) { m_row[column] += cost; });
    return m_row;
  }

  // Returns the directions to the nodes before each cell of a row, or to the next ones on the paths
  // to the sources.
  const std::vector<double>& back_link_row(const std::size_t row)
  {
    m_row.assign(frame().columns, std::numeric_limits<double>::infinity());
    m_search.for_each_predecessor(row, [&](const std::size_t column, const Grid_place& place) {
      const Grid_point p = m_search.position({column, row, 0});
      const Grid_point way =
          vector_between(m_costs, p, m_costs.beside(p, m_search.position(place)));
      const double degrees = std::atan2(way.x, -way.y) * 180 / std::acos(-1.);
      m_row[column] = degrees < 0 ? degrees + 360 : degrees;
    });
    return m_row;
  }

  void remove_work_files()
  {
    m_search.remove_files();
    if(m_search_onward)
      m_search_onward->remove_files();
  }

private:
  Route route(const Grid_cell& target) const
  {
    Route result{target, m_search.distance(target), {}, {}, {}};
    for(const Grid_place& place : m_search.path(target))
    {
      const Grid_point p = m_search.position(place);
      result.points.push_back(result.points.empty() ? p : m_costs.beside(result.points.back(), p));
    }
    if(m_graphs.goes_to_sources)
      std::reverse(result.points.begin(), result.points.end());
    const Grid_point* last = nullptr;
    for(const Grid_point& p : result.points)
    {
      result.lengths.push_back(
          last == nullptr ? 0 : result.lengths.back() + length_between(m_costs, *last, p));
      if(m_costs.has_heights())
        result.heights.push_back(height_at(m_costs, p));
      last = &p;
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
    m_isochrones.emplace(
        std::move(values), m_costs.shape(),
        [&](const std::size_t row) -> const std::vector<double>& { return cost_row(row); });
  }

  const Costs& m_costs;
  std::vector<Grid_cell> m_sources;
  Graph_of_window m_graphs, m_graphs_onward;
  Search m_search;
  std::optional<Search> m_search_onward; // between cells and targets
  std::vector<Route> m_routes;
  std::optional<Isochrones> m_isochrones;
  std::size_t m_number_reached = 0;
  double m_largest_cost = 0;
  std::vector<double> m_row;
};

#endif // TERRAIN_ROUTES_ANSWER_H
