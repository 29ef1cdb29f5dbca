// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_STEINER_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_STEINER_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/internal/Corner.h>
#include <CGAL/Approximate_geodesics/internal/Point_row.h>
#include <CGAL/Approximate_geodesics/internal/Points_on_edges.h>
#include <CGAL/Approximate_geodesics/internal/Sectors.h>
#include <CGAL/Approximate_geodesics/internal/messages.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * The graph of the vertices of a mesh and of points on its edges, so-called Steiner points. Two
 * nodes at the border of the same face are joined by a straight arc across the face, and
 * neighbours on an edge by an arc along it.
 *
 * It is the graph for faces with weights. An arc across a face costs its length times the weight of
 * the face, and one along an edge its length times the smaller weight of the two faces. There are
 * no arcs across faces of infinite weight, nor across barriers, along which paths may run. Without
 * weights and barriers, it is still the graph for paths across a few large faces.
 *
 * The placement says where points are, and so which error is made: `Geometric_points` guarantees a
 * bound, `Equally_spaced_points` and `Equally_dense_points` are simpler and do not.
 *
 * Arcs are not stored: the graph takes 36 bytes per vertex, in addition to the triangulation, and 8
 * per point, or 4 if points divide edges into equal parts. They are not all looked at either. A
 * path that comes across a face is not continued into the same face again, and where edges have
 * many points, a point looks only at those of the opposite edges that neither of its two neighbours
 * reaches on a shorter path.
 *
 * Nodes are the vertices, the points, and one more for every sector of those vertices whose
 * surroundings are divided by barriers into several sectors: no path leads through such a vertex
 * from one sector into another.
 *
 * An object of this class never changes after its construction, unless its weights are exchanged,
 * and may be used by several threads.
 *
 * \tparam Placement a model of `SteinerPointPlacement`
 *
 * \cgalModels{GeodesicGraph}
 */
template <typename Placement = Geometric_points>
class Steiner_graph
{
public:
  /// the number of a node; those of the vertices come first.
  using Node = Intrinsic_triangulation::Index;

  /// \name Creation
  /// @{

  /// the graph of an empty mesh.
  Steiner_graph() : Steiner_graph(Intrinsic_triangulation()) {}

