// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/Npy_file.h>

#include "files/Temporary_folder.h"
#include "files/matrix_job.h"
#include "files/npy_reader.h"

#include <CGAL/Geodesic_queries/Rows_in_memory.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

// Files of all distances have what matrices in memory have.

namespace {

using namespace geodesics_test;

template <typename T>
std::string expected_dictionary(const Matrix_job& job)
{
  return "{'descr': '<f" + std::to_string(sizeof(T)) + "', 'fortran_order': False, 'shape': (" +
         std::to_string(job.sources.size()) + ", " + std::to_string(job.targets.size()) + "), }";
}

// also that there is nothing else in the folder
template <typename T>
void expect_file(const Matrix_job& job, const Temporary_folder& folder)
{
  AG::Dense_rows<T> rows;
  ASSERT_TRUE(job.compute(rows));
  const Temporary_folder::Contents contents = folder.contents();
  ASSERT_EQ(contents.size(), 1u);
  const Npy_array array(contents.begin()->second);
  EXPECT_EQ(array.dictionary, expected_dictionary<T>(job));
  const std::size_t size = job.sources.size() * job.targets.size();
  EXPECT_TRUE(array.numbers<T>() == std::vector<T>(rows.data(), rows.data() + size));
  EXPECT_EQ(contents.begin()->second.size(),
            AG::Npy_file<T>::length(job.sources.size(), job.targets.size()));
}

template <typename T>
void expect_all_distances(const Matrix_job& job, const int number_of_threads = 1)
{
  const Temporary_folder folder;
  Matrix_watcher watcher;
  EXPECT_TRUE(
      job.compute(AG::Npy_file<T>(folder.file("distances.npy")), watcher, number_of_threads));
  expect_file<T>(job, folder);
}

template <typename T>
class Npy_file_of : public testing::Test
{
};

using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(Npy_file_of, Numbers, );

TYPED_TEST(Npy_file_of, has_all_distances)
{
  Matrix_job job(8);
  expect_all_distances<TypeParam>(job);
  job.sources.resize(20);
  job.sources[3] = job.sources[7];
  expect_all_distances<TypeParam>(job);
  job.targets.resize(9);
  job.maximum_distance = 3;
  expect_all_distances<TypeParam>(job);
}

TYPED_TEST(Npy_file_of, can_be_small)
{
  for(const std::size_t rows : {0u, 1u, 2u})
    for(const std::size_t columns : {0u, 1u, 2u})
      for(const bool is_symmetric : {false, true})
      {
        Matrix_job job(4);
        job.sources.resize(rows);
        job.targets.resize(columns);
        job.is_symmetric = is_symmetric && rows == columns;
        SCOPED_TRACE(std::to_string(rows) + " x " + std::to_string(columns));
        expect_all_distances<TypeParam>(job);
      }
}

// and with threads
TYPED_TEST(Npy_file_of, has_blocks_of_several_rows)
{
  Matrix_job job(6);
  job.repeat_sources(1100);
  for(const int number_of_threads : {1, 3})
    expect_all_distances<TypeParam>(job, number_of_threads);
}

TYPED_TEST(Npy_file_of, can_be_symmetric)
{
  Matrix_job job(7);
  job.is_symmetric = true;
  for(const int number_of_threads : {1, 3})
    expect_all_distances<TypeParam>(job, number_of_threads);
}

// which are read by squares, the last of which are smaller
TYPED_TEST(Npy_file_of, can_be_symmetric_and_large)
{
  for(const std::size_t rows : {1023u, 1024u, 1025u, 2050u})
  {
    Matrix_job job(6);
    job.is_symmetric = true;
    job.repeat_sources(rows);
    job.targets = job.sources;
    expect_all_distances<TypeParam>(job);
  }
}

TEST(Npy_file, can_be_of_the_present_folder)
{
  const Temporary_folder folder;
  const Current_folder current(folder.name());
  const Matrix_job job(4);
  AG::Npy_file<float> file("distances.npy");
  Matrix_watcher watcher = that_stops_at(9);
  EXPECT_FALSE(job.compute(file, watcher));
  EXPECT_TRUE(job.compute(file));
  expect_file<float>(job, folder);
}

TEST(Npy_file, tells_its_length)
{
  EXPECT_EQ(AG::Npy_file<float>::length(0, 0), 128u);
  EXPECT_EQ(AG::Npy_file<float>::length(3, 5), 128u + 3 * 5 * 4);
  EXPECT_EQ(AG::Npy_file<double>::length(3000000, 5000000), 128u + 120000000000000u);
}

} // namespace
