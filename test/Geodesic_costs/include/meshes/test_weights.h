// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_WEIGHTS_H
#define APPROXIMATE_GEODESICS_TEST_WEIGHTS_H

#include "oracles/test_oracles.h"

#include <CGAL/Geodesic_costs.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace geodesics_test {

using CGAL::Approximate_geodesics::Fixed_number_of_points;
using CGAL::Approximate_geodesics::Geometric_points;
using CGAL::Approximate_geodesics::Steiner_graph;

// What takes all meshes: thin faces that would need very many points get few.
inline auto lenient_parameters(const double epsilon)
{
  return CGAL::parameters::epsilon(epsilon)
      .accept_weaker_bound(true)
      .maximum_number_of_points_per_edge(100);
}

inline Geometric_points lenient_points(const double epsilon)
{
  return Geometric_points(lenient_parameters(epsilon));
}

using Weights = std::vector<double>; // by the index of the face
using Barriers = std::vector<bool>;  // by the index of the edge

// Values by the index of a face or an edge, as a property map that refers to them.
template <typename Descriptor, typename Vector>
struct Values_by_index
{
  using key_type = Descriptor;
  using value_type = typename Vector::value_type;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  friend value_type get(const Values_by_index& map, const Descriptor d)
  {
    return (*map.values)[d.idx()];
  }

  const Vector* values;
};

inline auto weight_map(const Weights& weights) { return Values_by_index<Face, Weights>{&weights}; }

inline auto with_weights(const Weights& weights)
{
  return CGAL::parameters::face_weight_map(weight_map(weights));
}

inline auto barrier_map(const Barriers& barriers)
{
  return Values_by_index<Edge, Barriers>{&barriers};
}

inline auto with_barriers(const Barriers& barriers)
{
  return CGAL::parameters::edge_is_constrained_map(barrier_map(barriers));
}

template <typename Placement>
Steiner_graph<Placement>
steiner_graph(const Mesh& mesh, const Weights& weights, const Placement& placement)
{
  return Steiner_graph<Placement>(Triangulation(mesh, with_weights(weights)), placement);
}

// The cost from the nearest of the sources to every vertex.
template <typename Placement>
std::vector<double> costs(const Mesh& mesh,
                          const Weights& weights,
                          const Placement& placement,
                          const std::vector<Vertex>& sources)
{
  return Basic_mesh_search<Steiner_graph<Placement>>(mesh, steiner_graph(mesh, weights, placement))
      .distances(sources);
}

// Weights that `weight(centroid)` says.
template <typename F>
Weights weights_by_place(const Mesh& mesh, F weight)
{
  Weights result(mesh.num_faces());
  for(const Face f : mesh.faces())
  {
    const Halfedge h = mesh.halfedge(f);
    result[f.idx()] = weight(CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                            mesh.point(mesh.target(mesh.next(h)))));
  }
  return result;
}

// Weights between `low` and `high` such that their logarithms are uniform; a part of them is `0`,
// and as many infinity.
inline Weights random_weights(
    const Mesh& mesh, Random& random, const double low, const double high, const double extreme = 0)
{
  Weights result(mesh.num_faces());
  for(double& w : result)
  {
    const double kind = random.between(0, 1);
    w = low * std::pow(high / low, random.between(0, 1));
    if(kind < extreme)
      w = 0;
    else if(kind < 2 * extreme)
      w = infinity;
  }
  return result;
}

// A part of all edges, about as large as `share`.
inline Barriers random_barriers(const Mesh& mesh, const double share, Random& random)
{
  Barriers result(mesh.num_edges());
  for(std::size_t i = 0; i < result.size(); ++i)
    result[i] = random.between(0, 1) < share;
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_WEIGHTS_H
