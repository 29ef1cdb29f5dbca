// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_PART_H
#define CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_PART_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics::internal {

// Whether mesh elements are hashable.
template <typename Descriptor>
constexpr bool is_hashable = std::is_default_constructible_v<std::hash<Descriptor>>;

/*
 * A map from mesh elements to numbers: a hash table with linear probing. Memory and time depend on
 * the number of entries, not on the size of the mesh. With `std::unordered_map`, which allocates
 * every entry, the path between near points executes 1.3 to 2.3 times as many instructions.
 */
template <typename Descriptor>
class Descriptor_table
{
public:
  Descriptor_table() : m_entries(std::size_t(1) << 10) {}

  // Returns the number of `d`, or `null_index` if there is no entry.
  Index find(const Descriptor& d) const { return m_entries[place_of(d)].number; }

  // Returns the number of `d`; inserts `number` if there is no entry.
  Index find_or_insert(const Descriptor& d, const Index number)
  {
    Entry& entry = m_entries[place_of(d)];
    if(entry.number != null_index)
      return entry.number;
    entry = {d, number};
    if(++m_size > m_entries.size() / 2)
    {
      std::vector<Entry> old(2 * m_entries.size());
      old.swap(m_entries);
      for(const Entry& moved : old)
        if(moved.number != null_index)
          m_entries[place_of(moved.descriptor)] = moved;
    }
    return number;
  }

private:
  struct Entry
  {
    Descriptor descriptor{};
    Index number = null_index;
  };

  // Returns the slot of `d`.
  std::size_t place_of(const Descriptor& d) const
  {
    constexpr std::uint64_t golden_ratio = 0x9E3779B97F4A7C15; // scatters close hash values
    const std::uint64_t hash =
        golden_ratio * static_cast<std::uint64_t>(std::hash<Descriptor>()(d));
    const std::size_t mask = m_entries.size() - 1;
    std::size_t i = static_cast<std::size_t>(hash >> 32) & mask;
    while(m_entries[i].number != null_index && m_entries[i].descriptor != d)
      i = (i + 1) & mask;
    return i;
  }

  std::vector<Entry> m_entries; // the size is a power of two
  std::size_t m_size = 0;
};

/*
 * A submesh: some faces of a mesh and their border, represented by the elements of the mesh. The
 * cost depends on the number of faces; that of `CGAL::Face_filtered_graph` depends on the size of
 * the mesh. The class is a model of `FaceListGraph` and `HalfedgeListGraph`, so parts are read like
 * meshes.
 *
 * A vertex may have several fans of faces. As in a mesh, its halfedges form a single cycle, in the
 * order of the mesh, with border halfedges in the gaps. So paths can pass through the vertex.
 *
 * Faces are added one by one, and `close()` finds the border. Invalid or unusual links make these
 * functions fail; reading the whole mesh then diagnoses the error.
 */
