// Computes the distances on a surface from its first point, isolines, and the exact path to the
// farthest point, and writes them for ParaView and other programs of VTK.
//
// Usage: distance_and_path [SURFACE.ply]

#include "vtkApproximateGeodesicDistance.h"
#include "vtkApproximateGeodesicPath.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <iostream>

namespace {

void write(vtkPolyData* const data, const char* const file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(file);
  writer->Write();
  std::cout << file << ": " << data->GetNumberOfPoints() << " points\n";
}

} // namespace

int main(int argc, char* argv[])
{
  vtkSmartPointer<vtkPolyDataAlgorithm> source;
  if(argc > 1)
  {
    const auto reader = vtkSmartPointer<vtkPLYReader>::New();
    reader->SetFileName(argv[1]);
    source = reader;
  }
  else
  {
    const auto sphere = vtkSmartPointer<vtkSphereSource>::New();
    sphere->SetThetaResolution(100);
    sphere->SetPhiResolution(100);
    source = sphere;
  }

  vtkNew<vtkApproximateGeodesicDistance> distance;
  distance->SetInputConnection(source->GetOutputPort());
  distance->AddSource(0);
  distance->SetEpsilon(0.1);
  distance->SetNumberOfIsolines(20);
  distance->Update();

  vtkDataArray* const distances = distance->GetOutput()->GetPointData()->GetScalars();
  vtkIdType farthest = 0;
  for(vtkIdType v = 0; distances != nullptr && v < distances->GetNumberOfTuples(); ++v)
    if(const double d = distances->GetComponent(v, 0);
       std::isfinite(d) && d > distances->GetComponent(farthest, 0))
      farthest = v;

  vtkNew<vtkApproximateGeodesicPath> path;
  path->SetInputConnection(source->GetOutputPort());
  path->SetStartVertex(0);
  path->SetEndVertex(farthest);
  path->SetEpsilon(0);
  path->Update();
  std::cout << "The path from point 0 to point " << farthest << " has length " << path->GetLength()
            << ".\n";

  write(distance->GetOutput(0), "distances.vtp");
  write(distance->GetOutput(1), "isolines.vtp");
  write(path->GetOutput(), "path.vtp");
}
