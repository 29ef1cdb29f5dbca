// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_RESUMABLE_BLOCKS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_RESUMABLE_BLOCKS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Matrix_identity.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/File_lock.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file_names.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_journal.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Tracks the completed blocks of a matrix file so that the computation can be resumed after any
 * process ends at any time: one journal per process lists the blocks that are on disk. When the
 * file is complete, it gets its name, and the auxiliary files are removed.
 *
 * `start()` and `finish()` are collective operations; their callbacks run in process 0.
 */
template <typename Team>
class Resumable_blocks
{
public:
  // A block number that marks all blocks as complete; the file is being finished.
  static constexpr std::uint64_t ALL = ~std::uint64_t(0);

  struct Journal
  {
    std::size_t rank;
    Matrix_journal::Contents contents;
  };
  using Journals = std::vector<Journal>;

  // The team is referred to, not copied.
  Resumable_blocks(std::string file, Team& team, const double seconds_between_commits)
    : m_names(std::move(file)), m_team(team), m_period(seconds_between_commits)
  {
  }

  const Matrix_file_names& names() const { return m_names; }

  // Finds the missing blocks. Calls `is_there(rank, record)` for each recorded block, unless
  // finishing changed the blocks, and then `prepare(rows)` with the number of missing rows.
  template <typename IsThere, typename Prepare>
  void start(const Matrix_identity& identity,
             const Distance_matrix_plan& plan,
             const bool are_changed_at_the_end,
             const IsThere& is_there,
             const Prepare& prepare)
  {
    m_plan = &plan;
    m_pending.clear(); // left by a failed computation
    std::vector<std::uint64_t> missing;
    on_first([&] {
      missing = find_missing(identity, are_changed_at_the_end, is_there);
      prepare(number_of_rows(missing));
    });
    m_team.share(missing);
    check_team(identity);
    m_missing = std::move(missing);
    m_rows_before = plan.number_of_rows() - number_of_rows(m_missing);
    m_rows_done = m_rows_before;
    m_team.restart_tickets();
    if(!m_missing.empty())
      m_journal =
          std::make_unique<Matrix_journal>(m_names.journal(m_team.rank()), identity,
                                           Matrix_journal::read(m_names.journal(m_team.rank())));
    m_last_commit = Clock::now();
    m_team.wait();
  }

  bool is_anything_missing() const { return !m_missing.empty(); }

  std::optional<std::size_t> next_block()
  {
    const std::uint64_t ticket = m_team.next_ticket();
    // Blocks with lower tickets are complete, or in progress elsewhere.
    if(m_team.size() > 1)
      m_rows_done = (std::min)(m_plan->number_of_rows(),
                               m_rows_before + std::size_t(ticket) * m_plan->rows_per_block());
    if(ticket >= m_missing.size())
      return std::nullopt;
    return static_cast<std::size_t>(m_missing[ticket]);
  }

  std::size_t number_of_rows_done() const { return m_rows_done; }

  // Records a written block. `sync()` flushes the data to disk before a record is committed.
  template <typename Sync>
  void note(const Block_record& record, const Sync& sync)
  {
    {
      const std::lock_guard lock(m_mutex);
      m_pending.push_back(record);
    }
    if(m_team.size() == 1)
      m_rows_done += m_plan->rows_of_block(record.block).size();
    const std::unique_lock lock(m_commit_mutex, std::try_to_lock); // held by a committing thread
    if(lock && Clock::now() - m_last_commit >= m_period)
      commit(sync);
  }

  // If all blocks are complete, calls `complete(journals)`, which assembles the file and returns
  // its temporary name. Returns whether the file is complete.
  template <typename Sync, typename Complete>
  bool finish(const Sync& sync, const Complete& complete)
  {
    commit(sync);
    m_journal.reset();
    m_team.wait();
    std::vector<std::uint64_t> is_complete{0};
    on_first([&] {
      is_complete[0] = m_was_complete || complete_file(complete);
      if(is_complete[0] != 0)
        remove_traces();
      m_lock.reset();
    });
    m_team.share(is_complete);
    return is_complete[0] != 0;
  }

  // Records in the journal of process 0 that all blocks are complete. This precedes any change to
  // the blocks and to the name of their file.
  void note_all()
  {
    const Matrix_journal::Contents contents = Matrix_journal::read(m_names.journal(0));
    if(!are_all_there({{0, contents}}))
      Matrix_journal(m_names.journal(0), m_identity, contents).append({Block_record{ALL, 0, 0, 0}});
  }

  // Whether a journal has that record.
  static bool are_all_there(const Journals& journals)
  {
    for(const Journal& journal : journals)
      for(const Block_record& record : journal.contents.records)
        if(record.block == ALL)
          return true;
    return false;
  }

private:
  using Clock = std::chrono::steady_clock;

  // Calls `f()` in process 0. If it throws there, all processes throw.
  template <typename F>
  void on_first(const F& f)
  {
    std::exception_ptr error;
    std::string message;
    if(m_team.rank() == 0)
      try
      {
        f();
      }
      catch(const std::exception& e)
      {
        error = std::current_exception();
        message = e.what();
        m_lock.reset(); // the computation has failed
      }
    m_team.share(message);
    if(error)
      std::rethrow_exception(error);
    if(!message.empty())
      throw std::runtime_error(message);
  }

