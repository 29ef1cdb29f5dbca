// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_SINGLE_PROCESS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_SINGLE_PROCESS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Local_file.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * One process, which computes a file of distances alone.
 *
 * \cgalModels{ProcessTeam}
 */
class Single_process
{
public:
  /// a file that all processes write to.
  using File = internal::Local_file;

  /// returns the number of this process, counted from 0.
  std::size_t rank() const { return 0; }

  /// returns the number of processes.
  std::size_t size() const { return 1; }

  /// waits until all processes have called this function.
  void wait() {}

  /// replaces the values by those of process 0.
  void share(std::vector<std::uint64_t>& /* values */) {}

  /// replaces the text by that of process 0.
  void share(std::string& /* text */) {}

  /// deals out tickets from 0 again.
  void restart_tickets() { m_next = 0; }

  /// returns the number of the next ticket, which no other thread and no other process gets.
  std::uint64_t next_ticket() { return m_next++; }

private:
  std::atomic<std::uint64_t> m_next{0};
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_SINGLE_PROCESS_H
