/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `BucketWidthPolicy` describes how to choose the width of the buckets of a
`CGAL::Approximate_geodesics::Basic_adaptive_bucket_queue`, and how to change it from one run to the
next.

The choice affects only the run time, never the distances.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Balanced_bucket_width}
\cgalHasModelsEnd
*/
class BucketWidthPolicy
{
public:
  /// chooses the width for the first run, on a graph with the given arcs. If there are no arcs, all
  /// their lengths are zero.
  explicit BucketWidthPolicy(const CGAL::Approximate_geodesics::Arc_lengths& arcs);

  /// returns the width of the buckets, in units of the graph: a positive number that is finite, as
  /// is its reciprocal. The queue calls it once before each run.
  double width() const;

  /// chooses the width for the next run, given the figures of the last one. That run may have ended
  /// early, or may have done nothing; there is also such a call before the first run.
  void update(const CGAL::Approximate_geodesics::Bucket_statistics& last_run);
};
