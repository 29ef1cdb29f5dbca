#ifndef COMMAND_LINE_MESH_OF_TRIANGLES_H
#define COMMAND_LINE_MESH_OF_TRIANGLES_H

#include <CGAL/Approximate_geodesics/Mesh/Triangle_soup_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

// Sets a halfedge of each vertex, as CGAL does when it adds faces in this order: that of a border,
// or of the last face. Where searches begin at a vertex depends on it, and so do the last bits.
template <typename Mesh, typename Soup, typename Copies>
void set_halfedges_of_vertices(Mesh& result, const Soup& soup, const Copies& copies)
{
  const auto set = [&](const auto h) {
    using Vertex = typename Mesh::Vertex_index;
    result.set_halfedge(Vertex(typename Mesh::size_type(target(h, soup))), copies[h]);
  };
  for(const auto f : faces(soup))
  {
    const auto h = halfedge(f, soup);
    for(const auto side : {h, next(h, soup), prev(h, soup)})
      set(side);
  }
  for(const auto h : halfedges(soup))
    if(face(h, soup) == boost::graph_traits<Soup>::null_face())
      set(h);
}

// Copies a mesh. Each face begins at its first corner.
template <typename Mesh, typename Soup>
Mesh copy_of(const Soup& soup)
{
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Face = typename Mesh::Face_index;
  using Size = typename Mesh::size_type;
  Mesh result;
  result.resize(Size(num_vertices(soup)), Size(num_edges(soup)), Size(num_faces(soup)));
  std::vector<Halfedge> copies(num_halfedges(soup));
  Size number = 0;
  for(const auto e : edges(soup))
    for(const auto h : {halfedge(e, soup), opposite(halfedge(e, soup), soup)})
      copies[h] = Halfedge(number++);
  for(const auto v : vertices(soup))
    result.point(Vertex(Size(v))) = soup.point(v);
  for(const auto h : halfedges(soup))
  {
    const auto f = face(h, soup);
    result.set_target(copies[h], Vertex(Size(target(h, soup))));
    result.set_next(copies[h], copies[next(h, soup)]);
    if(f != boost::graph_traits<Soup>::null_face())
      result.set_face(copies[h], Face(Size(f)));
  }
  set_halfedges_of_vertices(result, soup, copies);
  for(const auto f : faces(soup))
    result.set_halfedge(Face(Size(f)), copies[prev(halfedge(f, soup), soup)]);
  return result;
}

// Makes a mesh of faces that need no repair, in a fraction of the time that a repair takes; of
// others, or of faces that are not triangles, it makes none.
template <typename Mesh, typename Polygons>
std::optional<Mesh> mesh_of_triangles(const std::vector<typename Mesh::Point>& points,
                                      const Polygons& polygons)
{
  using Corner = std::uint32_t;
  using Triangles = std::vector<std::array<Corner, 3>>;
  if(points.size() >= (std::numeric_limits<Corner>::max)())
    return std::nullopt;
  Triangles triangles;
  triangles.reserve(polygons.size());
  for(const auto& polygon : polygons)
  {
    if(polygon.size() != 3)
      return std::nullopt;
    triangles.push_back({Corner(polygon[0]), Corner(polygon[1]), Corner(polygon[2])});
  }
  try
  {
    using Soup = CGAL::Approximate_geodesics::Triangle_soup_mesh<std::vector<typename Mesh::Point>,
                                                                 Triangles>;
    return copy_of<Mesh>(Soup(points, triangles));
  }
  catch(const std::invalid_argument&) // it tells what would have to be repaired
  {
    return std::nullopt;
  }
}

#endif // COMMAND_LINE_MESH_OF_TRIANGLES_H
