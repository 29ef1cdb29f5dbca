// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_LOCATIONS_H
#define APPROXIMATE_GEODESICS_PYTHON_LOCATIONS_H

// The nearest points of a surface. Compiled by itself, because CGAL's AABB tree takes long to
// compile.

#include "arrays.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <memory>

namespace python {

class Locator
{
public:
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

  // Builds a tree of the faces. The mesh is referred to, not copied.
  explicit Locator(const Mesh& mesh);
  ~Locator();

  // Returns the faces and the barycentric coordinates of the nearest points of the surface, and the
  // distances from them.
  py::tuple locate(const Array<double>& points) const;

private:
  class Tree;
  std::unique_ptr<const Tree> m_tree;
};

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_LOCATIONS_H
