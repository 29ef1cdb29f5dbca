// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/Child_process.h"
#include "files/Temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <string>
#include <vector>

// Several processes compute a file together. Their programs have MPI, and this one has not.

namespace {

using namespace geodesics_test;

const std::vector<std::string> all_kinds{"npy", "symmetric", "csr", "nearest"};

// Processes that compute a file of a kind.
class Team_of_processes
{
public:
  const Temporary_folder folder;

  explicit Team_of_processes(const std::string& kind) : m_kind(kind)
  {
    const Temporary_folder another; // for one process without MPI
    EXPECT_TRUE(runs({APPROXIMATE_GEODESICS_TEST_MATRIX_PROGRAM}, another, {})) << message();
    m_expected = another.contents();
    EXPECT_FALSE(m_expected.empty());
  }

  // Returns whether the program succeeds with so many processes.
  bool computes(const int number_of_processes, const std::vector<std::string>& arguments = {}) const
  {
    return runs({APPROXIMATE_GEODESICS_TEST_MPIEXEC, "-n", std::to_string(number_of_processes),
                 APPROXIMATE_GEODESICS_TEST_MPI_PROGRAM},
                folder, arguments);
  }

  std::string message() const { return m_output.bytes("printed"); }

  void expect_message(const std::string& text) const
  {
    EXPECT_NE(message().find(text), std::string::npos) << message();
  }

  void expect_complete() const { EXPECT_TRUE(folder.contents() == m_expected); }

  std::size_t number_of_markers() const
  {
    std::size_t result = 0;
    for(std::size_t block = 0; block < 144; ++block)
      result += folder.has("distances.part/" + std::to_string(block));
    return result;
  }

private:
  bool runs(std::vector<std::string> words,
            const Temporary_folder& to,
            const std::vector<std::string>& arguments) const
  {
    words.insert(words.end(),
                 {"file=" + to.file("distances"), "kind=" + m_kind, "side=12", "radius=6"});
    words.insert(words.end(), arguments.begin(), arguments.end());
    return Child_process(words, m_output.file("printed")).succeeds();
  }

  Temporary_folder m_output;
  std::string m_kind;
  Temporary_folder::Contents m_expected;
};

void expect_file_by(const int number_of_processes, const std::vector<std::string>& arguments = {})
{
  for(const std::string& kind : all_kinds)
  {
    const Team_of_processes team(kind);
    EXPECT_TRUE(team.computes(number_of_processes, arguments)) << team.message();
    team.expect_complete();
  }
}

TEST(Team_of_one, computes_the_file_of_one_process) { expect_file_by(1); }

TEST(Team_of_two, computes_the_file_of_one_process) { expect_file_by(2); }

TEST(Team_of_two, may_have_threads) { expect_file_by(2, {"threads=2"}); }

TEST(Team_of_three, computes_the_file_of_one_process) { expect_file_by(3); }

// A process of three is killed, and then any number of them goes on.
void expect_rows_kept(const std::string& kind, const int killed, const int number_of_processes)
{
  const Team_of_processes team(kind);
  EXPECT_FALSE(team.computes(3, {"signal=" + std::to_string(SIGKILL), "rows=60", "pause=0.1",
                                 "process=" + std::to_string(killed)}));
  EXPECT_FALSE(team.folder.has("distances"));
  EXPECT_GE(team.number_of_markers(), 60u - 3); // but for those that others are at
  EXPECT_LT(team.number_of_markers(), 144u);
  EXPECT_TRUE(team.computes(number_of_processes)) << team.message();
  team.expect_complete();
}

TEST(Team_of_three, keeps_rows_if_one_of_them_is_killed) { expect_rows_kept("csr", 1, 2); }

TEST(Team_of_three, keeps_rows_if_any_of_them_is_killed)
{
  for(const std::string& kind : all_kinds)
    for(const int number_of_processes : {1, 2, 4})
      for(const int killed : {0, 2})
        expect_rows_kept(kind, killed, number_of_processes);
}

TEST(Team_of_three, is_told_of_errors_of_the_first_one)
{
  const Team_of_processes team("npy");
  EXPECT_TRUE(team.computes(3)) << team.message();
  EXPECT_FALSE(team.computes(3, {"abort=0"})); // all of them end by themselves
  const std::string text = team.folder.file("distances") + " already exists; remove it";
  const std::string message = team.message();
  std::size_t number = 0;
  for(std::size_t at = message.find(text); at != std::string::npos; at = message.find(text, at + 1))
    ++number;
  EXPECT_EQ(number, 3u) << message;
  team.expect_complete();
}

TEST(Team_of_two, has_one_mesh)
{
  const Team_of_processes team("csr");
  EXPECT_FALSE(team.computes(2, {"seed.1=6"}));
  team.expect_message("process 0 of the team has another mesh, or other lengths, weights or "
                      "barriers than process 1");
  EXPECT_TRUE(team.computes(2)) << team.message();
  team.expect_complete();
}

} // namespace
