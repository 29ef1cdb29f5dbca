// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtkApproximateGeodesicDistance.h"

#include "filters.h"

#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Distance_filter = vtkNew<vtkApproximateGeodesicDistance>;

// The array that the filter has added to the points of its input.
std::vector<double> values(vtkApproximateGeodesicDistance& filter,
                           const char* const name = "GeodesicDistance")
{
  std::vector<double> result;
  vtkDataArray* const array = filter.GetOutput()->GetPointData()->GetArray(name);
  for(vtkIdType i = 0; array != nullptr && i < array->GetNumberOfTuples(); ++i)
    result.push_back(array->GetComponent(i, 0));
  return result;
}

std::vector<double> distances(vtkApproximateGeodesicDistance& filter)
{
  EXPECT_EQ(errors_of_update(filter), "");
  return values(filter);
}

// The distances on a single surface from its point 0.
std::vector<double> distances_on(vtkPolyData* const surface, const double epsilon = 0)
{
  Distance_filter filter;
  filter->SetInputData(surface);
  filter->SetEpsilon(epsilon);
  filter->AddSource(0);
  return distances(*filter);
}

vtkSmartPointer<vtkSelection> selection(const int type, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> list;
  for(const vtkIdType i : ids)
    list->InsertNextValue(i);
  vtkNew<vtkSelectionNode> node;
  node->SetFieldType(type);
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetSelectionList(list);
  auto result = vtkSmartPointer<vtkSelection>::New();
  result->AddNode(node);
  return result;
}

class Distances_on_square : public testing::Test
{
protected:
  Distances_on_square()
  {
    m_filter->SetInputData(m_square);
    m_filter->SetEpsilon(0);
  }

  // Expects the distances from the nearest of some positions in the plane.
  void expect_distances_from(const std::vector<std::array<double, 2>>& positions)
  {
    const std::vector<double> found = distances(*m_filter);
    ASSERT_EQ(found.size(), std::size_t(n * n));
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      double expected = infinity;
      for(const auto& p : positions)
        expected = (std::min)(expected, std::hypot(double(i % n) - p[0], double(i / n) - p[1]));
      EXPECT_NEAR(found[i], expected, 1e-6) << "point " << i;
    }
  }

  void expect_error(const std::string& part)
  {
    m_filter->Modified();
    expect_part(errors_of_update(*m_filter), part);
    EXPECT_EQ(m_filter->GetOutput()->GetNumberOfPoints(), 0);
  }

  static constexpr std::size_t n = 11;
  vtkSmartPointer<vtkPolyData> m_square = square(n);
  Distance_filter m_filter;
};

} // namespace

TEST_F(Distances_on_square, are_those_from_the_nearest_of_all_sources)
{
  m_filter->AddSource(24);
  expect_distances_from({{2, 2}});
  EXPECT_STREQ(m_filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "GeodesicDistance");

  const auto positions = poly_data({{7.25, 3.5}, {1, 9}}, {});
  positions->GetPoints()->SetPoint(1, 1, 9, 5); // above the surface
  m_filter->SetSourceData(positions);
  expect_distances_from({{2, 2}, {7.25, 3.5}, {1, 9}});

  m_filter->SetSelectionData(selection(vtkSelectionNode::POINT, {120}));
  m_filter->GenerateLabelsOn();
  expect_distances_from({{2, 2}, {7.25, 3.5}, {1, 9}, {10, 10}});
  const std::vector<double> labels = values(*m_filter, "NearestSource");
  ASSERT_EQ(labels.size(), n * n);
  EXPECT_EQ(labels[24], 0);
  EXPECT_EQ(labels[3 * n + 7], 1);
  EXPECT_EQ(labels[9 * n + 1], 2);
  EXPECT_EQ(labels[120], 3);

  EXPECT_EQ(m_filter->GetNumberOfSources(), 1);
  EXPECT_EQ(m_filter->GetSource(0), 24);
  EXPECT_EQ(m_filter->GetSource(1), -1);
  m_filter->RemoveAllSources();
  m_filter->SetSourceData(nullptr);
  expect_distances_from({{10, 10}});
}

