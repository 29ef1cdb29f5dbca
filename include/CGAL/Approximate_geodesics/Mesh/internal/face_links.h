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

// Checks that the faces of a mesh and their halfedges refer to each other. Unlike
// `CGAL::is_triangle()`, these functions do not assume that links are valid.

namespace CGAL::Approximate_geodesics::internal {

// Precondition: `f` has a halfedge.
template <typename TriangleMesh>
bool is_linked_triangle(const typename boost::graph_traits<TriangleMesh>::face_descriptor f,
                        const TriangleMesh& tmesh)
{
  const auto first = halfedge(f, tmesh);
  auto h = first;
  for(int i = 0; i < 3; ++i)
  {
    const auto previous = h;
    h = next(h, tmesh);
    if(h == boost::graph_traits<TriangleMesh>::null_halfedge() || face(h, tmesh) != f ||
       prev(h, tmesh) != previous || (h == first) != (i == 2))
      return false;
  }
  return true;
}

// Returns the number of sides of a face, or 0 if its links are invalid.
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

inline std::string name_of_face(const std::size_t i)
{
  return "face " + std::to_string(i) + " (in the order of faces())";
}

// Returns the number of faces. Throws if a face is not a triangle; `place_of(v)` returns the text
// that names a vertex of such a face.
template <typename TriangleMesh, typename PlaceOf>
std::size_t number_of_triangles(const TriangleMesh& tmesh, const PlaceOf place_of)
{
  std::size_t result = 0;
  for(const auto f : faces(tmesh))
  {
    if(halfedge(f, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
      reject(name_of_face(result) + " has no halfedge");
    if(!is_linked_triangle(f, tmesh))
    {
      const std::size_t sides = number_of_sides(f, tmesh);
      reject(name_of_face(result) + place_of(target(halfedge(f, tmesh), tmesh)) +
             (sides == 0 ? " is not linked to its halfedges in both directions"
                         : " is not a triangle: it has " + std::to_string(sides) + " sides"));
    }
    ++result;
  }
  return result;
}

// Whether the links between a border halfedge and the one before it fit. Precondition: there is
// one.
template <typename TriangleMesh>
bool follows_its_predecessor(
    const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
    const TriangleMesh& tmesh)
{
  const auto before = prev(h, tmesh);
  return next(before, tmesh) == h && target(before, tmesh) == source(h, tmesh);
}

template <typename TriangleMesh>
void check_triangles(const TriangleMesh& tmesh)
{
  number_of_triangles(tmesh, [](const auto&) { return ""; });
}

// Precondition: `h` has a face.
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

// Returns all halfedges in the order of `connectivity`, which must be valid.
template <typename TriangleMesh, typename Vertices, typename Connectivity>
auto halfedges_in_groups(const Vertices& vertices,
                         const Connectivity& connectivity,
                         const TriangleMesh& tmesh)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> result;
  result.reserve(connectivity.number_of_halfedges());
  for(typename Connectivity::Index v = 0; v < vertices.size(); ++v)
  {
    auto h = first_halfedge_from(vertices[v], tmesh);
    for(auto left = connectivity.degree(v); left > 0; --left)
    {
      result.push_back(h);
      h = counterclockwise(h, tmesh);
    }
  }
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_FACE_LINKS_H
