// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_TRIANGULATION_BUILDER_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_TRIANGULATION_BUILDER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/interruption.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/Connectivity_reader.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/read_face_gauges.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/read_thin_faces.h>
#include <CGAL/Approximate_geodesics/Mesh/read_face_weights.h>
#include <CGAL/Approximate_geodesics/Surface/Directional_cost.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Builds an `Intrinsic_triangulation` from a mesh. `Connectivity_reader` and the functions that
 * read lengths, weights and costs traverse and validate the mesh.
 */
template <typename TriangleMesh, typename NamedParameters>
class Triangulation_builder
{
  using Index = Intrinsic_triangulation::Index;
  using Reader =
      Connectivity_reader<TriangleMesh,
                          decltype(vertex_index_map(std::declval<const TriangleMesh&>(),
                                                    std::declval<const NamedParameters&>())),
                          decltype(halfedge_index_map(std::declval<const TriangleMesh&>(),
                                                      std::declval<const NamedParameters&>()))>;

  static constexpr bool needs_halfedges = is_any_given<NamedParameters,
                                                       internal_np::edge_length_t,
                                                       internal_np::face_weight_t,
                                                       internal_np::edge_is_constrained_t>;

public:
  Triangulation_builder(Intrinsic_triangulation& triangulation,
                        const TriangleMesh& tmesh,
                        const NamedParameters& np)
    : m_result(triangulation),
      m_mesh(tmesh),
      m_np(np),
      m_reader(triangulation, tmesh, vertex_index_map(tmesh, np), halfedge_index_map(tmesh, np))
  {
  }

  void build()
  {
    m_reader.read(needs_halfedges);
    check_for_interruption();
    copy_lengths();
    check_for_interruption();
    copy_weights();
    copy_barriers();
    CGAL_expensive_postcondition(m_result.is_valid());
  }

private:
  void copy_lengths()
  {
    Sharp_corners corners(m_result);
    Edge_lengths lengths = read_edge_lengths(m_mesh, m_reader.vertex_list(),
                                             m_reader.halfedge_list(), m_np, m_result, corners);
    m_result.m_length = std::move(lengths.of_halfedge);
    m_result.m_unit = lengths.unit;
    m_result.m_lines_may_return = is_given<NamedParameters, internal_np::edge_length_t>;
    if(!lengths.points.empty())
      m_result.m_thin_faces = thin_faces(std::move(corners).faces(), lengths.points, m_result);
  }

  void copy_weights()
  {
    if constexpr(has_directional_cost<NamedParameters>)
      copy_directional_costs();
    else if constexpr(is_given<NamedParameters, internal_np::face_weight_t>)
      m_result.set_weights(
          weights_of_faces(m_mesh, m_reader.halfedge_list(),
                           parameters::get_parameter(m_np, internal_np::face_weight), m_result));
  }

  void copy_directional_costs()
  {
    static_assert(!is_given<NamedParameters, internal_np::edge_length_t>,
                  "directional_cost, edge_length_map: directional costs require the lengths of the "
                  "embedding, which is given by the vertex point map");
    const auto& cost = parameters::get_parameter_reference(m_np, internal_np::face_weight);
    const auto point_map = vertex_point_map(m_mesh, m_np);
    m_result.m_gauges = Gauge_reader(m_mesh, m_reader.halfedge_list(), point_map, cost, m_result)
                            .read(sampling_tolerance(m_np));
  }

  void copy_barriers()
  {
    if constexpr(is_given<NamedParameters, internal_np::edge_is_constrained_t>)
    {
      const auto is_constrained = parameters::get_parameter(m_np, internal_np::edge_is_constrained);
      const auto& halfedges = m_reader.halfedge_list();
      std::vector<bool> is_barrier(halfedges.size());
      bool has_any = false;
      for(Index h = 0; h < halfedges.size(); ++h)
        if(!is_border(edge(halfedges[h], m_mesh), m_mesh) &&
           get(is_constrained, edge(halfedges[h], m_mesh)))
          is_barrier[h] = has_any = true;
      if(has_any)
        m_result.m_is_barrier = std::move(is_barrier);
    }
  }

  Intrinsic_triangulation& m_result;
  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  Reader m_reader;
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_TRIANGULATION_BUILDER_H
