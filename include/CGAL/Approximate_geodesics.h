// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_H
#define CGAL_APPROXIMATE_GEODESICS_H

#include <CGAL/license/Approximate_geodesics.h>

// Includes the whole package: functions, classes and queues, and with them the headers of the types
// that they mention.

#include <CGAL/Approximate_geodesics/Matrices/Rows_in_memory.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangle_soup_mesh.h>
#include <CGAL/Approximate_geodesics/Paths/Portal_labels.h>
#include <CGAL/Approximate_geodesics/Queries/distance_intervals.h>
#include <CGAL/Approximate_geodesics/Queries/farthest_point_sampling.h>
#include <CGAL/Approximate_geodesics/Queries/gradient.h>
#include <CGAL/Approximate_geodesics/Queries/isolines.h>
#include <CGAL/Approximate_geodesics/Queries/isolines_on_grid.h>
#include <CGAL/Approximate_geodesics/Queries/karcher_mean.h>
#include <CGAL/Approximate_geodesics/Queries/logarithmic_map.h>
#include <CGAL/Approximate_geodesics/Queries/offset_curves.h>
#include <CGAL/Approximate_geodesics/Queries/refined_path.h>
#include <CGAL/Approximate_geodesics/Queries/shorten_loop.h>
#include <CGAL/Approximate_geodesics/Queries/trace_geodesic.h>
#include <CGAL/Approximate_geodesics/Queries/voronoi_borders.h>
#include <CGAL/Approximate_geodesics/Queries/voronoi_partition.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_distances_on_grid.h>
#include <CGAL/approximate_geodesic_pair_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#endif // CGAL_APPROXIMATE_GEODESICS_H
