// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_FOR_GENERATED_MESHES_H
#define APPROXIMATE_GEODESICS_TEST_FOR_GENERATED_MESHES_H

#include "checks/test_random.h"
#include "meshes/test_meshes.h"

#include <gtest/gtest.h>

namespace geodesics_test {

// Calls `f(mesh, random)` for all kinds of meshes.
template <typename F>
void for_generated_meshes(F f)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    f(named.mesh, random);
  }
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_FOR_GENERATED_MESHES_H
