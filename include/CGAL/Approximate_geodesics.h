// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_H
#define CGAL_APPROXIMATE_GEODESICS_H

#include <CGAL/license/Approximate_geodesics.h>

// Includes the whole package, layer by layer.

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>

#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Queues/Queue_entry.h>

#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <CGAL/Approximate_geodesics/Graphs/Directional_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Directional_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Grid_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Grid_shape.h>
#include <CGAL/Approximate_geodesics/Graphs/Grid_vector.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Steiner_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/equal_parts.h>

#include <CGAL/Approximate_geodesics/Paths/Landmarks.h>
#include <CGAL/Approximate_geodesics/Paths/Loop_straightener.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Path_straightener.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_locations.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangle_soup_mesh.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Mesh/cost_functions.h>
#include <CGAL/Approximate_geodesics/Mesh/read_face_weights.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_types.h>
#include <CGAL/Approximate_geodesics/Matrices/Rows_in_memory.h>
#include <CGAL/Approximate_geodesics/Queries/distance_intervals.h>
#include <CGAL/Approximate_geodesics/Queries/farthest_point_sampling.h>
#include <CGAL/Approximate_geodesics/Queries/gradient.h>
#include <CGAL/Approximate_geodesics/Queries/isolines.h>
#include <CGAL/Approximate_geodesics/Queries/isolines_on_grid.h>
#include <CGAL/Approximate_geodesics/Queries/karcher_mean.h>
#include <CGAL/Approximate_geodesics/Queries/logarithmic_map.h>
#include <CGAL/Approximate_geodesics/Queries/refined_path.h>
#include <CGAL/Approximate_geodesics/Queries/shorten_loop.h>
#include <CGAL/Approximate_geodesics/Queries/trace_geodesic.h>
#include <CGAL/Approximate_geodesics/Queries/voronoi_borders.h>
#include <CGAL/Approximate_geodesics/Queries/voronoi_partition.h>

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_distances_on_grid.h>
#include <CGAL/approximate_geodesic_pair_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#endif // CGAL_APPROXIMATE_GEODESICS_H
