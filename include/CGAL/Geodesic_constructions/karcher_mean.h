// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_KARCHER_MEAN_H
#define CGAL_GEODESIC_CONSTRUCTIONS_KARCHER_MEAN_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Geodesic_constructions/logarithmic_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicConstructionsWalks
 *
 * What `karcher_mean()` returns.
 */
template <typename TriangleMesh>
struct Karcher_mean
{
  /// the point with the smallest sum that was found.
  Surface_point<TriangleMesh> point;

  /// the square root of the weighted mean of squared distances from that point.
  double deviation = 0;

  /// the number of iterations.
  std::size_t number_of_iterations = 0;

  /// whether it is a local minimum, up to rounding.
  bool has_converged = false;
};

namespace internal {

/*
 * Minimizes the weighted mean of squared distances from points, by Newton's method. Half its
 * gradient is the mean of the logarithms, backward. The Hessian of half a squared distance `d` is 1
 * along the path, and `d / r` across it, where `r` is the distance of the first vertex at which the
 * path bends: around that, points of the same distance form a circle.
 */
class Mean_search
{
public:
  // The weights add up to 1.
  Mean_search(const Saddle_vertex_graph& graph,
              std::vector<Intrinsic_point> points,
              std::vector<double> weights)
    : m_search(graph),
      m_first_lines(graph.triangulation()),
      m_points(std::move(points)),
      m_weights(std::move(weights))
  {
    m_best = at(start());
  }

  void run(const std::size_t largest_number_of_iterations)
  {
    constexpr double rounding = 1e-11;
    while(!m_has_converged && m_number_of_iterations < largest_number_of_iterations)
    {
      m_has_converged = length(m_best.step()) <= rounding * deviation();
      if(m_has_converged || !(descend() || go_to_corner()))
        return;
      ++m_number_of_iterations;
    }
  }

  const Intrinsic_point& point() const { return m_best.point; }
  double deviation() const { return std::sqrt(m_best.mean_of_squares); }
  std::size_t number_of_iterations() const { return m_number_of_iterations; }
  bool has_converged() const { return m_has_converged; }

private:
  struct Candidate
  {
    Intrinsic_point point{};
    double mean_of_squares = infinity;
    Plane_vector mean{0, 0};       // of logarithms
    double xx = 0, xy = 0, yy = 0; // the Hessian

    // A point at the same place.
    void add_here(const double weight)
    {
      xx += weight;
      yy += weight;
    }

    void add(const double weight, const double distance, const First_line& line)
    {
      const Plane_vector u{std::cos(line.angle), std::sin(line.angle)};
      const double across = distance / (std::max)(line.length, 1e-12 * distance);
      mean_of_squares += weight * distance * distance;
      mean = mean + weight * distance * u;
      xx += weight * (u.x * u.x + across * u.y * u.y);
      xy += weight * (u.x * u.y - across * u.x * u.y);
      yy += weight * (u.y * u.y + across * u.x * u.x);
    }

    Plane_vector step() const
    {
      const double determinant = xx * yy - xy * xy; // at least 1
      if(!(determinant > 0))
        return {0, 0};
      return 1 / determinant * Plane_vector{yy * mean.x - xy * mean.y, xx * mean.y - xy * mean.x};
    }
  };

  const Intrinsic_triangulation& triangulation() const { return m_search.graph().triangulation(); }

  Candidate at(const Intrinsic_point& point)
  {
    Geodesic_visitor_base visitor; // as in the compiled searches
    m_search.run({{point}}, {infinity, m_points}, visitor);
    Candidate result{point, 0};
    for(std::size_t i = 0; i < m_points.size(); ++i)
    {
      Path path = m_search.find_path(m_points[i]);
      check_reached(path, i);
      if(!(path.length > 0)) // the same point, or one that edges of length zero join it with
      {
        result.add_here(m_weights[i]);
        continue;
      }
      std::reverse(path.points.begin(), path.points.end());
      result.add(m_weights[i], path.length / triangulation().unit(), m_first_lines(path.points));
    }
    return result;
  }

  // Goes from the mean of the first points along a shortest path toward the next one: this ends at
  // the mean of two points, and of any number of points where the surface is flat.
  Intrinsic_point start()
  {
    Intrinsic_point result = m_points[0];
    double sum = m_weights[0];
    for(std::size_t i = 1; i < m_points.size(); ++i)
      if(m_weights[i] > 0)
      {
        sum += m_weights[i];
        m_search.run_to(result, {{m_points[i]}});
        const Path path = m_search.find_path(result);
        check_reached(path, i);
        result = point_on(path, m_weights[i] / sum * path.length / triangulation().unit());
      }
    return result;
  }

  // The point at this length from the first one.
  Intrinsic_point point_on(const Path& path, double length) const
  {
    for(std::size_t i = 1; i < path.points.size(); ++i)
    {
      const Segment s = shortest_segment(triangulation(), path.points[i - 1], path.points[i]);
      if(!(length < s.length))
      {
        length -= s.length;
        continue;
      }
      const Index h = s.from.halfedge;
      const Face_point to =
          triangulation().is_border(h) ? s.to : s.to.seen_from(triangulation(), h);
      std::array<double, 3> weight = s.from.weight;
      for(std::size_t k = 0; k < 3; ++k)
        weight[k] += length / s.length * (to.weight[k] - weight[k]);
      return point_in_face(triangulation(), h, weight).reduced(triangulation());
    }
    return path.points.back();
  }

  static void check_reached(const Path& path, const std::size_t i)
  {
    if(path.points.empty())
      reject("point " + std::to_string(i) + ", counted from 0, cannot be reached from others");
  }