template <typename TriangleMesh>
class Mesh_part
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  // The mesh is referred to, not copied.
  explicit Mesh_part(const TriangleMesh& tmesh) : m_mesh(&tmesh) {}

  // ----- construction

  // Adds a vertex if it is new, and returns its number.
  Index add_vertex(const vertex_descriptor v)
  {
    const Index next = static_cast<Index>(m_vertices.size());
    const Index result = m_number_of_vertex.find_or_insert(v, next);
    if(result == next)
    {
      m_vertices.push_back(v);
      m_halfedge_to.push_back(Graph_traits::null_halfedge());
    }
    return result;
  }

  // Adds the face to the left of `h`. Returns whether its links are valid. Precondition: the face
  // exists and is new.
  bool add_face(const halfedge_descriptor h)
  {
    const face_descriptor f = face(h, *m_mesh);
    if(!is_linked_triangle(f, *m_mesh) || !is_on_cycle_of_face(h, *m_mesh))
      return false;
    m_faces.push_back(f);
    halfedge_descriptor side = h;
    for(int i = 0; i < 3; ++i, side = next(side, *m_mesh))
    {
      const halfedge_descriptor across = opposite(side, *m_mesh);
      const vertex_descriptor v = target(side, *m_mesh);
      if(v == Graph_traits::null_vertex() || across == side || opposite(across, *m_mesh) != side ||
         source(next(side, *m_mesh), *m_mesh) != v || !add_halfedge(side))
        return false;
      m_halfedge_to[add_vertex(v)] = side;
    }
    return true;
  }

  // Finds the border. Returns whether its links are valid.
  bool close()
  {
    m_number_of_sides = m_halfedges.size();
    for(std::size_t i = 0; i < m_number_of_sides; ++i)
      add_halfedge(opposite(m_halfedges[i], *m_mesh));
    const std::size_t size = m_halfedges.size() - m_number_of_sides;
    m_after.assign(size, Graph_traits::null_halfedge());
    m_before.assign(size, Graph_traits::null_halfedge());
    for(std::size_t i = 0; i < size; ++i)
      if(!link_border(i))
        return false;
    return true;
  }

  // ----- numbers; null_index if the element is not in the part

  Index number(const vertex_descriptor v) const { return m_number_of_vertex.find(v); }
  Index number(const halfedge_descriptor h) const { return m_number_of_halfedge.find(h); }

  bool contains(const halfedge_descriptor h) const { return number(h) != null_index; }

  // ----- model of `FaceListGraph` and `HalfedgeListGraph`, after close()

  friend const TriangleMesh& whole(const Mesh_part& part) { return *part.m_mesh; }

  friend const auto& vertices(const Mesh_part& part) { return part.m_vertices; }
  friend const auto& halfedges(const Mesh_part& part) { return part.m_halfedges; }
  friend const auto& faces(const Mesh_part& part) { return part.m_faces; }
  friend std::size_t num_vertices(const Mesh_part& part) { return part.m_vertices.size(); }
  friend std::size_t num_halfedges(const Mesh_part& part) { return part.m_halfedges.size(); }
  friend std::size_t num_faces(const Mesh_part& part) { return part.m_faces.size(); }

  friend halfedge_descriptor halfedge(const vertex_descriptor v, const Mesh_part& part)
  {
    return part.m_halfedge_to[part.number(v)];
  }

  friend halfedge_descriptor halfedge(const face_descriptor f, const Mesh_part& part)
  {
    return halfedge(f, *part.m_mesh);
  }

  friend auto edge(const halfedge_descriptor h, const Mesh_part& part)
  {
    return edge(h, *part.m_mesh);
  }

  friend face_descriptor face(const halfedge_descriptor h, const Mesh_part& part)
  {
    const bool is_side = part.number(h) < part.m_number_of_sides;
    return is_side ? face(h, *part.m_mesh) : Graph_traits::null_face();
  }

  friend vertex_descriptor source(const halfedge_descriptor h, const Mesh_part& part)
  {
    return source(h, *part.m_mesh);
  }

  friend vertex_descriptor target(const halfedge_descriptor h, const Mesh_part& part)
  {
    return target(h, *part.m_mesh);
  }

  friend halfedge_descriptor opposite(const halfedge_descriptor h, const Mesh_part& part)
  {
    return opposite(h, *part.m_mesh);
  }

  friend halfedge_descriptor next(const halfedge_descriptor h, const Mesh_part& part)
  {
    const Index i = part.number(h);
    return i < part.m_number_of_sides ? next(h, *part.m_mesh)
                                      : part.m_after[i - part.m_number_of_sides];
  }

  friend halfedge_descriptor prev(const halfedge_descriptor h, const Mesh_part& part)
  {
    const Index i = part.number(h);
    return i < part.m_number_of_sides ? prev(h, *part.m_mesh)
                                      : part.m_before[i - part.m_number_of_sides];
  }

  friend auto get(const boost::vertex_point_t tag, const Mesh_part& part)
  {
    return get(tag, *part.m_mesh);
  }

  // Its index maps are its own numbers; those in named parameters refer to the whole mesh, and are
  // ignored.
  struct Index_map
  {
    template <typename Descriptor>
    friend Index get(const Index_map& map, const Descriptor d)
    {
      return map.part->number(d);
    }

    const Mesh_part* part;
  };

  template <typename NamedParameters>
  friend Index_map vertex_index_map(const Mesh_part& part, const NamedParameters& /* np */)
  {
    return {&part};
  }

  template <typename NamedParameters>
  friend Index_map halfedge_index_map(const Mesh_part& part, const NamedParameters& /* np */)
  {
    return {&part};
  }

