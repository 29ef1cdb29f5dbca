// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_WALKS_H
#define APPROXIMATE_GEODESICS_PYTHON_WALKS_H

// Straight walks and loops. Compiled by themselves, as searches for them take long to compile.

#include "arrays.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace CGAL::Approximate_geodesics {

class Solver;
class Solver_walks;

} // namespace CGAL::Approximate_geodesics

namespace python {

class Walks
{
public:
  using Elements = Array<std::int64_t>;
  using Coordinates = std::optional<Array<double>>;

  // Reads the mesh once. The solver is referred to, not copied.
  explicit Walks(const AG::Solver& solver);
  ~Walks();

  // Vectors have two numbers, in the frame of their point, or three, in space.

  // Returns points, the direction at the end, the length, and whether the walk meets the border.
  py::tuple trace(const Elements& elements,
                  const Coordinates& coordinates,
                  const Array<double>& direction,
                  double length) const;

  Array<double> logarithmic_map(const Elements& elements, const Coordinates& coordinates) const;

  // Returns a vector of as many numbers.
  Array<double> transport(const Elements& elements,
                          const Coordinates& coordinates,
                          const Elements& target_elements,
                          const Coordinates& target_coordinates,
                          const Array<double>& vector) const;

  // Vectors are tangent vectors, (n, 2).
  Array<double> extend_vectors(const Elements& elements,
                               const Coordinates& coordinates,
                               const Array<double>& vectors) const;

  // Returns the mean as a point of a solver, the deviation, and whether it has converged.
  py::tuple mean(const Elements& elements,
                 const Coordinates& coordinates,
                 const Array<double>& weights) const;

  // Curves are points, and a length.
  py::tuple shorten_loop(const Elements& elements, const Coordinates& coordinates) const;
  py::tuple shorten_curve(const Elements& elements, const Coordinates& coordinates) const;
  py::tuple shortest_loop_through(const Elements& elements, const Coordinates& coordinates) const;

  // The x axes, y axes and normals of all vertices.
  py::tuple frames() const;

private:
  std::unique_ptr<const AG::Solver_walks> m_walks;
  py::ssize_t m_number_of_vertices;
};

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_WALKS_H
