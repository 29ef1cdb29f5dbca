// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Geodesic_surface.h"

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_locator.h>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <unordered_set>

namespace approximate_geodesics_vtk {
namespace {

using AG::internal::reject;

// The faces that a poly data is made of, and their cells.
class Triangles
{
public:
  // Triangulates polygons and strips. Vertices among the cells connect nothing, and are left out.
  explicit Triangles(vtkPolyData& input)
    : m_points(input.GetPoints()), m_number_of_points(input.GetNumberOfPoints())
  {
    vtkIdType cell = input.GetNumberOfVerts();
    if(input.GetNumberOfLines() > 0)
      reject("cell " + std::to_string(cell) +
             " is a line, which is not a part of a surface; vtkTriangleFilter removes lines if its "
             "PassLines is off");
    m_corners.reserve(3 * static_cast<std::size_t>(input.GetNumberOfPolys()));
    for_each_cell(*input.GetPolys(), cell, &Triangles::add_polygon);
    for_each_cell(*input.GetStrips(), cell, &Triangles::add_strip);
  }

  const std::vector<vtkIdType>& corners() const { return m_corners; }
  const std::vector<vtkIdType>& cells() const { return m_cells; }

  // Returns whether faces have the same numbers as cells.
  bool are_all_cells() const
  {
    return m_cells.empty() || m_cells.back() == static_cast<vtkIdType>(m_cells.size()) - 1;
  }

  vtkSmartPointer<vtkPolyData> surface() const
  {
    vtkNew<vtkCellArray> faces;
    for(std::size_t i = 0; i < m_corners.size(); i += 3)
      faces->InsertNextCell(3, &m_corners[i]);
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetPoints(m_points);
    result->SetPolys(faces);
    return result;
  }

  // Flips faces until adjacent ones have the same orientation, if that is possible.
  void orient()
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(surface());
    normals->ConsistencyOn();
    normals->SplittingOff();
    normals->ComputePointNormalsOff();
    normals->ComputeCellNormalsOn(); // otherwise, it does nothing
    normals->Update();
    m_corners.clear();
    const auto it = vtk::TakeSmartPointer(normals->GetOutput()->GetPolys()->NewIterator());
    for(it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      it->GetCurrentCell(size, points);
      m_corners.insert(m_corners.end(), points, points + size);
    }
  }

private:
  using Add = void (Triangles::*)(vtkIdType cell, vtkIdType size, const vtkIdType* points);

  void for_each_cell(vtkCellArray& cells, vtkIdType& cell, const Add add)
  {
    const auto it = vtk::TakeSmartPointer(cells.NewIterator());
    for(it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      it->GetCurrentCell(size, points);
      if(size < 3)
        reject("cell " + std::to_string(cell) + " has " + std::to_string(size) +
               " points, fewer than a triangle");
      for(vtkIdType i = 0; i < size; ++i)
        if(points[i] < 0 || points[i] >= m_number_of_points)
          reject("cell " + std::to_string(cell) + " has point " + std::to_string(points[i]) +
                 "; points are numbered from 0, and there are " +
                 std::to_string(m_number_of_points));
      (this->*add)(cell, size, points);
    }
  }

  void add_polygon(const vtkIdType cell, const vtkIdType size, const vtkIdType* const points)
  {
    if(size == 3)
      return add_face(cell, points[0], points[1], points[2]);
    m_polygon->Initialize(static_cast<int>(size), points, m_points);
    if(m_polygon->Triangulate(0, m_ids, m_copies) == 0 || m_ids->GetNumberOfIds() != 3 * (size - 2))
      reject("cell " + std::to_string(cell) + ", a polygon of " + std::to_string(size) +
             " points, cannot be triangulated");
    for(vtkIdType i = 0; i < m_ids->GetNumberOfIds(); i += 3)
      add_face(cell, m_ids->GetId(i), m_ids->GetId(i + 1), m_ids->GetId(i + 2));
  }

  void add_strip(const vtkIdType cell, const vtkIdType size, const vtkIdType* const points)
  {
    for(vtkIdType i = 0; i + 2 < size; ++i) // every other face of a strip is flipped
      add_face(cell, points[i], points[i + 1 + i % 2], points[i + 2 - i % 2]);
  }

