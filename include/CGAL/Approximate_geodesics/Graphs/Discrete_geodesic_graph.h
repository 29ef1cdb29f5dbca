// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_DISCRETE_GEODESIC_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_DISCRETE_GEODESIC_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Arc_file.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_run.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_triangulation.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <istream>
#include <limits>
#include <memory>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsGraphs
 *
 * A graph whose shortest paths are longer than the shortest paths on the surface by a factor of at
 * most \f$1 + \varepsilon\f$.
 *
 * Its nodes are the vertices of the mesh, and points inside faces if most faces are far longer than
 * wide, since lines would otherwise cross very many of them. Its arcs are straight lines across
 * faces, unfolded into the plane. From every vertex, cones of directions are followed until other
 * vertices provide paths that are short enough; section \ref AG_discrete_geodesic_graph of the user
 * manual describes the criterion, and the report \cgalCite{ag-report} proves the bound. On scanned
 * models the mean error is about \f$\varepsilon / 100\f$ for \f$\varepsilon = 0.1\f$, and the
 * largest error about \f$\varepsilon / 4\f$ or less.
 *
 * Lengths are stored in single precision and rounded up, by a factor of at most
 * \f$1 + 2^{-23}\f$, or, if they are less than \f$2^{-126}\f$ times the longest edge, by up to
 * \f$2^{-149}\f$ times the longest edge. An arc takes 6 bytes, which is about 250 bytes per vertex
 * for \f$\varepsilon = 0.1\f$, in addition to the triangulation.
 *
 * An object of this class never changes after its construction and may be used by several threads.
 * For one search, or few, `Lazy_discrete_geodesic_graph` is faster.
 *
 * \cgalModels{SurfaceGraph}
 */
class Discrete_geodesic_graph
{
public:
  /// the number of a node; those of the vertices come first.
  using Node = Intrinsic_triangulation::Index;

  /// \name Creation
  /// @{

  /// the graph of an empty mesh.
  Discrete_geodesic_graph() = default;

