// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_KNOWN_DISTANCES_H
#define APPROXIMATE_GEODESICS_TEST_KNOWN_DISTANCES_H

#include "meshes/hostile_meshes.h"
#include "oracles/long_double_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// What a distance on a mesh can be at least and at most, and how much of it a `double` can know.

namespace geodesics_test {

// ----- points of the surface in `long double`

// The corners of the faces around a point, or those of its edge.
inline std::vector<std::pair<Vertex, Long>> parts(const Mesh& mesh, const Surface_point& p)
{
  if(const auto* v = std::get_if<Vertex>(&p))
    return {{*v, 1}};
  if(const auto* e = std::get_if<Edge_location>(&p))
    return {{mesh.source(e->first), 1 - Long(e->second)}, {mesh.target(e->first), e->second}};
  const auto& [f, weights] = std::get<Face_location>(p);
  const Halfedge h = mesh.halfedge(f);
  return {{mesh.source(h), weights[0]},
          {mesh.target(h), weights[1]},
          {mesh.target(mesh.next(h)), weights[2]}};
}

// Seen from a vertex that is not far, as the origin may be.
inline Long_point position_from(const Mesh& mesh, const Vertex origin, const Surface_point& p)
{
  Long_point result{};
  for(const auto& [v, weight] : parts(mesh, p))
    for(std::size_t i = 0; i < 3; ++i)
      result[i] += weight * (long_point(mesh.point(v)) - long_point(mesh.point(origin)))[i];
  return result;
}

inline Long straight_line(const Mesh& mesh, const Surface_point& p, const Surface_point& q)
{
  const Vertex origin = parts(mesh, p).front().first;
  return long_distance(position_from(mesh, origin, p), position_from(mesh, origin, q));
}

// ----- what is known of the distances

class Known_distances
{
public:
  explicit Known_distances(const Hostile_mesh& hostile)
    : row(hostile),
      mesh(row.mesh),
      m_layout(row.layout),
      m_edges(graph_of_edges(mesh)),
      m_rounding(mesh)
  {
    constexpr std::size_t largest = 300; // what each vertex sees takes long to find out
    if(mesh.number_of_faces() <= largest)
      m_lines = Lines_of_sight(mesh).graph();
  }

  // along edges
  Long longest(const Vertex s, const Vertex t) { return from(m_edges, m_by_edges, s)[t.idx()]; }

  // across faces, or a lower bound of that
  Long shortest(const Vertex s, const Vertex t)
  {
    if(!m_layout.empty())
      return long_distance(long_point(m_layout[s.idx()]), long_point(m_layout[t.idx()]));
    if(m_lines)
      return from(*m_lines, m_by_lines, s)[t.idx()];
    return long_distance(long_point(mesh.point(s)), long_point(mesh.point(t)));
  }

  bool is_exact() const { return m_lines.has_value(); }

  // between any points of the surface, by way of the corners next to them
  Long longest(const Surface_point& p, const Surface_point& q)
  {
    Long result = infinity;
    for(const auto& [v, v_weight] : parts(mesh, p))
      for(const auto& [w, w_weight] : parts(mesh, q))
        result = (std::min)(result,
                            straight_line(mesh, p, v) + longest(v, w) + straight_line(mesh, w, q));
    return result;
  }

  Long shortest(const Surface_point& p, const Surface_point& q)
  {
    const auto *v = std::get_if<Vertex>(&p), *w = std::get_if<Vertex>(&q);
    if(v != nullptr && w != nullptr)
      return shortest(*v, *w);
    return straight_line(mesh, p, q);
  }

  // how far a path of this length can be from the right one
  Long rounding(const Surface_point& p, const Long length) const
  {
    const Vertex v = parts(mesh, p).front().first;
    return Long(1e-12) * length +
           m_rounding.error_of_path(long_point(mesh.point(v)), length + straight_line(mesh, p, v));
  }

  // of the heights of faces that have hardly any
  Long error_of_flat_faces() const { return m_rounding.error_of_flat_faces(); }

  std::vector<Long> lengths_of_edges() const
  {
    std::vector<Long> result;
    for(const Edge e : mesh.edges())
      result.push_back(straight_line(mesh, mesh.vertex(e, 0), mesh.vertex(e, 1)));
    return result;
  }

  const Hostile_mesh& row;
  const Mesh& mesh;

private:
  using By_source = std::map<Vertex, std::vector<Long>>;

  static const std::vector<Long>& from(const Long_graph& graph, By_source& known, const Vertex s)
  {
    const auto [it, is_new] = known.try_emplace(s);
    if(is_new)
      it->second = graph.distances(s.idx());
    return it->second;
  }

  const std::vector<Point> m_layout;
  const Long_graph m_edges;
  std::optional<Long_graph> m_lines;
  Rounding_of_lengths m_rounding;
  By_source m_by_edges, m_by_lines;
};

// ----- all meshes

// Where paths do not run across faces.
inline const std::set<std::string>& refused_across_faces()
{
  static const std::set<std::string> result = [] {
    std::set<std::string> names;
    for(const Hostile_mesh& row : accepted_meshes())
      if(!row.refusal_across_faces.empty())
        names.insert(row.name);
    return names;
  }();
  return result;
}

// Calls `f(known)` for each that is not left out by its name.
template <typename F>
void for_accepted_meshes(const std::set<std::string>& left_out, F f)
{
  for(const Hostile_mesh& row : accepted_meshes())
    if(left_out.count(row.name) == 0)
    {
      SCOPED_TRACE(row.name);
      Known_distances known(row);
      f(known);
    }
}

// ----- what is expected of a graph

struct Bound
{
  bool is_along_edges = false;
  double epsilon = infinity; // of what is the shortest way between vertices, if there is a bound
  double of_edges = 0;       // of what is the shortest way along edges, which all graphs know
};

// The length of any path that a graph has found, or -1 if there is none.
inline void expect_length(const double found,
                          Known_distances& known,
                          const Bound& bound,
                          const Surface_point& p,
                          const Surface_point& q)
{
  const Long along_edges = known.longest(p, q);
  if(along_edges == infinity)
  {
    EXPECT_EQ(found, -1);
    return;
  }
  const Long shortest = known.shortest(p, q), rounding = known.rounding(p, along_edges);
  EXPECT_GE(found, 0);
  EXPECT_GE(found, shortest - rounding);
  EXPECT_LE(found, along_edges * (1 + bound.of_edges) + rounding);
  if(bound.epsilon < infinity && known.is_exact() && std::holds_alternative<Vertex>(p) &&
     std::holds_alternative<Vertex>(q))
  {
    EXPECT_LE(found, shortest * (1 + bound.epsilon) + rounding);
  }
}

// The same of a path that was not straightened.
inline void expect_distance(const double found,
                            Known_distances& known,
                            const Bound& bound,
                            const Surface_point& p,
                            const Surface_point& q)
{
  expect_length(found, known, bound, p, q);
  if(bound.is_along_edges && found >= 0 && std::holds_alternative<Vertex>(p) &&
     std::holds_alternative<Vertex>(q))
  {
    EXPECT_NEAR(found, double(known.longest(p, q)),
                1e-13 * found + std::numeric_limits<double>::denorm_min());
  }
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_KNOWN_DISTANCES_H
