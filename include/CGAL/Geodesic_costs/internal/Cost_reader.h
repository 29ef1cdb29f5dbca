// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_COST_READER_H
#define CGAL_GEODESIC_COSTS_INTERNAL_COST_READER_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_costs/internal/Face_gauges.h>
#include <CGAL/Geodesic_costs/internal/Slope_limit.h>
#include <CGAL/Geodesic_costs/internal/cost_formulas.h>
#include <CGAL/Geodesic_costs/read_face_weights.h>
#include <CGAL/property_map.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Reads the weights, or the gauges, and the barriers of a triangulation whose lengths are known.
 */
template <typename TriangleMesh, typename NamedParameters>
class Cost_reader
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Halfedges = std::vector<typename Graph_traits::halfedge_descriptor>;

public:
  // `halfedges` has the order of the triangulation.
  Cost_reader(Intrinsic_triangulation& triangulation,
              const TriangleMesh& tmesh,
              const Halfedges& halfedges,
              const NamedParameters& np)
    : m_result(triangulation), m_mesh(tmesh), m_halfedges(halfedges), m_np(np)
  {
  }

  void read()
  {
    if constexpr(has_directional_cost<NamedParameters>)
      read_gauges();
    else if constexpr(is_given<NamedParameters, internal_np::face_weight_t>)
      m_result.set_weights(
          weights_of_faces(m_mesh, m_halfedges,
                           parameters::get_parameter(m_np, internal_np::face_weight), m_result));
    if constexpr(is_given<NamedParameters, internal_np::edge_is_constrained_t>)
      read_barriers();
  }

private:
  void read_gauges()
  {
    static_assert(!is_given<NamedParameters, internal_np::edge_length_t>,
                  "directional_cost, max_slope, edge_length_map: costs by direction require the "
                  "lengths of the embedding, which is given by the vertex point map");
    const auto& cost = cost_function();
    const auto point_map = vertex_point_map(m_mesh, m_np);
    auto gauges = std::make_shared<const Face_gauges>(
        Gauge_reader(m_mesh, m_halfedges, point_map, cost, m_result)
            .read(slope_limit(m_np), sampling_tolerance(m_np)));
    std::vector<bool> is_forbidden(m_halfedges.size());
    for(Index h = 0; h < m_halfedges.size(); ++h)
      is_forbidden[h] = !m_result.is_border(h) && gauges->is_forbidden(gauges->face(h));
    m_result.m_is_forbidden = std::move(is_forbidden);
    m_result.m_memory_of_gauges = gauges->memory();
    m_result.m_gauges = std::move(gauges);
  }

  // Returns a function of faces and directions; without one, that of weights, or of lengths.
  decltype(auto) cost_function() const
  {
    if constexpr(has_cost_function<NamedParameters>)
      return parameters::get_parameter_reference(m_np, internal_np::face_weight);
    else if constexpr(is_given<NamedParameters, internal_np::face_weight_t>)
      return Weight_cost(parameters::get_parameter(m_np, internal_np::face_weight));
    else
      return Weight_cost(Constant_property_map<typename Graph_traits::face_descriptor, double>(1));
  }

  void read_barriers()
  {
    const auto is_constrained = parameters::get_parameter(m_np, internal_np::edge_is_constrained);
    std::vector<bool> is_barrier(m_halfedges.size());
    bool has_any = false;
    for(Index h = 0; h < m_halfedges.size(); ++h)
      if(!is_border(edge(m_halfedges[h], m_mesh), m_mesh) &&
         get(is_constrained, edge(m_halfedges[h], m_mesh)))
        is_barrier[h] = has_any = true;
    if(has_any)
      m_result.m_is_barrier = std::move(is_barrier);
  }

  Intrinsic_triangulation& m_result;
  const TriangleMesh& m_mesh;
  const Halfedges& m_halfedges;
  const NamedParameters& m_np;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_COST_READER_H
