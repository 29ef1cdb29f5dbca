// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_PAIRS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_PAIRS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * Lists of pairs of points on the surface of a `Solver`: the first source and the first target, and
 * so on. Pairs with the same source share a search. The header is not part of `Solver.h`, as
 * programs for other questions do not need it.
 *
 * All functions throw `std::invalid_argument` if there are not as many targets as sources, or if
 * one of them is not a point of the surface.
 */
class Solver_pairs
{
public:
  /// answers questions to `solver`.
  /// \warning `solver` is referred to, not copied.
  explicit Solver_pairs(const Solver& solver) : m_solver(solver) {}

  /*!
   * finds the distances from sources to targets.
   *
   * \param sources the sources
   * \param targets as many targets
   * \param distances receives one number per pair, infinity if the target is not reached
   * \param options the range of the searches, and the number of threads
   * \param watch is called during the run
   */
  void find_distances(const std::vector<Solver_point>& sources,
                      const std::vector<Solver_point>& targets,
                      double* const distances,
                      const Solver_pair_options& options = Solver_pair_options(),
                      const Solver_watch& watch = Solver_watch()) const
  {
    std::vector<double> found;
    with_pairs(sources, targets, options, watch, [&](const auto& pairs, auto& visitor) {
      found = m_solver.m_graph->find_distances(pairs, options.maximum_distance, visitor);
    });
    std::copy(found.begin(), found.end(), distances);
  }

  /// finds intervals that contain the distances on the surface: writes the lower and the upper end
  /// for each pair. The lower end is `0` if there is no error bound. If the target is beyond the
  /// range of the searches, they are the range, divided by `1 + error_bound()`, and infinity; an
  /// interval that is read without a search stays as it is unless it proves that. See also
  /// `Solver::prepare_intervals()`.
  void find_intervals(const std::vector<Solver_point>& sources,
                      const std::vector<Solver_point>& targets,
                      double* ends,
                      const Solver_pair_options& options = Solver_pair_options(),
                      const Solver_watch& watch = Solver_watch()) const
  {
    std::vector<std::pair<double, double>> found;
    with_pairs(sources, targets, options, watch, [&](const auto& pairs, auto& visitor) {
      found = m_solver.m_graph->find_intervals(pairs, options.maximum_distance, visitor);
    });
    for(const auto& [lower, upper] : found)
    {
      *ends++ = lower;
      *ends++ = upper;
    }
  }

  /*!
   * returns the points of a shortest path from each source to its target, three coordinates each.
   * If there is no path, it has no points.
   *
   * \param sources the sources
   * \param targets as many targets
   * \param lengths if not null, receives the length of each path, infinity if there is none
   * \param options the range of the searches, the kind of paths, and the number of threads
   * \param watch is called during the run
   */
  std::vector<std::vector<double>>
  find_paths(const std::vector<Solver_point>& sources,
             const std::vector<Solver_point>& targets,
             double* const lengths = nullptr,
             const Solver_pair_options& options = Solver_pair_options(),
             const Solver_watch& watch = Solver_watch()) const
  {
    std::vector<Path> paths;
    with_pairs(sources, targets, options, watch, [&](const auto& pairs, auto& visitor) {
      paths = m_solver.m_graph->find_paths(pairs, options.maximum_distance, options.straighten,
                                           visitor);
    });
    std::vector<std::vector<double>> result(paths.size());
    for(std::size_t i = 0; i < paths.size(); ++i)
      m_solver.append_coordinates(paths[i].points.begin(), paths[i].points.end(), result[i]);
    if(lengths != nullptr)
      std::transform(paths.begin(), paths.end(), lengths, Solver::length_of);
    return result;
  }

private:
  // Calls `f(pairs, visitor)`.
  template <typename F>
  void with_pairs(const std::vector<Solver_point>& sources,
                  const std::vector<Solver_point>& targets,
                  const Solver_pair_options& options,
                  const Solver_watch& watch,
                  const F& f) const
  {
    internal::Solver_visitor visitor(watch);
    const std::vector<Point_pair> pairs = this->pairs(sources, targets);
    m_solver.with_threads(options.number_of_threads, [&] { f(pairs, visitor); });
  }

  std::vector<Point_pair> pairs(const std::vector<Solver_point>& sources,
                                const std::vector<Solver_point>& targets) const
  {
    if(sources.size() != targets.size())
      internal::reject("pairs have " + std::to_string(sources.size()) + " sources and " +
                       std::to_string(targets.size()) + " targets");
    const auto from = m_solver.intrinsic_points(sources, "the source of pair");
    const auto to = m_solver.intrinsic_points(targets, "the target of pair");
    std::vector<Point_pair> result;
    for(std::size_t i = 0; i < from.size(); ++i)
      result.emplace_back(from[i], to[i]);
    return result;
  }

  const Solver& m_solver;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_PAIRS_H
