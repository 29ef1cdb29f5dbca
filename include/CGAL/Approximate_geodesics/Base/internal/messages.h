// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_MESSAGES_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_MESSAGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// a number with enough digits to recognize it, whatever its size
inline std::string text_of(const double number)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::digits10);
  text << number;
  return text.str();
}

// tells the caller what is wrong with the input
[[noreturn]] inline void reject(const std::string& reason)
{
  throw std::invalid_argument("Approximate_geodesics: " + reason);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_MESSAGES_H
