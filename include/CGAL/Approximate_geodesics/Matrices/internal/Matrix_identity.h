// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_IDENTITY_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_IDENTITY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/Bulk_checksum.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <boost/type_traits/is_detected.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

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

inline std::uint64_t checksum(const Intrinsic_triangulation& t)
{
  Bulk_checksum result;
  result.add(t.targets());
  result.add(t.lengths());
  result.add_value(t.unit());
  result.add_value(t.weight_unit());
  result.add_value(t.gauges().unit());
  for(Intrinsic_triangulation::Index h = 0; h < t.number_of_halfedges(); ++h)
  {
    if(t.has_weights())
      result.add_value(t.weight(h));
    if(t.has_barriers())
      result.add_value(static_cast<char>(t.is_barrier(h)));
  }
  for(const Face_gauges::Sector& s : t.gauges().all_sectors())
    for(const Plane_vector v : {s.direction, s.functional})
    {
      result.add_value(v.x);
      result.add_value(v.y);
    }
  for(Intrinsic_triangulation::Index v = 0; v < t.number_of_vertices(); ++v)
    result.add_value(t.index(v));
  return result.value();
}

inline std::uint64_t checksum(const std::vector<Intrinsic_point>& points)
{
  Bulk_checksum result;
  for(const Intrinsic_point& p : points)
  {
    result.add_value(p.vertex);
    result.add_value(p.halfedge);
    result.add_value(p.t);
    result.add_value(p.s);
  }
  return result.value();
}

template <typename Graph>
using Epsilon_of = decltype(std::declval<const Graph&>().epsilon());

// Covers the accessible properties of a graph; the part DISTANCES covers the others.
template <typename Graph>
std::uint64_t checksum_of_graph(const Graph& graph)
{
  Bulk_checksum result;
  result.add_value(static_cast<std::uint64_t>(graph.number_of_nodes()));
  result.add_value(graph.unit());
  const Arc_lengths lengths = graph.arc_lengths();
  for(const double length : {lengths.shortest, lengths.mean, lengths.longest})
    result.add_value(length);
  if constexpr(boost::is_detected_v<Epsilon_of, Graph>)
    result.add_value(graph.epsilon());
  if(leads_to_sources(graph))
    result.add_value(static_cast<char>(1));
  return result.value();
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_IDENTITY_H
