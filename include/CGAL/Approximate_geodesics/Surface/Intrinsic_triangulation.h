// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTRINSIC_TRIANGULATION_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTRINSIC_TRIANGULATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Surface/internal/triangulation_arrays.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicCostsChanges
 *
 * What a path costs per unit of length in each face of an `Intrinsic_triangulation`.
 * `read_face_weights()` makes it from a property map.
 */
struct Face_weights
{
  /// weights that are smaller than this in the unit, but not zero, are raised to it.
  static constexpr double SMALLEST_WEIGHT = (std::numeric_limits<double>::min)();

  /// for each halfedge, the weight of the face to its left, in units of `unit`: not negative;
  /// infinity if paths must not enter the face, or if there is none.
  std::vector<double> of_halfedge;

  /// the unit, a power of two.
  double unit = 1;
};

namespace internal {

template <typename TriangleMesh, typename NamedParameters>
class Triangulation_builder;
class Retriangulation;

// Defined in the package of costs.
template <typename TriangleMesh, typename NamedParameters>
class Cost_reader;
class Face_gauges;
class Triangulation_changes;
} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * A triangle mesh without coordinates: connectivity and edge lengths, checked, compact and in an
 * order that suits searches. Everything else in this package is built on it.
 *
 * <b>Vertices</b> are numbered breadth first from `0`, one connected component after the other, and
 * large components in patches, so that neighbors are close in memory; `vertex()` and `index()`
 * translate from and to the indices of the mesh's vertex index map.
 *
 * <b>Halfedges</b> are grouped by the vertex they start from, and within a group follow each other
 * counterclockwise. So the groups are the adjacency arrays of the mesh's edges, and two halfedges
 * that follow each other in a group bound a face, unless the first of them is a border halfedge.
 *
 * <b>Lengths</b> are in units of `unit()`, a power of two that depends on the mesh's extent: they
 * neither overflow nor vanish when squared, whatever the unit of the coordinates, and the
 * conversion to and from that unit is exact.
 *
 * <b>Thin faces</b> have shapes that rounded lengths do not determine well: caps, whose corners are
 * nearly collinear, and needles, with one short edge. If lengths are computed from coordinates, the
 * shapes of caps more than about 64 times as long as high, and of needles more than about 1000
 * times as long as wide, are computed from these in twice the precision of a `double`, and stored.
 *
 * <b>Weights</b> are the costs of a path per unit of length in each face, and <b>barriers</b> are
 * edges that paths do not cross. Both are given at construction. Of the graphs, `Steiner_graph`
 * supports them, and `Directional_graph` supports weights that are functions of the direction. The
 * others reject such a triangulation.
 *
 * After its construction an object of this class changes only by `set_weights()` and
 * `set_barriers()`, and may be used by several threads. It takes about 91 bytes per vertex on a
 * closed mesh, 48 more if there are weights, and 36 per thin face. Weights that are functions of
 * the direction never change, and copies share them.
 */
class Intrinsic_triangulation
{
public:
  /// \name Types
  /// @{

  /// the number of a vertex or of a halfedge.
  using Index = std::uint32_t;

  /// @}

  /// the null index, of no vertex and no halfedge.
  static constexpr Index null_index = (std::numeric_limits<Index>::max)();

  /// \name Creation
  /// @{

  /// an empty triangulation.
  Intrinsic_triangulation() : m_first_halfedge(1, 0) {}

