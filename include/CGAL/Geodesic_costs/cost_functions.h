// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_COST_FUNCTIONS_H
#define CGAL_GEODESIC_COSTS_COST_FUNCTIONS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics {

namespace internal {

struct Cost_formulas;

// Returns the gain in height per unit of horizontal length; infinity for a vertical direction.
template <typename Vector_3>
double slope(const Vector_3& direction)
{
  const auto [x, y, z] = space_vector(direction);
  const double run = std::sqrt(x * x + y * y);
  return run > 0 ? z / run : std::copysign(infinity, z);
}

// Whether a cost function can be called with a slope alone.
template <typename CostFunction>
constexpr bool is_cost_of_slope = std::is_invocable_v<const CostFunction&, double>;

} // namespace internal

/*!
 * \ingroup PkgGeodesicCostsFunctions
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
    if constexpr(std::is_invocable_v<const CostFunction&, const Face&, const Vector_3&>)
      return static_cast<double>(m_function(face, direction));
    else
      return static_cast<double>(m_function(internal::slope(direction)));
  }

  /// returns the result of a function of the slope.
  template <typename F = CostFunction, typename = std::enable_if_t<internal::is_cost_of_slope<F>>>
  double operator()(const double slope) const
  {
    return static_cast<double>(m_function(slope));
  }

private:
  friend struct internal::Cost_formulas;

  CostFunction m_function;
};

/*!
 * \ingroup PkgGeodesicCostsFunctions
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

  /// returns the cost of the opposite slope, of a function of the slope.
  template <typename F = CostFunction, typename = std::enable_if_t<internal::is_cost_of_slope<F>>>
  double operator()(const double slope) const
  {
    return static_cast<double>(m_function(-slope));
  }

private:
  friend struct internal::Cost_formulas;

  CostFunction m_function;
};

/*!
 * \ingroup PkgGeodesicCostsFunctions
 *
 * returns a value of the named parameter `face_weight_map` for costs that depend on the direction:
 * `face_weight_map(directional_cost(f))`.
 *
 * Paths have the costs of the largest convex gauge below the function: where a function is not
 * convex, zigzags are cheaper than straight lines, and their cost counts. In particular, infinity
 * for a direction forbids only to walk straight on in it; zigzags may follow it at a finite cost.
 * The named parameter `max_slope` limits slopes without such a way around. This gauge is known in
 * closed form for `Hiking_time`, `Walking_energy`, `Drift_time` where the drift is slower than the
 * boat, `Tensor_cost` with matrices that are positive definite, and for each of them in a
 * `Reversed_cost`. It takes 48 bytes a face, and is exact.
 *
 * Any other function is called when the mesh is read, for each face and in some 20 to 200
 * directions in its plane. Gauges of convex functions are exact in the directions of the edges.
 * Elsewhere they are too high by at most a tenth of `epsilon`, if that is given, and else by at
 * most 1 %. The exception are functions whose values differ by a factor of about \f$10^5\f$ or more
 * in a face, as no more directions are added to 2048, nor between directions that are \f$10^{-5}\f$
 * apart. `Directional_graph::sampling_error()` returns the error bound in any case, and the bound
 * of `Directional_points` includes it. Each direction takes 32 bytes, unless zigzags make it
 * redundant.
 *
 * \param f a model of `DirectionalCostFunction`, or a function `f(s)` of the slope: of `s` units of
 *        height per horizontal unit
 */
template <typename CostFunction>
Directional_cost<CostFunction> directional_cost(CostFunction f)
{
  return Directional_cost<CostFunction>(std::move(f));
}

