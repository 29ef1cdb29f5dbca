// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file.h>

#include "checks/expect_message.h"
#include "files/Temporary_folder.h"
#include "files/matrix_job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

// The part folder of an incomplete file is damaged: the file is right in the end, or there is an
// error that names what is damaged, and never a wrong file.

namespace {

using namespace geodesics_test;
using Contents = Temporary_folder::Contents;

class Damaged_file : public testing::TestWithParam<std::string>
{
protected:
  static constexpr std::size_t number_of_rows = 9; // and blocks
  const std::string part = "distances.part/", identity = part + "identity",
                    result = part + "result"; // a file if the matrix is dense

  const Matrix_job job{3};
  const Temporary_folder folder;
  const Matrix_file_job run{GetParam(), folder.file("distances")};
  Contents expected; // the complete file

  Damaged_file()
  {
    EXPECT_TRUE(run.compute(job));
    expected = folder.contents();
  }

  std::string marker(const std::size_t block) const { return part + std::to_string(block); }

  // What is there when so many rows are done.
  Contents contents_after(const std::size_t rows) const
  {
    Contents contents;
    folder.fill({});
    Matrix_watcher watcher([&](const std::size_t number_done) {
      if(number_done == rows)
        contents = folder.contents();
      return true;
    });
    EXPECT_TRUE(run.compute(job, watcher));
    contents.erase("distances.lock"); // goes with the program
    EXPECT_EQ(contents.size(), 2 + rows);
    return contents;
  }

  // The part folder without `result`, which was moved.
  Contents contents_after_move() const
  {
    Contents contents = contents_after(number_of_rows);
    contents.erase(is_dense() ? result : result + '/');
    contents.insert(expected.begin(), expected.end());
    return contents;
  }

