// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_H
#define CGAL_GEODESIC_CONSTRUCTIONS_H

#include <CGAL/license/Geodesic_constructions.h>

// Includes what is built on exact and approximate searches: curves and regions as sources, signed
// distances, offset curves, cells, straight walks, loops, isolines, gradients, partitions, and
// samples.

#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/Loop_straightener.h>
#include <CGAL/Geodesic_constructions/Source_curve.h>
#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/karcher_mean.h>
#include <CGAL/Geodesic_constructions/logarithmic_map.h>
#include <CGAL/Geodesic_constructions/offset_curves.h>
#include <CGAL/Geodesic_constructions/search_from_curves.h>
#include <CGAL/Geodesic_constructions/shorten_loop.h>
#include <CGAL/Geodesic_constructions/trace_geodesic.h>
#include <CGAL/Geodesic_constructions/voronoi_borders.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>

#endif // CGAL_GEODESIC_CONSTRUCTIONS_H
