// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtkApproximateGeodesicPath.h"

#include "Geodesic_surface.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace AGV = approximate_geodesics_vtk;

class vtkApproximateGeodesicPath::vtkInternals
{
public:
  AGV::Geodesic_surface Surface;
  vtkIdType Start = -1; // of the last path; negative if there is none
};

namespace {

std::vector<vtkIdType> points_to_repel(vtkPolyData& input,
                                       vtkPoints& positions,
                                       const vtkIdType start,
                                       const vtkIdType end)
{
  std::vector<vtkIdType> result;
  if(input.GetNumberOfPoints() == 0)
    return result; // which FindPoint() would print an error about
  for(vtkIdType i = 0; i < positions.GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    positions.GetPoint(i, p.data());
    if(!std::isfinite(p[0] + p[1] + p[2]))
      throw std::invalid_argument("point " + std::to_string(i) + " of RepelVertices is not finite");
    const vtkIdType v = input.FindPoint(p.data());
    if(v >= 0 && v != start && v != end)
      result.push_back(v);
  }
  return result;
}

// Writes a path in the opposite direction, as vtkDijkstraGraphGeodesicPath does.
void write_backward(const std::vector<double>& coordinates,
                    const std::vector<std::int64_t>& points,
                    const int type,
                    vtkPolyData& output,
                    vtkIdList& ids)
{
  const auto size = static_cast<vtkIdType>(points.size());
  vtkNew<vtkPoints> positions;
  positions->SetDataType(type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  positions->SetNumberOfPoints(size);
  ids.SetNumberOfIds(size);
  vtkNew<vtkCellArray> lines;
  if(size > 0)
    lines->InsertNextCell(static_cast<int>(size));
  for(vtkIdType i = 0; i < size; ++i)
  {
    const auto from = static_cast<std::size_t>(size - 1 - i);
    positions->SetPoint(i, &coordinates[3 * from]);
    ids.SetId(i, points[from]);
    lines->InsertCellPoint(i);
  }
  output.SetPoints(positions);
  output.SetLines(lines);
}

} // namespace

vtkStandardNewMacro(vtkApproximateGeodesicPath);

vtkApproximateGeodesicPath::vtkApproximateGeodesicPath()
  : IdList(vtkSmartPointer<vtkIdList>::New()),
    Length(std::numeric_limits<double>::infinity()),
    Internals(std::make_unique<vtkInternals>())
{
}

vtkApproximateGeodesicPath::~vtkApproximateGeodesicPath() = default;

void vtkApproximateGeodesicPath::SetRepelVertices(vtkPoints* const points)
{
  if(this->RepelVertices == points)
    return;
  this->RepelVertices = points;
  this->Modified();
}

vtkMTimeType vtkApproximateGeodesicPath::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->RepelVertices ? (std::max)(time, this->RepelVertices->GetMTime()) : time;
}

int vtkApproximateGeodesicPath::RequestData(vtkInformation*,
                                            vtkInformationVector** const inputs,
                                            vtkInformationVector* const outputs)
{
  vtkPolyData* const input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* const output = vtkPolyData::GetData(outputs);
  if(input == nullptr || output == nullptr)
    return 0;
  this->Internals->Start = -1;
  this->IdList->Reset();
  this->Length = std::numeric_limits<double>::infinity();
  return AGV::run(*this, [&](const AGV::AG::Solver_watch& watch) {
    AGV::Geodesic_surface::Settings settings;
    settings.epsilon = this->Epsilon;
    settings.weights_array = this->WeightsArrayName;
    settings.has_scalar_weights = this->UseScalarWeights != 0;
    if(this->RepelPathFromVertices && this->RepelVertices)
      settings.repelled_points =
          points_to_repel(*input, *this->RepelVertices, this->StartVertex, this->EndVertex);
    std::vector<double> coordinates;
    std::vector<std::int64_t> points;
    this->Internals->Surface.update(*input, settings, watch);
    this->Length = this->Internals->Surface.find_path(
        this->StartVertex, this->EndVertex, this->Straighten != 0, coordinates, points, watch);
    this->Internals->Start = this->StartVertex;
    write_backward(coordinates, points, input->GetPoints()->GetDataType(), *output, *this->IdList);
  });
}

void vtkApproximateGeodesicPath::GetCumulativeWeights(vtkDoubleArray* const weights)
{
  if(weights == nullptr)
    return;
  weights->Initialize();
  const AGV::Geodesic_surface& surface = this->Internals->Surface;
  if(this->Internals->Start < 0)
    return;
  AGV::run(*this, [&](const AGV::AG::Solver_watch& watch) {
    // A graph overestimates distances by a factor of at most 1 + Epsilon, without a bound along
    // edges if the path was straightened; the rest is for rounding errors.
    const double factor = (1 + (std::max)(this->Epsilon, 0.)) * (1 + 1e-9);
    const bool stops = this->StopWhenEndReached && !(this->Straighten && this->Epsilon < 0);
    const double maximum_distance =
        stops ? factor * this->Length : std::numeric_limits<double>::infinity();
    std::vector<double> distances(static_cast<std::size_t>(surface.number_of_points()));
    surface.find_distances({AGV::AG::Solver_point::at_vertex(this->Internals->Start)},
                           maximum_distance, distances.data(), nullptr, watch);
    weights->SetNumberOfValues(surface.number_of_points());
    std::copy(distances.begin(), distances.end(), weights->GetPointer(0));
  });
}

void vtkApproximateGeodesicPath::PrintSelf(ostream& os, const vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Epsilon: " << this->Epsilon << "\n";
  os << indent << "Straighten: " << this->Straighten << "\n";
  os << indent << "WeightsArrayName: " << this->WeightsArrayName << "\n";
  os << indent << "StopWhenEndReached: " << this->StopWhenEndReached << "\n";
  os << indent << "UseScalarWeights: " << this->UseScalarWeights << "\n";
  os << indent << "RepelPathFromVertices: " << this->RepelPathFromVertices << "\n";
  os << indent << "RepelVertices: " << this->RepelVertices << "\n";
  os << indent << "IdList: " << this->IdList << "\n";
  os << indent << "Length: " << this->Length << "\n";
}
