// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_SPRINGS_H
#define APPROXIMATE_GEODESICS_TEST_SPRINGS_H

#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>

#include <algorithm>
#include <cmath>
#include <functional>

// Surfaces that are given by lengths, where edges need not be shortest paths: a shortest path may
// cross a face again and again.

namespace geodesics_test {

inline Triangulation with_lengths(Mesh mesh, const std::function<double(Edge)>& length)
{
  const auto lengths = mesh.add_property_map<Edge, double>("e:length").first;
  for(const Edge e : mesh.edges())
    lengths[e] = length(e);
  return Triangulation(mesh, CGAL::parameters::edge_length_map(lengths));
}

// A cylinder without caps, between two rings of vertices. The edges from one to the other wind
// round it, as on a spring.
struct Spring
{
  static constexpr int n = 3; // vertices of a ring, and its circumference

  static Mesh mesh()
  {
    Mesh result;
    for(int i = 0; i < 2 * n; ++i)
      result.add_vertex(Point(i % n, i / n, 0));
    for(Mesh::size_type i = 0; i < n; ++i)
    {
      const Vertex a(i), b((i + 1) % n), c(i + n), d((i + 1) % n + n);
      result.add_face(a, b, c);
      result.add_face(b, d, c);
    }
    return result;
  }

  Triangulation triangulation() const
  {
    const Mesh m = mesh();
    return with_lengths(m, [&](const Edge e) {
      const int i = int(m.vertex(e, 0).idx()), j = int(m.vertex(e, 1).idx());
      if(i / n == j / n)
        return 1.;
      const bool is_diagonal = i % n != j % n;
      return std::hypot(turns * n - (is_diagonal ? 1 : 0), height);
    });
  }

  double distance(const int i, const int j) const
  {
    const int ahead = (j - i + 2 * n) % n;
    return std::hypot((std::min)(ahead, n - ahead), i / n == j / n ? 0 : height);
  }

  int turns;
  double height;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_SPRINGS_H
