// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_H
#define CGAL_GEODESIC_COSTS_H

#include <CGAL/license/Approximate_geodesics.h>

// Includes the package of costs: weights, costs that depend on the direction, barriers, limits of
// slopes, the graphs for them, and searches that are repaired after changes. Functions of other
// packages read the named parameters for these if this header is included.

#include <CGAL/Approximate_geodesics/Base/Arc_changes.h>
#include <CGAL/Approximate_geodesics/Graphs/Directional_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Directional_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Steiner_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/equal_parts.h>
#include <CGAL/Approximate_geodesics/Mesh/cost_functions.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Cost_reader.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/read_changes.h>
#include <CGAL/Approximate_geodesics/Mesh/read_face_weights.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Cost_graphs.h>
#include <CGAL/Approximate_geodesics/Search/internal/Free_ways.h>
#include <CGAL/Approximate_geodesics/Search/internal/continued_runs.h>
#include <CGAL/Approximate_geodesics/Surface/triangulation_changes.h>

#endif // CGAL_GEODESIC_COSTS_H