TEST_F(Distances_on_square, are_added_to_the_arrays_of_the_input)
{
  vtkNew<vtkFloatArray> heights, costs;
  heights->SetName("height");
  heights->SetNumberOfValues(n * n);
  heights->Fill(7);
  m_square->GetPointData()->SetScalars(heights);
  costs->SetName("cost");
  costs->SetNumberOfValues(m_square->GetNumberOfCells());
  costs->Fill(2);
  m_square->GetCellData()->SetScalars(costs);
  m_filter->AddSource(0);
  m_filter->GenerateLabelsOn();
  EXPECT_EQ(errors_of_update(*m_filter), "");
  vtkPolyData* const output = m_filter->GetOutput();
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 3);
  EXPECT_EQ(output->GetPointData()->GetArray("height"), heights.Get());
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "GeodesicDistance");
  EXPECT_EQ(output->GetCellData()->GetScalars(), costs.Get());
  EXPECT_EQ(output->GetPoints(), m_square->GetPoints());
  EXPECT_EQ(m_square->GetPointData()->GetScalars(), heights.Get());
  EXPECT_EQ(m_square->GetPointData()->GetNumberOfArrays(), 1);

  m_filter->SetDistanceArrayName("height"); // in place of that array
  EXPECT_EQ(errors_of_update(*m_filter), "");
  EXPECT_EQ(m_filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_EQ(m_filter->GetOutput()->GetPointData()->GetScalars()->GetTuple1(n - 1), n - 1.);
  EXPECT_EQ(heights->GetValue(n - 1), 7);
}

TEST_F(Distances_on_square, of_two_filters_on_one_input_are_independent)
{
  Distance_filter other;
  other->SetInputData(m_square);
  other->SetEpsilon(-1);
  other->AddSource(n * n - 1);
  m_filter->AddSource(0);
  const std::vector<double> found = distances(*m_filter), along_edges = distances(*other);
  const vtkMTimeType time = m_square->GetMTime();
  m_filter->Modified();
  EXPECT_EQ(distances(*m_filter), found);
  EXPECT_EQ(values(*other), along_edges);
  EXPECT_EQ(m_square->GetMTime(), time);
  for(std::size_t i = 0; i < n * n; ++i)
    EXPECT_LE(found[i], along_edges[n * n - 1 - i] + 1e-12);
}

TEST_F(Distances_on_square, are_those_from_all_points_of_selected_cells)
{
  m_filter->SetSelectionData(selection(vtkSelectionNode::CELL, {0, 1}));
  expect_distances_from({{0, 0}, {1, 0}, {0, 1}, {1, 1}});
}

TEST_F(Distances_on_square, keep_the_bound)
{
  m_filter->AddSource(3);
  const std::vector<double> exact = distances(*m_filter);
  m_filter->SetEpsilon(0.1);
  const std::vector<double> approximate = distances(*m_filter);
  m_filter->SetEpsilon(-1);
  const std::vector<double> along_edges = distances(*m_filter);
  for(std::size_t i = 0; i < n * n; ++i)
  {
    EXPECT_GE(approximate[i], exact[i] * (1 - 1e-12));
    EXPECT_LE(approximate[i], exact[i] * 1.1);
    EXPECT_GE(along_edges[i], exact[i] * (1 - 1e-12));
  }
  EXPECT_GT(*std::max_element(along_edges.begin(), along_edges.end()),
            1.02 * *std::max_element(exact.begin(), exact.end()));
}

