// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_LOGARITHMIC_MAP_H
#define CGAL_GEODESIC_CONSTRUCTIONS_LOGARITHMIC_MAP_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Queries/internal/compiled_searches.h>
#include <CGAL/Geodesic_constructions/trace_geodesic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

// The line from the start of a shortest path to its first vertex, or to its end. The angle is that
// in the frame of the start.
struct First_line
{
  double angle, length;
};

/*
 * Finds first lines of paths: lays out the faces that they cross around their start. So directions
 * are those of long lines, and accurate.
 */
class First_lines
{
public:
  explicit First_lines(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation), m_frames(triangulation)
  {
  }

  // \pre There are at least two points.
  First_line operator()(const std::vector<Intrinsic_point>& points) const
  {
    if(points.size() > 2 && points[1].is_on_edge())
      for(const Index g : {points[1].halfedge, m_triangulation.opposite(points[1].halfedge)})
        if(const std::optional<First_line> line = line_across(g, points))
          return *line;
    return {m_frames.angle_toward(points[0], points[1]).value_or(0),
            shortest_segment(m_triangulation, points[0], points[1]).length};
  }

  // How much the angle of a vector grows by parallel transport along a shortest path, which is
  // straight between vertices.
  double turn(const std::vector<Intrinsic_point>& path) const
  {
    double result = 0;
    std::vector<Intrinsic_point> line;
    const std::vector<Intrinsic_point> points = with_vertices(path);
    for(auto first = points.begin(); first + 1 != points.end();)
    {
      const auto last = std::find_if(first + 1, points.end() - 1,
                                     [](const Intrinsic_point& p) { return p.is_vertex(); });
      line.assign(first, last + 1);
      result -= (*this)(line).angle;
      std::reverse(line.begin(), line.end());
      result += (*this)(line).angle + straight_angle;
      first = last;
    }
    return result;
  }

private:
  // Crossings at the end of an edge are at its vertex, where there may be several of them.
  std::vector<Intrinsic_point> with_vertices(const std::vector<Intrinsic_point>& path) const
  {
    std::vector<Intrinsic_point> result;
    for(const Intrinsic_point& p : path)
    {
      const Intrinsic_point q = p.reduced(m_triangulation);
      if(result.empty() || !q.is_vertex() || q.vertex != result.back().vertex)
        result.push_back(q);
    }
    return result;
  }

  // The first line of a path that first crosses the edge of `g`, into the face to its left; none if
  // that edge is not one of the face where the path starts.
  std::optional<First_line> line_across(Index g, const std::vector<Intrinsic_point>& points) const
  {
    const Index first = m_triangulation.opposite(g);
    std::optional<Face_point> start;
    if(!m_triangulation.is_border(first))
      for_each_face_point(m_triangulation, points[0], first, [&](const Face_point& p) {
        start = p.seen_from(m_triangulation, first);
      });
    if(!start)
      return std::nullopt;
    const Face_layout face(m_triangulation, first);
    const std::optional<Plane_vector> way =
        way_across(g, face.vector_to_corner(1, *start), face.edge(1, 0), points);
    if(!way)
      return std::nullopt;
    return First_line{m_frames.angle_in_face(points[0], *start, face, *way), length(*way)};
  }

  // The position of the first vertex, or of the end, where the source of `g`, and its vector, are
  // laid out around the start.
  std::optional<Plane_vector> way_across(Index g,
                                         Plane_vector left,
                                         Plane_vector edge,
                                         const std::vector<Intrinsic_point>& points) const
  {
    for(std::size_t i = 2; !m_triangulation.is_border(g); ++i)
    {
      const Intrinsic_point& p = points[i];
      const Face_step step = Face_step::of(m_triangulation, m_triangulation.source(g), g);
      const Plane_vector left_side = step.left_side(edge), apex = left + left_side;
      if(p.is_vertex() || i + 1 == points.size())
      {
        std::optional<Plane_vector> result;
        for_each_face_point(m_triangulation, p, g, [&](const Face_point& q) {
          result = q.seen_from(m_triangulation, g).position({left, left + edge, apex});
        });
        return result;
      }
      const auto is_crossed = [&](const Index h) {
        return h != null_index && p.is_on_edge_of(h, m_triangulation);
      };
      if(!is_crossed(step.left) && !is_crossed(step.right))
        return std::nullopt;
      const bool goes_right = !is_crossed(step.left);
      g = goes_right ? step.right : step.left;
      left = goes_right ? apex : left;
      edge = goes_right ? step.right_edge(edge) : left_side;
    }
    return std::nullopt;
  }

  const Intrinsic_triangulation& m_triangulation;
  const Tangent_frames m_frames;
};

/*
 * The directions and lengths of shortest paths from the source of an exact search to all vertices.
 * Paths over a vertex start like the path to that vertex, so only lines from the source are traced.
 */
