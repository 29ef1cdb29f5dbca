// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact cells of random points of a mesh, and the cut locus of one, beside the exact distances from
// the same points; whether borders are equidistant, and areas add up. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_constructions/voronoi_borders.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

using Location = AG::Face_location<Mesh>;
using Locations = std::vector<Location>;
using Cells = AG::Voronoi_cells<Mesh>;

static constexpr std::size_t NUMBER_OF_CHECKED_BORDERS = 10;

static Locations random_points(const Mesh& mesh, const std::size_t number)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  std::uniform_int_distribution<Mesh::size_type> face(0, mesh.number_of_faces() - 1);
  Locations result;
  while(result.size() < number)
  {
    const double t = part(random), s = part(random);
    if(t + s <= 1)
      result.push_back({Mesh::Face_index(face(random)), {1 - t - s, t, s}});
  }
  return result;
}

// Exact distances of points from the nearest of some sources.
static std::vector<double>
distances(const Mesh& mesh, const Locations& sources, const Locations& points)
{
  AG::Surface_mesh_shortest_path<Mesh, AG::Saddle_vertex_graph> paths(mesh);
  for(const Location& source : sources)
    paths.add_source_point(source);
  std::vector<double> result;
  for(const Location& p : points)
    result.push_back(paths.shortest_distance_to_source_points(p).first);
  return result;
}

// How much farther than the nearest source those of a border are, at most, for some borders, over
// the largest distance of their points.
static double largest_difference(const Mesh& mesh, const Locations& sources, const Cells& cells)
{
  const std::size_t step = cells.borders.size() / NUMBER_OF_CHECKED_BORDERS + 1;
  Locations points;
  for(std::size_t i = 0; i < cells.borders.size(); i += step)
    points.insert(points.end(), cells.borders[i].points.begin(), cells.borders[i].points.end());
  const std::vector<double> nearest = distances(mesh, sources, points);
  double difference = 0, largest = 0;
  std::size_t first = 0; // of the points of the border
  for(std::size_t i = 0; i < cells.borders.size(); i += step)
  {
    const auto& border = cells.borders[i];
    for(const std::size_t source : border.sources)
    {
      const std::vector<double> own = distances(mesh, {sources[source]}, border.points);
      for(std::size_t j = 0; j < own.size(); ++j)
      {
        difference = (std::max)(difference, std::abs(own[j] - nearest[first + j]));
        largest = (std::max)(largest, nearest[first + j]);
      }
    }
    first += border.points.size();
  }
  return difference / largest;
}

static void measure(Mesh& mesh,
                    const std::string& name,
                    const std::size_t number,
                    const bool is_locus,
                    const std::size_t number_of_rounds,
                    Table& table)
{
  const auto map = mesh.add_property_map<Vertex, double>("v:distance").first;
  const Locations sources = random_points(mesh, number);
  Cells cells;
  Contest contest;
  contest.add([&](auto) {
    CGAL::approximate_geodesic_distances(mesh, map, sources, CGAL::parameters::epsilon(0));
  });
  contest.add([&](auto) {
    cells = is_locus ? AG::cut_locus(mesh, sources) : AG::voronoi_borders(mesh, sources);
  });
  contest.run(number_of_rounds);
  const double area = CGAL::Polygon_mesh_processing::area(mesh);
  const double sum = std::accumulate(cells.areas.begin(), cells.areas.end(), 0.);
  table.add_row()
      .add(name)
      .add(is_locus ? "cut locus" : std::to_string(number) + " cells")
      .add(contest.median_seconds(0) * 1e3, 1)
      .add(contest.median_seconds(1) * 1e3, 1)
      .add(contest.ratio(1, 0), 1)
      .add(double(cells.borders.size()), 0)
      .add(is_locus ? "-" : Table::scientific(largest_difference(mesh, sources, cells)))
      .add(Table::scientific(std::abs(sum - area) / area));
}

int main(int argc, char* argv[])
{
  const auto run = [](const Options& options, const Report& report) {
    const std::size_t rounds = options.number_of_rounds;
    Table table({"mesh", "result", "distances ms", "result ms", "result : distances", "borders",
                 "distances differ", "sum of areas differs"});
    for(const std::string& name : options.meshes)
    {
      Mesh mesh = read_mesh(name);
      for(const std::size_t number : {10u, 100u, 1000u})
        measure(mesh, short_name(name), number, false, rounds, table);
      measure(mesh, short_name(name), 1, true, rounds, table);
    }
    report.print("cells",
                 "Cells of random points and the cut locus of one, beside exact distances from "
                 "them (medians of " +
                     std::to_string(rounds) +
                     "); by how much distances from the two sources of some borders differ from "
                     "the smallest one, over the largest one, and the sum of areas from that of "
                     "the mesh, relatively",
                 table);
  };
  return run_benchmark(argc, argv, "bench_cells", {usual_meshes(), 5, ""}, run);
}