TEST_F(Distances_on_square, keep_the_graph_until_the_input_or_a_parameter_changes)
{
  m_filter->SetEpsilon(0.1);
  m_filter->AddSource(0);
  const std::vector<double> before = distances(*m_filter);
  auto* const coordinates = vtkFloatArray::SafeDownCast(m_square->GetPoints()->GetData());
  ASSERT_NE(coordinates, nullptr);
  for(vtkIdType i = 0; i < coordinates->GetNumberOfValues(); ++i) // VTK cannot know
    coordinates->GetPointer(0)[i] *= 2;
  m_filter->RemoveAllSources();
  m_filter->AddSource(0);
  EXPECT_EQ(distances(*m_filter), before) << "of the graph of the old coordinates";
  coordinates->Modified();
  const std::vector<double> after = distances(*m_filter);
  for(std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(after[i], 2 * before[i], 1e-12);

  const auto other = square(n);
  m_filter->SetInputData(other);
  EXPECT_EQ(distances(*m_filter), before);
  m_filter->SetEpsilon(0);
  EXPECT_NE(distances(*m_filter), before);
}

TEST_F(Distances_on_square, have_isolines)
{
  m_filter->AddSource(0);
  m_filter->SetNumberOfIsolines(3);
  m_filter->SetDistanceArrayName("r");
  EXPECT_EQ(errors_of_update(*m_filter), "");
  vtkPolyData* const isolines = m_filter->GetOutput(1);
  EXPECT_EQ(isolines->GetNumberOfLines(), 3);
  EXPECT_STREQ(isolines->GetPointData()->GetScalars()->GetName(), "r");
  for(vtkIdType i = 0; i < isolines->GetNumberOfPoints(); ++i)
  {
    double p[3];
    isolines->GetPoint(i, p);
    EXPECT_NEAR(isolines->GetPointData()->GetScalars()->GetComponent(i, 0), std::hypot(p[0], p[1]),
                0.2);
  }
  EXPECT_EQ(values(*m_filter, "r").size(), n * n);
  m_filter->SetNumberOfIsolines(0);
  m_filter->Update();
  EXPECT_EQ(m_filter->GetOutput(1)->GetNumberOfPoints(), 0);
}

TEST_F(Distances_on_square, are_infinite_behind_forbidden_cells)
{
  vtkNew<vtkFloatArray> weights;
  weights->SetName("cost");
  for(vtkIdType c = 0; c < m_square->GetNumberOfCells(); ++c) // one row of cells is forbidden
    weights->InsertNextValue(
        c / vtkIdType(2 * (n - 1)) == 4 ? std::numeric_limits<float>::infinity() : 3.f);
  m_square->GetCellData()->AddArray(weights);
  m_filter->AddSource(0);
  m_filter->SetWeightsArrayName("cost");
  m_filter->SetEpsilon(0.2);
  m_filter->GenerateLabelsOn();
  m_filter->SetNumberOfIsolines(2);
  const std::vector<double> found = distances(*m_filter);
  const std::vector<double> labels = values(*m_filter, "NearestSource");
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    const bool is_behind = i / n > 4;
    EXPECT_EQ(found[i] == infinity, is_behind) << "point " << i;
    EXPECT_EQ(labels[i], is_behind ? -1 : 0);
  }
  EXPECT_NEAR(found[10], 30, 1e-5);
  vtkPolyData* const isolines = m_filter->GetOutput(1);
  EXPECT_EQ(isolines->GetNumberOfLines(), 2);
  for(vtkIdType i = 0; i < isolines->GetNumberOfPoints(); ++i)
    EXPECT_TRUE(std::isfinite(isolines->GetPoint(i)[0] + isolines->GetPoint(i)[1]));
}

TEST(Approximate_geodesic_distance, is_infinite_on_other_components)
{
  vtkNew<vtkSphereSource> sphere, other;
  other->SetCenter(20, 0, 0);
  vtkNew<vtkAppendPolyData> spheres;
  spheres->AddInputConnection(sphere->GetOutputPort());
  spheres->AddInputConnection(other->GetOutputPort());
  Distance_filter filter;
  filter->SetInputConnection(spheres->GetOutputPort());
  filter->AddSource(0);
  const std::vector<double> found = distances(*filter);
  ASSERT_EQ(found.size(), 100u);
  for(std::size_t i = 0; i < 100; ++i)
    EXPECT_EQ(found[i] == infinity, i >= 50);
}

