// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How many points geometric progressions have for the same bound, ours and the published ones, and
// how many thin faces take, on all sample meshes. They are only counted: some graphs would not fit
// into memory. See --help.

#include "meshes/Mesh.h"
#include "meshes/Weighted_terrain.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Published_geometric_points.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Geometric_progressions.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <stdexcept>
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

// ----- thin faces

static constexpr double SHOWN = 0.1; // epsilon
static constexpr std::size_t MANY = 1000;

// What the bound takes on all sample meshes; a row for those that take many points, or are refused.
class Thin_faces
{
public:
  Thin_faces() : m_rows({"mesh", "faces", "smallest angle", "points/edge", "at most", "bound"}) {}

  void add(const std::string& name)
  {
    const Mesh mesh = read_mesh(name);
    if(!CGAL::is_triangle_mesh(mesh))
      return;
    const AG::Intrinsic_triangulation triangulation(mesh);
    ++m_number_of_meshes;
    try
    {
      const Count count(triangulation, AG::Geometric_points(SHOWN));
      if(count.largest > MANY)
        add_row(name, triangulation).add(count.mean, 2).add(double(count.largest), 0).add(SHOWN, 1);
    }
    catch(const std::length_error& refusal)
    {
      ++m_number_of_refusals;
      add_weaker_bound(name, triangulation);
      m_refusals += short_name(name) + ": " + refusal.what() + "\n";
    }
  }

  void print(const Report& report) const
  {
    report.print("thin_faces",
                 "Of " + std::to_string(m_number_of_meshes) + " sample meshes of triangles, " +
                     std::to_string(m_number_of_meshes - m_number_of_refusals) +
                     " have the bound epsilon = " + Table::text_of(SHOWN, 1) +
                     "; those with more than " + std::to_string(MANY) +
                     " points on an edge, and the bounds of others if weaker ones are accepted",
                 m_rows);
    std::cout << "Refused:\n\n" << m_refusals;
  }

private:
  Table::Row add_row(const std::string& name, const AG::Intrinsic_triangulation& triangulation)
  {
    double smallest = 1;
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(!triangulation.is_border(h))
        smallest =
            (std::min)(smallest, AG::internal::Face_shape(triangulation, h).sine_of_corner());
    return m_rows.add_row()
        .add(short_name(name))
        .add(double(triangulation.number_of_faces()), 0)
        .add(Table::scientific(std::asin(smallest)));
  }

  void add_weaker_bound(const std::string& name, const AG::Intrinsic_triangulation& triangulation)
  {
    AG::Geometric_points placement(CGAL::parameters::epsilon(SHOWN).accept_weaker_bound(true));
    const Count count(triangulation, placement);
    placement.prepare(triangulation);
    add_row(name, triangulation)
        .add(count.mean, 2)
        .add(double(count.largest), 0)
        .add(Table::text_of(placement.epsilon(triangulation), 1));
  }

  Table m_rows;
  std::string m_refusals;
  std::size_t m_number_of_meshes = 0, m_number_of_refusals = 0;
};

int main(int argc, char* argv[])
{
  const auto count_points = [](const Options& options, const Report& report) {
    report.print("steiner_placements", "Points per edge for the same bound",
                 placements_table(options.meshes, Weighted_terrain(options)));
    Thin_faces thin;
    for(const std::string& name : options.is_quick ? options.meshes : all_sample_meshes())
      thin.add(name);
    thin.print(report);
  };
  return run_benchmark(argc, argv, "bench_placements", {{"bunny00"}, 1, ""}, count_points);
}
