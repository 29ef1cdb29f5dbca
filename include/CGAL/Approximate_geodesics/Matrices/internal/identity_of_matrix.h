// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_IDENTITY_OF_MATRIX_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_IDENTITY_OF_MATRIX_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Matrix_columns.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Row_search.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/matrix_points.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <boost/type_traits/is_detected.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

inline std::uint32_t checksum(const Intrinsic_triangulation& t)
{
  Checksum result;
  for(const Intrinsic_triangulation::Index target : t.targets())
    result.add(target);
  for(const double length : t.lengths())
    result.add(length);
  result.add(t.unit());
  result.add(t.weight_unit());
  result.add(t.gauges().unit());
  for(Intrinsic_triangulation::Index h = 0; h < t.number_of_halfedges(); ++h)
  {
    if(t.has_weights())
      result.add(t.weight(h));
    if(t.has_barriers())
      result.add(static_cast<char>(t.is_barrier(h)));
  }
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

inline std::uint32_t checksum(const std::vector<Intrinsic_point>& points)
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

template <typename Graph>
using Epsilon_of = decltype(std::declval<const Graph&>().epsilon());

// Covers the accessible properties of a graph; the part DISTANCES covers the others.
template <typename Graph>
std::uint32_t checksum_of_graph(const Graph& graph)
{
  Checksum result;
  result.add(static_cast<std::uint64_t>(graph.number_of_nodes()));
  result.add(graph.unit());
  const Arc_lengths lengths = graph.arc_lengths();
  for(const double length : {lengths.shortest, lengths.mean, lengths.longest})
    result.add(length);
  if constexpr(boost::is_detected_v<Epsilon_of, Graph>)
    result.add(graph.epsilon());
  if(leads_to_sources(graph))
    result.add(static_cast<char>(1));
  return result.value();
}

// Fingerprints the input of the matrix, and its first row.
template <typename Graph>
Matrix_identity identity_of_matrix(const Graph& graph,
                                   const Matrix_points& points,
                                   const Matrix_columns<Graph>& columns,
                                   const Row_limits& limits)
{
  Matrix_identity result;
  result.parts[Matrix_identity::MESH] = checksum(graph.triangulation());
  result.parts[Matrix_identity::GRAPH] = checksum_of_graph(graph);
  result.parts[Matrix_identity::NUMBER_OF_SOURCES] = points.sources.size();
  result.parts[Matrix_identity::NUMBER_OF_TARGETS] = points.targets.size();
  result.parts[Matrix_identity::SOURCES] = checksum(points.sources);
  result.parts[Matrix_identity::TARGETS] = checksum(points.targets);
  Checksum limit, distances;
  limit.add(limits.maximum_distance);
  limit.add(static_cast<std::uint64_t>(limits.number_of_nearest));
  result.parts[Matrix_identity::LIMIT] = limit.value();
  if(!points.sources.empty())
  {
    Row_search<Graph> search(graph, columns, limits);
    for(const double distance : search.find(points.sources.front()))
      distances.add(distance);
  }
  result.parts[Matrix_identity::DISTANCES] = distances.value();
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_IDENTITY_OF_MATRIX_H
