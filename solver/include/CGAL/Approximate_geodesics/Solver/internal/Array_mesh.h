// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_MESH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_MESH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

using Array_mesh = Surface_mesh<Simple_cartesian<double>::Point_3>;

/*
 * Builds a mesh from arrays of coordinates and face indices, keeping the numbering. Faces are
 * matched by sorting their sides. A non-manifold element is rejected with a message that names it.
 * `PMP::polygon_soup_to_polygon_mesh()` names none, cannot be interrupted, and does not keep the
 * first corner of a face, to which barycentric coordinates refer.
 */
class Array_mesh_builder
{
  using Vertex = Array_mesh::Vertex_index;
  using Halfedge = Array_mesh::Halfedge_index;
  using Face = Array_mesh::Face_index;

public:
  explicit Array_mesh_builder(Array_mesh& mesh) : m_mesh(mesh) {}

  template <typename Integer>
  void build(const double* const coordinates,
             const std::size_t number_of_vertices,
             const Integer* const corners,
             const std::size_t number_of_faces)
  {
    check_size(number_of_vertices, number_of_faces);
    m_mesh.reserve(static_cast<Array_mesh::size_type>(number_of_vertices),
                   static_cast<Array_mesh::size_type>(3 * number_of_faces / 2),
                   static_cast<Array_mesh::size_type>(number_of_faces));
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      add_vertex(coordinates + 3 * v);
    m_sides.reserve(3 * number_of_faces);
    for(std::size_t f = 0; f < number_of_faces; ++f)
      add_sides(f, corners + 3 * f);
    m_halfedges.resize(m_sides.size());
    sort_sides();
    add_edges();
    for(std::size_t f = 0; f < number_of_faces; ++f)
      add_face(f);
    link_border();
    check_vertices();
  }

private:
  // The side of a face from one of its corners to the next one.
  struct Side
  {
    std::uint32_t low, high; // the end vertices
    std::size_t corner;      // the index of its start among all face corners
    bool goes_up;            // whether it starts at `low`

    bool operator<(const Side& other) const
    {
      return std::tie(low, high, corner) < std::tie(other.low, other.high, other.corner);
    }

    bool is_on_edge_of(const Side& other) const { return low == other.low && high == other.high; }
  };

  static std::string name_of_edge(const Side& side)
  {
    return "the edge between vertices " + std::to_string(side.low) + " and " +
           std::to_string(side.high);
  }

  static std::string name_of_face(const Side& side)
  {
    return "face " + std::to_string(side.corner / 3);
  }

  static void check_size(const std::size_t number_of_vertices, const std::size_t number_of_faces)
  {
    constexpr std::size_t most = (std::numeric_limits<std::uint32_t>::max)() / 6;
    if(number_of_vertices > most || number_of_faces > most)
      throw std::length_error("Approximate_geodesics: the mesh has " +
                              std::to_string(number_of_vertices) + " vertices and " +
                              std::to_string(number_of_faces) +
                              " faces, too many for 32-bit halfedge indices");
  }

  void add_vertex(const double* const p)
  {
    if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      reject("vertex " + std::to_string(m_mesh.number_of_vertices()) + " is not finite: (" +
             text_of(p[0]) + ", " + text_of(p[1]) + ", " + text_of(p[2]) + ")");
    check_for_interruption_at(m_mesh.number_of_vertices());
    m_mesh.add_vertex({p[0], p[1], p[2]});
  }

