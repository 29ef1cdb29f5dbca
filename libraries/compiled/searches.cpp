// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#define CGAL_APPROXIMATE_GEODESICS_INSTANTIATION
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_queries/internal/compiled_pairs.h>
