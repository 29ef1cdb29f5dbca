// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_identity.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Geodesic_costs/internal/Face_gauges.h>

#include <vector>

namespace CGAL::Approximate_geodesics::internal {
namespace {

template <typename Numbers>
std::uint32_t checksum_of_numbers(const Numbers& numbers)
{
  Checksum result;
  for(const double number : numbers)
    result.add(number);
  return result.value();
}

std::uint32_t checksum(const std::vector<Intrinsic_point>& points)
{
  Checksum result;
  for(const Intrinsic_point& p : points)
  {
    result.add(p.vertex);
    result.add(p.halfedge);
    result.add(p.t);
    result.add(p.s);
  }
  return result.value();
}

} // namespace

std::uint32_t checksum(const Intrinsic_triangulation& t)
{
  Checksum result;
  for(const Intrinsic_triangulation::Index target : t.targets())
    result.add(target);
  for(const double length : t.lengths())
    result.add(length);
  result.add(t.unit());
  result.add(t.weight_unit());
  result.add(t.has_directional_costs() ? t.gauges().unit() : 1.);
  for(Intrinsic_triangulation::Index h = 0; h < t.number_of_halfedges(); ++h)
  {
    if(t.has_weights())
      result.add(t.weight(h));
    if(t.has_barriers())
      result.add(static_cast<char>(t.is_barrier(h)));
  }
  if(t.has_directional_costs())
    for(const Face_gauges::Sector& s : t.gauges().all_sectors())
      for(const Plane_vector v : {s.direction, s.functional})
      {
        result.add(v.x);
        result.add(v.y);
      }
  for(Intrinsic_triangulation::Index v = 0; v < t.number_of_vertices(); ++v)
    result.add(t.index(v));
  return result.value();
}

Matrix_identity::Matrix_identity(const Matrix_facts& facts)
{
  parts[MESH] = checksum(facts.triangulation);
  parts[GRAPH] = checksum_of_numbers(facts.graph);
  parts[NUMBER_OF_SOURCES] = facts.sources.size();
  parts[NUMBER_OF_TARGETS] = facts.targets.size();
  parts[SOURCES] = checksum(facts.sources);
  parts[TARGETS] = checksum(facts.targets);
  Checksum limit;
  limit.add(facts.maximum_distance);
  limit.add(static_cast<std::uint64_t>(facts.number_of_nearest));
  parts[LIMIT] = limit.value();
  parts[DISTANCES] = checksum_of_numbers(facts.first_row);
}

} // namespace CGAL::Approximate_geodesics::internal
