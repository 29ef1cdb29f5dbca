/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `GeodesicGraph` describes a graph on a triangulated surface, whose nodes are points of
the surface and whose arcs are paths between them, as searched by
`CGAL::Approximate_geodesics::Propagation`.

<b>Nodes</b> are numbered from `0` on without gaps. The first of them are the vertices of
`triangulation()`, with the numbers that they have there; a graph may add nodes of its own after
them.

<b>Lengths</b> are finite, not negative, and in units of `unit()`, which is called the unit of the
graph. They can be costs.

<b>Arcs</b> need not be stored. They are asked for when the search expands a node, and may be
computed then. They may also depend on how the search got there: `for_each_arc()` is given the
labels of the search.

All member functions are `const`, and several threads may call them for the same object at the same
time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Edge_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Discrete_geodesic_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Steiner_graph}
\cgalHasModelsEnd

\sa `CGAL::Approximate_geodesics::Propagation`
*/
class GeodesicGraph
{
public:
  /// \name Types
  /// @{

  /// the number of a node: `std::uint32_t`. The largest number stands for no node.
  using Node = CGAL::Approximate_geodesics::Intrinsic_triangulation::Index;

  /// @}

  /// \name Creation
  /// @{

  /// builds the graph of `triangulation`. The search does not need this constructor;
  /// `CGAL::Approximate_geodesics::Surface_mesh_shortest_path` does, and passes on the named
  /// parameters that it was given.
  template <typename NamedParameters>
  GeodesicGraph(CGAL::Approximate_geodesics::Intrinsic_triangulation triangulation,
                const NamedParameters& np);

  /// @}

  /// \name Access
  /// @{

  /// returns the triangulation that the graph was built on. It is the same object as long as the
  /// graph exists.
  const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation() const;

  /// returns the number of nodes, which is at least the number of vertices of `triangulation()`.
  std::size_t number_of_nodes() const;

  /// returns the unit of lengths, a power of two, in the unit of the mesh: usually
  /// `triangulation().unit()`.
  double unit() const;

  /// returns where a node is that is not one of the vertices of `triangulation()`; it may stand for
  /// one of them, or lie on an edge. Only graphs with such nodes have this member function. The
  /// search does not need it; whoever draws paths does.
  CGAL::Approximate_geodesics::Intrinsic_point place(Node node) const;

  /// returns a summary of the lengths of the arcs, or an estimate. Queues set themselves up with
  /// it; they work with arcs of other lengths, too, only not as fast.
  CGAL::Approximate_geodesics::Arc_lengths arc_lengths() const;

  /// returns an upper bound of the number of arcs that `for_each_arc()` reports of a node. The
  /// search keeps room for so many; if there are more, its behaviour is undefined. A graph that has
  /// no such bound does not have this member function, and is searched a bit more slowly.
  std::size_t maximum_degree() const;

  /*!
  calls `f(target, length)` for every arc that starts from `node`, in any order.

  No label changes while the member function is running.

  \tparam Labels the type of the labels
  \tparam F a function object called with a `Node` and a `double`

  \param node the node that is being expanded. It may be expanded more than once in a run, each time
              with a smaller distance than before.
  \param labels what the search has found so far, to be read only:
         - `labels.distance(n)` is the smallest distance of the node `n` found so far, in units of
           the graph, or infinity if it was not reached. That of `node` is the one that it is being
           expanded with. Others are upper bounds, which may still fall.
         - `labels.is_reached(n)` is whether that distance is finite.
         - `labels.predecessor(n)` is the node that `n` was reached from with this distance, and
           thus says from which direction the path arrives; for a node that the search started from
           it is the largest `Node`, which stands for none. It may be asked for if `n` was reached.
         - `labels.number_of_nodes()` is the number of nodes.
         - `labels.was_expanded(n)` is whether `n` was expanded before in this run, with a larger
           distance. It is always `false` if the graph has a member function `maximum_degree()`.
  \param f what to call

  A graph that does not look at `labels` reports the same arcs whenever it is asked about a node.
  One that does may leave out arcs that cannot shorten any path: an arc to a node `t` if
  `labels.distance(node) + length >= labels.distance(t)`, or if the path that arrives at `node` is
  such that `t` is reached at least as well in another way. Only then are distances independent of
  the order in which nodes are expanded, and of the queue. (`Lazy_discrete_geodesic_graph` goes
  further: it leaves out arcs if `t` is reached well enough in another way.)
  */
  template <typename Labels, typename F>
  void for_each_arc(Node node, const Labels& labels, F f) const;

  /*!
  calls `f(h, t)` for every edge that the arc from `source` to `target` crosses, in this order: at
  the point that is at the part `t`, a `double` from `0` to `1`, of the way from the source to the
  target of the halfedge `h` of `triangulation()`. Between two such points, and before the first and
  after the last one, the arc runs straight through a face, or along an edge.

  The search does not need this; whoever draws paths does.

  \param source the node that the arc starts from
  \param target the node that it leads to
  \param length the length of the arc, up to rounding, in units of the graph: there may be several
                arcs between the two nodes
  \param f what to call

  \return the length of the arc before it was rounded, if it was, in units of the graph.
  */
  template <typename F>
  double for_each_crossing(Node source, Node target, double length, F f) const;

  /// is told that `node` will probably be expanded soon, and may ask the memory for what this
  /// takes. It may just as well do nothing.
  void prefetch(Node node) const;

  /// @}

  /*!
  \name Places That Are Not Nodes

  `CGAL::Approximate_geodesics::Surface_mesh_shortest_path` and the functions of this package need
  these member functions. The search does not.
  */
  /// @{

  /*!
  calls `f(node, length)` for straight lines from a place on the surface to nodes, or back: enough
  of them for paths that start or end there. If `place` is a vertex, these are the nodes that stand
  for it, with length `0`.
  */
  template <typename F>
  void for_each_arc(const CGAL::Approximate_geodesics::Intrinsic_point& place, F f) const;

  /*!
  calls `f(i, length)` for straight lines from a place on the surface to others, none of which need
  be those of nodes.

  \param place a place that is not a vertex
  \param places the others: `places[i]` is one of them, and
         `places.for_each_in_face(triangulation(), h, g)` calls `g(i)` for those in the face to the
         left of the halfedge `h`, and on its sides
  \param f what to call
  */
  template <typename Places, typename F>
  void for_each_line(const CGAL::Approximate_geodesics::Intrinsic_point& place,
                     const Places& places,
                     F f) const;

  /// does what `for_each_crossing()` does between nodes, from a place to the node `target`.
  template <typename F>
  double for_each_crossing(const CGAL::Approximate_geodesics::Intrinsic_point& source,
                           Node target,
                           double length,
                           F f) const;

  /// does the same from a place to another.
  template <typename F>
  double for_each_crossing(const CGAL::Approximate_geodesics::Intrinsic_point& source,
                           const CGAL::Approximate_geodesics::Intrinsic_point& target,
                           double length,
                           F f) const;

  /// @}
};
