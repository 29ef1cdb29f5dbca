// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_REQUIRE_H
#define APPROXIMATE_GEODESICS_TEST_REQUIRE_H

#include <cstdlib>
#include <iostream>

namespace geodesics_test {

// Tells a fuzzer that it has found something.
template <typename... Details>
void require(const bool condition, const char* what, const Details&... details)
{
  if(condition)
    return;
  std::cerr << "Broken: " << what;
  ((std::cerr << ' ' << details), ...);
  std::cerr << std::endl;
  std::abort();
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_REQUIRE_H
