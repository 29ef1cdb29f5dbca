// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_MATRIX_JOB_H
#define APPROXIMATE_GEODESICS_TEST_MATRIX_JOB_H

#include "meshes/test_meshes.h"

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Csr_file.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Npy_file.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Process_team.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodesics_test {

namespace AG = CGAL::Approximate_geodesics;

// Keeps what it is told, and asks a function whether to go on.
class Matrix_watcher : public AG::Distance_matrix_visitor_base
{
public:
  using Goes_on = std::function<bool(std::size_t number_done)>;

  explicit Matrix_watcher(Goes_on goes_on = [](std::size_t) { return true; })
    : m_asks(std::move(goes_on))
  {
  }

  void on_progress(const AG::Distance_matrix_progress& progress)
  {
    numbers_done.push_back(progress.number_done);
    m_goes_on = m_goes_on && m_asks(progress.number_done);
  }

  bool go_further() const { return m_goes_on; }

  std::vector<std::size_t> numbers_done;

private:
  Goes_on m_asks;
  bool m_goes_on = true;
};

inline Matrix_watcher that_stops_at(const std::size_t number_of_rows)
{
  return Matrix_watcher(
      [=](const std::size_t number_done) { return number_done < number_of_rows; });
}

/*
 * Distances between vertices along the edges of a mesh.
 */
struct Matrix_job
{
  AG::Edge_graph graph;
  std::vector<std::size_t> sources;
  std::vector<std::size_t> targets;
  double maximum_distance = std::numeric_limits<double>::infinity();
  bool is_symmetric = false;

  // between all vertices, sources in an order of their own unless targets are to be the same
  explicit Matrix_job(const std::size_t side, const std::uint64_t seed = 5)
  {
    Random random(seed);
    graph = AG::Edge_graph(AG::Intrinsic_triangulation(to_mesh(terrain(side, side, random))));
    sources = targets = random.permutation(side * side);
  }

  void repeat_sources(const std::size_t number)
  {
    const std::vector<std::size_t> before = sources;
    sources.resize(number);
    for(std::size_t i = 0; i < number; ++i)
      sources[i] = before[i % before.size()];
  }

  template <typename Tag = CGAL::Sequential_tag, typename Rows>
  bool compute(Rows&& rows, Matrix_watcher& watcher) const
  {
    const auto np = CGAL::parameters::targets(targets)
                        .maximum_distance(maximum_distance)
                        .concurrency_tag(Tag())
                        .visitor(std::ref(watcher));
    if constexpr(AG::internal::can_be_symmetric<std::remove_reference_t<Rows>>)
      return CGAL::approximate_geodesic_distance_matrix(graph, rows, sources,
                                                        np.symmetric(is_symmetric));
    else
      return CGAL::approximate_geodesic_distance_matrix(graph, rows, sources, np);
  }

  template <typename Rows>
  bool compute(Rows&& rows) const
  {
    Matrix_watcher watcher;
    return compute(rows, watcher);
  }

  // by several threads, if there can be any
  template <typename Rows>
  bool
  compute(Rows&& rows, Matrix_watcher& watcher, [[maybe_unused]] const int number_of_threads) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(number_of_threads > 1)
    {
      const auto most = static_cast<std::size_t>(number_of_threads); // whatever the machine has
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, most);
      return tbb::task_arena(number_of_threads).execute([&] {
        return compute<CGAL::Parallel_tag>(rows, watcher);
      });
    }
#endif
    return compute(rows, watcher);
  }
};

// The kinds of files that a job can be written to.
inline const std::vector<std::string>& kinds_of_matrix_files()
{
  static const std::vector<std::string> result{"npy", "symmetric", "csr", "nearest"};
  return result;
}

/*
 * A file, and how it is to be computed.
 */
struct Matrix_file_job
{
  std::string kind;
  std::string file;
  int number_of_threads = 1;

  // Returns whether it is complete.
  bool compute(Matrix_job job, Matrix_watcher& watcher, AG::Process_team& team) const
  {
    job.is_symmetric = kind == "symmetric";
    if(kind == "npy" || kind == "symmetric")
      return job.compute(AG::Npy_file<float>(file, team), watcher, number_of_threads);
    AG::Csr_file<float> sink(file, team);
    if(kind == "nearest")
      sink.keep_nearest(20);
    else if(kind != "csr")
      throw std::invalid_argument("no kind of file: " + kind);
    return job.compute(sink, watcher, number_of_threads);
  }

  bool compute(const Matrix_job& job, Matrix_watcher& watcher) const
  {
    AG::Single_process team;
    return compute(job, watcher, team);
  }

  bool compute(const Matrix_job& job) const
  {
    Matrix_watcher watcher;
    return compute(job, watcher);
  }
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_MATRIX_JOB_H
