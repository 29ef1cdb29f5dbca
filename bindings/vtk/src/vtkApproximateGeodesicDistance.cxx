// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtkApproximateGeodesicDistance.h"

#include "Geodesic_surface.h"

#include <vtkCellArray.h>
#include <vtkConvertSelection.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace AGV = approximate_geodesics_vtk;
using AGV::AG::Solver_point;
using Sources = std::vector<Solver_point>;

class vtkApproximateGeodesicDistance::vtkInternals
{
public:
  AGV::Geodesic_surface Surface;
  std::vector<vtkIdType> Sources;
};

namespace {

void add_point(const vtkIdType point, vtkPolyData&, Sources& sources)
{
  sources.push_back(Solver_point::at_vertex(point));
}

void add_points_of_cell(const vtkIdType cell, vtkPolyData& input, Sources& sources)
{
  if(cell < 0 || cell >= input.GetNumberOfCells())
    throw std::invalid_argument("the selection has cell " + std::to_string(cell) +
                                "; cells are numbered from 0, and there are " +
                                std::to_string(input.GetNumberOfCells()));
  vtkNew<vtkIdList> points;
  input.GetCellPoints(cell, points);
  for(vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    add_point(points->GetId(i), input, sources);
}

void add_selected(vtkSelection& selection, vtkPolyData& input, Sources& sources)
{
  const auto indices = vtkSmartPointer<vtkSelection>::Take(
      vtkConvertSelection::ToIndexSelection(&selection, &input));
  for(unsigned int n = 0; n < indices->GetNumberOfNodes(); ++n)
  {
    vtkSelectionNode& node = *indices->GetNode(n);
    auto* const ids = vtkIdTypeArray::SafeDownCast(node.GetSelectionList());
    const int type = node.GetFieldType();
    if(type != vtkSelectionNode::POINT && type != vtkSelectionNode::CELL)
      throw std::invalid_argument("the selection is of neither points nor cells");
    for(vtkIdType i = 0; ids != nullptr && i < ids->GetNumberOfValues(); ++i)
      (type == vtkSelectionNode::POINT ? add_point : add_points_of_cell)(ids->GetValue(i), input,
                                                                         sources);
  }
}

Sources find_sources(const std::vector<vtkIdType>& ids,
                     const AGV::Geodesic_surface& surface,
                     vtkPolyData& input,
                     vtkPolyData* const points,
                     vtkSelection* const selection,
                     const AGV::AG::Solver_watch& watch)
{
  Sources result;
  for(const vtkIdType v : ids)
    add_point(v, input, result);
  if(points != nullptr)
    for(const Solver_point& p : surface.locate(*points, watch))
      result.push_back(p);
  if(selection != nullptr)
    add_selected(*selection, input, result);
  if(result.empty())
    throw std::invalid_argument("there is no source: neither a point of the input, nor one of a "
                                "second input or a selection");
  return result;
}

void add_labels(const std::vector<std::int64_t>& labels, vtkPolyData& output)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName("NearestSource");
  array->SetNumberOfValues(static_cast<vtkIdType>(labels.size()));
  std::copy(labels.begin(), labels.end(), array->GetPointer(0));
  output.GetPointData()->AddArray(array);
}

// Writes isolines at equal steps between 0 and the largest distance.
void find_isolines(const AGV::Geodesic_surface& surface,
                   vtkDoubleArray& distances,
                   const int number,
                   vtkPolyData& output,
                   const AGV::AG::Solver_watch& watch)
{
  double range[2];
  distances.GetFiniteRange(range);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> levels;
  levels->SetName(distances.GetName());
  for(int i = 1; i <= number; ++i)
  {
    if(!watch.go_further())
      throw AGV::AG::Solver_interrupted();
    const double level = range[1] * i / (number + 1.);
    for(const std::vector<double>& line : surface.find_isolines(distances.GetPointer(0), level))
    {
      lines->InsertNextCell(static_cast<int>(line.size() / 3));
      for(std::size_t j = 0; j < line.size(); j += 3)
      {
        lines->InsertCellPoint(points->InsertNextPoint(&line[j]));
        levels->InsertNextValue(level);
      }
    }
  }
  output.SetPoints(points);
  output.SetLines(lines);
  output.GetPointData()->SetScalars(levels);
}

} // namespace

