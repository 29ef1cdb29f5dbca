// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_WALKS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_WALKS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Geodesic_constructions/Source_curve.h>
#include <CGAL/Geodesic_constructions/karcher_mean.h>
#include <CGAL/Geodesic_constructions/shorten_loop.h>
#include <CGAL/Geodesic_constructions/trace_geodesic.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * Straight walks and loops on the surface of a `Solver`. They depend neither on the bound of the
 * solver nor on its costs and barriers. The header is not part of `Solver.h`, as programs for
 * distances do not need it.
 *
 * A direction is a vector in space, of which the part along the surface counts, or a
 * `Tangent_vector`, whose frame at a vertex `find_frames()` gives. All `const` member functions are
 * thread-safe. A watch is told the progress of each search.
 */
class Solver_walks
{
  using Kernel = Simple_cartesian<double>;
  using Mesh = Solver::Mesh;
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

  /// A locally shortest curve.
  struct Curve
  {
    std::vector<double> coordinates; ///< those of its points, three each; the first one of a loop
                                     ///< is also the last. There is only one if it contracts to it
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
  explicit Solver_walks(const Solver& solver, const Solver_watch& watch = Solver_watch())
    : Solver_walks(solver, internal::Solver_visitor(watch))
  {
  }

  /// not copyable.
  Solver_walks(const Solver_walks&) = delete;
  Solver_walks& operator=(const Solver_walks&) = delete;

