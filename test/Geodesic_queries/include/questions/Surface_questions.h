// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_SURFACE_QUESTIONS_H
#define APPROXIMATE_GEODESICS_TEST_SURFACE_QUESTIONS_H

#include "questions/Node_questions.h"

#include <CGAL/Geodesic_constructions/search_from_curves.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_test {

/*
 * Questions to a `Guided_search` about points, which may be guided by landmarks or positions.
 * Those about pairs are also compared with searches that nothing guides.
 */
template <typename Search>
class Surface_questions
{
  using Graph = typename Search::Graph;
  using Point = CGAL::Approximate_geodesics::Intrinsic_point;
  using Points = std::vector<Point>;
  using Sources = std::vector<CGAL::Approximate_geodesics::Source_point>;
  using Stop_rule = typename Search::Stop_rule;
  using Landmarks = typename Search::Landmarks;
  using Positions = CGAL::Approximate_geodesics::Vertex_positions;

  static constexpr double unreached = std::numeric_limits<double>::infinity();

public:
  // Questions are about these points.
  Surface_questions(const Graph& graph,
                    Points points,
                    const Positions& positions,
                    const Answer_kind& kind)
    : m_graph(graph),
      m_points(std::move(points)),
      m_positions(positions),
      m_used(graph),
      m_kind(kind)
  {
  }

  void prepare([[maybe_unused]] const std::size_t number_of_landmarks)
  {
    if constexpr(CGAL::Approximate_geodesics::internal::has_asymmetry<Graph> ||
                 CGAL::Approximate_geodesics::internal::can_stay_in_corridor<Graph>)
    {
      auto landmarks = std::make_unique<const Landmarks>(m_graph, number_of_landmarks);
      m_used.use_landmarks(*landmarks);
      m_landmarks = std::move(landmarks);
    }
  }

  template <typename Choices>
  std::string ask(Choices& choices)
  {
    switch(choices.below(8))
    {
    case 0:
      return about_all(choices);
    case 1:
      return with_visitor(choices);
    case 2:
      return after_changes(choices);
    case 3:
      return about_curve(choices);
    case 4:
      return about_nothing(choices);
    default:
      return about_pair(choices);
    }
  }

private:
  template <typename Choices>
  const Point& point(Choices& choices) const
  {
    return m_points[choices.below(m_points.size())];
  }

  template <typename Choices>
  Sources sources(Choices& choices) const
  {
    Sources result;
    for(std::size_t i = chosen(choices, 16) ? 0 : 1 + choices.below(2); i > 0; --i)
      result.push_back({point(choices), m_kind.has_initial_distances && chosen(choices, 2)
                                            ? chosen_part(choices)
                                            : 0});
    return result;
  }

  template <typename Choices>
  Stop_rule stop(Choices& choices) const
  {
    const bool has_limit = chosen(choices, 2) && (m_kind.keeps_order || m_kind.deviation == 0);
    Stop_rule result{has_limit ? 4 * chosen_part(choices) : unreached};
    if(chosen(choices, 2))
      result.targets = {point(choices), point(choices)};
    return result;
  }

  Search new_search() const
  {
    Search result(m_graph);
    if constexpr(CGAL::Approximate_geodesics::internal::has_asymmetry<Graph> ||
                 CGAL::Approximate_geodesics::internal::can_stay_in_corridor<Graph>)
      if(m_landmarks)
        result.use_landmarks(*m_landmarks);
    return result;
  }

  template <typename Choices>
  std::string about_all(Choices& choices)
  {
    const Sources s = sources(choices);
    const Stop_rule rule = stop(choices);
    Search fresh = new_search();
    m_used.run(s, rule);
    fresh.run(s, rule);
    return compare_all(fresh, m_kind.keeps_order || rule.targets.empty() ? m_points : rule.targets);
  }

  template <typename Choices>
  std::string with_visitor(Choices& choices)
  {
    const Sources s = sources(choices);
    Recorder<typename Search::Node> recorder;
    const std::size_t last = choices.below(m_graph.number_of_nodes() + 1);
    (chosen(choices, 2) ? recorder.throw_at : recorder.stop_at) = last;
    Search fresh = new_search();
    const auto throws = [&](Search& search) {
      auto visitor = recorder;
      try
      {
        search.run(s, {}, visitor);
        return false;
      }
      catch(const std::runtime_error&)
      {
        return true;
      }
    };
    const bool has_thrown = throws(m_used);
    if(has_thrown != throws(fresh))
      return m_kind.keeps_order ? "only one has thrown; " : "";
    return has_thrown || m_kind.keeps_order ? compare_all(fresh, m_points) : std::string();
  }