  /*!
   * builds the graph of `triangulation`.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param triangulation the triangulation
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
   *           listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{epsilon}
   *     \cgalParamDescription{paths in the graph are at most \f$1 + \varepsilon\f$ times as long as
   *                           the shortest ones on the surface}
   *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
   *     \cgalParamDefault{`0.1`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{concurrency_tag}
   *     \cgalParamDescription{whether the graph is built by several threads at the same time. The
   *                           result is the same.}
   *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
   *                    `CGAL::Parallel_if_available_tag`}
   *     \cgalParamDefault{`CGAL::Sequential_tag`}
   *     \cgalParamExtra{`CGAL::Parallel_tag` needs TBB.}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if `epsilon` is not a finite number above `0`, if a face breaks
   *         the triangle inequality, or if `triangulation` has weights or barriers.
   *
   * There is no proved bound of run time and memory. In measurements, they are about the same for
   * all vertices of meshes whose faces are not too oblong, whatever the degree of the vertex and
   * the size of the mesh. In the worst case, cones cross all `n` faces of a mesh, as in a fan of
   * needles whose outer ends turn inwards, and take time \cgalBigO{n} each.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Discrete_geodesic_graph(Intrinsic_triangulation triangulation,
                                   const NamedParameters& np = parameters::default_values())
    : m_rules(internal::checked_epsilon(np)),
      m_triangulation(
          internal::without_weights(std::move(triangulation), np, "Discrete_geodesic_graph"))
  {
    build(internal::Loop::with_tag<internal::Concurrency_tag<NamedParameters>>());
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the triangulation that the graph was built on.
  const Intrinsic_triangulation& triangulation() const { return m_triangulation.mesh(); }

  /// returns the bound that the graph was built for, or, below \f$7.2\cdot10^{-7}\f$, a larger one,
  /// as lengths are rounded.
  double epsilon() const
  {
    constexpr double of_rounding = 1. / (1 << 23);
    return (std::max)(m_rules.epsilon, m_rules.longest_detour * (1 + of_rounding) - 1);
  }

  /// returns a bound on how much, relatively, distances there are larger than those back, as the
  /// arcs that are left out in the two directions can differ: `epsilon()`.
  double asymmetry() const { return epsilon(); }

  /// \cond SKIP_IN_MANUAL
  // The data that a search needs for paths.
  using Run = internal::Arc_run<Discrete_geodesic_graph>;
  /// \endcond

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return m_triangulation.get().number_of_vertices(); }

  /// returns the number of arcs.
  std::size_t number_of_arcs() const { return m_rows.number_of_arcs(); }

  /// returns the unit of lengths, that of the triangulation.
  double unit() const { return triangulation().unit(); }

  /// returns a summary of the lengths of the arcs.
  Arc_lengths arc_lengths() const { return m_rows.arc_lengths(); }

  /// returns the largest number of arcs that start from a node.
  std::size_t maximum_degree() const { return m_rows.maximum_degree(); }

  /*!
   * calls `f(target, length)` for every arc that starts from `node`.
   *
   * The arcs do not depend on the labels. They are those of a `Lazy_discrete_geodesic_graph` that
   * keeps its arcs.
   */
  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& /* labels */, F f) const
  {
    m_rows.for_each_arc(node, f);
  }

  /*!
   * calls `f(h, t)` for every edge that the arc of the given length from `source` to `target`
   * crosses, in this order: the crossing is at the part `t` of the halfedge `h`, from its source.
   * `rounding` is a bound on the error of the given length. Returns the length of the arc, before
   * it was rounded.
   * \pre There is such an arc.
   */
  template <typename F>
  double for_each_crossing(const Node source,
                           const Node target,
                           const double length,
                           F f,
                           const double rounding = 0) const
  {
    // with the visitor and the rules by which `build()` has found the arcs
    return m_triangulation.trace<internal::Leave_out_detours>(
        m_rules, source, target, internal::before_rounding_up(length), rounding, f);
  }

  /// returns where a node is, which may be one of the vertices.
  Intrinsic_point position(const Node node) const { return m_triangulation.position(node); }

  /// attaches a point of the surface by straight lines across the faces around it, like the arcs of
  /// a vertex. So the bound holds for it, too.
  internal::Cones_of_point attach(const Intrinsic_point& point) const
  {
    return {triangulation(), m_rules, point};
  }

  /// prefetches the arcs of `node`.
  void prefetch(const Node node) const { m_rows.prefetch(node); }

  /// returns the number of bytes that the graph takes, its triangulation included.
  std::size_t memory() const { return internal::memory_of(m_triangulation, m_rows); }

  /// returns whether the triangulation is valid, and every edge has arcs that are no longer.
  /// Run time is linear.
  bool is_valid() const;

  /// @}

  /// \name Input and Output
  /// @{

  /*!
   * writes the graph to `out`, a binary stream: 8 bytes per arc, 4 per node, and a header. The
   * triangulation is not written, since constructing it from the mesh is fast. That requires the
   * header `CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h`.
   * \throws std::runtime_error if writing fails.
   */
  void save(std::ostream& out) const { save(internal::bytes_to(out)); }

  /*!
   * reads a graph from `in`, a binary stream, that was written for the same triangulation. If there
   * are thin faces, a triangulation of edge lengths differs from one of coordinates.
   *
   * \throws std::invalid_argument if the stream does not contain a graph, is damaged or incomplete,
   *         or belongs to another triangulation. The message says which.
   */
  static Discrete_geodesic_graph load(std::istream& in, Intrinsic_triangulation triangulation)
  {
    return load(internal::bytes_from(in), std::move(triangulation));
  }

  /// \cond SKIP_IN_MANUAL

  void save(const internal::Put_bytes& put) const
  {
    internal::Arc_file::save(put, triangulation(), m_triangulation.get(), m_rules.epsilon, m_rows);
  }

  static Discrete_geodesic_graph load(const internal::Get_bytes& get,
                                      Intrinsic_triangulation triangulation)
  {
    Discrete_geodesic_graph result;
    result.m_triangulation = internal::Cone_triangulation(std::move(triangulation));
    double epsilon = 0;
    internal::Arc_file::load(get, result.triangulation(), result.m_triangulation.get(), epsilon,
                             result.m_rows);
    result.m_rules = internal::Cone_rules(epsilon);
    result.m_rows.shrink_to_fit();
    return result;
  }

  /// \endcond

  /// @}

