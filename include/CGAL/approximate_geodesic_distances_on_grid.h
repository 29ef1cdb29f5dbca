// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESIC_DISTANCES_ON_GRID_H
#define CGAL_APPROXIMATE_GEODESIC_DISTANCES_ON_GRID_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/internal/search_on_grid.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics::internal {

// Adapts a visitor of cells to a visitor of nodes.
template <typename Visitor>
class Cell_visitor
{
public:
  Cell_visitor(Visitor& visitor, const Grid_shape& shape) : m_visitor(visitor), m_shape(shape) {}

  void on_settled(const Grid_graph::Node node, const double distance)
  {
    if(node < m_shape.number_of_cells())
      m_visitor.on_settled(m_shape.cell(node), distance);
  }

  void on_progress(const std::size_t number_of_settled_nodes, const std::size_t number_of_nodes)
  {
    m_visitor.on_progress(number_of_settled_nodes, number_of_nodes);
  }

  bool go_further() { return m_visitor.go_further(); }

private:
  Visitor& m_visitor;
  const Grid_shape& m_shape;
};

// Appends a named parameter to a chain, if it is given.
template <typename Tag, typename NamedParameters, typename Chain>
auto with_parameter([[maybe_unused]] const Tag tag,
                    [[maybe_unused]] const NamedParameters& np,
                    const Chain& chain)
{
  if constexpr(is_given<NamedParameters, Tag>)
  {
    const auto value = parameters::get_parameter(np, tag);
    return Named_function_parameters<std::decay_t<decltype(value)>, Tag, Chain>(value, chain);
  }
  else
    return chain;
}

// The graph of a grid that named parameters of a search ask for.
template <typename FrictionRange, typename NamedParameters>
Grid_graph
grid_graph(const Grid_shape& shape, const FrictionRange& friction, const NamedParameters& np)
{
  const auto none = parameters::default_values();
  const auto e = with_parameter(internal_np::epsilon, np, none);
  const auto h = with_parameter(internal_np::heights, np, e);
  const auto w = with_parameter(internal_np::face_weight, np, h);
  const auto s = with_parameter(internal_np::max_slope, np, w);
  return Grid_graph(shape, friction, with_parameter(internal_np::direction_to_source, np, s));
}

} // namespace Approximate_geodesics::internal

/*!
 * \ingroup PkgGeodesicGridsFunctions
 *
 * computes, for each cell of a grid, the approximately smallest cost of a path from the center of
 * the nearest source to its own.
 *
 * Each cell has a friction, a cost per unit of length. Costs may also depend on the slope of a
 * surface, and on the direction. Without a bound `epsilon`, paths consist of straight lines between
 * centers of cells. Where cells have the same friction, they are at most 0.3 % too long, in all
 * directions, if the width of cells is half to twice their height. With a bound, paths cost at most
 * \f$1 + \varepsilon\f$ times as much as the cheapest ones in the plane, and never less.
 * See `Approximate_geodesics::Grid_graph`.
 *
 * \tparam FrictionRange a model of `ConstRange` whose value type is a number type, or such a type
 * \tparam OutputIterator a model of `OutputIterator` that takes `double`
 * \tparam Sources `Approximate_geodesics::Grid_cell`, or a model of `ConstRange` with this value
 *         type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param shape the numbers of columns and rows, the size of a cell, and the value for no data
 * \param friction the friction of the cells, row by row, not negative, or one number for all; cells
 *        of infinite friction and those without data cannot be entered, and no path leads between
 *        two that touch at a corner
 * \param distances receives a cost for each cell, row by row: infinity for cells that cannot be
 *        entered, are not reachable, or not within `maximum_distance`, or if there is no source
 * \param sources a cell, or a range of cells; a source that cannot be entered has the cost 0, and
 *        there is no path from it
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `epsilon`,
 *        `heights`, `face_weight_map`, `max_slope` and `direction_to_source`, as for the
 *        constructor of `Approximate_geodesics::Grid_graph`, and `maximum_distance` and `visitor`,
 *        as for `approximate_geodesic_distances()`; the visitor is told of cells
 *
 * \throws std::invalid_argument as the constructor of `Approximate_geodesics::Grid_graph` does, and
 *         if a source is not in the grid, or the maximum distance is negative or not a number.
 * \throws std::length_error as this constructor does.
 *
 * Run time is \cgalBigO{n} in practice for `n` nodes: cells, and points on their sides if there is
 * a bound.
 *
 * \sa `approximate_geodesic_path_on_grid()`
 */
