// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_SCALABLE_ALLOCATOR_H
#define APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_SCALABLE_ALLOCATOR_H

// CGAL includes it beside parallel_for.h, and does not use it there.

#endif // APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_SCALABLE_ALLOCATOR_H
