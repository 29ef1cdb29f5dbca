// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_H
#define CGAL_APPROXIMATE_GEODESICS_H

#include <CGAL/license/Approximate_geodesics.h>

// Includes the whole package.

#include <CGAL/Approximate_geodesics/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Array_queue.h>
#include <CGAL/Approximate_geodesics/Balanced_bucket_width.h>
#include <CGAL/Approximate_geodesics/Binary_heap_queue.h>
#include <CGAL/Approximate_geodesics/Bucket_statistics.h>
#include <CGAL/Approximate_geodesics/D_ary_heap_queue.h>
#include <CGAL/Approximate_geodesics/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Equally_dense_points.h>
#include <CGAL/Approximate_geodesics/Equally_spaced_points.h>
#include <CGAL/Approximate_geodesics/Fibonacci_heap_queue.h>
#include <CGAL/Approximate_geodesics/Geodesic_visitor_base.h>
#include <CGAL/Approximate_geodesics/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Pairing_heap_queue.h>
#include <CGAL/Approximate_geodesics/Place.h>
#include <CGAL/Approximate_geodesics/Propagation.h>
#include <CGAL/Approximate_geodesics/Propagation_statistics.h>
#include <CGAL/Approximate_geodesics/Published_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Published_bucket_width.h>
#include <CGAL/Approximate_geodesics/Published_geometric_points.h>
#include <CGAL/Approximate_geodesics/Queue_entry.h>
#include <CGAL/Approximate_geodesics/Radix_heap_queue.h>
#include <CGAL/Approximate_geodesics/Steiner_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Approximate_geodesics/Surface_point.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/farthest_point_sampling.h>
#include <CGAL/geodesic_gradient.h>
#include <CGAL/geodesic_isolines.h>
#include <CGAL/geodesic_voronoi_partition.h>
#include <CGAL/refined_geodesic_path.h>

#endif // CGAL_APPROXIMATE_GEODESICS_H
