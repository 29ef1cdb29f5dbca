// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_NAMED_PARAMETERS_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_NAMED_PARAMETERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>
#include <CGAL/version.h>

#include <functional>
#include <limits>
#include <ratio>
#include <type_traits>

// The named parameters of this package. Inside CGAL, each of them would be one line in
// CGAL/STL_Extension/internal/parameters_interface.h, and this file would be unnecessary. Outside,
// CGAL's parameter chain cannot be extended. So a chain that starts with a parameter of this
// package has its own type, which derives from CGAL's and offers the parameters of both. A chain
// that starts with a parameter of CGAL requires `parameters::combine()`.

#define CGAL_APPROXIMATE_GEODESICS_FOR_EACH_NEW_PARAMETER(APPLY)                                   \
  APPLY(accept_weaker_bound_t, accept_weaker_bound, accept_weaker_bound)                           \
  APPLY(chord_error_t, chord_error, chord_error)                                                   \
  APPLY(direction_to_source_t, direction_to_source, direction_to_source)                           \
  APPLY(edge_length_t, edge_length, edge_length_map)                                               \
  APPLY(epsilon_t, epsilon, epsilon)                                                               \
  APPLY(face_weight_t, face_weight, face_weight_map)                                               \
  APPLY(heights_t, heights, heights)                                                               \
  APPLY(max_slope_t, max_slope, max_slope)                                                         \
  APPLY(maximum_number_of_points_t, maximum_number_of_points, maximum_number_of_points)            \
  APPLY(maximum_number_of_points_per_edge_t, maximum_number_of_points_per_edge,                    \
        maximum_number_of_points_per_edge)                                                         \
  APPLY(relative_tolerance_t, relative_tolerance, relative_tolerance)                              \
  APPLY(initial_distances_t, initial_distances, initial_distances)                                 \
  APPLY(signed_distances_t, signed_distances, signed_distances)                                    \
  APPLY(straighten_t, straighten, straighten)                                                      \
  APPLY(symmetric_t, symmetric, symmetric)                                                         \
  APPLY(targets_t, targets, targets)                                                               \
  APPLY(nearest_source_t, nearest_source, nearest_source_map)                                      \
  APPLY(geodesic_predecessor_t, geodesic_predecessor, predecessor_map)

// Parameters that newer versions of CGAL provide.
#if CGAL_VERSION_NR < 1050601000
#define CGAL_APPROXIMATE_GEODESICS_MAXIMUM_DISTANCE(APPLY)                                         \
  APPLY(maximum_distance_t, maximum_distance, maximum_distance)
#else
#define CGAL_APPROXIMATE_GEODESICS_MAXIMUM_DISTANCE(APPLY)
#endif

#if CGAL_VERSION_NR < 1060001000
#define CGAL_APPROXIMATE_GEODESICS_CONCURRENCY_TAG(APPLY)                                          \
  APPLY(concurrency_tag_t, concurrency_tag, concurrency_tag)
#else
#define CGAL_APPROXIMATE_GEODESICS_CONCURRENCY_TAG(APPLY)
#endif

// Parameters of CGAL that affect results.
#define CGAL_APPROXIMATE_GEODESICS_FOR_EACH_OF_CGAL(APPLY)                                         \
  APPLY(edge_is_constrained_t, edge_is_constrained, edge_is_constrained_map)                       \
  APPLY(maximum_distance_t, maximum_distance, maximum_distance)                                    \
  APPLY(number_of_points_per_edge_t, number_of_points_per_edge, number_of_points_per_edge)         \
  APPLY(nb_points_per_distance_unit_t, nb_points_per_distance_unit,                                \
        number_of_points_per_distance_unit)                                                        \
  APPLY(visitor_t, visitor, visitor)

#define CGAL_APPROXIMATE_GEODESICS_FOR_EACH_PARAMETER(APPLY)                                       \
  CGAL_APPROXIMATE_GEODESICS_FOR_EACH_NEW_PARAMETER(APPLY)                                         \
  CGAL_APPROXIMATE_GEODESICS_MAXIMUM_DISTANCE(APPLY)                                               \
  CGAL_APPROXIMATE_GEODESICS_CONCURRENCY_TAG(APPLY)

