// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_DIRECTIONAL_POINTS_H
#define CGAL_GEODESIC_COSTS_DIRECTIONAL_POINTS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Gauge_polygon.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Gauge_vicinities.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Geometric_progressions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicCostsPlacements
 *
 * Points in geometric progressions from the ends of the edges, for costs that depend on the
 * direction, so that paths cost at most \f$1 + \varepsilon\f$ times as much as the cheapest ones on
 * the surface.
 *
 * They differ from `Geometric_points` in two ways. Their spacing depends on how far the direction
 * of a path can turn in each corner of a face before the chord of the gauge between two directions
 * is too high: where the unit ball of the gauge is smooth, this is proportional to
 * \f$\sqrt\varepsilon\f$ divided by the root of the curvature, and where it has corners, to
 * \f$\varepsilon\f$. And progressions start at the same cost from the vertex, on all of its edges.
 * This is in proportion to \f$\varepsilon\f$ and to the smallest cost of a way from the opposite
 * side of a face, and larger if the gauges are nearly linear in the corners there. Section
 * \ref AG_directional_bound of the manual states the theorem, and the report \cgalCite{ag-report}
 * proves it.
 *
 * There is no bound where some directions in a face are free or forbidden, and others are not, or
 * steeper than `max_slope`. Such faces are rejected, and so are faces with an edge that needs more
 * than `maximum_number_of_points_per_edge` points, since their area is almost zero, for example.
 * With `accept_weaker_bound`, such edges get 20 / \f$\sqrt\varepsilon\f$ points, and there is no
 * bound.
 *
 * \cgalModels{SteinerPointPlacement}
 */
class Directional_points
{
public:
  /// the number of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  /// whether points divide every edge into equal parts, so that no positions are stored.
  static constexpr bool makes_equal_parts = false;

  /// the default limit.
  static constexpr std::size_t MAXIMUM_NUMBER_OF_POINTS_PER_EDGE = 20000;

  /// progressions start at least this far from the end, in lengths of the edge.
  static constexpr double SMALLEST_START = 1e-36;

  /*!
   * places points for the bound `epsilon`.
   *
   * \param epsilon the bound
   *
   * \throws std::invalid_argument if `epsilon` is not a finite number above `0`.
   */
  explicit Directional_points(const double epsilon = 0.1)
    : m_epsilon(internal::checked_epsilon(parameters::epsilon(epsilon)))
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
   *     \cgalParamDescription{the maximum number of points on an edge}
   *     \cgalParamType{an integer type}
   *     \cgalParamDefault{`20000`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{accept_weaker_bound}
   *     \cgalParamDescription{whether faces are accepted where the bound does not hold;
   *                           `epsilon()` returns infinity then}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`false`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if `epsilon` is not a finite number above `0`, or the limit is
   *         not an integer above `0`.
   */
  template <typename T, typename Tag, typename Base>
  explicit Directional_points(const Named_function_parameters<T, Tag, Base>& np)
    : m_epsilon(internal::checked_epsilon(np)),
      m_limit(internal::limit_of_points(np, MAXIMUM_NUMBER_OF_POINTS_PER_EDGE))
  {
  }

  /// computes where progressions start and how close points are. If a weaker bound is accepted,
  /// edges that need most points get few, until there are no more than `maximum_number_of_points`
  /// on all edges together.
  ///
  /// \throws std::invalid_argument naming a face or an edge where the bound does not hold.
  ///
  /// Run time is \cgalBigO{n k \log k} for `k` directions per face, some hundreds.
  void
  prepare(const Intrinsic_triangulation& triangulation,
          const std::size_t maximum_number_of_points = (std::numeric_limits<std::size_t>::max)())
  {
    const double sampling_error = triangulation.gauges().sampling_error();
    const double rest = (std::max)((1 + m_epsilon) / (1 + sampling_error) - 1, 0.5 * m_epsilon);
    const double of_crossings = SHARE_OF_CROSSINGS * rest;
    m_bound = m_epsilon;
    internal::Gauge_vicinities vicinities(triangulation);
    compute_steps(triangulation, of_crossings, vicinities);
    compute_starts(triangulation, (rest - of_crossings) / (1 + of_crossings), vicinities);
    if((1 + rest) * (1 + sampling_error) > (1 + m_epsilon) * (1 + ROUNDING))
      give_up(
          "the cost function was sampled in too few directions, so that costs may be too high by " +
          internal::text_of(sampling_error) +
          "; use a larger epsilon, or give it to the triangulation, too");
    m_largest_number = m_limit.number;
    while(m_limit.is_soft && m_largest_number > 1 &&
          internal::has_more_points(triangulation, *this, maximum_number_of_points))
      m_largest_number /= 2;
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(triangulation.is_crossable(h) && triangulation.length(h) > 0 &&
         progressions(triangulation, h).number_of_points() > m_largest_number)
        give_up(triangulation.name_of_face(h) + " needs more points on an edge than " +
                std::to_string(m_largest_number) + ", the maximum_number_of_points_per_edge");
  }

  /// returns the number of points on the edge of `h`.
  std::size_t number_of_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    if(!triangulation.is_crossable(h))
      return 0;
    const std::size_t result = progressions(triangulation, h).number_of_points();
    if(result <= m_largest_number)
      return result;
    constexpr double largest = 20; // if the bound was given up
    return (std::min)(m_largest_number,
                      static_cast<std::size_t>(largest / std::sqrt(m_epsilon)) + 1);
  }

