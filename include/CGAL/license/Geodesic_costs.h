// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LICENSE_GEODESIC_COSTS_H
#define CGAL_LICENSE_GEODESIC_COSTS_H

// Inside CGAL this file is generated, and says under which license the package is used.
// Outside, the package is available under the GNU General Public License, version 3 or later.

#endif // CGAL_LICENSE_GEODESIC_COSTS_H
