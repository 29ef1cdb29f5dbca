// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_H
#define CGAL_APPROXIMATE_GEODESICS_H

#include <CGAL/license/Approximate_geodesics.h>

// Includes everything: the core, and the packages on it that are installed.

#include <CGAL/Approximate_geodesics/Mesh/Triangle_soup_mesh.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#if __has_include(<CGAL/Geodesic_costs.h>)
#include <CGAL/Geodesic_costs.h>
#endif
#if __has_include(<CGAL/Geodesic_constructions.h>)
#include <CGAL/Geodesic_constructions.h>
#endif
#if __has_include(<CGAL/Geodesic_queries.h>)
#include <CGAL/Geodesic_queries.h>
#endif
#if __has_include(<CGAL/Geodesic_grids.h>)
#include <CGAL/Geodesic_grids.h>
#endif

#endif // CGAL_APPROXIMATE_GEODESICS_H
