/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `GeodesicPriorityQueue` describes a queue of graph nodes with distances as keys, as used
by `CGAL::Approximate_geodesics::Propagation`. That class checks at compile time that a queue has
all members below, and names the first one that is missing.

There is one operation to insert a node and to lower its key: `push()`. A queue that can find the
entry of a node lowers its key. Any other leaves the old entry where it is, which becomes
<em>stale</em>: the search recognizes stale entries when they come out, and skips them.

Entries come out in batches. A queue that keeps its entries in order returns one at a time. A queue
that does not order entries of similar keys returns several of them, which makes the search a lot
faster, as it takes fewer decisions between one node and the next. The keys returned need not be the
smallest ones: the search expands a node again if its distance falls afterwards, so that distances
are right in any order. The better the order, the less often this happens. Only `is_final()` must be
exact, as it decides when the search may stop and which nodes a visitor is notified of.

<b>Monotony.</b> After a call of `clear()`, the first keys are pushed in any order. After the first
call of `extract_min()`, no key is pushed that is smaller than the smallest key of the last batch.

<b>Finality.</b> A key is final if it is smaller than all keys that are in the queue or may still be
pushed. For a queue that returns entries one by one, in the order of their keys, this is one line:

\code{.cpp}
bool is_final(Key key) const { return key < m_key_extracted_last; } // which clear() sets to 0
\endcode

For a queue that empties one bucket after the other, the final keys are those that belong to earlier
buckets.

<b>Finality in steps.</b> If a call of `extract_min()` makes the key of any entry final that was
extracted before, it makes the keys of all of them final. Both kinds of queues above fulfill this.

If an exception leaves a member function, `clear()` makes the queue usable again. A queue that was
moved from may only be destroyed or assigned to.

<b>Optional.</b> A queue that counts may have a `const` member function `statistics()` that returns
a `CGAL::Approximate_geodesics::Bucket_statistics`. The statistics of the search then include the
comparisons in the queue.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Basic_adaptive_bucket_queue}
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

  /// a key and a node, in this order, as a structured binding gets them: for example
  /// `CGAL::Approximate_geodesics::Queue_entry`, or `std::pair<Key, Node>`.
  using Entry = unspecified_type;

  /// a range of entries, with `const` member functions `begin()`, `end()` and `size()`.
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
  /// becomes stale.
  /// \pre `key` is not a NaN, not negative, and not smaller than the smallest key of the last
  /// batch.
  void push(Node node, Key key);

  /// removes one or more entries, which may be stale, and returns them. The range stays valid until
  /// the next call of `extract_min()` or `clear()`, also when `push()` is called. It does not
  /// contain two entries of the same node and key. \pre `!is_empty()`
  Batch extract_min();

  /// removes all entries, and prepares for a new run, whose keys may be as small as zero. It is
  /// called before each run, including the first one; a queue that adapts to runs does so here.
  void clear();

  /// @}

  /// \name Access
  /// @{

  /// returns whether no entry is left, not even a stale one.
  bool is_empty() const;

  /// returns whether `key` is final: smaller than all keys in the queue, and than all that may
  /// still be pushed in this run. If a key is final, it remains so until `clear()` is called, and
  /// all smaller keys are final, too.
  bool is_final(Key key) const;

  /// calls `f(node)` for the node of every entry in the queue. It may do so more than once for a
  /// node, and also for nodes whose entries were extracted before.
  template <typename F>
  void for_each_node(F f) const;

  /// returns the number of bytes that the queue takes.
  std::size_t memory() const;

  /// @}

  /// \name Optional
  /// @{

  /// does what `extract_min()` does, and removes more entries, up to `largest_batch`, if there are
  /// more that may come in any order. Graphs that are searched by several threads get larger
  /// batches in this way. A queue without this member function works with them, too, but keeps
  /// threads less busy.
  Batch extract_round(std::size_t largest_batch);

  /// @}
};