TEST(Approximate_geodesic_distance, triangulates_polygons_and_strips)
{
  vtkNew<vtkSphereSource> sphere, quads;
  for(vtkSphereSource* const s : {sphere.Get(), quads.Get()})
  {
    s->SetThetaResolution(9);
    s->SetPhiResolution(7);
  }
  sphere->Update();
  const std::vector<double> expected = distances_on(sphere->GetOutput());

  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(sphere->GetOutputPort());
  strips->Update();
  ASSERT_GT(strips->GetOutput()->GetNumberOfStrips(), 0);
  const std::vector<double> on_strips = distances_on(strips->GetOutput());
  ASSERT_EQ(on_strips.size(), expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(on_strips[i], expected[i], 1e-12);

  quads->LatLongTessellationOn();
  quads->Update();
  ASSERT_EQ(quads->GetOutput()->GetPolys()->GetMaxCellSize(), 4);
  EXPECT_EQ(distances_on(quads->GetOutput()).size(), expected.size());

  // around the corner of an L, which is a single polygon that is not convex
  const auto bent =
      poly_data({{0, 2}, {0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}}, {{0, 1, 2, 3, 4, 5}});
  EXPECT_NEAR(distances_on(bent)[3], 1 + std::sqrt(2.), 1e-12);
}

TEST(Approximate_geodesic_distance, does_not_depend_on_orientations)
{
  const auto surface = square(11);
  const std::vector<double> expected = distances_on(surface);
  const vtkIdType number = surface->GetNumberOfPolys();
  for(vtkIdType c = 0; c < number; c += 3)
    surface->GetPolys()->ReverseCellAtId(c);
  surface->GetPolys()->Modified();
  const std::vector<double> found = distances_on(surface);
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-12);

  // a strip that is joined with a twist cannot be oriented
  Distance_filter filter;
  filter->SetInputData(poly_data({{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 3}},
                                 {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}));
  filter->AddSource(0);
  expect_part(errors_of_update(*filter), "orientation");
}

