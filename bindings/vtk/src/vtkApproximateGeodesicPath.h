// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * @class vtkApproximateGeodesicPath
 * @brief Shortest path between two points of a surface: along edges, across faces within an error
 * bound, or exact.
 *
 * The input is a surface of triangles; polygons and strips are triangulated. The output is a
 * polyline from EndVertex to StartVertex, as that of vtkDijkstraGraphGeodesicPath, whose setters
 * this class has: a program changes the name of the class to use it. If there is no path, the
 * output has no points.
 *
 * The first update builds a graph, which is kept until the input or a parameter changes. A path
 * between other vertices then takes a fraction of the time. Surfaces must be
 * manifold, and orientable; triangles of other orientations than their neighbors are flipped
 * inside, which builds the graph twice. Errors name the cell or the point.
 */

#ifndef vtkApproximateGeodesicPath_h
#define vtkApproximateGeodesicPath_h

#include "vtkApproximateGeodesicsModule.h" // For export macro
#include "vtkGraphGeodesicPath.h"
#include "vtkSmartPointer.h" // For members

#include <memory> // For members
#include <string> // For members

class vtkDoubleArray;
class vtkIdList;
class vtkPoints;

class VTKAPPROXIMATEGEODESICS_EXPORT vtkApproximateGeodesicPath : public vtkGraphGeodesicPath
{
public:
  static vtkApproximateGeodesicPath* New();
  vtkTypeMacro(vtkApproximateGeodesicPath, vtkGraphGeodesicPath)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The error bound: the path is at most 1 + Epsilon times as long as the shortest one. 0 asks for
   * an exact path, which is not possible with weights. If it is negative, which is the default, the
   * path runs along edges, without a bound.
   */
  vtkSetMacro(Epsilon, double);
  vtkGetMacro(Epsilon, double);
  ///@}

  ///@{
  /**
   * Whether the path is shortened to a locally shortest one, which is not possible with weights.
   * Off by default.
   */
  vtkSetMacro(Straighten, vtkTypeBool);
  vtkGetMacro(Straighten, vtkTypeBool);
  vtkBooleanMacro(Straighten, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The name of an array of the cells: the cost of a unit of length in each of them, not negative;
   * infinity forbids a cell. None by default.
   */
  vtkSetStdStringFromCharMacro(WeightsArrayName);
  vtkGetCharFromStdStringMacro(WeightsArrayName);
  ///@}

  /**
   * The points of the input on the path, from EndVertex to StartVertex: one for each point of the
   * output, or -1 where the path crosses an edge.
   */
  vtkIdList* GetIdList() { return this->IdList; }

  /**
   * The length of the path, or its cost if there are weights; infinity if there is no path.
   */
  vtkGetMacro(Length, double);

  ///@{
  /**
   * Whether GetCumulativeWeights() may leave out points that are farther away than EndVertex. The
   * search for the path always stops there. Off by default.
   */
  vtkSetMacro(StopWhenEndReached, vtkTypeBool);
  vtkGetMacro(StopWhenEndReached, vtkTypeBool);
  vtkBooleanMacro(StopWhenEndReached, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether a unit of length in a triangle costs the mean of 1 / s^2 for the scalars s of its three
   * points, where 1 stands for 1 / 0. (vtkDijkstraGraphGeodesicPath uses one end of each edge.) Off
   * by default.
   */
  vtkSetMacro(UseScalarWeights, vtkTypeBool);
  vtkGetMacro(UseScalarWeights, vtkTypeBool);
  vtkBooleanMacro(UseScalarWeights, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the triangles around RepelVertices cost a million times as much. Off by default.
   */
  vtkSetMacro(RepelPathFromVertices, vtkTypeBool);
  vtkGetMacro(RepelPathFromVertices, vtkTypeBool);
  vtkBooleanMacro(RepelPathFromVertices, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Positions: the nearest points of the input repel the path, except for StartVertex and
   * EndVertex.
   */
  virtual void SetRepelVertices(vtkPoints* points);
  vtkPoints* GetRepelVertices() { return this->RepelVertices; }
  ///@}

  /**
   * Computes the distances of the points of the input from StartVertex, as of the last update:
   * infinity for those that are not reached. Empty if that has failed.
   */
  virtual void GetCumulativeWeights(vtkDoubleArray* weights);

  vtkMTimeType GetMTime() override;

protected:
  vtkApproximateGeodesicPath();
  ~vtkApproximateGeodesicPath() override;

  int RequestData(vtkInformation* request,
                  vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

  double Epsilon = -1;
  vtkTypeBool Straighten = 0;
  std::string WeightsArrayName;
  vtkTypeBool StopWhenEndReached = 0;
  vtkTypeBool UseScalarWeights = 0;
  vtkTypeBool RepelPathFromVertices = 0;
  vtkSmartPointer<vtkPoints> RepelVertices;
  vtkSmartPointer<vtkIdList> IdList;
  double Length;

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  vtkApproximateGeodesicPath(const vtkApproximateGeodesicPath&) = delete;
  void operator=(const vtkApproximateGeodesicPath&) = delete;
};

#endif
