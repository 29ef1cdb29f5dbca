// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_CURVE_SOURCES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_CURVE_SOURCES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Paths/internal/Sources.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/internal/Curves/lines_from_curves.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Curves as the sources of a search. The foot of a path is the point of a curve where it starts.
 */
template <typename Search, typename Answer>
class Curve_sources final : public Attached_sources<Search, Answer>
{
  using Base = Attached_sources<Search, Answer>;
  using typename Base::Find_entries;
  using typename Base::Graph;
  using typename Base::Node;
  using typename Base::Seed;
  using Run = typename Search::Run;

public:
  // Checks the curves. The triangulation is referred to.
  Curve_sources(const Intrinsic_triangulation& triangulation, std::vector<Intrinsic_curve> curves)
    : m_curves(std::move(curves))
  {
    check(triangulation);
    for(std::size_t i = 0; i < m_curves.size(); ++i)
    {
      for(auto& polyline : m_curves[i].polylines)
        prepare(triangulation, i, polyline);
      for(const Index h : m_curves[i].faces)
        m_faces.emplace_back(triangulation.first_of_face(h), i);
    }
    std::sort(m_faces.begin(), m_faces.end());
    m_segments = Segments_by_face(triangulation, m_curves);
  }

  const std::vector<Intrinsic_curve>& curves() const { return m_curves; }

  std::vector<Seed> seeds(const Graph& graph) override
  {
    std::vector<Seed> result;
    for(std::size_t i = 0; i < m_curves.size(); ++i)
      for_each_line(graph, m_curves[i],
                    [&](const Node node, const double length, const Intrinsic_point& foot) {
                      if(length < infinity)
                        result.push_back({node, m_curves[i].distance + length * graph.unit(),
                                          add_foot(foot, i)});
                    });
    return result;
  }

  // Always finds entries, as these tell a run that it starts from curves. If a run finds lines from
  // labels, the seeds are only upper bounds.
  Find_entries find_entries(const Search& search, const std::vector<Seed>& seeds) override
  {
    return [&] {
      std::vector<typename Search::Entry> result;
      if constexpr(Run::attaches_by_labels)
        append_lines_by_labels(search, result);
      else
        for(const Seed& seed : seeds)
          result.push_back({seed, {}});
      return result;
    };
  }

  // The curves with faces around the point are considered, too.
  void consider_lines(const Graph& graph, const Intrinsic_point& point, Answer& best) const override
  {
    const std::size_t around = curve_around(graph.triangulation(), point);
    if(around != null_index && m_curves[around].distance < best.distance)
      best = {m_curves[around].distance, around, null_index, 0, point};
    if(!point.is_vertex())
      attach_target(graph, point)
          .for_each_point(m_segments,
                          [&](const std::size_t i, const double length, const double t) {
                            consider_line(graph, i, length, t, best);
                          });
  }

  void consider_lines_by_labels([[maybe_unused]] const Search& search,
                                [[maybe_unused]] const Intrinsic_point& point,
                                [[maybe_unused]] const double largest,
                                [[maybe_unused]] Answer& best) const override
  {
    if constexpr(Run::attaches_by_labels)
      search.graph_run().for_each_line_to(
          point, largest, search.labels(), m_segments,
          [&](const Node node, const double length) { Base::consider(search, node, length, best); },
          [&](const std::size_t i, const double length, const double t) {
            consider_line(search.graph(), i, length, t, best);
          });
  }

  Intrinsic_point position(const std::size_t foot) const override { return m_feet[foot]; }

  double distance(const std::size_t source) const override { return m_curves[source].distance; }

private:
  // The lines where a search starts whose run finds them from labels.
  void append_lines_by_labels(const Search& search, std::vector<typename Search::Entry>& result)
  {
    m_feet.clear();
    this->m_sources_of_feet.clear();
    const double unit = search.graph().unit();
    for(std::size_t i = 0; i < m_curves.size(); ++i)
      for_each_line_by_labels(
          search.graph(), search.graph_run(), m_curves[i], m_curves[i].distance / unit,
          [&](const Node node, const double length, const auto& payload,
              const Intrinsic_point& foot) {
            result.push_back(
                {{node, m_curves[i].distance + length * unit, add_foot(foot, i)}, payload});
          });
  }

  // Considers the line of this length from the part `t` of a segment.
  void consider_line(const Graph& graph,
                     const std::size_t segment,
                     const double length,
                     const double t,
                     Answer& best) const
  {
    const auto& [from, to, curve] = m_segments[segment];
    const double distance = m_curves[curve].distance + length * graph.unit();
    if(distance < best.distance)
      best = {distance, curve, null_index, length,
              m_segments[segment].point(graph.triangulation(), t)};
  }

  // The nearest of the curves that have the point in one of their faces; null_index if there is
  // none.
  std::size_t curve_around(const Intrinsic_triangulation& triangulation,
                           const Intrinsic_point& point) const
  {
    std::size_t result = null_index;
    if(!m_faces.empty())
      point.for_each_face(triangulation, [&](const Index h) {
        const Index face = triangulation.first_of_face(h);
        for(auto it = std::lower_bound(m_faces.begin(), m_faces.end(),
                                       std::make_pair(face, std::size_t(0)));
            it != m_faces.end() && it->first == face; ++it)
          if(result == null_index || m_curves[it->second].distance < m_curves[result].distance)
            result = it->second;
      });
    return result;
  }