  /*!
   * copies the connectivity and the edge lengths of `tmesh`.
   *
   * Boundaries, several connected components, isolated vertices, edges of length zero and faces of
   * area zero are normal input.
   *
   * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param tmesh the triangle mesh; it is neither changed nor referred to later
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
   *           listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
   *                    `%Point_3` as value type}
   *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
   *     \cgalParamExtra{Not needed if `edge_length_map` is given.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{edge_length_map}
   *     \cgalParamDescription{a property map associating lengths to the edges of `tmesh`, to be
   *                           used in place of the distances of their end points}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a
   *                    number type convertible by `CGAL::to_double()` as value type}
   *     \cgalParamDefault{unused}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{face_weight_map}
   *     \cgalParamDescription{a property map associating weights to the faces of `tmesh`: what a
   *                           path in the face costs per unit of length. `0` makes it free, and
   *                           infinity forbidden.}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and a
   *                    number type convertible by `CGAL::to_double()` as value type; or what
   *                    `directional_cost()` returns}
   *     \cgalParamDefault{unused: all faces have weight `1`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{max_slope}
   *     \cgalParamDescription{the steepest slope, uphill and downhill, that paths may have in the
   *                           directions of their straight pieces, in units of z per horizontal
   *                           unit. Costs depend on the direction then, whether or not there is a
   *                           face weight map. See `Directional_graph`.}
   *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
   *     \cgalParamDefault{infinity: there is no limit}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{edge_is_constrained_map}
   *     \cgalParamDescription{a property map saying which edges of `tmesh` are barriers, which
   *                           paths may run along, and not cross}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and
   *                    `bool` as value type}
   *     \cgalParamDefault{unused: no edge is a barrier}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{concurrency_tag}
   *     \cgalParamDescription{whether several threads compute lengths and the shapes of thin faces
   *                           at the same time; only one at a time reads `tmesh` and property
   *                           maps, not always that of the caller. The result is the same.}
   *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
   *                    `CGAL::Parallel_if_available_tag`}
   *     \cgalParamDefault{`CGAL::Sequential_tag`}
   *     \cgalParamExtra{`CGAL::Parallel_tag` needs TBB.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_index_map}
   *     \cgalParamDescription{a property map associating to each vertex of `tmesh` a unique index
   *                           between `0` and `num_vertices(tmesh) - 1`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an
   *                    integer type as value type}
   *     \cgalParamDefault{an automatically indexed internal map}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{halfedge_index_map}
   *     \cgalParamDescription{a property map associating to each halfedge of `tmesh` a unique index
   *                           between `0` and `num_halfedges(tmesh) - 1`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and an
   *                    integer type as value type}
   *     \cgalParamDefault{an automatically indexed internal map}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{geom_traits}
   *     \cgalParamDescription{an instance of a geometric traits class}
   *     \cgalParamType{a class model of `Kernel`}
   *     \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if a face is not a triangle, if a coordinate or a length is
   *         infinite or not a number, if a length is negative or does not fit a `double`, if a
   *         weight, a cost or `max_slope` is negative or not a number, if paths cost more than a
   * `double` holds, if an index is out of range or given twice, or if the halfedges around a vertex
   * do not form one cycle. The message names the element. \throws std::length_error if `tmesh` has
   * too many halfedges for 32-bit indices.
   *
   * Run time and memory are \cgalBigO{n} for `n` vertices. The header
   * `CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h` has to be included, and
   * `CGAL/Geodesic_costs.h` for weights, limits of slopes, and barriers.
   */
  template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
  explicit Intrinsic_triangulation(const TriangleMesh& tmesh,
                                   const NamedParameters& np = parameters::default_values())
    : Intrinsic_triangulation()
  {
    internal::Triangulation_builder<TriangleMesh, NamedParameters>(*this, tmesh, np).build();
  }

  /// @}

  /// \name Size
  /// @{

  /// returns the number of vertices, isolated ones included.
  Index number_of_vertices() const { return static_cast<Index>(m_first_halfedge.size() - 1); }

  /// returns the number of halfedges, border halfedges included.
  Index number_of_halfedges() const { return static_cast<Index>(m_target.size()); }

  /// returns the number of edges.
  Index number_of_edges() const { return number_of_halfedges() / 2; }

  /// returns the number of faces.
  Index number_of_faces() const { return m_number_of_faces; }

  /// returns the number of bytes that the arrays of the triangulation take.
  std::size_t memory() const
  {
    return internal::memory_of(m_first_halfedge, m_target, m_vertex_of_index, m_index_of_vertex,
                               m_length, m_weight, m_is_border, m_is_barrier, m_is_lifted,
                               m_is_flipped, m_is_forbidden, m_opposite_rank, m_thin_faces) +
           m_memory_of_gauges;
  }

  /// @}

  /// \name Numbering
  /// @{

  /// returns the number of the vertex that has index `i` in the mesh, or `null_index` if there is
  /// none.
  Index vertex(const std::size_t i) const
  {
    if(m_vertex_of_index.empty())
      return i < number_of_vertices() ? static_cast<Index>(i) : null_index;
    return i < m_vertex_of_index.size() ? m_vertex_of_index[i] : null_index;
  }

