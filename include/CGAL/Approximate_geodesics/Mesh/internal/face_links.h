// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_FACE_LINKS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_FACE_LINKS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <vector>

// Navigation on meshes whose links have not been validated, and checks of these links. Unlike
// `CGAL::is_triangle()`, these functions do not assume that links are valid.

namespace CGAL::Approximate_geodesics::internal {

// Returns the number of sides of a face, or 0 if its halfedges are not linked to it and to each
// other in both directions. Precondition: `f` has a halfedge.
template <typename TriangleMesh>
std::size_t number_of_sides(const typename boost::graph_traits<TriangleMesh>::face_descriptor f,
                            const TriangleMesh& tmesh)
{
  const auto first = halfedge(f, tmesh);
  auto h = first;
  std::size_t result = 0;
  do
  {
    const auto previous = h;
    h = next(h, tmesh);
    if(h == boost::graph_traits<TriangleMesh>::null_halfedge() || face(h, tmesh) != f ||
       prev(h, tmesh) != previous) // otherwise the loop may never return to `first`
      return 0;
    ++result;
  } while(h != first);
  return result;
}

template <typename TriangleMesh>
bool is_linked_triangle(const typename boost::graph_traits<TriangleMesh>::face_descriptor f,
                        const TriangleMesh& tmesh)
{
  return halfedge(f, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge() &&
         number_of_sides(f, tmesh) == 3;
}

inline std::string name_of_face(const std::size_t i)
{
  return "face " + std::to_string(i) + " (in the order of faces())";
}

// Throws if a face is not a triangle; `place_of(v)` returns the text that names a vertex of such a
// face.
template <typename TriangleMesh, typename PlaceOf>
void check_triangles(const TriangleMesh& tmesh, const PlaceOf place_of)
{
  std::size_t i = 0;
  for(const auto f : faces(tmesh))
  {
    if(halfedge(f, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
      reject(name_of_face(i) + " has no halfedge");
    const std::size_t sides = number_of_sides(f, tmesh);
    if(sides != 3)
      reject(name_of_face(i) + place_of(target(halfedge(f, tmesh), tmesh)) +
             (sides == 0 ? " is not linked to its halfedges in both directions"
                         : " is not a triangle: it has " + std::to_string(sides) + " sides"));
    ++i;
  }
}

template <typename TriangleMesh>
void check_triangles(const TriangleMesh& tmesh)
{
  check_triangles(tmesh, [](const auto& /* v */) { return ""; });
}

// Whether `h` is one of the first three halfedges of its face. Precondition: `h` has a face.
template <typename TriangleMesh>
bool is_on_cycle_of_face(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                         const TriangleMesh& tmesh)
{
  auto side = halfedge(face(h, tmesh), tmesh);
  for(int i = 0; i < 3 && side != boost::graph_traits<TriangleMesh>::null_halfedge(); ++i)
  {
    if(side == h)
      return true;
    side = next(side, tmesh);
  }
  return false;
}

// Whether the links between a border halfedge and the one before it are valid. Precondition: there
// is one.
template <typename TriangleMesh>
bool follows_its_predecessor(
    const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
    const TriangleMesh& tmesh)
{
  const auto before = prev(h, tmesh);
  return next(before, tmesh) == h && target(before, tmesh) == source(h, tmesh);
}

// Returns the first halfedge from `v`, or a null halfedge if `v` is isolated.
template <typename TriangleMesh>
auto first_halfedge_from(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                         const TriangleMesh& tmesh)
{
  const auto h = halfedge(v, tmesh);
  return h == boost::graph_traits<TriangleMesh>::null_halfedge() ? h : opposite(h, tmesh);
}

// Returns the next halfedge around the source of `h`, or a null halfedge if the mesh is invalid
// there.
template <typename TriangleMesh>
auto counterclockwise(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                      const TriangleMesh& tmesh)
{
  const auto before = prev(h, tmesh);
  return before == boost::graph_traits<TriangleMesh>::null_halfedge() ? before
                                                                      : opposite(before, tmesh);
}

// Returns all halfedges in the order of `connectivity`, which must be valid. Throws if it does not
// belong to the mesh.
template <typename TriangleMesh, typename Vertices, typename Connectivity>
auto halfedges_in_groups(const Vertices& vertices,
                         const Connectivity& connectivity,
                         const TriangleMesh& tmesh)
{
  const auto null = boost::graph_traits<TriangleMesh>::null_halfedge();
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> result;
  result.reserve(connectivity.number_of_halfedges());
  for(typename Connectivity::Index v = 0; v < vertices.size(); ++v)
  {
    const auto first = first_halfedge_from(vertices[v], tmesh);
    auto left = connectivity.degree(v);
    auto h = first;
    if(h != null)
      do
      {
        result.push_back(h);
        h = counterclockwise(h, tmesh);
        --left;
      } while(h != first && h != null && left > 0);
    if(h != first || left != 0)
      reject("the triangulation was not built from this mesh");
  }
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_FACE_LINKS_H
