/*!
\ingroup PkgGeodesicQueriesConcepts
\cgalConcept

The concept `DistanceRowSink` describes where the rows of a distance matrix go. It is the second
argument of `CGAL::approximate_geodesic_distance_matrix()`.

Rows come in blocks, of which each thread computes one at a time. For each row, the thread calls
`collect()`; after the last row of a block, it calls `add()`. Several threads make these calls at
the same time, each with a block of its own. `start()` is called before all of them, and `finish()`
after all of them, but not if an exception ends the computation.

Where less is needed, a function object can take its place, which gets one row after the other.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Dense_rows}
\cgalHasModels{CGAL::Approximate_geodesics::Radius_rows}
\cgalHasModels{CGAL::Approximate_geodesics::Nearest_rows}
\cgalHasModels{CGAL::Approximate_geodesics::Npy_file}
\cgalHasModels{CGAL::Approximate_geodesics::Csr_file}
\cgalHasModelsEnd
*/
class DistanceRowSink
{
public:
  /// what a thread stores of a block of rows until it is complete. Default constructible.
  using Block = unspecified_type;

  /// prepares for a matrix. \param plan its size and its blocks. It stays where it is until
  /// `finish()`.
  void start(const CGAL::Approximate_geodesics::Distance_matrix_plan& plan);

  /*!
  receives a row.

  \param block the block of the thread
  \param row the number of the row
  \param distances the distances; they are gone when the function returns
  */
  void collect(Block& block,
               std::size_t row,
               const CGAL::Approximate_geodesics::Distance_row& distances);

  /*!
  receives a block, all rows of which were collected, and clears it for the next one.

  \param number the number of the block in the plan
  \param block the block
  */
  void add(std::size_t number, Block& block);

  /*!
  completes the matrix.

  \param is_done whether this process was not stopped by a visitor. If it is the only one, all
  blocks were added then.

  \return whether the matrix is complete
  */
  bool finish(bool is_done);

  /// \name Optional Members
  /// @{

  /// whether the sink makes the matrix symmetric in `finish()` if the plan says so.
  static constexpr bool can_be_symmetric = true;

  /// returns the number of nearest columns to keep of each row, or `0` for all columns. A search
  /// ends when it has found them.
  std::size_t number_of_nearest() const;

  /// returns the next block to compute, if there is one: for a sink that has some blocks already,
  /// or shares them with other processes. Without this function, all blocks are computed.
  std::optional<std::size_t> next_block();

  /// returns the number of rows that are done, if `next_block()` is there.
  std::size_t number_of_rows_done() const;

  /// @}
};