  /// returns the index in the mesh of the vertex with number `v`.
  Index index(const Index v) const
  {
    CGAL_precondition(v < number_of_vertices());
    return m_index_of_vertex.empty() ? v : m_index_of_vertex[v];
  }

  /// @}

  /// \name Connectivity
  /// @{

  /// returns the first halfedge that starts from `v`.
  Index first_halfedge(const Index v) const { return m_first_halfedge[v]; }

  /// returns the halfedge after the last one that starts from `v`.
  Index beyond_halfedge(const Index v) const { return m_first_halfedge[v + 1]; }

  /// returns the number of halfedges that start from `v`.
  Index degree(const Index v) const { return beyond_halfedge(v) - first_halfedge(v); }

  /// returns the vertex that `h` ends at.
  Index target(const Index h) const { return m_target[h]; }

  /// returns the vertex that `h` starts from.
  Index source(const Index h) const { return m_target[opposite(h)]; }

  /// returns the halfedge on the other side of the edge of `h`.
  Index opposite(const Index h) const
  {
    return m_first_halfedge[m_target[h]] + m_opposite_rank.rank_of_opposite(h);
  }

  /// returns the halfedge that follows `h` around its face. \pre `h` is not a border halfedge.
  Index next(const Index h) const
  {
    CGAL_precondition(!is_border(h));
    const Index v = m_target[h], first = first_halfedge(v);
    const Index rank = m_opposite_rank.rank_of_opposite(h);
    const Index number_if_first = rank == 0 ? degree(v) : 0; // around to the last one
    return first + rank + number_if_first - 1;
  }

  /// returns the halfedge that follows `h` counterclockwise among those that start from `v`.
  /// \pre `h` starts from `v`.
  Index counterclockwise(const Index v, const Index h) const
  {
    return h + 1 == beyond_halfedge(v) ? first_halfedge(v) : h + 1;
  }

  /// returns the halfedge that follows `h` clockwise among those that start from `v`.
  /// \pre `h` starts from `v`.
  Index clockwise(const Index v, const Index h) const
  {
    return (h == first_halfedge(v) ? beyond_halfedge(v) : h) - 1;
  }

  /// returns the halfedges of the face to the left of `h`, from that on.
  /// \pre `h` is not a border halfedge.
  std::array<Index, 3> halfedges_of_face(const Index h) const
  {
    const Index second = next(h);
    return {h, second, next(second)};
  }

  /// \cond SKIP_IN_MANUAL
  // The smallest halfedge of the face to the left of `h`, which identifies the face.
  Index first_of_face(const Index h) const
  {
    const auto sides = halfedges_of_face(h);
    return *std::min_element(sides.begin(), sides.end());
  }
  /// \endcond

  /// returns whether there is no face to the left of `h`.
  bool is_border(const Index h) const { return m_is_border[h]; }

  /// @}

  /// \name Lengths
  /// @{

  /// returns the length of `h`, in units of `unit()`.
  double length(const Index h) const { return m_length[h]; }

  /// returns the unit of length, a power of two, in the unit of the mesh.
  double unit() const { return m_unit; }

  /// @}

  /// \name Weights and Barriers
  /// @{

  /// returns whether faces have weights.
  bool has_weights() const { return !m_weight.empty(); }

  /// returns the weight of the face to the left of `h`, in units of `weight_unit()`; infinity if
  /// there is no face. If there are no weights, it is `1` for every face.
  double weight(const Index h) const
  {
    if(has_weights())
      return m_weight[h];
    return is_border(h) ? std::numeric_limits<double>::infinity() : 1;
  }

  /// returns whether paths may enter the face to the left of `h`.
  bool is_open(const Index h) const
  {
    return weight(h) < std::numeric_limits<double>::infinity() &&
           (m_is_forbidden.empty() || !m_is_forbidden[h]);
  }

  /// returns the weight of the edge of `h`: the smaller weight of its two faces. A barrier counts
  /// as two edges; the weight is that of the one to the left of `h`.
  double weight_of_edge(const Index h) const
  {
    if(!has_weights())
      return 1;
    return is_barrier(h) ? m_weight[h] : (std::min)(m_weight[h], m_weight[opposite(h)]);
  }

