// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_H
#define CGAL_GEODESIC_QUERIES_H

#include <CGAL/license/Approximate_geodesics.h>

// Includes all of the package Geodesic Queries: distance matrices, lists of pairs, landmarks,
// labels at portals, and intervals.

#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_types.h>
#include <CGAL/Approximate_geodesics/Matrices/Rows_in_memory.h>
#include <CGAL/Approximate_geodesics/Paths/Exact_landmarks.h>
#include <CGAL/Approximate_geodesics/Paths/Guided_search.h>
#include <CGAL/Approximate_geodesics/Paths/Landmarks.h>
#include <CGAL/Approximate_geodesics/Paths/Point_pairs.h>
#include <CGAL/Approximate_geodesics/Paths/Portal_labels.h>
#include <CGAL/Approximate_geodesics/Queries/Pair_queries.h>
#include <CGAL/Approximate_geodesics/Queries/distance_intervals.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_pair_distances.h>

#endif // CGAL_GEODESIC_QUERIES_H
