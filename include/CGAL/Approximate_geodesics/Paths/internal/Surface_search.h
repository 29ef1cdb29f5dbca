// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Euclidean_heuristic.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Path.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Search/internal/heuristics.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Points_by_face.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Where a search starts: a place, and a distance, in the unit of the mesh.
struct Source
{
  Intrinsic_point place;
  double distance = 0;
};

inline double checked_initial_distance(const double distance)
{
  if(!(distance >= 0) || std::isinf(distance))
    reject("the initial distance of a source is " + text_of(distance) +
           "; it must be a finite number that is not negative");
  return distance;
}

// Makes a run go on until the distance of a place is certain.
template <typename StopRule, typename GeodesicGraph>
void add_target(StopRule& stop, const GeodesicGraph& graph, const Intrinsic_point& place)
{
  if(place.is_vertex())
  {
    stop.targets.push_back(place.vertex);
    return;
  }
  stop.places.emplace_back();
  graph.for_each_arc(place, [&](const auto node, const double length) {
    stop.places.back().push_back({node, length * graph.unit()});
  });
}

/*
 * Searches a graph from any places of the surface, and tells the distances of any others: the ones
 * that are not nodes are joined to nodes, and to each other, as the graph says.
 */
template <typename GeodesicGraph, typename PriorityQueue>
class Surface_search
{
public:
  using Search = Propagation<GeodesicGraph, PriorityQueue>;
  using Node = typename Search::Node;
  using Stop_rule = typename Search::Stop_rule;

  static constexpr std::size_t null_source = Search::null_source;

  explicit Surface_search(const GeodesicGraph& graph) : m_graph(&graph), m_search(graph) {}

  const Search& search() const { return m_search; }
  Search& search() { return m_search; }

  // To be called when the lengths of the graph have changed.
  void restart()
  {
    Search search(*m_graph);
    search.collect_statistics(m_search.collects_statistics());
    m_search = std::move(search);
  }

  template <typename Visitor>
  void run(std::vector<Source> sources, const Stop_rule& stop, Visitor&& visitor)
  {
    set_sources(std::move(sources), stop);
    m_search.run(seeds(), stop, visitor);
  }

  // The same until the distance of `target` is certain, led there if an estimate of the rest of the
  // way is given. Then `target` is all that can be asked for.
  template <typename Estimate>
  void run_to(const Intrinsic_point& target,
              std::vector<Source> sources,
              Stop_rule stop,
              const Estimate& estimate)
  {
    set_sources(std::move(sources), stop);
    stop.maximum_distance = (std::min)(stop.maximum_distance, nearest_by_line(target).distance);
    add_target(stop, *m_graph, target);
    m_search.run_toward(seeds(), stop, estimate);
  }

  // How a place is reached: over a node, or straight from a source.
  struct Answer
  {
    double distance = std::numeric_limits<double>::infinity(); // in the unit of the mesh
    double last_length = 0; // of the line from the node or the source, in that of the graph
    Node node = Search::null_node;
    std::size_t source = null_source;

    bool is_reached() const { return source != null_source; }
  };

  Answer nearest(const Intrinsic_point& place) const
  {
    Answer result = nearest_by_line(place);
    if(place.is_vertex())
      consider(place.vertex, 0, result);
    else
      m_graph->for_each_arc(
          place, [&](const Node node, const double length) { consider(node, length, result); });
    if(result.node != Search::null_node)
      result.source = m_search.source(result.node);
    const bool is_known =
        result.distance <= m_maximum_distance && m_search.is_certain(result.distance);
    return is_known ? result : Answer();
  }

  // The path from a place to its nearest source; without points if none has reached it.
  Path find_path(const Intrinsic_point& place) const
  {
    Path result;
    const Answer answer = nearest(place);
    if(!answer.is_reached())
      return result;
    result.points.push_back(place);
    const Source& source = m_sources[answer.source];
    if(answer.node == Search::null_node)
      append_line(place, source.place, source.place, answer.last_length, result);
    else
    {
      if(!place.is_vertex())
        append_line(place, answer.node, internal::place(*m_graph, answer.node), answer.last_length,
                    result);
      append_line_to_source(append_tree_path(m_search, answer.node, result), source, result);
    }
    return result;
  }

  // The same, led by the straight line if positions are known.
  void run_to(const Intrinsic_point& target,
              std::vector<Source> sources,
              const Stop_rule& stop,
              const Vertex_positions& positions)
  {
    if(positions.are_known())
      run_to(target, std::move(sources), stop,
             Euclidean_heuristic<GeodesicGraph>(*m_graph, positions, target));
    else
      run_to(target, std::move(sources), stop, No_heuristic());
  }

private:
  void set_sources(std::vector<Source> sources, const Stop_rule& stop)
  {
    m_sources = std::move(sources);
    m_maximum_distance = stop.maximum_distance;
    std::vector<Intrinsic_point> places;
    for(const Source& s : m_sources)
      places.push_back(s.place);
    m_places = Points_by_face(m_graph->triangulation(), places);
  }

  std::vector<typename Search::Seed> seeds() const
  {
    std::vector<typename Search::Seed> result;
    for(std::size_t i = 0; i < m_sources.size(); ++i)
    {
      const Source& s = m_sources[i];
      m_graph->for_each_arc(s.place, [&](const Node node, const double length) {
        if(length < std::numeric_limits<double>::infinity())
          result.push_back({node, s.distance + length * m_graph->unit(), i});
      });
    }
    return result;
  }

  Answer nearest_by_line(const Intrinsic_point& place) const
  {
    Answer result;
    if(!m_places.is_empty() && !place.is_vertex())
      m_graph->for_each_line(place, m_places, [&](const std::size_t i, const double length) {
        const double distance = m_sources[i].distance + length * m_graph->unit();
        if(distance < result.distance)
          result = {distance, length, Search::null_node, i};
      });
    return result;
  }

  void consider(const Node node, const double length, Answer& best) const
  {
    const double distance = m_search.distance(node) + length * m_graph->unit();
    if(distance < best.distance)
      best = {distance, length, node, null_source};
  }

  // Appends the line from where the path has got to, to a node or place `to`, which is at `end`.
  template <typename End>
  void append_line(const Intrinsic_point& from,
                   const End& to,
                   const Intrinsic_point& end,
                   const double length,
                   Path& path) const
  {
    path.length += m_graph->for_each_crossing(from, to, length, [&](const Node h, const double t) {
      path.points.push_back(Intrinsic_point::on_edge(h, t));
    });
    append(end, m_graph->triangulation(), path);
  }

  // Appends the line from the node that the search has started with to the source.
  void append_line_to_source(const Node first, const Source& source, Path& path) const
  {
    if(source.place.is_vertex())
      return;
    const double length = (m_search.distance(first) - source.distance) / m_graph->unit();
    const auto beyond = static_cast<std::ptrdiff_t>(path.points.size());
    path.length +=
        m_graph->for_each_crossing(source.place, first, length, [&](const Node h, const double t) {
          path.points.push_back(Intrinsic_point::on_edge(h, t));
        });
    std::reverse(path.points.begin() + beyond, path.points.end());
    append(source.place, m_graph->triangulation(), path);
  }

  const GeodesicGraph* m_graph;
  Search m_search;
  std::vector<Source> m_sources;
  Points_by_face m_places; // of the sources
  double m_maximum_distance = std::numeric_limits<double>::infinity();
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_SEARCH_H
