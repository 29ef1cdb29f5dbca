// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_EXACT_CASE_H
#define BENCHMARK_EXACT_CASE_H

#include "measuring/child_process.h"
#include "meshes/Mesh.h"
#include "peers/Exact_search.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

// What the exact class is asked to cope with.
struct Limits
{
  unsigned seconds = 60; // of the processor, per mesh
  std::size_t faces = 100000;
};

// A mesh, with the exact distances from some of its vertices.
class Exact_case
{
public:
  static constexpr double ROUNDING = 1e-10; // of the exact class

  // from random vertices
  Exact_case(const std::string& name, const std::size_t number_of_sources, const Limits& limits)
    : Exact_case(name, read_mesh(name), number_of_sources, limits)
  {
  }

  Exact_case(const std::string& name,
             const Mesh& mesh,
             const std::vector<Vertex>& sources,
             const Limits& limits)
    : m_name(short_name(name)), m_mesh(mesh), m_sources(sources)
  {
    if(!CGAL::is_triangle_mesh(m_mesh))
      throw std::runtime_error("not a triangle mesh");
    if(m_mesh.number_of_faces() > limits.faces)
      throw std::runtime_error("more than " + std::to_string(limits.faces) + " faces");
    find_distances(limits.seconds);
    correct_distances();
  }

  const std::string& name() const { return m_name; }
  const Mesh& mesh() const { return m_mesh; }
  const std::vector<Vertex>& sources() const { return m_sources; }

  double distance(const std::size_t source, const Vertex v) const
  {
    return m_distances[source * m_mesh.number_of_vertices() + v.idx()];
  }

  // the number of distances that the exact class had too long
  std::size_t number_of_corrections() const { return m_number_of_corrections; }

private:
  using Point = Kernel::Point_3;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  Exact_case(const std::string& name,
             const Mesh& mesh,
             const std::size_t number_of_sources,
             const Limits& limits)
    : Exact_case(name, mesh, random_sources(mesh, number_of_sources), limits)
  {
  }

  void find_distances(const unsigned seconds)
  {
    const auto find = [this](double* to) {
      Exact_search search(m_mesh);
      for(const Vertex source : m_sources)
      {
        search.run(source);
        for(const Vertex v : m_mesh.vertices())
          *to++ = search.distance(v);
      }
    };
    try
    {
      m_distances =
          numbers_from_child(m_sources.size() * m_mesh.number_of_vertices(), seconds, find);
    }
    catch(const std::exception& e)
    {
      throw std::runtime_error(std::string("the exact class ") + e.what());
    }
  }

  // The exact class rounds, and may lose a path by that. A shorter one, which is measured as it
  // lies on the mesh, proves it wrong, whoever has found it.
  void correct_distances()
  {
    const auto epsilon = CGAL::parameters::epsilon(0.01);
    const auto ours = m_mesh.add_property_map<Vertex, double>("v:ours").first;
    auto exact = m_distances.begin();
    for(const Vertex source : m_sources)
    {
      CGAL::approximate_geodesic_distances(m_mesh, ours, source, epsilon);
      for(const Vertex v : m_mesh.vertices())
      {
        if(ours[v] < *exact * (1 - ROUNDING))
        {
          std::vector<Point> points;
          CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), source, v, epsilon);
          correct(*exact, points);
        }
        ++exact;
      }
    }
  }

  void correct(double& exact, const std::vector<Point>& points)
  {
    if(m_tree.empty())
      m_tree.insert(faces(m_mesh).first, faces(m_mesh).second, m_mesh);
    double length = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      if(!is_on_mesh(points[i]) || !is_on_mesh(CGAL::midpoint(points[i - 1], points[i])))
        return;
      length += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
    }
    if(length >= exact)
      return;
    exact = length;
    ++m_number_of_corrections;
  }

  bool is_on_mesh(const Point& point) const
  {
    const CGAL::Bbox_3 box = m_tree.bbox();
    const double size = box.xmax() - box.xmin() + box.ymax() - box.ymin() + box.zmax() - box.zmin();
    return std::sqrt(m_tree.squared_distance(point)) <= 1e-12 * size;
  }

  std::string m_name;
  Mesh m_mesh;
  std::vector<Vertex> m_sources;
  std::vector<double> m_distances; // of all vertices from the first source, and so on
  std::size_t m_number_of_corrections = 0;
  Tree m_tree; // of the faces, if it was needed
};

// from the first vertex and random ones
inline Exact_case first_and_random_case(const std::string& name,
                                        const std::size_t number_of_sources)
{
  const Mesh mesh = read_mesh(name);
  return Exact_case(name, mesh, first_and_random(random_sources(mesh, number_of_sources)),
                    Limits());
}

#endif // BENCHMARK_EXACT_CASE_H