/*!
 * \ingroup PkgGeodesicCostsFunctions
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
constexpr bool is_directional_cost = false;

template <typename F>
constexpr bool is_directional_cost<Directional_cost<F>> = true;

// Whether named parameters contain a cost function of the direction.
template <typename NamedParameters>
constexpr bool has_cost_function =
    is_directional_cost<std::decay_t<decltype(parameters::get_parameter(
        std::declval<const NamedParameters&>(), internal_np::face_weight))>>;

// Whether costs depend on the direction, as they also do if the slope is limited.
template <typename NamedParameters>
constexpr bool has_directional_cost =
    has_cost_function<NamedParameters> || is_given<NamedParameters, internal_np::max_slope_t>;

} // namespace internal

/*!
 * \ingroup PkgGeodesicCostsFunctions
 *
 * The walking time on slopes, in seconds per meter of surface length, by Tobler's hiking function
 * \cgalCite{t-tpgam-93}: the speed is \f$6\,e^{-3.5\,|s + 0.05|}\f$ kilometers per hour for a slope
 * of \f$s\f$ meters of height per horizontal meter. The maximum, 6 km/h, is slightly downhill.
 *
 * The mesh is in meters, with the z axis upward. Slopes steeper than about 27 %, uphill and
 * downhill, are traversed in zigzags of that slope, which takes less time than the straight path.
 *
 * \cgalModels{DirectionalCostFunction}
 */
class Hiking_time
{
public:
  /// constructs the cost function, with all speeds multiplied by `factor`. Tobler's function is for
  /// footpaths; he suggests `0.6` off paths, and `1.25` on horseback.
  /// \throws std::invalid_argument if `factor` is not a finite number above `0`.
  explicit Hiking_time(const double factor = 1)
    : m_factor(internal::checked_positive(factor, "the factor of hiking speeds"))
  {
  }

  /// returns the time per unit of length in a direction, in seconds per meter.
  template <typename Face, typename Vector_3>
  double operator()(const Face& /* face */, const Vector_3& direction) const
  {
    return (*this)(internal::slope(direction));
  }

  /// returns the time per unit of length on a slope, in seconds per meter.
  double operator()(const double slope) const
  {
    return 0.6 / m_factor * std::exp(3.5 * std::abs(slope + 0.05));
  }

private:
  friend struct internal::Cost_formulas;

  double m_factor;
};

/*!
 * \ingroup PkgGeodesicCostsFunctions
 *
 * The energy of walking on slopes, in joules per kilogram of body mass and meter of surface length,
 * as measured by Minetti, Moia, Roi, Susta and Ferretti \cgalCite{mmrsf-ecwre-02}:
 * \f$280.5\,s^5 - 58.7\,s^4 - 76.8\,s^3 + 51.9\,s^2 + 19.6\,s + 2.5\f$ for a slope of \f$s\f$
 * meters of height per horizontal meter. The minimum is at about -15 %.
 *
 * The mesh is in meters, with the z axis upward. The measurements cover slopes of up to 45 %;
 * steeper directions have infinite cost, and steep faces are climbed in zigzags, unless `max_slope`
 * forbids it.
 *
 * \cgalModels{DirectionalCostFunction}
 */
class Walking_energy
{
public:
  /// the steepest measured slope.
  static constexpr double STEEPEST_SLOPE = 0.45;

  /// returns the energy per unit of length in a direction, in joules per kilogram and meter.
  template <typename Face, typename Vector_3>
  double operator()(const Face& /* face */, const Vector_3& direction) const
  {
    return (*this)(internal::slope(direction));
  }

  /// returns the energy per unit of length on a slope, in joules per kilogram and meter.
  double operator()(const double s) const
  {
    return std::abs(s) <= STEEPEST_SLOPE ? energy(s) : internal::infinity;
  }

private:
  friend struct internal::Cost_formulas;

  static double energy(const double s)
  {
    return ((((280.5 * s - 58.7) * s - 76.8) * s + 51.9) * s + 19.6) * s + 2.5;
  }
};

/*!
 * \ingroup PkgGeodesicCostsFunctions
 *
 * The walking time on slopes, in seconds per meter of surface length, by Naismith's rule with
 * Langmuir's corrections \cgalCite{l-ml-84}, as the module `r.walk` of GRASS has it: 0.72 seconds
 * per horizontal meter and 6 seconds per meter of ascent; a descent of up to 12 degrees, a slope of
 * 0.2125, saves 2 seconds per meter of height, and a steeper one costs as much.
 *
 * The mesh is in meters, with the z axis upward. Steep descents are made in zigzags of 12 degrees.
 *
 * \cgalModels{DirectionalCostFunction}
 */
