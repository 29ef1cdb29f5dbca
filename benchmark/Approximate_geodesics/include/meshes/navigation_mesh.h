// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_NAVIGATION_MESH_H
#define BENCHMARK_NAVIGATION_MESH_H

#include "meshes/Mesh.h"
#include "meshes/terrain_weights.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

/*
 * Makes a mesh like those on which agents of games and simulations walk: a square with obstacles,
 * whose corners are all vertices that there are. With 26 obstacles a side, it has 6,763 faces.
 */
class Navigation_mesh_maker
{
  using Info = Mesh::size_type;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Info, Kernel>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
      Kernel,
      CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>>;

public:
  explicit Navigation_mesh_maker(const std::size_t obstacles_per_side)
  {
    const double side = double(obstacles_per_side);
    add_polygon({{{0, 0}, {side, 0}, {side, side}, {0, side}, {0, side / 2}}});
    for(std::size_t i = 0; i < obstacles_per_side; ++i)
      for(std::size_t j = 0; j < obstacles_per_side; ++j)
        add_obstacle(double(i) + between(0.4, 0.6), double(j) + between(0.4, 0.6));
    for(const auto f : m_triangulation.finite_face_handles())
      add_face(*f);
  }

  const Mesh& mesh() const { return m_mesh; }

private:
  static constexpr Info OUTER_CORNERS = 5, CORNERS_OF_OBSTACLE = 8;

  double between(const double low, const double high)
  {
    return low + (high - low) * double(m_random() - m_random.min()) /
                     double(m_random.max() - m_random.min());
  }

  void add_polygon(const std::vector<std::array<double, 2>>& corners)
  {
    std::vector<Triangulation::Vertex_handle> handles;
    for(const auto& [x, y] : corners)
    {
      handles.push_back(m_triangulation.insert({x, y}));
      handles.back()->info() = m_mesh.add_vertex({x, y, 0}).idx();
    }
    for(std::size_t i = 0; i < handles.size(); ++i)
      m_triangulation.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
  }

  // Adds an octagon, whose corners are on an ellipse.
  void add_obstacle(const double x, const double y)
  {
    constexpr double pi = 3.14159265358979323846;
    const double a = between(0.15, 0.35), b = between(0.15, 0.35), turn = between(0, pi);
    std::vector<std::array<double, 2>> corners;
    for(Info i = 0; i < CORNERS_OF_OBSTACLE; ++i)
    {
      const double angle = 2 * pi * (i + between(0.1, 0.9)) / CORNERS_OF_OBSTACLE;
      const double u = a * std::cos(angle), v = b * std::sin(angle);
      corners.push_back({x + u * std::cos(turn) - v * std::sin(turn),
                         y + u * std::sin(turn) + v * std::cos(turn)});
    }
    add_polygon(corners);
  }

  static Info obstacle(const Info vertex) // from 1 on, 0 for the outer corners
  {
    return vertex < OUTER_CORNERS ? 0 : 1 + (vertex - OUTER_CORNERS) / CORNERS_OF_OBSTACLE;
  }

  // Obstacles are convex, so a face is in one if its corners are.
  template <typename Face>
  void add_face(const Face& f)
  {
    std::array<Info, 3> v;
    for(int i = 0; i < 3; ++i)
      v[static_cast<std::size_t>(i)] = f.vertex(i)->info();
    if(obstacle(v[0]) == 0 || obstacle(v[0]) != obstacle(v[1]) || obstacle(v[0]) != obstacle(v[2]))
      m_mesh.add_face(Vertex(v[0]), Vertex(v[1]), Vertex(v[2]));
  }

  std::mt19937_64 m_random{1};
  Triangulation m_triangulation;
  Mesh m_mesh;
};

inline Mesh navigation_mesh(const std::size_t obstacles_per_side)
{
  return Navigation_mesh_maker(obstacles_per_side).mesh();
}

// Four kinds of ground, in patches.
inline Face_weights region_weights(Mesh& mesh)
{
  constexpr std::array<double, 4> weights = {1, 1.5, 2.5, 4};
  constexpr double size_of_patch = 5;
  const Face_weights result = mesh.add_property_map<Mesh::Face_index, double>("f:weight", 1).first;
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Kernel::Point_3 p = CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                             mesh.point(mesh.target(mesh.next(h))));
    const auto patch = static_cast<std::size_t>(p.x() / size_of_patch) +
                       3 * static_cast<std::size_t>(p.y() / size_of_patch);
    result[f] = weights[patch % weights.size()];
  }
  return result;
}

#endif // BENCHMARK_NAVIGATION_MESH_H
