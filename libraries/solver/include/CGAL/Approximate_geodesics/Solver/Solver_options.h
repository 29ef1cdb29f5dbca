// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_OPTIONS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_OPTIONS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * A point of a `Solver`: a vertex, a point on an edge, or a point of a face.
 */
struct Solver_point
{
  /// the kinds of points.
  enum Kind : std::uint8_t
  {
    VERTEX, ///< a vertex
    EDGE,   ///< a point on an edge
    FACE    ///< a point of a face
  };

  /// returns the point at a vertex.
  static Solver_point at_vertex(const std::int64_t vertex) { return {VERTEX, vertex, 0, {}}; }

  /// returns the point on the edge between two vertices at the parameter `t`: `0` is the first one,
  /// `1` is the second one.
  static Solver_point
  on_edge(const std::int64_t first_vertex, const std::int64_t second_vertex, const double t)
  {
    return {EDGE, first_vertex, second_vertex, {1 - t, t, 0}};
  }

  /// returns the point of a face with the given barycentric coordinates: the weights of its
  /// vertices, in their order in the array of faces. They are not negative, and their sum is `1`.
  static Solver_point in_face(const std::int64_t face, const std::array<double, 3>& coordinates)
  {
    return {FACE, face, 0, coordinates};
  }

  Kind kind;                         ///< what it is
  std::int64_t element;              ///< the number of the vertex, the face or the first vertex
  std::int64_t second_vertex;        ///< the second vertex of the edge
  std::array<double, 3> coordinates; ///< barycentric coordinates on the edge or in the face
};

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The callbacks of a `Solver`, which are called about 30 times per second, always in the calling
 * thread. Both may be empty.
 */
struct Solver_watch
{
  /// returns whether to continue. Otherwise the call throws `Solver_interrupted`.
  std::function<bool()> go_further;

  /// receives the number of completed steps and their total: vertices of a search or of a graph
  /// under construction, rows of a matrix, or points of a sample. It is not called if the total is
  /// 0.
  std::function<void(std::size_t, std::size_t)> on_progress;
};

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The exception that a `Solver` throws if a watch ends a call. The solver is unchanged.
 */
struct Solver_interrupted : std::runtime_error
{
  /// constructs the exception.
  Solver_interrupted() : std::runtime_error("Approximate_geodesics: the run was interrupted") {}
};

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * A directional cost: one of the predefined cost functions with its parameters and arrays, or
 * samples of another one. Unlike arbitrary functions, it can be saved by a `Solver`.
 *
 * The constructor of `Solver` checks parameters and arrays.
 */
struct Solver_cost
{
  /// the cost functions.
  enum Model : std::uint8_t
  {
    HIKING_TIME,    ///< `Hiking_time`
    WALKING_ENERGY, ///< `Walking_energy`
    DRIFT_TIME,     ///< `Drift_time`
    ONE_WAY,        ///< `One_way`
    TENSOR_COST,    ///< `Tensor_cost`
    SAMPLED_COST,   ///< any cost function, sampled in several directions per face
    NAISMITH_TIME   ///< `Naismith_time`
  };

  /// returns `Hiking_time`, with a factor for speeds.
  static Solver_cost hiking_time(const double factor = 1) { return {HIKING_TIME, {factor}, {}}; }

  /// returns `Walking_energy`.
  static Solver_cost walking_energy() { return {WALKING_ENERGY, {}, {}}; }

  /// returns `Naismith_time`, with the seconds per horizontal meter and per meter of ascent.
  static Solver_cost naismith_time(const double pace = 0.72, const double ascent = 6)
  {
    return {NAISMITH_TIME, {pace, ascent}, {}};
  }

  /// returns `Drift_time`, with the velocities of the drift, three numbers per face, and the speed
  /// of the boat.
  static Solver_cost drift_time(std::vector<double> velocities, const double speed)
  {
    return {DRIFT_TIME, {speed}, std::move(velocities)};
  }

  /// returns `One_way`, with the directions of the faces, three numbers each, the cost in
  /// admissible directions, and the smallest cosine of the angle to an admissible direction.
  static Solver_cost
  one_way(std::vector<double> ways, const double cost = 1, const double smallest_cosine = 0)
  {
    return {ONE_WAY, {cost, smallest_cosine}, std::move(ways)};
  }

  /// returns `Tensor_cost`, with six numbers per face: the entries xx, xy, xz, yy, yz and zz.
  static Solver_cost tensor_cost(std::vector<double> tensors)
  {
    return {TENSOR_COST, {}, std::move(tensors)};
  }

  /// returns a cost function that was sampled in the same number of directions in each face, and is
  /// linear between neighboring directions. The samples of a face are two orthogonal unit vectors
  /// in its plane, three numbers each, and, for each direction, its angle from the first vector to
  /// the second one and its cost. The angles increase from \f$-\pi\f$ to \f$\pi\f$.
  static Solver_cost sampled_cost(std::vector<double> samples,
                                  const std::size_t number_of_directions)
  {
    return {SAMPLED_COST, {static_cast<double>(number_of_directions)}, std::move(samples)};
  }

