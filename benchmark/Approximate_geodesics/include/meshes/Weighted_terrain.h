// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_WEIGHTED_TERRAIN_H
#define BENCHMARK_WEIGHTED_TERRAIN_H

#include "meshes/Mesh.h"
#include "meshes/Terrain.h"
#include "meshes/terrain_weights.h"
#include "output/Options.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// A terrain with weights.
class Weighted_terrain
{
  using Triangulation = CGAL::Approximate_geodesics::Intrinsic_triangulation;

public:
  explicit Weighted_terrain(const Options& options) : Weighted_terrain(options.is_quick ? 40 : 224)
  {
  }

  explicit Weighted_terrain(const std::size_t side)
    : m_mesh(terrain(side, 1, LARGEST_SHIFT)),
      m_weights(terrain_weights(m_mesh, double(side))),
      m_triangulation(m_mesh, CGAL::parameters::face_weight_map(m_weights))
  {
  }

  const Mesh& mesh() const { return m_mesh; }
  const Triangulation& triangulation() const { return m_triangulation; }

  // Random vertices outside the lake.
  std::vector<Vertex> sources(const std::size_t count) const
  {
    std::vector<Vertex> result;
    for(std::size_t candidates = count; result.size() < count; candidates *= 2)
    {
      result = random_sources(m_mesh, candidates);
      const auto is_in_lake = [this](const Vertex v) { return this->is_in_lake(v); };
      result.erase(std::remove_if(result.begin(), result.end(), is_in_lake), result.end());
    }
    result.resize(count);
    return result;
  }

private:
  bool is_in_lake(const Vertex v) const
  {
    const auto faces = m_mesh.faces_around_target(m_mesh.halfedge(v));
    return std::all_of(faces.begin(), faces.end(), [this](const auto f) {
      return f == Mesh::null_face() || std::isinf(m_weights[f]);
    });
  }

  // Needles admit no error bound.
  static constexpr double LARGEST_SHIFT = 0.2;

  Mesh m_mesh;
  Face_weights m_weights;
  Triangulation m_triangulation;
};

#endif // BENCHMARK_WEIGHTED_TERRAIN_H
