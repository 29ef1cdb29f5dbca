// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SEARCH_PART_ONCE_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SEARCH_PART_ONCE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_part.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Part_to_read.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Vertex_results.h>
#include <CGAL/Approximate_geodesics/Queries/internal/with_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Calls `f` with a search of a part, as `search_once()` does. Returns false if the part is invalid;
// reading the whole mesh then diagnoses the error.
template <typename TriangleMesh, typename NamedParameters, typename F>
bool search_part_once(const Mesh_part<TriangleMesh>& part,
                      const NamedParameters& np,
                      const bool finds_path,
                      F f)
{
  Intrinsic_triangulation triangulation;
  Triangulation_builder<Mesh_part<TriangleMesh>, NamedParameters> builder(triangulation, part, np);
  if(!builder.try_to_build() ||
     triangulation.face_without_shape() != Intrinsic_triangulation::null_index)
    return false;
  with_graph_on<Lazy_discrete_geodesic_graph, Saddle_vertex_graph>(
      std::move(triangulation), np,
      [&](const auto& graph) { search_graph(graph, part, np, finds_path, f); });
  return true;
}

/*
 * Maps the vertices of the whole mesh to nodes of a part. Vertices outside the part have no node.
 */
template <typename Translation>
class Whole_translation
{
  using Part = typename Translation::Triangle_mesh;

public:
  using Triangle_mesh = typename Part::Triangle_mesh;
  using vertex_descriptor = typename Part::vertex_descriptor;
  using Index = typename Part::Index;

  explicit Whole_translation(const Translation& translation) : m_translation(translation) {}

  const Triangle_mesh& mesh() const { return whole(m_translation.mesh()); }

  Index node(const vertex_descriptor v) const
  {
    const bool is_in_part = m_translation.mesh().number(v) != Part::null_index;
    return is_in_part ? m_translation.node(v) : Part::null_index;
  }

  vertex_descriptor vertex(const Index node) const { return m_translation.vertex(node); }

private:
  const Translation& m_translation;
};

// Finds the part of the mesh that contains a path from the nearest source to `target`, and calls
// `f` with a search of it. Returns false if the part cannot be determined without reading the whole
// mesh.
template <typename TriangleMesh,
          typename Sources,
          typename Target,
          typename NamedParameters,
          typename F>
bool search_part_between([[maybe_unused]] const TriangleMesh& tmesh,
                         [[maybe_unused]] const Sources& sources,
                         [[maybe_unused]] const Target& target,
                         [[maybe_unused]] const NamedParameters& np,
                         [[maybe_unused]] F f)
{
  if constexpr(may_read_part<TriangleMesh, NamedParameters>())
    if(const auto part = Part_to_read(tmesh, np).between(sources, target))
      return search_part_once(*part, np, true, f);
  return false;
}

// Writes the results of a search of the part within the maximum distance. Returns false if the part
// cannot be determined without reading the whole mesh.
template <typename TriangleMesh,
          typename VertexDistanceMap,
          typename Sources,
          typename NamedParameters>
bool write_distances_of_part([[maybe_unused]] const TriangleMesh& tmesh,
                             [[maybe_unused]] VertexDistanceMap distances,
                             [[maybe_unused]] const Sources& sources,
                             [[maybe_unused]] const NamedParameters& np)
{
  if constexpr(may_read_part<TriangleMesh, NamedParameters>() &&
               is_given<NamedParameters, internal_np::maximum_distance_t> &&
               !is_given<NamedParameters, internal_np::targets_t>)
    if(const auto part = Part_to_read(tmesh, np).around(sources))
      return search_part_once(*part, np, false, [&](auto& search) {
        search.run_from(sources, np);
        Vertex_results(search.search().search(), Whole_translation(search.translation()))
            .write(distances, np);
      });
  return false;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SEARCH_PART_ONCE_H
