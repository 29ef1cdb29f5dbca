// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Queries/internal/compiled_searches.h>
#include <CGAL/Approximate_geodesics/Queries/internal/straighten.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Array_costs.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Array_mesh.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_file.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_graph.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_visitor.h>
#include <CGAL/Approximate_geodesics/Solver/internal/make_solver_graph.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

/*!
 * \defgroup PkgGeodesicLibrariesArrays Plain Arrays
 * \ingroup PkgGeodesicLibrariesRef
 *
 * The class `CGAL::Approximate_geodesics::Solver` takes vertices and faces as plain arrays, for
 * programs without mesh types and for bindings to other languages. Its headers are in the folder
 * `libraries/solver`, and its CMake target is `Approximate_geodesics::Solver`. The Python and
 * JavaScript packages in the folder `bindings` wrap it.
 */

namespace CGAL::Approximate_geodesics {
namespace internal {

// Calls `f` in a task arena of `number` threads, including this one; `0` selects one per core.
// Arenas are kept per thread, because some versions of TBB leak memory when an arena is destroyed.
template <typename F>
void with_threads([[maybe_unused]] const std::size_t number, const F& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  constexpr std::size_t most = 1 << 16;
  if(number > most)
    reject("the number of threads is " + std::to_string(number) + ", more than " +
           std::to_string(most));
  if(number == 0 || number >= static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()))
    return f();
  thread_local std::map<std::size_t, tbb::task_arena> arenas;
  arenas.try_emplace(number, static_cast<int>(number)).first->second.execute(f);
#else
  f();
#endif
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * Distances and paths on a mesh given by plain arrays, for programs without mesh types and for
 * bindings to other languages. This type offers the class `Surface_mesh_shortest_path` and the
 * functions of the package, with a graph that is chosen at run time.
 *
 * Vertices and faces are identified by their array indices. All `const` member functions are
 * thread-safe; each concurrent call uses its own workspace.
 *
 * All member functions throw `std::invalid_argument` with a message that names the invalid element,
 * such as "face 17 has vertex 99", and `Solver_interrupted` if the watch ends the call.
 */
class Solver
{
  friend class Solver_pairs;

public:
  /// the type of the mesh: a `Triangle_soup_mesh` on arrays of the solver.
  using Mesh = internal::Array_mesh;

private:
  using Vertex_index_map = decltype(get(boost::vertex_index, std::declval<const Mesh&>()));
  using Translation = Mesh_translation<Mesh, Vertex_index_map>;
  using Values_of_vertices = boost::iterator_property_map<const double*, Vertex_index_map>;

public:
  /// \name Creation
  /// @{

  /*!
   * reads a mesh, and builds the graph.
   *
   * \tparam Integer an integer type
   *
   * \param coordinates the coordinates of the vertices, three each
   * \param number_of_vertices their number
   * \param corners the vertices of the faces, three each, counterclockwise seen from one side of
   *        the surface
   * \param number_of_faces their number
   * \param options the bound, costs, and threads
   * \param watch is called during long steps
   *
   * \throws std::invalid_argument if a coordinate is not finite, a vertex of a face does not exist
   *         or occurs in it twice, the orientations of adjacent faces are inconsistent, or an edge
   *         or a vertex is not manifold.
   */
  template <typename Integer>
  Solver(const double* const coordinates,
         const std::size_t number_of_vertices,
         const Integer* const corners,
         const std::size_t number_of_faces,
         const Solver_options& options = Solver_options(),
         const Solver_watch& watch = Solver_watch())
    : m_costs(m_mesh)
  {
    internal::Solver_visitor visitor(watch);
    build(coordinates, number_of_vertices, corners, number_of_faces, options, nullptr);
    visitor.finish();
  }

  /// reads a solver from a binary stream written by `save()`.
  /// \throws std::invalid_argument if the stream does not contain a solver, or is damaged.
  explicit Solver(std::istream& in,
                  const std::size_t number_of_threads = 0,
                  const Solver_watch& watch = Solver_watch())
    : Solver(internal::bytes_from(in), number_of_threads, watch)
  {
  }

