// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_DEFERRED_SIGHTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_DEFERRED_SIGHTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Vertex_sights.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// A sight, and the data to resume it.
struct Deferred_sight
{
  using Index = Intrinsic_triangulation::Index;

  Deferred_sight(const Sight& deferred,
                 const Crossing& last_milestone,
                 const Index tip_of_sight,
                 const double label,
                 const double smallest)
    : sight(deferred),
      milestone(last_milestone),
      tip(tip_of_sight),
      label_of_tip(label),
      smallest_label(smallest)
  {
  }

  Sight sight;
  Crossing milestone; // the last one on the way
  Index tip;
  double label_of_tip;
  double smallest_label; // of points that are seen
};

/*
 * A sight is followed up to a horizon only, a few edges beyond the nodes that are expanded, and is
 * resumed when the search reaches it. By then, the labels around it are known, and prune useless
 * sights. Farther away, only upper bounds are known, the lengths of paths along edges, which are
 * too large to prune them. On a rough surface, most sights are useless there, and would be followed
 * across a large part of it. On a smooth surface, most are useful; there, the horizon is farther
 * away, and keeps the working set of the search small enough for the processor's caches.
 *
 * The order of sights by distance is that of continuous Dijkstra (J. Mitchell, D. Mount,
 * C. Papadimitriou, The discrete geodesic problem, 1987). Here, an approximate order is enough:
 * sights are in buckets, one for each step of the search, which is a fraction of the distance to
 * the horizon. Buckets consist of blocks, which are used again as soon as their sights were
 * resumed: no sight is copied, and the memory is in the caches.
 */
class Deferred_sights
{
public:
  using List = std::vector<Deferred_sight>;

  // Where a task defers sights: to a list of its own, or, if it is the only one, to where they
  // wait.
  class Sink
  {
  public:
    explicit Sink(Deferred_sights& all) : m_all(&all) {}
    explicit Sink(List& list) : m_list(&list) {}

    List& list(const double smallest_label) const
    {
      return m_list != nullptr ? *m_list : m_all->list_of(smallest_label);
    }

  private:
    Deferred_sights* m_all = nullptr;
    List* m_list = nullptr;
  };

  // Whether paths bend so often that most sights are useless.
  static bool is_rough(const Bends& bends)
  {
    constexpr double rough = 0.005; // mean excess
    return bends.mean_excess() > rough;
  }

  // How far away sights are deferred; infinity if they are not. On a smooth surface that fits into
  // the processor's caches, or where few vertices have sights, deferring these takes more time than
  // it saves, unless it gives several threads something to do. Where faces are long and thin, as in
  // a CAD part, vertices are denser than edges are long.
  static double
  suitable_distance(const Bends& bends, const double mean_edge, const bool is_parallel)
  {
    constexpr double smooth = 0.001, fewest_bends = 0.1; // mean excess, share of vertices
    constexpr std::size_t smallest_size = 60000;
    const bool gains =
        bends.mean_excess() > smooth ||
        (bends.number_of_vertices() > smallest_size && bends.share_of_bends() > fewest_bends);
    const double edge = bends.spacing() < mean_edge / 2 ? bends.spacing() : mean_edge;
    return gains || is_parallel ? (std::max)(mean_edge, edge * (is_rough(bends) ? 5 : 16))
                                : infinity;
  }

  // Starts a search. The horizon is at least this far away from the nodes that are expanded.
  void start(const double distance)
  {
    for(Blocks& blocks : m_steps)
      clear(blocks);
    for(List& list : m_of_tasks) // a search may have ended while there were tasks
      list.clear();
    m_beyond.clear();
    clear(m_resumed);
    m_first = 0;
    m_distance = distance;
    m_step = distance / steps_to_horizon;
    m_next_step = distance < infinity ? 0 : infinity;
  }

  // Sights of which nothing is nearer are deferred.
  double horizon() const { return m_next_step + m_distance; }
  double distance() const { return m_distance; }

  // Moves the horizon if the search reaches the next step with these nodes, which are expanded, and
  // returns whether it does. If there are no nodes, it has reached the next sights.
  template <typename Labels>
  bool
  advance(const Deferred_sight::Index* const nodes, const std::size_t number, const Labels& labels)
  {
    clear(m_resumed);
    double label = number == 0 && is_any_waiting() ? next_label_and_tip().first : 0;
    for(std::size_t i = 0; i < number; ++i)
      label = (std::max)(label, labels.distance(nodes[i]));
    if(!(label >= m_next_step))
      return false;
    for(std::size_t i = 0; i < number_of_steps && label >= m_next_step; ++i)
      take_next_step();
    if(label >= m_next_step) // all buckets are empty
      m_next_step = label + m_step > label ? label + m_step : infinity;
    if(!m_beyond.empty())
      sort_beyond();
    return true;
  }

  // The number of blocks of sights that are to be resumed then, one by a thread at a time.
  std::size_t number_of_blocks() const { return m_resumed.size(); }

  // Calls `f(sight)` for those of a block, unless the label of the tip has been lowered: the sight
  // is also followed with the smaller label.
  template <typename Labels, typename Prefetch, typename F>
  void for_each_in_block(const std::size_t block,
                         const Labels& labels,
                         const Prefetch& prefetch,
                         F f) const
  {
    constexpr std::size_t ahead = 8;
    const List& list = m_resumed[block];
    for(std::size_t i = 0; i < (std::min)(ahead, list.size()); ++i)
      prefetch(list[i]);
    for(std::size_t i = 0; i < list.size(); ++i)
    {
      if(i + ahead < list.size())
        prefetch(list[i + ahead]);
      if(!(labels.distance(list[i].tip) < list[i].label_of_tip))
        f(list[i]);
    }
  }

