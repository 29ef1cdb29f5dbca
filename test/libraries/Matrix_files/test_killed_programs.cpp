// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file.h>

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "files/Temporary_folder.h"
#include "files/matrix_job.h"

#include <gtest/gtest.h>

#ifdef APPROXIMATE_GEODESICS_TEST_MATRIX_PROGRAM

#include "../../../libraries/matrix_files/src/files.h"
#include "files/Child_process.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

// Programs that are killed, and two of them at the same time.

namespace {

using namespace geodesics_test;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// the words that run compute_matrix_file
template <typename... Arguments>
std::vector<std::string>
program(const Temporary_folder& folder, const std::string& kind, const Arguments&... arguments)
{
  return {APPROXIMATE_GEODESICS_TEST_MATRIX_PROGRAM, "file=" + folder.file("distances"),
          "kind=" + kind, arguments...};
}

// How far a program has come, as its files tell.
enum Phase
{
  BEFORE,
  COMPUTING,
  BETWEEN, // all blocks are marked
  FINISHING,
  REMOVING,
  AFTER,
  NUMBER_OF_PHASES
};

std::size_t number_of_markers(const std::string& part)
{
  std::size_t result = 0;
  std::error_code ignored; // it was there a moment ago
  for(std::filesystem::directory_iterator i(part, ignored), end; !ignored && i != end;
      i.increment(ignored))
    result += i->path().filename().string().find_first_not_of("0123456789") == std::string::npos;
  return result;
}

Phase phase(const Temporary_folder& folder, const std::size_t number_of_blocks)
{
  const bool has_part = folder.has("distances.part/identity");
  if(folder.has("distances"))
    return has_part ? REMOVING : AFTER;
  if(!has_part)
    return BEFORE;
  if(folder.has("distances.part/symmetric") || folder.has("distances.part/result/data.npy"))
    return FINISHING;
  const std::size_t number = number_of_markers(folder.file("distances.part"));
  return number == number_of_blocks ? BETWEEN : COMPUTING;
}

/*
 * Lets programs compute a file, and kills them at random: after some time, or when a phase has
 * begun.
 */
class Killer
{
public:
  Killer(const std::string& kind, const std::size_t side) : m_kind(kind), m_side(side)
  {
    const Clock::time_point start = Clock::now();
    EXPECT_TRUE(Child_process(words("1")).succeeds());
    m_duration = Clock::now() - start;
    m_expected = m_folder.contents();
    EXPECT_FALSE(m_expected.empty());
    m_folder.fill({});
  }

  void kill(const std::size_t times)
  {
    for(std::size_t number = 0; number < times;)
    {
      Child_process child(words(std::to_string(1 + m_random.below(3))));
      await(child);
      if(child.kill())
      {
        ++number;
        ++m_hits[phase(m_folder, number_of_blocks())];
      }
      if(m_folder.has("distances")) // with traces or without
        complete();
    }
    complete();
  }

  ~Killer()
  {
    std::cout << m_kind << ", kills by phase:";
    for(const std::size_t hits : m_hits)
      std::cout << ' ' << hits;
    std::cout << std::endl;
  }

private:
  std::vector<std::string> words(const std::string& threads) const
  {
    return program(m_folder, m_kind, "side=" + std::to_string(m_side), "threads=" + threads);
  }

  std::size_t number_of_blocks() const
  {
    const std::size_t rows = m_side * m_side;
    return AG::Distance_matrix_plan(std::vector<std::size_t>(rows), rows).number_of_blocks();
  }

  void await(Child_process& child)
  {
    const auto wanted = m_random.below(NUMBER_OF_PHASES);
    if(m_random.below(2) == 0)
      std::this_thread::sleep_for(m_duration * m_random.between(0, 1));
    else
      while(!child.has_ended() && phase(m_folder, number_of_blocks()) < wanted)
        std::this_thread::yield();
  }

  // and begins anew
  void complete()
  {
    if(!m_folder.has("distances") || m_folder.has("distances.part/identity"))
    {
      EXPECT_TRUE(Child_process(words("2")).succeeds());
    }
    Temporary_folder::Contents contents = m_folder.contents();
    contents.erase("distances.lock"); // stays if that comes last
    contents.erase("distances.part/");
    EXPECT_TRUE(contents == m_expected);
    m_folder.fill({});
  }

  const Temporary_folder m_folder{std::filesystem::temp_directory_path()}; // of a true disk
  std::string m_kind;
  std::size_t m_side;
  Random m_random{test_seed()};
  Temporary_folder::Contents m_expected;
  Seconds m_duration;
  std::size_t m_hits[NUMBER_OF_PHASES] = {};
};

TEST(Killed_program, is_gone_on_with)
{
  for(const std::string& kind : kinds_of_matrix_files())
    Killer(kind, 24).kill(5);
}

TEST(Killed_program, is_gone_on_with_many_times)
{
  for(const std::string& kind : kinds_of_matrix_files())
    Killer(kind, 40).kill(50);
}

// those marked before it was killed
TEST(Killed_program, has_its_rows_kept)
{
  for(const std::string& kind : kinds_of_matrix_files())
  {
    const Temporary_folder folder;
    Child_process child(
        program(folder, kind, "side=8", "signal=" + std::to_string(SIGKILL), "rows=40"));
    EXPECT_TRUE(child.was_killed());
    const Matrix_job job(8);
    Matrix_watcher watcher;
    EXPECT_TRUE((Matrix_file_job{kind, folder.file("distances")}).compute(job, watcher));
    EXPECT_EQ(watcher.numbers_done.front(), 41u);
    EXPECT_FALSE(folder.has("distances.part"));
  }
}

TEST(Two_programs, do_not_compute_a_file_at_the_same_time)
{
  const Matrix_job job(8);
  for(const std::string& kind : kinds_of_matrix_files())
  {
    const Temporary_folder folder;
    Child_process child(
        program(folder, kind, "side=8", "signal=" + std::to_string(SIGSTOP), "rows=20"));
    ASSERT_TRUE(child.halts());
    const Temporary_folder::Contents before = folder.contents();
    const Matrix_file_job run{kind, folder.file("distances")};
    for(int i = 0; i < 2; ++i) // the first one does not open the door for the second one
      expect_message<std::invalid_argument>(
          [&] { run.compute(job); }, folder.file("distances") + " is already being computed");
    EXPECT_TRUE(folder.contents() == before);
    EXPECT_TRUE(child.kill());
    EXPECT_TRUE(run.compute(job));
    EXPECT_FALSE(folder.has("distances.part"));
  }
}

// Returns how often another process had the lock at the same time.
int number_of_shared_locks(const Temporary_folder& folder)
{
  int result = 0;
  for(int turn = 0; turn < 1000; ++turn)
    try
    {
      const auto lock = AG::internal::lock_file(folder.file("distances.lock"), "distances");
      const int owner = ::open(folder.file("owner").c_str(), O_CREAT | O_EXCL, 0600);
      if(owner < 0)
        ++result;
      else
      {
        ::close(owner);
        std::filesystem::remove(folder.file("owner"));
      }
    }
    catch(const std::invalid_argument&)
    {
    }
  return result;
}

// One opens the lock of another, which removes it at its end, and a third one creates a new one.
TEST(Three_programs, do_not_have_a_lock_at_the_same_time)
{
  const Temporary_folder folder;
  std::vector<pid_t> children(3);
  for(pid_t& child : children)
    if((child = ::fork()) == 0)
      ::_exit((std::min)(number_of_shared_locks(folder), 100));
  for(const pid_t child : children)
  {
    int status = -1;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
}

} // namespace

#endif
