// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_CHILD_PROCESS_H
#define BENCHMARK_CHILD_PROCESS_H

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

// Memory shared with child processes.
class Shared_doubles
{
public:
  explicit Shared_doubles(const std::size_t size)
    : m_size(size),
      m_memory(mmap(nullptr, bytes(), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
  {
    if(m_memory == MAP_FAILED)
      throw std::bad_alloc();
  }

  Shared_doubles(const Shared_doubles&) = delete;
  Shared_doubles& operator=(const Shared_doubles&) = delete;
  ~Shared_doubles() { munmap(m_memory, bytes()); }

  double* data() const { return static_cast<double*>(m_memory); }

private:
  std::size_t bytes() const { return m_size * sizeof(double); }

  std::size_t m_size;
  void* m_memory;
};

// CPU time in seconds, which does not depend on other processes.
inline void limit_processor_time(const unsigned seconds)
{
  const rlimit limit{seconds, seconds + 1};
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CPU, &limit);
  setrlimit(RLIMIT_CORE, &none);
}

template <typename F>
[[noreturn]] void run_as_child(const unsigned seconds, double* const result, F f)
{
  int status = EXIT_SUCCESS;
  try
  {
    limit_processor_time(seconds);
    f(result);
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    status = EXIT_FAILURE;
  }
  _exit(status);
}

// Returns the numbers that `f(double*)` writes. `f` runs in a child process; if it crashes or
// exceeds its time, an exception reports it.
template <typename F>
std::vector<double> numbers_from_child(const std::size_t size, const unsigned seconds, F f)
{
  const Shared_doubles numbers(size);
  std::cout.flush();
  const pid_t child = fork();
  if(child < 0)
    throw std::runtime_error("no process can be started");
  if(child == 0)
    run_as_child(seconds, numbers.data(), f);
  int status = 0;
  waitpid(child, &status, 0);
  if(WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    throw std::runtime_error("takes more than " + std::to_string(seconds) + " s");
  if(WIFSIGNALED(status))
    throw std::runtime_error("crashes, signal " + std::to_string(WTERMSIG(status)));
  if(WEXITSTATUS(status) != EXIT_SUCCESS)
    throw std::runtime_error("fails");
  return {numbers.data(), numbers.data() + size};
}

#endif // BENCHMARK_CHILD_PROCESS_H
