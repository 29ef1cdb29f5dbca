// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_CURVE_READER_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_CURVE_READER_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/other_sources.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Converts a region. Its border is divided into closed polylines.
template <typename Translation>
Intrinsic_curve intrinsic_curve(const Translation& translation,
                                const Intrinsic_triangulation& triangulation,
                                const Source_region<typename Translation::Triangle_mesh>& region)
{
  if(region.faces.empty())
    reject("a region has no faces");
  Intrinsic_curve result;
  std::set<Index> faces; // their smallest halfedges
  for(const auto f : region.faces)
  {
    const Index h = translation.halfedge_of(f);
    if(faces.insert(triangulation.first_of_face(h)).second)
      result.faces.push_back(h);
  }
  const auto is_inside = [&](const Index h) {
    return !triangulation.is_border(h) && faces.count(triangulation.first_of_face(h)) > 0;
  };
  std::set<Index> passed;
  for(const Index face : result.faces)
    for(Index h : triangulation.halfedges_of_face(face))
    {
      if(is_inside(triangulation.opposite(h)) || passed.count(h) > 0)
        continue;
      auto& polyline = result.polylines.emplace_back();
      while(passed.insert(h).second)
      {
        polyline.push_back(Intrinsic_point::at_vertex(triangulation.source(h)));
        h = triangulation.next(h);
        while(is_inside(triangulation.opposite(h)))
          h = triangulation.next(triangulation.opposite(h));
      }
      polyline.push_back(polyline.front());
    }
  return result;
}

/*
 * Converts curves of a mesh. Points that are not in the same face are joined by shortest paths, for
 * which a workspace is made when they are needed.
 */
template <typename Graph, typename Translation>
class Curve_reader
{
  using Triangle_mesh = typename Translation::Triangle_mesh;

public:
  // Both are referred to, not copied.
  Curve_reader(const Graph& graph, const Translation& translation)
    : m_graph(graph), m_translation(translation)
  {
  }

  Intrinsic_curve read(const Source_region<Triangle_mesh>& region)
  {
    return intrinsic_curve(m_translation, m_graph.triangulation(), region);
  }

  Intrinsic_curve read(const Source_curve<Triangle_mesh>& curve)
  {
    std::vector<Intrinsic_point> points =
        intrinsic_points(m_translation, curve.points, "point of a curve");
    if(points.empty())
      reject("a curve has no points");
    if(curve.is_closed)
      points.push_back(points.front());
    Intrinsic_curve result;
    auto& polyline = result.polylines.emplace_back(1, points.front());
    for(std::size_t i = 1; i < points.size(); ++i)
      append(points[i], i, polyline);
    return result;
  }

  // Reads a curve or a region, or a range of them.
  template <typename Curves>
  std::vector<Intrinsic_curve> read_all(const Curves& curves)
  {
    std::vector<Intrinsic_curve> result;
    if constexpr(is_other_source<Triangle_mesh, Curves>)
      result.push_back(read(curves));
    else
      for(const auto& curve : curves)
        result.push_back(name_in_message([&] { return name_in_list("source", result.size()); },
                                         [&] { return read(curve); }));
    return result;
  }

private:
  void append(const Intrinsic_point& p, const std::size_t i, std::vector<Intrinsic_point>& polyline)
  {
    const Intrinsic_point last = polyline.back();
    if(!p.is_same(last, m_graph.triangulation()) &&
       !(shortest_segment(m_graph.triangulation(), last, p).length < infinity))
    {
      if(!m_search)
        m_search = std::make_unique<Surface_search<Graph>>(m_graph);
      m_search->run_to(last, {{p}});
      const std::vector<Intrinsic_point> path = m_search->find_path(last).points;
      if(path.empty())
        reject("no path joins points " + std::to_string(i - 1) + " and " + std::to_string(i) +
               " of a curve, counted from 0");
      polyline.insert(polyline.end(), path.begin() + 1, path.end() - 1);
    }
    polyline.push_back(p);
  }

  const Graph& m_graph;
  const Translation& m_translation;
  std::unique_ptr<Surface_search<Graph>> m_search;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_CURVE_READER_H
