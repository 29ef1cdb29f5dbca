// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_STEINER_GRAPH_H
#define CGAL_GEODESIC_COSTS_STEINER_GRAPH_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph_base.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Weighted_costs.h>

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicCostsGraphs
 *
 * The graph of the vertices of a mesh and of points on its edges, so-called Steiner points. Two
 * nodes at the border of the same face are joined by a straight arc across the face, and
 * neighbors on an edge by an arc along it.
 *
 * It is the graph for faces with weights. An arc across a face costs its length times the weight of
 * the face, and an arc along an edge its length times the smaller weight of the two faces. There
 * are no arcs across faces of infinite weight, nor across barriers, along which paths may run.
 * Without weights and barriers, it is suitable for paths across a few large faces.
 *
 * The placement determines where points are, and thus the error: `Geometric_points` guarantees a
 * bound, `Fixed_number_of_points` and `Points_at_interval` are simpler and do not.
 *
 * Between long sides of thin faces, arcs that make a small angle with a side are left out, if the
 * placement says up to which angle. The bound of `Geometric_points` has room for the ways in their
 * place.
 *
 * Arcs are not stored: the graph takes 36 bytes per vertex, in addition to the triangulation, and 8
 * per point, or 4 if points divide edges into equal parts. A search does not look at all arcs
 * either. A path that crosses a face is not continued into the same face again, and where edges
 * have many points, a point is only connected to those points of the opposite edges that neither of
 * its two neighbors reaches at a lower cost.
 *
 * Faces of weight `0` are free. Of the paths that cost the same, searches return one whose free
 * parts are shortest.
 *
 * Nodes are the vertices, the points, and one for each sector of a vertex whose incident faces are
 * divided by barriers into several sectors: no path leads through such a vertex from one sector
 * into another. `attach()` lists all nodes of a vertex; a run of `Propagation` from several places
 * starts from all of them.
 *
 * An object of this class never changes after its construction, unless its weights or barriers do,
 * and may be used by several threads.
 *
 * \tparam Placement a model of `SteinerPointPlacement`
 *
 * \cgalModels{SurfaceGraph}
 */
template <typename Placement = Geometric_points>
class Steiner_graph : public Steiner_graph_base<Placement, internal::Weighted_costs>
{
  using Base = Steiner_graph_base<Placement, internal::Weighted_costs>;

public:
  /// \name Creation
  /// @{

  /// the graph of an empty mesh.
  Steiner_graph() : Steiner_graph(Intrinsic_triangulation()) {}

  /*!
   * builds the graph of `triangulation`, its weights and its barriers.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param triangulation the triangulation
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": that of the
   *           placement, and the one listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{maximum_number_of_points}
   *     \cgalParamDescription{the maximum number of points on all edges together}
   *     \cgalParamType{an integer type}
   *     \cgalParamDefault{1000 per edge on average, but at least \f$10^6\f$ and at most
   *                       \f$10^8\f$}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if there are points and a face violates the triangle inequality,
   *         or as the placement does.
   * \throws std::length_error if more than `maximum_number_of_points` points are needed; it says
   *         how many, and on which edge most of them are. Also if there are more than
   *         \f$2^{32} - 1\f$ nodes, or as the placement does.
   *
   * Run time and memory are \cgalBigO{n} for `n` nodes. Points are counted before they are
   * constructed.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Steiner_graph(Intrinsic_triangulation triangulation,
                         const NamedParameters& np = parameters::default_values())
    : Steiner_graph(std::move(triangulation), Placement(np), internal::maximum_number_of_points(np))
  {
    static_assert(!internal::is_given<NamedParameters, internal_np::direction_to_source_t>,
                  "direction_to_source: distances there and back are the same in this graph; use "
                  "Directional_graph");
    static_assert(!internal::is_given<NamedParameters, internal_np::max_slope_t>,
                  "max_slope: costs depend on the direction then; use Directional_graph");
    if constexpr(internal::is_given<NamedParameters, internal_np::face_weight_t>)
      if(!this->m_triangulation.has_weights() && this->m_triangulation.number_of_halfedges() > 0)
        internal::reject("face_weight_map was given to Steiner_graph; it is for the constructor of "
                         "Intrinsic_triangulation");
  }

  /// builds the graph with a placement that was constructed before. If `maximum_number_of_points`
  /// is `0`, the default of the named parameter applies.
  Steiner_graph(Intrinsic_triangulation triangulation,
                Placement placement,
                const std::size_t maximum_number_of_points = 0)
    : Base(std::move(triangulation), std::move(placement), maximum_number_of_points)
  {
  }

  /// @}

  /// \name Modification
  /// @{

  /*!
   * replaces the weights by what `read_face_weights()` returns; the points stay where they are. If
   * weights around a vertex now differ that were all the same when the graph was built, or thin
   * faces are not forbidden any more, the bound gets worse, unless `Geometric_points` was
   * constructed for weights that may change: `epsilon()` returns the new one.
   *
   * \warning No other thread may use the graph meanwhile, and existing workspaces for it become
   * invalid.
   *
   * Run time is \cgalBigO{n} for `n` vertices and points.
   */
  void set_weights(Face_weights weights)
  {
    this->m_triangulation.set_weights(std::move(weights));
    this->m_changes.add_unknown();
    this->summarize_arcs();
  }

  /*!
   * changes the weights of some faces. The points stay where they are, and the bound is as above.
   * Workspaces stay valid: `Surface_search::repair()` finds what is different, in time that depends
   * on that, and any other run is as after building the graph.
   *
   * \warning No other thread may use the graph meanwhile.
   *
   * \throws std::invalid_argument as `Intrinsic_triangulation::set_weights()` does. Then no weight
   *         has changed.
   *
   * Run time is linear in the number of changes, amortized. At the first call for a triangulation
   * without weights, it is \cgalBigO{n}.
   */
  void set_weights(const std::vector<Weight_change>& changes)
  {
    this->change_weights(changes);
    if(this->m_changes.number() - this->m_number_of_changes > this->most_changes())
      this->summarize_arcs(); // takes no longer than so many changes
  }

  /// does the same for a list in braces, which could also stand for `Face_weights`.
  void set_weights(const std::initializer_list<Weight_change> changes)
  {
    set_weights(std::vector<Weight_change>(changes));
  }

  /*!
   * lifts barriers, or puts them back, as doors are opened and closed. Only edges that were
   * barriers when the graph was built can change. Workspaces stay valid, as above. The bound stays
   * the same if `Geometric_points` was constructed for barriers that may be lifted; other
   * placements than that have points on barriers anyway.
   *
   * \warning No other thread may use the graph meanwhile.
   *
   * \throws std::invalid_argument as `Intrinsic_triangulation::set_barriers()` does. Then no
   * barrier has changed.
   *
   * Run time is linear in the number of changes; at the first call, it is \cgalBigO{n}.
   */
  void set_barriers(const std::vector<Barrier_change>& changes) { this->change_barriers(changes); }

  /// @}
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_STEINER_GRAPH_H
