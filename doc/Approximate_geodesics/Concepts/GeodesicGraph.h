/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `GeodesicGraph` describes a graph that `CGAL::Approximate_geodesics::Propagation`
searches. The concept `SurfaceGraph` refines it: it adds what places the graph on a surface.

<b>Nodes</b> are numbered from `0` on without gaps.

<b>Lengths</b> are finite, not negative, and in units of `unit()`, which is called the unit of the
graph. They can be costs.

<b>Arcs</b> need not be stored. They are asked for when the search expands a node, and may be
computed then. They may also depend on how the search got there: `for_each_arc()` is given the
labels of the search.

A graph whose arcs depend on more than that has a type `Run`: a search keeps an object of it, which
can find upper bounds of distances first, keep something with each label, expand several nodes
together, or use several threads.

All member functions are `const`, and several threads may call them for the same object at the same
time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Edge_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Discrete_geodesic_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Saddle_vertex_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Steiner_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Directional_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Grid_graph}
\cgalHasModelsEnd

\sa `GeodesicRun`
\sa `SurfaceGraph`
\sa `CGAL::Approximate_geodesics::Propagation`
*/
class GeodesicGraph
{
public:
  /// \name Types
  /// @{

  /// the number of a node: `std::uint32_t`. The largest number stands for no node.
  using Node = std::uint32_t;

  /// @}

  /// \name Required
  /// @{

  /// returns the number of nodes.
  std::size_t number_of_nodes() const;

  /// returns the unit of lengths, a power of two, in the unit of the mesh.
  double unit() const;

  /// returns a summary of the lengths of the arcs, or an estimate. Queues set themselves up with
  /// it; they work with arcs of other lengths, too, only not as fast.
  /// `summarize_arc_lengths()` makes it of a list of lengths; both are in
  /// `CGAL/Approximate_geodesics/Base/Arc_lengths.h`.
  CGAL::Approximate_geodesics::Arc_lengths arc_lengths() const;

  /*!
  calls `f(target, length)` for every arc that starts from `node`, in any order.

  No label changes while the member function is running.

  \tparam Labels the type of the labels
  \tparam F a function object called with a `Node` and a `double`

  \param node the node that is being expanded. It may be expanded more than once in a run, each time
              with a smaller distance than before.
  \param labels what the search has found so far, to be read only:
         distances, reached nodes and predecessors, as `GeodesicRun` lists them. The distance of
         `node` is the one that it is being expanded with. Others are upper bounds, which may still
         fall.
  \param f what to call. `f(first, lengths, number)`, where `lengths` is a `const double*`, stands
         for so many arcs to consecutive nodes.

  A graph that does not look at `labels` reports the same arcs whenever it is asked about a node.
  One that does may leave out arcs that cannot shorten any path: an arc to a node `t` if
  `labels.distance(node) + length >= labels.distance(t)`, or if the path that arrives at `node` is
  such that `t` is reached at least as well in another way. Only then are distances independent of
  the order in which nodes are expanded, and of the queue. (`Lazy_discrete_geodesic_graph` goes
  further: it leaves out arcs if `t` is reached well enough in another way.)

  A graph with a `Run` does not need this member function, unless the `Run` uses it.
  */
  template <typename Labels, typename F>
  void for_each_arc(Node node, const Labels& labels, F f) const;

  /// @}

  /// \name Optional
  /// A graph that does not have these members is searched all the same.
  /// @{

  /// returns an upper bound of the number of arcs that `for_each_arc()` reports of a node. The
  /// search keeps room for so many; if there are more, its behavior is undefined. A graph without
  /// this member function is searched a bit more slowly.
  std::size_t maximum_degree() const;

  /// prefetches the data for expanding `node`. It is called for nodes that will probably be
  /// expanded soon.
  void prefetch(Node node) const;

  /// what a search of the graph needs, a model of `GeodesicRun`. The default is
  /// `CGAL::Approximate_geodesics::Geodesic_run_base<GeodesicGraph>`.
  using Run = unspecified_type;

  /// returns whether several threads take part in each search, so that there is no use in several
  /// searches at the same time. The default is `false`.
  bool is_parallel() const;

  /// @}

  /// \name Optional, for Arcs That Cost Nothing
  /// If lengths are costs, many paths can cost the same. With these members,
  /// `Propagation::predecessor()` tells those whose free parts are shortest. The header
  /// `CGAL/Geodesic_costs.h` has to be included.
  /// @{

  /// returns whether there may be arcs that cost nothing.
  bool has_free_arcs() const;

  /// calls `f(target, length)` for the arcs from `node` that cost nothing, with their lengths in
  /// any unit, or `f(first, lengths, number)` as above. `starts` tells whether paths start with the
  /// node, if that makes a difference.
  template <typename F>
  void for_each_free_arc(Node node, bool starts, F f) const;

  /// @}

  /// \name Optional, for Repairs
  /// `Propagation::repair()` needs groups of nodes, such that the groups of a node contain the
  /// other ends of all arcs that start from it, and of all that lead to it. A graph with a `Run` is
  /// not repaired. The header `CGAL/Geodesic_costs.h` has to be included.
  /// @{

  /// returns the number of groups, which are numbered from `0` on.
  std::size_t number_of_groups() const;

  /// calls `f(group)` for groups of a node, and maybe several times: enough of them to contain the
  /// ends of its arcs.
  template <typename F>
  void for_each_group(Node node, F f) const;

  /// calls `f(node)` for the nodes of a group, and maybe several times.
  template <typename F>
  void for_each_node_of_group(std::size_t group, F f) const;

  /// returns how arcs have changed since the graph was built. Without this member function, they
  /// never change, and only other seeds are a reason for a repair.
  const CGAL::Approximate_geodesics::Arc_changes& arc_changes() const;

  /// @}
};