  /// walks straight ahead, as `trace_geodesic()` does.
  template <typename Direction>
  Walk trace(const Solver_point& start,
             const Direction& direction,
             const double length,
             const Solver_watch& watch = Solver_watch()) const
  {
    const internal::Solver_visitor visitor(watch);
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
  void find_logarithms(const Solver_point& source,
                       double* vectors,
                       const Solver_watch& watch = Solver_watch()) const
  {
    internal::Solver_visitor visitor(watch);
    const Intrinsic_point p = intrinsic_point(source, "source");
    Search search(m_graph);
    run(search, {p});
    internal::Logarithms logarithms(search, p);
    for(const auto v : vertices(m_solver.mesh()))
    {
      internal::check_for_interruption_at(v);
      vectors = write(logarithms(m_translation.node(v)), vectors);
    }
    visitor.finish();
  }

  /// transports a vector along a shortest path, as `parallel_transport()` does, and returns it in
  /// the frame of the target.
  /// \throws std::invalid_argument if there is no path.
  template <typename Direction>
  Tangent_vector transport(const Solver_point& source,
                           const Solver_point& target,
                           const Direction& direction,
                           const Solver_watch& watch = Solver_watch()) const
  {
    const internal::Solver_visitor visitor(watch);
    const Intrinsic_point p = intrinsic_point(source, "source"),
                          q = intrinsic_point(target, "target");
    Search search(m_graph);
    search.run_to(q, {{p}});
    const Path path = search.find_path(q);
    if(path.points.empty())
      internal::reject("there is no path to transport the vector along");
    std::vector<Point> points;
    std::transform(path.points.rbegin(), path.points.rend(), std::back_inserter(points),
                   [&](const Intrinsic_point& r) { return m_translation.surface_point(r); });
    return m_tracer.transport(points, vector(direction));
  }

  /// writes, for each vertex, the vector of the nearest source after it has been transported along
  /// a shortest path, two numbers in the frame of the vertex; zeros if it is not reached.
  void extend_vectors(const std::vector<Solver_point>& sources,
                      const std::vector<Tangent_vector>& vectors,
                      double* extended,
                      const Solver_watch& watch = Solver_watch()) const
  {
    internal::Solver_visitor visitor(watch);
    if(vectors.size() != sources.size())
      internal::reject("there are " + std::to_string(sources.size()) + " sources, and " +
                       std::to_string(vectors.size()) + " vectors");
    for(std::size_t i = 0; i < vectors.size(); ++i)
      internal::check_tangent_vector(vectors[i], ("vector " + std::to_string(i)).c_str());
    Search search(m_graph);
    run(search, intrinsic_points(sources, "source"));
    const internal::First_lines lines(m_graph.triangulation());
    for(const auto v : vertices(m_solver.mesh()))
    {
      internal::check_for_interruption_at(v);
      Tangent_vector result;
      if(const auto node = m_translation.node(v); node != Search::Search::null_node)
        if(const std::size_t source = search.source(node); source != Search::null_source)
        {
          const Path path = search.find_path(Intrinsic_point::at_vertex(node)); // to the source
          result = internal::tangent_vector(internal::angle_of(vectors[source]) -
                                                lines.turn(path.points),
                                            internal::length(vectors[source]));
        }
      extended = write(result, extended);
    }
    visitor.finish();
  }

  /// returns the vector in space that a tangent vector at a point stands for.
  Vector vector_3(const Solver_point& p, const Tangent_vector& v) const
  {
    return numbers(m_tracer.vector_3(point(p, "point"), v));
  }

  /// finds a mean of points, as `karcher_mean()` does.
  Mean find_mean(const std::vector<Solver_point>& points,
                 const std::vector<double>& weights,
                 const Solver_watch& watch = Solver_watch()) const
  {
    const internal::Solver_visitor visitor(watch);
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
  Curve shorten_loop(const std::vector<Solver_point>& points,
                     const Solver_watch& watch = Solver_watch()) const
  {
    const internal::Solver_visitor visitor(watch);
    return curve_of(Loop_straightener(m_graph.triangulation()).shortened(path(points, true)));
  }

  /// shortens a curve in the same way, but keeps its ends where they are.
  Curve shorten_curve(const std::vector<Solver_point>& points,
                      const Solver_watch& watch = Solver_watch()) const
  {
    const internal::Solver_visitor visitor(watch);
    const Loop_straightener straightener(m_graph.triangulation());
    return curve_of(straightener.shortened_with_fixed_ends(path(points, false)));
  }

  /// finds a shortest loop through a point, as `shortest_loop_through()` does. It has no points if
  /// there is none.
  Curve shortest_loop_through(const Solver_point& p,
                              const Solver_watch& watch = Solver_watch()) const
  {
    const internal::Solver_visitor visitor(watch);
    return curve_of(internal::shortest_loop(m_graph, intrinsic_point(p, "point")));
  }

  /// writes the axes of the frame of each vertex, of length `1` in the plane that is orthogonal to
  /// the normal there, and that normal: the sum of those of the faces, weighted by their areas.
  /// They are zero at isolated vertices.
  void find_frames(double* x_axes, double* y_axes, double* normals) const
  {
    for(const auto v : vertices(m_solver.mesh()))
    {
      const Vector normal = normal_at(v);
      Vector x{0, 0, 0};
      if(halfedge(v, m_solver.mesh()) != Mesh::Halfedge_index())
        x = numbers(m_tracer.vector_3(Point(v), Tangent_vector{1, 0}));
      x = internal::unit_vector(internal::linear_combination(x, -internal::dot(x, normal), normal));
      const Vector y = internal::cross_product(normal, x);
      x_axes = std::copy(x.begin(), x.end(), x_axes);
      y_axes = std::copy(y.begin(), y.end(), y_axes);
      normals = std::copy(normal.begin(), normal.end(), normals);
    }
  }

private:
  using Search = Surface_search<Saddle_vertex_graph>;

  // The visitor watches the construction.
  Solver_walks(const Solver& solver, internal::Solver_visitor&& visitor)
    : m_solver(solver),
      m_tracer(solver.mesh()),
      m_graph(internal::graph_with_epsilon<Saddle_vertex_graph, Sequential_tag>(
          Intrinsic_triangulation(solver.mesh()), 0)),
      m_translation(solver.mesh(), get(boost::vertex_index, solver.mesh()), m_graph.triangulation())
  {
    m_translation.list_vertices();
    visitor.finish();
  }

  static void run(Search& search, const std::vector<Intrinsic_point>& sources)
  {
    std::vector<Source_point> points;
    for(const Intrinsic_point& p : sources)
      points.push_back({p});
    Geodesic_visitor_base visitor; // as in the compiled searches
    search.run(std::move(points), {}, visitor);
  }

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
    return Solver_point::on_edge(source(h, m_solver.mesh()), target(h, m_solver.mesh()), t);
  }

  void append(const Point& p, std::vector<double>& coordinates) const
  {
    const Kernel::Point_3 position = m_tracer.point_3(p);
    coordinates.insert(coordinates.end(), {position.x(), position.y(), position.z()});
  }

  // Along the curve that points of the mesh stand for.
  Path path(const std::vector<Solver_point>& points, const bool is_closed) const
  {
    Source_curve<Mesh> curve{{}, is_closed};
    for(const Intrinsic_point& p : intrinsic_points(points, "point"))
      curve.points.push_back(m_translation.surface_point(p));
    internal::Curve_reader reader(m_graph, m_translation);
    return {reader.read(curve).polylines.front(), 0};
  }

  Curve curve_of(const Path& path) const
  {
    Curve result{{}, path.points.empty() ? internal::infinity : path.length};
    for(const Intrinsic_point& p : path.points)
      append(m_translation.surface_point(p), result.coordinates);
    return result;
  }

  // ----- vectors

  static Tangent_vector vector(const Tangent_vector& v) { return v; }
  static Vector_3 vector(const Vector& v) { return {v[0], v[1], v[2]}; }
  static Vector numbers(const Vector_3& v) { return {v.x(), v.y(), v.z()}; }

  static double* write(const Tangent_vector& v, double* const numbers)
  {
    numbers[0] = v.x;
    numbers[1] = v.y;
    return numbers + 2;
  }

  Vector normal_at(const Mesh::Vertex_index v) const
  {
    const Mesh& mesh = m_solver.mesh();
    Vector_3 result(0, 0, 0);
    if(halfedge(v, mesh) != Mesh::Halfedge_index())
      for(const auto h : halfedges_around_target(v, mesh))
        if(!is_border(h, mesh))
        {
          const auto& p = mesh.point(v);
          result += cross_product(mesh.point(target(next(h, mesh), mesh)) - p,
                                  mesh.point(source(h, mesh)) - p);
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
