// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_RUNNING_H
#define APPROXIMATE_GEODESICS_PYTHON_RUNNING_H

// Runs without the global interpreter lock, which is only acquired to check for signals and to
// report progress.

#include "interpreter_lock.h"

#include <CGAL/Approximate_geodesics/Solver/Solver_watch.h>

#include <pybind11/pybind11.h>

#include <cstddef>

namespace python {

namespace py = pybind11;
namespace AG = CGAL::Approximate_geodesics;

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