class Naismith_time
{
public:
  /// the steepest descent that saves time.
  static constexpr double STEEPEST_GENTLE_DESCENT = 0.2125;

  /// constructs the cost function.
  /// \param pace the seconds per horizontal meter
  /// \param ascent the seconds per meter of ascent
  /// \throws std::invalid_argument if `pace` is below `0.425`, as descents would take no time, or
  ///         `ascent` is negative, or if one of them is not a finite number.
  explicit Naismith_time(const double pace = 0.72, const double ascent = 6)
    : m_pace(internal::checked_positive(pace, "the pace")), m_ascent(ascent)
  {
    if(pace < OF_DESCENT * STEEPEST_GENTLE_DESCENT)
      internal::reject("the pace is " + internal::text_of(pace) +
                       " seconds per meter; it must be at least 0.425");
    if(!(ascent >= 0) || std::isinf(ascent))
      internal::reject("the time of ascents is " + internal::text_of(ascent) +
                       "; it must be a finite number that is not negative");
  }

  /// returns the time per unit of length in a direction, in seconds per meter.
  template <typename Face, typename Vector_3>
  double operator()(const Face& /* face */, const Vector_3& direction) const
  {
    return (*this)(internal::slope(direction));
  }

  /// returns the time per unit of length on a slope, in seconds per meter.
  double operator()(const double slope) const
  {
    const double per_height = slope >= 0                          ? m_ascent
                              : slope >= -STEEPEST_GENTLE_DESCENT ? -OF_DESCENT
                                                                  : OF_DESCENT;
    if(std::isinf(slope))
      return per_height;
    return (m_pace + per_height * std::abs(slope)) / std::hypot(1, slope);
  }

private:
  static constexpr double OF_DESCENT = 2; // seconds per meter of height

  double m_pace, m_ascent;
};

/*!
 * \ingroup PkgGeodesicCostsFunctions
 *
 * The travel time per unit of length in a current or a wind: Zermelo's navigation problem
 * \cgalCite{z-nbrwv-31}. A boat or an airplane moves with the speed \f$v\f$ relative to a medium
 * that drifts with the velocity \f$w\f$, which is constant in each face. Its ground speed in the
 * direction \f$d\f$ is \f$d\cdot w + \sqrt{v^2 - |w|^2 + (d\cdot w)^2}\f$.
 *
 * If the drift is faster than the boat, unattainable directions have infinite cost.
 *
 * \tparam FaceVectorMap a model of `ReadablePropertyMap` with faces as key type and a `%Vector_3`
 *         as value type
 *
 * \cgalModels{DirectionalCostFunction}
 */
template <typename FaceVectorMap>
class Drift_time
{
public:
  /// constructs the cost function from the drift velocities and the speed of the boat, in the same
  /// unit.
  /// \pre Each velocity lies in the plane of its face; a normal component increases the cost.
  /// \throws std::invalid_argument if `speed` is not a finite number above `0`.
  Drift_time(FaceVectorMap drift, const double speed)
    : m_drift(std::move(drift)),
      m_speed(internal::checked_positive(speed, "the speed through the drift"))
  {
  }

  /// returns the time per unit of length in a direction.
  template <typename Face, typename Vector_3>
  double operator()(const Face& face, const Vector_3& direction) const
  {
    const auto& drift = get(m_drift, face);
    const double ahead = CGAL::to_double(drift * direction);
    const double square = CGAL::to_double(drift * drift);
    const double radicand = m_speed * m_speed - square + ahead * ahead;
    const double progress = radicand < 0 ? 0 : ahead + std::sqrt(radicand);
    return progress <= 0 ? internal::infinity : 1 / progress;
  }

private:
  friend struct internal::Cost_formulas;

  FaceVectorMap m_drift;
  double m_speed;
};

