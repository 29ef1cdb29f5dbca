/*!
\ingroup PkgGeodesicQueriesConcepts
\cgalConcept

The concept `DistanceMatrixVisitor` describes an object that watches the computation of a distance
matrix, and may end it. It is passed as the named parameter `visitor` to
`CGAL::approximate_geodesic_distance_matrix()`, and to
`CGAL::approximate_geodesic_pair_distances()`, where a row is a source.

If several threads compute, calls are serialized: the visitor needs no lock for itself. It does for
what other threads of the program change, such as a flag that cancels the computation, which has to
be a `std::atomic<bool>`. The functions may throw: the computation ends, and the exception leaves
the function that started it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Distance_matrix_visitor_base}
\cgalHasModelsEnd
*/
class DistanceMatrixVisitor
{
public:
  /// is called after each block of rows or, if rows go to a function object, after each row. The
  /// number of rows done never decreases.
  void on_progress(const CGAL::Approximate_geodesics::Distance_matrix_progress& progress);

  /// returns whether the computation is to continue. It is called before each row. If it returns
  /// `false`, threads finish their current rows, incomplete blocks are dropped, and the function
  /// returns `false`. Other threads may still call it once.
  bool go_further();
};