namespace CGAL {

namespace internal_np {

#define CGAL_APPROXIMATE_GEODESICS_TAG(TAG, VALUE, NAME)                                           \
  enum TAG                                                                                         \
  {                                                                                                \
    VALUE                                                                                          \
  };
CGAL_APPROXIMATE_GEODESICS_FOR_EACH_PARAMETER(CGAL_APPROXIMATE_GEODESICS_TAG)
#undef CGAL_APPROXIMATE_GEODESICS_TAG

} // namespace internal_np

namespace Approximate_geodesics::internal {

/*
 * A chain of named parameters that can be continued with those of this package and of CGAL, in any
 * order. Only the outermost link has this type and the inner ones are CGAL's, so that CGAL's
 * functions accept the chain: among several matching base classes, the nearest is deduced (CWG
 * 2303).
 */
template <typename T, typename Tag, typename Base = internal_np::No_property>
struct Named_parameters : Named_function_parameters<T, Tag, Base>
{
  using Cgal_parameters = Named_function_parameters<T, Tag, Base>;
  using Cgal_parameters::Cgal_parameters;

  template <typename NewTag, typename K>
  Named_parameters<K, NewTag, Cgal_parameters> append(const K& k) const
  {
    return Named_parameters<K, NewTag, Cgal_parameters>(k, *this);
  }

#define CGAL_add_named_parameter(TAG, VALUE, NAME)                                                 \
  template <typename K>                                                                            \
  auto NAME(const K& k) const                                                                      \
  {                                                                                                \
    return this->template append<internal_np::TAG>(k);                                             \
  }
#define CGAL_add_named_parameter_with_compatibility CGAL_add_named_parameter
#define CGAL_add_extra_named_parameter_with_compatibility CGAL_add_named_parameter
#define CGAL_add_named_parameter_with_compatibility_cref_only(TAG, VALUE, NAME)                    \
  template <typename K>                                                                            \
  auto NAME(const K& k) const                                                                      \
  {                                                                                                \
    return this->template append<internal_np::TAG>(std::cref(k));                                  \
  }
#define CGAL_add_named_parameter_with_compatibility_ref_only(TAG, VALUE, NAME)                     \
  template <typename K>                                                                            \
  auto NAME(K& k) const                                                                            \
  {                                                                                                \
    return this->template append<internal_np::TAG>(std::ref(k));                                   \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
  CGAL_APPROXIMATE_GEODESICS_FOR_EACH_PARAMETER(CGAL_add_named_parameter)
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
};

template <typename NamedParameters, typename Tag>
constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

template <typename T, typename Tag, typename Base>
std::true_type is_named_parameters_test(const Named_function_parameters<T, Tag, Base>*);
std::false_type is_named_parameters_test(...);

// Distinguishes named parameters from another last argument.
template <typename T>
constexpr bool is_named_parameters =
    decltype(is_named_parameters_test(static_cast<const T*>(nullptr)))::value;

// The concurrency tag; sequential by default.
template <typename NamedParameters>
using Concurrency_tag = typename internal_np::
    Lookup_named_param_def<internal_np::concurrency_tag_t, NamedParameters, Sequential_tag>::type;

// Whether a number is known at compile time to be zero, or not to be: only if it is a `std::ratio`.
template <typename Number>
constexpr bool is_zero = false;
template <typename Number>
constexpr bool is_nonzero = false;
template <std::intmax_t NUMERATOR, std::intmax_t DENOMINATOR>
constexpr bool is_zero<std::ratio<NUMERATOR, DENOMINATOR>> = NUMERATOR == 0;
template <std::intmax_t NUMERATOR, std::intmax_t DENOMINATOR>
constexpr bool is_nonzero<std::ratio<NUMERATOR, DENOMINATOR>> = NUMERATOR != 0;

template <typename Number>
double value_of_number([[maybe_unused]] const Number& number)
{
  if constexpr(is_zero<Number> || is_nonzero<Number>)
    return static_cast<double>(Number::num) / static_cast<double>(Number::den);
  else
    return CGAL::to_double(number);
}

// The distance beyond which nothing is reached: infinity by default.
template <typename NamedParameters>
double maximum_distance(const NamedParameters& np)
{
  return CGAL::to_double(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_distance),
                                   std::numeric_limits<double>::infinity()));
}

template <typename NamedParameters, typename... Tags>
constexpr bool is_any_given = (is_given<NamedParameters, Tags> || ...);

// Whether a function that reads the parameters `Read` would ignore a given parameter of this
// package, or one of CGAL's that affects results. Ignoring `concurrency_tag`, or a parameter that
// describes the mesh, such as an index map, is harmless.
#define CGAL_APPROXIMATE_GEODESICS_OR_IGNORED(TAG, VALUE, NAME)                                    \
  || (is_given<NamedParameters, internal_np::TAG> &&                                               \
      !(std::is_same_v<internal_np::TAG, Read> || ...))
template <typename NamedParameters, typename... Read>
constexpr bool ignores_any =
    false CGAL_APPROXIMATE_GEODESICS_FOR_EACH_NEW_PARAMETER(CGAL_APPROXIMATE_GEODESICS_OR_IGNORED)
        CGAL_APPROXIMATE_GEODESICS_FOR_EACH_OF_CGAL(CGAL_APPROXIMATE_GEODESICS_OR_IGNORED);
#undef CGAL_APPROXIMATE_GEODESICS_OR_IGNORED

// Whether paths cost more or less than their length, or must not go everywhere.
template <typename NamedParameters>
constexpr bool has_costs = is_any_given<NamedParameters,
                                        internal_np::face_weight_t,
                                        internal_np::max_slope_t,
                                        internal_np::edge_is_constrained_t>;

// Reports parameters of the package of costs in one line each, unless it is included.
template <typename NamedParameters, bool IS_INCLUDED>
void check_costs()
{
  static_assert(IS_INCLUDED || !is_given<NamedParameters, internal_np::face_weight_t>,
                "face_weight_map: include <CGAL/Geodesic_costs.h>");
  static_assert(IS_INCLUDED || !is_given<NamedParameters, internal_np::max_slope_t>,
                "max_slope: include <CGAL/Geodesic_costs.h>");
  static_assert(IS_INCLUDED || !is_given<NamedParameters, internal_np::edge_is_constrained_t>,
                "edge_is_constrained_map: include <CGAL/Geodesic_costs.h>");
  static_assert(IS_INCLUDED || !is_given<NamedParameters, internal_np::number_of_points_per_edge_t>,
                "number_of_points_per_edge: include <CGAL/Geodesic_costs.h>");
}

// Appends the links of `second`, innermost first, to `first`.
template <typename First, typename T, typename Tag, typename Base>
auto append_parameters(const First& first, const Named_function_parameters<T, Tag, Base>& second)
{
  using Value = std::decay_t<decltype(second.v)>;
  if constexpr(std::is_same_v<Base, internal_np::No_property>)
    return Named_function_parameters<Value, Tag, First>(second.v, first);
  else
  {
    const auto chain = append_parameters(first, static_cast<const Base&>(second));
    return Named_function_parameters<Value, Tag, std::decay_t<decltype(chain)>>(second.v, chain);
  }
}

} // namespace Approximate_geodesics::internal

