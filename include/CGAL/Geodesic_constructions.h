// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_H
#define CGAL_GEODESIC_CONSTRUCTIONS_H

#include <CGAL/license/Approximate_geodesics.h>

// Includes what is built on exact and approximate searches: curves and regions as sources, signed
// distances, offset curves, cells, straight walks, loops, isolines, gradients, partitions, and
// samples.

#include <CGAL/Approximate_geodesics/Paths/Loop_straightener.h>
#include <CGAL/Approximate_geodesics/Queries/Source_curve.h>
#include <CGAL/Approximate_geodesics/Queries/farthest_point_sampling.h>
#include <CGAL/Approximate_geodesics/Queries/gradient.h>
#include <CGAL/Approximate_geodesics/Queries/isolines.h>
#include <CGAL/Approximate_geodesics/Queries/karcher_mean.h>
#include <CGAL/Approximate_geodesics/Queries/logarithmic_map.h>
#include <CGAL/Approximate_geodesics/Queries/offset_curves.h>
#include <CGAL/Approximate_geodesics/Queries/search_from_curves.h>
#include <CGAL/Approximate_geodesics/Queries/shorten_loop.h>
#include <CGAL/Approximate_geodesics/Queries/trace_geodesic.h>
#include <CGAL/Approximate_geodesics/Queries/voronoi_borders.h>
#include <CGAL/Approximate_geodesics/Queries/voronoi_partition.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_curve.h>

#endif // CGAL_GEODESIC_CONSTRUCTIONS_H
