// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_RESIDENT_MEMORY_H
#define BENCHMARK_RESIDENT_MEMORY_H

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>

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

#endif // BENCHMARK_RESIDENT_MEMORY_H
