/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `ProcessTeam` describes processes that compute a file of distances together, on one
machine or on several that share a file system. Each of them makes the same calls.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Single_process}
\cgalHasModels{CGAL::Approximate_geodesics::Mpi_team}
\cgalHasModelsEnd
*/
class ProcessTeam
{
public:
  /// a file that all processes have open, and write to at different places. It is made from its
  /// name, and has member functions `void write(std::uint64_t offset, const void* data, std::size_t
  /// size)`, `void resize(std::uint64_t size)`, and `void sync()`, which returns when what this
  /// process has written is on the disk. They throw `std::runtime_error` if they cannot do so.
  using File = unspecified_type;

  /// returns the number of this process, counted from 0.
  std::size_t rank() const;

  /// returns the number of processes.
  std::size_t size() const;

  /// waits until all processes have called this function.
  void wait();

  /// replaces the values by those of process 0.
  void share(std::vector<std::uint64_t>& values);

  /// replaces the text by that of process 0.
  void share(std::string& text);

  /// deals out tickets from 0 again, once all processes have called this function.
  void restart_tickets();

  /// returns the number of the next ticket, which no other thread and no other process gets.
  std::uint64_t next_ticket();
};
