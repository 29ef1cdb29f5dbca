// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_journal.h>

#include "checks/expect_message.h"
#include "files/Temporary_folder.h"
#include "files/matrix_job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

// What is beside an incomplete file is damaged: the file is right in the end, or there is an error
// that names what is damaged, and never a wrong file.

namespace {

using namespace geodesics_test;
using Journal = AG::internal::Matrix_journal;
using AG::internal::Block_record;
using Contents = Temporary_folder::Contents;

class Damaged_file : public testing::TestWithParam<std::string>
{
protected:
  static constexpr std::size_t number_of_rows = 9;
  static constexpr const char *file = "distances", *part = "distances.part",
                              *journal = "distances.journal";

  const Matrix_job job{3};
  const Temporary_folder folder;
  const Matrix_file_job run{GetParam(), folder.file(file), 1, 1e9};
  std::string expected; // the complete file

  Damaged_file()
  {
    EXPECT_TRUE(run.compute(job));
    expected = folder.bytes(file);
  }

  // What is there when so many rows are done.
  Contents contents_after(const std::size_t rows) const
  {
    Contents result;
    folder.fill({});
    Matrix_file_job with_commits = run;
    with_commits.seconds_between_commits = 0;
    Matrix_watcher watcher([&](const std::size_t number_done) {
      if(number_done == rows)
        result = folder.contents();
      return true;
    });
    EXPECT_TRUE(with_commits.compute(job, watcher));
    result.erase("distances.lock"); // goes with the program
    EXPECT_EQ(result.size(), 2u);
    return result;
  }

  // Returns the number of rows that were computed.
  std::size_t expect_right_file(const Contents& contents) const
  {
    folder.fill(contents);
    Matrix_watcher watcher;
    EXPECT_TRUE(run.compute(job, watcher));
    const Contents found = folder.contents();
    EXPECT_EQ(found.size(), 1u);
    EXPECT_TRUE(found.at(file) == expected);
    return watcher.numbers_done.size();
  }

  void expect_error(const Contents& contents, const std::string& message) const
  {
    folder.fill(contents);
    expect_message<std::invalid_argument>([&] { run.compute(job); }, message);
    EXPECT_TRUE(folder.contents() == contents);
  }

  // `contents` with one file changed
  template <typename F>
  static Contents changed(Contents contents, const std::string& name, const F& change)
  {
    change(contents.at(name));
    return contents;
  }

  static Contents flipped(const Contents& contents, const std::string& name, const std::size_t at)
  {
    return changed(contents, name, [&](std::string& bytes) {
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << at % 8));
    });
  }

  static Contents shortened(const Contents& contents, const std::string& name, const std::size_t to)
  {
    return changed(contents, name, [&](std::string& bytes) { bytes.resize(to); });
  }

  // `contents` with another record in the journal
  Contents with_record(const Contents& contents, const Block_record& record) const
  {
    folder.fill(contents);
    const std::string name = folder.file(journal);
    const Journal::Contents read = Journal::read(name);
    Journal(name, *read.identity, read).append({record});
    return folder.contents();
  }

  // The journal says that the work is being finished.
  Contents with_all_noted(const Contents& contents) const
  {
    return with_record(contents, {~std::uint64_t(0), 0, 0, 0});
  }

  bool is_dense() const { return GetParam() == "npy" || GetParam() == "symmetric"; }
};

INSTANTIATE_TEST_SUITE_P(, Damaged_file, testing::ValuesIn(kinds_of_matrix_files()));

TEST_P(Damaged_file, has_a_journal_that_ends_anywhere)
{
  const Contents contents = contents_after(number_of_rows - 2);
  const std::size_t size = contents.at(journal).size();
  ASSERT_EQ(size, Journal::LENGTH_OF_HEADER + (number_of_rows - 2) * Journal::LENGTH_OF_RECORD);
  for(std::size_t length = 0; length < size; ++length)
  {
    const Contents damaged = shortened(contents, journal, length);
    if(length < Journal::LENGTH_OF_HEADER)
      expect_error(damaged, folder.file(part) + " exists without a journal");
    else
      EXPECT_EQ(expect_right_file(damaged),
                number_of_rows - (length - Journal::LENGTH_OF_HEADER) / Journal::LENGTH_OF_RECORD);
  }
}

