// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_IDENTITY_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_IDENTITY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A fingerprint of a distance matrix, by parts, so that messages can name the difference between
 * two matrices.
 */
struct Matrix_identity
{
  enum Part
  {
    KIND,
    MESH,
    GRAPH,
    NUMBER_OF_SOURCES, // the number itself, not a checksum
    NUMBER_OF_TARGETS,
    SOURCES,
    TARGETS,
    LIMIT,
    DISTANCES,
    NUMBER_OF_PARTS
  };

  Matrix_identity() = default;
  explicit Matrix_identity(const Matrix_facts& facts);

  // Returns the text of messages for a part that differs.
  static const char* name(const std::size_t part)
  {
    constexpr std::array<const char*, NUMBER_OF_PARTS> names{
        "another kind of file or of numbers",
        "another mesh, or other lengths, weights or barriers",
        "another graph, or another bound epsilon",
        "another number of sources",
        "another number of targets",
        "other sources",
        "other targets",
        "another maximum_distance or number of nearest",
        "distances that differ, as another version or compilation of the program gives them"};
    return names[part];
  }

  // Returns that text, with the values of both matrices if possible.
  std::string difference(const std::size_t part, const Matrix_identity& other) const
  {
    if(part != NUMBER_OF_SOURCES && part != NUMBER_OF_TARGETS)
      return name(part);
    return std::string(name(part)) + " (" + std::to_string(parts[part]) + ", not " +
           std::to_string(other.parts[part]) + ')';
  }

  std::array<std::uint64_t, NUMBER_OF_PARTS> parts{};
};

// Returns a checksum of all that distances on a triangulation depend on.
std::uint32_t checksum(const Intrinsic_triangulation& triangulation);

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_IDENTITY_H