  template <typename Integer>
  void add_sides(const std::size_t face, const Integer* const corners)
  {
    check_for_interruption_at(face);
    std::array<std::uint32_t, 3> v;
    for(std::size_t i = 0; i < 3; ++i)
    {
      // negative numbers become too large
      if(static_cast<std::uint64_t>(corners[i]) >= m_mesh.number_of_vertices())
        reject("face " + std::to_string(face) + " has vertex " + std::to_string(corners[i]) +
               "; the vertices are numbered from 0, and there are " +
               std::to_string(m_mesh.number_of_vertices()));
      v[i] = static_cast<std::uint32_t>(corners[i]);
    }
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t from = v[i], to = v[(i + 1) % 3];
      if(from == to)
        reject("face " + std::to_string(face) + " has vertex " + std::to_string(from) + " twice");
      m_sides.push_back({(std::min)(from, to), (std::max)(from, to), 3 * face + i, from < to});
    }
  }

  // Counting sort by the lower end, then a comparison sort of each short group.
  void sort_sides()
  {
    std::vector<std::size_t> next(m_mesh.number_of_vertices() + 1, 0);
    for(const Side& side : m_sides)
      ++next[side.low + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Side> sorted(m_sides.size());
    for(const Side& side : m_sides)
      sorted[next[side.low]++] = side;
    m_sides = std::move(sorted);
    auto first = m_sides.begin();
    for(std::size_t v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      check_for_interruption_at(v);
      const auto beyond = m_sides.begin() + static_cast<std::ptrdiff_t>(next[v]);
      std::sort(first, beyond);
      first = beyond;
    }
  }

  void add_edges()
  {
    for(std::size_t i = 0; i < m_sides.size();)
    {
      check_for_interruption_at(m_mesh.number_of_edges());
      const Side& side = m_sides[i];
      const Halfedge up = m_mesh.add_edge(Vertex(side.low), Vertex(side.high));
      const auto link = [&](const Side& s) {
        m_halfedges[s.corner] = s.goes_up ? up : m_mesh.opposite(up);
      };
      link(side);
      if(++i == m_sides.size() || !side.is_on_edge_of(m_sides[i]))
        continue;
      const Side& second = m_sides[i];
      if(++i < m_sides.size() && side.is_on_edge_of(m_sides[i]))
        reject(name_of_edge(side) + " is not manifold: " + name_of_face(side) + ", " +
               name_of_face(second) + " and " + name_of_face(m_sides[i]) + " share it");
      check_second(side, second);
      link(second);
    }
  }

  static void check_second(const Side& first, const Side& second)
  {
    if(first.goes_up == second.goes_up)
      reject(name_of_face(first) + " and " + name_of_face(second) + " traverse " +
             name_of_edge(first) +
             " in the same direction; adjacent faces must have the same "
             "orientation");
  }

  void add_face(const std::size_t number)
  {
    check_for_interruption_at(number);
    const Face face = m_mesh.add_face();
    m_mesh.set_halfedge(face, m_halfedges[3 * number]); // keeps the first corner first
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Halfedge h = m_halfedges[3 * number + i];
      m_mesh.set_face(h, face);
      m_mesh.set_next(h, m_halfedges[3 * number + (i + 1) % 3]);
      m_mesh.set_halfedge(m_mesh.target(h), h);
    }
  }

  // Links border halfedges. A manifold vertex has at most one outgoing border halfedge.
  void link_border()
  {
    std::vector<Halfedge> from(m_mesh.number_of_vertices());
    for(const Halfedge h : m_mesh.halfedges())
    {
      check_for_interruption_at(h);
      if(m_mesh.face(h) == Array_mesh::null_face())
      {
        Halfedge& first = from[m_mesh.source(h)];
        if(first != Array_mesh::null_halfedge())
          reject_vertex(m_mesh.source(h));
        first = h;
      }
    }
    for(const Halfedge h : from)
      if(h != Array_mesh::null_halfedge())
      {
        m_mesh.set_next(h, from[m_mesh.target(h)]);
        m_mesh.set_halfedge(m_mesh.target(h), h);
      }
  }

  // Rotating around a manifold vertex visits all of its edges.
  void check_vertices() const
  {
    std::vector<std::size_t> degree(m_mesh.number_of_vertices(), 0);
    for(const Halfedge h : m_mesh.halfedges())
      ++degree[m_mesh.target(h)];
    for(const Vertex v : m_mesh.vertices())
    {
      check_for_interruption_at(v);
      const Halfedge first = m_mesh.halfedge(v);
      if(first == Array_mesh::null_halfedge())
        continue;
      std::size_t number = 0;
      Halfedge h = first;
      do
      {
        ++number;
        h = m_mesh.opposite(m_mesh.next(h));
      } while(h != first);
      if(number != degree[v])
        reject_vertex(v);
    }
  }

  [[noreturn]] static void reject_vertex(const Vertex v)
  {
    reject("vertex " + std::to_string(static_cast<std::size_t>(v)) +
           " is not manifold: its faces form several groups that share no edge");
  }

  Array_mesh& m_mesh;
  std::vector<Side> m_sides;
  std::vector<Halfedge> m_halfedges; // by corner
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_MESH_H
