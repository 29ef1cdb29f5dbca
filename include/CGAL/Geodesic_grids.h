// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_H
#define CGAL_GEODESIC_GRIDS_H

#include <CGAL/license/Geodesic_grids.h>

// Includes the package of rasters: distances, paths and isolines on grids of cells.

#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/Grid_vector.h>
#include <CGAL/Geodesic_grids/isolines_on_grid.h>
#include <CGAL/approximate_geodesic_distances_on_grid.h>

#endif // CGAL_GEODESIC_GRIDS_H
