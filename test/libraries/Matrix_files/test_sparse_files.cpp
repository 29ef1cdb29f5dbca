// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/Csr_file.h>

#include "checks/expect_message.h"
#include "files/Temporary_folder.h"
#include "files/matrix_job.h"
#include "files/npy_reader.h"

#include <CGAL/Geodesic_queries/Rows_in_memory.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Folders of some distances have what matrices in memory have.

namespace {

using namespace geodesics_test;

// the entries of rows, as SciPy has them
template <typename T>
struct Sparse_entries
{
  std::vector<std::int32_t> starts{0}, columns;
  std::vector<T> distances;

  explicit Sparse_entries(const AG::Sparse_rows<T>& rows)
  {
    for(std::size_t row = 0; row < rows.number_of_rows(); ++row)
    {
      for(const auto column : rows.columns(row))
        columns.push_back(static_cast<std::int32_t>(column));
      distances.insert(distances.end(), rows.distances(row).begin(), rows.distances(row).end());
      starts.push_back(static_cast<std::int32_t>(columns.size()));
    }
  }

  void expect_in(const Temporary_folder::Contents& files, const std::size_t number_of_columns) const
  {
    const auto array = [&](const char* name) {
      return Npy_array(files.at(std::string(name) + ".npy"));
    };
    EXPECT_EQ(files.size(), 4u);
    EXPECT_TRUE(array("indptr").template numbers<std::int32_t>() == starts);
    EXPECT_TRUE(array("indices").template numbers<std::int32_t>() == columns);
    EXPECT_TRUE(array("data").template numbers<T>() == distances);
    EXPECT_EQ(array("shape").template numbers<std::int64_t>(),
              (std::vector<std::int64_t>{std::int64_t(starts.size()) - 1,
                                         std::int64_t(number_of_columns)}));
    EXPECT_EQ(array("indptr").dictionary, dictionary("i4", starts.size()));
    EXPECT_EQ(array("indices").dictionary, dictionary("i4", columns.size()));
    EXPECT_EQ(array("data").dictionary,
              dictionary("f" + std::to_string(sizeof(T)), distances.size()));
    EXPECT_EQ(array("shape").dictionary, dictionary("i8", 2));
  }

private:
  static std::string dictionary(const std::string& type, const std::size_t size)
  {
    return "{'descr': '<" + type + "', 'fortran_order': False, 'shape': (" + std::to_string(size) +
           ",), }";
  }
};

// the same in memory, in a file that was saved, and in one that was computed
template <typename Rows, typename File>
void expect_same(const Matrix_job& job,
                 Rows&& rows,
                 File&& file,
                 const Temporary_folder& folder,
                 const int number_of_threads)
{
  Matrix_watcher watcher;
  EXPECT_TRUE(job.compute(rows));
  const Temporary_folder saved;
  AG::save_csr(rows, saved.name()); // into an existing folder
  Sparse_entries(rows).expect_in(saved.contents(), job.targets.size());
  EXPECT_TRUE(job.compute(file, watcher, number_of_threads));
  AG::save_csr(rows, folder.file("saved"));
  for(const auto& [name, bytes] : saved.contents())
    for(const char* const copy : {"saved/", "computed/"})
      EXPECT_TRUE(folder.bytes(copy + name) == bytes) << copy << name;
  EXPECT_EQ(folder.contents().size(), 8u); // nothing else
}

template <typename T>
void expect_same_entries(Matrix_job job, const int number_of_threads = 1)
{
  for(const double radius : {0., 2.5, 1e300})
  {
    const Temporary_folder folder;
    job.maximum_distance = radius;
    expect_same(job, AG::Radius_rows<T>(), AG::Csr_file<T>(folder.file("computed")), folder,
                number_of_threads);
  }
  job.maximum_distance = std::numeric_limits<double>::infinity();
  for(const std::size_t number : {1u, 7u, 1000u})
  {
    const Temporary_folder folder;
    AG::Csr_file<T> file(folder.file("computed"));
    file.keep_nearest(number);
    EXPECT_EQ(file.number_of_nearest(), number);
    expect_same(job, AG::Nearest_rows<T>(number), file, folder, number_of_threads);
  }
}

template <typename T>
class Csr_file_of : public testing::Test
{
};

using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(Csr_file_of, Numbers, );

TYPED_TEST(Csr_file_of, has_the_entries_of_rows_in_memory)
{
  Matrix_job job(8);
  expect_same_entries<TypeParam>(job);
  job.sources.resize(20);
  job.sources[3] = job.sources[7];
  job.targets.resize(9);
  expect_same_entries<TypeParam>(job);
}

TYPED_TEST(Csr_file_of, can_be_small)
{
  for(const std::size_t rows : {0u, 1u, 2u})
    for(const std::size_t columns : {0u, 1u, 2u})
    {
      Matrix_job job(4);
      job.sources.resize(rows);
      job.targets.resize(columns);
      SCOPED_TRACE(std::to_string(rows) + " x " + std::to_string(columns));
      expect_same_entries<TypeParam>(job);
    }
}

// and threads
TYPED_TEST(Csr_file_of, has_blocks_of_several_rows)
{
  Matrix_job job(6);
  job.repeat_sources(1100);
  job.maximum_distance = 4;
  for(const int number_of_threads : {1, 3})
  {
    const Temporary_folder folder;
    expect_same(job, AG::Radius_rows<TypeParam>(), AG::Csr_file<TypeParam>(folder.file("computed")),
                folder, number_of_threads);
  }
}

TEST(Csr_file, may_have_a_slash_behind_its_name)
{
  const Matrix_job job(4);
  const Temporary_folder folder, another;
  AG::Csr_file<float> file(folder.file("distances/"));
  Matrix_watcher watcher = that_stops_at(9);
  EXPECT_FALSE(job.compute(file, watcher));
  EXPECT_TRUE(folder.has("distances.part"));
  EXPECT_TRUE(job.compute(file));
  EXPECT_TRUE((Matrix_file_job{"csr", another.file("distances")}).compute(job));
  EXPECT_TRUE(folder.contents() == another.contents());
}

TEST(Saved_rows, tell_why_they_cannot_be_saved)
{
  const Matrix_job job(4);
  AG::Radius_rows<float> rows;
  EXPECT_TRUE(job.compute(rows));
  const Temporary_folder folder;
  expect_message<std::runtime_error>([&] { AG::save_csr(rows, folder.file("missing/folder")); },
                                     folder.file("missing/folder"));
  folder.fill({{"data.npy/", ""}});
  expect_message<std::runtime_error>([&] { AG::save_csr(rows, folder.name()); },
                                     folder.file("data.npy") + " cannot be opened for writing: ");
}

TEST(Csr_file, keeps_at_least_one_entry)
{
  AG::Csr_file<float> file("distances");
  expect_message<std::invalid_argument>([&] { file.keep_nearest(0); },
                                        "the number of nearest columns is 0");
}

} // namespace
