// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_WALKS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_WALKS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queries/karcher_mean.h>
#include <CGAL/Approximate_geodesics/Queries/shorten_loop.h>
#include <CGAL/Approximate_geodesics/Queries/trace_geodesic.h>
#include <CGAL/Approximate_geodesics/Solver/Solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * Straight walks and loops on the surface of a `Solver`. They depend neither on the bound of the
 * solver nor on its costs and barriers. The header is not part of `Solver.h`, as programs for
 * distances do not need it.
 *
 * A direction is a vector in space, of which the part along the surface counts, or a
 * `Tangent_vector`, whose frame at a vertex `find_frames()` gives. All `const` member functions are
 * thread-safe.
 */
class Solver_walks
{
  using Kernel = Simple_cartesian<double>;
  using Mesh = Surface_mesh<Kernel::Point_3>;
  using Point = Surface_point<Mesh>;
  using Vector_3 = Kernel::Vector_3;
  using Vertex_index_map = decltype(get(boost::vertex_index, std::declval<const Mesh&>()));

public:
  /// a vector in space.
  using Vector = std::array<double, 3>;

  /// A straight walk.
  struct Walk
  {
    std::vector<double> coordinates; ///< those of its points, three each
    Vector direction;                ///< the direction at its end, of length `1`
    double length;                   ///< its length
    bool meets_border;               ///< whether it has ended early at the border
  };

  /// A closed curve.
  struct Loop
  {
    std::vector<double> coordinates; ///< those of its points, three each; the first one is also the
                                     ///< last, unless there is only one
    double length;                   ///< its length; infinity if there is none
  };

  /// A mean of points.
  struct Mean
  {
    Solver_point point; ///< the mean
    double deviation;   ///< the square root of the mean of the squared distances from it
    bool has_converged; ///< whether it is a local minimum, up to rounding
  };

  /// reads the mesh of a solver, which is referred to, not copied. It takes about 300 bytes per
  /// vertex.
  /// \throws std::invalid_argument if a face breaks the triangle inequality.
  explicit Solver_walks(const Solver& solver)
    : m_solver(solver),
      m_tracer(solver.mesh()),
      m_graph(internal::graph_with_epsilon<Saddle_vertex_graph, Sequential_tag>(
          Intrinsic_triangulation(solver.mesh()), 0)),
      m_translation(solver.mesh(), get(boost::vertex_index, solver.mesh()), m_graph.triangulation())
  {
    m_translation.list_vertices();
  }

  /// not copyable.
  Solver_walks(const Solver_walks&) = delete;
  Solver_walks& operator=(const Solver_walks&) = delete;

  /// walks straight ahead, as `trace_geodesic()` does.
  template <typename Direction>
  Walk trace(const Solver_point& start, const Direction& direction, const double length) const
  {
    const auto walk = m_tracer.trace(point(start, "start"), vector(direction), length);
    Walk result{{}, {}, walk.length, walk.meets_border};
    for(const Point& p : walk.points)
      append(p, result.coordinates);
    // out of the surface, if it could not begin
    if(walk.length > 0)
      result.direction = numbers(m_tracer.vector_3(walk.points.back(), walk.direction));
    return result;
  }

  /// writes the logarithmic map of a point, two numbers per vertex, as `logarithmic_map()` computes
  /// it.
  void find_logarithms(const Solver_point& source, double* vectors) const
  {
    const Intrinsic_point p = intrinsic_point(source, "source");
    Surface_search<Saddle_vertex_graph> search(m_graph);
    Geodesic_visitor_base visitor; // as in the compiled searches
    search.run({{p}}, {}, visitor);
    internal::Logarithms logarithms(search, p);
    for(const auto v : m_solver.mesh().vertices())
    {
      const Tangent_vector vector = logarithms(m_translation.node(v));
      *vectors++ = vector.x;
      *vectors++ = vector.y;
    }
  }

  /// transports a vector along a shortest path, as `parallel_transport()` does, and returns it in
  /// the frame of the target.
  /// \throws std::invalid_argument if there is no path.
  template <typename Direction>
  Tangent_vector transport(const Solver_point& source,
                           const Solver_point& target,
                           const Direction& direction) const
  {
    const auto path =
        path_between(intrinsic_point(source, "source"), intrinsic_point(target, "target"));
    if(path.empty())
      internal::reject("there is no path to transport the vector along");
    std::vector<Point> points;
    for(const Intrinsic_point& p : path)
      points.push_back(m_translation.surface_point(p));
    return m_tracer.transport(points, vector(direction));
  }

  /// returns the vector in space that a tangent vector at a point stands for.
  Vector vector_3(const Solver_point& p, const Tangent_vector& v) const
  {
    return numbers(m_tracer.vector_3(point(p, "point"), v));
  }

  /// finds a mean of points, as `karcher_mean()` does.
  Mean find_mean(const std::vector<Solver_point>& points, const std::vector<double>& weights) const
  {
    if(points.empty())
      internal::reject("there are no points to find the mean of");
    std::vector<double> shares = internal::shares(weights, points.size());
    internal::Mean_search search(m_graph, intrinsic_points(points, "point"), std::move(shares));
    constexpr std::size_t largest_number_of_iterations = 100;
    search.run(largest_number_of_iterations);
    return {solver_point(search.point()), search.deviation() * m_graph.triangulation().unit(),
            search.has_converged()};
  }