  Model model;                    ///< the cost function
  std::vector<double> parameters; ///< the numerical arguments of its constructor
  std::vector<double> of_faces;   ///< the same number of numbers for each face, or none
};

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The parameters of a `Solver`. Arrays are only read during construction.
 */
struct Solver_options
{
  /// the error bound: paths are at most `1 + epsilon` times as long as shortest paths. `0` requests
  /// exact distances, which do not support costs or barriers. If absent, paths follow edges,
  /// without an error bound.
  std::optional<double> epsilon = std::nullopt;

  /// the cost per unit of length in each face. Weights are not negative; infinity makes a face
  /// impassable.
  const double* face_weights = nullptr;

  /// the cost per unit of length in each face, if it depends on the direction. It excludes
  /// `face_weights`.
  std::optional<Solver_cost> directional_cost = std::nullopt;

  /// the steepest slope of straight pieces of paths, uphill and downhill, with any costs; see
  /// `Directional_graph`. If it is infinite, there is no limit.
  double max_slope = std::numeric_limits<double>::infinity();

  /// whether to accept a weaker bound where `epsilon` cannot be guaranteed with these costs;
  /// `Solver::error_bound()` returns the resulting bound.
  bool accept_weaker_bound = false;

  /// the maximum number of Steiner points on all edges together, which take about 50 bytes each;
  /// `0` selects the default of `Steiner_graph`.
  std::size_t maximum_number_of_points = 0;

  /// edges that paths must not cross, as pairs of vertices.
  const std::int64_t* barriers = nullptr;

  /// the number of barriers.
  std::size_t number_of_barriers = 0;

  /// whether face weights and barriers may change: the bound then still holds afterwards, with more
  /// points. This is not saved.
  bool may_change = false;

  /// the number of threads for building the graph and computing matrices; `0` selects one per core.
  /// Without TBB, a single thread is used.
  std::size_t number_of_threads = 0;
};

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The parameters of a `Grid_solver`. Arrays have one value per cell, row by row, and are only read
 * during construction.
 */
struct Grid_solver_options
{
  /// the number of slopes per unit that `slope_costs` has.
  static constexpr int SLOPES_PER_UNIT = 8000;

  /// the number of all slopes, from -4 to 4.
  static constexpr std::size_t NUMBER_OF_SLOPES = 8 * SLOPES_PER_UNIT + 1;

  /// the costs per unit of length; if null, all are `1`.
  const double* friction = nullptr;

  /// the heights of the centers, if not null.
  const double* heights = nullptr;

  /// the error bound, which is not supported with heights or costs. If absent, there is none.
  std::optional<double> epsilon = std::nullopt;

  /// the cost per unit of length, which friction multiplies; arrays have numbers for cells in place
  /// of faces. `Hiking_time`, `Walking_energy` and `Naismith_time` need heights.
  std::optional<Solver_cost> cost = std::nullopt;

  /// the costs per unit of length on slopes from `-4` to `4`, instead of `cost`, if not empty.
  std::vector<double> slope_costs = {};

  /// the steepest slope of lines, uphill and downhill; it needs heights. If it is infinite, there
  /// is no limit.
  double max_slope = std::numeric_limits<double>::infinity();
};

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The range and the direction of a search.
 */
struct Solver_search_options
{
  /// vertices at larger distances are not reached.
  double maximum_distance = std::numeric_limits<double>::infinity();

  /// whether to compute distances to the sources instead of from them. They differ only with
  /// directional costs; in that case, the first such search copies the graph.
  bool direction_to_source = false;
};

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The columns, the range and the direction of a matrix computation.
 */
struct Solver_row_options
{
  /// the points of the columns; if null, all vertices.
  const std::vector<Solver_point>* targets = nullptr;

  /// columns at larger distances are not reached.
  double maximum_distance = std::numeric_limits<double>::infinity();

  /// whether to compute distances to the sources, as in `Solver_search_options`.
  bool direction_to_source = false;

  /// whether to replace each distance and its transpose by the smaller of the two. Targets must
  /// equal the sources, in the same order. It is not supported for nearest rows or directional
  /// costs.
  bool symmetric = false;

  /// the number of threads; `0` selects that of the solver.
  std::size_t number_of_threads = 0;
};

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * The range of searches for pairs of points, and the kind of their paths.
 */
struct Solver_pair_options
{
  /// targets at larger distances are not reached.
  double maximum_distance = std::numeric_limits<double>::infinity();

  /// whether to straighten paths to locally shortest ones, which does not support costs.
  bool straighten = false;

  /// the number of threads; `0` selects that of the solver.
  std::size_t number_of_threads = 0;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_OPTIONS_H
