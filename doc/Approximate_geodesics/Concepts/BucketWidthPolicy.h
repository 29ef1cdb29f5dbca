/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `BucketWidthPolicy` describes how the width of the buckets of a
`CGAL::Approximate_geodesics::Basic_adaptive_bucket_queue` is chosen, and how it changes from one
run to the next.

The choice has no influence on the distances, only on the time that it takes to find them.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Balanced_bucket_width}
\cgalHasModels{CGAL::Approximate_geodesics::Published_bucket_width}
\cgalHasModelsEnd
*/
class BucketWidthPolicy
{
public:
  /// chooses the width for the first run, on a graph with the given arcs. All of their lengths are
  /// zero if there are no arcs.
  explicit BucketWidthPolicy(const CGAL::Approximate_geodesics::Arc_lengths& arcs);

  /// returns the width of the buckets, in units of the graph. It is larger than zero, and neither
  /// it nor its reciprocal is infinite. The queue asks for it once before each run.
  double width() const;

  /// is given the figures of a run after it, to choose the width for the next one. The figures may
  /// be those of a run that ended early, or that consisted of nothing: there is such a call before
  /// the first run, too.
  void update(const CGAL::Approximate_geodesics::Bucket_statistics& last_run);
};
