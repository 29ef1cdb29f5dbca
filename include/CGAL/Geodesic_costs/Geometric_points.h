// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_GEOMETRIC_POINTS_H
#define CGAL_GEODESIC_COSTS_GEOMETRIC_POINTS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Geometric_progressions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicCostsPlacements
 *
 * Points in geometric progressions from the ends of the edges, so that paths cost at most
 * \f$1 + \varepsilon\f$ times as much as the cheapest ones on the surface, whatever the weights.
 *
 * From either end of an edge, the distances of the points from that end grow by a constant factor,
 * \f$\lambda = \exp(2 \sinh^{-1}(\sqrt{\varepsilon} \sin \alpha))\f$, where \f$\alpha\f$ is the
 * smallest angle that the edge makes there with the other edges of its two faces (if it is acute,
 * else the sine is replaced by 1). The progression starts at a distance from the vertex that is
 * proportional to the radius of its star: the radius times about \f$\sqrt{\varepsilon / 2}\f$ if
 * all faces around it have the same weight, and else times about \f$\varepsilon / 6\f$. There are
 * no points on edges at the border, nor on barriers, unless these may be lifted, since no cheapest
 * path needs them. Section
 * \ref AG_geometric_points of the manual states the theorem, and the report \cgalCite{ag-report}
 * proves it.
 *
 * The number of points on an edge is \cgalBigO{\log(1 / \varepsilon) / \sqrt\varepsilon} times a
 * factor that depends on the angles. Progressions were introduced by Aleksandrov, Lanthier,
 * Maheshwari and Sack \cgalCite{alms-eawsp-98}; theirs have
 * \cgalBigO{\log(1 / \varepsilon) / \varepsilon} points, and a factor that grows with the ratio of
 * the weights.
 *
 * <b>Thin faces.</b> The number of points is inversely proportional to the sine of the smallest
 * angle. For \f$\varepsilon = 0.1\f$ and an angle of 0.001, a needle needs some 2500 on either of
 * its long sides. A face that needs more than `maximum_number_of_points_per_edge` points is
 * rejected, and so are faces of area zero, unless they are forbidden. With `accept_weaker_bound`,
 * the face is accepted with at most 20 / \f$\sqrt\varepsilon\f$ points in a progression, and
 * `epsilon()` returns the bound that is left for the whole mesh. It is infinity if there are faces
 * of area zero.
 *
 * \cgalModels{SteinerPointPlacement}
 */
class Geometric_points
{
public:
  /// the number of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  /// whether points divide every edge into equal parts, so that no positions are stored.
  static constexpr bool makes_equal_parts = false;

  /// the default limit: 8 megabytes on one edge.
  static constexpr std::size_t MAXIMUM_NUMBER_OF_POINTS_PER_EDGE = 1000000;

  /*!
   * places points for the bound `epsilon`.
   *
   * \param epsilon the bound
   * \param may_change whether the bound also holds after `Steiner_graph::set_weights()` around
   *        vertices where all weights are the same now, and after `Steiner_graph::set_barriers()`;
   *        then there are points on barriers, too
   *
   * \throws std::invalid_argument if `epsilon` is not a finite number above `0`.
   */
  explicit Geometric_points(const double epsilon = 0.1, const bool may_change = false)
    : m_epsilon(internal::checked_epsilon(parameters::epsilon(epsilon))), m_may_change(may_change)
  {
  }

  /*!
   * reads the bound from named parameters.
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{epsilon}
   *     \cgalParamDescription{paths in the graph cost at most \f$1 + \varepsilon\f$ times as much
   *                           as the cheapest ones on the surface}
   *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
   *     \cgalParamDefault{`0.1`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{maximum_number_of_points_per_edge}
   *     \cgalParamDescription{the maximum number of points on an edge of a thin face}
   *     \cgalParamType{an integer type}
   *     \cgalParamDefault{`1000000`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{accept_weaker_bound}
   *     \cgalParamDescription{whether faces that need more points are accepted with few, and with
   *                           a weaker bound, which `epsilon()` returns; else they are rejected}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`false`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if `epsilon` is not a finite number above `0`, or the limit is
   *         not an integer above `0`.
   */
  template <typename T, typename Tag, typename Base>
  explicit Geometric_points(const Named_function_parameters<T, Tag, Base>& np,
                            const bool may_change = false)
    : m_epsilon(internal::checked_epsilon(np)),
      m_limit(internal::limit_of_points(np, MAXIMUM_NUMBER_OF_POINTS_PER_EDGE)),
      m_may_change(may_change)
  {
  }