  template <typename IsThere>
  std::vector<std::uint64_t> find_missing(const Matrix_identity& identity,
                                          const bool are_changed_at_the_end,
                                          const IsThere& is_there)
  {
    if(!std::filesystem::is_directory(m_names.folder()))
      reject("there is no folder " + m_names.folder());
    m_lock.reset(); // left by a failed computation
    m_lock = std::make_unique<File_lock>(m_names.lock(), m_names.file());
    m_identity = identity;
    Journals journals = read_journals();
    bool has_begun = false;
    for(const Journal& journal : journals)
      if(journal.contents.identity)
      {
        check_identity(m_names.journal(journal.rank), *journal.contents.identity);
        has_begun = true;
      }
    check_files(has_begun, are_all_there(journals));
    m_was_complete = is_file_there();
    if(m_was_complete || (are_all_there(journals) && are_changed_at_the_end))
      return {};
    for(Journal& journal : journals)
      drop_wrong_records(journal, is_there);
    return missing_blocks(journals);
  }

  // Removes the records of blocks that fail verification, so that `finish()` can trust the
  // journals.
  template <typename IsThere>
  void drop_wrong_records(Journal& journal, const IsThere& is_there) const
  {
    std::vector<Block_record>& records = journal.contents.records;
    const auto wrong =
        std::remove_if(records.begin(), records.end(), [&](const Block_record& record) {
          return record.block >= m_plan->number_of_blocks() || !is_there(journal.rank, record);
        });
    if(wrong == records.end())
      return;
    records.erase(wrong, records.end());
    Matrix_journal::replace(m_names.journal(journal.rank), m_identity, records);
  }

  void check_identity(const std::string& journal, const Matrix_identity& other) const
  {
    for(std::size_t part = 0; part < other.parts.size(); ++part)
      if(m_identity.parts[part] != other.parts[part])
        reject(journal + " belongs to a computation with " + other.difference(part, m_identity) +
               "; " + Matrix_journal::remedy());
  }

  void check_files(const bool has_begun, const bool are_all_there) const
  {
    if(!are_all_there) // an existing file is not the result of these journals
      check_is_not_there();
    if(has_begun)
      return;
    const Matrix_file_names::By_rank parts = m_names.parts();
    if(!parts.empty())
      reject(parts.begin()->second + " exists without a journal; " + Matrix_journal::remedy());
  }

  void check_is_not_there() const
  {
    if(is_file_there())
      reject(m_names.file() + " already exists; remove it, or choose another name");
  }

  std::vector<std::uint64_t> missing_blocks(const Journals& journals) const
  {
    std::vector<bool> is_done(m_plan->number_of_blocks(), are_all_there(journals));
    for(const Journal& journal : journals)
      for(const Block_record& record : journal.contents.records)
        if(record.block < is_done.size())
          is_done[record.block] = true;
    std::vector<std::uint64_t> result;
    for(std::size_t i = 0; i < is_done.size(); ++i)
      if(!is_done[i])
        result.push_back(i);
    return result;
  }

  // Checks that all processes have identical input; otherwise the result depends on scheduling.
  void check_team(const Matrix_identity& identity)
  {
    std::vector<std::uint64_t> first(identity.parts.begin(), identity.parts.end());
    m_team.share(first);
    for(std::size_t part = 0; part < first.size(); ++part)
      if(identity.parts[part] != first[part])
        reject("process 0 of the team has " + std::string(Matrix_identity::name(part)) +
               " than process " + std::to_string(m_team.rank()));
  }

  template <typename Sync>
  void commit(const Sync& sync)
  {
    std::vector<Block_record> records;
    {
      const std::lock_guard lock(m_mutex);
      records.swap(m_pending);
    }
    if(records.empty())
      return;
    sync();
    m_journal->append(records);
    m_last_commit = Clock::now();
  }

  template <typename Complete>
  bool complete_file(const Complete& complete)
  {
    const Journals journals = read_journals();
    if(!missing_blocks(journals).empty())
      return false;
    check_is_not_there(); // it may have been created meanwhile
    const std::string name = complete(journals);
    note_all();
    std::filesystem::rename(name, m_names.file());
    return true;
  }

  // Removes the journal of process 0 last: as long as it exists, it shows that the file is
  // complete.
  void remove_traces() const
  {
    for(const auto& [rank, file] : m_names.parts())
      std::filesystem::remove(file);
    const Matrix_file_names::By_rank journals = m_names.journals();
    for(auto journal = journals.rbegin(); journal != journals.rend(); ++journal)
    {
      std::filesystem::remove(Matrix_journal::replacement(journal->second));
      std::filesystem::remove(journal->second);
    }
  }

  Journals read_journals() const
  {
    Journals result;
    for(const auto& [rank, file] : m_names.journals())
      result.push_back({rank, Matrix_journal::read(file)});
    return result;
  }

  bool is_file_there() const { return std::filesystem::exists(m_names.file()); }

  std::size_t number_of_rows(const std::vector<std::uint64_t>& blocks) const
  {
    std::size_t result = 0;
    for(const std::uint64_t block : blocks)
      result += m_plan->rows_of_block(static_cast<std::size_t>(block)).size();
    return result;
  }

  Matrix_file_names m_names;
  Team& m_team;
  std::chrono::duration<double> m_period;
  const Distance_matrix_plan* m_plan = nullptr;
  Matrix_identity m_identity;        // process 0 only
  std::unique_ptr<File_lock> m_lock; // process 0 only
  bool m_was_complete = false;       // process 0 only: at start()
  std::vector<std::uint64_t> m_missing;
  std::size_t m_rows_before = 0;
  std::atomic<std::size_t> m_rows_done{0};

  std::mutex m_mutex;
  std::vector<Block_record> m_pending; // written, not yet in the journal
  std::mutex m_commit_mutex;
  std::unique_ptr<Matrix_journal> m_journal;
  Clock::time_point m_last_commit;
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_RESUMABLE_BLOCKS_H
