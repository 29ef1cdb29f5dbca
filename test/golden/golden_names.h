// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_GOLDEN_NAMES_H
#define APPROXIMATE_GEODESICS_TEST_GOLDEN_NAMES_H

#include "meshes/test_soup.h"
#include "peers/Pairing_heap_queue.h"
#include "peers/Published_bucket_queue.h"
#include "peers/Published_geometric_points.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs.h>

// All classes of the package that golden results are made of, for the day when one is renamed.

namespace geodesics_test::golden {

namespace AG = CGAL::Approximate_geodesics;

using Triangulation = AG::Intrinsic_triangulation;
using Edges = AG::Edge_graph;
using Built = AG::Discrete_geodesic_graph;
using Lazy = AG::Lazy_discrete_geodesic_graph;
using Exact = AG::Saddle_vertex_graph;
using Spaced_points = AG::Fixed_number_of_points;
using Dense_points = AG::Points_at_interval;
using Geometric_points = AG::Geometric_points;
using Published_points = AG::Published_geometric_points;
using Directional_points = AG::Directional_points;

template <typename Placement>
using With_points = AG::Steiner_graph<Placement>;

template <typename Placement>
using With_costs = AG::Directional_graph<Placement>;

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

} // namespace geodesics_test::golden

#endif // APPROXIMATE_GEODESICS_TEST_GOLDEN_NAMES_H