  /// computes where the progressions of every vertex start, and looks for faces that need too many
  /// points. If a weaker bound is accepted, the faces that need most points get few, until there
  /// are no more than `maximum_number_of_points` on all edges together.
  ///
  /// \throws std::length_error naming the face and the number if a face needs too many points,
  ///         and no weaker bound is accepted.
  ///
  /// Run time is \cgalBigO{n}.
  void
  prepare(const Intrinsic_triangulation& triangulation,
          const std::size_t maximum_number_of_points = (std::numeric_limits<std::size_t>::max)())
  {
    if(const Index h = raised_weight(triangulation);
       h != Intrinsic_triangulation::null_index && !m_limit.is_soft)
      internal::reject("the bound epsilon cannot be kept, as " + triangulation.name_of_face(h) +
                       " has a weight that is less than 1e-307 of the largest finite one; "
                       "accept_weaker_bound(true) accepts that there is no bound");
    const Index number_of_vertices = triangulation.number_of_vertices();
    std::vector<bool> is_uniform(number_of_vertices);
    for(Index v = 0; v < number_of_vertices; ++v)
      is_uniform[v] = !m_may_change && internal::are_weights_uniform(triangulation, v);
    const bool are_uniform =
        std::all_of(is_uniform.begin(), is_uniform.end(), [](const bool is) { return is; });
    m_epsilon_of_crossings = are_uniform ? m_epsilon : SHARE_OF_CROSSINGS * m_epsilon;

    std::vector<double> start(number_of_vertices);
    for(Index v = 0; v < number_of_vertices; ++v)
    {
      const internal::Star star(triangulation, v);
      if(star.is_degenerate() && !m_limit.is_soft)
        internal::Measured_progressions::refuse(triangulation, star.narrowest_face(),
                                                (std::numeric_limits<std::size_t>::max)(),
                                                m_limit.number);
      start[v] = relative_start(is_uniform[v]) * star.radius();
    }
    internal::Limit_of_points limit = m_limit;
    do
    {
      m_progressions = internal::Measured_progressions(triangulation, start, m_epsilon_of_crossings,
                                                       limit, m_may_change);
      limit.number /= 2;
    } while(limit.is_soft && limit.number > 0 &&
            internal::has_more_points(triangulation, *this, maximum_number_of_points));
  }

  /// returns the number of points on the edge of `h`.
  std::size_t number_of_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    return has_points(triangulation, h)
               ? m_progressions.on_edge(triangulation, h).number_of_points()
               : 0;
  }

  /// writes the positions of these points to `positions`. `number_of_points` is the result of
  /// `number_of_points()`.
  void place(const Intrinsic_triangulation& triangulation,
             const Index h,
             float* positions,
             std::size_t /* number_of_points */) const
  {
    if(has_points(triangulation, h))
      m_progressions.on_edge(triangulation, h).place(positions);
  }

  /// returns the bound that holds with the present weights of `triangulation`; it is not smaller
  /// than the requested one. Run time is \cgalBigO{n}.
  double epsilon(const Intrinsic_triangulation& triangulation) const
  {
    using internal::infinity;
    if(raised_weight(triangulation) != Intrinsic_triangulation::null_index)
      return infinity;
    if(!m_may_change && triangulation.has_lifted_barriers())
      return infinity; // there are no points on these
    double of_crossings = m_epsilon_of_crossings, of_vicinities = 0;
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
    {
      const internal::Star star(triangulation, v);
      if(star.is_degenerate())
        return infinity;
      if(std::isinf(star.radius()) || star.radius() == 0) // no face, or all in one place
        continue;
      const double start = 2 * m_progressions.start(v) / star.radius();
      if(start >= 1)
        return infinity;
      if(internal::are_weights_uniform(triangulation, v))
        of_crossings = (std::max)(of_crossings, std::expm1(-std::log1p(-start * start) / 2));
      else
        of_vicinities = (std::max)(of_vicinities, start / (1 - start));
    }
    const double of_given_up = m_progressions.epsilon_of_given_up(triangulation);
    if(of_given_up > of_crossings)
      return (1 + of_given_up) * (1 + of_crossings) * (1 + of_vicinities) - 1;
    const double result = of_crossings + (1 + of_crossings / 2) * of_vicinities;
    constexpr double tolerance = 1e-9;
    return result <= m_epsilon * (1 + tolerance) ? m_epsilon : result;
  }

  /// returns the tangent of the angle with a side up to which arcs across faces may be left out, as
  /// ways along the side cost little more: the bound has room for this.
  double tangent_of_narrow_arcs() const
  {
    constexpr double largest_square = 0.4;
    return std::sqrt((std::min)(m_epsilon_of_crossings, largest_square));
  }

  /// returns whether `accept_weaker_bound` was given.
  bool accepts_weaker_bound() const { return m_limit.is_soft; }

  /// returns the number of bytes that are stored per element of the mesh.
  std::size_t memory() const { return m_progressions.memory(); }

private:
  // The share of epsilon for crossing faces if weights differ; the rest is for passing near
  // vertices. This share approximately minimizes the number of points.
  static constexpr double SHARE_OF_CROSSINGS = 0.65;

  // Returns a halfedge of a face whose weight was raised to the smallest one that is allowed beside
  // the largest, or the null index.
  static Index raised_weight(const Intrinsic_triangulation& triangulation)
  {
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(triangulation.weight(h) == Face_weights::SMALLEST_WEIGHT)
        return h;
    return Intrinsic_triangulation::null_index;
  }

  bool has_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    return triangulation.is_crossable(h) || (m_may_change && triangulation.is_barrier(h));
  }

  // Returns where progressions start, relative to the radius of the star.
  double relative_start(const bool is_uniform) const
  {
    constexpr double largest = 1. / 3;
    const double e = m_epsilon_of_crossings;
    if(is_uniform)
      return (std::min)(std::sqrt(e * (2 + e)) / (2 * (1 + e)), largest);
    const double of_vicinities = (m_epsilon - e) / (1 + e / 2);
    return (std::min)(of_vicinities / (2 * (1 + of_vicinities)), largest);
  }

  double m_epsilon;
  internal::Limit_of_points m_limit{MAXIMUM_NUMBER_OF_POINTS_PER_EDGE, false};
  bool m_may_change = false;
  double m_epsilon_of_crossings = 0; // for paths across faces, away from vertices
  internal::Measured_progressions m_progressions;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_GEOMETRIC_POINTS_H
