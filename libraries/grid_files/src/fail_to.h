// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_GRID_FILES_FAIL_TO_H
#define APPROXIMATE_GEODESICS_GRID_FILES_FAIL_TO_H

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace CGAL::Approximate_geodesics::internal {

// Throws an error with the reason that the system has given in `errno`.
[[noreturn]] inline void fail_to(const std::string& verb, const std::string& file)
{
  const std::string reason = errno != 0 ? ": " + std::generic_category().message(errno) : "";
  throw std::runtime_error("Approximate_geodesics: " + file + " cannot be " + verb + reason);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // APPROXIMATE_GEODESICS_GRID_FILES_FAIL_TO_H
