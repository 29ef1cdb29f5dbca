/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `GeodesicVisitor` describes an object that watches a run, and may end it. It is passed
as the named parameter `visitor`, or to `CGAL::Approximate_geodesics::Surface_search::run()` or
`CGAL::Approximate_geodesics::Propagation::run()`.

A vertex is <em>settled</em> when the search has found out that its distance is final. This happens
in groups: whenever the search goes on to larger distances, a number of vertices are settled at
once. For each group, `on_settled()` is called for each of its vertices, then `on_progress()` once,
then `go_further()` once. `go_further()` is not called when all targets are settled, nor after the
last group, when the search is complete.

A model that need not know the vertices can have a member `static constexpr bool is_told_of_nodes`
that is `false`: `on_settled()` is not called then, which spares the search sorting each group, and
a vertex may count as settled more than once.

All calls come from the thread that runs the search. The functions must not run or change the object
that calls them, and must not rely on what it answers before the run has ended. They may throw an
exception: the run ends, and the exception leaves the function that started it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Geodesic_visitor_base}
\cgalHasModelsEnd
*/
class GeodesicVisitor
{
public:
  /*!
  is called once for every vertex that is reached, when it is settled. The distances of successive
  calls never decrease.

  \tparam Vertex the type of vertices: the mesh's `vertex_descriptor`, or
          `CGAL::Approximate_geodesics::Propagation::Node` if an object of that class or a
          `CGAL::Approximate_geodesics::Surface_search` is run

  \param vertex the vertex. Only these two classes also pass nodes that are no vertices, but points
         that a graph has added.
  \param distance its distance from the nearest source, in the unit of the mesh
  */
  template <typename Vertex>
  void on_settled(const Vertex& vertex, double distance);

  /*!
  is called after each group of settled nodes, and at the end of a run that does not end early.

  \param number_of_settled_nodes the number of nodes settled since the run began
  \param number_of_nodes the number of nodes of the graph, which is never attained if some of them
         cannot be reached
  */
  void on_progress(std::size_t number_of_settled_nodes, std::size_t number_of_nodes);

  /// returns whether the search shall go on. If not, the run ends normally: settled vertices keep
  /// their distances, and all others count as not reached.
  bool go_further();
};
