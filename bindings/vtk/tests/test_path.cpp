// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtkApproximateGeodesicPath.h"

#include "filters.h"

#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkDijkstraGraphGeodesicPath.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Path_filter = vtkNew<vtkApproximateGeodesicPath>;

double length_of_path(vtkApproximateGeodesicPath& filter)
{
  EXPECT_EQ(errors_of_update(filter), "");
  return length(*filter.GetOutput());
}

// A surface, and the last path on it, from one corner of a square to the opposite one.
class Path_on_square : public testing::Test
{
protected:
  Path_on_square()
  {
    m_filter->SetInputData(m_square);
    m_filter->SetEndVertex(n * n - 1);
  }

  double length_of_path() { return ::length_of_path(*m_filter); }

  static constexpr int n = 11;
  static inline const double diagonal = std::sqrt(2.) * (n - 1);
  vtkSmartPointer<vtkPolyData> m_square = square(n);
  Path_filter m_filter;
};

} // namespace

// The same program as for vtkDijkstraGraphGeodesicPath, but for the class: the types of the two
// filters are the parameter.
template <typename Filter>
class Paths_on_spheres : public testing::Test
{
};

using Filters = testing::Types<vtkDijkstraGraphGeodesicPath, vtkApproximateGeodesicPath>;
TYPED_TEST_SUITE(Paths_on_spheres, Filters);

TYPED_TEST(Paths_on_spheres, are_found_on_one_and_not_between_two)
{
  vtkNew<vtkSphereSource> sphere, other;
  sphere->SetRadius(3);
  other->SetCenter(20, 0, 0);
  vtkNew<vtkAppendPolyData> spheres;
  spheres->AddInputConnection(sphere->GetOutputPort());
  vtkNew<TypeParam> filter;
  spheres->Update();
  filter->SetInputData(spheres->GetOutput()); // which changes
  const vtkIdType end = spheres->GetOutput()->GetNumberOfPoints() - 1;
  filter->SetStartVertex(0);
  filter->SetEndVertex(end);
  filter->Update();
  vtkPolyData* const path = filter->GetOutput();
  ASSERT_GT(path->GetNumberOfPoints(), 1);
  EXPECT_EQ(path->GetNumberOfCells(), 1);
  ASSERT_EQ(filter->GetIdList()->GetNumberOfIds(), path->GetNumberOfPoints());
  EXPECT_EQ(filter->GetIdList()->GetId(0), end);
  EXPECT_EQ(filter->GetIdList()->GetId(path->GetNumberOfPoints() - 1), 0);

  spheres->AddInputConnection(other->GetOutputPort());
  spheres->Update();
  filter->SetEndVertex(spheres->GetOutput()->GetNumberOfPoints() - 1);
  filter->Update();
  ASSERT_NE(filter->GetOutput()->GetPoints(), nullptr);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(Approximate_geodesic_path, is_as_long_as_that_of_VTK_along_edges)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(21);
  sphere->SetPhiResolution(17);
  Path_filter filter;
  vtkNew<vtkDijkstraGraphGeodesicPath> dijkstra;
  filter->SetInputConnection(sphere->GetOutputPort());
  dijkstra->SetInputConnection(sphere->GetOutputPort());
  sphere->Update();
  vtkPolyData* const surface = sphere->GetOutput();
  for(vtkIdType end = 1; end < surface->GetNumberOfPoints(); end += 17)
  {
    filter->SetEndVertex(end);
    dijkstra->SetEndVertex(end);
    dijkstra->Update();
    EXPECT_NEAR(length_of_path(*filter), length(*dijkstra->GetOutput()), 1e-6);
    for(vtkIdType i = 0; i < filter->GetIdList()->GetNumberOfIds(); ++i)
    {
      const double* const p = filter->GetOutput()->GetPoint(i);
      double q[3];
      surface->GetPoint(filter->GetIdList()->GetId(i), q);
      EXPECT_EQ(vtkMath::Distance2BetweenPoints(p, q), 0);
    }
  }
  vtkNew<vtkDoubleArray> weights, expected;
  filter->GetCumulativeWeights(weights);
  dijkstra->GetCumulativeWeights(expected);
  ASSERT_EQ(weights->GetNumberOfValues(), expected->GetNumberOfValues());
  for(vtkIdType v = 0; v < weights->GetNumberOfValues(); ++v)
    EXPECT_NEAR(weights->GetValue(v), expected->GetValue(v), 1e-6);
}