  /// writes the positions of these points to `positions`. `number_of_points` is the result of
  /// `number_of_points()`.
  void place(const Intrinsic_triangulation& triangulation,
             const Index h,
             float* positions,
             const std::size_t number_of_points) const
  {
    const auto all = progressions(triangulation, h);
    if(number_of_points == all.number_of_points())
      return all.place(positions);
    for(std::size_t i = 0; i < number_of_points; ++i) // fewer than the bound requires
    {
      const double part = double(i + 1) / double(number_of_points + 1);
      positions[i] = static_cast<float>(part <= 0.5 ? part : part - 1);
    }
  }

  /// returns the bound, or infinity if a weaker one was accepted.
  double epsilon(const Intrinsic_triangulation& /* triangulation */) const { return m_bound; }

  /// returns whether `accept_weaker_bound` was given.
  bool accepts_weaker_bound() const { return m_limit.is_soft; }

  /// returns the number of bytes that are stored per element of the mesh.
  std::size_t memory() const { return internal::memory_of(m_start, m_step); }

private:
  static constexpr double SHARE_OF_CROSSINGS =
      0.8; // of epsilon; the rest is for passing near vertices
  static constexpr double SHARE_OF_SAMPLING = 0.05; // of the error of crossings
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double LARGEST_START = internal::Gauge_vicinities::LARGEST_PART;
  static constexpr double ROUNDING = 1e-9;
  static constexpr double ROUNDING_OF_LOGARITHM = 2.5e-7; // as in `Measured_progressions`

  void give_up(const std::string& reason)
  {
    if(!m_limit.is_soft)
      internal::reject("the bound epsilon cannot be kept, as " + reason +
                       "; accept_weaker_bound(true) accepts that there is no bound");
    m_bound = infinity;
  }