template <typename FrictionRange,
          typename OutputIterator,
          typename Sources,
          typename NamedParameters = parameters::Default_named_parameters>
void approximate_geodesic_distances_on_grid(
    const Approximate_geodesics::Grid_shape& shape,
    const FrictionRange& friction,
    OutputIterator distances,
    const Sources& sources,
    const NamedParameters& np = parameters::default_values())
{
  namespace AG = Approximate_geodesics;
  static_assert(
      !AG::internal::ignores_any<NamedParameters, internal_np::epsilon_t, internal_np::heights_t,
                                 internal_np::face_weight_t, internal_np::max_slope_t,
                                 internal_np::direction_to_source_t,
                                 internal_np::maximum_distance_t, internal_np::visitor_t>,
      "approximate_geodesic_distances_on_grid() reads the named parameters of Grid_graph, "
      "maximum_distance and visitor only");
  const AG::Grid_graph graph = AG::internal::grid_graph(shape, friction, np);
  const std::vector<AG::Seed> seeds = AG::internal::seeds_of_cells(graph, sources);
  const AG::Stop_rule stop{AG::internal::maximum_distance(np)};
  AG::Propagation search(graph);
  if constexpr(AG::internal::is_given<NamedParameters, internal_np::visitor_t>)
  {
    auto visitor = parameters::get_parameter(np, internal_np::visitor);
    search.run(seeds, stop, AG::internal::Cell_visitor(std::ref(visitor).get(), graph.shape()));
  }
  else
    search.run(seeds, stop);
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
    *distances++ = search.distance(static_cast<AG::Grid_graph::Node>(i));
}

/*!
 * \ingroup PkgGeodesicGridsFunctions
 *
 * computes an approximately cheapest path between the centers of two cells of a grid, and returns
 * its cost.
 *
 * The cost is that of `approximate_geodesic_distances_on_grid()`, up to rounding. The search is an
 * A* search with `Approximate_geodesics::Grid_graph::lower_bound()`.
 *
 * \tparam FrictionRange a model of `ConstRange` whose value type is a number type, or such a type
 * \tparam OutputIterator a model of `OutputIterator` that takes `Approximate_geodesics::Grid_point`
 * \tparam Sources `Approximate_geodesics::Grid_cell`, or a model of `ConstRange` with this value
 *         type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param shape the numbers of columns and rows, the size of a cell, and the value for no data
 * \param friction the friction of the cells, row by row, or one number for all
 * \param points receives the points of the path, from the source to the target; none if there is no
 *        path. On a periodic grid, a path that leaves the grid goes on beyond it
 * \param source a cell, or a range of cells, of which the nearest is taken
 * \param target a cell
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `epsilon`,
 *        `heights`, `face_weight_map`, `max_slope` and `maximum_distance`
 *
 * \return the cost of the path, or infinity if there is none, or not within `maximum_distance`.
 *
 * \throws std::invalid_argument, std::length_error as `approximate_geodesic_distances_on_grid()`
 *         does, and if `target` is not in the grid.
 *
 * \sa `approximate_geodesic_distances_on_grid()`
 */
template <typename FrictionRange,
          typename OutputIterator,
          typename Sources,
          typename NamedParameters = parameters::Default_named_parameters>
double approximate_geodesic_path_on_grid(const Approximate_geodesics::Grid_shape& shape,
                                         const FrictionRange& friction,
                                         OutputIterator points,
                                         const Sources& source,
                                         const Approximate_geodesics::Grid_cell& target,
                                         const NamedParameters& np = parameters::default_values())
{
  namespace AG = Approximate_geodesics;
  static_assert(
      !AG::internal::ignores_any<NamedParameters, internal_np::epsilon_t, internal_np::heights_t,
                                 internal_np::face_weight_t, internal_np::max_slope_t,
                                 internal_np::maximum_distance_t>,
      "approximate_geodesic_path_on_grid() reads the named parameters epsilon, heights, "
      "face_weight_map, max_slope and maximum_distance only");
  const AG::Grid_graph graph = AG::internal::grid_graph(shape, friction, np);
  const AG::Grid_graph::Node end = graph.node(target);
  const std::vector<AG::Seed> seeds = AG::internal::seeds_of_cells(graph, source);
  AG::Propagation search(graph);
  const std::vector<AG::Grid_point> path =
      AG::internal::find_path_on_grid(search, seeds, AG::internal::maximum_distance(np), end);
  std::copy(path.begin(), path.end(), points);
  return search.distance(end);
}

} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESIC_DISTANCES_ON_GRID_H