  void add_face(const vtkIdType cell, const vtkIdType a, const vtkIdType b, const vtkIdType c)
  {
    m_corners.insert(m_corners.end(), {a, b, c});
    m_cells.push_back(cell);
  }

  vtkSmartPointer<vtkPoints> m_points;
  vtkIdType m_number_of_points;
  std::vector<vtkIdType> m_corners, m_cells;
  vtkNew<vtkPolygon> m_polygon;
  vtkNew<vtkIdList> m_ids;
  vtkNew<vtkPoints> m_copies;
};

std::vector<double> coordinates_of(vtkPolyData& points)
{
  std::vector<double> result(3 * static_cast<std::size_t>(points.GetNumberOfPoints()));
  for(vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i)
    points.GetPoint(i, result.data() + 3 * i);
  return result;
}

// Multiplies the weights of faces by those of their cells.
void multiply_by_array(std::vector<double>& weights,
                       vtkPolyData& input,
                       const std::vector<vtkIdType>& cells,
                       const std::string& name)
{
  vtkDataArray* const array = input.GetCellData()->GetArray(name.c_str());
  if(array == nullptr)
    reject("the input has no array '" + name + "' of numbers of cells");
  if(array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != input.GetNumberOfCells())
    reject("the array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) +
           " tuples of " + std::to_string(array->GetNumberOfComponents()) +
           " numbers; weights are one number for each of " +
           std::to_string(input.GetNumberOfCells()) + " cells");
  for(std::size_t f = 0; f < weights.size(); ++f)
    weights[f] *= array->GetComponent(cells[f], 0);
}

// Multiplies the weights of faces by the mean cost of their corners, which is that of
// vtkDijkstraGraphGeodesicPath: 1 / s^2, or 1 if the scalar s is 0.
void multiply_by_scalars(std::vector<double>& weights,
                         vtkPolyData& input,
                         const std::vector<vtkIdType>& corners)
{
  vtkDataArray* const scalars = input.GetPointData()->GetScalars();
  if(scalars == nullptr)
    return; // as there
  if(scalars->GetNumberOfTuples() != input.GetNumberOfPoints())
    reject("there are " + std::to_string(scalars->GetNumberOfTuples()) + " scalars of " +
           std::to_string(input.GetNumberOfPoints()) + " points");
  const auto cost = [scalars](const vtkIdType v) {
    const double s = scalars->GetComponent(v, 0);
    return s * s != 0 ? 1 / (s * s) : 1;
  };
  for(std::size_t f = 0; f < weights.size(); ++f)
    weights[f] *= (cost(corners[3 * f]) + cost(corners[3 * f + 1]) + cost(corners[3 * f + 2])) / 3;
}

void make_expensive(std::vector<double>& weights,
                    const std::vector<vtkIdType>& corners,
                    const std::vector<vtkIdType>& points)
{
  constexpr double factor = 1e6;
  const std::unordered_set<vtkIdType> repelled(points.begin(), points.end());
  for(std::size_t i = 0; i < corners.size(); i += 3)
    if(std::any_of(&corners[i], &corners[i] + 3,
                   [&](const vtkIdType v) { return repelled.count(v) > 0; }))
      weights[i / 3] *= factor;
}

// Returns the weights of faces; none if they all are 1.
std::vector<double> face_weights(vtkPolyData& input,
                                 const Triangles& triangles,
                                 const Geodesic_surface::Settings& settings)
{
  std::vector<double> result;
  if(settings.weights_array.empty() && !settings.has_scalar_weights &&
     settings.repelled_points.empty())
    return result;
  result.assign(triangles.cells().size(), 1);
  if(!settings.weights_array.empty())
    multiply_by_array(result, input, triangles.cells(), settings.weights_array);
  if(settings.has_scalar_weights)
    multiply_by_scalars(result, input, triangles.corners());
  make_expensive(result, triangles.corners(), settings.repelled_points);
  return result;
}

// Flips faces only if that is necessary, which most surfaces do not need.
std::unique_ptr<const AG::Solver> make_solver(Triangles& triangles,
                                              const std::vector<double>& coordinates,
                                              const AG::Solver_options& options,
                                              const AG::Solver_watch& watch)
{
  const auto build = [&] {
    return std::make_unique<const AG::Solver>(coordinates.data(), coordinates.size() / 3,
                                              triangles.corners().data(), triangles.cells().size(),
                                              options, watch);
  };
  try
  {
    return build();
  }
  catch(const std::invalid_argument&)
  {
    triangles.orient();
  }
  try
  {
    return build();
  }
  catch(const std::invalid_argument& e)
  {
    if(triangles.are_all_cells())
      throw;
    throw std::invalid_argument(
        e.what() + std::string(" (of the faces that vtkTriangleFilter would make of the cells)"));
  }
}

} // namespace

