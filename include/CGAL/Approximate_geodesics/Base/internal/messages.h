// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_MESSAGES_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_MESSAGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

// Returns a number as text, with all significant digits, whatever the locale.
inline std::string text_of(const double number)
{
  std::array<char, 32> text; // at most a sign, digits, a point, and an exponent of five characters
  std::snprintf(text.data(), text.size(), "%.*g", std::numeric_limits<double>::digits10, number);
  std::string result = text.data();
  std::replace(result.begin(), result.end(), ',', '.');
  return result;
}

// The prefix of all messages.
inline const std::string& name_of_package()
{
  static const std::string result = "Approximate_geodesics: ";
  return result;
}

// Throws an error about invalid input.
[[noreturn]] inline void reject(const std::string& reason)
{
  throw std::invalid_argument(name_of_package() + reason);
}

// Returns a parameter. Throws an error if it is not a finite number larger than 0.
inline double checked_positive(const double number, const char* const name)
{
  if(!(number > 0) || std::isinf(number))
    reject(std::string(name) + " is " + text_of(number) +
           "; it must be a finite number larger than 0");
  return number;
}

inline std::string name_in_list(const std::string& role, const std::size_t position)
{
  return role + ' ' + std::to_string(position) + " (counted from 0)";
}

// Returns `f()`. If `f` rejects its input, prepends `name()` to the message. Other exceptions, such
// as those of property maps, pass unchanged.
template <typename Name, typename F>
auto name_in_message(const Name& name, const F& f)
{
  try
  {
    return f();
  }
  catch(const std::invalid_argument& e)
  {
    const std::string text = e.what();
    if(text.rfind(name_of_package(), 0) != 0)
      throw;
    reject(name() + ": " + text.substr(name_of_package().size()));
  }
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_MESSAGES_H
