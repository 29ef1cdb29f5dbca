// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_LINKS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_LINKS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Surface/internal/triangulation_arrays.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
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
  for(Index v = 0; v < vertices.size(); ++v)
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

/*
 * Reads and validates the connectivity of a mesh, in the order of the mesh's own indices. This is
 * the only reader; it serves whole meshes and parts, with any index maps. It reports success or
 * failure, and diagnoses failures on request.
 *
 * Links are copied to a compact array. Rotating around vertices on the mesh itself would cause a
 * cache miss per step; sequential copying is prefetched by the hardware. Faces are checked in
 * memory order for the same reason. Indices of removed elements are gaps in the array.
 *
 * The class does not depend on named parameters, so it is instantiated once per mesh type and index
 * maps.
 */
template <typename TriangleMesh, typename VertexIndexMap, typename HalfedgeIndexMap>
class Mesh_links
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;

  // The mesh is referred to, not copied. Throws `std::length_error` if it is too large.
  Mesh_links(const TriangleMesh& tmesh,
             VertexIndexMap vertex_index_map,
             HalfedgeIndexMap halfedge_index_map)
    : m_mesh(tmesh),
      m_number_of_vertices(num_vertices(tmesh)),
      m_number_of_halfedges(num_halfedges(tmesh)),
      m_vertex_index_map(std::move(vertex_index_map)),
      m_halfedge_index_map(std::move(halfedge_index_map))
  {
    if(m_number_of_halfedges >= null_index || m_number_of_vertices >= null_index)
      throw std::length_error("Approximate_geodesics: the mesh has " +
                              std::to_string(m_number_of_vertices) + " vertices and " +
                              std::to_string(m_number_of_halfedges) +
                              " halfedges, too many for 32-bit indices");
  }

  // Reads all links. Returns whether they are valid, all faces are triangles, and indices are
  // unique. Polygon meshes fail before memory is allocated.
  bool read()
  {
    return read_faces() && list_vertices() && link_halfedges() && are_links_complete() &&
           3 * m_number_of_faces == m_number_of_sides;
  }

  // By index; null vertices where the mesh has removed vertices.
  std::vector<vertex_descriptor>& vertex_list() { return m_vertices; }

  bool has_removed_vertices() const { return m_has_removed_vertices; }

  // Returns the index of a vertex of the mesh.
  Index index(const vertex_descriptor v) const
  {
    return static_cast<Index>(get(m_vertex_index_map, v));
  }

  // The following functions return whether the halfedges from each vertex form a single cycle. One
  // of them may be called, once, after read().

  // Writes what a search along edges requires.
  bool write_adjacency(Vertex_adjacency& result) { return write_groups<false>(result); }

  bool write(Connectivity& result)
  {
    result.number_of_faces = m_number_of_faces;
    if(!write_groups<true>(result))
      return false;
    result.opposite_rank.resize(result.number_of_halfedges());
    for(const halfedge_descriptor h : halfedges(m_mesh))
    {
      const Link link = m_links[index(h)], across = m_links[index(opposite(h, m_mesh))];
      const Index number = result.first_halfedge(across.target) + link.counterclockwise;
      result.opposite_rank.set(number, across.counterclockwise);
    }
    for(const halfedge_descriptor h : m_border)
    {
      const Index source = m_links[index(opposite(h, m_mesh))].target;
      result.border.push_back({source, m_links[index(h)].counterclockwise});
    }
    m_links = std::vector<Link>(); // frees its memory
    return true;
  }

  // Diagnoses a mesh that was refused: throws an exception that names the first invalid element.
  // Reads the mesh step by step, and follows no link before it is checked.
  [[noreturn]] void reject_mesh()
  {
    check_triangles(m_mesh, [this](const vertex_descriptor v) { return ", at " + name(v) + ','; });
    m_vertices.assign(m_number_of_vertices, Graph_traits::null_vertex());
    m_halfedges.assign(m_number_of_halfedges, Graph_traits::null_halfedge());
    for(const vertex_descriptor v : vertices(m_mesh))
      list(v);
    for(const vertex_descriptor v : vertices(m_mesh))
      check_cycle(v);
    for(const halfedge_descriptor h : m_halfedges)
      if(h != Graph_traits::null_halfedge())
        check_opposite(h);
    check_that_vertices_know_faces();
    for(const halfedge_descriptor h : halfedges(m_mesh))
      check_side(h);
    reject("there are halfedges with a face that is not in faces()");
  }

