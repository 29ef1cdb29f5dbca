// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_H
#define CGAL_GEODESIC_COSTS_H

#include <CGAL/license/Geodesic_costs.h>

// Includes the package of costs: weights, costs that depend on the direction, barriers, limits of
// slopes, the graphs for them, and searches that are repaired after changes. Functions of other
// packages read the named parameters for these if this header is included.

#include <CGAL/Geodesic_costs/Arc_changes.h>
#include <CGAL/Geodesic_costs/Directional_graph.h>
#include <CGAL/Geodesic_costs/Directional_points.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_costs/equal_parts.h>
#include <CGAL/Geodesic_costs/internal/Cost_graphs.h>
#include <CGAL/Geodesic_costs/internal/Cost_reader.h>
#include <CGAL/Geodesic_costs/internal/Free_ways.h>
#include <CGAL/Geodesic_costs/internal/continued_runs.h>
#include <CGAL/Geodesic_costs/internal/read_changes.h>
#include <CGAL/Geodesic_costs/read_face_weights.h>
#include <CGAL/Geodesic_costs/triangulation_changes.h>

#endif // CGAL_GEODESIC_COSTS_H
