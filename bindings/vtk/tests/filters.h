// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_VTK_TESTS_FILTERS_H
#define APPROXIMATE_GEODESICS_VTK_TESTS_FILTERS_H

// Surfaces, and updates of filters whose errors are collected.

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

// Points in the plane, and faces of any number of points.
inline vtkSmartPointer<vtkPolyData> poly_data(const std::vector<std::array<double, 2>>& points,
                                              const std::vector<std::vector<vtkIdType>>& faces)
{
  vtkNew<vtkPoints> positions;
  for(const auto& p : points)
    positions->InsertNextPoint(p[0], p[1], 0);
  vtkNew<vtkCellArray> cells;
  for(const auto& face : faces)
    cells->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(positions);
  result->SetPolys(cells);
  return result;
}

// A square of n x n points with integer coordinates, each cell split along the diagonal of equal
// steps. Point i is at (i % n, i / n).
inline vtkSmartPointer<vtkPolyData> square(const int n)
{
  std::vector<std::array<double, 2>> points;
  std::vector<std::vector<vtkIdType>> faces;
  for(int y = 0; y < n; ++y)
    for(int x = 0; x < n; ++x)
    {
      points.push_back({double(x), double(y)});
      const vtkIdType v = y * n + x;
      if(x == n - 1 || y == n - 1)
        continue;
      faces.push_back({v, v + 1, v + n + 1});
      faces.push_back({v, v + n + 1, v + n});
    }
  return poly_data(points, faces);
}

inline double distance(vtkPolyData& data, const vtkIdType a, const vtkIdType b)
{
  double p[3], q[3];
  data.GetPoint(a, p);
  data.GetPoint(b, q);
  return std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
}

// The length of the polyline through all points.
inline double length(vtkPolyData& path)
{
  double result = 0;
  for(vtkIdType i = 1; i < path.GetNumberOfPoints(); ++i)
    result += distance(path, i - 1, i);
  return result;
}

// Updates a filter, and returns the messages of its errors.
inline std::string errors_of_update(vtkAlgorithm& filter)
{
  std::string result;
  vtkNew<vtkCallbackCommand> collect;
  collect->SetClientData(&result);
  collect->SetCallback([](vtkObject*, unsigned long, void* const text, void* const message) {
    *static_cast<std::string*>(text) += static_cast<const char*>(message);
  });
  const auto of_filter = filter.AddObserver(vtkCommand::ErrorEvent, collect);
  const auto of_executive = filter.GetExecutive()->AddObserver(vtkCommand::ErrorEvent, collect);
  filter.Update();
  filter.RemoveObserver(of_filter);
  filter.GetExecutive()->RemoveObserver(of_executive);
  return result;
}

// Expects that a part of a text is there.
inline void expect_part(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in '" << text << "'";
}

#endif // APPROXIMATE_GEODESICS_VTK_TESTS_FILTERS_H