private:
  // Returns whether `h` is new.
  bool add_halfedge(const halfedge_descriptor h)
  {
    const Index number = static_cast<Index>(m_halfedges.size());
    const bool is_new = m_number_of_halfedge.find_or_insert(h, number) == number;
    if(is_new)
      m_halfedges.push_back(h);
    return is_new;
  }

  // Links a border halfedge to its successor: the next halfedge around its target that the part
  // contains. Each step is checked to be invertible, which guarantees termination on invalid
  // meshes.
  bool link_border(const std::size_t i)
  {
    const halfedge_descriptor first = m_halfedges[m_number_of_sides + i];
    halfedge_descriptor h = first, following = Graph_traits::null_halfedge();
    do
    {
      following = next(h, *m_mesh);
      if(following == Graph_traits::null_halfedge() || prev(following, *m_mesh) != h)
        return false;
      h = opposite(following, *m_mesh);
      if(opposite(h, *m_mesh) != following)
        return false;
    } while(!contains(following));
    const Index number_of_following = number(following);
    if(number_of_following < m_number_of_sides)
      return false;
    m_after[i] = following;
    m_before[number_of_following - m_number_of_sides] = first;
    return true;
  }

  const TriangleMesh* m_mesh;
  Descriptor_table<vertex_descriptor> m_number_of_vertex;
  Descriptor_table<halfedge_descriptor> m_number_of_halfedge;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedge_to; // by vertex, with a face; null if isolated
  std::vector<halfedge_descriptor> m_halfedges;   // sides of faces, then border halfedges
  std::vector<face_descriptor> m_faces;
  std::size_t m_number_of_sides = 0;
  std::vector<halfedge_descriptor> m_after, m_before; // by border halfedge
};

template <typename TriangleMesh>
constexpr bool is_part = false;

template <typename TriangleMesh>
constexpr bool is_part<Mesh_part<TriangleMesh>> = true;

/*
 * Positions of vertices and other points of a mesh that has not been read yet, relative to the
 * first vertex that is asked for, which avoids cancellation if the origin is far away.
 */
template <typename TriangleMesh, typename NamedParameters>
class Mesh_positions
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Point_map = decltype(vertex_point_map(std::declval<const TriangleMesh&>(),
                                              std::declval<const NamedParameters&>()));
  using Traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;