  // Takes a step that does not increase the mean, or half of that, and so on. Returns false if all
  // of them do.
  bool descend()
  {
    constexpr double rounding = 1e-13; // far smaller steps change the sum by no more
    constexpr int number_of_steps = 12;
    constexpr std::size_t largest_number_of_faces = 100000;
    const double angle = angle_of(m_best.step());
    double step = length(m_best.step());
    for(int i = 0; i < number_of_steps; ++i, step /= 2)
    {
      const Straight_walk walk(triangulation(), m_best.point, angle, step, largest_number_of_faces);
      const Candidate candidate = at(walk.points().back());
      if(candidate.mean_of_squares < m_best.mean_of_squares * (1 + rounding))
      {
        m_best = candidate;
        return true;
      }
    }
    return false;
  }
  // Takes the best corner of the faces, if it is better: a vertex with an angle of more than 2 pi
  // can be a minimum that steps approach only slowly.
  bool go_to_corner()
  {
    const Candidate before = m_best;
    if(before.point.is_vertex())
    {
      m_has_converged = true;
      return false;
    }
    before.point.for_each_face(triangulation(), [&](const Index h) {
      for(const Index side : triangulation().halfedges_of_face(h))
      {
        const Candidate candidate = at(Intrinsic_point::at_vertex(triangulation().source(side)));
        if(candidate.mean_of_squares < m_best.mean_of_squares)
          m_best = candidate;
      }
    });
    return m_best.mean_of_squares < before.mean_of_squares;
  }

  Surface_search<Saddle_vertex_graph> m_search;
  const First_lines m_first_lines;
  const std::vector<Intrinsic_point> m_points;
  const std::vector<double> m_weights;
  Candidate m_best; // lengths in units of the triangulation
  std::size_t m_number_of_iterations = 0;
  bool m_has_converged = false;
};

// Returns weights that add up to 1, one for each of the points.
template <typename Weights>
std::vector<double> shares(const Weights& weights, const std::size_t number_of_points)
{
  std::vector<double> result;
  double sum = 0, largest = 0;
  for(const auto& number : weights)
  {
    const double weight = CGAL::to_double(number);
    if(!(weight >= 0) || std::isinf(weight))
      reject(name_in_list("weight", result.size()) + " is " + text_of(weight) +
             "; it must be a finite number that is not negative");
    largest = (std::max)(largest, weight);
    result.push_back(weight);
  }
  if(result.size() != number_of_points || !(largest > 0))
    reject("there are " + std::to_string(number_of_points) + " points, and " +
           std::to_string(result.size()) +
           " weights; there must be one weight for each point, and one that is not 0");
  for(double& weight : result)
    sum += weight /= largest; // so that the sum does not overflow
  for(double& weight : result)
    weight /= sum;
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsWalks
 *
 * finds a Karcher mean \cgalCite{k-rcmms-77} of points: where the weighted mean of the squared
 * distances from them is smallest, at least in the neighborhood.
 *
 * It starts at the mean of two points on a shortest path between them, goes on from there to a mean
 * of three points toward the third one, and so on. In each iteration, an exact search finds the
 * logarithms of all points, see `logarithmic_map()`. Their mean gives the step, by Newton's method,
 * and `trace_geodesic()` the next point. A step that makes the mean of squares larger is halved, up
 * to twelve times; if that does not help, the best corner of the face is tried. It has converged if
 * a step is shorter than \f$10^{-11}\f$ times the deviation, or, at a vertex, if no step makes the
 * mean of squares smaller.
 *
 * The mean of two points is the middle of a shortest path between them. If points lie far apart,
 * or on different sides of a handle, there may be several local minima, and the result depends on
 * the start. On the cut locus of a point, iterations may end without convergence.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam PointRange a model of `ConstRange` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, `Face_location` or
 *         `Surface_point` as value type
 * \tparam WeightRange a model of `ConstRange` with a number type convertible by
 *         `CGAL::to_double()` as value type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param points the points, at least one; they must lie in one connected component
 * \param weights a finite weight for each point, not negative, and not all `0`
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map`, `edge_length_map`, `concurrency_tag`, `vertex_index_map`,
 *           `halfedge_index_map` and `geom_traits`, as for `approximate_geodesic_distances()`, and
 *           the one listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the largest number of iterations; not negative}
 *     \cgalParamType{an integer type}
 *     \cgalParamDefault{`100`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the point, the deviation, the number of iterations, and whether it has converged.
 *
 * \throws std::invalid_argument if there are no points, or not as many weights, if a weight is
 *         negative, infinite or NaN, if all are `0`, if points lie in different components, if the
 *         number of iterations is negative, and as `logarithmic_map()` does.
 *
 * \sa `logarithmic_map()`
 */
template <typename TriangleMesh,
          typename PointRange,
          typename WeightRange,
          typename NamedParameters = parameters::Default_named_parameters>
Karcher_mean<TriangleMesh> karcher_mean(const TriangleMesh& tmesh,
                                        const PointRange& points,
                                        const WeightRange& weights,
                                        const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::ignores_any<NamedParameters, internal_np::edge_length_t>,
                "karcher_mean() is exact, and reads edge_length_map only");
  const auto graph = internal::exact_graph(tmesh, np);
  Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np), graph.triangulation());
  translation.list_vertices();
  std::vector<Intrinsic_point> places = internal::intrinsic_points(translation, points, "point");
  std::vector<double> shares = internal::shares(weights, places.size());
  internal::Mean_search search(graph, std::move(places), std::move(shares));
  search.run(internal::largest_number_of_iterations(np, 100));
  return {translation.surface_point(search.point()),
          search.deviation() * graph.triangulation().unit(), search.number_of_iterations(),
          search.has_converged()};
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_KARCHER_MEAN_H