  /*!
   * builds the graph of `triangulation`, its weights and its barriers.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param triangulation the triangulation
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": that of the
   *           placement
   *
   * \throws std::invalid_argument if there are points, and a face breaks the triangle inequality,
   * or as the placement does. \throws std::length_error if there would be more nodes than 32-bit
   * numbers can tell apart.
   *
   * Run time and memory are \cgalBigO{n} for `n` nodes.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Steiner_graph(Intrinsic_triangulation triangulation,
                         const NamedParameters& np = parameters::default_values())
    : Steiner_graph(std::move(triangulation), Placement(np))
  {
  }

  /// builds the graph likewise, with a placement that was made before.
  Steiner_graph(Intrinsic_triangulation triangulation, Placement placement)
    : m_triangulation(std::move(triangulation)), m_placement(std::move(placement))
  {
    m_sectors = internal::Sectors(m_triangulation);
    const std::size_t number_of_others =
        m_triangulation.number_of_vertices() + std::size_t(m_sectors.number_of_sectors());
    m_placement.prepare(m_triangulation);
    m_points = internal::Points_on_edges(m_triangulation, m_placement,
                                         Intrinsic_triangulation::null_index - number_of_others);
    if(m_points.number_of_points() > 0) // there are arcs across faces
      m_triangulation.check_triangle_inequality();
    m_first_point = m_triangulation.number_of_vertices();
    m_first_sector = m_first_point + m_points.number_of_points();
    find_maximum_degree();
    summarize_arcs();
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the triangulation that the graph was built on.
  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }

  /// returns the placement of the points.
  const Placement& placement() const { return m_placement; }

  /// returns the bound that the placement guarantees with the present weights: paths cost at most
  /// `1 + epsilon()` times as much as the cheapest ones on the surface. It is infinity if there is
  /// none. Run time is \cgalBigO{n}.
  double epsilon() const { return m_placement.epsilon(m_triangulation); }

  /// returns the number of nodes.
  std::size_t number_of_nodes() const
  {
    return std::size_t(m_first_sector) + m_sectors.number_of_sectors();
  }

  /// returns the number of points on edges. On barriers, those of both sides count.
  std::size_t number_of_points() const { return m_points.number_of_points(); }

  /// returns the unit of costs, in the unit of the mesh times that of the weights.
  double unit() const { return m_triangulation.unit() * m_triangulation.weight_unit(); }

  /// returns a summary of the costs of the arcs along edges, which are the shortest ones, as if
  /// points divided every edge into equal parts.
  const Arc_lengths& arc_lengths() const { return m_arc_lengths; }

  /// returns an upper bound of the number of arcs that start from a node.
  std::size_t maximum_degree() const { return m_maximum_degree; }

  /// returns a halfedge that `node` lies on, and how far along: a part of it between `0` and `1`.
  /// The part is `0` if the node stands for a vertex. \pre `node` is not one of the vertices.
  std::pair<Node, double> place(const Node node) const
  {
    CGAL_precondition(node >= m_first_point);
    if(node >= m_first_sector)
      return {m_sectors.first_halfedge(node - m_first_sector), 0};
    const Node p = node - m_first_point, h = m_points.halfedge(p);
    return {h, m_points.part_before(m_points.edge(h), p)};
  }

  /// calls `f(target, cost)` for the arcs that start from `node` and may be part of a cheapest path
  /// that arrives there as `labels` says.
  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    if(node >= m_first_sector)
      expand_sector(node, f);
    else if(node >= m_first_point)
      expand_point(node, labels, f);
    else if(is_divided(node))
      expand_divided_vertex(node, labels, f);
    else
      expand_vertex(node, f);
  }

  /// returns `cost`: arcs run straight across a face, or along an edge.
  template <typename F>
  double for_each_crossing(Node /* source */, Node /* target */, const double cost, F /* f */) const
  {
    return cost;
  }

  /// asks for what it takes to find the arcs of `node`, which will be needed soon.
  void prefetch(const Node node) const
  {
    if(node < m_first_point)
      m_triangulation.prefetch(m_triangulation.first_halfedge(node));
    else if(node < m_first_sector)
      m_points.prefetch(node - m_first_point);
  }

  /// returns the number of bytes that the graph takes, its triangulation included.
  std::size_t memory() const
  {
    return m_triangulation.memory() + m_placement.memory() + m_points.memory() + m_sectors.memory();
  }

  /// returns whether the triangulation is valid.
  bool is_valid() const { return m_triangulation.is_valid(); }

  /// @}

  /// \name Modification
  /// @{

  /*!
   * exchanges the weights, as `Intrinsic_triangulation::set_face_weights()` does; the points stay
   * where they are. If the weights of the faces around a vertex become more different than they
   * were when the graph was built, or than `Geometric_points` was told to expect, the bound gets
   * worse: `epsilon()` tells.
   *
   * \warning No other thread may use the graph meanwhile, and workspaces that were made for it
   * before have to be made anew.
   *
   * Run time is \cgalBigO{n} for `n` vertices and points.
   */
  template <typename TriangleMesh,
            typename FaceWeightMap,
            typename NamedParameters = parameters::Default_named_parameters>
  void set_face_weights(const TriangleMesh& tmesh,
                        const FaceWeightMap& face_weight_map,
                        const NamedParameters& np = parameters::default_values())
  {
    m_triangulation.set_face_weights(tmesh, face_weight_map, np);
    summarize_arcs();
  }

  /// @}

