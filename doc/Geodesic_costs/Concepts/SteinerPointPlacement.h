/*!
\ingroup PkgGeodesicCostsConcepts
\cgalConcept

The concept `SteinerPointPlacement` describes where `CGAL::Approximate_geodesics::Steiner_graph`
and `CGAL::Approximate_geodesics::Directional_graph` place points on edges. A graph stores a copy of
its placement.

A <b>position</b> on an edge is a part of it, measured from the nearer end, so that points very
close to an end can be told apart: from `0` to `0.5`, it is the part of the edge between the source
of the halfedge and the point; if it is negative, minus the part between the point and the target.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Fixed_number_of_points}
\cgalHasModels{CGAL::Approximate_geodesics::Points_at_interval}
\cgalHasModels{CGAL::Approximate_geodesics::Geometric_points}
\cgalHasModels{CGAL::Approximate_geodesics::Directional_points}
\cgalHasModelsEnd
*/
class SteinerPointPlacement
{
public:
  /// the number of a halfedge.
  using Index = CGAL::Approximate_geodesics::Intrinsic_triangulation::Index;

  /// whether points divide every edge into equal parts. Their positions are not stored then.
  static constexpr bool makes_equal_parts = unspecified;

  /// reads named parameters. Only needed if the graph is to be built from these.
  template <typename NamedParameters>
  explicit SteinerPointPlacement(const NamedParameters& np);

  /// is called once, before all other functions. If there are more than `maximum_number_of_points`
  /// points on all edges together, the graph rejects them before it allocates memory. A placement
  /// can avoid that by fewer points and a weaker bound.
  void prepare(const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation,
               std::size_t maximum_number_of_points);

  /// returns the number of points on the edge of `h`, which is longer than zero. It is called for
  /// one halfedge of every edge, and for both of a barrier.
  std::size_t
  number_of_points(const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation,
                   Index h) const;

  /// writes the positions of these points, ascending from the source to the target of `h`. Not
  /// needed if `makes_equal_parts`.
  void place(const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation,
             Index h,
             float* positions,
             std::size_t number_of_points) const;

  /// returns a number such that paths cost at most one plus this number times as much as the
  /// cheapest ones on the surface, with the weights that `triangulation` has now; infinity if there
  /// is none.
  double epsilon(const CGAL::Approximate_geodesics::Intrinsic_triangulation& triangulation) const;

  /// returns the number of bytes that the placement takes, apart from its own size.
  std::size_t memory() const;

  /// returns the tangent of an angle \f$\beta\f$. `CGAL::Approximate_geodesics::Steiner_graph` may
  /// leave out arcs across a face, between sides with at least 128 points each, that make a smaller
  /// angle with a side: the way along the side, and across from there, is at most
  /// \f$1/\cos(\beta/2)\f$ times as long. `epsilon()` has to allow for that. Optional: without it,
  /// or if it is not positive, there are all arcs.
  double tangent_of_narrow_arcs() const;

  /// returns whether fewer points and a weaker bound are accepted. Optional: if it returns `false`,
  /// the message about too many points suggests `accept_weaker_bound`.
  bool accepts_weaker_bound() const;
};