// as they are before the first row
TEST_P(Damaged_file, has_a_journal_that_has_just_begun)
{
  const Contents contents = contents_after(1);
  for(std::size_t length = 0; length <= Journal::LENGTH_OF_HEADER; ++length)
    EXPECT_EQ(expect_right_file({{journal, contents.at(journal).substr(0, length)}}),
              number_of_rows);
}

TEST_P(Damaged_file, has_a_journal_with_a_wrong_bit)
{
  const Contents contents = contents_after(number_of_rows - 2);
  for(std::size_t at = 0; at < contents.at(journal).size(); ++at)
    expect_error(flipped(contents, journal, at), folder.file(journal));
}

TEST_P(Damaged_file, has_a_journal_with_zeros_behind_it)
{
  const Contents contents = contents_after(4);
  for(const std::size_t number : {1u, 35u, 36u, 37u, 5000u})
  {
    const auto append = [&](std::string& bytes) { bytes.append(number, '\0'); };
    EXPECT_EQ(expect_right_file(changed(contents, journal, append)), number_of_rows - 4);
  }
}

TEST_P(Damaged_file, has_a_journal_with_something_else_behind_it)
{
  const Contents contents = contents_after(4);
  const auto append = [](std::string& bytes) { bytes.append(36, 'x'); };
  expect_error(changed(contents, journal, append), folder.file(journal) + " is damaged at byte " +
                                                       std::to_string(contents.at(journal).size()));
}

TEST_P(Damaged_file, has_a_journal_of_another_version)
{
  const auto change = [](std::string& bytes) { bytes[8] = 7; };
  expect_error(changed(contents_after(4), journal, change),
               folder.file(journal) + " has version 7; this program reads version 2");
}

TEST_P(Damaged_file, has_a_journal_that_is_none)
{
  const auto change = [](std::string& bytes) { bytes.assign(200, 'x'); };
  expect_error(changed(contents_after(4), journal, change),
               folder.file(journal) + " is not the journal of a distance matrix");
}

TEST_P(Damaged_file, has_records_of_blocks_that_do_not_exist)
{
  for(const std::uint64_t block : {std::uint64_t(number_of_rows), std::uint64_t(1) << 40})
  {
    const Contents contents = with_record(contents_after(4), {block, 0, 4, 0});
    EXPECT_EQ(expect_right_file(contents), number_of_rows - 4);
  }
}

// A record that is sound by itself, of a block that is not there, whichever record comes first.
TEST_P(Damaged_file, has_records_that_are_not_true)
{
  for(const std::uint64_t block : {0u, 5u})
  {
    const Contents contents = with_record(contents_after(4), {block, 0, 40, 1});
    EXPECT_EQ(expect_right_file(contents), number_of_rows - 4);
  }
}

// One block is not as its record says.
TEST_P(Damaged_file, has_data_with_a_wrong_bit)
{
  for(const std::size_t rows : {number_of_rows - 2, number_of_rows})
  {
    const Contents contents = contents_after(rows);
    for(std::size_t at = 0; at < contents.at(part).size(); at += 11)
      EXPECT_LE(expect_right_file(flipped(contents, part, at)), number_of_rows - rows + 1);
  }
}

TEST_P(Damaged_file, has_data_that_end_anywhere)
{
  for(const std::size_t rows : {number_of_rows - 2, number_of_rows})
  {
    const Contents contents = contents_after(rows);
    std::size_t fewest = number_of_rows;
    for(std::size_t length = 0; length < contents.at(part).size(); length += 11)
      fewest = std::min(fewest, expect_right_file(shortened(contents, part, length)));
    EXPECT_LE(fewest, number_of_rows - rows + 1);
  }
}

