// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_RESIDENT_MEMORY_H
#define BENCHMARK_RESIDENT_MEMORY_H

#include "measuring/child_process.h"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <vector>

// The resident memory of a process, in bytes.

inline double resident_memory()
{
  std::ifstream in("/proc/self/statm");
  double total, resident;
  if(!(in >> total >> resident))
    throw std::runtime_error("the operating system does not tell how much memory is used");
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// Returns freed memory to the operating system. Otherwise a child process would reuse it, and its
// use would not be measured.
inline void release_free_memory() { malloc_trim(0); }

// peak resident memory
inline double peak_memory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

// How much memory `f` takes at its largest, in a process of its own that may run for so many
// seconds.
template <typename F>
double peak_memory_of(const unsigned seconds, F f)
{
  release_free_memory();
  const std::vector<double> numbers = numbers_from_child(1, seconds, [&](double* const result) {
    const double before = resident_memory();
    f();
    result[0] = peak_memory() - before;
  });
  return numbers[0];
}

#endif // BENCHMARK_RESIDENT_MEMORY_H
