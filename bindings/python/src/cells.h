// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_CELLS_H
#define APPROXIMATE_GEODESICS_PYTHON_CELLS_H

// Exact cells of sources, compiled by themselves.

#include "arrays.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Approximate_geodesics {

class Solver;

} // namespace CGAL::Approximate_geodesics

namespace python {

// Returns areas, the points of borders, their pairs of sources, neighbors, and triangles.
py::tuple cells(const AG::Solver& solver,
                const Array<std::int64_t>& elements,
                const std::optional<Array<double>>& coordinates,
                bool within_cells,
                const std::vector<double>& initial_distances,
                std::optional<double> chord_error);

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_CELLS_H
