// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_EQUAL_PARTS_H
#define CGAL_GEODESIC_COSTS_EQUAL_PARTS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Approximate_geodesics {

namespace internal {

// The common base of models of `SteinerPointPlacement` that divide each edge into equal parts.
class Equal_parts
{
public:
  using Index = Intrinsic_triangulation::Index;
  static constexpr bool makes_equal_parts = true;

  void prepare(const Intrinsic_triangulation& /* triangulation */,
               std::size_t /* maximum_number_of_points */)
  {
  }

  double epsilon(const Intrinsic_triangulation& /* triangulation */) const
  {
    return std::numeric_limits<double>::infinity();
  }

  std::size_t memory() const { return 0; }

protected:
  template <typename NamedParameters>
  static void reject_limits()
  {
    static_assert(!limits_points<NamedParameters>,
                  "maximum_number_of_points_per_edge, accept_weaker_bound: they are for "
                  "Geometric_points");
  }
};

} // namespace internal

/*!
 * \ingroup PkgGeodesicCostsPlacements
 *
 * The same number of points on every edge, which divide it into equal parts.
 *
 * There is no bound, `epsilon()` is infinity: between two slivers, a path can be longer than the
 * geodesic by any factor. On scanned models the mean error falls from 1.4 % with one point per edge
 * to 0.2 % with eight. Without any points, the paths are those along edges.
 *
 * \cgalModels{SteinerPointPlacement}
 */
class Fixed_number_of_points : public internal::Equal_parts
{
public:
  /// places this number of points on every edge.
  explicit Fixed_number_of_points(const std::size_t number_of_points_per_edge = 3)
    : m_number_of_points(number_of_points_per_edge)
  {
  }

  /*!
   * reads the number of points from named parameters.
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{number_of_points_per_edge}
   *     \cgalParamDescription{the number of points on every edge}
   *     \cgalParamType{an integer type}
   *     \cgalParamDefault{`3`}
   *     \cgalParamExtra{A chain that starts with this parameter cannot be continued with those of
   *                     this package, see \ref AG_chains.}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if the number is negative or not an integer.
   */
  template <typename T, typename Tag, typename Base>
  explicit Fixed_number_of_points(const Named_function_parameters<T, Tag, Base>& np)
  {
    static_assert(
        !internal::is_any_given<Named_function_parameters<T, Tag, Base>, internal_np::epsilon_t,
                                internal_np::nb_points_per_distance_unit_t>,
        "Fixed_number_of_points reads number_of_points_per_edge, and gives no bound: for "
        "epsilon, use Geometric_points");
    reject_limits<Named_function_parameters<T, Tag, Base>>();
    constexpr double too_many = 4294967296; // nodes, on a single edge
    const double number = CGAL::to_double(parameters::choose_parameter(
        parameters::get_parameter(np, internal_np::number_of_points_per_edge), 3));
    if(!(number >= 0) || number != std::floor(number) || number > too_many)
      internal::reject("the number of points per edge is " + internal::text_of(number) +
                       "; it must be an integer from 0 to 2^32");
    m_number_of_points = static_cast<std::size_t>(number);
  }

  /// returns the number of points on the edge of a halfedge.
  std::size_t number_of_points(const Intrinsic_triangulation& /* triangulation */,
                               Index /* halfedge */) const
  {
    return m_number_of_points;
  }

private:
  std::size_t m_number_of_points;
};

/*!
 * \ingroup PkgGeodesicCostsPlacements
 *
 * Points that divide every edge into equal parts, as few as possible so that no part is longer than
 * a given spacing. Small faces get few points, and large ones more, which suits meshes of
 * mechanical parts.
 *
 * There is no bound, `epsilon()` is infinity: paths that cross faces thinner than the spacing can
 * be longer than the geodesics by any factor.
 *
 * \cgalModels{SteinerPointPlacement}
 */
class Points_at_interval : public internal::Equal_parts
{
public:
  /// places points at distances of at most `spacing`, in the unit of the mesh.
  /// \throws std::invalid_argument if `spacing` is not a number above `0`.
  explicit Points_at_interval(const double spacing) : m_spacing(spacing)
  {
    if(!(spacing > 0))
      internal::reject("the spacing of points on edges is " + internal::text_of(spacing) +
                       "; it must be a number larger than 0");
  }

  /*!
   * reads the density from named parameters.
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{number_of_points_per_distance_unit}
   *     \cgalParamDescription{the density of the points on edges: one divided by the spacing}
   *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
   *     \cgalParamDefault{there is none, it has to be given}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if the density is not a finite number above `0`.
   */
  template <typename T, typename Tag, typename Base>
  explicit Points_at_interval(const Named_function_parameters<T, Tag, Base>& np)
    : m_spacing(1 / checked_density(np))
  {
  }

  /// returns the number of points on the edge of `h`.
  std::size_t number_of_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    constexpr double too_many = 1e18; // still fits an integer
    const double number_of_parts =
        std::ceil(triangulation.length(h) * (triangulation.unit() / m_spacing));
    return static_cast<std::size_t>((std::clamp)(number_of_parts - 1, 0., too_many));
  }

private:
  template <typename NamedParameters>
  static double checked_density(const NamedParameters& np)
  {
    static_assert(internal::is_given<NamedParameters, internal_np::nb_points_per_distance_unit_t>,
                  "Points_at_interval: number_of_points_per_distance_unit has to be given");
    static_assert(
        !internal::is_any_given<NamedParameters, internal_np::epsilon_t,
                                internal_np::number_of_points_per_edge_t>,
        "Points_at_interval reads number_of_points_per_distance_unit, and gives no bound: "
        "for epsilon, use Geometric_points; for number_of_points_per_edge, "
        "Fixed_number_of_points");
    reject_limits<NamedParameters>();
    return internal::checked_positive(
        CGAL::to_double(parameters::get_parameter(np, internal_np::nb_points_per_distance_unit)),
        "the number of points per distance unit");
  }

  double m_spacing;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_EQUAL_PARTS_H