  /// returns the unit of weights, a power of two.
  double weight_unit() const { return m_weight_unit; }

  /// exchanges the weights.
  /// \pre There is one per halfedge.
  void set_weights(Face_weights weights)
  {
    CGAL_precondition(weights.of_halfedge.size() == m_target.size());
    m_weight = std::move(weights.of_halfedge);
    m_weight_unit = weights.unit;
  }

  /// returns whether weights are functions of the direction. `has_weights()` is `false` then.
  bool has_directional_costs() const { return m_gauges != nullptr; }

  /// \cond SKIP_IN_MANUAL
  // \pre There are directional costs.
  const internal::Face_gauges& gauges() const { return *m_gauges; }
  /// \endcond

  /// returns whether any edge is a barrier.
  bool has_barriers() const { return !m_is_barrier.empty(); }

  /// returns whether the edge of `h` is a barrier, or is one that is lifted. Border edges are not:
  /// nothing crosses them anyway.
  bool is_barrier(const Index h) const { return has_barriers() && m_is_barrier[h]; }

  /// returns whether the edge of `h` is a barrier that is lifted: paths may cross it.
  bool is_lifted(const Index h) const { return !m_is_lifted.empty() && m_is_lifted[h]; }

  /// returns whether any barrier is lifted.
  bool has_lifted_barriers() const
  {
    return std::find(m_is_lifted.begin(), m_is_lifted.end(), true) != m_is_lifted.end();
  }

  /// returns whether paths may cross the edge of `h`.
  bool is_crossable(const Index h) const
  {
    return !is_border(h) && !is_border(opposite(h)) && (!is_barrier(h) || is_lifted(h));
  }

  /// @}

  /// \name For Graphs
  /// @{

  /// returns the targets of all halfedges, one after the other.
  const std::vector<Index>& targets() const { return m_target; }

  /// returns the lengths of all halfedges, one after the other.
  const std::vector<double>& lengths() const { return m_length; }

  /// \cond SKIP_IN_MANUAL
  const internal::Thin_faces& thin_faces() const { return m_thin_faces; }

  // Whether a shortest path may return to a face of the mesh: lengths are not those of an
  // embedding.
  bool lines_may_return() const { return m_lines_may_return; }

  // Whether the edge of `h` is not an edge of the mesh, as in a `Retriangulation`. A shortest
  // path may cross it, and the faces next to it, more than once.
  bool is_flipped(const Index h) const { return !m_is_flipped.empty() && m_is_flipped[h]; }

  // Whether the face to the left of `h` is not a face of the mesh. \pre There is a face.
  bool is_in_new_face(const Index h) const
  {
    if(m_is_flipped.empty())
      return false;
    const Index second = next(h);
    return is_flipped(h) || is_flipped(second) || is_flipped(next(second));
  }
  /// \endcond

  /// prefetches the arrays' entries at `h`, and the next few.
  void prefetch(const Index h) const
  {
    constexpr Index doubles_per_cache_line = 8;
    internal::prefetch(m_target.data(), h);
    internal::prefetch(m_length.data(), h);
    internal::prefetch(m_length.data(), h + doubles_per_cache_line);
  }

  /// \cond SKIP_IN_MANUAL
  // `h` may be null_index.
  void prefetch_length(const Index h) const { internal::prefetch(m_length.data(), h); }
  /// \endcond

  /// @}

  /// \name Checks
  /// @{

  /*!
   * returns whether the arrays are consistent: every halfedge has an opposite halfedge of the same
   * length, every face is a triangle, and the number of faces is right.
   *
   * Run time is \cgalBigO{n}.
   */
  bool is_valid() const
  {
    std::size_t number_of_corners = 0;
    for(Index v = 0; v < number_of_vertices(); ++v)
    {
      if(vertex(index(v)) != v)
        return false;
      for(Index h = first_halfedge(v); h < beyond_halfedge(v); ++h)
      {
        if(!is_valid_halfedge(h) || source(h) != v)
          return false;
        number_of_corners += is_border(h) ? 0 : 1;
      }
    }
    return number_of_corners == 3 * std::size_t(m_number_of_faces) &&
           m_first_halfedge.back() == number_of_halfedges();
  }