  /// does the same for bytes that `get(bytes, size)` writes to an array: the next ones, `size` of
  /// them, which may be `0`. It returns whether there are so many.
  explicit Solver(const std::function<bool(char*, std::size_t)>& get,
                  const std::size_t number_of_threads = 0,
                  const Solver_watch& watch = Solver_watch())
    : m_costs(m_mesh)
  {
    internal::Solver_visitor visitor(watch);
    internal::Solver_file file;
    file.read(get);
    Solver_options options;
    options.epsilon = file.epsilon;
    options.directional_cost = std::move(file.cost);
    options.max_slope = file.max_slope;
    options.accept_weaker_bound = file.accepts_weaker_bound;
    options.maximum_number_of_points = static_cast<std::size_t>(file.maximum_number_of_points);
    options.number_of_threads = number_of_threads;
    if(file.weights)
      options.face_weights = file.weights->data();
    // A graph for barriers is not saved, and without any, another one is built.
    const bool has_lost_barriers = file.barriers && file.barriers->empty();
    if(file.barriers)
    {
      options.barriers = file.barriers->data();
      options.number_of_barriers = file.barriers->size() / 2;
    }
    if(file.coordinates.size() % 3 != 0 || file.corners.size() % 3 != 0 ||
       (file.weights && file.weights->size() != file.corners.size() / 3))
      internal::reject("the file of the solver has arrays of inconsistent sizes");
    build(file.coordinates.data(), file.coordinates.size() / 3, file.corners.data(),
          file.corners.size() / 3, options, has_lost_barriers ? nullptr : &get);
    visitor.finish();
  }

  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// writes the mesh, the parameters, and the graph if it is expensive to build, to a binary
  /// stream.
  /// \throws std::runtime_error if writing fails.
  void save(std::ostream& out) const { save(internal::bytes_to(out)); }

