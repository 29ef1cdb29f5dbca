// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_RUNNING_H
#define APPROXIMATE_GEODESICS_PYTHON_RUNNING_H

// Runs without the lock of the interpreter, which is taken only to ask for signals, and to tell of
// progress.

#include "interpreter_lock.h"

#include <CGAL/Approximate_geodesics/Solver/Solver_watch.h>

#include <pybind11/pybind11.h>

#include <cstddef>

namespace python {

namespace py = pybind11;
namespace AG = CGAL::Approximate_geodesics;

// Calls `f(watch)`, and returns what it returns. `progress` is a callable, or None.
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
    throw py::error_already_set(); // what the handler of the signal has raised
  }
}

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_RUNNING_H
