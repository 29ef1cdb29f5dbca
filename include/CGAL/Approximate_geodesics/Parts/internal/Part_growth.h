// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_PART_GROWTH_H
#define CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_PART_GROWTH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/face_links.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_part.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A point of the surface of a mesh that has not been read yet.
 */
template <typename TriangleMesh>
struct Mesh_place
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Vertex = typename Graph_traits::vertex_descriptor;

  // The vertices, with weights that add up to 1: one, two on an edge, or three in a face; the last
  // one is repeated with weight 0.
  std::array<Vertex, 3> corner;
  std::array<double, 3> weight;
  std::size_t number_of_corners;

  // A halfedge whose face contains the point; null for an isolated vertex.
  typename Graph_traits::halfedge_descriptor halfedge;
};

// These functions throw `std::invalid_argument` if the point may be invalid.

inline void check_place(const bool is_valid)
{
  if(!is_valid)
    reject("a source or a target may be invalid"); // it is caught
}

// Returns a halfedge of the edge of `h` with a face to its left.
template <typename TriangleMesh>
auto side_of_edge(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                  const TriangleMesh& tmesh)
{
  if(!is_border(h, tmesh))
    return h;
  const auto g = opposite(h, tmesh);
  check_place(!is_border(g, tmesh));
  return g;
}

template <typename TriangleMesh>
Mesh_place<TriangleMesh>
checked_place(const TriangleMesh& tmesh,
              const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  check_place(may_be_element(v, Graph_traits::null_vertex(), num_vertices(tmesh), tmesh));
  const auto h = halfedge(v, tmesh);
  const bool is_isolated = h == Graph_traits::null_halfedge();
  const auto side = is_isolated ? h : side_of_edge(h, tmesh);
  check_place(is_isolated || target(h, tmesh) == v);
  return {{v, v, v}, {1, 0, 0}, 1, side};
}

template <typename TriangleMesh>
Mesh_place<TriangleMesh> checked_place(
    const TriangleMesh& tmesh,
    const std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>& point)
{
  const auto [h, t] = point;
  check_point(h, t, tmesh);
  const auto v = source(h, tmesh), w = target(h, tmesh);
  return {{v, w, w}, {1 - t, t, 0}, 2, side_of_edge(h, tmesh)};
}

template <typename TriangleMesh, typename FT>
Mesh_place<TriangleMesh>
checked_place(const TriangleMesh& tmesh,
              const std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor,
                              std::array<FT, 3>>& location)
{
  const auto& [f, coordinates] = location;
  const std::array<double, 3> weights = checked_weights(f, coordinates, tmesh);
  check_place(is_linked_triangle(f, tmesh));
  const auto h = halfedge(f, tmesh), g = next(h, tmesh);
  return {{source(h, tmesh), source(g, tmesh), source(next(g, tmesh), tmesh)}, weights, 3, h};
}

template <typename TriangleMesh>
Mesh_place<TriangleMesh> checked_place(const TriangleMesh& tmesh,
                                       const Surface_point<TriangleMesh>& point)
{
  return std::visit([&](const auto& p) { return checked_place(tmesh, p); }, point);
}

/*
 * Positions of vertices and other points of a mesh, relative to one of the vertices, which avoids
 * cancellation if the origin is far away.
 */
template <typename TriangleMesh, typename NamedParameters>
class Mesh_positions
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Point_map = decltype(vertex_point_map(std::declval<const TriangleMesh&>(),
                                              std::declval<const NamedParameters&>()));
  using Traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;

public:
  Mesh_positions(const TriangleMesh& tmesh,
                 const NamedParameters& np,
                 const vertex_descriptor origin)
    : m_point_map(vertex_point_map(tmesh, np)),
      m_traits(parameters::choose_parameter<Traits>(
          parameters::get_parameter(np, internal_np::geom_traits))),
      m_origin(double_point(get(m_point_map, origin), m_traits))
  {
  }

  Space_vector operator()(const vertex_descriptor v) const
  {
    return difference(double_point(get(m_point_map, v), m_traits), m_origin);
  }

  Space_vector operator()(const Mesh_place<TriangleMesh>& place) const
  {
    const Space_vector first = (*this)(place.corner[0]);
    Space_vector result = first;
    for(std::size_t i = 1; i < place.number_of_corners; ++i)
      result =
          linear_combination(result, place.weight[i], difference((*this)(place.corner[i]), first));
    return result;
  }

private:
  Point_map m_point_map;
  Traits m_traits;
  Space_vector m_origin;
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
    double result = std::numeric_limits<double>::infinity();
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
              const Positions& positions,
              const Detour& detour,
              const std::size_t largest_number_of_faces)
    : m_part(tmesh),
      m_mesh(tmesh),
      m_positions(positions),
      m_detour(detour),
      m_largest_number_of_faces(largest_number_of_faces)
  {
  }

  void start_at(const Mesh_place<TriangleMesh>& place)
  {
    if(place.halfedge == Graph_traits::null_halfedge())
      m_part.add_vertex(place.corner[0]);
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
    return measure_new_vertices() && m_part.close() && do_lengths_fit();
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
        if(!follow_border(across, from))
          return false;
      }
      else
        enter_later(across, m_detour.on_edge(from.detour, to.detour, distance(from, to)));
      from = to;
    }
    return true;
  }

  // Enters the face across the border at the target of `h`. Returns false if links are invalid.
  bool follow_border(const halfedge_descriptor h, const Vertex& end)
  {
    const halfedge_descriptor following = next(h, m_mesh);
    if(following == Graph_traits::null_halfedge())
      return false;
    const halfedge_descriptor across = opposite(following, m_mesh);
    if(is_border(across, m_mesh))
      return false; // an edge without faces
    enter_later(across, end.detour * (1 - Detour::rounding));
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

  // An edge is at most as long as the detours of its ends together.
  bool do_lengths_fit() const
  {
    return std::isfinite(2 * m_largest_detour * static_cast<double>(num_halfedges(m_part)));
  }

  Mesh_part<TriangleMesh> m_part;
  const TriangleMesh& m_mesh;
  const Positions& m_positions;
  const Detour& m_detour;
  const std::size_t m_largest_number_of_faces;
  std::vector<halfedge_descriptor> m_entries; // whose faces will be added
  std::vector<Vertex> m_vertices;             // by number in the part
  double m_largest_detour = 0;
  double m_next_limit = std::numeric_limits<double>::infinity();
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_PART_GROWTH_H