TEST_F(Path_on_square, keeps_the_bound)
{
  m_filter->SetStartVertex(3); // of no diagonal
  const double shortest = distance(*m_square, 3, n * n - 1);
  EXPECT_GT(length_of_path(), 1.02 * shortest);
  m_filter->SetEpsilon(0.01);
  EXPECT_LE(length_of_path(), 1.01 * shortest);
  m_filter->SetEpsilon(0);
  EXPECT_NEAR(length_of_path(), shortest, 1e-5); // the points are single precision
  EXPECT_NEAR(m_filter->GetLength(), shortest, 1e-12);
  ASSERT_GT(m_filter->GetIdList()->GetNumberOfIds(), 2);
  EXPECT_EQ(m_filter->GetIdList()->GetId(1), -1) << "the path crosses an edge there";
  m_filter->SetEpsilon(-1);
  m_filter->StraightenOn();
  EXPECT_NEAR(length_of_path(), shortest, 1e-5);
}

TEST_F(Path_on_square, of_one_point_is_that_point)
{
  for(const double epsilon : {-1., 0., 0.1})
  {
    m_filter->SetEpsilon(epsilon);
    m_filter->SetStartVertex(n * n - 1);
    EXPECT_EQ(length_of_path(), 0);
    EXPECT_EQ(m_filter->GetLength(), 0);
    EXPECT_GE(m_filter->GetOutput()->GetNumberOfPoints(), 1);
  }
}

