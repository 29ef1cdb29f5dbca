// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_H
#define CGAL_GEODESIC_QUERIES_H

#include <CGAL/license/Geodesic_queries.h>

// Includes all of the package Geodesic Queries: distance matrices, lists of pairs, landmarks,
// labels at portals, and intervals.

#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/Geodesic_queries/Exact_landmarks.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Landmarks.h>
#include <CGAL/Geodesic_queries/Pair_queries.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>
#include <CGAL/Geodesic_queries/Portal_labels.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/Geodesic_queries/distance_intervals.h>
#include <CGAL/Geodesic_queries/refined_path.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_pair_distances.h>

#endif // CGAL_GEODESIC_QUERIES_H
