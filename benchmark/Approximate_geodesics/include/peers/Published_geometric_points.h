// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_PUBLISHED_GEOMETRIC_POINTS_H
#define BENCHMARK_PUBLISHED_GEOMETRIC_POINTS_H

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Geometric_progressions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*
 * The geometric progressions of Aleksandrov, Lanthier, Maheshwari and Sack (1998), for comparison:
 * `Geometric_points` guarantees the same bound with a fraction of these points.
 *
 * From either end of an edge, the distances of consecutive points grow by the factor 1 + delta
 * sin(theta), where theta is the smallest angle at the vertex (and the factor is 1 + delta if that
 * is obtuse). They start at delta times the radius of the star of the vertex, and end where the
 * spacings of the two progressions are equal. Paths then cost at most 1 + delta (1 + 2 W / ((1 - 2
 * delta) w)) times as much as the cheapest ones, for delta < 1/2, where W is the largest finite
 * weight of a face and w the smallest one, which must not be 0; so delta is chosen for this to be 1
 * + epsilon.
 *
 * `SMALLEST_SINE` is used, and ends the bound, as in `Geometric_points`.
 */
class Published_geometric_points
{
public:
  // The index of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  // Points do not divide edges into equal parts.
  static constexpr bool makes_equal_parts = false;

  // Smaller sines are replaced by this one.
  static constexpr double SMALLEST_SINE = 0.02;

  // The minimum distance of a progression from the end, relative to the edge length.
  static constexpr double SMALLEST_START = 1e-36;

  // Places points for the bound `epsilon`.
  // \throws std::invalid_argument if `epsilon` is not a finite number above `0`.
  explicit Published_geometric_points(const double epsilon = 0.1)
    : m_epsilon(internal::checked_epsilon(parameters::epsilon(epsilon)))
  {
  }

  // Reads the bound from the named parameter `epsilon`, by default `0.1`.
  // \throws std::invalid_argument if it is not a finite number above `0`.
  template <typename T, typename Tag, typename Base>
  explicit Published_geometric_points(const Named_function_parameters<T, Tag, Base>& np)
    : m_epsilon(internal::checked_epsilon(np))
  {
    static_assert(!internal::is_any_given<Named_function_parameters<T, Tag, Base>,
                                          internal_np::number_of_points_per_edge_t,
                                          internal_np::nb_points_per_distance_unit_t>,
                  "Published_geometric_points reads epsilon, which says how many points there are: "
                  "for a number of your "
                  "own, use Fixed_number_of_points or Points_at_interval");
  }

  // Computes the starts and the factors of the progressions of every vertex.
  // \throws std::invalid_argument if some faces, but not all, have weight `0`.
  //
  // Run time is O(n).
  void
  prepare(const Intrinsic_triangulation& triangulation,
          std::size_t /* maximum_number_of_points */ = (std::numeric_limits<std::size_t>::max)())
  {
    const double ratio = ratio_of_weights(triangulation);
    if(std::isinf(ratio))
      internal::reject("a face has weight 0, for which the published placement has no points; use "
                       "Geometric_points");
    m_delta = delta(ratio);
    m_ends.clear();
    m_ends.reserve(triangulation.number_of_vertices());
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
    {
      const double sine = (std::max)(smallest_sine(triangulation, v), SMALLEST_SINE);
      m_ends.push_back(
          {m_delta * internal::Star(triangulation, v).radius(), sine, std::log1p(m_delta * sine)});
    }
  }

  // Returns the number of points on the edge of `h`.
  std::size_t number_of_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    return progressions(triangulation, h).number_of_points();
  }

  // Writes the positions of these points to `positions`.
  void place(const Intrinsic_triangulation& triangulation,
             const Index h,
             float* positions,
             std::size_t /* number_of_points */) const
  {
    progressions(triangulation, h).place(positions);
  }

  // Returns the guaranteed bound for the current weights of `triangulation`. Run time is O(n).
  double epsilon(const Intrinsic_triangulation& triangulation) const
  {
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
      if(smallest_sine(triangulation, v) < SMALLEST_SINE ||
         internal::Star(triangulation, v).is_degenerate())
        return std::numeric_limits<double>::infinity();
    constexpr double tolerance = 1e-9;
    const double result = bound(m_delta, ratio_of_weights(triangulation));
    return result <= m_epsilon * (1 + tolerance) ? m_epsilon : result;
  }

  // Returns the number of bytes stored for all elements of the mesh.
  std::size_t memory() const { return m_ends.capacity() * sizeof(End); }

private:
  using End = internal::Geometric_progressions::End;

  static double bound(const double delta, const double ratio)
  {
    return delta * (1 + 2 * ratio / (1 - 2 * delta));
  }

  // The solution of `bound(delta, ratio) == m_epsilon` between 0 and 1/2.
  double delta(const double ratio) const
  {
    const double b = 1 + 2 * ratio + 2 * m_epsilon;
    return 2 * m_epsilon / (b + std::sqrt(b * b - 8 * m_epsilon));
  }

  // The largest finite weight divided by the smallest.
  static double ratio_of_weights(const Intrinsic_triangulation& triangulation)
  {
    double smallest = std::numeric_limits<double>::infinity(), largest = 0;
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    {
      const double weight = triangulation.weight(h);
      if(std::isinf(weight))
        continue;
      smallest = (std::min)(smallest, weight);
      largest = (std::max)(largest, weight);
    }
    if(largest == 0)
      return 1;
    return smallest > 0 ? largest / smallest : std::numeric_limits<double>::infinity();
  }

  static double smallest_sine(const Intrinsic_triangulation& triangulation, const Index v)
  {
    double result = 1;
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
      if(!triangulation.is_border(h))
        result = (std::min)(result, internal::Face_shape(triangulation, h).sine_of_corner());
    return result;
  }

  internal::Geometric_progressions progressions(const Intrinsic_triangulation& triangulation,
                                                const Index h) const
  {
    const double length = triangulation.length(h);
    return {end(triangulation.source(h), length), end(triangulation.target(h), length)};
  }

  End end(const Index v, const double length) const
  {
    constexpr double largest_start = 0.49;
    End result = m_ends[v];
    result.start = (std::clamp)(result.start / length, SMALLEST_START, largest_start);
    return result;
  }

  double m_epsilon;
  double m_delta = 0;
  std::vector<End> m_ends; // per vertex
};

} // namespace CGAL::Approximate_geodesics

#endif // BENCHMARK_PUBLISHED_GEOMETRIC_POINTS_H
