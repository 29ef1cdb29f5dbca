// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file.h>

#include "checks/expect_message.h"
#include "files/Temporary_folder.h"
#include "files/matrix_job.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

// A file that is computed in several runs is that of one run, and no row is computed twice.

namespace {

using namespace geodesics_test;

class Interrupted_file : public testing::TestWithParam<std::string>
{
protected:
  const Temporary_folder folder;
  const Matrix_file_job file{GetParam(), folder.file("distances")};

  static Temporary_folder::Contents undisturbed(const Matrix_job& job)
  {
    const Temporary_folder other;
    EXPECT_TRUE((Matrix_file_job{GetParam(), other.file("distances")}).compute(job));
    return other.contents();
  }

  // that there is nothing beside the file
  void expect_complete(const Matrix_job& job) const
  {
    EXPECT_TRUE(folder.contents() == undisturbed(job));
  }

  void expect_incomplete() const
  {
    EXPECT_FALSE(folder.has("distances"));
    EXPECT_TRUE(folder.has("distances.part/identity"));
    EXPECT_TRUE(folder.has("distances.part/result"));
    EXPECT_FALSE(folder.has("distances.lock"));
  }
};

INSTANTIATE_TEST_SUITE_P(, Interrupted_file, testing::ValuesIn(kinds_of_matrix_files()));

TEST_P(Interrupted_file, goes_on_where_a_visitor_has_ended_it)
{
  const Matrix_job job(8);
  for(std::size_t done = 0; done + 5 < 64; done += 5)
  {
    Matrix_watcher watcher = that_stops_at(done + 5);
    EXPECT_FALSE(file.compute(job, watcher));
    expect_incomplete();
    EXPECT_EQ(watcher.numbers_done.front(), done + 1);
    EXPECT_EQ(watcher.numbers_done.back(), done + 5);
  }
  EXPECT_TRUE(file.compute(job));
  expect_complete(job);
}

TEST_P(Interrupted_file, goes_on_before_the_first_row_and_after_the_last_one)
{
  const Matrix_job job(4);
  Matrix_watcher none = that_stops_at(0);
  none.on_progress({16, 0, 0, 0});
  EXPECT_FALSE(file.compute(job, none));
  EXPECT_EQ(none.numbers_done.size(), 1u);
  expect_incomplete();
  Matrix_watcher watcher = that_stops_at(16); // none is left to ask for
  EXPECT_TRUE(file.compute(job, watcher));
  EXPECT_EQ(watcher.numbers_done.size(), 16u);
  expect_complete(job);
}

TEST_P(Interrupted_file, goes_on_after_an_error)
{
  const Matrix_job job(8);
  for(const std::size_t last : {10u, 30u, 64u})
  {
    Matrix_watcher watcher([=](const std::size_t number_done) {
      if(number_done == last)
        throw std::domain_error("Approximate_geodesics' visitor");
      return true;
    });
    expect_message<std::domain_error>([&] { file.compute(job, watcher); }, "visitor");
    expect_incomplete();
  }
  Matrix_watcher watcher;
  EXPECT_TRUE(file.compute(job, watcher));
  EXPECT_EQ(watcher.numbers_done.size(), 0u);
  expect_complete(job);
}

TEST_P(Interrupted_file, is_not_taken_for_one_that_was_put_there_meanwhile)
{
  const Matrix_job job(4);
  Matrix_watcher watcher([&](const std::size_t number_done) {
    if(number_done == 5)
      std::ofstream(folder.file("distances")) << "another";
    return true;
  });
  expect_message<std::invalid_argument>([&] { file.compute(job, watcher); }, " already exists");
  EXPECT_EQ(folder.bytes("distances"), "another");
  std::filesystem::remove(folder.file("distances"));
  expect_incomplete();
  EXPECT_TRUE(file.compute(job));
  expect_complete(job);
}

TEST_P(Interrupted_file, is_computed_by_one_object_at_a_time)
{
  const Matrix_job job(4);
  Matrix_watcher watcher([&](const std::size_t number_done) {
    if(number_done == 5)
      expect_message<std::invalid_argument>(
          [&] { file.compute(job); }, " is already being computed, by this program or another one");
    return true;
  });
  EXPECT_TRUE(file.compute(job, watcher));
  expect_complete(job);
}

TEST_P(Interrupted_file, goes_on_with_any_number_of_threads)
{
  Matrix_job job(16);
  job.maximum_distance = 5;
  Matrix_file_job run = file;
  std::size_t done = 0, step = 40;
  for(const int number_of_threads : {1, 3, 2, 4, 1})
  {
    run.number_of_threads = number_of_threads;
    Matrix_watcher watcher = that_stops_at(done += step);
    EXPECT_FALSE(run.compute(job, watcher));
    EXPECT_GT(watcher.numbers_done.front(), done - step);
    EXPECT_GE(watcher.numbers_done.back(), done);
    expect_incomplete();
  }
  EXPECT_TRUE(run.compute(job));
  expect_complete(job);
}

TEST_P(Interrupted_file, marks_each_block_at_once)
{
  const Matrix_job job(8);
  Matrix_watcher watcher([&](const std::size_t number_done) {
    std::size_t number = 0;
    for(std::size_t block = 0; block < 64; ++block)
      number += folder.has("distances.part/" + std::to_string(block));
    EXPECT_EQ(number, number_done);
    return true;
  });
  EXPECT_TRUE(file.compute(job, watcher));
  EXPECT_EQ(watcher.numbers_done.size(), 64u);
}

TEST(Interrupted_files, go_on_by_the_same_object)
{
  const Temporary_folder folder, another;
  const Matrix_job job(8);
  AG::Csr_file<float> file(folder.file("distances"));
  Matrix_watcher watcher([](const std::size_t number_done) {
    if(number_done == 30)
      throw std::domain_error("Approximate_geodesics' visitor");
    return true;
  });
  expect_message<std::domain_error>([&] { job.compute(file, watcher); }, "visitor");
  Matrix_watcher second;
  EXPECT_TRUE(job.compute(file, second));
  EXPECT_EQ(second.numbers_done.front(), 31u);
  AG::Csr_file<float> undisturbed(another.file("distances"));
  EXPECT_TRUE(job.compute(undisturbed));
  EXPECT_TRUE(folder.contents() == another.contents());
}

// The file and its part folder are where the link leads to.
TEST_P(Interrupted_file, is_reached_by_links)
{
  const Matrix_job job(4);
  const Temporary_folder links;
  std::filesystem::create_symlink(folder.file("distances"), links.file("second"));
  std::filesystem::create_symlink("second", links.file("first"));
  const Matrix_file_job linked{GetParam(), links.file("first")};
  Matrix_watcher watcher = that_stops_at(5);
  EXPECT_FALSE(linked.compute(job, watcher));
  expect_incomplete();
  EXPECT_TRUE(linked.compute(job));
  expect_complete(job);
  EXPECT_TRUE(std::filesystem::is_symlink(links.file("first")));
  EXPECT_TRUE(std::filesystem::is_symlink(links.file("second")));
  expect_message<std::invalid_argument>([&] { linked.compute(job); }, links.file("first"),
                                        " already exists");
}

TEST_P(Interrupted_file, is_not_reached_by_a_cycle_of_links)
{
  std::filesystem::create_symlink("distances", folder.file("distances"));
  expect_message<std::invalid_argument>([&] { file.compute(Matrix_job(4)); },
                                        folder.file("distances"), "a cycle of symbolic links");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("distances")));
}

} // namespace