TEST_F(Path_on_square, costs_what_its_cells_do)
{
  const vtkIdType number = m_square->GetNumberOfCells();
  vtkNew<vtkFloatArray> weights;
  weights->SetName("cost");
  for(vtkIdType c = 0; c < number; ++c) // one cell costs nothing
    weights->InsertNextValue(c == number / 2 ? 0.f : 2.f);
  m_square->GetCellData()->AddArray(weights);
  m_filter->SetWeightsArrayName("cost");
  for(const double epsilon : {-1., 0.5})
  {
    m_filter->SetEpsilon(epsilon);
    length_of_path();
    EXPECT_LE(m_filter->GetLength(), 2 * 1.5 * diagonal);
    EXPECT_GT(m_filter->GetLength(), diagonal);
  }
  for(vtkIdType c = 0; c < number; ++c)
    weights->SetValue(c, std::numeric_limits<float>::infinity());
  weights->Modified();
  length_of_path();
  EXPECT_EQ(m_filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(m_filter->GetLength(), infinity);
}

TEST_F(Path_on_square, follows_large_scalars)
{
  vtkNew<vtkFloatArray> scalars; // large along two sides
  for(int i = 0; i < n * n; ++i)
    scalars->InsertNextValue(i % n == n - 1 || i < n ? 10.f : 1.f);
  m_square->GetPointData()->SetScalars(scalars);
  EXPECT_NEAR(length_of_path(), diagonal, 1e-5);
  m_filter->UseScalarWeightsOn();
  EXPECT_NEAR(length_of_path(), 2 * (n - 2) + std::sqrt(2.), 1e-5); // the corner is cut
}

TEST_F(Path_on_square, goes_around_points_that_repel_it)
{
  constexpr vtkIdType middle = n * n / 2;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(m_square->GetPoint(middle));
  points->InsertNextPoint(m_square->GetPoint(0)); // the start, which does not count
  m_filter->SetRepelVertices(points);
  length_of_path();
  EXPECT_GE(m_filter->GetIdList()->IsId(middle), 0);
  m_filter->RepelPathFromVerticesOn();
  EXPECT_GT(length_of_path(), diagonal + 0.1);
  EXPECT_LT(m_filter->GetIdList()->IsId(middle), 0);
  m_filter->SetEpsilon(0.1);
  const double around = length_of_path();
  EXPECT_GT(around, diagonal + 0.07);
  EXPECT_LT(around, 1.2 * diagonal);
}

TEST_F(Path_on_square, gives_distances_up_to_its_end)
{
  for(const double epsilon : {-1., 0., 0.1})
  {
    m_filter->SetEpsilon(epsilon);
    m_filter->SetEndVertex(5);
    m_filter->SetStopWhenEndReached(epsilon == 0);
    length_of_path();
    vtkNew<vtkDoubleArray> weights;
    m_filter->GetCumulativeWeights(weights);
    ASSERT_EQ(weights->GetNumberOfValues(), n * n);
    EXPECT_EQ(weights->GetValue(0), 0);
    EXPECT_NEAR(weights->GetValue(5), 5, 1e-6);
    EXPECT_EQ(weights->GetValue(n * n - 1) == infinity, epsilon == 0);
  }
}

TEST_F(Path_on_square, gives_the_distance_of_its_end_also_if_it_is_straightened)
{
  m_filter->SetStartVertex(3);
  m_filter->StraightenOn();
  m_filter->StopWhenEndReachedOn();
  const double straight = length_of_path();
  vtkNew<vtkDoubleArray> weights;
  m_filter->GetCumulativeWeights(weights);
  ASSERT_EQ(weights->GetNumberOfValues(), n * n);
  EXPECT_GT(weights->GetValue(n * n - 1), straight); // along edges
  EXPECT_LT(weights->GetValue(n * n - 1), infinity);
}

TEST_F(Path_on_square, reports_what_is_wrong)
{
  const auto expect_error = [this](const std::string& part) {
    expect_part(errors_of_update(*m_filter), part);
    EXPECT_EQ(m_filter->GetOutput()->GetNumberOfPoints(), 0);
    vtkNew<vtkDoubleArray> weights;
    m_filter->GetCumulativeWeights(weights);
    EXPECT_EQ(weights->GetNumberOfValues(), 0);
    m_filter->Modified();
  };
  m_filter->SetEndVertex(n * n);
  expect_error("target is vertex 121");
  m_filter->SetEndVertex(5);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, std::numeric_limits<double>::quiet_NaN(), 0);
  m_filter->SetRepelVertices(points);
  m_filter->RepelPathFromVerticesOn();
  expect_error("point 0 of RepelVertices is not finite");
  m_filter->RepelPathFromVerticesOff();
  m_filter->SetStartVertex(-1);
  expect_error("source is vertex -1");
  m_filter->SetStartVertex(0);
  m_filter->SetEpsilon(std::numeric_limits<double>::quiet_NaN());
  expect_error("epsilon is nan");
  m_filter->SetEpsilon(0);
  m_filter->SetWeightsArrayName("cost");
  expect_error("no array 'cost'");
  vtkNew<vtkFloatArray> weights;
  weights->SetName("cost");
  weights->SetNumberOfComponents(2);
  weights->SetNumberOfTuples(m_square->GetNumberOfCells());
  weights->Fill(1);
  m_square->GetCellData()->AddArray(weights);
  expect_error("200 tuples of 2 numbers");
  weights->SetNumberOfComponents(1);
  weights->SetNumberOfTuples(m_square->GetNumberOfCells());
  weights->Fill(1);
  weights->Modified();
  expect_error("epsilon"); // exact distances do not have weights
  m_filter->SetEpsilon(0.1);
  weights->SetValue(17, -1);
  weights->Modified();
  expect_error("17");
  m_filter->SetWeightsArrayName(nullptr);
  EXPECT_EQ(errors_of_update(*m_filter), "");
}

TEST(Approximate_geodesic_path, needs_points)
{
  Path_filter filter;
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  filter->SetRepelVertices(points);
  filter->RepelPathFromVerticesOn();
  expect_part(errors_of_update(*filter), "they are numbered from 0, and there are 0");
}

TEST_F(Path_on_square, is_not_searched_further_when_it_is_aborted)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* const filter, unsigned long, void*, void*) {
    vtkAlgorithm::SafeDownCast(filter)->AbortExecuteOn();
  });
  const auto large = square(300);
  m_filter->SetInputData(large);
  m_filter->SetEpsilon(0.01);
  m_filter->SetEndVertex(large->GetNumberOfPoints() - 1);
  const auto observer = m_filter->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_EQ(errors_of_update(*m_filter), "");
  EXPECT_EQ(m_filter->GetOutput()->GetNumberOfPoints(), 0);
  m_filter->RemoveObserver(observer);
  m_filter->SetEpsilon(-1); // which is fast
  EXPECT_NEAR(length_of_path(), std::sqrt(2.) * 299, 1e-3);
}

TEST_F(Path_on_square, prints_its_parameters)
{
  std::ostringstream text;
  m_filter->Print(text);
  for(const char* const name :
      {"Epsilon: -1", "Straighten: 0", "StopWhenEndReached", "RepelVertices"})
    expect_part(text.str(), name);
}
