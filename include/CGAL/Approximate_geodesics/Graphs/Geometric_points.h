// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_GEOMETRIC_POINTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_GEOMETRIC_POINTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Face_shape.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Geometric_progressions.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Weight_spread.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsPlacements
 *
 * Points in geometric progressions from the ends of the edges, so that paths cost at most
 * \f$1 + \varepsilon\f$ times as much as the cheapest ones on the surface.
 *
 * From either end of an edge, points follow each other at distances that grow by a constant factor,
 * \f$\lambda = \exp(2 \sinh^{-1}(\sqrt{\varepsilon} \sin \alpha))\f$, where \f$\alpha\f$ is the
 * smaller angle that the edge makes there with others of its two faces (if it is acute, else the
 * sine is to be read as 1). The progression starts at a distance from the vertex that is in
 * proportion to the radius of its star: the radius times about \f$\sqrt{\varepsilon / 2}\f$ if all
 * faces around it have the same weight, and else times about \f$\varepsilon / 6\f$ times the
 * smallest weight, divided by the largest. There are no points on edges at the border, nor on
 * barriers, since no cheapest path needs them. The manual has the exact statement and its proof:
 * see Section \ref AG_geometric_points.
 *
 * So there are \cgalBigO{\log(1 / \varepsilon) / \sqrt\varepsilon} points on an edge, times a
 * factor that depends on the angles, and grows with the logarithm of the ratio of the weights. The
 * idea of progressions is that of Aleksandrov, Lanthier, Maheshwari and Sack
 * \cgalCite{alms-eawsp-98}, whose own progressions, `Published_geometric_points`, have
 * \cgalBigO{\log(1 / \varepsilon) / \varepsilon} points.
 *
 * Faces with angles of almost `0` or 180 degrees would need points without end. Where a sine is
 * below `SMALLEST_SINE`, there are at most `LARGEST_NUMBER_IF_THIN` /
 * \f$\sqrt\varepsilon\f$ points in a progression, and
 * stars are taken to have a radius of at least a thousand-millionth part of their longest edge.
 * There is no bound then, and `epsilon()` is infinity; paths that cross such a face can be too long
 * by about the distance of points there.
 *
 * \cgalModels{SteinerPointPlacement}
 */
class Geometric_points
{
public:
  /// the number of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  /// whether points divide every edge into equal parts, so that their number says where they are.
  static constexpr bool makes_equal_parts = false;

  /// there is no bound for angles with smaller sines.
  static constexpr double SMALLEST_SINE = 0.02;

  /// with such an angle, a progression has at most so many points, divided by the root of epsilon.
  static constexpr int LARGEST_NUMBER_IF_THIN = 20;

  /// progressions start at least this far from the end, in lengths of the edge; less matters only
  /// if weights differ by more than a `double` can tell.
  static constexpr double SMALLEST_START = 1e-36;

  /*!
   * places points for the bound `epsilon`.
   *
   * \param epsilon the bound
   * \param ratio_of_weights the ratio of weights around a vertex that the bound shall hold for,
   *        even if weights get that different later; `0` for the weights that there are
   *
   * \throws std::invalid_argument if `epsilon` is not a finite number above `0`, or the ratio is
   *         negative, infinite or not a number.
   */
  explicit Geometric_points(const double epsilon = 0.1, const double ratio_of_weights = 0)
    : m_epsilon(internal::checked_epsilon(parameters::epsilon(epsilon))),
      m_expected_ratio(ratio_of_weights)
  {
    if(!(ratio_of_weights >= 0) || std::isinf(ratio_of_weights))
      internal::reject("the expected ratio of weights is " + internal::text_of(ratio_of_weights) +
                       "; it must be a finite number that is not negative");
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
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if `epsilon` is not a finite number above `0`.
   */
  template <typename T, typename Tag, typename Base>
  explicit Geometric_points(const Named_function_parameters<T, Tag, Base>& np)
    : m_epsilon(internal::checked_epsilon(np))
  {
    static_assert(!internal::is_any_given<Named_function_parameters<T, Tag, Base>,
                                          internal_np::number_of_points_per_edge_t,
                                          internal_np::nb_points_per_distance_unit_t>,
                  "Geometric_points reads epsilon, which says how many points there are: for a "
                  "number of your "
                  "own, use Fixed_number_of_points or Points_at_interval");
  }

  /// computes where the progressions of every vertex start. Run time is \cgalBigO{n}.
  void prepare(const Intrinsic_triangulation& triangulation)
  {
    const Index number_of_vertices = triangulation.number_of_vertices();
    std::vector<internal::Weight_spread> weights;
    weights.reserve(number_of_vertices);
    for(Index v = 0; v < number_of_vertices; ++v)
      weights.emplace_back(triangulation, v);
    const bool are_uniform = std::all_of(weights.begin(), weights.end(),
                                         [this](const auto& w) { return will_be_uniform(w); });
    m_epsilon_of_crossings = are_uniform ? m_epsilon : SHARE_OF_CROSSINGS * m_epsilon;

    m_start.resize(number_of_vertices);
    for(Index v = 0; v < number_of_vertices; ++v)
      m_start[v] = relative_start(weights[v]) * internal::Star(triangulation, v).radius();
  }

  /// returns the number of points on the edge of `h`.
  std::size_t number_of_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    return triangulation.is_crossable(h) ? progressions(triangulation, h).number_of_points() : 0;
  }

