// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_PAIRS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_PAIRS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/Solver.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// The member functions of `Solver` for lists of pairs.
namespace CGAL::Approximate_geodesics {

inline std::vector<Point_pair> Solver::pairs(const std::vector<Solver_point>& sources,
                                             const std::vector<Solver_point>& targets) const
{
  if(sources.size() != targets.size())
    internal::reject("pairs have " + std::to_string(sources.size()) + " sources and " +
                     std::to_string(targets.size()) + " targets");
  const auto from = intrinsic_points(sources, "the source of pair");
  const auto to = intrinsic_points(targets, "the target of pair");
  std::vector<Point_pair> result;
  for(std::size_t i = 0; i < from.size(); ++i)
    result.emplace_back(from[i], to[i]);
  return result;
}

template <typename F>
void Solver::with_pairs(const std::vector<Solver_point>& sources,
                        const std::vector<Solver_point>& targets,
                        const Solver_pair_options& options,
                        const Solver_watch& watch,
                        const F& f) const
{
  internal::Solver_visitor visitor(watch);
  const std::vector<Point_pair> pairs = this->pairs(sources, targets);
  with_threads(options.number_of_threads, [&] { f(pairs, visitor); });
}

inline void Solver::find_pair_distances(const std::vector<Solver_point>& sources,
                                        const std::vector<Solver_point>& targets,
                                        double* const distances,
                                        const Solver_pair_options& options,
                                        const Solver_watch& watch) const
{
  std::vector<double> found;
  with_pairs(sources, targets, options, watch,
             [&](const std::vector<Point_pair>& pairs, internal::Solver_visitor& visitor) {
               found = m_graph->find_distances(pairs, options.maximum_distance, visitor);
             });
  std::copy(found.begin(), found.end(), distances);
}

inline void Solver::find_pair_intervals(const std::vector<Solver_point>& sources,
                                        const std::vector<Solver_point>& targets,
                                        double* ends,
                                        const Solver_pair_options& options,
                                        const Solver_watch& watch) const
{
  std::vector<std::pair<double, double>> found;
  with_pairs(sources, targets, options, watch,
             [&](const std::vector<Point_pair>& pairs, internal::Solver_visitor& visitor) {
               found = m_graph->find_intervals(pairs, options.maximum_distance, visitor);
             });
  for(const auto& [lower, upper] : found)
  {
    *ends++ = lower;
    *ends++ = upper;
  }
}

inline std::vector<std::vector<double>> Solver::find_paths(const std::vector<Solver_point>& sources,
                                                           const std::vector<Solver_point>& targets,
                                                           double* const lengths,
                                                           const Solver_pair_options& options,
                                                           const Solver_watch& watch) const
{
  std::vector<Path> paths;
  with_pairs(sources, targets, options, watch,
             [&](const std::vector<Point_pair>& pairs, internal::Solver_visitor& visitor) {
               paths = m_graph->find_paths(pairs, options.maximum_distance, options.straighten,
                                           visitor);
             });
  std::vector<std::vector<double>> result(paths.size());
  for(std::size_t i = 0; i < paths.size(); ++i)
    append_coordinates(paths[i].points.begin(), paths[i].points.end(), result[i]);
  if(lengths != nullptr)
    std::transform(paths.begin(), paths.end(), lengths, length_of);
  return result;
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_PAIRS_H
