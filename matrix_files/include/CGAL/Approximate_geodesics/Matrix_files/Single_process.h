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
 * A team of one process.
 *
 * \cgalModels{ProcessTeam}
 */
class Single_process
{
public:
  /// the file type.
  using File = internal::Local_file;

  /// returns the rank of this process: 0.
  std::size_t rank() const { return 0; }

  /// returns the number of processes: 1.
  std::size_t size() const { return 1; }

  /// does nothing.
  void wait() {}

  /// does nothing.
  void share(std::vector<std::uint64_t>& /* values */) {}

  /// does nothing.
  void share(std::string& /* text */) {}

  /// restarts the ticket counter at 0.
  void restart_tickets() { m_next = 0; }

  /// returns the next ticket. Tickets are unique among all threads.
  std::uint64_t next_ticket() { return m_next++; }

private:
  std::atomic<std::uint64_t> m_next{0};
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_SINGLE_PROCESS_H
