// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How many points geometric progressions have for the same bound, ours and the published ones. They
// are only counted: the graphs of the latter would not fit into memory. See --help.

#include "meshes/Mesh.h"
#include "meshes/Weighted_terrain.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Reference/Published_geometric_points.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Index = AG::Intrinsic_triangulation::Index;

// How many points a placement has on the edges of a mesh.
struct Count
{
  template <typename Placement>
  Count(const AG::Intrinsic_triangulation& triangulation, Placement placement)
  {
    placement.prepare(triangulation);
    std::size_t sum = 0;
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(h < triangulation.opposite(h))
      {
        const std::size_t n = placement.number_of_points(triangulation, h);
        sum += n;
        largest = (std::max)(largest, n);
      }
    mean = double(sum) / double(triangulation.number_of_edges());
  }

  double mean = 0;
  std::size_t largest = 0;
};

static void add_placements(Table& table,
                           const std::string& name,
                           const AG::Intrinsic_triangulation& triangulation)
{
  for(const double epsilon : {0.5, 0.2, 0.1, 0.05})
  {
    const Count ours(triangulation, AG::Geometric_points(epsilon));
    const Count published(triangulation, AG::Published_geometric_points(epsilon));
    table.add_row()
        .add(name)
        .add(epsilon, 2)
        .add(ours.mean, 2)
        .add(double(ours.largest), 0)
        .add(published.mean, 2)
        .add(double(published.largest), 0)
        .add(published.mean / ours.mean, 1);
  }
}

static Table placements_table(const std::vector<std::string>& meshes,
                              const Weighted_terrain& terrain)
{
  Table result({"mesh", "epsilon", "points/edge", "at most", "published points/edge",
                "published at most", "published : ours"});
  for(const std::string& name : meshes)
    add_placements(result, short_name(name), AG::Intrinsic_triangulation(read_mesh(name)));
  add_placements(result, "terrain", terrain.triangulation());
  return result;
}

int main(int argc, char* argv[])
{
  const auto count_points = [](const Options& options, const Report& report) {
    report.print("steiner_placements", "Points per edge for the same bound",
                 placements_table(options.meshes, Weighted_terrain(options)));
  };
  return run_benchmark(argc, argv, "bench_placements", {{"bunny00"}, 1, ""}, count_points);
}