  /// does the same by `put(bytes, size)`, which takes an array, and returns whether that was
  /// possible. If `size` is 0, it is to hand on all that it has taken.
  void save(const std::function<bool(const char*, std::size_t)>& put) const
  {
    internal::Solver_file(m_mesh, m_costs, m_bound).write(put);
    m_graph->save(put);
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the number of vertices.
  std::size_t number_of_vertices() const { return m_mesh.number_of_vertices(); }

  /// returns the number of faces.
  std::size_t number_of_faces() const { return m_mesh.number_of_faces(); }

  /// returns the requested bound, if any.
  std::optional<double> epsilon() const { return m_bound.epsilon; }

  /// returns the guaranteed bound: infinity for paths along edges, and if the costs admit no bound.
  double error_bound() const { return m_graph->error_bound(); }

  /// returns whether faces have weights.
  bool has_face_weights() const { return m_costs.has_weights(); }

  /// returns the directional costs, if there are any.
  const std::optional<Solver_cost>& directional_cost() const { return m_costs.directional_cost(); }

  /// returns the limit of slopes, or infinity if there is none.
  double max_slope() const { return m_costs.max_slope(); }

  /// returns whether any edges are barriers.
  bool has_barriers() const { return m_costs.has_barriers(); }

  /// returns the number of threads used for matrices; `0` means one per core.
  std::size_t number_of_threads() const { return m_number_of_threads; }

  /// returns the size of the graph and of the unused workspaces, in bytes. The mesh takes about 80
  /// more bytes per vertex.
  std::size_t memory() const { return m_graph->memory(); }

  /// writes the coordinates of the vertices, three each.
  void write_coordinates(double* coordinates) const
  {
    for(const auto v : vertices(m_mesh))
      coordinates = write(m_mesh.point(v), coordinates);
  }

  /// returns the mesh, in which vertices and faces have their array indices, for functions of
  /// \cgal. It refers to arrays of the solver, and so do copies of it.
  const Mesh& mesh() const { return m_mesh; }

  /// returns a point in terms of `mesh()`. Messages about invalid points begin with `role`.
  Surface_point<Mesh> surface_point(const Solver_point& point, const std::string& role) const
  {
    return m_translation->surface_point(intrinsic_point(point, role));
  }

  /// writes the vertices of the faces, three each.
  void write_corners(std::int64_t* corners) const
  {
    for(const auto f : faces(m_mesh))
      for(const auto h : halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        *corners++ = source(h, m_mesh);
  }

  /// @}

  /*!
   * \name Changes
   * The next call of `find_distances()` repairs the results of the last one if most of its sources
   * are the same. No other thread may use the solver during these calls.
   * They throw `std::invalid_argument`, and change nothing, if the solver was made with neither
   * face weights nor barriers.
   */
  /// @{

  /*!
   * changes the weights of some faces. `error_bound()` returns the bound that is left; it stays the
   * same if the solver was made with `Solver_options::may_change`.
   *
   * \param faces the faces
   * \param weights as many new weights: not negative; infinity makes a face impassable
   * \param number their number
   */
  void set_weights(const std::int64_t* const faces,
                   const double* const weights,
                   const std::size_t number)
  {
    std::vector<Weight_change> changes;
    for(std::size_t i = 0; i < number; ++i)
    {
      check_element("change " + std::to_string(i), "that of face", faces[i], number_of_faces());
      changes.push_back({m_translation->halfedge_of(face(faces[i])), weights[i]});
    }
    m_graph->set_weights(changes);
    for(std::size_t i = 0; i < number; ++i)
      m_costs.set_weight(face(faces[i]), weights[i]);
  }

  /*!
   * lifts barriers, or puts them back, as doors are opened and closed. Only edges that were
   * barriers at construction can change. `save()` writes those that are not lifted.
   *
   * \param ends the edges, two vertices each
   * \param is_barrier for each of them, whether it is a barrier from now on
   * \param number their number
   */
  void set_barriers(const std::int64_t* const ends,
                    const bool* const is_barrier,
                    const std::size_t number)
  {
    std::vector<Barrier_change> changes;
    for(std::size_t i = 0; i < number; ++i)
    {
      const auto p = Solver_point::on_edge(ends[2 * i], ends[2 * i + 1], 0.5);
      changes.push_back({intrinsic_point(p, "barrier", i).halfedge, is_barrier[i]});
    }
    m_graph->set_barriers(changes);
    for(std::size_t i = 0; i < number; ++i)
      m_costs.set_barrier(
          edge(halfedge(vertex(ends[2 * i]), vertex(ends[2 * i + 1]), m_mesh).first, m_mesh),
          is_barrier[i]);
  }

  /*!
   * prepares for many pairs, until weights or barriers change: makes `Landmarks`, or
   * `Exact_landmarks` if distances are exact, which guide searches for single paths and lists of
   * pairs. No other thread may use the solver meanwhile.
   *
   * \throws std::invalid_argument as the constructor of `Landmarks` does.
   *
   * Run time and memory are those of these classes.
   */
  void prepare_pairs(const std::size_t number_of_landmarks,
                     const Solver_watch& watch = Solver_watch())
  {
    internal::Solver_visitor visitor(watch);
    m_graph->prepare_pairs(number_of_landmarks);
    visitor.finish();
  }

  /*!
   * prepares for very many intervals, until weights or barriers change: makes `Portal_labels`, from
   * which `Solver_pairs::find_intervals()` reads those of pairs of vertices, without a search. The
   * quotient of their ends is larger by a factor of up to `1 + epsilon`. If this fails, intervals
   * that were prepared before stay. No other thread may use the solver meanwhile.
   *
   * \throws std::invalid_argument as the constructor of `Portal_labels` does, and if distances are
   *         exact.
   *
   * Run time and memory are those of this class.
   */
  void prepare_intervals(const double epsilon, const Solver_watch& watch = Solver_watch())
  {
    internal::Solver_visitor visitor(watch);
    internal::with_threads(m_number_of_threads, [&] { m_graph->prepare_intervals(epsilon); });
    visitor.finish();
  }

  /// @}

  /// \name Distances and Paths
  /// @{

  /*!
   * finds the distance of each vertex from the nearest source.
   *
   * \param sources the sources
   * \param distances receives one number per vertex, infinity if it is not reached
   * \param nearest_sources if not null, receives the position of the nearest source of each vertex,
   *        or `-1` if it is not reached
   * \param predecessors if not null, receives the previous vertex on a shortest path from the
   *        nearest source to each vertex: the vertex itself if there is none, or `-1` if it is not
   *        reached
   * \param options the range and the direction of the search
   * \param watch is called during the run
   */
  void find_distances(const std::vector<Solver_point>& sources,
                      double* const distances,
                      std::int64_t* const nearest_sources = nullptr,
                      std::int64_t* const predecessors = nullptr,
                      const Solver_search_options& options = Solver_search_options(),
                      const Solver_watch& watch = Solver_watch()) const
  {
    internal::Solver_visitor visitor(watch);
    std::vector<Source_point> seeds;
    for(const Intrinsic_point& p : intrinsic_points(sources, "source"))
      seeds.push_back({p});
    m_graph->in_direction(options.direction_to_source)
        .find_distances(std::move(seeds), options.maximum_distance, distances, nearest_sources,
                        predecessors, visitor);
    if(predecessors != nullptr)
      for(std::size_t v = 0; v < number_of_vertices(); ++v)
        if(predecessors[v] >= 0)
          predecessors[v] =
              m_translation->vertex(static_cast<Intrinsic_triangulation::Index>(predecessors[v]));
  }

  /*!
   * appends the points of a shortest path from `source` to `target` to `coordinates`, three numbers
   * each, and returns its length. If there is no path, appends nothing and returns infinity.
   *
   * \param source the start of the path
   * \param target the end of the path
   * \param straighten whether to straighten the path to a locally shortest one, which does not
   *        support costs
   * \param coordinates receives the points
   * \param watch is called during the search
   * \param vertices if not null, receives the vertex at each point, or `-1` if there is none
   */
  double find_path(const Solver_point& source,
                   const Solver_point& target,
                   const bool straighten,
                   std::vector<double>& coordinates,
                   const Solver_watch& watch = Solver_watch(),
                   std::vector<std::int64_t>* const vertices = nullptr) const
  {
    internal::Solver_visitor visitor(watch);
    Path path = m_graph->find_path(intrinsic_point(source, "source"),
                                   intrinsic_point(target, "target"), positions(), visitor);
    if(!path.points.empty())
      internal::straighten_if_wanted(m_graph->triangulation(), parameters::straighten(straighten),
                                     path);
    append_coordinates(path.points.rbegin(), path.points.rend(), coordinates);
    if(vertices != nullptr)
      std::transform(path.points.rbegin(), path.points.rend(), std::back_inserter(*vertices),
                     [&](const Intrinsic_point& p) {
                       return p.is_vertex()
                                  ? static_cast<std::int64_t>(m_translation->vertex(p.vertex))
                                  : -1;
                     });
    return length_of(path);
  }

  /// @}

  /// \name Matrices
  /// Matrices have one row per source and one column per target.
  /// @{

  /// writes all distances in row-major order, infinity if a target is not reached.
  void compute_matrix(double* const distances,
                      const std::vector<Solver_point>& sources,
                      const Solver_row_options& options = Solver_row_options(),
                      const Solver_watch& watch = Solver_watch()) const
  {
    Dense_rows<double> rows(distances);
    compute_rows(rows, sources, options, watch);
  }

  /// finds the distances up to the maximum distance.
  void compute_matrix(Radius_rows<double>& rows,
                      const std::vector<Solver_point>& sources,
                      const Solver_row_options& options = Solver_row_options(),
                      const Solver_watch& watch = Solver_watch()) const
  {
    compute_rows(rows, sources, options, watch);
  }

  /// finds the smallest distances of each row.
  void compute_matrix(Nearest_rows<double>& rows,
                      const std::vector<Solver_point>& sources,
                      const Solver_row_options& options = Solver_row_options(),
                      const Solver_watch& watch = Solver_watch()) const
  {
    compute_rows(rows, sources, options, watch);
  }

  /// @}

  /// \name Applications of Distances
  /// @{

  /// writes the position of the nearest source of each face, as `voronoi_partition()` does, or
  /// `-1`.
  void find_voronoi_partition(const std::vector<Solver_point>& sources,
                              std::int64_t* nearest_sources,
                              const Solver_search_options& options = Solver_search_options(),
                              const Solver_watch& watch = Solver_watch()) const
  {
    std::vector<double> distances(number_of_vertices());
    std::vector<std::int64_t> nearest(number_of_vertices());
    find_distances(sources, distances.data(), nearest.data(), nullptr, options, watch);
    for(const auto f : faces(m_mesh))
    {
      std::array<internal::Corner_source, 3> corners;
      std::size_t i = 0;
      for(const auto v : vertices_around_face(halfedge(f, m_mesh), m_mesh))
        corners[i++] = {distances[v], static_cast<std::size_t>(nearest[v])};
      *nearest_sources++ = static_cast<std::int64_t>(internal::source_of_face(corners));
    }
  }

  /// appends a farthest point sample to `vertices`, as `farthest_point_sampling()` computes it, and
  /// returns the largest distance of a vertex from the sample and the sources.
  /// \param number the maximum number of chosen vertices
  /// \param sources vertices that count as chosen before
  /// \param vertices receives the vertices
  /// \param watch is called after each chosen vertex
  double find_farthest_vertices(const std::size_t number,
                                const std::vector<Solver_point>& sources,
                                std::vector<std::int64_t>& vertices,
                                const Solver_watch& watch = Solver_watch()) const
  {
    const auto points = intrinsic_points(sources, "source");
    for(std::size_t i = 0; i < points.size(); ++i)
      if(!points[i].is_vertex())
        internal::reject("source " + std::to_string(i) + " is not a vertex");
    internal::Solver_visitor visitor(watch);
    return m_graph->find_farthest_vertices(points, number, vertices, visitor);
  }

  /// writes the gradient of the function with these vertex values, three numbers per face, as
  /// `gradient()` computes it.
  void find_gradient(const double* const values, double* gradients) const
  {
    std::vector<Simple_cartesian<double>::Vector_3> vectors(number_of_faces());
    gradient(m_mesh, Values_of_vertices(values, get(boost::vertex_index, m_mesh)),
             boost::make_iterator_property_map(vectors.begin(), get(boost::face_index, m_mesh)));
    for(const auto& vector : vectors)
      gradients = write(vector, gradients);
  }

  /// returns the isolines of the function with these vertex values at `level`, as `isolines()`
  /// computes them: three numbers per point.
  std::vector<std::vector<double>> find_isolines(const double* const values,
                                                 const double level) const
  {
    std::vector<std::vector<Mesh::Point>> polylines;
    isolines(m_mesh, Values_of_vertices(values, get(boost::vertex_index, m_mesh)), level,
             std::back_inserter(polylines));
    std::vector<std::vector<double>> result;
    for(const auto& polyline : polylines)
    {
      std::vector<double>& coordinates = result.emplace_back(3 * polyline.size());
      double* next = coordinates.data();
      for(const auto& point : polyline)
        next = write(point, next);
    }
    return result;
  }

  /// @}

private:
  template <typename Integer>
  void build(const double* const coordinates,
             const std::size_t number_of_vertices,
             const Integer* const corners,
             const std::size_t number_of_faces,
             const Solver_options& options,
             const internal::Get_bytes* const saved_graph)
  {
    m_bound = {options.epsilon, options.accept_weaker_bound, options.maximum_number_of_points,
               options.may_change};
    m_number_of_threads = options.number_of_threads;
    if(m_bound.epsilon && !(*m_bound.epsilon >= 0 && std::isfinite(*m_bound.epsilon)))
      internal::reject("epsilon is " + internal::text_of(*m_bound.epsilon) +
                       "; it must be finite and not negative");
    m_arrays.assign(coordinates, number_of_vertices, corners, number_of_faces);
    m_mesh = m_arrays.mesh();
    if(options.face_weights != nullptr)
      m_costs.set_weights(options.face_weights);
    if(options.directional_cost)
      m_costs.set_directional_cost(*options.directional_cost);
    m_costs.set_max_slope(options.max_slope);
    if(options.number_of_barriers > 0)
      m_costs.set_barriers(options.barriers, options.number_of_barriers);
    internal::with_threads(m_number_of_threads, [&] {
      m_graph =
          internal::make_solver_graph(m_costs.triangulation(m_bound.epsilon), m_bound, saved_graph);
    });
    m_translation.emplace(m_mesh, get(boost::vertex_index, std::as_const(m_mesh)),
                          m_graph->triangulation());
    m_translation->list_vertices();
  }

  template <typename Rows>
  void compute_rows(Rows& rows,
                    const std::vector<Solver_point>& sources,
                    const Solver_row_options& options,
                    const Solver_watch& watch) const
  {
    internal::Solver_visitor visitor(watch);
    internal::Any_rows any_rows(rows);
    const auto rows_of = intrinsic_points(sources, "source");
    std::optional<std::vector<Intrinsic_point>> columns;
    if(options.targets != nullptr)
      columns = intrinsic_points(*options.targets, "target");
    with_threads(options.number_of_threads, [&] {
      m_graph->in_direction(options.direction_to_source)
          .compute_rows(any_rows, rows_of, columns ? &*columns : nullptr, options.maximum_distance,
                        options.symmetric, visitor);
    });
  }

  template <typename F>
  void with_threads(const std::size_t number, const F& f) const
  {
    internal::with_threads(number > 0 ? number : m_number_of_threads, f);
  }

  static double length_of(const Path& path)
  {
    return path.points.empty() ? std::numeric_limits<double>::infinity() : path.length;
  }

  template <typename Iterator>
  void
  append_coordinates(Iterator point, const Iterator beyond, std::vector<double>& coordinates) const
  {
    const auto number = static_cast<std::size_t>(std::distance(point, beyond));
    coordinates.resize(coordinates.size() + 3 * number);
    for(double* next = coordinates.data() + coordinates.size() - 3 * number; point != beyond;
        ++point)
      next =
          write(m_translation->point(*point, get(vertex_point, m_mesh), Simple_cartesian<double>()),
                next);
  }

  std::vector<Intrinsic_point> intrinsic_points(const std::vector<Solver_point>& points,
                                                const std::string& kind) const
  {
    std::vector<Intrinsic_point> result;
    result.reserve(points.size());
    for(const Solver_point& p : points)
      result.push_back(intrinsic_point(p, kind, result.size()));
    return result;
  }

  static Mesh::Face_index face(const std::int64_t i) { return Mesh::Face_index(i); }
  static Mesh::Vertex_index vertex(const std::int64_t i) { return Mesh::Vertex_index(i); }

  static void check_element(const std::string& name,
                            const std::string& what,
                            const std::int64_t i,
                            const std::size_t size)
  {
    if(static_cast<std::uint64_t>(i) >= size) // also negative ones
      internal::reject(name + " is " + what + ' ' + std::to_string(i) +
                       "; they are numbered from 0, and there are " + std::to_string(size));
  }

  Intrinsic_point intrinsic_point(const Solver_point& p,
                                  const std::string& kind,
                                  const std::optional<std::size_t> number = std::nullopt) const
  {
    const std::string name = number ? kind + ' ' + std::to_string(*number) : kind;
    const auto check = [&](const std::string& what, const std::int64_t i, const std::size_t size) {
      check_element(name, what, i, size);
      return i;
    };
    if(p.kind == Solver_point::VERTEX)
      return m_translation->intrinsic_point(
          vertex(check("vertex", p.element, number_of_vertices())));
    if(p.kind == Solver_point::FACE)
      return m_translation->intrinsic_point(face(check("face", p.element, number_of_faces())),
                                            p.coordinates);
    const auto end = [&](const std::int64_t v) {
      return vertex(check("on an edge of vertex", v, number_of_vertices()));
    };
    const auto [h, is_found] = halfedge(end(p.element), end(p.second_vertex), m_mesh);
    if(!is_found)
      internal::reject(name + " is not on an edge: no face has both vertex " +
                       std::to_string(p.element) + " and vertex " +
                       std::to_string(p.second_vertex));
    return m_translation->intrinsic_point(h, p.coordinates[1]);
  }

  // Computed on demand: only path searches use positions.
  const Vertex_positions& positions() const
  {
    std::call_once(m_has_positions, [this] {
      m_positions = Vertex_positions(m_graph->triangulation(),
                                     m_translation->position_of_vertex(get(vertex_point, m_mesh)));
    });
    return m_positions;
  }

  template <typename Vector>
  static double* write(const Vector& v, double* const numbers)
  {
    for(int i = 0; i < 3; ++i)
      numbers[i] = v[i];
    return numbers + 3;
  }

  internal::Mesh_arrays m_arrays;
  Mesh m_mesh = m_arrays.mesh();
  internal::Array_costs m_costs;
  internal::Bound_of_graph m_bound;
  std::size_t m_number_of_threads = 0;
  std::unique_ptr<internal::Solver_graph> m_graph;
  std::optional<Translation> m_translation;
  mutable std::once_flag m_has_positions;
  mutable Vertex_positions m_positions;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_H
