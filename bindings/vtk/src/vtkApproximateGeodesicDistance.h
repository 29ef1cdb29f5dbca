// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * @class vtkApproximateGeodesicDistance
 * @brief Distances of the points of a surface from the nearest of some sources, along the surface:
 * across faces within an error bound, exact, or along edges.
 *
 * The input is a surface of triangles; polygons and strips are triangulated. The first output is
 * the input with an array of its points: distances, infinity for points that no source reaches. The
 * second output has isolines. Sources are, in this order: points of the input; the nearest points
 * of the surface to the points of a second input; and the points of a selection.
 *
 * The first update builds a graph, which is kept until the input, Epsilon or weights change.
 * Distances from other sources then take a fraction of the time. Surfaces must be
 * manifold, and orientable; triangles of other orientations than their neighbors are flipped
 * inside, which builds the graph twice. Errors name the cell or the point.
 */

#ifndef vtkApproximateGeodesicDistance_h
#define vtkApproximateGeodesicDistance_h

#include "vtkApproximateGeodesicsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For members
#include <string> // For members

class VTKAPPROXIMATEGEODESICS_EXPORT vtkApproximateGeodesicDistance : public vtkPolyDataAlgorithm
{
public:
  static vtkApproximateGeodesicDistance* New();
  vtkTypeMacro(vtkApproximateGeodesicDistance, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Points of the input that are sources.
   */
  void AddSource(vtkIdType point);
  void RemoveAllSources();
  vtkIdType GetNumberOfSources() const;
  vtkIdType GetSource(vtkIdType i) const;
  ///@}

  ///@{
  /**
   * Poly data whose points are sources, at the nearest points of the surface.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetSourceData(vtkDataObject* data) { this->SetInputData(1, data); }
  ///@}

  ///@{
  /**
   * A selection, of points, which are sources, or of cells, all of whose points are sources.
   */
  void SetSelectionConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetSelectionData(vtkDataObject* data) { this->SetInputData(2, data); }
  ///@}

  ///@{
  /**
   * The error bound: distances are lengths of paths at most 1 + Epsilon times as long as the
   * shortest ones. 0 asks for exact distances, which are not possible with weights. If it is
   * negative, paths run along edges, without a bound. 0.1 by default.
   */
  vtkSetMacro(Epsilon, double);
  vtkGetMacro(Epsilon, double);
  ///@}

  ///@{
  /**
   * The name of an array of the cells: the cost of a unit of length in each of them, not negative;
   * infinity forbids a cell. None by default.
   */
  vtkSetStdStringFromCharMacro(WeightsArrayName);
  vtkGetCharFromStdStringMacro(WeightsArrayName);
  ///@}

  ///@{
  /**
   * The name of the array with the distances, "GeodesicDistance" by default.
   */
  vtkSetStdStringFromCharMacro(DistanceArrayName);
  vtkGetCharFromStdStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Whether the first output also gets the array "NearestSource": the position of the nearest
   * source of each point among all sources, or -1. Off by default.
   */
  vtkSetMacro(GenerateLabels, vtkTypeBool);
  vtkGetMacro(GenerateLabels, vtkTypeBool);
  vtkBooleanMacro(GenerateLabels, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The number of isolines, at levels of equal steps between 0 and the largest distance; 0 by
   * default. For other levels, see vtkContourFilter.
   */
  vtkSetClampMacro(NumberOfIsolines, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfIsolines, int);
  ///@}

protected:
  vtkApproximateGeodesicDistance();
  ~vtkApproximateGeodesicDistance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request,
                  vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

  double Epsilon = 0.1;
  std::string WeightsArrayName;
  std::string DistanceArrayName = "GeodesicDistance";
  vtkTypeBool GenerateLabels = 0;
  int NumberOfIsolines = 0;

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  vtkApproximateGeodesicDistance(const vtkApproximateGeodesicDistance&) = delete;
  void operator=(const vtkApproximateGeodesicDistance&) = delete;
};

#endif
