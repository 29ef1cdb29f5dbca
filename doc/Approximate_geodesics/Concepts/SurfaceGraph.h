/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `SurfaceGraph` describes a graph whose nodes are points of a triangulated surface and
whose arcs are paths between them. `CGAL::Approximate_geodesics::Surface_search` finds distances and
paths between any points of the surface with it, and
`CGAL::Approximate_geodesics::Surface_mesh_shortest_path` does so for a mesh.

The first nodes are the vertices of `triangulation()`, with the numbers that they have there; a
graph may add nodes of its own after them.

A graph whose arcs are edges needs three members more than a `GeodesicGraph` has:

\code{.cpp}
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h> // to read meshes
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>

static constexpr bool arcs_are_edges = true;
const Intrinsic_triangulation& triangulation() const { return m_triangulation; }
Lines_in_faces attach(const Intrinsic_point& p) const { return {m_triangulation, p}; }
\endcode

\cgalRefines{GeodesicGraph}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Edge_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Discrete_geodesic_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Saddle_vertex_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Steiner_graph}
\cgalHasModels{CGAL::Approximate_geodesics::Directional_graph}
\cgalHasModelsEnd

\sa `CGAL::Approximate_geodesics::Surface_search`
\sa `CGAL::Approximate_geodesics::Surface_mesh_shortest_path`
*/
class SurfaceGraph
{
public:
  /// \name Creation
  /// @{

  /// builds the graph of `triangulation`. Only
  /// `CGAL::Approximate_geodesics::Surface_mesh_shortest_path` needs this constructor, unless it is
  /// given a graph, and passes on the named parameters that it was given.
  template <typename NamedParameters>
  SurfaceGraph(CGAL::Approximate_geodesics::Intrinsic_triangulation triangulation,
               const NamedParameters& np);

  /// @}

  /// \name Required
  /// @{

  /// returns the triangulation that the graph was built on. It is the same object as long as the
  /// graph exists.
  const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation() const;

  /*!
  attaches a point of the surface to the graph. Lengths are in units of the graph. The object that
  is returned may refer to the graph.
  It has these member functions, all of them `const`:
  - `for_each_node(f)` calls `f(node, length)` for straight lines between the point and nodes:
    enough of them for paths that start or end there. If the point is a vertex, these are the nodes
    that stand for it, with length `0`. An infinite length stands for no line.
  - `for_each_point(points, f)` calls `f(i, length)` for straight lines to `points[i]`, which need
    not pass a node; `points` are `CGAL::Approximate_geodesics::Points_by_face`, and the attached
    point is not a vertex.
  - `for_each_crossing(end, length, f)` does for one of these lines what `for_each_crossing()` of
    the graph does for an arc, from the attached point on; `end` is a `Node`, or a
    `CGAL::Approximate_geodesics::Intrinsic_point` that is not a vertex.

  `CGAL::Approximate_geodesics::Lines_in_faces` is such a type, for graphs whose nodes are the
  vertices, and whose unit is that of the triangulation. It also supports curves as sources, which
  a graph of your own does only if it returns this type and has no `Run` that `attaches_by_labels`.
  */
  unspecified_type attach(const CGAL::Approximate_geodesics::Intrinsic_point& point) const;

  /// does the same for a point where searches arrive: lengths are those of the ways from nodes to
  /// the point. Only needed if the ways there and back differ.
  unspecified_type attach_target(const CGAL::Approximate_geodesics::Intrinsic_point& point) const;

  /// returns whether distances are those to the sources of a search, and not from them. Only needed
  /// if these differ; matrices are not made symmetric then.
  bool leads_to_sources() const;

  /*!
  calls `f(h, t)` for every edge that the arc from `source` to `target` crosses, in this order: at
  the point that is at the part `t`, a `double` from `0` to `1`, of the way from the source to the
  target of the halfedge `h` of `triangulation()`. Between two such points, and before the first and
  after the last one, the arc runs straight through a face, or along an edge.

  A graph whose `arcs_are_edges` does not need this member function, nor one whose
  `GeodesicRun::for_each_crossing()` does not call it.

  \param source the node that the arc starts from
  \param target the node that it leads to
  \param length the length of the arc, up to rounding, in units of the graph: there may be several
                arcs between the two nodes
  \param f what to call

  \return the length of the arc before it was rounded, if it was, in units of the graph.
  */
  template <typename F>
  double for_each_crossing(Node source, Node target, double length, F f) const;

  /// @}

  /// \name Optional
  /// @{

  /// whether all nodes are vertices, and all arcs edges: then the points of paths can be of any
  /// type, and no arc is traced. The default is `false`.
  static constexpr bool arcs_are_edges = unspecified_value;

  /// returns where a node is that is not one of the vertices of `triangulation()`; it may stand for
  /// one of them, or lie on an edge. Only graphs with such nodes have this member function.
  CGAL::Approximate_geodesics::Intrinsic_point position(Node node) const;

  /// returns a bound on how much longer, relatively, the way back along an arc is than the arc: `0`
  /// if each arc leads back, infinity if nothing is known. The distances of nodes must not depend
  /// on the search. `CGAL::Approximate_geodesics::Landmarks` need it, and compare it with the
  /// distances that they find.
  double asymmetry() const;

  /// returns a number such that paths between vertices cost at most one plus this number times as
  /// much as the cheapest ones on the surface. `distance_intervals()` reads it; the default is
  /// infinity.
  double epsilon() const;

  /// returns a cost by which this bound is weaker for a point that is not a vertex, in units of the
  /// graph, as `Steiner_graph::cost_to_corner()` does. The default is `0`.
  double cost_to_corner(const CGAL::Approximate_geodesics::Intrinsic_point& point) const;

  /// replaces the weights of the faces. Only graphs that support weights have this member function;
  /// `set_face_weights()` of the class needs it.
  void set_weights(CGAL::Approximate_geodesics::Face_weights weights);

  /// changes the weights of some faces; `set_weights()` of the class needs it.
  void set_weights(const std::vector<CGAL::Approximate_geodesics::Weight_change>& changes);

  /// lifts barriers, or puts them back; `set_barriers()` of the class needs it.
  void set_barriers(const std::vector<CGAL::Approximate_geodesics::Barrier_change>& changes);

  /// @}
};
