// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_JS_CALLS_H
#define APPROXIMATE_GEODESICS_JS_CALLS_H

// What a call from JavaScript exchanges with it: arrays in, arrays out, progress, and failures.

#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#define JS_IMPORT(name) extern "C" __attribute__((import_module("javascript"), import_name(#name)))
#define JS_EXPORT(name) extern "C" __attribute__((export_name(#name), used))

namespace javascript {

namespace AG = CGAL::Approximate_geodesics;

// The types of arrays, and the classes of errors, by their numbers in `wasm.js`.
enum Type : int
{
  NUMBERS,
  INTEGERS,
  BYTES
};
enum Failure : int
{
  INVALID,
  OUT_OF_MEMORY,
  INTERRUPTED,
  OTHER
};

} // namespace javascript

// JavaScript copies what it is given before these return. `go_further` tells whether to continue.
JS_IMPORT(give) void javascript_give(javascript::Type type, const void* data, std::size_t size);
JS_IMPORT(fail) void javascript_fail(javascript::Failure kind, const char* text, std::size_t size);
JS_IMPORT(report) void javascript_report(double number_done, double number);
JS_IMPORT(go_further) bool javascript_go_further();

namespace javascript {

// Results, which JavaScript gets in the order of these calls.
inline void give(const std::vector<double>& values)
{
  javascript_give(NUMBERS, values.data(), values.size());
}

inline void give(const std::vector<std::int32_t>& values)
{
  javascript_give(INTEGERS, values.data(), values.size());
}

inline void give(const std::vector<std::int64_t>& values)
{
  give(std::vector<std::int32_t>(values.begin(), values.end())); // elements of meshes fit
}

inline void give(const std::string& bytes) { javascript_give(BYTES, bytes.data(), bytes.size()); }

inline void fail(const Failure kind, const std::string& text)
{
  const std::string prefix = "Approximate_geodesics: ";
  const std::size_t start = text.compare(0, prefix.size(), prefix) == 0 ? prefix.size() : 0;
  javascript_fail(kind, text.data() + start, text.size() - start);
}

// Returns `f()`, or tells JavaScript why there is no result.
template <typename F>
auto call(const F& f) -> decltype(f())
{
  try
  {
    return f();
  }
  catch(const std::invalid_argument& e)
  {
    fail(INVALID, e.what());
  }
  catch(const AG::Solver_interrupted& e)
  {
    fail(INTERRUPTED, e.what());
  }
  catch(const std::bad_alloc&)
  {
    javascript_fail(OUT_OF_MEMORY, nullptr, 0);
  }
  catch(const std::length_error&) // of arrays that are larger than the address space
  {
    javascript_fail(OUT_OF_MEMORY, nullptr, 0);
  }
  catch(const std::exception& e)
  {
    fail(OTHER, e.what());
  }
  return decltype(f())();
}

// Calls the function `progress` of JavaScript, if there is one.
inline AG::Solver_watch watch(const bool has_progress)
{
  AG::Solver_watch result;
  if(has_progress)
  {
    result.go_further = [] { return javascript_go_further(); };
    result.on_progress = [](const std::size_t number_done, const std::size_t number) {
      javascript_report(static_cast<double>(number_done), static_cast<double>(number));
    };
  }
  return result;
}

// Converts points of six numbers each: the kind, the element, the second vertex, and three
// coordinates.
inline std::vector<AG::Solver_point> points(const double* const numbers, const std::size_t size)
{
  constexpr std::size_t numbers_per_point = 6;
  std::vector<AG::Solver_point> result;
  result.reserve(size / numbers_per_point);
  for(const double* p = numbers; p != numbers + size; p += numbers_per_point)
    result.push_back({static_cast<AG::Solver_point::Kind>(p[0]),
                      static_cast<std::int64_t>(p[1]),
                      static_cast<std::int64_t>(p[2]),
                      {p[3], p[4], p[5]}});
  return result;
}

} // namespace javascript

#endif // APPROXIMATE_GEODESICS_JS_CALLS_H
