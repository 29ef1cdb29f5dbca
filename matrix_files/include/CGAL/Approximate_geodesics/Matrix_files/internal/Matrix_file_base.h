// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_FILE_BASE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_FILE_BASE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Bulk_checksum.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Matrix_identity.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Resumable_blocks.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Common base of the matrix files: the team of processes, and the completed blocks.
 */
template <typename T, typename Team>
class Matrix_file_base
{
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>,
                "distances in files are of type float or double");

public:
  std::optional<std::size_t> next_block() { return m_blocks.next_block(); }
  std::size_t number_of_rows_done() const { return m_blocks.number_of_rows_done(); }

protected:
  using Blocks = Resumable_blocks<Team>;
  using Journals = typename Blocks::Journals;

  Matrix_file_base(std::string file, Team& team, const double seconds_between_commits)
    : m_team(team), m_blocks(std::move(file), team, seconds_between_commits)
  {
  }

  Matrix_file_base(std::string file, const double seconds_between_commits)
    : m_own_team(std::make_unique<Team>()),
      m_team(*m_own_team),
      m_blocks(std::move(file), m_team, seconds_between_commits)
  {
  }

  Team& team() { return m_team; }
  Blocks& blocks() { return m_blocks; }
  const Distance_matrix_plan& plan() const { return *m_plan; }
  const Matrix_file_names& names() const { return m_blocks.names(); }

  // `kind` distinguishes file formats. The other parameters are those of
  // `Resumable_blocks::start()`.
  template <typename IsThere, typename Prepare>
  void start(const Distance_matrix_plan& plan,
             const std::string& kind,
             const bool are_changed_at_the_end,
             const IsThere& is_there,
             const Prepare& prepare)
  {
    m_plan = &plan;
    Matrix_identity identity = plan.identity();
    identity.parts[Matrix_identity::KIND] = checksum_of_kind(kind, plan.is_symmetric());
    Bulk_checksum version; // includes the size of blocks, which the journal numbers
    version.add_value(identity.parts[Matrix_identity::DISTANCES]);
    version.add_value(static_cast<std::uint64_t>(plan.rows_per_block()));
    identity.parts[Matrix_identity::DISTANCES] = version.value();
    m_blocks.start(identity, plan, are_changed_at_the_end, is_there, prepare);
  }

  // Throws if there is not enough disk space.
  void check_space(const std::uint64_t bytes) const
  {
    const std::uint64_t available = std::filesystem::space(names().folder()).available;
    if(bytes > available)
      throw std::runtime_error("Approximate_geodesics: " + names().file() + " needs " +
                               std::to_string(bytes >> 20) + " MB more, but its disk has only " +
                               std::to_string(available >> 20) + " MB left");
  }

private:
  static std::uint64_t checksum_of_kind(const std::string& kind, const bool is_symmetric)
  {
    Bulk_checksum result;
    result.add(kind.data(), kind.size());
    result.add_value(static_cast<std::uint64_t>(sizeof(T)));
    result.add_value(static_cast<std::uint64_t>(is_symmetric));
    return result.value();
  }

  std::unique_ptr<Team> m_own_team; // if none was given
  Team& m_team;
  Blocks m_blocks;
  const Distance_matrix_plan* m_plan = nullptr;
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_FILE_BASE_H