public:
  struct Place
  {
    Space_vector position;

    // A halfedge whose face contains the point; null for an isolated vertex.
    halfedge_descriptor halfedge;
    vertex_descriptor isolated_vertex = Graph_traits::null_vertex();
  };

  Mesh_positions(const TriangleMesh& tmesh, const NamedParameters& np)
    : m_mesh(tmesh),
      m_point_map(vertex_point_map(tmesh, np)),
      m_traits(parameters::choose_parameter<Traits>(
          parameters::get_parameter(np, internal_np::geom_traits)))
  {
  }

  Space_vector operator()(const vertex_descriptor v)
  {
    const Space_vector p = double_point(get(m_point_map, v), m_traits);
    if(!m_origin)
      m_origin = p;
    return difference(p, *m_origin);
  }

  // These functions throw `std::invalid_argument` if the point may be invalid.

  Place place(const vertex_descriptor v)
  {
    check(may_be_element(v, Graph_traits::null_vertex(), num_vertices(m_mesh), m_mesh));
    const halfedge_descriptor h = halfedge(v, m_mesh);
    if(h == Graph_traits::null_halfedge())
      return {(*this)(v), h, v};
    check(target(h, m_mesh) == v);
    return {(*this)(v), side_of_edge(h)};
  }

  Place place(const std::pair<halfedge_descriptor, double>& point)
  {
    const auto [h, t] = point;
    check_point(h, t, m_mesh);
    const halfedge_descriptor side = side_of_edge(h);
    const Space_vector start = (*this)(source(h, m_mesh));
    const Space_vector way = difference((*this)(target(h, m_mesh)), start);
    return {linear_combination(start, t, way), side};
  }

  template <typename FT>
  Place place(const std::pair<face_descriptor, std::array<FT, 3>>& location)
  {
    const auto& [f, coordinates] = location;
    const std::array<double, 3> weights = checked_weights(f, coordinates, m_mesh);
    check(is_linked_triangle(f, m_mesh));
    const halfedge_descriptor h = halfedge(f, m_mesh), g = next(h, m_mesh);
    const Space_vector a = (*this)(source(h, m_mesh)), b = (*this)(source(g, m_mesh));
    const Space_vector c = (*this)(target(g, m_mesh));
    const Space_vector on_edge = linear_combination(a, weights[1], difference(b, a));
    return {linear_combination(on_edge, weights[2], difference(c, a)), h};
  }

  Place place(const Surface_point<TriangleMesh>& point)
  {
    return std::visit([this](const auto& p) { return this->place(p); }, point);
  }

private:
  static void check(const bool is_valid)
  {
    if(!is_valid)
      reject("a source or a target may be invalid"); // it is caught
  }

  // Returns a halfedge of the edge of `h` with a face to its left.
  halfedge_descriptor side_of_edge(const halfedge_descriptor h) const
  {
    const halfedge_descriptor side = is_border(h, m_mesh) ? opposite(h, m_mesh) : h;
    check(!is_border(side, m_mesh));
    return side;
  }

  const TriangleMesh& m_mesh;
  Point_map m_point_map;
  Traits m_traits;
  std::optional<Space_vector> m_origin;
};

/*
 * A lower bound on the length of a path through a point in space: the straight-line distance from
 * the nearest source, including its initial distance, and to the target, if there is one.
 */
struct Detour
{
  struct Start
  {
    Space_vector position;
    double distance;
  };

  double over(const Space_vector& p) const
  {
    double result = infinity;
    for(const Start& start : starts)
      result = (std::min)(result, start.distance + accurate_length(difference(p, start.position)));
    return target ? result + accurate_length(difference(p, *target)) : result;
  }

  // Returns a lower bound on the detours of the points of an edge, given those of its ends and its
  // length. Along the edge, the detour is Lipschitz continuous with constant 1, or 2 if there is a
  // target. NaN if values are not finite.
  double on_edge(const double value_1, const double value_2, const double length) const
  {
    const double sum = value_1 + value_2, change = target ? 2 * length : length;
    return (sum - change) / 2 - rounding * (sum + change);
  }

  static constexpr double rounding = 1e-12; // relative, of values and lengths

  std::vector<Start> starts;
  std::optional<Space_vector> target;
  double limit = 0; // on the length of paths
};

/*
 * Finds the part of a mesh with all faces that a path from the sources within the limit may meet.
 *
 * Such a path leaves a face in one of three ways: it crosses an edge at a point whose detour is
 * within the limit; it passes through a vertex, and then all edges around it contain such a point;
 * or it passes through a vertex to another fan of faces across a border, and then the detour of the
 * vertex is within the limit. So faces are entered across edges that may contain such a point, and,
 * at borders, through vertices.
 */
