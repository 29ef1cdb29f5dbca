// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_SOLVERS_H
#define APPROXIMATE_GEODESICS_TEST_SOLVERS_H

#include "checks/expect_message.h"
#include "meshes/test_soup.h"

#include <CGAL/Approximate_geodesics/Solver/Solver.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodesics_test {

using CGAL::Approximate_geodesics::Solver;
using CGAL::Approximate_geodesics::Solver_options;
using CGAL::Approximate_geodesics::Solver_point;

struct Soup_arrays
{
  std::vector<double> coordinates;
  std::vector<int> corners;

  explicit Soup_arrays(const Soup& soup)
  {
    for(const Point& p : soup.points)
      coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
    for(const auto& t : soup.triangles)
      for(const std::size_t v : t)
        corners.push_back(static_cast<int>(v));
  }

  std::size_t number_of_vertices() const { return coordinates.size() / 3; }
  std::size_t number_of_faces() const { return corners.size() / 3; }
};

// A solver stays where it is.
struct Solver_of : Solver
{
  explicit Solver_of(const Soup_arrays& a, const Solver_options& options = Solver_options())
    : Solver(a.coordinates.data(),
             a.number_of_vertices(),
             a.corners.data(),
             a.number_of_faces(),
             options)
  {
  }
};

inline Solver_options bound(const std::optional<double> epsilon)
{
  Solver_options result;
  result.epsilon = epsilon;
  return result;
}

// A watch that ends everything as soon as it is asked, which is after some time.
inline CGAL::Approximate_geodesics::Solver_watch impatient_watch()
{
  CGAL::Approximate_geodesics::Solver_watch result;
  result.go_further = [] { return false; };
  return result;
}

inline std::vector<double> solver_distances(const Solver& solver,
                                            const std::vector<Solver_point>& sources)
{
  std::vector<double> result(solver.number_of_vertices());
  solver.find_distances(sources, result.data());
  return result;
}

inline std::vector<double> solver_distances(const Solver& solver)
{
  return solver_distances(solver, {Solver_point::at_vertex(3)});
}

inline void expect_refused(const std::string& message, const std::function<void()>& call)
{
  expect_texts<std::invalid_argument>(call, {message});
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_SOLVERS_H
