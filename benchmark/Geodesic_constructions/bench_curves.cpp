// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Searches from curves beside those from points, and curves at constant distance: their time, and
// how exact their spacing is. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/aabb_traits.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/offset_curves.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

using Curve = AG::Source_curve<Mesh>;
using Offset = AG::Offset_curve<Kernel::Point_3>;
using Distances = Mesh::Property_map<Vertex, double>;

// Closed curves of shortest paths between three random vertices.
std::vector<Curve> random_curves(const Mesh& mesh, const std::size_t number)
{
  const auto vertices = random_sources(mesh, 3 * number);
  std::vector<Curve> result;
  for(std::size_t i = 0; i < number; ++i)
    result.push_back({{vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]}, true});
  return result;
}

// The exact polyline, whose points are given: joining them is no part of the search.
Curve polyline(const Mesh& mesh, const Curve& curve)
{
  AG::Surface_mesh_shortest_path<Mesh, AG::Saddle_vertex_graph> paths(mesh);
  Curve result{{}, true};
  for(std::size_t i = 0; i < curve.points.size(); ++i)
  {
    paths.remove_all_source_points();
    paths.add_source_point(curve.points[(i + 1) % curve.points.size()]);
    std::vector<AG::Surface_point<Mesh>> points;
    paths.shortest_path_surface_points_to_source_points(curve.points[i],
                                                        std::back_inserter(points));
    result.points.insert(result.points.end(), points.begin(), points.end() - 1);
  }
  return result;
}

std::vector<Curve> random_polylines(const Mesh& mesh, const std::size_t number)
{
  std::vector<Curve> result;
  for(const Curve& curve : random_curves(mesh, number))
    result.push_back(polyline(mesh, curve));
  return result;
}

void measure_searches(Mesh& mesh,
                      const std::string& name,
                      const std::vector<Curve>& curves,
                      Table& table)
{
  const std::size_t rounds = curves.size();
  const auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;
  const auto sources = random_sources(mesh, rounds);
  Contest contest;
  const auto add = [&](const double epsilon, const auto& sources_of_rounds) {
    contest.add([&, epsilon](const auto round) {
      CGAL::approximate_geodesic_distances(mesh, distances, sources_of_rounds[round],
                                           parameters::epsilon(epsilon));
    });
  };
  for(const double epsilon : {0., 0.1})
  {
    add(epsilon, sources);
    add(epsilon, curves);
  }
  contest.run(rounds);
  std::size_t number_of_points = 0;
  for(const Curve& curve : curves)
    number_of_points += curve.points.size();
  table.add_row()
      .add(name)
      .add(double(mesh.number_of_vertices()), 0)
      .add(double(number_of_points) / double(rounds), 0)
      .add(contest.median_seconds(1) * 1e3, 1)
      .add(contest.ratio(1, 0), 2)
      .add(contest.median_seconds(3) * 1e3, 1)
      .add(contest.ratio(3, 2), 2);
}

// How far the distances of points of offsets, and of the middles between them, are from what they
// should be, in steps.
struct Spacing
{
  std::size_t number = 0, number_within_1_percent = 0, number_across_axis = 0;
  double largest = 0; // but for segments across the medial axis

  void add(const double error, const bool is_across_axis = false)
  {
    ++number;
    number_within_1_percent += std::abs(error) <= 0.01 ? 1 : 0;
    number_across_axis += is_across_axis ? 1 : 0;
    if(!is_across_axis)
      largest = (std::max)(largest, std::abs(error));
  }

  // Adds a point and the middle of a segment, by the errors of its ends and its middle. Along a
  // segment in a face, the distance is convex, but for where it crosses the medial axis: the paths
  // to the two sides come from different directions. So it does if the middle is farther than both
  // ends, by more than rounding.
  void add_segment(const double start, const double middle, const double end)
  {
    add(start);
    add(middle, middle > (std::max)(start, end) + 1e-6);
  }
};

