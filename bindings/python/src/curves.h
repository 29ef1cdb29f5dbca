// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_CURVES_H
#define APPROXIMATE_GEODESICS_PYTHON_CURVES_H

// Distances from curves and regions, and their offsets. Compiled by themselves, as exact searches
// take long to compile.

#include "arrays.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Approximate_geodesics {

class Solver;

} // namespace CGAL::Approximate_geodesics

namespace python {

Array<double> distances_from_curve(const AG::Solver& solver,
                                   const Array<std::int64_t>& elements,
                                   const std::optional<Array<double>>& coordinates,
                                   bool is_closed,
                                   bool is_signed,
                                   const py::object& progress);

Array<double> distances_from_region(const AG::Solver& solver,
                                    const std::vector<std::int64_t>& faces,
                                    const py::object& progress);

// Returns pairs of a distance and points.
py::list offsets_of_curve(const AG::Solver& solver,
                          const Array<std::int64_t>& elements,
                          const std::optional<Array<double>>& coordinates,
                          bool is_closed,
                          const std::vector<double>& distances,
                          const py::object& progress);

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_CURVES_H
