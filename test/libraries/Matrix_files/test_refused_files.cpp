// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file.h>

#include "checks/expect_message.h"
#include "files/Temporary_folder.h"
#include "files/matrix_job.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>

#include <gtest/gtest.h>

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#ifdef __linux__
#include <csignal>
#include <sys/resource.h>
#include <unistd.h>
#endif

// Files that are not begun, or not gone on with, and what the message says. Nothing on the disk
// changes then.

namespace {

using namespace geodesics_test;

template <typename Exception, typename F, typename... Texts>
void expect_refusal(const Temporary_folder& folder, const F& f, const Texts&... texts)
{
  const Temporary_folder::Contents before = folder.contents();
  expect_message<Exception>(f, texts...);
  EXPECT_TRUE(folder.contents() == before);
}

// Leaves a file that has half of its rows.
void begin(const Matrix_file_job& file, const Matrix_job& job)
{
  Matrix_watcher watcher = that_stops_at(job.sources.size() / 2);
  EXPECT_FALSE(file.compute(job, watcher));
}

TEST(Refused_file, is_there_already)
{
  const Matrix_job job(4);
  for(const std::string& kind : kinds_of_matrix_files())
  {
    const Temporary_folder folder;
    const Matrix_file_job file{kind, folder.file("distances")};
    EXPECT_TRUE(file.compute(job));
    expect_refusal<std::invalid_argument>(
        folder, [&] { file.compute(job); }, file.file + " already exists; remove it");
  }
}

// What would be deleted with the folder is not ours.
TEST(Refused_file, has_a_part_folder_of_something_else)
{
  const Matrix_job job(4);
  for(const std::string& kind : kinds_of_matrix_files())
    for(const char* const part : {"distances.part", "distances.part/0", "distances.part/result"})
    {
      const Temporary_folder folder;
      folder.fill({{part, "something"}});
      const Matrix_file_job file{kind, folder.file("distances")};
      expect_refusal<std::invalid_argument>(
          folder, [&] { file.compute(job); },
          folder.file("distances.part") + " exists, but is not an unfinished distance matrix");
    }
}

TEST(Refused_file, has_something_else_in_place_of_its_lock)
{
  const Temporary_folder folder;
  folder.fill({{"distances.lock", "something"}, {"another", ""}});
  std::filesystem::create_symlink("another", folder.file("linked.lock"));
  std::filesystem::create_directory(folder.file("nested.lock"));
  for(const char* const name : {"distances", "linked", "nested"})
    expect_refusal<std::invalid_argument>(
        folder,
        [&] {
          (Matrix_file_job{"npy", folder.file(name)}).compute(Matrix_job(4));
        },
        folder.file(name) + ".lock exists, but is not a lock");
}

TEST(Refused_file, has_no_name)
{
  const Temporary_folder folder;
  const Current_folder current(folder.name());
  for(const std::string& kind : kinds_of_matrix_files())
    expect_refusal<std::invalid_argument>(
        folder,
        [&] {
          (Matrix_file_job{kind, ""}).compute(Matrix_job(4));
        },
        "the name of a matrix file is empty");
}

// Whether its name has a folder or not.
TEST(Refused_file, is_computed_by_another_object)
{
  const Matrix_job job(4);
  const Temporary_folder folder;
  const Current_folder current(folder.name());
  for(const std::string& name : {std::string("distances"), folder.file("others")})
  {
    const Matrix_file_job file{"npy", name};
    Matrix_watcher watcher([&](const std::size_t number_done) {
      if(number_done == 2)
        expect_message<std::invalid_argument>([&] { file.compute(job); },
                                              name + " is already being computed");
      return true;
    });
    EXPECT_TRUE(file.compute(job, watcher));
  }
}

TEST(Refused_file, has_no_part_folder_by_a_similar_name)
{
  const Matrix_job job(4);
  const Temporary_folder folder;
  const Temporary_folder::Contents others{{"distances.part.x", "1"},
                                          {"distances.part1/0", "2"},
                                          {"distances.part.new/result", "3"},
                                          {"a distances.part", "4"}};
  folder.fill(others);
  EXPECT_TRUE((Matrix_file_job{"npy", folder.file("distances")}).compute(job));
  Temporary_folder::Contents contents = folder.contents();
  EXPECT_EQ(contents.erase("distances"), 1u);
  EXPECT_TRUE(contents == others);
}

TEST(Refused_file, belongs_to_another_job)
{
  const Matrix_job job(5);
  struct Difference
  {
    std::function<void(Matrix_job&)> change;
    std::string message;
  };
  const std::vector<Difference> differences{
      {[](auto& j) { j.graph = Matrix_job(5, 6).graph; }, "another mesh, or other lengths"},
      {[](auto& j) { j.sources.pop_back(); }, "another number of sources (25, not 24);"},
      {[](auto& j) { j.sources.push_back(0); }, "another number of sources (25, not 26);"},
      {[](auto& j) { j.targets.resize(3); }, "another number of targets (25, not 3);"},
      {[](auto& j) { j.sources[24] = j.sources[0]; }, "other sources"},
      {[](auto& j) { std::swap(j.targets[3], j.targets[4]); }, "other targets"},
      {[](auto& j) { j.maximum_distance = 1e9; }, "another maximum_distance or number"}};
  for(const char* const kind : {"npy", "csr", "nearest"})
  {
    const Temporary_folder folder;
    const Matrix_file_job file{kind, folder.file("distances")};
    begin(file, job);
    for(const Difference& difference : differences)
    {
      Matrix_job another = job;
      difference.change(another);
      expect_refusal<std::invalid_argument>(
          folder, [&] { file.compute(another); },
          folder.file("distances.part") + " belongs to a computation with " + difference.message,
          "; delete " + folder.file("distances.part") + " to restart");
    }
    EXPECT_TRUE(file.compute(job));
  }
}

TEST(Refused_file, is_of_another_kind)
{
  const Matrix_job job(5);
  for(const std::string& kind : kinds_of_matrix_files())
    for(const std::string& another : kinds_of_matrix_files())
      if(kind != another)
      {
        const Temporary_folder folder;
        begin({kind, folder.file("distances")}, job);
        expect_refusal<std::invalid_argument>(
            folder,
            [&] {
              (Matrix_file_job{another, folder.file("distances")}).compute(job);
            },
            folder.file("distances.part") + " belongs to a computation with another ",
            kind == "npy" || kind == "symmetric" || another == "npy" || another == "symmetric"
                ? "kind of file or of numbers"
                : "number of nearest");
      }
}

TEST(Refused_file, has_other_numbers)
{
  const Matrix_job job(5);
  const Temporary_folder folder;
  begin({"npy", folder.file("dense")}, job);
  begin({"csr", folder.file("sparse")}, job);
  const std::string message = "another kind of file or of numbers";
  expect_refusal<std::invalid_argument>(
      folder, [&] { job.compute(AG::Npy_file<double>(folder.file("dense"))); }, message);
  expect_refusal<std::invalid_argument>(
      folder, [&] { job.compute(AG::Csr_file<double>(folder.file("sparse"))); }, message);
}

TEST(Refused_file, has_another_number_of_nearest)
{
  const Matrix_job job(5);
  const Temporary_folder folder;
  begin({"nearest", folder.file("distances")}, job);
  AG::Csr_file<float> file(folder.file("distances"));
  file.keep_nearest(19);
  expect_refusal<std::invalid_argument>(
      folder, [&] { job.compute(file); }, "another maximum_distance or number of nearest");
}

TEST(Refused_file, has_another_bound)
{
  const Matrix_job job(5);
  const Temporary_folder folder;
  const auto compute = [&](const double epsilon) {
    const AG::Discrete_geodesic_graph graph(job.graph.triangulation(),
                                            CGAL::parameters::epsilon(epsilon));
    AG::Npy_file<float> file(folder.file("distances"));
    Matrix_watcher watcher = that_stops_at(3);
    return CGAL::approximate_geodesic_distance_matrix(graph, file, job.sources,
                                                      CGAL::parameters::visitor(std::ref(watcher)));
  };
  const std::string message = "another graph, or another bound epsilon";
  EXPECT_FALSE(compute(0.1));
  expect_refusal<std::invalid_argument>(
      folder, [&] { compute(0.2); }, message);
  expect_refusal<std::invalid_argument>(
      folder,
      [&] {
        (Matrix_file_job{"npy", folder.file("distances")}).compute(job);
      },
      message);
}

TEST(Refused_file, is_in_a_folder_that_is_missing)
{
  const Temporary_folder folder;
  const std::string missing = folder.file("missing");
  for(const std::string& kind : kinds_of_matrix_files())
    expect_refusal<std::invalid_argument>(
        folder,
        [&] {
          (Matrix_file_job{kind, missing + "/distances"}).compute(Matrix_job(4));
        },
        "there is no folder " + missing);
}

TEST(Refused_file, is_longer_than_the_disk_has_room_for)
{
  Matrix_job job(4);
  job.targets.assign(1 << 21, 0);
  const std::size_t length_of_row = job.targets.size() * sizeof(double);
  const Temporary_folder folder;
  const std::size_t available = std::filesystem::space(folder.name()).available;
  job.sources.assign(available / length_of_row + available / length_of_row / 10 + 2, 0);
  expect_refusal<std::runtime_error>(
      folder, [&] { job.compute(AG::Npy_file<double>(folder.file("distances"))); },
      folder.file("distances") + " needs ", " MB more, but its disk has only ", " MB left");
}

TEST(Refused_file, is_longer_than_the_disk_has_room_for_with_millions_of_rows)
{
  Matrix_job job(4);
  const Temporary_folder folder;
  const std::size_t number_of_rows = 4000000;
  const std::size_t available = std::filesystem::space(folder.name()).available;
  job.targets.assign(available / number_of_rows / sizeof(double) * 2, 0);
  job.sources.assign(number_of_rows, 0);
  expect_refusal<std::runtime_error>(
      folder, [&] { job.compute(AG::Npy_file<double>(folder.file("distances"))); }, " needs ");
}

#ifdef __linux__

TEST(Refused_file, is_in_a_folder_that_cannot_be_written_to)
{
  const std::string file = "/proc/self/distances";
  for(const std::string& kind : kinds_of_matrix_files())
    expect_message<std::runtime_error>(
        [&] {
          (Matrix_file_job{kind, file}).compute(Matrix_job(4));
        },
        file, " cannot be opened for writing: ");
}

TEST(Refused_file, is_in_a_folder_that_is_read_only)
{
  if(::geteuid() == 0)
    GTEST_SKIP() << "who may write everywhere is refused nowhere";
  namespace fs = std::filesystem;
  const Temporary_folder folder;
  fs::permissions(folder.name(), fs::perms::owner_read | fs::perms::owner_exec);
  expect_refusal<std::runtime_error>(
      folder,
      [&] {
        (Matrix_file_job{"npy", folder.file("distances")}).compute(Matrix_job(4));
      },
      " cannot be opened for writing: " + std::generic_category().message(EACCES));
  fs::permissions(folder.name(), fs::perms::owner_all);
}

// Files cannot become longer than that meanwhile, as if the disk was full.
class Limited_length
{
public:
  explicit Limited_length(const std::size_t bytes)
  {
    ::getrlimit(RLIMIT_FSIZE, &m_before);
    m_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, m_before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }

