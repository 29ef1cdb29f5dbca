// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_PYTHON_FILES_H
#define APPROXIMATE_GEODESICS_PYTHON_FILES_H

// Reading and writing of solvers, as files or bytes, and reading of meshes.

#include "arrays.h"
#include "running.h"

#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Approximate_geodesics/Solver/read_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace python {

// Has the reason in `errno`, if the system has told one.
[[noreturn]] inline void throw_error_of_file(const std::string& file)
{
  if(errno == 0)
    errno = EIO;
  PyErr_SetFromErrnoWithFilename(PyExc_OSError, file.c_str());
  throw py::error_already_set();
}

inline void save(const AG::Solver& solver, const std::string& file)
{
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  try
  {
    const Unlocked unlocked;
    solver.save(out);
    out.close();
  }
  catch(const std::runtime_error&)
  {
    out.setstate(std::ios::failbit);
  }
  if(!out)
    throw_error_of_file(file);
}

// Reads a solver, up to the end of the stream.
inline std::unique_ptr<AG::Solver> read_solver(std::istream& in, const std::size_t threads)
{
  return run(py::none(), [&](const AG::Solver_watch& watch) {
    auto result = std::make_unique<AG::Solver>(in, threads, watch);
    if(in.peek() != std::istream::traits_type::eof())
      throw std::invalid_argument("there are extra bytes after the solver");
    return result;
  });
}

inline std::unique_ptr<AG::Solver> load(const std::string& file, const std::size_t threads)
{
  std::ifstream in(file, std::ios::binary);
  if(!in)
    throw_error_of_file(file);
  return read_solver(in, threads);
}

inline py::bytes to_bytes(const AG::Solver& solver)
{
  const std::string result = [&] {
    const Unlocked unlocked;
    std::ostringstream out(std::ios::binary);
    solver.save(out);
    return out.str();
  }();
  return result;
}

inline std::unique_ptr<AG::Solver> from_bytes(const py::bytes& bytes, const std::size_t threads)
{
  std::istringstream in(std::string(bytes), std::ios::binary);
  return read_solver(in, threads);
}

// Reads the vertices and faces of a mesh in a format that CGAL supports.
inline py::tuple read_mesh(const std::string& file)
{
  if(!std::ifstream(file))
    throw_error_of_file(file);
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  {
    const Unlocked unlocked;
    AG::read_soup(file, points, faces);
  }
  std::vector<double> coordinates;
  for(const auto& p : points)
    coordinates.insert(coordinates.end(), p.cartesian_begin(), p.cartesian_end());
  std::vector<std::int32_t> corners;
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    if(faces[f].size() != 3)
      throw std::invalid_argument("face " + std::to_string(f) + " of " + file + " has " +
                                  std::to_string(faces[f].size()) + " vertices; it must have 3");
    for(const std::size_t v : faces[f])
      corners.push_back(static_cast<std::int32_t>(v));
  }
  const auto number_of_faces = static_cast<py::ssize_t>(faces.size());
  return py::make_tuple(moved_points(std::move(coordinates)),
                        moved(std::move(corners), {number_of_faces, 3}));
}

} // namespace python

#endif // APPROXIMATE_GEODESICS_PYTHON_FILES_H
