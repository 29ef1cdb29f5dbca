// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_GOLDEN_NAMES_H
#define APPROXIMATE_GEODESICS_TEST_GOLDEN_NAMES_H

#include "test_soup.h"

#include <CGAL/Approximate_geodesics/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Array_queue.h>
#include <CGAL/Approximate_geodesics/Binary_heap_queue.h>
#include <CGAL/Approximate_geodesics/D_ary_heap_queue.h>
#include <CGAL/Approximate_geodesics/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Equally_dense_points.h>
#include <CGAL/Approximate_geodesics/Equally_spaced_points.h>
#include <CGAL/Approximate_geodesics/Fibonacci_heap_queue.h>
#include <CGAL/Approximate_geodesics/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Pairing_heap_queue.h>
#include <CGAL/Approximate_geodesics/Propagation.h>
#include <CGAL/Approximate_geodesics/Published_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Published_geometric_points.h>
#include <CGAL/Approximate_geodesics/Radix_heap_queue.h>
#include <CGAL/Approximate_geodesics/Steiner_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

// All classes of the package that golden results are made of, for the day when one is renamed.

namespace geodesics_test {
namespace golden {

namespace AG = CGAL::Approximate_geodesics;

using Triangulation = AG::Intrinsic_triangulation;
using Edges = AG::Edge_graph;
using Built = AG::Discrete_geodesic_graph;
using Lazy = AG::Lazy_discrete_geodesic_graph;
using Spaced_points = AG::Equally_spaced_points;
using Dense_points = AG::Equally_dense_points;
using Geometric_points = AG::Geometric_points;
using Published_points = AG::Published_geometric_points;

template <typename Placement>
using With_points = AG::Steiner_graph<Placement>;

using Buckets = AG::Adaptive_bucket_queue;
using Published_buckets = AG::Published_bucket_queue;
using Radix_heap = AG::Radix_heap_queue;
using Binary_heap = AG::Binary_heap_queue;
using Four_ary_heap = AG::D_ary_heap_queue<4>;
using Fibonacci_heap = AG::Fibonacci_heap_queue;
using Pairing_heap = AG::Pairing_heap_queue;
using Array = AG::Array_queue;

template <typename GeodesicGraph, typename Queue>
using Search = AG::Propagation<GeodesicGraph, Queue>;

template <typename GeodesicGraph>
using Shortest_paths = AG::Surface_mesh_shortest_path<Mesh, GeodesicGraph>;

} // namespace golden
} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_GOLDEN_NAMES_H
