// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_DIRECTIONAL_GRAPH_H
#define CGAL_GEODESIC_COSTS_DIRECTIONAL_GRAPH_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/Directional_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph_base.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Gauge_costs.h>

#include <cstddef>
#include <utility>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicCostsGraphs
 *
 * The graph for costs that depend on the direction, which `directional_cost()` gives to a
 * triangulation. Its nodes are those of a `Steiner_graph`: vertices and points on edges. The cost
 * of an arc across a face is the gauge of the face for the vector from one end to the other, and
 * the cost of an arc along an edge is the smaller one of both faces. There are no arcs where the
 * cost is infinite, nor across barriers, along which paths may run.
 *
 * Distances are those from the sources of a search, or, with the named parameter
 * `direction_to_source(true)`, those to the sources. `reversed()` returns a copy of the graph for
 * the other direction, so that the mesh is read only once.
 *
 * Where zigzags are cheaper than a straight line across a face, the line has their cost. Zigzags
 * within the face come arbitrarily close to the line. So an infinite cost of a direction forbids
 * straight lines only, as long as there are others to zigzag in.
 *
 * With the named parameter `max_slope` of the triangulation, there are no arcs in faces, nor along
 * their sides, whose slope is larger, uphill or downhill. No zigzags within a face take their
 * place: those that others have the costs of keep the limit, too. A path is made of straight pieces
 * from side to side of faces, or along sides, each of which is within the limit; it bends at nodes.
 * Between two slanted sides, it can gain height by turning at them, as on a road. More points on
 * sides, or smaller faces, allow more such turns. Where the steepness of the face itself is too
 * much, whatever the direction, let it cost infinity in all: that does not depend on the mesh.
 * Faces that are not steeper than the limit in any direction keep their bound; if there are others,
 * there is none, as paths with turns elsewhere than at nodes are not approximated.
 *
 * Arcs are not stored: the graph takes 60 bytes per vertex in addition to the triangulation, which
 * has the gauges, and 8 per point, or 4 if points divide edges into equal parts. As in a
 * `Steiner_graph`, a search does not look at all arcs.
 *
 * An object of this class never changes after its construction, and may be used by several threads.
 *
 * \tparam Placement a model of `SteinerPointPlacement`: `Directional_points` guarantees a bound,
 *         `Fixed_number_of_points` and `Points_at_interval` are simpler and do not.
 *
 * \cgalModels{SurfaceGraph}
 */
template <typename Placement = Directional_points>
class Directional_graph : public Steiner_graph_base<Placement, internal::Gauge_costs>
{
  using Base = Steiner_graph_base<Placement, internal::Gauge_costs>;

public:
  /// \name Creation
  /// @{

  /*!
   * builds the graph of `triangulation`.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param triangulation the triangulation
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": that of the
   *           placement, and those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{direction_to_source}
   *     \cgalParamDescription{whether distances are those to the sources of a search instead of
   *                           those from them}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`false`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{maximum_number_of_points}
   *     \cgalParamDescription{the maximum number of points on all edges together}
   *     \cgalParamType{an integer type}
   *     \cgalParamDefault{1000 per edge on average, but at least \f$10^6\f$ and at most
   *                       \f$10^8\f$}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if the triangulation has no directional costs, if there are
   *         points and a face violates the triangle inequality, or as the placement does.
   * \throws std::length_error if more than `maximum_number_of_points` points are needed; it says
   *         how many, and on which edge most of them are. Also if there are more than
   *         \f$2^{32} - 1\f$ nodes.
   *
   * Run time and memory are \cgalBigO{n} for `n` nodes.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Directional_graph(Intrinsic_triangulation triangulation,
                             const NamedParameters& np = parameters::default_values())
    : Directional_graph(std::move(triangulation),
                        Placement(np),
                        parameters::choose_parameter(
                            parameters::get_parameter(np, internal_np::direction_to_source), false),
                        internal::maximum_number_of_points(np))
  {
  }

  /// builds the graph with a placement that was constructed before. If `maximum_number_of_points`
  /// is `0`, the default of the named parameter applies.
  Directional_graph(Intrinsic_triangulation triangulation,
                    Placement placement,
                    const bool direction_to_source = false,
                    const std::size_t maximum_number_of_points = 0)
    : Base(std::move(triangulation),
           std::move(placement),
           maximum_number_of_points,
           direction_to_source)
  {
  }

  /// returns a copy of the graph for distances in the other direction.
  Directional_graph reversed() const
  {
    Directional_graph result = *this;
    result.m_is_backward = !this->m_is_backward;
    return result;
  }

  /// @}

  /// \name Access
  /// @{

  /// returns whether distances are those to the sources of a search instead of those from them.
  bool leads_to_sources() const { return this->m_is_backward; }

  /// returns a bound of the relative error of the costs, which may be too high where the cost
  /// function was sampled in some directions only; `0` if it has a formula in all faces. It is part
  /// of `epsilon()`. It holds for convex cost functions; for others, costs are those of zigzags in
  /// sampled directions.
  double sampling_error() const { return this->m_triangulation.gauges().sampling_error(); }

  /// @}
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_DIRECTIONAL_GRAPH_H