private:
  // The target of a halfedge, and the next halfedge counterclockwise around its source.
  struct Link
  {
    Index target;
    Index counterclockwise;
  };

  // Returns an invalid index, which is not less than the size, for a null vertex.
  std::size_t checked_index(const vertex_descriptor v) const
  {
    return v == Graph_traits::null_vertex() ? std::size_t(null_index)
                                            : static_cast<std::size_t>(get(m_vertex_index_map, v));
  }

  std::size_t index(const halfedge_descriptor h) const // unchecked
  {
    return static_cast<std::size_t>(get(m_halfedge_index_map, h));
  }

  // Counts the faces. Returns whether all are triangles.
  bool read_faces()
  {
    for(const face_descriptor f : faces(m_mesh))
    {
      if(!is_linked_triangle(f, m_mesh))
        return false;
      const halfedge_descriptor h = halfedge(f, m_mesh), g = next(h, m_mesh), k = next(g, m_mesh);
      if(target(h, m_mesh) != source(g, m_mesh) || target(g, m_mesh) != source(k, m_mesh) ||
         target(k, m_mesh) != source(h, m_mesh))
        return false;
      ++m_number_of_faces;
    }
    return true;
  }

  // Returns false if an index is out of range, or a duplicate.
  bool list_vertices()
  {
    reserve_huge_pages(m_vertices, m_number_of_vertices);
    m_vertices.assign(m_number_of_vertices, Graph_traits::null_vertex());
    std::size_t number = 0;
    for(const vertex_descriptor v : vertices(m_mesh))
    {
      const std::size_t i = checked_index(v);
      if(i >= m_number_of_vertices || m_vertices[i] != Graph_traits::null_vertex())
        return false;
      m_vertices[i] = v;
      ++number;
    }
    m_has_removed_vertices = number < m_number_of_vertices;
    return true;
  }

  bool link_halfedges()
  {
    reserve_huge_pages(m_links, m_number_of_halfedges);
    m_links.assign(m_number_of_halfedges, {null_index, null_index});
    resize_in_huge_pages(m_first_of_vertex, m_number_of_vertices + 1);
    std::size_t number = 0;
    for(const halfedge_descriptor h : halfedges(m_mesh))
    {
      const bool is_on_border = is_border(h, m_mesh);
      if(!link(h) || (is_on_border && !follows_its_predecessor(h, m_mesh)))
        return false;
      ++number;
      if(is_on_border)
        m_border.push_back(h);
    }
    m_has_removed_halfedges = number < m_number_of_halfedges;
    m_number_of_sides = number - m_border.size();
    std::partial_sum(m_first_of_vertex.begin(), m_first_of_vertex.end(), m_first_of_vertex.begin());
    return true;
  }

  // Returns false if the links of `h` are invalid, if an index is out of range, or if the index of
  // `h` is a duplicate, that is, its link already has a target.
  bool link(const halfedge_descriptor h)
  {
    const halfedge_descriptor before = prev(h, m_mesh);
    if(before == Graph_traits::null_halfedge())
      return false;
    const std::size_t i = index(h), counterclockwise = index(opposite(before, m_mesh));
    const std::size_t v = checked_index(target(h, m_mesh));
    if(i >= m_number_of_halfedges || counterclockwise >= m_number_of_halfedges ||
       v >= m_number_of_vertices || opposite(opposite(h, m_mesh), m_mesh) != h ||
       m_links[i].target != null_index)
      return false;
    m_links[i] = {static_cast<Index>(v), static_cast<Index>(counterclockwise)};
    ++m_first_of_vertex[v + 1]; // in-degree equals out-degree
    return true;
  }

  // Whether no link leads to a removed halfedge.
  bool are_links_complete() const
  {
    if(m_has_removed_halfedges)
      for(const halfedge_descriptor h : halfedges(m_mesh))
      {
        const std::size_t across = index(opposite(h, m_mesh));
        if(across >= m_number_of_halfedges || m_links[across].target == null_index ||
           m_links[m_links[index(h)].counterclockwise].target == null_index)
          return false;
      }
    return true;
  }

  // Returns the index of the first halfedge from a vertex, or `null_index` if there is none or it
  // is invalid.
  Index first_halfedge(const Index v) const
  {
    const bool is_removed = m_vertices[v] == Graph_traits::null_vertex();
    const halfedge_descriptor toward =
        is_removed ? Graph_traits::null_halfedge() : halfedge(m_vertices[v], m_mesh);
    if(toward == Graph_traits::null_halfedge())
      return null_index;
    const std::size_t i = index(toward), result = index(opposite(toward, m_mesh));
    const bool is_right = i < m_links.size() && result < m_links.size() && m_links[i].target == v;
    return is_right ? static_cast<Index>(result) : null_index;
  }

  // Prefetches the link of a halfedge at the vertex with index `v`, if there is one.
  void prefetch_link_of(const std::size_t v) const
  {
    if(v < m_vertices.size() && m_vertices[v] != Graph_traits::null_vertex())
      if(const halfedge_descriptor h = halfedge(m_vertices[v], m_mesh);
         h != Graph_traits::null_halfedge())
        prefetch(m_links.data(), index(h));
  }

  // If `keeps_ranks`, replaces each counterclockwise link by the rank of the halfedge around its
  // source.
  template <bool keeps_ranks>
  bool write_groups(Vertex_adjacency& result)
  {
    result.first_of_vertex = std::move(m_first_of_vertex);
    resize_in_huge_pages(result.target_of_halfedge, result.number_of_halfedges());
    for(Index v = 0; v < result.number_of_vertices(); ++v)
    {
      prefetch_link_of(v + 16);
      const Index first = first_halfedge(v);
      if((first == null_index) != (result.degree(v) == 0) ||
         !write_cycle<keeps_ranks>(m_links.data(), first, v, result))
        return false;
    }
    return true;
  }

  // Returns whether all halfedges from `v` form a single cycle. The halfedges of a cycle share
  // their source.
  template <bool keeps_ranks>
  static bool
  write_cycle(Link* const links, const Index first, const Index v, Vertex_adjacency& result)
  {
    Index* const target = result.target_of_halfedge.data(); // stays in a register
    const Index begin = result.first_halfedge(v), degree = result.degree(v);
    Index h = first;
    for(Index rank = 0; rank < degree; ++rank)
    {
      Link& link = links[h];
      target[begin + rank] = link.target;
      h = link.counterclockwise;
      if constexpr(keeps_ranks)
        link.counterclockwise = rank;
      if((h == first) != (rank + 1 == degree))
        return false;
    }
    return true;
  }

  // ----- diagnosis

  std::size_t number(const vertex_descriptor v) const
  {
    if(v == Graph_traits::null_vertex())
      reject("a halfedge of the mesh has no vertex");
    return number_below(m_number_of_vertices, get(m_vertex_index_map, v), "vertex");
  }

  std::size_t number(const halfedge_descriptor h) const
  {
    return number_below(m_number_of_halfedges, get(m_halfedge_index_map, h), "halfedge");
  }

  template <typename I>
  static std::size_t number_below(const std::size_t size, const I i, const std::string& kind)
  {
    if(static_cast<std::size_t>(i) >= size) // also negative ones
      reject(kind + " index " + std::to_string(i) + " is out of range: it must be less than " +
             std::to_string(size));
    return static_cast<std::size_t>(i);
  }

  std::string name(const vertex_descriptor v) const
  {
    return "vertex " + std::to_string(number(v));
  }

  std::string name(const halfedge_descriptor h) const
  {
    return "the halfedge from " + name(source(h, m_mesh)) + " to " + name(target(h, m_mesh));
  }

  void list(const vertex_descriptor v)
  {
    vertex_descriptor& listed = m_vertices[number(v)];
    if(listed != Graph_traits::null_vertex())
      reject("vertex index " + std::to_string(number(v)) + " is assigned to more than one vertex");
    listed = v;
  }

  // Lists the halfedges from `v`, which must form a single cycle.
  void check_cycle(const vertex_descriptor v)
  {
    const halfedge_descriptor first = first_halfedge_from(v, m_mesh);
    halfedge_descriptor h = first;
    if(h != Graph_traits::null_halfedge())
      do
      {
        if(h == Graph_traits::null_halfedge() || source(h, m_mesh) != v)
          reject_halfedges_around(v);
        halfedge_descriptor& listed = m_halfedges[number(h)];
        if(listed != Graph_traits::null_halfedge())
          reject_halfedges_around(v);
        listed = h;
        if(m_vertices[number(target(h, m_mesh))] != target(h, m_mesh))
          reject(name(h) + " leads to a vertex that is not in vertices()");
        h = counterclockwise(h, m_mesh);
      } while(h != first);
  }

  // Every opposite halfedge must be found around its source.
  void check_opposite(const halfedge_descriptor h) const
  {
    const halfedge_descriptor across = opposite(h, m_mesh);
    if(m_halfedges[number(across)] != across || opposite(across, m_mesh) != h)
      reject_halfedges_around(target(h, m_mesh));
  }

  [[noreturn]] void reject_halfedges_around(const vertex_descriptor v) const
  {
    reject("the halfedges around " + name(v) +
           " do not form one cycle, or their indices are not unique");
  }

  void check_that_vertices_know_faces() const
  {
    std::size_t number_of_face = 0;
    for(const face_descriptor f : faces(m_mesh))
    {
      for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        if(m_halfedges[number(h)] == Graph_traits::null_halfedge())
          reject(name_of_face(number_of_face) + " is not found around " + name(source(h, m_mesh)));
      ++number_of_face;
    }
  }

  // Checks that halfedges with a face are on the cycle of that face, and the others on a border.
  void check_side(const halfedge_descriptor h) const
  {
    if(m_halfedges[number(h)] != h)
      reject(name(h) + " is not found around its source, or its index is not unique");
    if(is_border(h, m_mesh) && !follows_its_predecessor(h, m_mesh))
      reject(name(h) + " is on the border, but does not follow the halfedge before it");
    if(!is_border(h, m_mesh) && !is_on_cycle_of_face(h, m_mesh))
      reject(name(h) + " has a face, but is not on the cycle of that face");
  }

  const TriangleMesh& m_mesh;
  const std::size_t m_number_of_vertices; // cached: num_vertices() may be linear
  const std::size_t m_number_of_halfedges;
  const VertexIndexMap m_vertex_index_map;
  const HalfedgeIndexMap m_halfedge_index_map;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges; // found around vertices, for reject_mesh() only
  std::vector<Link> m_links;            // by index; without a target if the halfedge was removed
  std::vector<Index> m_first_of_vertex; // prefix sums of degrees
  std::vector<halfedge_descriptor> m_border;
  std::size_t m_number_of_faces = 0;
  std::size_t m_number_of_sides = 0; // halfedges that refer to a face
  bool m_has_removed_vertices = false;
  bool m_has_removed_halfedges = false;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_LINKS_H
