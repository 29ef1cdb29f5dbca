// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Uses the installed headers for plain arrays: a file of a tetrahedron has 4 points and 4 faces.

#include <CGAL/Approximate_geodesics/Solver/read_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

int main()
{
  const char* const file = "tetrahedron.off";
  std::ofstream(file) << "OFF\n4 4 0\n0 0 0\n3 0 0\n0 4 0\n0 0 12\n"
                         "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  CGAL::Approximate_geodesics::read_soup(file, points, faces);
  std::remove(file);
  return points.size() == 4 && faces.size() == 4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