/*!
 * \ingroup PkgGeodesicCostsFunctions
 *
 * A Riemannian metric that is constant in each face, given by one metric tensor per face: in the
 * direction \f$d\f$, a path costs \f$\sqrt{d^T A\,d}\f$ per unit of length, where \f$A\f$ is a
 * symmetric matrix.
 *
 * If a matrix is not finite, or not positive semidefinite in the plane of its face, beyond
 * rounding, costs are NaN, and reading the mesh fails.
 *
 * \tparam FaceTensorMap a model of `ReadablePropertyMap` with faces as key type and as value type
 *         `std::array<double, 6>`: the entries xx, xy, xz, yy, yz and zz of the matrix
 *
 * \cgalModels{DirectionalCostFunction}
 */
template <typename FaceTensorMap>
class Tensor_cost
{
public:
  /// constructs the cost function from the tensors.
  explicit Tensor_cost(FaceTensorMap tensors) : m_tensors(std::move(tensors)) {}

  /// returns the cost per unit of length in a direction.
  template <typename Face, typename Vector_3>
  double operator()(const Face& face, const Vector_3& direction) const
  {
    const std::array<double, 6> a = get(m_tensors, face);
    const auto [x, y, z] = internal::space_vector(direction);
    const double square = a[0] * x * x + a[3] * y * y + a[5] * z * z +
                          2 * (a[1] * x * y + a[2] * x * z + a[4] * y * z);
    return std::isfinite(square) ? std::sqrt(square) : std::numeric_limits<double>::quiet_NaN();
  }

private:
  friend struct internal::Cost_formulas;

  FaceTensorMap m_tensors;
};

/*!
 * \ingroup PkgGeodesicCostsFunctions
 *
 * A cost function that restricts the directions in each face to those close to a given direction.
 * All others have infinite cost, so paths have no error bound `epsilon`.
 *
 * \tparam FaceVectorMap a model of `ReadablePropertyMap` with faces as key type and a `%Vector_3`
 *         as value type
 *
 * \cgalModels{DirectionalCostFunction}
 */
template <typename FaceVectorMap>
class One_way
{
public:
  /// constructs the cost function. In a face with a zero vector, all directions are admissible.
  /// \param ways the directions of the faces, vectors of any length
  /// \param cost the cost per unit of length in admissible directions
  /// \param smallest_cosine the smallest cosine of the angle between an admissible direction and
  ///        that of the face: `0` admits half of the directions. Zigzags can follow any direction
  ///        in a gap of less than 180 degrees.
  /// \throws std::invalid_argument if `cost` is negative, infinite, or NaN, or if `smallest_cosine`
  ///         is not between `-1` and `1`.
  explicit One_way(FaceVectorMap ways, const double cost = 1, const double smallest_cosine = 0)
    : m_ways(std::move(ways)), m_cost(cost), m_smallest_cosine(smallest_cosine)
  {
    if(!(cost >= 0) || std::isinf(cost))
      internal::reject("the cost of one-way faces is " + internal::text_of(cost) +
                       "; it must be a finite number that is not negative");
    if(!(smallest_cosine >= -1 && smallest_cosine <= 1))
      internal::reject("the smallest cosine is " + internal::text_of(smallest_cosine) +
                       "; it must be a number from -1 to 1");
  }

  /// returns the cost per unit of length in a direction; NaN if the vector of the face is infinite
  /// or NaN, so that reading the mesh fails.
  template <typename Face, typename Vector_3>
  double operator()(const Face& face, const Vector_3& direction) const
  {
    constexpr double rounding = 1e-12;
    const auto& way = get(m_ways, face);
    const auto [x, y, z] = internal::space_vector(way);
    const double length = std::hypot(std::hypot(x, y), z); // does not overflow
    if(!std::isfinite(length))
      return std::numeric_limits<double>::quiet_NaN();
    const bool is_allowed =
        CGAL::to_double(way * direction) >= (m_smallest_cosine - rounding) * length;
    return is_allowed ? m_cost : internal::infinity;
  }

private:
  FaceVectorMap m_ways;
  double m_cost;
  double m_smallest_cosine;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_COST_FUNCTIONS_H