  // Calls `append(i, part, sink)` for all `i` below `number`, those of the blocks first, in
  // parallel if there are enough: it appends arcs to a part of the candidates, and defers sights to
  // the sink. If any sights wait, requests a call when the search reaches them. Results depend on
  // the order of sights, and so this does not depend on threads.
  template <typename Candidates, typename F>
  void
  append_all(const Loop& loop, const std::size_t number, Candidates& candidates, const F& append)
  {
    constexpr std::size_t fewest_tasks = 16;
    if(loop.is_parallel() && number >= fewest_tasks)
      append_in_parallel(loop, number, candidates, append);
    else
      for(std::size_t i = 0; i < number; ++i)
      {
        append(i, candidates, Sink(*this));
        if(i < m_resumed.size())
          release(m_resumed[i]);
      }
    if(is_any_waiting())
    {
      const auto [label, tip] = next_label_and_tip();
      candidates.call_again(tip, label);
    }
  }

  std::size_t memory() const
  {
    std::size_t result = memory_of(m_beyond);
    const auto add = [&](const std::vector<List>& lists) {
      result += memory_of(lists);
      for(const List& list : lists)
        result += memory_of(list);
    };
    add(m_of_tasks);
    add(m_unused);
    add(m_resumed);
    for(const Blocks& blocks : m_steps)
      add(blocks);
    return result;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t number_of_steps = 16, steps_to_horizon = 8;
  static constexpr std::size_t sights_in_block = 64;

  using Blocks = std::vector<List>; // those of a step have sights

  bool is_any_waiting() const
  {
    return !m_beyond.empty() || std::any_of(m_steps.begin(), m_steps.end(),
                                            [](const Blocks& blocks) { return !blocks.empty(); });
  }

  // The label at which the search reaches the next sights, and a tip, whose label is smaller.
  // \pre A sight is waiting.
  std::pair<double, Deferred_sight::Index> next_label_and_tip() const
  {
    for(std::size_t i = 0; i < number_of_steps; ++i)
      if(const Blocks& blocks = m_steps[(m_first + i) % number_of_steps]; !blocks.empty())
        return {m_next_step + static_cast<double>(i) * m_step, blocks.front().front().tip};
    return {m_next_step + number_of_steps * m_step, m_beyond.front().tip};
  }

  template <typename Candidates, typename F>
  void append_in_parallel(const Loop& loop,
                          const std::size_t number,
                          Candidates& candidates,
                          const F& append)
  {
    m_of_tasks.resize((std::max)(m_of_tasks.size(), number));
    candidates.append_in_parallel(loop, number, [&](const std::size_t i, Candidates& part) {
      append(i, part, Sink(m_of_tasks[i]));
    });
    for(std::size_t i = 0; i < number; ++i)
    {
      for(const Deferred_sight& sight : m_of_tasks[i])
        list_of(sight.smallest_label).push_back(sight);
      m_of_tasks[i].clear();
    }
  }

  List& list_of(const double smallest_label)
  {
    const double step = (smallest_label - m_next_step) / m_step;
    return step < number_of_steps
               ? open_block(m_steps[(m_first + static_cast<std::size_t>(step)) % number_of_steps])
               : m_beyond;
  }

  // The last block, where there is room for one more sight.
  List& open_block(Blocks& blocks)
  {
    if(blocks.empty() || blocks.back().size() == sights_in_block)
    {
      if(m_unused.empty())
        m_unused.emplace_back().reserve(sights_in_block);
      blocks.push_back(std::move(m_unused.back()));
      m_unused.pop_back();
    }
    return blocks.back();
  }

  void release(List& block)
  {
    if(block.capacity() == 0) // released before
      return;
    block.clear();
    m_unused.push_back(std::move(block));
  }

  void clear(Blocks& blocks)
  {
    for(List& block : blocks)
      release(block);
    blocks.clear();
  }

  void take_next_step()
  {
    Blocks& blocks = m_steps[m_first];
    std::move(blocks.begin(), blocks.end(), std::back_inserter(m_resumed));
    blocks.clear();
    m_first = (m_first + 1) % number_of_steps;
    m_next_step += m_step;
  }

  // Moves sights beyond the last bucket, as behind long edges, to the buckets, or resumes them.
  void sort_beyond()
  {
    const double end = m_next_step + number_of_steps * m_step;
    const auto first =
        std::partition(m_beyond.begin(), m_beyond.end(),
                       [&](const Deferred_sight& s) { return s.smallest_label >= end; });
    for(auto s = first; s != m_beyond.end(); ++s)
    {
      const double step = (s->smallest_label - m_next_step) / m_step;
      const auto i = // not beyond the last bucket, by rounding
          (std::min)(static_cast<std::size_t>((std::max)(step, 0.)), number_of_steps - 1);
      open_block(step > 0 ? m_steps[(m_first + i) % number_of_steps] : m_resumed).push_back(*s);
    }
    m_beyond.erase(first, m_beyond.end());
  }

  std::array<Blocks, number_of_steps> m_steps; // a ring, from `m_first` on
  std::size_t m_first = 0;
  List m_beyond; // the last of these
  Blocks m_resumed, m_unused;
  std::vector<List> m_of_tasks;
  double m_next_step = infinity, m_step = infinity, m_distance = infinity;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_DEFERRED_SIGHTS_H