class Geodesic_surface::Graph
{
public:
  Graph(vtkPolyData& input, const Settings& settings, const AG::Solver_watch& watch)
    : m_input(&input), m_time(input.GetMTime()), m_settings(settings)
  {
    Triangles triangles(input);
    const std::vector<double> weights = face_weights(input, triangles, settings);
    const std::vector<double> coordinates = coordinates_of(input);
    AG::Solver_options options;
    if(settings.epsilon >= 0 || std::isnan(settings.epsilon))
      options.epsilon = settings.epsilon;
    if(!weights.empty())
      options.face_weights = weights.data();
    m_solver = make_solver(triangles, coordinates, options, watch);
  }

  bool is_of(vtkPolyData& input, const Settings& settings) const
  {
    return m_input == &input && m_time == input.GetMTime() && m_settings == settings;
  }

  const AG::Solver& solver() const { return *m_solver; }

  // Builds a tree of the faces on demand.
  const AG::Solver_locator& locator() const
  {
    if(!m_locator)
      m_locator = std::make_unique<const AG::Solver_locator>(*m_solver);
    return *m_locator;
  }

private:
  const vtkPolyData* m_input; // only compared: the time is that of no other object
  vtkMTimeType m_time;
  Settings m_settings;
  std::unique_ptr<const AG::Solver> m_solver;
  mutable std::unique_ptr<const AG::Solver_locator> m_locator;
};

Geodesic_surface::Geodesic_surface() = default;
Geodesic_surface::~Geodesic_surface() = default;

void Geodesic_surface::update(vtkPolyData& input,
                              const Settings& settings,
                              const AG::Solver_watch& watch)
{
  if(m_graph && m_graph->is_of(input, settings))
    return;
  m_graph.reset();
  m_graph = std::make_unique<const Graph>(input, settings, watch);
}

vtkIdType Geodesic_surface::number_of_points() const
{
  return static_cast<vtkIdType>(m_graph->solver().number_of_vertices());
}

void Geodesic_surface::find_distances(const std::vector<AG::Solver_point>& sources,
                                      const double maximum_distance,
                                      double* const distances,
                                      std::int64_t* const nearest_sources,
                                      const AG::Solver_watch& watch) const
{
  AG::Solver_search_options options;
  options.maximum_distance = maximum_distance;
  m_graph->solver().find_distances(sources, distances, nearest_sources, nullptr, options, watch);
}

double Geodesic_surface::find_path(const vtkIdType start,
                                   const vtkIdType end,
                                   const bool straighten,
                                   std::vector<double>& coordinates,
                                   std::vector<std::int64_t>& points,
                                   const AG::Solver_watch& watch) const
{
  return m_graph->solver().find_path(AG::Solver_point::at_vertex(start),
                                     AG::Solver_point::at_vertex(end), straighten, coordinates,
                                     watch, &points);
}

std::vector<std::vector<double>> Geodesic_surface::find_isolines(const double* const values,
                                                                 const double level) const
{
  return m_graph->solver().find_isolines(values, level);
}

std::vector<AG::Solver_point> Geodesic_surface::locate(vtkPolyData& points,
                                                       const AG::Solver_watch& watch) const
{
  const std::vector<double> coordinates = coordinates_of(points);
  std::vector<AG::Solver_locator::Location> locations;
  m_graph->locator().locate(coordinates.data(), coordinates.size() / 3,
                            std::back_inserter(locations), watch);
  std::vector<AG::Solver_point> result;
  for(const auto& location : locations)
    result.push_back(AG::Solver_point::in_face(location.face, location.coordinates));
  return result;
}

} // namespace approximate_geodesics_vtk