  void check(const Intrinsic_triangulation& triangulation) const
  {
    if(triangulation.has_directional_costs())
      reject("Directional_graph: curves are no sources where costs depend on the direction");
    for(std::size_t i = 0; i < m_curves.size(); ++i)
    {
      check_initial_distance(m_curves[i].distance, i);
      for(const auto& polyline : m_curves[i].polylines)
        for(const Intrinsic_point& p : polyline)
          check_point(p, triangulation);
      for(const Index h : m_curves[i].faces)
        if(!(h < triangulation.number_of_halfedges()) || triangulation.is_border(h))
          reject("source " + std::to_string(i) + " has a face that does not exist");
    }
  }

  // Adds a foot, and returns its number.
  std::size_t add_foot(const Intrinsic_point& point, const std::size_t curve)
  {
    m_feet.push_back(point);
    this->m_sources_of_feet.push_back(curve);
    return m_feet.size() - 1;
  }

  // Calls `f(node, length, foot)` for the lines from a curve to nodes of a graph.
  template <typename F>
  static void for_each_line(const Graph& graph, const Intrinsic_curve& curve, F f)
  {
    Known_labels labels(graph.number_of_nodes());
    const auto report = [&](const Index node, const double length, const Intrinsic_point& foot) {
      labels.lower(node, length);
      f(node, length, foot);
    };
    std::vector<Curve_sample> samples;
    for(const auto& polyline : curve.polylines)
      for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
        for_each_node_beside(graph, polyline[i], polyline[i + 1], report,
                             [&](const Curve_sample& s) { samples.push_back(s); });
    std::vector<Intrinsic_point> points = curve_points(graph, curve);
    remove_duplicates(points);
    for(const Intrinsic_point& p : points)
      if(p.is_vertex())
        labels.lower(p.vertex, 0);
    const auto report_from = [&](const Intrinsic_point& p) {
      return [&](const Index node, const double length) { report(node, length, p); };
    };
    for(const Intrinsic_point& p : points)
      for_each_node_from(graph, p, labels, report_from(p));
    for(const Curve_sample& s : samples)
      for_each_node_from_sample(graph, s, labels, report_from(s.point));
  }

  // Upper bounds of distances from a curve.
  class Known_labels
  {
  public:
    explicit Known_labels(const std::size_t number_of_nodes) : m_labels(number_of_nodes, infinity)
    {
    }

    double distance(const Index node) const { return m_labels[node]; }

    void lower(const Index node, const double label)
    {
      m_labels[node] = (std::min)(m_labels[node], label);
    }

  private:
    std::vector<double> m_labels;
  };

  // The points of a curve where lines may start that make no right angle with it.
  static std::vector<Intrinsic_point> curve_points(const Graph& graph, const Intrinsic_curve& curve)
  {
    std::vector<Intrinsic_point> result;
    for(const auto& points : curve.polylines)
      for(std::size_t i = 0; i < points.size(); ++i)
        if(!is_superfluous(graph, points, i))
          result.push_back(points[i]);
    for(const Index h : curve.faces)
      for(const Index side : graph.triangulation().halfedges_of_face(h))
        result.push_back(Intrinsic_point::at_vertex(graph.triangulation().target(side)));
    return result;
  }

  static void prepare(const Intrinsic_triangulation& triangulation,
                      const std::size_t curve,
                      std::vector<Intrinsic_point>& points)
  {
    const auto name = [&] { return "curve " + std::to_string(curve) + ", counted from 0, "; };
    if(points.empty())
      reject(name() + "has a polyline without points");
    std::vector<Intrinsic_point> result;
    for(const Intrinsic_point& p : points)
      if(const Intrinsic_point q = p.reduced(triangulation);
         result.empty() || !q.is_same(result.back(), triangulation))
      {
        if(!result.empty() &&
           !(shortest_segment(triangulation, result.back(), q).length < infinity))
          reject(name() + "has two consecutive points that are not in the same face");
        result.push_back(q);
      }
    points = std::move(result);
  }

  // Whether the lines from a vertex of a curve are redundant, as the curve is straight there: lines
  // across edges reach all that those from there would reach.
  static bool is_superfluous(const Graph& graph,
                             const std::vector<Intrinsic_point>& points,
                             const std::size_t i)
  {
    if constexpr(!attaches_in_cones<Graph>)
      return false;
    else
    {
      const std::size_t last = points.size() - 1;
      const bool is_inside = i > 0 && i < last;
      const bool is_joint =
          i == 0 && last > 2 && points[0].is_same(points[last], graph.triangulation());
      if(i == last && last > 2 && points[0].is_same(points[last], graph.triangulation()))
        return true; // it is the first one
      return (is_inside || is_joint) &&
             is_straight(graph.triangulation(), points[is_joint ? last - 1 : i - 1], points[i],
                         points[i + 1]);
    }
  }

  static void remove_duplicates(std::vector<Intrinsic_point>& points)
  {
    const auto key = [](const Intrinsic_point& p) {
      return std::make_tuple(p.vertex, p.halfedge, p.t, p.s);
    };
    std::sort(points.begin(), points.end(),
              [&](const auto& p, const auto& q) { return key(p) < key(q); });
    points.erase(std::unique(points.begin(), points.end(),
                             [&](const auto& p, const auto& q) { return key(p) == key(q); }),
                 points.end());
  }

  std::vector<Intrinsic_curve> m_curves;
  Segments_by_face m_segments;
  std::vector<std::pair<Index, std::size_t>> m_faces; // sorted; with their curves
  std::vector<Intrinsic_point> m_feet;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_CURVE_SOURCES_H
