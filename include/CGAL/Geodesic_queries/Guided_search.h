// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_GUIDED_SEARCH_H
#define CGAL_GEODESIC_QUERIES_GUIDED_SEARCH_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Geodesic_queries/Exact_landmarks.h>
#include <CGAL/Geodesic_queries/Landmarks.h>
#include <CGAL/Geodesic_queries/internal/Corridor_finder.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicQueriesPairs
 *
 * A `Surface_search` whose runs to a single target are guided by landmarks, which makes them fast.
 * Other runs are those of `Surface_search`, and so are the functions for results.
 *
 * Landmarks give lower bounds of distances to the target: see `Landmarks`. Those of an exact graph
 * are `Exact_landmarks`. They limit an exact run to a corridor around the shortest path, which two
 * searches of another graph find before it; the run has to be from a single source whose initial
 * distance is `0`.
 *
 * \tparam SurfaceGraph a model of `SurfaceGraph`
 * \tparam PriorityQueue a model of `GeodesicPriorityQueue`
 *
 * \sa `Pair_queries`
 */
template <typename SurfaceGraph, typename PriorityQueue = Adaptive_bucket_queue>
class Guided_search : public Surface_search<SurfaceGraph, PriorityQueue>
{
  using Base = Surface_search<SurfaceGraph, PriorityQueue>;

  static constexpr bool has_corridors = internal::can_stay_in_corridor<SurfaceGraph>;

public:
  /// the landmarks: `Exact_landmarks` or `Landmarks`.
  using Landmarks = internal::Landmarks_of<SurfaceGraph>;

  /// makes a workspace for `graph`, without landmarks. Run time and memory are those of
  /// `Surface_search`.
  /// \warning `graph` is referred to, not copied.
  explicit Guided_search(const SurfaceGraph& graph) : Base(graph) {}

  /// a workspace for a temporary graph would outlive it.
  explicit Guided_search(const SurfaceGraph&& graph) = delete;

  /// guides runs to a single target from now on, as long as arcs of the graph do not change. If it
  /// is exact, the last run is forgotten.
  /// \warning `landmarks` are referred to, not copied.
  /// \throws std::invalid_argument if they are those of another graph.
  void use_landmarks(const Landmarks& landmarks);

  /// temporary landmarks would not live long enough.
  void use_landmarks(const Landmarks&& landmarks) = delete;

  /// returns whether runs to a single target are guided by landmarks.
  bool uses_landmarks() const
  {
    if constexpr(has_corridors)
      return m_guide != nullptr;
    else
      return m_guide != nullptr && m_guide->are_valid();
  }

  /*!
   * does the same as `Surface_search::run_to()`, guided by the landmarks. Where there are none, or
   * they do not help, positions guide it.
   *
   * \throws std::invalid_argument as `Surface_search::run()` does.
   */
  void run_to(const Intrinsic_point& target,
              std::vector<Source_point> sources,
              const Vertex_positions& positions = Vertex_positions(),
              double maximum_distance = std::numeric_limits<double>::infinity());

  /// returns the number of bytes of the search, and of the one that finds corridors.
  std::size_t memory() const
  {
    if constexpr(has_corridors)
      return Base::memory() + (m_guide ? m_guide->memory() : 0);
    else
      return Base::memory();
  }

  /// \cond SKIP_IN_MANUAL

  // Whether so many targets of a source are better found by a guided run to each of them. Exact
  // distances are the same, to the last bit, and one run to all targets takes as long as about ten
  // that are guided. Others may change, so they must not depend on the number of targets.
  bool guides_to_each_of(const std::size_t number_of_targets) const
  {
    constexpr std::size_t most_of_exact = 8;
    return uses_landmarks() && (number_of_targets <= most_of_exact || !has_corridors);
  }

  /// \endcond

private:
  using Corridor_finder = internal::Corridor_finder<Landmarks>;

  template <typename Finder>
  bool run_in_corridor(Finder& finder,
                       const Intrinsic_point& target,
                       const Intrinsic_point& source,
                       double maximum_distance);

  // The landmarks, or what finds corridors by them.
  std::conditional_t<has_corridors, std::unique_ptr<Corridor_finder>, const Landmarks*> m_guide =
      nullptr;
};

// Not in the class, as those of `Surface_search`.

template <typename SurfaceGraph, typename PriorityQueue>
void Guided_search<SurfaceGraph, PriorityQueue>::use_landmarks(const Landmarks& landmarks)
{
  if(&landmarks.graph() != &this->graph())
    internal::reject("the landmarks are those of another graph");
  if constexpr(has_corridors)
  {
    auto finder = std::make_unique<Corridor_finder>(landmarks);
    this->run({}); // the last corridor is no longer valid
    m_guide = std::move(finder);
  }
  else
    m_guide = &landmarks;
}

template <typename SurfaceGraph, typename PriorityQueue>
void Guided_search<SurfaceGraph, PriorityQueue>::run_to(const Intrinsic_point& target,
                                                        std::vector<Source_point> sources,
                                                        const Vertex_positions& positions,
                                                        const double maximum_distance)
{
  const Intrinsic_triangulation& t = this->graph().triangulation();
  if(uses_landmarks() && target.is_valid(t)) // `Surface_search` rejects bad input
  {
    if constexpr(has_corridors)
    {
      if(sources.size() == 1 && sources[0].distance == 0 && sources[0].point.is_valid(t) &&
         maximum_distance >= 0 &&
         run_in_corridor(*m_guide, target, sources[0].point, maximum_distance))
        return;
    }
    else if constexpr(internal::has_asymmetry<SurfaceGraph>)
      return this->run_toward(target, std::move(sources), m_guide->to(target), maximum_distance);
  }
  Base::run_to(target, std::move(sources), positions, maximum_distance);
}

// Runs to the target within its corridor. Returns whether the result is final: where faces are
// numerically degenerate, all paths in the corridor may be too long.
template <typename SurfaceGraph, typename PriorityQueue>
template <typename Finder>
bool Guided_search<SurfaceGraph, PriorityQueue>::run_in_corridor(Finder& finder,
                                                                 const Intrinsic_point& target,
                                                                 const Intrinsic_point& source,
                                                                 const double maximum_distance)
{
  this->run({}); // the last corridor is no longer valid
  internal::Corridor corridor = finder.find(source, target);
  if(!corridor.is_known())
    return false;
  const double limit = (std::min)(maximum_distance, corridor.length * this->graph().unit());
  this->run_by({{source}}, {limit, {target}},
               [&](auto& search, const auto& seeds, const auto& rule, const auto& entries) {
                 search.run_within(std::move(corridor.distance_to_goal), seeds, rule, entries);
               });
  const bool is_reachable = corridor.length > 0;
  return !is_reachable || this->nearest(target).is_reached();
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_GUIDED_SEARCH_H