private:
  // Each thread works on blocks of nodes. They do not depend on the number of threads, so that the
  // graph does not either.
  static constexpr Node SIZE_OF_BLOCK = internal::Arc_block::MAXIMUM_SIZE;

  using Expansion = internal::Cone_expansion<internal::Recent_unfolding>;

  // What a thread builds blocks with.
  struct Workspace
  {
    explicit Workspace(const Intrinsic_triangulation& triangulation) : unfolding(triangulation) {}

    internal::Recent_unfolding unfolding;
    std::vector<internal::Stored_arc> arcs;
    internal::Arc_block rows;
  };

  void build(const internal::Loop& loop)
  {
    m_triangulation.get().check_triangle_inequality();
    std::vector<internal::Arc_block> blocks((number_of_nodes() + SIZE_OF_BLOCK - 1) /
                                            SIZE_OF_BLOCK);
    const double unit = internal::unit_of_arcs(triangulation());
    std::atomic<std::size_t> number_done(0);
    std::vector<std::unique_ptr<Workspace>> workspaces(loop.number_of_threads());
    loop.run(blocks.size(), [&](const std::size_t i, const std::size_t thread) {
      std::unique_ptr<Workspace>& workspace = workspaces[thread];
      if(!workspace)
        workspace = std::make_unique<Workspace>(m_triangulation.get());
      build_block(static_cast<Node>(i) * SIZE_OF_BLOCK, unit, *workspace, number_done);
      blocks[i] = workspace->rows; // a copy takes no more memory than it needs
    });
    m_rows = internal::Compressed_arcs(unit, std::move(blocks));
  }

  void build_block(const Node first,
                   const double unit,
                   Workspace& workspace,
                   std::atomic<std::size_t>& number_done) const
  {
    const Expansion expansion(m_triangulation.get(), workspace.unfolding, m_rules);
    const Node number_of_nodes = static_cast<Node>(this->number_of_nodes());
    const Node beyond = first + (std::min)(SIZE_OF_BLOCK, number_of_nodes - first);
    workspace.rows.clear();
    for(Node node = first; node < beyond; ++node)
    {
      internal::check_for_interruption(number_done++, number_of_nodes);
      internal::find_stored_arcs(node, unit, workspace.arcs, [&](const auto f) {
        m_triangulation.for_each_arc(expansion, node, f);
      });
      workspace.rows.append(workspace.arcs);
    }
  }

  internal::Cone_rules m_rules{0.1};
  internal::Cone_triangulation m_triangulation;
  internal::Compressed_arcs m_rows;
};

inline bool Discrete_geodesic_graph::is_valid() const
{
  const Intrinsic_triangulation& t = triangulation();
  if(!t.is_valid() || m_rows.number_of_rows() != number_of_nodes())
    return false;
  constexpr double rounding = 1 + 1. / (1 << 22);
  const double smallest_step =
      2 * m_rows.unit() * static_cast<double>(std::numeric_limits<float>::denorm_min());
  std::vector<double> length_to(number_of_nodes(), std::numeric_limits<double>::infinity());
  for(Node v = 0; v < number_of_nodes(); ++v)
  {
    bool is_valid = true;
    m_rows.for_each_arc(v, [&](const Node target, const double length) {
      is_valid = is_valid && target < number_of_nodes() && target != v && length >= 0;
      if(is_valid)
        length_to[target] = length;
    });
    if(!is_valid)
      return false;
    if(v >= t.number_of_vertices()) // a point in a face
      is_valid = m_rows.degree(v) > 0;
    else
      for(Node h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
      {
        const Node w = t.target(h);
        const double longest = t.length(h) * rounding + smallest_step;
        is_valid = is_valid && (w == v || length_to[w] <= longest);
      }
    if(!is_valid)
      return false;
    m_rows.for_each_arc(v, [&](const Node target, double) {
      length_to[target] = std::numeric_limits<double>::infinity();
    });
  }
  return true;
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_DISCRETE_GEODESIC_GRAPH_H