namespace parameters {

#define CGAL_APPROXIMATE_GEODESICS_FUNCTION(TAG, VALUE, NAME)                                      \
  template <typename K>                                                                            \
  auto NAME(const K& k)                                                                            \
  {                                                                                                \
    return Approximate_geodesics::internal::Named_parameters<K, internal_np::TAG>(k);              \
  }
CGAL_APPROXIMATE_GEODESICS_FOR_EACH_PARAMETER(CGAL_APPROXIMATE_GEODESICS_FUNCTION)
#undef CGAL_APPROXIMATE_GEODESICS_FUNCTION

/*!
 * \ingroup PkgApproximateGeodesicsFunctions
 *
 * concatenates two or more chains of named parameters of this package and of \cgal.
 *
 * A chain that starts with a named parameter of this package can be continued with any other; a
 * chain that starts with a parameter of \cgal cannot be continued with a parameter of this package.
 * In this case, combine two chains: `combine(vertex_point_map(vpm).verbose(true), targets(range))`.
 *
 * \return a sequence of \ref bgl_namedparameters "Named Parameters" that contains the parameters of
 *         all arguments.
 */
template <typename T, typename Tag, typename Base, typename... NamedParameters>
auto combine(const Named_function_parameters<T, Tag, Base>& first,
             const NamedParameters&... further)
{
  if constexpr(sizeof...(further) == 0)
    return first;
  else
    return Approximate_geodesics::internal::append_parameters(first, combine(further...));
}

} // namespace parameters
} // namespace CGAL

#undef CGAL_APPROXIMATE_GEODESICS_FOR_EACH_NEW_PARAMETER
#undef CGAL_APPROXIMATE_GEODESICS_MAXIMUM_DISTANCE
#undef CGAL_APPROXIMATE_GEODESICS_CONCURRENCY_TAG
#undef CGAL_APPROXIMATE_GEODESICS_FOR_EACH_OF_CGAL
#undef CGAL_APPROXIMATE_GEODESICS_FOR_EACH_PARAMETER

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_NAMED_PARAMETERS_H
