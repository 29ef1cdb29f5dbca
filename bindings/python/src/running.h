// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_RUNNING_H
#define APPROXIMATE_GEODESICS_PYTHON_RUNNING_H

// Runs without the global interpreter lock, which is only acquired to check for signals and to
// report progress.

#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>
#include <thread>

namespace python {

namespace py = pybind11;
namespace AG = CGAL::Approximate_geodesics;

inline bool is_interpreter_ending()
{
#if PY_VERSION_HEX >= 0x030d0000
  return Py_IsFinalizing() != 0;
#else
  return _Py_IsFinalizing() != 0;
#endif
}

/*
 * Releases the lock during its lifetime.
 *
 * During interpreter shutdown, daemon threads may still run. If they request the lock, older
 * versions of Python unwind their stacks, which aborts the process if there are C++ frames; newer
 * versions block them until the process ends, and so does this class.
 */
class Unlocked
{
public:
  Unlocked() : m_state(PyEval_SaveThread()) {}
  ~Unlocked() { lock(); }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

  // Returns `f()`, called with the lock.
  template <typename F>
  auto with_lock(const F& f)
  {
    struct Unlock
    {
      Unlocked& owner;
      ~Unlock() { owner.m_state = PyEval_SaveThread(); }
    };
    lock();
    const Unlock unlock{*this};
    return f();
  }

private:
  void lock() const noexcept
  {
    if(is_interpreter_ending())
      wait_for_the_end();
    try
    {
      PyEval_RestoreThread(m_state);
    }
    catch(...) // shutdown has begun since the check
    {
      wait_for_the_end();
    }
  }

  [[noreturn]] static void wait_for_the_end()
  {
    for(;;)
      std::this_thread::sleep_for(std::chrono::hours(1));
  }

  PyThreadState* m_state;
};

// Returns `f(watch)`. `progress` is a callable, or None.
template <typename F>
auto run(const py::object& progress, const F& f)
{
  try
  {
    Unlocked unlocked;
    AG::Solver_watch watch;
    watch.go_further = [&] { return unlocked.with_lock([] { return PyErr_CheckSignals() == 0; }); };
    if(!progress.is_none())
      watch.on_progress = [&](const std::size_t number_done, const std::size_t number) {
        unlocked.with_lock([&] { progress(number_done, number); });
      };
    return f(watch);
  }
  catch(const AG::Solver_interrupted&)
  {
    throw py::error_already_set(); // raised by the signal handler
  }
}

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_RUNNING_H