vtkStandardNewMacro(vtkApproximateGeodesicDistance);

vtkApproximateGeodesicDistance::vtkApproximateGeodesicDistance()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

vtkApproximateGeodesicDistance::~vtkApproximateGeodesicDistance() = default;

void vtkApproximateGeodesicDistance::AddSource(const vtkIdType point)
{
  this->Internals->Sources.push_back(point);
  this->Modified();
}

void vtkApproximateGeodesicDistance::RemoveAllSources()
{
  this->Internals->Sources.clear();
  this->Modified();
}

vtkIdType vtkApproximateGeodesicDistance::GetNumberOfSources() const
{
  return static_cast<vtkIdType>(this->Internals->Sources.size());
}

vtkIdType vtkApproximateGeodesicDistance::GetSource(const vtkIdType i) const
{
  return i >= 0 && i < this->GetNumberOfSources()
             ? this->Internals->Sources[static_cast<std::size_t>(i)]
             : -1;
}

int vtkApproximateGeodesicDistance::FillInputPortInformation(const int port,
                                                             vtkInformation* const info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 2 ? "vtkSelection" : "vtkPolyData");
  if(port > 0)
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkApproximateGeodesicDistance::RequestData(vtkInformation*,
                                                vtkInformationVector** const inputs,
                                                vtkInformationVector* const outputs)
{
  vtkPolyData* const input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* const output = vtkPolyData::GetData(outputs, 0);
  vtkPolyData* const isolines = vtkPolyData::GetData(outputs, 1);
  if(input == nullptr || output == nullptr || isolines == nullptr)
    return 0;
  return AGV::run(*this, [&](const AGV::AG::Solver_watch& watch) {
    AGV::Geodesic_surface& surface = this->Internals->Surface;
    AGV::Geodesic_surface::Settings settings;
    settings.epsilon = this->Epsilon;
    settings.weights_array = this->WeightsArrayName;
    surface.update(*input, settings, watch);
    const Sources sources =
        find_sources(this->Internals->Sources, surface, *input, vtkPolyData::GetData(inputs[1]),
                     vtkSelection::GetData(inputs[2]), watch);
    vtkNew<vtkDoubleArray> distances;
    distances->SetName(this->DistanceArrayName.c_str());
    distances->SetNumberOfValues(input->GetNumberOfPoints());
    std::vector<std::int64_t> labels(
        this->GenerateLabels ? static_cast<std::size_t>(input->GetNumberOfPoints()) : 0);
    surface.find_distances(sources, std::numeric_limits<double>::infinity(),
                           distances->GetPointer(0), this->GenerateLabels ? labels.data() : nullptr,
                           watch);
    find_isolines(surface, *distances, this->NumberOfIsolines, *isolines, watch);
    output->ShallowCopy(input);
    // SetScalars() would remove the scalars of the input
    output->GetPointData()->SetActiveAttribute(output->GetPointData()->AddArray(distances),
                                               vtkDataSetAttributes::SCALARS);
    if(this->GenerateLabels)
      add_labels(labels, *output);
  });
}

void vtkApproximateGeodesicDistance::PrintSelf(ostream& os, const vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSources: " << this->GetNumberOfSources() << "\n";
  os << indent << "Epsilon: " << this->Epsilon << "\n";
  os << indent << "WeightsArrayName: " << this->WeightsArrayName << "\n";
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "GenerateLabels: " << this->GenerateLabels << "\n";
  os << indent << "NumberOfIsolines: " << this->NumberOfIsolines << "\n";
}