  /// writes the positions of these points to `positions`.
  void place(const Intrinsic_triangulation& triangulation,
             const Index h,
             float* positions,
             std::size_t /* number_of_points */) const
  {
    if(triangulation.is_crossable(h))
      progressions(triangulation, h).place(positions);
  }

  /// returns the bound that holds with the present weights of `triangulation`, which can have been
  /// exchanged; not less than what was asked for. Run time is \cgalBigO{n}.
  double epsilon(const Intrinsic_triangulation& triangulation) const
  {
    double of_crossings = m_epsilon_of_crossings, of_vicinities = 0;
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
    {
      const internal::Star star(triangulation, v);
      if(star.is_degenerate() || has_thin_corner(triangulation, v))
        return std::numeric_limits<double>::infinity();
      if(std::isinf(star.radius()) || star.radius() == 0) // no face, or all in one place
        continue;
      const double start = m_start[v] / star.radius();
      const internal::Weight_spread weights(triangulation, v);
      if(weights.are_uniform())
        of_crossings = (std::max)(of_crossings, std::expm1(-std::log1p(-4 * start * start) / 2));
      else
        of_vicinities = (std::max)(of_vicinities, 2 * start * weights.ratio() / (1 - 2 * start));
    }
    const double result = of_crossings + (1 + of_crossings / 2) * of_vicinities;
    constexpr double tolerance = 1e-9;
    return result <= m_epsilon * (1 + tolerance) ? m_epsilon : result;
  }

  /// returns the number of bytes that are stored per element of the mesh.
  std::size_t memory() const { return m_start.capacity() * sizeof(double); }

private:
  // If weights differ, what is left of epsilon is for passing vertices at some distance; this share
  // makes for about as few points as possible.
  static constexpr double SHARE_OF_CROSSINGS = 0.65;

  // what positions are rounded by can bring two neighbors apart
  static constexpr double ROUNDING_OF_LOGARITHM = 2.5e-7;

  // Where progressions start, in proportion to the radius of the star.
  double relative_start(const internal::Weight_spread& weights) const
  {
    constexpr double largest = 1. / 3;
    const double e = m_epsilon_of_crossings;
    if(will_be_uniform(weights))
      return (std::min)(std::sqrt(e * (2 + e)) / (2 * (1 + e)), largest);
    const double of_vicinities = (m_epsilon - e) / (1 + e / 2);
    const double ratio = (std::max)(weights.ratio(), m_expected_ratio);
    return of_vicinities / (2 * (ratio + of_vicinities));
  }

  bool will_be_uniform(const internal::Weight_spread& weights) const
  {
    return weights.are_uniform() && m_expected_ratio == 0;
  }

  // \pre The edge of `h` is not at the border, and longer than zero.
  internal::Geometric_progressions progressions(const Intrinsic_triangulation& triangulation,
                                                const Index h) const
  {
    const Index opposite = triangulation.opposite(h);
    const internal::Face_shape left(triangulation, h), right(triangulation, opposite);
    const double length = triangulation.length(h);
    return {end(m_start[triangulation.target(opposite)] / length,
                (std::min)(left.sine_of_corner(), right.sine_of_next_corner())),
            end(m_start[triangulation.target(h)] / length,
                (std::min)(right.sine_of_corner(), left.sine_of_next_corner()))};
  }

  internal::Geometric_progressions::End end(const double start, const double sine) const
  {
    constexpr double largest_start = 0.49;
    internal::Geometric_progressions::End result;
    result.start = (std::clamp)(start, SMALLEST_START, largest_start);
    result.sine = (std::max)(sine, SMALLEST_SINE);
    const double log_of_ratio = 2 * std::asinh(result.sine * std::sqrt(m_epsilon_of_crossings));
    result.log_of_ratio =
        (std::max)(log_of_ratio - ROUNDING_OF_LOGARITHM, log_of_ratio / 2); // of tiny ones
    if(sine < SMALLEST_SINE)
    {
      const double largest_number = LARGEST_NUMBER_IF_THIN / std::sqrt(m_epsilon_of_crossings);
      result.log_of_ratio =
          (std::max)(result.log_of_ratio, -std::log(result.start) / largest_number);
    }
    return result;
  }

  // whether points around `v` are not as they should be
  static bool has_thin_corner(const Intrinsic_triangulation& triangulation, const Index v)
  {
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
      if(!triangulation.is_border(h) && !std::isinf(triangulation.weight(h)) &&
         internal::Face_shape(triangulation, h).sine_of_corner() < SMALLEST_SINE)
        return true;
    return false;
  }

  double m_epsilon;
  double m_expected_ratio = 0;       // of weights, or 0
  double m_epsilon_of_crossings = 0; // as far as paths are straight
  std::vector<double> m_start;       // of the progressions at a vertex: the distance from it
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_GEOMETRIC_POINTS_H
