/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `GeodesicRun` describes what a search of a graph needs beside distances and
predecessors: which nodes were expanded before, upper bounds of distances, or how paths arrive. It
is the type `Run` of a `GeodesicGraph`. A graph that needs no such thing has no `Run`; then
`CGAL::Approximate_geodesics::Geodesic_run_base` reports its arcs. A `Run` can derive from that
class, and define only the members that it replaces.

`CGAL::Approximate_geodesics::Propagation` makes an object of this type of the graph, keeps it for
all of its runs, and calls it for each of them in this order:
-# `forget()`, if there was a run before that the new one does not continue;
-# `start()`;
-# `on_label()` for each node where the run starts;
-# for each batch of nodes, `expand()`, and then `on_label()` for each label that falls;
-# `finish()`, when no node is left to expand, unless the run ended early or has a heuristic. If
this lowers labels, the run goes on with the step before;
-# `discard()` for nodes whose labels are not final, if the run ended early.

If an exception leaves the run, `forget_all()` is called. All calls come from one thread.

<b>Labels</b> are distances in units of the graph. `labels`, which are to be read only, have these
member functions:
- `labels.distance(n)` is the smallest distance of the node `n` found so far, or infinity if it was
  not reached. It may still fall, for `n` being expanded, too.
- `labels.is_reached(n)` is whether that distance is finite.
- `labels.predecessor(n)` is the node that `n` was reached from with this distance, and thus says
from which direction the path arrives; for a node that the search started from it is the largest
`Node`, which stands for none. It may be asked for if `n` was reached.
- `labels.number_of_nodes()` is the number of nodes.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Geodesic_run_base}
\cgalHasModelsEnd

\sa `GeodesicGraph`
*/
class GeodesicRun
{
public:
  /// \name Types and Creation
  /// @{

  /// what is kept of the path to a node: a class with a default constructor, which has the value of
  /// nodes where a run starts. It may be empty.
  using Payload = unspecified_type;

  /// prepares for runs on a graph.
  explicit GeodesicRun(const GeodesicGraph& graph);

  /// @}

  /// \name Runs
  /// @{

  /*!
  is called when a run starts, before any node has a label.

  \tparam Search a type with these member functions:
          - `find_upper_bounds(graph, f)` runs Dijkstra's algorithm, or A*, on another
  `GeodesicGraph` with the same nodes and the same unit, from where the run starts, and until it is
  known how far the targets of the run can be. It then calls `f(node, label)` for each node reached,
  whose distance in the graph to be searched must not exceed this label.
          - `limit()` is the largest label that is of interest, which `find_upper_bounds()` lowers
  if the run has targets.
          - `heuristic()` is a `std::function<double(Node)>`, valid until the run ends: a lower
  bound of the distance to the target. It is empty unless `run_toward()` was called.
          - `starts_from_curves()` is whether the run starts from curves. The labels of its seeds
  use up a part of the error bound of the graph then.
  */
  template <typename Search>
  void start(Search& search);

  /*!
  appends the arcs of several nodes to `candidates`, in any order.

  \param nodes the nodes; one of them may have been expanded before, with a larger distance
  \param number their number; `0` only if this call was requested
  \param labels what the search has found so far; labels do not change meanwhile
  \param candidates an object with these member functions:
         - `make_room(n)` is to be called before `n` calls of `append()`;
         - `append(is_arc, node, label, target, length)` appends an arc if `is_arc` is `true`, whose
           start has this label. It does not branch, so it may pay to call it in vain;
         - `append(is_arc, node, label, target, length, payload)` does the same, and keeps the
  payload if the label of the target falls;
         - `append_arcs(graph, nodes, number, labels)` appends what `for_each_arc()` reports;
         - `append_in_parallel(loop, n, f)` calls `f(i, part)` for all `i` below `n`, where `part`
  is an object like `candidates`, and appends what was appended to these, in the order of `i`.
           `loop.run(n, g)` has to call `g(i, thread)` for all `i` below `n`, at the same time only
           with different values of `thread`, all below `loop.number_of_threads()`; `part.thread()`
           is this value;
         - `call_again(node, label)` requests that this function is called again, perhaps without
           any node, before nodes are expanded with larger labels than this one. `node` is one that
           was expanded with a smaller label. The last request counts, and none remains after the
           next call. It is not to be made in searches with a heuristic.

  `GeodesicGraph::for_each_arc()` says which arcs may be left out.
  */
  template <typename Labels, typename Candidates>
  void expand(const Node* nodes, std::size_t number, const Labels& labels, Candidates& candidates);

