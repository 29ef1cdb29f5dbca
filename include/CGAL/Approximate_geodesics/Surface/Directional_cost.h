// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_DIRECTIONAL_COST_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_DIRECTIONAL_COST_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>

#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * A cost function as a value of the named parameter `face_weight_map`: `directional_cost()` makes
 * it.
 *
 * \tparam CostFunction a model of `DirectionalCostFunction`
 */
template <typename CostFunction>
class Directional_cost
{
public:
  /// takes a copy of the function.
  explicit Directional_cost(CostFunction function) : m_function(std::move(function)) {}

  /// returns what the function does.
  template <typename Face, typename Vector_3>
  double operator()(const Face& face, const Vector_3& direction) const
  {
    return static_cast<double>(m_function(face, direction));
  }

private:
  CostFunction m_function;
};

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * A cost function for the ways back: a model of `DirectionalCostFunction`, which asks another one
 * for the opposite direction.
 */
template <typename CostFunction>
class Reversed_cost
{
public:
  /// takes a copy of the function.
  explicit Reversed_cost(CostFunction function) : m_function(std::move(function)) {}

  /// returns what going the other way costs.
  template <typename Face, typename Vector_3>
  double operator()(const Face& face, const Vector_3& direction) const
  {
    return static_cast<double>(m_function(face, -direction));
  }

private:
  CostFunction m_function;
};

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * makes a value of the named parameter `face_weight_map` for costs that depend on where one goes:
 * `face_weight_map(directional_cost(f))`.
 *
 * The function is called when the mesh is read, for each face and in some 20 to 200 directions in
 * its plane. What paths cost is the largest convex gauge below these costs: where a function is not
 * convex, zigzags are cheaper than straight lines, and their cost is the one that counts. Gauges of
 * convex functions are too high by a tenth of `epsilon` at most, if that is given, and else by 1 %.
 * They are exact in the directions of the edges. Each direction takes 32 bytes, but for those that
 * zigzags make needless.
 *
 * \param f a model of `DirectionalCostFunction`
 */
template <typename CostFunction>
Directional_cost<CostFunction> directional_cost(CostFunction f)
{
  return Directional_cost<CostFunction>(std::move(f));
}

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * makes a cost function for the ways back, of one for the ways there. Distances from a source are
 * then those to it, to the last bit; the named parameter `direction_to_source` is another way to
 * get these.
 */
template <typename CostFunction>
Reversed_cost<CostFunction> reversed_cost(CostFunction f)
{
  return Reversed_cost<CostFunction>(std::move(f));
}

namespace internal {

template <typename T>
struct Is_directional_cost : std::false_type
{
};

template <typename F>
struct Is_directional_cost<Directional_cost<F>> : std::true_type
{
};

// Whether named parameters give costs that depend on the direction.
template <typename NamedParameters>
constexpr bool has_directional_cost =
    Is_directional_cost<std::decay_t<decltype(parameters::get_parameter(
        std::declval<const NamedParameters&>(), internal_np::face_weight))>>::value;

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_DIRECTIONAL_COST_H