  Limited_length(const Limited_length&) = delete;
  Limited_length& operator=(const Limited_length&) = delete;

  ~Limited_length()
  {
    ::setrlimit(RLIMIT_FSIZE, &m_before);
    std::signal(SIGXFSZ, m_handler);
  }

private:
  rlimit m_before;
  void (*m_handler)(int);
};

// Wherever that happens, the message says so, and the same call goes on later.
TEST(Full_disk, ends_a_computation_that_goes_on_later)
{
  const Matrix_job job(6);
  const std::string reason = std::generic_category().message(EFBIG);
  for(const std::string& kind : kinds_of_matrix_files())
  {
    const Temporary_folder folder, another;
    const Matrix_file_job file{kind, folder.file("distances")};
    EXPECT_TRUE((Matrix_file_job{kind, another.file("distances")}).compute(job));
    std::size_t number_of_errors = 0, most_done = 0;
    for(std::size_t limit = 0; limit < 20000 && !folder.has("distances"); limit += 300)
      try
      {
        Matrix_watcher watcher([&](const std::size_t number_done) {
          most_done = number_done;
          return true;
        });
        const Limited_length limited(limit);
        file.compute(job, watcher);
      }
      catch(const std::runtime_error& e)
      {
        ++number_of_errors;
        const std::string message = e.what();
        EXPECT_NE(message.find("Approximate_geodesics: " + file.file), std::string::npos)
            << message;
        EXPECT_NE(message.find(" cannot be "), std::string::npos) << message;
        EXPECT_NE(message.find(reason), std::string::npos) << message;
        EXPECT_FALSE(folder.has("distances"));
      }
    EXPECT_GT(number_of_errors, 5u);
    EXPECT_EQ(most_done, 36u);
    EXPECT_TRUE(folder.contents() == another.contents()) << kind;
  }
}

// while it is computed
TEST(Full_disk, keeps_the_rows_that_are_done)
{
  const Matrix_job job(6);
  for(const std::string& kind : kinds_of_matrix_files())
  {
    const Temporary_folder folder, another;
    const Matrix_file_job file{kind, folder.file("distances")};
    EXPECT_TRUE((Matrix_file_job{kind, another.file("distances")}).compute(job));
    {
      std::unique_ptr<Limited_length> limited;
      Matrix_watcher watcher([&](const std::size_t number_done) {
        if(number_done == 20)
          limited = std::make_unique<Limited_length>(10);
        return true;
      });
      expect_message<std::runtime_error>([&] { file.compute(job, watcher); },
                                         std::generic_category().message(EFBIG));
    }
    Matrix_watcher watcher;
    EXPECT_TRUE(file.compute(job, watcher));
    EXPECT_EQ(watcher.numbers_done.front(), 21u);
    EXPECT_TRUE(folder.contents() == another.contents()) << kind;
  }
}

#endif

} // namespace