class Logarithms
{
  using Search = Surface_search<Saddle_vertex_graph>;
  using Node = Search::Node;

public:
  // The search has run from `source` only.
  Logarithms(const Search& search, const Intrinsic_point& source)
    : m_search(search),
      m_source(source),
      m_first_lines(search.graph().triangulation()),
      m_angles(search.graph().number_of_nodes(), unknown())
  {
    if(source.is_vertex())
      m_angles[source.vertex] = 0;
  }

  // Infinitely long if the vertex was not reached.
  Tangent_vector operator()(const Node node)
  {
    if(node == Search::Search::null_node || !m_search.search().is_reached(node))
      return {infinity, 0};
    m_nodes.clear();
    Node first = node;
    for(; std::isnan(m_angles[first]) && !is_first(first);
        first = m_search.search().predecessor(first))
      m_nodes.push_back(first);
    if(std::isnan(m_angles[first]))
      m_angles[first] = angle_of_line(first);
    for(const Node n : m_nodes)
      m_angles[n] = m_angles[first];
    return tangent_vector(m_angles[first], m_search.search().distance(node));
  }

private:
  static double unknown() { return std::numeric_limits<double>::quiet_NaN(); }

  // Whether there is no other vertex on the path, but the source.
  bool is_first(const Node node) const
  {
    const Node before = m_search.search().predecessor(node);
    return before == Search::Search::null_node || before == m_source.vertex;
  }

  // The angle of the straight line from the source.
  double angle_of_line(const Node node)
  {
    m_points.assign(1, m_source);
    m_search.search().graph_run().for_each_crossing_from(
        m_source, 0, node, m_search.search().labels(), Append_crossing{m_points});
    m_points.push_back(Intrinsic_point::at_vertex(node));
    return m_first_lines(m_points).angle;
  }

  const Search& m_search;
  const Intrinsic_point m_source;
  const First_lines m_first_lines;
  std::vector<double> m_angles; // by node; NaN where it is not known
  std::vector<Node> m_nodes;    // on a path
  std::vector<Intrinsic_point> m_points;
};

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsWalks
 *
 * computes the logarithmic map of a point: for each vertex, the direction at the point in which a
 * shortest path to the vertex starts, and its length, which is the distance, as a tangent vector.
 *
 * It is the inverse of `trace_geodesic()`: a walk from the source with the direction and the length
 * of its vector ends at the vertex, up to rounding, if a single shortest path leads there, and
 * passes no vertex on its way. Behind a vertex with an angle of more than \f$2\pi\f$, shortest
 * paths that bend there start in the same direction. On the cut locus, where several shortest paths
 * end, one of them is taken.
 *
 * Distances and directions are exact, up to rounding: they are those of the paths that `epsilon(0)`
 * finds. The vectors of all vertices are a chart of the surface around the point, for example for
 * textures.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexVectorMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `Tangent_vector`
 *         as value type
 * \tparam Point `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, `Face_location`, or
 *         `Surface_point`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param vertex_vector_map receives one vector per vertex, in the frame of `source` that
 *        `Tangent_vector` describes; the zero vector at the source, and an infinitely long vector
 *        if the vertex is not reached
 * \param source the point
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map`, `edge_length_map`, `concurrency_tag`, `maximum_distance`,
 *           `vertex_index_map`, `halfedge_index_map` and `geom_traits`, as for
 *           `approximate_geodesic_distances()`
 *
 * \throws std::invalid_argument as `approximate_geodesic_distances()` does, and if a path cannot be
 *         traced across nearly degenerate faces, see `Surface_search::find_path()`. In these cases,
 *         nothing is written.
 * \throws std::length_error if `tmesh` has too many halfedges for 32-bit indices.
 *
 * It takes an exact search, and tracing one straight line per vertex that is reached from the
 * source without a bend; on usual meshes, this is about as much.
 *
 * \sa `trace_geodesic()`
 * \sa `karcher_mean()`
 */
template <typename TriangleMesh,
          typename VertexVectorMap,
          typename Point,
          typename NamedParameters = parameters::Default_named_parameters>
void logarithmic_map(const TriangleMesh& tmesh,
                     VertexVectorMap vertex_vector_map,
                     const Point& source,
                     const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::ignores_any<NamedParameters, internal_np::edge_length_t,
                                       internal_np::maximum_distance_t>,
                "logarithmic_map() is exact, and reads edge_length_map and maximum_distance only");
  const auto graph = internal::exact_graph(tmesh, np);
  const Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np),
                                     graph.triangulation());
  const Intrinsic_point point = internal::intrinsic_point(translation, source, "source");
  Surface_search<Saddle_vertex_graph> search(graph);
  Geodesic_visitor_base visitor; // as in the compiled searches
  search.run({{point}}, {internal::maximum_distance(np)}, visitor);

  internal::Logarithms logarithms(search, point);
  std::vector<Tangent_vector> vectors;
  for(const auto v : vertices(tmesh))
    vectors.push_back(logarithms(translation.node(v)));
  std::size_t i = 0;
  for(const auto v : vertices(tmesh))
    put(vertex_vector_map, v, vectors[i++]);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_LOGARITHMIC_MAP_H
