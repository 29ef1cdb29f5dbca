/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `GeodesicVisitor` describes an object that watches a run, and may end it. It is given as
the named parameter `visitor`, or to `CGAL::Approximate_geodesics::Propagation::run()`.

A vertex is <em>settled</em> as soon as its distance is final. This is found out in groups: whenever
the search goes on to larger distances, a number of vertices are settled at once. Then
`on_settled()` is called for each of them, `on_progress()` once, and `go_further()` once. When the
search has come to its end, there is one last group, for which `go_further()` is not called any
more; neither is it when all targets are settled.

All calls come from the thread that runs the search. The functions must not run or change the object
that calls them, and what that object answers is not certain before the run has ended. They may
throw: the run ends, and the exception leaves the function that started it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Geodesic_visitor_base}
\cgalHasModelsEnd
*/
class GeodesicVisitor
{
public:
  /*!
  is called once for every vertex that is reached, when its distance is final. The distances of
  successive calls never decrease.

  \tparam Vertex the type of vertices: the mesh's `vertex_descriptor`, or
          `CGAL::Approximate_geodesics::Propagation::Node` if it is that class which is run

  \param vertex the vertex. Nodes that are not vertices, but points that a graph has added, are
         passed on only by `CGAL::Approximate_geodesics::Propagation`.
  \param distance its distance from the nearest source, in the unit of the mesh
  */
  template <typename Vertex>
  void on_settled(const Vertex& vertex, double distance);

  /*!
  is called after each group of settled nodes, and at the end of the run unless it was ended early.

  \param number_of_settled_nodes how many nodes were settled since the run began
  \param number_of_nodes how many nodes the graph has. A run that cannot reach all of them ends
         before the other number gets there.
  */
  void on_progress(std::size_t number_of_settled_nodes, std::size_t number_of_nodes);

  /// returns whether the search shall go on. If not, the run ends in the normal way: vertices that
  /// were settled keep their distances, and all others count as not reached.
  bool go_further();
};