template <typename TriangleMesh, typename Positions>
class Part_growth
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  // All arguments are referred to, not copied. Growth fails beyond `largest_number_of_faces`.
  Part_growth(const TriangleMesh& tmesh,
              Positions& positions,
              const Detour& detour,
              const std::size_t largest_number_of_faces)
    : m_part(tmesh),
      m_mesh(tmesh),
      m_positions(positions),
      m_detour(detour),
      m_largest_number_of_faces(largest_number_of_faces)
  {
  }

  void start_at(const typename Positions::Place& place)
  {
    if(place.halfedge == Graph_traits::null_halfedge())
      m_part.add_vertex(place.isolated_vertex);
    else
      m_entries.push_back(place.halfedge);
  }

  // Returns whether the part is complete and valid, and its lengths are certain not to overflow.
  bool run()
  {
    while(!m_entries.empty())
    {
      const halfedge_descriptor h = m_entries.back();
      m_entries.pop_back();
      if(!m_part.contains(h) && !enter(h))
        return false;
    }
    // an edge is at most as long as the detours of its ends together
    return measure_new_vertices() && m_part.close() &&
           std::isfinite(2 * m_largest_detour * static_cast<double>(num_halfedges(m_part)));
  }

  Mesh_part<TriangleMesh>& part() { return m_part; }

  // Returns a limit up to which the part stays the same; infinity if it is a whole component.
  double next_limit() const { return m_next_limit; }

private:
  struct Vertex
  {
    Space_vector position;
    double detour;
  };

  bool enter(const halfedge_descriptor h)
  {
    if(num_faces(m_part) >= m_largest_number_of_faces || !m_part.add_face(h))
      return false;
    if(!measure_new_vertices())
      return false;
    Vertex from = vertex(source(h, m_mesh));
    halfedge_descriptor side = h;
    for(int i = 0; i < 3; ++i, side = next(side, m_mesh))
    {
      const Vertex to = vertex(target(side, m_mesh));
      const halfedge_descriptor across = opposite(side, m_mesh);
      if(is_border(across, m_mesh))
      {
        // the face across the border at the target of `across` may be met
        const halfedge_descriptor following = next(across, m_mesh);
        if(following == Graph_traits::null_halfedge() ||
           is_border(opposite(following, m_mesh), m_mesh)) // an edge without faces
          return false;
        enter_later(opposite(following, m_mesh), from.detour * (1 - Detour::rounding));
      }
      else
        enter_later(across, m_detour.on_edge(from.detour, to.detour, distance(from, to)));
      from = to;
    }
    return true;
  }

  // Enters the face of `h` if `detour`, a lower bound, is within the limit.
  void enter_later(const halfedge_descriptor h, const double detour)
  {
    if(m_part.contains(h))
      return;
    if(detour > m_detour.limit)
      m_next_limit = (std::min)(m_next_limit, detour);
    else
      m_entries.push_back(h);
  }

  static double distance(const Vertex& a, const Vertex& b)
  {
    return accurate_length(difference(a.position, b.position));
  }

  const Vertex& vertex(const vertex_descriptor v) const { return m_vertices[m_part.number(v)]; }

  // Returns false if a position is not finite.
  bool measure_new_vertices()
  {
    for(std::size_t i = m_vertices.size(); i < num_vertices(m_part); ++i)
    {
      const Space_vector p = m_positions(vertices(m_part)[i]);
      const double detour = m_detour.over(p);
      if(!std::isfinite(detour))
        return false;
      m_vertices.push_back({p, detour});
      m_largest_detour = (std::max)(m_largest_detour, detour);
    }
    return true;
  }

  Mesh_part<TriangleMesh> m_part;
  const TriangleMesh& m_mesh;
  Positions& m_positions;
  const Detour& m_detour;
  const std::size_t m_largest_number_of_faces;
  std::vector<halfedge_descriptor> m_entries; // whose faces will be added
  std::vector<Vertex> m_vertices;             // by number in the part
  double m_largest_detour = 0;
  double m_next_limit = infinity;
};

} // namespace Approximate_geodesics::internal

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

#endif // CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_MESH_PART_H