  /*!
   * checks that every face can be laid out in the plane: no edge is longer than the other two
   * together, up to rounding, and the edges are not smaller than the mesh by a factor of more than
   * \f$10^{132}\f$, where areas underflow. Graphs whose arcs cross faces need this.
   *
   * \throws std::invalid_argument naming the vertices of a face that violates this.
   */
  void check_triangle_inequality() const
  {
    const Index h = face_without_shape();
    if(h == null_index)
      return;
    const Index g = next(h), k = next(g);
    const char* const what = length(h) > length(g) + length(k)
                                 ? "the triangle inequality does not hold"
                                 : "the area is too small relative to the mesh, and underflows,";
    internal::reject(what + (" in " + name_of_face(h)) + ": its edges have lengths " +
                     internal::text_of(length(h) * unit()) + ", " +
                     internal::text_of(length(g) * unit()) + ", " +
                     internal::text_of(length(k) * unit()));
  }

  /// @}

  /// \cond SKIP_IN_MANUAL
  static constexpr double smallest_perimeter = 0x1p-240; // its fourth power still fits a `double`

  // Whether `h` is not so long that its face breaks the triangle inequality, and the area does not
  // underflow. \pre There is a face to the left.
  bool has_shape(const Index h) const
  {
    // lengths have been rounded once, or are given with errors of that order
    constexpr double tolerance = 16 * std::numeric_limits<double>::epsilon();
    const Index g = next(h);
    const double rest = length(g) + length(next(g)), perimeter = length(h) + rest;
    return length(h) <= rest + tolerance * perimeter &&
           !(0 < rest && perimeter < smallest_perimeter);
  }

  // A halfedge of a face without shape, or null.
  Index face_without_shape() const
  {
    for(Index h = 0; h < number_of_halfedges(); ++h)
      if(!is_border(h) && !has_shape(h))
        return h;
    return null_index;
  }

  // Names the face to the left of `h` in messages.
  std::string name_of_face(const Index h) const
  {
    const Index g = next(h);
    return "the face with vertices " + std::to_string(index(target(next(g)))) + ", " +
           std::to_string(index(target(h))) + ", " + std::to_string(index(target(g)));
  }
  /// \endcond

private:
  template <typename TriangleMesh, typename NamedParameters>
  friend class internal::Triangulation_builder;
  template <typename TriangleMesh, typename NamedParameters>
  friend class internal::Cost_reader;
  friend class internal::Retriangulation;
  friend class internal::Triangulation_changes;

  bool is_valid_halfedge(const Index h) const
  {
    if(target(h) >= number_of_vertices() || opposite(h) >= number_of_halfedges())
      return false;
    const Index g = opposite(h);
    if(g == h || opposite(g) != h || length(g) != length(h) || !(length(h) >= 0))
      return false;
    if(is_border(h))
      return true;
    const Index second = next(h), third = is_border(second) ? null_index : next(second);
    return third != null_index && !is_border(third) && next(third) == h;
  }

  std::vector<Index> m_first_halfedge; // per vertex, and one beyond
  std::vector<Index> m_target;         // per halfedge, as the next three
  std::vector<double> m_length;
  std::vector<bool> m_is_border;
  internal::Opposite_ranks m_opposite_rank;
  internal::Thin_faces m_thin_faces;
  std::shared_ptr<const internal::Face_gauges> m_gauges; // if costs depend on the direction
  std::size_t m_memory_of_gauges = 0;
  std::vector<double> m_weight;         // per halfedge, or empty
  std::vector<bool> m_is_barrier;       // likewise
  std::vector<bool> m_is_lifted;        // likewise
  std::vector<bool> m_is_flipped;       // likewise
  std::vector<bool> m_is_forbidden;     // likewise: whether gauges are infinite in all directions
  std::vector<Index> m_vertex_of_index; // empty if vertices keep their indices
  std::vector<Index> m_index_of_vertex; // likewise
  Index m_number_of_faces = 0;
  double m_unit = 1;
  double m_weight_unit = 1;
  bool m_lines_may_return = false;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTRINSIC_TRIANGULATION_H