// Asks the exact class for the distances of some points of each curve.
Spacing spacing_of(const Mesh& mesh,
                   const Curve& source,
                   const std::vector<Offset>& offsets,
                   const double step)
{
  using Exact = AG::Surface_mesh_shortest_path<Mesh, AG::Saddle_vertex_graph>;
  using Traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;
  constexpr std::size_t every = 41;
  Exact exact(mesh);
  exact.add_source_curve(source);
  CGAL::AABB_tree<Traits> tree;
  exact.build_aabb_tree(tree);
  Spacing result;
  for(const Offset& offset : offsets)
    for(std::size_t i = 0; i + 1 < offset.points.size(); i += every)
    {
      const auto error = [&](const Kernel::Point_3& p) {
        const auto place = exact.locate(p, tree);
        const auto nearest = exact.shortest_distance_to_source_points(place.first, place.second);
        return (nearest.first - offset.distance) / step;
      };
      const auto &p = offset.points[i], &q = offset.points[i + 1];
      result.add_segment(error(p), error(CGAL::midpoint(p, q)), error(q));
    }
  return result;
}

void measure_offsets(Mesh& mesh,
                     const std::string& name,
                     const std::vector<Curve>& curves,
                     Table& table)
{
  constexpr std::size_t number = 50;
  const Distances distances = mesh.add_property_map<Vertex, double>("v:distance").first;
  const auto search = [&](const Curve& curve) {
    CGAL::approximate_geodesic_distances(mesh, distances, curve, parameters::epsilon(0));
  };
  std::vector<std::vector<double>> levels;
  for(const Curve& curve : curves)
  {
    search(curve);
    const double largest = *std::max_element(distances.begin(), distances.end());
    auto& l = levels.emplace_back();
    for(std::size_t i = 1; i <= number; ++i)
      l.push_back(largest * double(i) / double(number + 1));
  }
  std::vector<Offset> offsets;
  std::vector<std::vector<Kernel::Point_3>> lines;
  Contest contest;
  contest.add([&](const auto round) { search(curves[round]); });
  contest.add([&](const auto round) {
    offsets.clear();
    AG::offset_curves(mesh, curves[round], levels[round], std::back_inserter(offsets));
  });
  contest.add([&](const auto round) {
    lines.clear();
    AG::isolines(mesh, distances, levels[round], std::back_inserter(lines));
  });
  contest.run(curves.size());
  const double seconds = contest.median_seconds(1) - contest.median_seconds(0);
  const Spacing spacing = spacing_of(mesh, curves.back(), offsets, levels.back().front());
  const auto percent = [&](const std::size_t part, const std::size_t of) {
    return 100. * double(part) / double((std::max)(of, std::size_t(1)));
  };
  table.add_row()
      .add(name)
      .add(contest.median_seconds(0) * 1e3, 1)
      .add(seconds * 1e3, 1)
      .add(seconds / contest.median_seconds(0), 2)
      .add(seconds / contest.median_seconds(2), 2)
      .add(contest.median_seconds(1) * 1e3, 1)
      .add(percent(spacing.number_within_1_percent, spacing.number), 2)
      .add(percent(spacing.number_across_axis, spacing.number), 1)
      .add(100 * spacing.largest, 2);
}

int main(int argc, char* argv[])
{
  const auto measure = [](const Options& options, const Report& report) {
    Table searches({"mesh", "vertices", "points", "exact ms", "exact, curve : point",
                    "epsilon 0.1 ms", "epsilon 0.1, curve : point"});
    Table offsets({"mesh", "exact search ms", "50 offsets beside it ms", "offsets : search",
                   "offsets : isolines", "both ms", "within 1 % of the step, %",
                   "across the medial axis, %", "largest error elsewhere, % of the step"});
    for(const std::string& name : options.meshes)
    {
      Mesh mesh = read_mesh(name);
      const std::vector<Curve> curves = random_polylines(mesh, options.number_of_rounds);
      measure_searches(mesh, short_name(name), curves, searches);
      measure_offsets(mesh, short_name(name), curves, offsets);
    }
    const std::string number = std::to_string(options.number_of_rounds);
    report.print("curves",
                 "Distances from closed curves of shortest paths between three random vertices "
                 "beside those from a random vertex (" +
                     number + " curves)",
                 searches);
    report.print(
        "offsets",
        "50 curves at constant distance from them beside isolines of the same distances; "
        "errors of points and middles of segments, for the last curve; a segment is across "
        "the medial axis if its middle is farther than its ends",
        offsets);
  };
  return run_benchmark(argc, argv, "bench_curves", {usual_meshes(), 5, ""}, measure);
}
