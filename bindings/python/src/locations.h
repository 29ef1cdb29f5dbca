// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_LOCATIONS_H
#define APPROXIMATE_GEODESICS_PYTHON_LOCATIONS_H

// The nearest points of a surface. Compiled by itself, because CGAL's AABB tree takes long to
// compile.

#include "arrays.h"

#include <memory>

namespace CGAL::Approximate_geodesics {

class Solver;
class Solver_locator;

} // namespace CGAL::Approximate_geodesics

namespace python {

class Locator
{
public:
  // Builds a tree of the faces. The solver is referred to, not copied.
  explicit Locator(const AG::Solver& solver);
  ~Locator();

  // Returns the faces and the barycentric coordinates of the nearest points of the surface, and the
  // distances from them.
  py::tuple locate(const Array<double>& points) const;

private:
  std::unique_ptr<const AG::Solver_locator> m_locator;
};

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_LOCATIONS_H
