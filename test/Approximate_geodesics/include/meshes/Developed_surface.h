// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_DEVELOPED_SURFACE_H
#define APPROXIMATE_GEODESICS_TEST_DEVELOPED_SURFACE_H

#include "meshes/surface_points.h"
#include "oracles/long_double_distances.h"

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace geodesics_test {

// A point of the plane that some part of a surface is laid out in, and the number of that plane.
struct Place
{
  Long x, y;
  Long plane = 0;
};

inline Long distance_in_plane(const Place& p, const Place& q)
{
  return std::hypot(p.x - q.x, p.y - q.y);
}

/*
 * A surface that is known by how its faces are laid out in planes: its distances have a closed
 * form. It needs no embedding in space: lengths are those in the plane.
 */
struct Developed_surface
{
  using Corners = std::array<Place, 3>;
  using Distance = std::function<Long(const Place&, const Place&)>;

  void add(const std::array<std::size_t, 3>& triangle, const Corners& corners)
  {
    const auto& [a, b, c] = corners;
    if(!((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0))
      throw std::logic_error("the fixture has a face that is not counterclockwise");
    soup.triangles.push_back(triangle);
    places.push_back(corners);
  }

  Soup soup; // its points mean nothing unless it is embedded
  std::vector<Corners> places;
  Distance distance;
  bool is_embedded = false;
};

// The lengths of the edges of its mesh, by index.
inline std::vector<double> lengths_of(const Developed_surface& surface, const Mesh& mesh)
{
  std::vector<double> result(mesh.num_edges());
  for(const Face f : mesh.faces())
  {
    Halfedge h = mesh.halfedge(f);
    const auto& p = surface.places[f.idx()];
    for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
      result[mesh.edge(h).idx()] = static_cast<double>(distance_in_plane(p[i], p[(i + 1) % 3]));
  }
  return result;
}

inline Triangulation triangulation_of(const Developed_surface& surface, const Mesh& mesh)
{
  if(surface.is_embedded)
    return Triangulation(mesh);
  const std::vector<double> lengths = lengths_of(surface, mesh);
  return Triangulation(mesh, CGAL::parameters::edge_length_map(boost::make_iterator_property_map(
                                 lengths.begin(), get(boost::edge_index, mesh))));
}

// Its mesh, and its points in terms of mesh, triangulation and planes.
class Developed_mesh
{
public:
  explicit Developed_mesh(Developed_surface s)
    : surface(std::move(s)),
      mesh(to_mesh(surface.soup)),
      triangulation(triangulation_of(surface, mesh)),
      m_translation(mesh, get(boost::vertex_index, mesh), triangulation)
  {
    m_translation.list_vertices();
  }

  Developed_mesh(const Developed_mesh&) = delete;
  Developed_mesh& operator=(const Developed_mesh&) = delete;

  Place place(const Face_location& p) const
  {
    const auto& corners = surface.places[p.first.idx()];
    Place result{0, 0, corners[0].plane};
    for(std::size_t i = 0; i < 3; ++i)
    {
      result.x += p.second[i] * corners[i].x;
      result.y += p.second[i] * corners[i].y;
    }
    return result;
  }

  Long distance(const Face_location& p, const Face_location& q) const
  {
    return surface.distance(place(p), place(q));
  }

  auto intrinsic(const Face_location& p) const { return m_translation.intrinsic_point(p); }

  Surface_point point_of_mesh(const CGAL::Approximate_geodesics::Intrinsic_point& p) const
  {
    return m_translation.surface_point(p);
  }

  Face_location corner(const Vertex v) const
  {
    for(const Face f : faces_of(mesh, v))
      return location(f, v);
    throw std::logic_error("an isolated vertex has no face");
  }

  // The points that have places: all vertices but isolated ones.
  std::vector<Face_location> corners() const
  {
    std::vector<Face_location> result;
    for(const Vertex v : mesh.vertices())
      if(!mesh.is_isolated(v))
        result.push_back(corner(v));
    return result;
  }

  // On edges and in faces.
  Face_location random_location(Random& random) const
  {
    Face_location result = random_face_location(mesh, random);
    if(random.below(2) == 0)
    {
      const std::size_t i = random.below(3);
      result.second[(i + 1) % 3] += result.second[i];
      result.second[i] = 0;
      result.second[(i + 2) % 3] = 1 - result.second[(i + 1) % 3];
    }
    return result;
  }

  // The distance between two points of a face, of all that both lie in; infinity if there is none.
  Long distance_in_face(const Surface_point& p, const Surface_point& q) const
  {
    Long result = infinity;
    const std::set<Face> faces = faces_of(mesh, q);
    for(const Face f : faces_of(mesh, p))
      if(faces.count(f) > 0)
        result =
            (std::min)(result, distance_in_plane(place(location(f, p)), place(location(f, q))));
    return result;
  }

  Long angle_around(const Vertex v) const
  {
    Long result = 0;
    for(const Face f : faces_of(mesh, v))
    {
      const auto& p = surface.places[f.idx()];
      const std::size_t i = rank_in(f, v), j = (i + 1) % 3, k = (i + 2) % 3;
      const Long ux = p[j].x - p[i].x, uy = p[j].y - p[i].y, vx = p[k].x - p[i].x,
                 vy = p[k].y - p[i].y;
      result += std::abs(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy));
    }
    return result;
  }

  const Developed_surface surface;
  const Mesh mesh;
  const Triangulation triangulation;

private:
  using Index_map = decltype(get(boost::vertex_index, std::declval<const Mesh&>()));

  std::size_t rank_in(const Face f, const Vertex v) const
  {
    const auto& t = surface.soup.triangles[f.idx()];
    return static_cast<std::size_t>(std::find(t.begin(), t.end(), std::size_t(v)) - t.begin());
  }

  // A point of a face in terms of that.
  Face_location location(const Face f, const Surface_point& p) const
  {
    if(const auto* location = std::get_if<Face_location>(&p))
      return *location;
    Face_location result{f, {0, 0, 0}};
    if(const auto* v = std::get_if<Vertex>(&p))
      result.second[rank_in(f, *v)] = 1;
    else
    {
      const auto& [h, t] = std::get<Edge_location>(p);
      result.second[rank_in(f, mesh.source(h))] = 1 - t;
      result.second[rank_in(f, mesh.target(h))] = t;
    }
    return result;
  }

  CGAL::Approximate_geodesics::Mesh_translation<Mesh, Index_map> m_translation;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_DEVELOPED_SURFACE_H