private:
  using Index = Node;
  using Row = internal::Point_row;
  using Reached_point = internal::Reached_point;

  static constexpr Node null_node = Intrinsic_triangulation::null_index;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // From so many points on, it pays to search for those that are worth looking at.
  static constexpr Index LONG_ROW = 16;

  // ----- nodes and edges

  bool is_divided(const Node v) const
  {
    return !m_sectors.is_empty() && m_sectors.first_sector(v) != m_sectors.beyond_sector(v);
  }

  // The node at the vertex `v` in the face to the left of `h`, which starts there.
  Node corner_node(const Node v, const Index h) const
  {
    if(m_sectors.is_empty())
      return v;
    const Index sector = m_sectors.sector(v, h);
    return sector == null_node ? v : m_first_sector + sector;
  }

  // The nodes at the ends of the edge of `h`, or of its left side.
  Node node_at_source(const Index h) const
  {
    const Index twin = m_triangulation.opposite(h);
    const Node v = m_triangulation.target(twin);
    if(m_sectors.is_empty() || (m_triangulation.is_border(h) && m_triangulation.is_border(twin)))
      return v;
    return corner_node(v, m_triangulation.is_border(h) ? m_triangulation.next(twin) : h);
  }
  Node node_at_target(const Index h) const
  {
    const Node v = m_triangulation.target(h);
    if(m_sectors.is_empty())
      return v;
    return m_triangulation.is_border(h) ? node_at_source(m_triangulation.opposite(h))
                                        : corner_node(v, m_triangulation.next(h));
  }

  // Costs are in proportion to this along the edge of `h`, or along its left side.
  double weight_along(const Index h) const
  {
    return m_triangulation.is_barrier(h) ? m_triangulation.weight(h)
                                         : m_triangulation.weight_of_edge(h);
  }

  // The points of the edge of `h`, as seen from its source or its target.
  Row row_from_source(const Index h) const { return row(h, true); }
  Row row_from_target(const Index h) const { return row(h, false); }
  Row row(const Index h, const bool is_from_source) const
  {
    const Index e = m_points.edge(h), first = m_points.first_point(e);
    return Row(m_first_point + first, m_points.number_of_points(e), m_points.positions(first),
               m_triangulation.length(h), m_points.is_first(h) == is_from_source);
  }

  // Whether paths may enter the face to the left of `h`.
  bool is_open(const Index h) const { return m_triangulation.weight(h) < infinity; }

  // ----- arcs from vertices

  // A search can start at a divided vertex, and get there, but not go through it.
  template <typename Labels, typename F>
  void expand_divided_vertex(const Node v, const Labels& labels, F& f) const
  {
    if(labels.predecessor(v) == null_node)
      for(Index s = m_sectors.first_sector(v); s < m_sectors.beyond_sector(v); ++s)
        f(m_first_sector + s, 0.);
  }

  template <typename F>
  void expand_sector(const Node node, F& f) const
  {
    const Index sector = node - m_first_sector;
    const Node v = m_sectors.vertex(sector);
    f(v, 0.);
    Index h = m_sectors.first_halfedge(sector);
    do
    {
      expand_corner(v, h, f);
      h = m_triangulation.counterclockwise(v, h);
    } while(!m_triangulation.is_border(h) && !m_triangulation.is_barrier(h));
    // of a barrier, the side that faces the sector
    expand_edge(m_triangulation.opposite(h), false, f);
  }

  template <typename F>
  void expand_vertex(const Node v, F& f) const
  {
    const Index beyond = m_triangulation.beyond_halfedge(v);
    for(Index h = m_triangulation.first_halfedge(v); h < beyond; ++h)
    {
      expand_corner(v, h, f);
      if(m_triangulation.is_barrier(h)) // both sides of which start here
        expand_edge(m_triangulation.opposite(h), false, f);
    }
  }

  // The arcs from the source `v` of `h` along it and across the face to its left.
  template <typename F>
  void expand_corner(const Node v, const Index h, F& f) const
  {
    expand_edge(h, true, f);
    if(!is_open(h))
      return;
    const Row row = row_from_source(m_triangulation.next(h));
    if(row.size() == 0)
      return;
    const double x = m_triangulation.length(h);
    const double third = m_triangulation.length(m_triangulation.counterclockwise(v, h));
    visit(row, {0, row.size()}, internal::Corner(x, row.length(), third), x,
          m_triangulation.weight(h), f);
  }

  // The arc along the edge of `h`, or along its left side, from its source or target.
  template <typename F>
  void expand_edge(const Index h, const bool starts_at_source, F& f) const
  {
    const double weight = weight_along(h);
    if(weight == infinity)
      return;
    const Index e = m_points.edge(h);
    const Index first = m_points.first_point(e), beyond = m_points.beyond_point(e);
    const double length = m_triangulation.length(h);
    if(first == beyond)
      f(starts_at_source ? node_at_target(h) : node_at_source(h), weight * length);
    else if(starts_at_source == m_points.is_first(h))
      f(m_first_point + first, weight * (length * m_points.part_before(e, first)));
    else
      f(m_first_point + beyond - 1, weight * (length * m_points.part_behind(e, beyond - 1)));
  }

  // The arcs to points of a row, from the point at the distance `x` from its corner.
  template <typename F>
  void visit(const Row& row,
             const std::pair<Index, Index> ranks,
             const internal::Corner& corner,
             const double x,
             const double weight,
             F& f) const
  {
    row.for_each_block(ranks.first, ranks.second, corner, x, weight,
                       [&](const Node first, const double* const costs, const Index number) {
                         if constexpr(std::is_invocable_v<F, Node, const double*, std::size_t>)
                           f(first, costs, std::size_t(number));
                         else
                           for(Index i = 0; i < number; ++i)
                             f(first + i, costs[i]);
                       });
  }

  // ----- arcs from points on edges

  // A point on an edge, seen from the face to the left of a halfedge.
  struct Place
  {
    Place reversed(const Index twin) const
    {
      return {twin, node, from_target, from_source, toward_target, toward_source};
    }

    Index halfedge;
    Node node;
    double from_source, from_target;   // distances
    Node toward_source, toward_target; // neighbours
  };

  // The halfedges of the face to the left of the first of them.
  struct Face
  {
    Index first, second, third;
  };

  Face face(const Index h) const
  {
    const Index second = m_triangulation.next(h);
    return {h, second, m_triangulation.next(second)};
  }

  template <typename Labels, typename F>
  void expand_point(const Node node, const Labels& labels, F& f) const
  {
    const Index h = m_points.halfedge(node - m_first_point), twin = m_triangulation.opposite(h);
    const Place left = place_on_edge(node, h);
    expand_along_edge(left, f);

    const Node predecessor = labels.predecessor(node);
    const bool has_right = m_points.edge(twin) == m_points.edge(h) && is_open(twin);
    if(!has_right)
    {
      if(is_open(h))
        expand_face(left, face(h), labels, f);
      return;
    }
    const Face face_to_right = face(twin);
    const bool comes_from_right = is_opposite(predecessor, left, face_to_right);
    bool comes_from_left = false;
    if(is_open(h))
    {
      const Face face_to_left = face(h);
      comes_from_left = is_opposite(predecessor, left, face_to_left);
      if(!comes_from_left || comes_from_right)
        expand_face(left, face_to_left, labels, f);
    }
    if(!comes_from_right || comes_from_left)
      expand_face(left.reversed(twin), face_to_right, labels, f);
  }

  Place place_on_edge(const Node node, const Index h) const
  {
    const Index p = node - m_first_point, e = m_points.edge(h);
    const double length = m_triangulation.length(h);
    return {h,
            node,
            length * m_points.part_before(e, p),
            length * m_points.part_behind(e, p),
            p == m_points.first_point(e) ? node_at_source(h) : node - 1,
            p + 1 == m_points.beyond_point(e) ? node_at_target(h) : node + 1};
  }

  template <typename F>
  void expand_along_edge(const Place& place, F& f) const
  {
    const double weight = weight_along(place.halfedge);
    if(weight == infinity)
      return;
    f(place.toward_source, weight * (is_point(place.toward_source) ? gap(place, place.toward_source)
                                                                   : place.from_source));
    f(place.toward_target, weight * (is_point(place.toward_target) ? gap(place, place.toward_target)
                                                                   : place.from_target));
  }

  bool is_point(const Node node) const { return node >= m_first_point && node < m_first_sector; }

  // The distance to another point of the edge, measured from the end that the place is closer to.
  double gap(const Place& place, const Node other) const
  {
    return place.from_source < place.from_target
               ? std::abs(distance_from_end(place.halfedge, other, true) - place.from_source)
               : std::abs(distance_from_end(place.halfedge, other, false) - place.from_target);
  }

  // The distance of a point on the edge of `h` from the source or the target of `h`.
  double distance_from_end(const Index h, const Node node, const bool is_from_source) const
  {
    const Index p = node - m_first_point, e = m_points.edge(h);
    const bool is_from_first_end = m_points.is_first(h) == is_from_source;
    return m_triangulation.length(h) *
           (is_from_first_end ? m_points.part_before(e, p) : m_points.part_behind(e, p));
  }

  // Whether a node is on one of the two edges of a face that are not the first, and not at an end
  // of that.
  bool is_opposite(const Node node, const Place& place, const Face& face) const
  {
    if(!is_point(node)) // but a vertex, or null
      return node != place.toward_source && node != place.toward_target &&
             node == corner_node(m_triangulation.target(face.second), face.third);
    const Index e = m_points.edge(m_points.halfedge(node - m_first_point));
    return e == m_points.edge(face.second) || e == m_points.edge(face.third);
  }

  // The arcs across a face, whose first halfedge is that of the place.
  template <typename Labels, typename F>
  void expand_face(const Place& place, const Face& face, const Labels& labels, F& f) const
  {
    const double weight = m_triangulation.weight(place.halfedge);
    const double length = m_triangulation.length(place.halfedge);
    const Row at_target = row_from_source(face.second), at_source = row_from_target(face.third);

    const internal::Corner corner(length, at_target.length(), at_source.length());
    f(corner_node(m_triangulation.target(face.second), face.third),
      weight * corner.distance(place.from_target, at_target.length()));
    if(at_target.size() > 0)
      visit(at_target, worthwhile(at_target, corner, weight, place, false, labels), corner,
            place.from_target, weight, f);
    if(at_source.size() > 0)
    {
      const internal::Corner other_corner(length, at_source.length(), at_target.length());
      visit(at_source, worthwhile(at_source, other_corner, weight, place, true, labels),
            other_corner, place.from_source, weight, f);
    }
  }

  // The ranks of the points of a row that a path over a place may be the cheapest one to, given its
  // neighbours. The row starts from the corner at the source or target of the place's halfedge.
  template <typename Labels>
  std::pair<Index, Index> worthwhile(const Row& row,
                                     const internal::Corner& corner,
                                     const double weight,
                                     const Place& place,
                                     const bool is_at_source,
                                     const Labels& labels) const
  {
    if(row.size() < LONG_ROW)
      return {0, row.size()};
    const auto reached = [&](const Node node, const double distance_if_vertex) {
      return Reached_point{labels.distance(node),
                           is_point(node) ? distance_from_end(place.halfedge, node, is_at_source)
                                          : distance_if_vertex};
    };
    const double length = m_triangulation.length(place.halfedge);
    return internal::cell(
        row, corner, weight, reached(place.node, 0),
        reached(is_at_source ? place.toward_source : place.toward_target, 0),
        reached(is_at_source ? place.toward_target : place.toward_source, length));
  }

  // ----- set-up

  void summarize_arcs()
  {
    m_arc_lengths = Arc_lengths();
    double shortest = infinity, sum = 0, longest = 0;
    std::size_t number_of_arcs = 0;
    m_points.for_each_first_halfedge([&](const Index h, const Index e) {
      const double cost = weight_along(h) * m_triangulation.length(h);
      if(!(cost < infinity)) // nor a forbidden edge of length zero
        return;
      const std::size_t number = m_points.number_of_points(e) + std::size_t(1);
      shortest = (std::min)(shortest, cost / double(number));
      sum += cost;
      longest = (std::max)(longest, cost);
      number_of_arcs += number;
    });
    if(number_of_arcs > 0)
      m_arc_lengths = {shortest, sum / double(number_of_arcs), longest};
  }

  void find_maximum_degree()
  {
    std::size_t largest = 0;
    for(Index v = 0; v < m_triangulation.number_of_vertices(); ++v)
    {
      std::size_t degree = 1; // to the vertex, from one of its sectors
      for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v); ++h)
        degree += 2 + number_of_opposite_points(h); // a barrier is two edges
      largest = (std::max)(largest, degree);
    }
    m_points.for_each_first_halfedge([&](const Index h, Index /* edge */) {
      const Index twin = m_triangulation.opposite(h);
      std::size_t degree = 4; // along the edge, and to the third vertices of both faces
      for(const Index side : {h, twin})
        if(!m_triangulation.is_border(side))
          degree += number_of_opposite_points(side) +
                    number_of_opposite_points(m_triangulation.next(side));
      largest = (std::max)(largest, degree);
    });
    m_maximum_degree = largest;
  }

  // On the edge opposite to the source of `h`, in the face to the left of `h`.
  std::size_t number_of_opposite_points(const Index h) const
  {
    return m_triangulation.is_border(h)
               ? 0
               : m_points.number_of_points(m_points.edge(m_triangulation.next(h)));
  }

  Intrinsic_triangulation m_triangulation;
  Placement m_placement;
  internal::Sectors m_sectors;
  internal::Points_on_edges m_points;
  Node m_first_point = 0;  // the vertices come before
  Node m_first_sector = 0; // the points do
  Arc_lengths m_arc_lengths;
  std::size_t m_maximum_degree = 0;
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_STEINER_GRAPH_H