  /// shortens a closed curve, as `shorten_loop()` does. Points that have no face in common with the
  /// next one are joined to it by a shortest path.
  Loop shorten_loop(const std::vector<Solver_point>& curve) const
  {
    const std::vector<Intrinsic_point> points = intrinsic_points(curve, "point");
    if(points.empty())
      internal::reject("the loop has no points");
    Path loop{{points.front()}, 0};
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const Intrinsic_point &p = points[i], &q = points[(i + 1) % points.size()];
      if(std::isinf(internal::shortest_segment(m_graph.triangulation(), p, q).length))
      {
        const auto path = path_between(p, q);
        if(path.empty())
          internal::reject("there is no path from point " + std::to_string(i) + " to the next one");
        loop.points.insert(loop.points.end(), path.begin() + 1, path.end() - 1);
      }
      loop.points.push_back(q);
    }
    return loop_of(Loop_straightener(m_graph.triangulation()).shortened(loop));
  }

  /// finds a shortest loop through a point, as `shortest_loop_through()` does. It has no points if
  /// there is none.
  Loop shortest_loop_through(const Solver_point& p) const
  {
    return loop_of(internal::shortest_loop(m_graph, intrinsic_point(p, "point")));
  }

  /// writes the axes of the frame of each vertex, of length `1` in the plane that is orthogonal to
  /// the normal there, and that normal: the sum of those of the faces, weighted by their areas.
  /// They are zero at isolated vertices.
  void find_frames(double* x_axes, double* y_axes, double* normals) const
  {
    for(const auto v : m_solver.mesh().vertices())
    {
      const Vector normal = normal_at(v);
      Vector x{0, 0, 0};
      if(!m_solver.mesh().is_isolated(v))
        x = numbers(m_tracer.vector_3(Point(v), Tangent_vector{1, 0}));
      x = internal::unit_vector(internal::linear_combination(x, -internal::dot(x, normal), normal));
      const Vector y = internal::cross_product(normal, x);
      x_axes = std::copy(x.begin(), x.end(), x_axes);
      y_axes = std::copy(y.begin(), y.end(), y_axes);
      normals = std::copy(normal.begin(), normal.end(), normals);
    }
  }

private:
  // ----- points

  Point point(const Solver_point& p, const std::string& role) const
  {
    return m_translation.surface_point(intrinsic_point(p, role));
  }

  Intrinsic_point intrinsic_point(const Solver_point& p, const std::string& role) const
  {
    return std::visit([&](const auto& q) { return m_translation.intrinsic_point(q); },
                      m_solver.surface_point(p, role));
  }

  std::vector<Intrinsic_point> intrinsic_points(const std::vector<Solver_point>& points,
                                                const std::string& role) const
  {
    std::vector<Intrinsic_point> result;
    for(const Solver_point& p : points)
      result.push_back(intrinsic_point(p, role + ' ' + std::to_string(result.size())));
    return result;
  }

  Solver_point solver_point(const Intrinsic_point& p) const
  {
    const Point place = m_translation.surface_point(p);
    if(const auto* const v = std::get_if<Mesh::Vertex_index>(&place))
      return Solver_point::at_vertex(*v);
    if(const auto* const location = std::get_if<Face_location<Mesh>>(&place))
      return Solver_point::in_face(location->first, location->second);
    const auto& [h, t] = std::get<std::pair<Mesh::Halfedge_index, double>>(place);
    return Solver_point::on_edge(m_solver.mesh().source(h), m_solver.mesh().target(h), t);
  }

  void append(const Point& p, std::vector<double>& coordinates) const
  {
    const Kernel::Point_3 position = m_tracer.point_3(p);
    coordinates.insert(coordinates.end(), {position.x(), position.y(), position.z()});
  }

  Loop loop_of(const Path& path) const
  {
    Loop result{{}, path.points.empty() ? internal::infinity : path.length};
    for(const Intrinsic_point& p : path.points)
      append(m_translation.surface_point(p), result.coordinates);
    return result;
  }

  // Empty if there is none.
  std::vector<Intrinsic_point> path_between(const Intrinsic_point& p,
                                            const Intrinsic_point& q) const
  {
    Surface_search<Saddle_vertex_graph> search(m_graph);
    search.run_to(q, {{p}});
    Path path = search.find_path(q);
    std::reverse(path.points.begin(), path.points.end());
    return std::move(path.points);
  }

  // ----- vectors

  static Tangent_vector vector(const Tangent_vector& v) { return v; }
  static Vector_3 vector(const Vector& v) { return {v[0], v[1], v[2]}; }
  static Vector numbers(const Vector_3& v) { return {v.x(), v.y(), v.z()}; }

  Vector normal_at(const Mesh::Vertex_index v) const
  {
    const Mesh& mesh = m_solver.mesh();
    Vector_3 result(0, 0, 0);
    if(!mesh.is_isolated(v))
      for(const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
        if(!mesh.is_border(h))
        {
          const auto& p = mesh.point(v);
          result += cross_product(mesh.point(mesh.target(mesh.next(h))) - p,
                                  mesh.point(mesh.source(h)) - p);
        }
    return internal::unit_vector(numbers(result));
  }

  const Solver& m_solver;
  const Geodesic_tracer<Mesh> m_tracer;
  const Saddle_vertex_graph m_graph;
  Mesh_translation<Mesh, Vertex_index_map> m_translation;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_WALKS_H