  /// is called when the label of a node has fallen to `distance`, along an arc with this payload.
  void on_label(Node node, double distance, const Payload& payload);

  /// is called when no node is left to expand. `search.labels()` and `search.limit()` are as above;
  /// `search.lower(node, label, predecessor)` lowers a label, without calling `on_label()`, and the
  /// node will be expanded.
  template <typename Search>
  void finish(Search& search);

  /// forgets one node, whose label was not final.
  void discard(Node node);

  /// forgets the last run, in which these nodes were expanded. They may occur more than once.
  void forget(const std::vector<Node>& nodes);

  /// forgets all nodes.
  void forget_all();

  /// @}

  /// \name Properties
  /// @{

  /// returns how many nodes to expand at once if the queue can give more than usual, see
  /// `GeodesicPriorityQueue::extract_round()`; `0` if the usual number is all right.
  std::size_t largest_batch() const;

  /// returns the number of bytes that the object takes, apart from its own size.
  std::size_t memory() const;

  /// @}

  /// \name Lines
  /// For graphs that are searched by `CGAL::Approximate_geodesics::Surface_search`.
  /// `CGAL::Approximate_geodesics::Geodesic_run_base` has these, but for the last two, which are
  /// only needed if `attaches_by_labels` is `true`. A point is a
  /// `CGAL::Approximate_geodesics::Intrinsic_point`. Lengths, and the labels of points, are in
  /// units of the graph.
  /// @{

  /// whether the lines between points and nodes depend on labels: whether there are more of them
  /// than `attach()` of the graph finds.
  static constexpr bool attaches_by_labels = unspecified_value;

  /// calls `f(h, t)` for every edge that the arc crosses along which the label of `target` was
  /// found from that of `source`, as `SurfaceGraph::for_each_crossing()` does, and returns its
  /// length.
  template <typename Labels, typename F>
  double for_each_crossing(Node source, Node target, const Labels& labels, const F& f) const;

  /// does the same for the line from `point`, where the search has started with the label
  /// `distance`, to `target`.
  template <typename Labels, typename F>
  double for_each_crossing_from(const Intrinsic_point& point,
                                double distance,
                                Node target,
                                const Labels& labels,
                                const F& f) const;

  /// does the same for the line of the given length from `point`, whose distance from the sources
  /// is `distance`, to `end`: a `Node` on its path, or a source that is not a vertex.
  template <typename End, typename Labels, typename F>
  double for_each_crossing_to(const Intrinsic_point& point,
                              double distance,
                              const End& end,
                              double length,
                              const Labels& labels,
                              const F& f) const;

  /// calls `f(node, length, payload)` for the lines from a point where the run starts with the
  /// label `distance`. It is called after `start()`, also for vertices.
  template <typename F>
  void for_each_line_from(const Intrinsic_point& point, double distance, F f) const;

  /// calls `on_node(node, length)` and `on_point(i, length)` for the lines from nodes, and from
  /// `points[i]`, to a point that is not a vertex: for those on paths that are not longer than
  /// `distance`. `points` are the sources, `CGAL::Approximate_geodesics::Points_by_face`.
  template <typename Labels, typename OnNode, typename OnPoint>
  void for_each_line_to(const Intrinsic_point& point,
                        double distance,
                        const Labels& labels,
                        const Points_by_face& points,
                        OnNode on_node,
                        OnPoint on_point) const;

  /// @}
};
