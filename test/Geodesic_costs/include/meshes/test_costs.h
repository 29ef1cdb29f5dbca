// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_COSTS_H
#define APPROXIMATE_GEODESICS_TEST_COSTS_H

#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Geodesic_costs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Costs that depend on the direction.

namespace geodesics_test {

using Vector = Kernel::Vector_3;
using CGAL::Approximate_geodesics::directional_cost;
using CGAL::Approximate_geodesics::Directional_graph;
using CGAL::Approximate_geodesics::Fixed_number_of_points;
using CGAL::Approximate_geodesics::reversed_cost;
using Dense_graph = Directional_graph<Fixed_number_of_points>;

template <typename Cost>
auto with_cost(const Cost& cost)
{
  return CGAL::parameters::face_weight_map(directional_cost(cost));
}

template <typename Cost>
Directional_graph<> bounded_graph(const Mesh& mesh, const Cost& cost, const double epsilon)
{
  const auto np = with_cost(cost).epsilon(epsilon);
  return Directional_graph<>(Triangulation(mesh, np), np);
}

template <typename Cost>
Dense_graph dense_graph(const Mesh& mesh, const Cost& cost, const std::size_t number)
{
  return Dense_graph(Triangulation(mesh, with_cost(cost)), Fixed_number_of_points(number));
}

// What a vector in the plane costs in a wind: the time that it takes.
struct Wind
{
  double cost(const Vector& v) const
  {
    const double ahead = drift * v, rest = speed * speed - drift.squared_length();
    return (std::sqrt(ahead * ahead + rest * v.squared_length()) - ahead) / rest;
  }

  Vector drift;
  double speed; // larger than that of the drift
};

// What a vector in space costs: its length, and a part of it that depends on the direction.
struct Slant
{
  double cost(const Vector& v) const
  {
    return factor * (std::sqrt(v.squared_length()) + slant * v);
  }

  double factor;
  Vector slant; // shorter than 1
};

// A polyhedral norm of the xy-plane, which need not be symmetric: the largest of several linear
// functions.
struct Half_planes
{
  static constexpr double full_circle = 6.283185307179586;

  // with so many sides, the first one of which is turned by a part of its angle
  static Half_planes regular(const int number, const double turn)
  {
    Half_planes result;
    for(int i = 0; i < number; ++i)
      result.add(full_circle * (i + turn) / number, 1);
    return result;
  }

  // some of which may not matter
  static Half_planes random(Random& random, const int number)
  {
    Half_planes result;
    const double turn = random.between(0, 1);
    for(int i = 0; i < number; ++i)
      result.add(full_circle * (i + turn + random.between(-0.2, 0.2)) / number,
                 random.between(0.6, 1.4));
    return result;
  }

  double cost(const Vector& v) const
  {
    double result = 0;
    for(const Vector& side : sides)
      result = (std::max)(result, side * v);
    return result;
  }

  void add(const double angle, const double size)
  {
    sides.push_back(size * Vector(std::cos(angle), std::sin(angle), 0));
  }

  std::vector<Vector> sides;
};

// Different ones for each face; in some of them, a direction costs several times as much as the
// opposite one.
inline std::vector<Slant> random_slants(const Mesh& mesh, Random& random, const double largest)
{
  std::vector<Slant> result;
  const auto part = [&] { return random.between(-largest, largest) / std::sqrt(3.); };
  for(std::size_t i = 0; i < mesh.number_of_faces(); ++i)
  {
    const double factor = std::pow(2., random.between(-1, 1)), x = part(), y = part();
    result.push_back({factor, Vector(x, y, part())});
  }
  return result;
}

// A cost function of a range of winds or slants, by the index of the face.
template <typename Costs>
auto cost_of_faces(const Costs& costs)
{
  return [&costs](const Face f, const Vector& d) { return costs[f.idx()].cost(d); };
}

// ... of one for all faces
template <typename Cost>
auto cost_everywhere(const Cost& cost)
{
  return [cost](const Face, const Vector& d) { return cost.cost(d); };
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_COSTS_H