TEST_P(Damaged_file, has_other_data)
{
  Contents contents = contents_after(number_of_rows);
  const auto fill = [](std::string& bytes) { bytes.assign(bytes.size(), 'x'); };
  EXPECT_EQ(expect_right_file(changed(contents, part, fill)), number_of_rows);
  contents.erase(part);
  EXPECT_EQ(expect_right_file(contents), number_of_rows);
}

// and the run that sees it is ended before it has computed all of that again
TEST_P(Damaged_file, is_not_complete_before_all_is_right)
{
  folder.fill(changed(contents_after(number_of_rows), part,
                      [](std::string& bytes) { bytes.assign(bytes.size(), 'x'); }));
  for(std::size_t rows = 1; rows < number_of_rows; ++rows)
  {
    Matrix_watcher watcher = that_stops_at(rows);
    EXPECT_FALSE(run.compute(job, watcher));
    EXPECT_EQ(watcher.numbers_done.size(), 1u);
    EXPECT_FALSE(folder.has(file));
  }
  EXPECT_EQ(expect_right_file(folder.contents()), 1u);
}

// What another process has done is damaged, and this one does it again.
TEST_P(Damaged_file, has_a_journal_of_another_process)
{
  Contents contents = contents_after(4);
  contents["distances.journal.3"] = contents.at(journal);
  contents.erase(journal);
  if(!is_dense())
  {
    contents["distances.part.3"] = contents.at(part);
    contents.erase(part);
  }
  const std::string part_3 = is_dense() ? part : "distances.part.3";
  EXPECT_EQ(expect_right_file(contents), number_of_rows - 4);
  for(std::size_t at = 0; at < contents.at(part_3).size(); at += 11)
    EXPECT_LE(expect_right_file(flipped(contents, part_3, at)), number_of_rows - 4 + 1);
  contents[part_3].clear();
  EXPECT_EQ(expect_right_file(contents), number_of_rows);
}

// The new file is there, and what was beside it is not yet gone.
TEST_P(Damaged_file, has_traces_beside_it)
{
  Contents contents = with_all_noted(contents_after(number_of_rows));
  contents[file] = expected;
  EXPECT_EQ(expect_right_file(contents), 0u);
  contents.erase(part);
  EXPECT_EQ(expect_right_file(contents), 0u);
  contents["distances.journal.2"] = contents.at(journal);
  contents.erase(journal);
  EXPECT_EQ(expect_right_file(contents), 0u);
}

// Somebody puts a file of that name there while the work is interrupted.
TEST_P(Damaged_file, is_not_taken_for_another_file)
{
  Contents contents = contents_after(number_of_rows - 2);
  contents[file] = "of somebody";
  expect_error(contents, folder.file(file) + " already exists");
}

TEST_P(Damaged_file, has_a_copy_that_ends_anywhere)
{
  if(is_dense())
    GTEST_SKIP() << "such files have no copy";
  Contents contents = contents_after(number_of_rows);
  for(std::size_t length = 0; length <= expected.size(); length += 12)
  {
    contents["distances.new"] = expected.substr(0, length);
    EXPECT_EQ(expect_right_file(contents), 0u);
  }
}

// Distances were being made symmetric: some are so already.
TEST_P(Damaged_file, is_symmetric_in_part)
{
  if(GetParam() != "symmetric")
    GTEST_SKIP() << "it is not to be";
  const Contents contents = with_all_noted(contents_after(number_of_rows));
  for(std::size_t length = 0; length <= expected.size(); length += 12)
  {
    const auto replace = [&](std::string& bytes) {
      bytes.replace(0, length, expected.substr(0, length));
    };
    EXPECT_EQ(expect_right_file(changed(contents, part, replace)), 0u);
    if(length < expected.size())
      expect_error(shortened(contents, part, length),
                   folder.file(part) + " is missing or has the wrong length");
  }
  Contents without_data = contents;
  without_data.erase(part);
  expect_error(without_data, folder.file(part) + " is missing or has the wrong length");
}

} // namespace
