// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_GRIDS_H
#define APPROXIMATE_GEODESICS_PYTHON_GRIDS_H

#include <pybind11/pybind11.h>

namespace python {

// Adds the class `Grid`: a direct binding of `Grid_solver`.
void add_grid(pybind11::module_& module);

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_GRIDS_H
