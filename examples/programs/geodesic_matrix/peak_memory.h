#ifndef GEODESIC_MATRIX_PEAK_MEMORY_H
#define GEODESIC_MATRIX_PEAK_MEMORY_H

#include <sys/resource.h>

// The bytes that this process has had in memory at most.
inline double peak_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  constexpr double unit = 1;
#else
  constexpr double unit = 1024;
#endif
  return unit * double(usage.ru_maxrss);
}

#endif // GEODESIC_MATRIX_PEAK_MEMORY_H
