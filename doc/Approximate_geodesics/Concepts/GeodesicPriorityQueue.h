/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `GeodesicPriorityQueue` describes a queue of graph nodes with distances as keys, as used
by `CGAL::Approximate_geodesics::Propagation`.

The search has one verb to insert and to lower: `push()`. If a queue can find the entry of a node,
it lowers its key; if not, it leaves the old entry where it is, which has become <em>stale</em>. The
search recognizes stale entries when they come out, and skips them.

Entries come out in batches. A queue that keeps its entries in order returns one at a time. One that
does not care to order entries of similar keys returns some of those, and the search gains a lot:
the fewer decisions it has to take between one node and the next, the faster it is. The queue need
not return the smallest key either. Distances are right in any case, as the search expands a node
again whose distance has fallen since; the better the order, the less often this happens. What must
be exact is `is_final()`: it decides when the search may stop, and what a visitor is told.

<b>Monotony.</b> Between two calls of `clear()`, the first keys are pushed in any order; after the
first call of `extract_min()`, no key is pushed that is smaller than the smallest of the batch
extracted last.

<b>Finality in steps.</b> When `extract_min()` makes the key of any entry that was extracted earlier
final, it makes those of all entries that were extracted earlier final. (A queue that returns keys
in their order fulfils this, if it calls those final that are smaller than the last one; so does a
queue that empties one bucket after the other, if it calls those final that belong to earlier
buckets.)

If an exception leaves a member function, `clear()` makes the queue usable again. A queue that was
moved from may only be destroyed or assigned to.

A queue that counts may have a member function `statistics()` that returns a
`CGAL::Approximate_geodesics::Bucket_statistics`; the search then knows the number of comparisons.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Basic_adaptive_bucket_queue}
\cgalHasModels{CGAL::Approximate_geodesics::Basic_published_bucket_queue}
\cgalHasModels{CGAL::Approximate_geodesics::Radix_heap_queue}
\cgalHasModels{CGAL::Approximate_geodesics::D_ary_heap_queue}
\cgalHasModels{CGAL::Approximate_geodesics::Pairing_heap_queue}
\cgalHasModels{CGAL::Approximate_geodesics::Fibonacci_heap_queue}
\cgalHasModels{CGAL::Approximate_geodesics::Array_queue}
\cgalHasModelsEnd

\sa `CGAL::Approximate_geodesics::Propagation`
*/
class GeodesicPriorityQueue
{
public:
  /// \name Types
  /// @{

  /// the number of a node: `std::uint32_t`.
  using Node = unspecified_type;

  /// a distance, in units of the graph: `double`.
  using Key = unspecified_type;

  /// what comes out: a key and a node. A structured binding of two names gets them in this order.
  /// `CGAL::Approximate_geodesics::Queue_entry` will do.
  using Entry = unspecified_type;

  /// a range of entries, with member functions `begin()`, `end()` and `size()`.
  using Batch = unspecified_type;

  /// @}

  /// \name Creation
  /// @{

  /// makes an empty queue for a graph with `number_of_nodes` nodes and the given arcs.
  GeodesicPriorityQueue(std::size_t number_of_nodes,
                        const CGAL::Approximate_geodesics::Arc_lengths& arcs);

  /// @}

  /// \name Operations
  /// @{

  /// enters `node` with `key`; if it is present with a larger key, that entry is replaced or
  /// becomes stale. \pre `key` is not a NaN, not negative, and not smaller than the smallest
  /// key of the batch extracted last.
  void push(Node node, Key key);

  /// removes one or more entries, which may be stale, and returns them. The range is valid until
  /// the next call of `extract_min()` or `clear()`; `push()` leaves it as it is. It does not hold
  /// two entries of the same node and key. \pre `!is_empty()`
  Batch extract_min();

  /// removes all entries, and prepares for a new run, whose keys may be as small as zero. It is
  /// called before each run, the first one included; a queue that learns from a run does so here.
  void clear();

  /// @}

  /// \name Access
  /// @{

  /// returns whether no entry is left, not even a stale one.
  bool is_empty() const;

  /// returns whether `key` is smaller than all keys that are in the queue, and than all that may
  /// still be pushed in this run: those are not smaller than the key extracted last. Once true,
  /// this stays true until `clear()` is called; if it is true of a key, so it is of smaller ones.
  bool is_final(Key key) const;

  /// calls `f(node)` for the node of every entry that is present. It may do so more than once for
  /// a node, and for nodes whose entries were extracted before.
  template <typename F>
  void for_each_node(F f) const;

  /// returns the number of bytes that the queue takes.
  std::size_t memory() const;

  /// @}
};