  // Repairs what there is by now.
  template <typename Choices>
  std::string after_changes(Choices& choices)
  {
    const Sources s = sources(choices);
    m_used.repair(s);
    Search fresh = new_search();
    fresh.run(s);
    std::string result;
    for(const Point& p : m_points)
      result +=
          difference("repaired distance", m_used.distance(p), fresh.distance(p), m_kind.deviation);
    return result;
  }

  template <typename Choices>
  std::string about_curve(Choices& choices)
  {
    if constexpr(!CGAL::Approximate_geodesics::internal::has_curves<Graph>)
      return about_all(choices);
    else
    {
      const auto& t = m_graph.triangulation();
      if(t.has_directional_costs()) // for which there are no curves
        return about_all(choices);
      const auto h = static_cast<typename Search::Node>(choices.below(t.number_of_halfedges()));
      const std::vector<CGAL::Approximate_geodesics::Intrinsic_curve> curves = {
          {{{Point::at_vertex(t.source(h)), Point::at_vertex(t.target(h))}}, {}, 0}};
      Search fresh = new_search();
      CGAL::Approximate_geodesics::run_from_curves(m_used, curves);
      CGAL::Approximate_geodesics::run_from_curves(fresh, curves);
      return compare_all(fresh, m_points);
    }
  }

  // Input that is refused, and changes nothing.
  template <typename Choices>
  std::string about_nothing(Choices& choices)
  {
    const Sources s = sources(choices);
    const Stop_rule near{0.01 * chosen_part(choices)};
    m_used.run(s, near);
    bool is_refused = false;
    try
    {
      m_used.run(sources(choices), {std::numeric_limits<double>::quiet_NaN()});
    }
    catch(const std::invalid_argument&)
    {
      is_refused = true;
    }
    Search fresh = new_search();
    fresh.run(s, near);
    return (is_refused ? "" : "NaN is accepted; ") + compare_all(fresh, m_points);
  }

  template <typename Choices>
  std::string about_pair(Choices& choices)
  {
    const Point source = point(choices), target = point(choices);
    const double limit = chosen(choices, 3) ? 4 * chosen_part(choices) : unreached;
    const bool knows_positions = chosen(choices, 4);
    const auto find = [&](Search& search) {
      if(!knows_positions)
        return pair_distances(search, {{source, target}}, limit)[0];
      search.run_to(target, {{source}}, m_positions, limit);
      return search.distance(target);
    };
    Search fresh = new_search(), unguided(m_graph);
    const double found = find(m_used);
    std::string result =
        difference("pair", found, find(fresh), m_kind.keeps_order ? 0 : m_kind.deviation);
    if(!knows_positions && limit == unreached)
      result += compare_paths(pair_paths(m_used, {{source, target}})[0], found);
    const double deviation = m_kind.deviation_of_pairs;
    if(knows_positions)
      unguided.run({{source}}, {unreached, {target}});
    const double expected = knows_positions ? unguided.distance(target)
                                            : pair_distances(unguided, {{source, target}})[0];
    if(std::abs(expected - limit) <= deviation * limit) // and may exceed it
      return result;
    return result +
           difference("unguided", found, expected <= limit ? expected : unreached, deviation);
  }

  static std::string compare_paths(const CGAL::Approximate_geodesics::Path& path,
                                   const double distance)
  {
    constexpr double rounding = 1e-6; // of arcs in single precision
    if(path.points.empty() || std::isinf(distance))
      return path.points.empty() == std::isinf(distance) ? "" : "a path is missing; ";
    return path.length <= distance * (1 + rounding) ? ""
                                                    : difference("path", path.length, distance);
  }

  std::string compare_all(const Search& fresh, const Points& points) const
  {
    std::string result;
    for(const Point& p : points)
    {
      const auto found = m_used.nearest(p), expected = fresh.nearest(p);
      result += difference("distance", found.distance, expected.distance,
                           m_kind.keeps_order ? 0 : m_kind.deviation);
      if(m_kind.keeps_order ? found.source != expected.source || found.node != expected.node
                            : found.is_reached() != expected.is_reached())
        result += "it is another source or node; ";
    }
    return result;
  }

  const Graph& m_graph;
  const Points m_points;
  const Positions& m_positions;
  std::unique_ptr<const Landmarks> m_landmarks;
  Search m_used;
  Answer_kind m_kind;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_SURFACE_QUESTIONS_H
