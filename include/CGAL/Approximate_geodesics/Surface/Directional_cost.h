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
 * A cost function as a value of the named parameter `face_weight_map`, as `directional_cost()`
 * returns it.
 *
 * \tparam CostFunction a model of `DirectionalCostFunction`
 */
template <typename CostFunction>
class Directional_cost
{
public:
  /// stores a copy of the function.
  explicit Directional_cost(CostFunction function) : m_function(std::move(function)) {}

  /// returns the result of the function.
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
 * The cost function of ways back: it calls another one with the opposite direction.
 *
 * \cgalModels{DirectionalCostFunction}
 */
template <typename CostFunction>
class Reversed_cost
{
public:
  /// stores a copy of the function.
  explicit Reversed_cost(CostFunction function) : m_function(std::move(function)) {}

  /// returns the cost of the opposite direction.
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
 * returns a value of the named parameter `face_weight_map` for costs that depend on the direction:
 * `face_weight_map(directional_cost(f))`.
 *
 * The function is called when the mesh is read, for each face and in some 20 to 200 directions in
 * its plane. Paths have the costs of the largest convex gauge below the function: where a function
 * is not convex, zigzags are cheaper than straight lines, and their cost counts.
 *
 * Gauges of convex functions are exact in the directions of the edges. Elsewhere they are too high
 * by at most a tenth of `epsilon`, if that is given, and else by at most 1 %. The exception are
 * functions whose values differ by a factor of about \f$10^5\f$ or more in a face, as no more
 * directions are added to 2048, nor between directions that are \f$10^{-5}\f$ apart.
 * `Directional_graph::sampling_error()` returns the error bound in any case, and the bound of
 * `Directional_points` includes it. Each direction takes 32 bytes, unless zigzags make it
 * redundant.
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
 * returns the cost function of ways back. With it, distances from a source are those to the source
 * with the original function, to the last bit. The named parameter `direction_to_source` has the
 * same effect.
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

// Whether named parameters contain costs that depend on the direction.
template <typename NamedParameters>
constexpr bool has_directional_cost =
    Is_directional_cost<std::decay_t<decltype(parameters::get_parameter(
        std::declval<const NamedParameters&>(), internal_np::face_weight))>>::value;

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_DIRECTIONAL_COST_H