TEST(Approximate_geodesic_distance, uses_weights_of_polygons)
{
  const auto squares =
      poly_data({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
  vtkNew<vtkIdTypeArray> vertex; // among the cells, it has a weight, and connects nothing
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({3});
  squares->SetVerts(verts);
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("cost");
  for(const double w : {100., 1., 3.})
    weights->InsertNextValue(w);
  squares->GetCellData()->AddArray(weights);
  Distance_filter filter;
  filter->SetInputData(squares);
  filter->SetWeightsArrayName("cost");
  filter->SetEpsilon(0.01);
  filter->AddSource(0);
  const std::vector<double> found = distances(*filter);
  EXPECT_NEAR(found[1], 1, 1e-12);
  EXPECT_NEAR(found[4], 4, 1e-12);
}

TEST(Approximate_geodesic_distance, locates_sources_beside_faces_without_area)
{
  // the last face is the side of the others, from (0, 0) to (4, 0)
  Distance_filter filter;
  filter->SetInputData(
      poly_data({{0, 0}, {4, 0}, {2, 3}, {1, 0}}, {{0, 3, 2}, {3, 1, 2}, {1, 3, 0}}));
  filter->SetEpsilon(0);
  for(const double x : {0., 0.5, 1., 3., 4.})
  {
    filter->SetSourceData(poly_data({{x, -1}}, {}));
    const std::vector<double> found = distances(*filter);
    EXPECT_NEAR(found[0], x, 1e-9);
    EXPECT_NEAR(found[1], 4 - x, 1e-9);
  }
  filter->SetInputData(poly_data({{0, 0}, {4, 0}, {1, 0}}, {{0, 1, 2}}));
  EXPECT_NEAR(distances(*filter)[0], 4, 1e-9); // from the last source
}

TEST_F(Distances_on_square, report_what_is_wrong_with_sources)
{
  expect_error("no source");
  m_filter->AddSource(121);
  expect_error("source 0 is vertex 121");
  m_filter->RemoveAllSources();
  m_filter->SetSelectionData(selection(vtkSelectionNode::CELL, {200}));
  errors_of_update(*m_filter); // VTK itself may leave it out
  m_filter->SetSelectionData(selection(vtkSelectionNode::ROW, {0}));
  expect_error("neither points nor cells");
  m_filter->SetSelectionData(nullptr);
  const auto nowhere = poly_data({{0, 0}, {infinity, 0}}, {});
  m_filter->SetSourceData(nowhere);
  expect_error("point 1 is (inf, 0, 0)");
  vtkNew<vtkPolyData> nothing;
  m_filter->SetInputData(nothing);
  expect_error("the mesh has no faces to locate points in");
  m_filter->SetSourceData(nullptr);
  m_filter->AddSource(0);
  expect_error("source 0 is vertex 0");
}

TEST_F(Distances_on_square, report_what_is_wrong_with_cells)
{
  m_filter->AddSource(0);
  const auto expect_error_of = [this](vtkPolyData* const surface, const std::string& part) {
    m_filter->SetInputData(surface);
    expect_error(part);
  };
  const std::vector<std::array<double, 2>> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 2}, {3, -1}};
  expect_error_of(poly_data(corners, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
                  "face 0, face 1 and face 2 share it");
  expect_error_of(poly_data(corners, {{0, 1, 2, 3}, {1, 0, 4}, {0, 1, 5}}),
                  "vtkTriangleFilter would make");
  expect_error_of(poly_data(corners, {{0, 1, 2}, {1, 7, 2}}), "cell 1 has point 7");
  expect_error_of(poly_data(corners, {{0, 1, 2}, {1, -1, 2}}), "cell 1 has point -1");
  expect_error_of(poly_data(corners, {{0, 1, 2}, {1, 2}}), "cell 1 has 2 points");
  expect_error_of(poly_data(corners, {{0, 1, 2}, {1, 1, 2}}), "face 1");
  expect_error_of(poly_data({{0, 0}, {0, 0}, {0, 0}, {0, 0}}, {{0, 1, 2, 3}}),
                  "cell 0, a polygon of 4 points, cannot be triangulated");
  for(const double x : {infinity, std::numeric_limits<double>::quiet_NaN()})
    expect_error_of(poly_data({{0, 0}, {1, 0}, {x, 1}}, {{0, 1, 2}}), "vertex 2 is not finite");

  const auto with_line = poly_data(corners, {{0, 1, 2}});
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({2, 3});
  with_line->SetLines(lines);
  expect_error_of(with_line, "cell 0 is a line");
}

TEST_F(Distances_on_square, end_when_the_filter_is_aborted)
{
  struct Progress
  {
    double largest = 0, last_allowed = 1;
  } progress;
  vtkNew<vtkCallbackCommand> follow;
  follow->SetClientData(&progress);
  follow->SetCallback([](vtkObject* const filter, unsigned long, void* const data, void* amount) {
    auto& p = *static_cast<Progress*>(data);
    p.largest = (std::max)(p.largest, *static_cast<double*>(amount));
    if(p.largest > p.last_allowed)
      vtkAlgorithm::SafeDownCast(filter)->AbortExecuteOn();
  });
  m_filter->AddObserver(vtkCommand::ProgressEvent, follow);
  const auto large = square(300);
  m_filter->SetInputData(large);
  m_filter->SetEpsilon(0.01);
  m_filter->AddSource(0);
  progress.last_allowed = -1; // at once
  EXPECT_EQ(errors_of_update(*m_filter), "");
  EXPECT_EQ(m_filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_LT(progress.largest, 1);

  progress.last_allowed = 1;
  m_filter->SetEpsilon(-1);
  EXPECT_EQ(distances(*m_filter).size(), 90000u);
  EXPECT_EQ(progress.largest, 1);

  progress = {0, 0.999}; // when distances are found, and the graph is there
  m_filter->SetNumberOfIsolines(VTK_INT_MAX);
  EXPECT_EQ(errors_of_update(*m_filter), "");
  EXPECT_EQ(m_filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(Distances_on_square, print_their_parameters)
{
  std::ostringstream text;
  m_filter->Print(text);
  for(const char* const name :
      {"NumberOfSources: 0", "Epsilon: 0", "GenerateLabels", "NumberOfIsolines"})
    expect_part(text.str(), name);
}
