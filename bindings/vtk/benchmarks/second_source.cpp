// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances and paths from many points of a surface, one after another, by `Solver` and by the
// filters, which keep their graphs. Prints the shortest times in milliseconds, and what VTK adds,
// as a ratio.
//
// Usage: second_source MESH

#include "vtkApproximateGeodesicDistance.h"
#include "vtkApproximateGeodesicPath.h"

#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Approximate_geodesics/Solver/read_soup.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

struct Surface
{
  explicit Surface(const std::string& file)
  {
    std::vector<CGAL::Simple_cartesian<double>::Point_3> positions;
    std::vector<std::vector<std::size_t>> faces;
    AG::read_soup(file, positions, faces);
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    for(const auto& p : positions)
    {
      coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
      points->InsertNextPoint(p.x(), p.y(), p.z());
    }
    vtkNew<vtkCellArray> cells;
    for(const auto& face : faces)
    {
      cells->InsertNextCell(static_cast<int>(face.size()));
      for(const std::size_t v : face)
      {
        corners.push_back(static_cast<std::int64_t>(v));
        cells->InsertCellPoint(static_cast<vtkIdType>(v));
      }
    }
    data->SetPoints(points);
    data->SetPolys(cells);
  }

  std::size_t number_of_points() const { return coordinates.size() / 3; }

  std::vector<double> coordinates;
  std::vector<std::int64_t> corners;
  vtkNew<vtkPolyData> data;
};

// Calls both functions with many points, alternating, and prints the sums of their shortest times.
template <typename F, typename G>
void compare(const std::string& name,
             const Surface& surface,
             const F& by_solver,
             const G& by_filter)
{
  constexpr std::size_t number = 20, repetitions = 7;
  std::array<double, 2> sums{};
  for(std::size_t i = 0; i < number; ++i)
  {
    const auto v = static_cast<std::int64_t>(i * surface.number_of_points() / number);
    std::array<double, 2> shortest;
    shortest.fill(std::numeric_limits<double>::infinity());
    const auto measure = [&](double& time, const auto& f) {
      CGAL::Real_timer timer;
      timer.start();
      f(v);
      time = (std::min)(time, timer.time());
    };
    for(std::size_t j = 0; j < repetitions; ++j)
    {
      measure(shortest[0], by_solver);
      measure(shortest[1], by_filter);
    }
    for(std::size_t k = 0; k < 2; ++k)
      sums[k] += 1e3 * shortest[k] / number;
  }
  std::cout << std::left << std::setw(34) << name << std::right << std::fixed
            << std::setprecision(3) << std::setw(10) << sums[0] << std::setw(10) << sums[1]
            << std::setprecision(2) << std::setw(8) << sums[1] / sums[0] << "\n";
}

void compare_with_bound(const Surface& surface, const double epsilon)
{
  AG::Solver_options options;
  if(epsilon >= 0)
    options.epsilon = epsilon;
  const AG::Solver solver(surface.coordinates.data(), surface.number_of_points(),
                          surface.corners.data(), surface.corners.size() / 3, options);
  std::string bound = "along edges";
  if(epsilon >= 0)
    bound = "epsilon " + std::to_string(epsilon).substr(0, 4);

  vtkNew<vtkApproximateGeodesicDistance> distance;
  distance->SetInputData(surface.data);
  distance->SetEpsilon(epsilon);
  compare(
      "distances, " + bound, surface,
      [&](const std::int64_t v) {
        std::vector<double> distances(surface.number_of_points());
        solver.find_distances({AG::Solver_point::at_vertex(v)}, distances.data());
      },
      [&](const std::int64_t v) {
        distance->RemoveAllSources();
        distance->AddSource(v);
        distance->Update();
      });

  vtkNew<vtkApproximateGeodesicPath> path;
  path->SetInputData(surface.data);
  path->SetEpsilon(epsilon);
  path->SetStartVertex(static_cast<vtkIdType>(surface.number_of_points()) / 3);
  compare(
      "path, " + bound, surface,
      [&](const std::int64_t v) {
        std::vector<double> coordinates;
        solver.find_path(AG::Solver_point::at_vertex(path->GetStartVertex()),
                         AG::Solver_point::at_vertex(v), false, coordinates);
      },
      [&](const std::int64_t v) {
        path->SetEndVertex(v);
        path->Modified(); // the same path again
        path->Update();
      });
}

int main(int argc, char* argv[])
try
{
  if(argc != 2)
  {
    std::cerr << "Usage: second_source MESH\n";
    return EXIT_FAILURE;
  }
  const Surface surface(argv[1]);
  std::cout << surface.number_of_points()
            << " points; milliseconds of a search when the graph is there\n"
            << std::setw(44) << "Solver" << std::setw(10) << "filter" << std::setw(8) << "ratio"
            << "\n";
  for(const double epsilon : {-1., 0.1, 0.01, 0.})
    compare_with_bound(surface, epsilon);
}
catch(const std::exception& e)
{
  std::cerr << e.what() << "\n";
  return EXIT_FAILURE;
}
