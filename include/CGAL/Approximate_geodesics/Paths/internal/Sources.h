// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SOURCES_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SOURCES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Source_point.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Search/internal/extensions.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The sources of a `Surface_search`, of one kind. The core has `Point_sources`; packages may have
 * others, such as curves.
 *
 * Each path starts at a point of a source, its foot. `Search`, the search for distances of nodes,
 * takes each foot for a source of its own: the index of a seed's source is the number of its foot.
 * A search asks for seeds and entries once in a run, and for the rest once for each point whose
 * distance or path it is asked for; so virtual functions cost next to nothing.
 */
template <typename Search, typename Answer>
class Attached_sources
{
public:
  using Graph = typename Search::Graph;
  using Node = typename Search::Node;
  using Seed = typename Search::Seed;
  using Find_entries = typename Search::Find_entries;

  virtual ~Attached_sources() = default;

  // Returns a seed for each line from a source to a node.
  virtual std::vector<Seed> seeds(const Graph& graph) = 0;

  // Returns what finds the lines where a search with these seeds starts; empty if it is the seeds
  // where it starts. Both arguments are referred to.
  virtual Find_entries find_entries(const Search& search, const std::vector<Seed>& seeds) = 0;

  // Considers, for the answer at a point, the lines from sources that do not depend on labels.
  virtual void
  consider_lines(const Graph& graph, const Intrinsic_point& point, Answer& best) const = 0;

  // Considers the lines from nodes and sources that a run finds from labels, on paths that are not
  // longer than `largest`, in units of the graph. The point is not a vertex.
  virtual void consider_lines_by_labels(const Search& search,
                                        const Intrinsic_point& point,
                                        double largest,
                                        Answer& best) const = 0;

  // Returns where a foot is.
  virtual Intrinsic_point position(std::size_t foot) const = 0;

  // Returns the initial distance of a source.
  virtual double distance(std::size_t source) const = 0;

  // Returns the index of the source that a foot is part of.
  std::size_t source(const std::size_t foot) const
  {
    return m_sources_of_feet.empty() ? foot : m_sources_of_feet[foot];
  }

  // Considers the line of this length from a node.
  static void consider(const Search& search, const Node node, const double length, Answer& best)
  {
    const double distance = search.distance(node) + length * search.graph().unit();
    if(distance < best.distance)
      best = {distance, Search::null_source, node, length,
              Intrinsic_point::at_vertex(Intrinsic_triangulation::null_index)};
  }

protected:
  Attached_sources() = default;
  Attached_sources(Attached_sources&&) = default;
  Attached_sources& operator=(Attached_sources&&) = default;

  std::vector<std::size_t> m_sources_of_feet; // empty if each foot is a source
};

// Lists the lines between an attached point and nodes, in units of the graph. As they are listed,
// one instantiation of a graph's functions is enough.
template <typename Attachment>
void list_lines(const Attachment& attachment, std::vector<Last_arc>& lines)
{
  lines.clear();
  attachment.for_each_node([&](const Intrinsic_triangulation::Index node, const double length) {
    lines.push_back({node, length});
  });
}

/*
 * Points as the sources of a search. The foot of all paths from a point is the point itself.
 */
template <typename Search, typename Answer>
class Point_sources final : public Attached_sources<Search, Answer>
{
  using Base = Attached_sources<Search, Answer>;
  using typename Base::Find_entries;
  using typename Base::Graph;
  using typename Base::Node;
  using typename Base::Seed;
  using Run = typename Search::Run;

public:
  Point_sources() = default;

  // Checks the points. The triangulation is referred to.
  Point_sources(const Intrinsic_triangulation& triangulation, std::vector<Source_point> points)
    : m_points(std::move(points))
  {
    std::vector<Intrinsic_point> positions;
    positions.reserve(m_points.size());
    for(const Source_point& s : m_points)
    {
      check_point(s.point, triangulation);
      check_initial_distance(s.distance, positions.size());
      positions.push_back(s.point);
    }
    m_by_face = Points_by_face(triangulation, std::move(positions));
  }

  const std::vector<Source_point>& points() const { return m_points; }

  std::vector<Seed> seeds(const Graph& graph) override
  {
    std::vector<Seed> result;
    std::vector<Last_arc> lines;
    for(std::size_t i = 0; i < m_points.size(); ++i)
    {
      list_lines(graph.attach(m_points[i].point), lines);
      for(const auto& [node, length] : lines)
        if(length < std::numeric_limits<double>::infinity())
          result.push_back({node, m_points[i].distance + length * graph.unit(), i});
    }
    if constexpr(tells_free_arcs<Graph>)
      Free_ends<Graph>::add_seeds(graph, m_points, result);
    return result;
  }

  // Finds the ends of the lines from the points if lines are found from labels.
  Find_entries find_entries([[maybe_unused]] const Search& search,
                            const std::vector<Seed>& /* seeds */) override
  {
    if constexpr(!Run::attaches_by_labels)
      return {};
    else
      return [&] {
        std::vector<typename Search::Entry> result;
        const double unit = search.graph().unit();
        for(std::size_t i = 0; i < m_points.size(); ++i)
          search.graph_run().for_each_line_from(
              m_points[i].point, m_points[i].distance / unit,
              [&](const Node node, const double length, const typename Run::Payload& payload) {
                result.push_back({{node, m_points[i].distance + length * unit, i}, payload});
              });
        return result;
      };
  }

  void consider_lines(const Graph& graph, const Intrinsic_point& point, Answer& best) const override
  {
    if(!m_by_face.is_empty() && !point.is_vertex())
      attach_target(graph, point)
          .for_each_point(m_by_face, [&](const std::size_t i, const double length) {
            consider_line(graph, i, length, best);
          });
  }

  void consider_lines_by_labels([[maybe_unused]] const Search& search,
                                [[maybe_unused]] const Intrinsic_point& point,
                                [[maybe_unused]] const double largest,
                                [[maybe_unused]] Answer& best) const override
  {
    if constexpr(Run::attaches_by_labels)
      search.graph_run().for_each_line_to(
          point, largest, search.labels(), m_by_face,
          [&](const Node node, const double length) { Base::consider(search, node, length, best); },
          [&](const std::size_t i, const double length) {
            consider_line(search.graph(), i, length, best);
          });
  }

  Intrinsic_point position(const std::size_t foot) const override { return m_points[foot].point; }

  double distance(const std::size_t source) const override { return m_points[source].distance; }

private:
  // Considers the line of this length from a point.
  void
  consider_line(const Graph& graph, const std::size_t i, const double length, Answer& best) const
  {
    const double distance = m_points[i].distance + length * graph.unit();
    if(distance < best.distance)
      best = {distance, i, Search::null_node, length, m_points[i].point};
  }

  std::vector<Source_point> m_points;
  Points_by_face m_by_face;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SOURCES_H
