// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_VTK_GEODESIC_SURFACE_H
#define APPROXIMATE_GEODESICS_VTK_GEODESIC_SURFACE_H

// The triangles of a poly data, and their solver, which both filters search. Its source is the only
// one that includes `Solver.h`, which takes long to compile.

#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>

#include <vtkAlgorithm.h>
#include <vtkType.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace approximate_geodesics_vtk {

namespace AG = CGAL::Approximate_geodesics;

class Geodesic_surface
{
public:
  // What the graph depends on, besides the poly data.
  struct Settings
  {
    double epsilon;                         // negative: paths run along edges
    std::string weights_array;              // of cells; empty: none
    bool has_scalar_weights = false;        // whether faces also have weights by the point scalars
    std::vector<vtkIdType> repelled_points; // the faces around these are expensive

    bool operator==(const Settings& s) const
    {
      return epsilon == s.epsilon && weights_array == s.weights_array &&
             has_scalar_weights == s.has_scalar_weights && repelled_points == s.repelled_points;
    }
  };

  Geodesic_surface();
  ~Geodesic_surface();

  // Builds the graph, unless it is that of the same input and the same settings. If this throws,
  // there is no graph.
  void update(vtkPolyData& input, const Settings& settings, const AG::Solver_watch& watch);

  vtkIdType number_of_points() const;

  // Writes the distances of all points, infinity if they are not reached, and the positions of the
  // nearest sources, or -1, unless `nearest_sources` is null.
  void find_distances(const std::vector<AG::Solver_point>& sources,
                      double maximum_distance,
                      double* distances,
                      std::int64_t* nearest_sources,
                      const AG::Solver_watch& watch) const;

  // Appends the coordinates of a shortest path, and the points of the input at these or -1. Returns
  // the length; if there is no path, appends nothing and returns infinity.
  double find_path(vtkIdType start,
                   vtkIdType end,
                   bool straighten,
                   std::vector<double>& coordinates,
                   std::vector<std::int64_t>& points,
                   const AG::Solver_watch& watch) const;

  std::vector<std::vector<double>> find_isolines(const double* values, double level) const;

  // Returns the nearest points of the surface. The first call builds a tree of the faces.
  std::vector<AG::Solver_point> locate(vtkPolyData& points, const AG::Solver_watch& watch) const;

private:
  class Graph;
  std::unique_ptr<const Graph> m_graph;
};

// Calls `f(watch)`, where the watch reports progress, and ends the run if `filter` is aborted.
// Returns what RequestData() shall return: exceptions become errors of the filter.
template <typename F>
int run(vtkAlgorithm& filter, const F& f)
{
  AG::Solver_watch watch;
  watch.go_further = [&filter] { return filter.GetAbortExecute() == 0; };
  watch.on_progress = [&filter](const std::size_t number_done, const std::size_t number) {
    filter.UpdateProgress(static_cast<double>(number_done) / static_cast<double>(number));
  };
  try
  {
    f(watch);
  }
  catch(const AG::Solver_interrupted&) // the output stays empty
  {
  }
  catch(const std::exception& e)
  {
    vtkErrorWithObjectMacro(&filter, << e.what());
    return 0;
  }
  return 1;
}

} // namespace approximate_geodesics_vtk

#endif // APPROXIMATE_GEODESICS_VTK_GEODESIC_SURFACE_H