  // Returns the number of rows that were computed.
  std::size_t expect_right_file(const Contents& contents) const
  {
    folder.fill(contents);
    Matrix_watcher watcher;
    EXPECT_TRUE(run.compute(job, watcher));
    EXPECT_TRUE(folder.contents() == expected);
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

  // `contents` with other bytes in place of all data
  Contents with_other_data(Contents contents, const char byte = 'x') const
  {
    for(auto& [name, bytes] : contents)
      if(name != identity)
        bytes.assign(bytes.size(), byte);
    return contents;
  }

  bool is_dense() const { return GetParam() == "npy" || GetParam() == "symmetric"; }
};

INSTANTIATE_TEST_SUITE_P(, Damaged_file, testing::ValuesIn(kinds_of_matrix_files()));

// All of its numbers are zero, or some digits are missing.
TEST_P(Damaged_file, has_an_identity_that_ends_anywhere)
{
  const Contents contents = contents_after(4);
  for(std::size_t length = 0; length < contents.at(identity).size(); ++length)
    expect_error(shortened(contents, identity, length), "delete " + folder.file("distances.part"));
  Contents without = contents;
  without.erase(identity);
  expect_error(without, folder.file("distances.part") + " exists, but is not an unfinished");
}

TEST_P(Damaged_file, has_an_identity_with_a_wrong_bit)
{
  const Contents contents = contents_after(4);
  for(std::size_t at = 0; at < contents.at(identity).size(); ++at)
    expect_error(flipped(contents, identity, at), "delete " + folder.file("distances.part"));
}

TEST_P(Damaged_file, has_an_identity_with_something_behind_it)
{
  const auto append = [](std::string& bytes) { bytes += '\n'; };
  expect_error(changed(contents_after(4), identity, append),
               folder.file(identity) + " is damaged; delete ");
}

TEST_P(Damaged_file, is_of_another_version)
{
  const auto change = [](std::string& bytes) { bytes[bytes.find('\n') - 1] = '7'; };
  expect_error(changed(contents_after(4), identity, change),
               folder.file(identity) + " was not written by this version of the program; delete ");
}

TEST_P(Damaged_file, has_markers_of_blocks_that_do_not_exist)
{
  for(const char* const name : {"9", "1099511627776", "99999999999999999999999", "x", "-1", "04"})
  {
    Contents contents = contents_after(4);
    contents[part + name] = contents.at(marker(0));
    EXPECT_EQ(expect_right_file(contents), number_of_rows - 4);
  }
}

// A marker that is sound by itself, of a block that is not there.
TEST_P(Damaged_file, has_markers_that_are_not_true)
{
  for(const std::size_t block : {3u, 5u})
  {
    Contents contents = contents_after(4);
    contents[marker(block)] = contents.at(marker(0));
    EXPECT_EQ(expect_right_file(contents), number_of_rows - (block == 3 ? 3 : 4));
  }
}

TEST_P(Damaged_file, has_a_marker_with_a_wrong_bit)
{
  const Contents contents = contents_after(4);
  for(std::size_t at = 0; at < contents.at(marker(2)).size(); ++at)
    EXPECT_EQ(expect_right_file(flipped(contents, marker(2), at)), number_of_rows - 3);
}

TEST_P(Damaged_file, has_a_marker_that_ends_anywhere)
{
  const Contents contents = contents_after(4);
  for(std::size_t length = 0; length < contents.at(marker(2)).size(); ++length)
  {
    EXPECT_EQ(expect_right_file(shortened(contents, marker(2), length)), number_of_rows - 3);
    // as a crash leaves a file whose length has reached the disk, and whose data has not
    const auto fill = [&](std::string& bytes) {
      std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(length), bytes.end(), '\0');
    };
    const Contents filled = changed(contents, marker(2), fill);
    EXPECT_EQ(expect_right_file(filled), number_of_rows - (filled == contents ? 4 : 3));
  }
}

// One block is not as its marker says.
TEST_P(Damaged_file, has_data_with_a_wrong_bit)
{
  if(!is_dense())
    GTEST_SKIP() << "its data is in the markers";
  for(const std::size_t rows : {number_of_rows - 2, number_of_rows})
  {
    const Contents contents = contents_after(rows);
    for(std::size_t at = 0; at < contents.at(result).size(); at += 11)
      EXPECT_LE(expect_right_file(flipped(contents, result, at)), number_of_rows - rows + 1);
  }
}

TEST_P(Damaged_file, has_data_that_end_anywhere)
{
  if(!is_dense())
    GTEST_SKIP() << "its data is in the markers";
  for(const std::size_t rows : {number_of_rows - 2, number_of_rows})
  {
    const Contents contents = contents_after(rows);
    std::size_t fewest = number_of_rows;
    for(std::size_t length = 0; length < contents.at(result).size(); length += 11)
      fewest = std::min(fewest, expect_right_file(shortened(contents, result, length)));
    EXPECT_LE(fewest, number_of_rows - rows + 1);
    const auto append = [](std::string& bytes) { bytes += "something"; };
    EXPECT_EQ(expect_right_file(changed(contents, result, append)), number_of_rows - rows);
  }
}

TEST_P(Damaged_file, has_other_data)
{
  Contents contents = contents_after(number_of_rows);
  EXPECT_EQ(expect_right_file(with_other_data(contents)), number_of_rows);
  EXPECT_EQ(expect_right_file(with_other_data(contents, '\0')), number_of_rows); // after a crash
  contents.erase(is_dense() ? result : result + '/');
  EXPECT_EQ(expect_right_file(contents), is_dense() ? number_of_rows : 0);
}

// and the run that sees it is ended before it has computed all of that again
TEST_P(Damaged_file, is_not_complete_before_all_is_right)
{
  folder.fill(with_other_data(contents_after(number_of_rows)));
  for(std::size_t rows = 1; rows < number_of_rows; ++rows)
  {
    Matrix_watcher watcher = that_stops_at(rows);
    EXPECT_FALSE(run.compute(job, watcher));
    EXPECT_EQ(watcher.numbers_done.size(), 1u);
    EXPECT_FALSE(folder.has("distances"));
  }
  EXPECT_EQ(expect_right_file(folder.contents()), 1u);
}

// The new file is there, and the folder is not yet gone, whatever is left in it.
TEST_P(Damaged_file, has_traces_beside_it)
{
  Contents contents = contents_after_move();
  for(std::size_t block = 0; block < number_of_rows; ++block)
  {
    EXPECT_EQ(expect_right_file(contents), 0u);
    contents.erase(marker(block));
  }
  EXPECT_EQ(expect_right_file(contents), 0u);
  contents.erase(identity);
  contents["distances.part/"];
  folder.fill(contents);
  expect_message<std::invalid_argument>([&] { run.compute(job); },
                                        folder.file("distances") + " already exists");
  EXPECT_TRUE(folder.contents() == expected);
}

TEST_P(Damaged_file, is_not_taken_for_that_of_another_job)
{
  folder.fill(contents_after_move());
  expect_message<std::invalid_argument>([&] { run.compute(Matrix_job(3, 6)); },
                                        " belongs to a computation with another mesh");
}

// It was killed before the part folder was complete.
TEST_P(Damaged_file, has_just_begun)
{
  const std::string fresh = identity + ".new", complete = contents_after(1).at(identity);
  EXPECT_EQ(expect_right_file({{part, ""}}), number_of_rows);
  EXPECT_EQ(expect_right_file({{fresh, "Unf"}}), number_of_rows);
  EXPECT_EQ(expect_right_file({{fresh, complete}}), number_of_rows);
  EXPECT_EQ(expect_right_file({{fresh, complete}, {is_dense() ? result : result + '/', ""}}),
            number_of_rows);
}

// Somebody puts a file of that name there while the work is interrupted.
TEST_P(Damaged_file, is_not_taken_for_another_file)
{
  Contents contents = contents_after(number_of_rows - 2);
  contents["distances"] = "of somebody";
  expect_error(contents, folder.file("distances") + " already exists");
}

// while it is computed, so that it cannot be completed
TEST_P(Damaged_file, does_not_replace_another_file)
{
  folder.fill({});
  Matrix_watcher watcher([&](const std::size_t number_done) {
    if(number_done == number_of_rows)
      std::filesystem::copy(folder.file("distances.part/identity"), folder.file("distances"));
    return true;
  });
  expect_message<std::invalid_argument>([&] { run.compute(job, watcher); },
                                        folder.file("distances") + " already exists");
  const std::string other = folder.bytes("distances");
  EXPECT_EQ(other, folder.bytes(identity));
  expect_error(folder.contents(), folder.file("distances") + " already exists");
  std::filesystem::remove(folder.file("distances"));
  EXPECT_EQ(expect_right_file(folder.contents()), 0u);
}

TEST_P(Damaged_file, has_arrays_that_end_anywhere)
{
  if(is_dense())
    GTEST_SKIP() << "such files are not assembled";
  Contents contents = contents_after(number_of_rows);
  contents.erase(result + '/');
  for(const char* const name : {"/data.npy", "/indices.npy", "/indptr.npy", "/shape.npy"})
  {
    const std::string bytes = expected.at(std::string("distances") + name);
    for(std::size_t length = 0; length <= bytes.size() + 12; length += 12)
    {
      contents[result + name] =
          bytes.substr(0, length) + std::string(length - std::min(length, bytes.size()), 'x');
      EXPECT_EQ(expect_right_file(contents), 0u);
    }
  }
}

// Distances were being made symmetric: some are so already.
TEST_P(Damaged_file, is_symmetric_in_part)
{
  if(GetParam() != "symmetric")
    GTEST_SKIP() << "it is not to be";
  Contents contents = contents_after(number_of_rows);
  contents[part + "symmetric"];
  const std::string complete = expected.at("distances");
  for(std::size_t length = 0; length <= complete.size(); length += 12)
  {
    const auto replace = [&](std::string& bytes) {
      bytes.replace(0, length, complete.substr(0, length));
    };
    EXPECT_EQ(expect_right_file(changed(contents, result, replace)), 0u);
    if(length < complete.size())
      expect_error(shortened(contents, result, length),
                   folder.file(result) + " is missing or has the wrong length; delete ");
  }
  contents.erase(result);
  expect_error(contents, folder.file(result) + " is missing or has the wrong length; delete ");
}

} // namespace
