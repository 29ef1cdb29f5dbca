// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_PART_AS_MESH_H
#define CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_PART_AS_MESH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_part.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <vector>

// Makes `Mesh_part` a model of `FaceListGraph` and `HalfedgeListGraph`. Its index maps are its own
// numbers; index maps in the named parameters refer to the whole mesh and are ignored.

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {
namespace parts {

template <typename TriangleMesh>
using Vertex_of = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

template <typename TriangleMesh>
using Halfedge_of = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

template <typename TriangleMesh>
using Face_of = typename boost::graph_traits<TriangleMesh>::face_descriptor;

template <typename TriangleMesh>
const std::vector<Vertex_of<TriangleMesh>>& vertices(const Mesh_part<TriangleMesh>& part)
{
  return part.list_of_vertices();
}

template <typename TriangleMesh>
const std::vector<Halfedge_of<TriangleMesh>>& halfedges(const Mesh_part<TriangleMesh>& part)
{
  return part.list_of_halfedges();
}

template <typename TriangleMesh>
const std::vector<Face_of<TriangleMesh>>& faces(const Mesh_part<TriangleMesh>& part)
{
  return part.list_of_faces();
}

template <typename TriangleMesh>
auto num_vertices(const Mesh_part<TriangleMesh>& part)
{
  return part.list_of_vertices().size();
}

template <typename TriangleMesh>
auto num_halfedges(const Mesh_part<TriangleMesh>& part)
{
  return part.list_of_halfedges().size();
}

template <typename TriangleMesh>
auto num_faces(const Mesh_part<TriangleMesh>& part)
{
  return part.list_of_faces().size();
}

template <typename TriangleMesh>
auto halfedge(const Vertex_of<TriangleMesh> v, const Mesh_part<TriangleMesh>& part)
{
  return part.halfedge_to(v);
}

template <typename TriangleMesh>
auto halfedge(const Face_of<TriangleMesh> f, const Mesh_part<TriangleMesh>& part)
{
  return halfedge(f, part.mesh());
}

template <typename TriangleMesh>
auto edge(const Halfedge_of<TriangleMesh> h, const Mesh_part<TriangleMesh>& part)
{
  return edge(h, part.mesh());
}

template <typename TriangleMesh>
auto face(const Halfedge_of<TriangleMesh> h, const Mesh_part<TriangleMesh>& part)
{
  return part.face_of(h);
}

template <typename TriangleMesh>
auto source(const Halfedge_of<TriangleMesh> h, const Mesh_part<TriangleMesh>& part)
{
  return source(h, part.mesh());
}

template <typename TriangleMesh>
auto target(const Halfedge_of<TriangleMesh> h, const Mesh_part<TriangleMesh>& part)
{
  return target(h, part.mesh());
}

template <typename TriangleMesh>
auto opposite(const Halfedge_of<TriangleMesh> h, const Mesh_part<TriangleMesh>& part)
{
  return opposite(h, part.mesh());
}

template <typename TriangleMesh>
auto next(const Halfedge_of<TriangleMesh> h, const Mesh_part<TriangleMesh>& part)
{
  return part.after(h);
}

template <typename TriangleMesh>
auto prev(const Halfedge_of<TriangleMesh> h, const Mesh_part<TriangleMesh>& part)
{
  return part.before(h);
}

template <typename TriangleMesh>
auto get(const boost::vertex_point_t tag, const Mesh_part<TriangleMesh>& part)
{
  return get(tag, part.mesh());
}

// ----- index maps

template <typename TriangleMesh>
struct Part_index_map
{
  const Mesh_part<TriangleMesh>* part;
};

template <typename TriangleMesh, typename Descriptor>
auto get(const Part_index_map<TriangleMesh>& map, const Descriptor d)
{
  return map.part->number(d);
}

template <typename TriangleMesh, typename NamedParameters>
auto vertex_index_map(const Mesh_part<TriangleMesh>& part, const NamedParameters& /* np */)
{
  return Part_index_map<TriangleMesh>{&part};
}

template <typename TriangleMesh, typename NamedParameters>
auto halfedge_index_map(const Mesh_part<TriangleMesh>& part, const NamedParameters& /* np */)
{
  return Part_index_map<TriangleMesh>{&part};
}

// The mesh whose descriptors the part uses.
template <typename TriangleMesh>
const TriangleMesh& whole(const Mesh_part<TriangleMesh>& part)
{
  return part.mesh();
}

} // namespace parts
} // namespace internal
} // namespace Approximate_geodesics

template <typename TriangleMesh, typename Tag>
struct graph_has_property<Approximate_geodesics::internal::Mesh_part<TriangleMesh>, Tag>
  : graph_has_property<TriangleMesh, Tag>
{
};

} // namespace CGAL

namespace boost {

template <typename TriangleMesh>
struct graph_traits<CGAL::Approximate_geodesics::internal::Mesh_part<TriangleMesh>>
  : graph_traits<TriangleMesh>
{
};

template <typename TriangleMesh, typename Tag>
struct property_map<CGAL::Approximate_geodesics::internal::Mesh_part<TriangleMesh>, Tag>
  : property_map<TriangleMesh, Tag>
{
};

} // namespace boost

#endif // CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_PART_AS_MESH_H