  // Computes, per corner, the largest logarithm of the ratio of distances of neighbors, and looks
  // at the vicinities of vertices.
  void compute_steps(const Intrinsic_triangulation& triangulation,
                     const double epsilon,
                     internal::Gauge_vicinities& vicinities)
  {
    const auto& gauges = triangulation.gauges();
    m_step.assign(triangulation.number_of_halfedges(), internal::Gauge_polygon::LARGEST_STEP);
    internal::Gauge_samples samples; // their memory is reused
    internal::Gauge_polygon polygon;
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(triangulation.is_open(h) && h == triangulation.first_of_face(h))
      {
        internal::check_for_interruption();
        const double error = polygon.assign(triangulation, h, SHARE_OF_SAMPLING * epsilon, samples);
        if(polygon.is_free())
        {
          vicinities.add_free(h);
          continue;
        }
        if(polygon.is_bounded())
          vicinities.add(h, polygon, error);
        else
          give_up(triangulation.name_of_face(h) +
                  " has directions that are free or forbidden, and others that are not");
        if(gauges.is_limited(gauges.face(h)))
          give_up(triangulation.name_of_face(h) +
                  " is steeper than max_slope, and paths may follow some of its directions only");
        for(const Index g : triangulation.halfedges_of_face(h))
          m_step[g] = polygon.is_bounded()
                          ? polygon.step(gauges.side(g),
                                         -1 * gauges.side(triangulation.halfedges_of_face(g)[2]),
                                         (1 + epsilon) / (1 + error) - 1)
                          : std::sqrt(epsilon);
      }
  }

  // Computes, per halfedge, where the points on its edge start, relative to its length.
  void compute_starts(const Intrinsic_triangulation& triangulation,
                      const double epsilon,
                      const internal::Gauge_vicinities& vicinities)
  {
    m_start.assign(triangulation.number_of_halfedges(), LARGEST_START);
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
    {
      const Index first = triangulation.first_halfedge(v),
                  beyond = triangulation.beyond_halfedge(v);
      // seen from the other end of an edge, the vertex and the first point are neighbors, too
      double largest = infinity;
      for(Index h = first; h < beyond; ++h)
      {
        if(triangulation.is_open(h) &&
           internal::Face_shape(triangulation, h).distance_to_opposite_edge() == 0)
          give_up("a face at vertex " + std::to_string(triangulation.index(v)) + " has no area");
        if(triangulation.is_crossable(h))
          largest =
              (std::min)(largest, vicinities.cost(h) * -std::expm1(-steps(triangulation, h)[1]));
      }
      const double radius = vicinities.radius(v, epsilon, largest), height = vicinities.height(v);
      if(height < infinity)
        for(Index h = first; h < beyond; ++h)
          m_start[h] = radius / (std::max)(vicinities.cost(h), height);
    }
  }

  // Returns the largest logarithms of ratios of distances from the source and the target of `h`.
  std::array<double, 2> steps(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    std::array<double, 2> result;
    result.fill(internal::Gauge_polygon::LARGEST_STEP);
    const Index opposite = triangulation.opposite(h);
    for(const Index side : {h, opposite})
      if(triangulation.is_open(side))
      {
        double &first = result[side == h ? 0 : 1], &second = result[side == h ? 1 : 0];
        first = (std::min)(first, m_step[side]);
        second = (std::min)(second, m_step[triangulation.next(side)]);
      }
    return result;
  }

  // \pre The edge of `h` is not at the border, and longer than zero.
  internal::Geometric_progressions progressions(const Intrinsic_triangulation& triangulation,
                                                const Index h) const
  {
    const std::array<double, 2> steps = this->steps(triangulation, h);
    return {end(m_start[h], steps[0]), end(m_start[triangulation.opposite(h)], steps[1])};
  }

  // The progressions meet where the last steps of both are small enough for both.
  static internal::Geometric_progressions::End end(const double start, const double step)
  {
    constexpr double smallest = 1e-12; // not zero
    internal::Geometric_progressions::End result;
    result.start = start > SMALLEST_START ? (std::min)(start, LARGEST_START) : SMALLEST_START;
    result.log_of_ratio = (std::max)({step - ROUNDING_OF_LOGARITHM, step / 2, smallest});
    result.sine = std::sinh(result.log_of_ratio / 2);
    return result;
  }

  double m_epsilon;
  internal::Limit_of_points m_limit{MAXIMUM_NUMBER_OF_POINTS_PER_EDGE, false};
  std::size_t m_largest_number = 0; // of points on an edge: the limit, or less because of the total
  double m_bound = 0;
  std::vector<double> m_start; // per halfedge: where points start, relative to its length
  std::vector<double> m_step;  // per halfedge: the logarithm of the ratio, for its source
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_DIRECTIONAL_POINTS_H
