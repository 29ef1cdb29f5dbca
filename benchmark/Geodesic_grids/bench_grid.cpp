// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Grids of cells: errors by direction where all have the same friction, beside steps in 8 and 16
// directions as other programs for rasters have them; time and memory of a search where friction
// varies, and errors against a graph with many more points; on heights, times of hikers against a
// grid that is four times finer, and what errors are due to. See --help.

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Rough_terrain.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/centroid.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <ios>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using AG::Grid_graph;
using AG::Grid_shape;
using CGAL::parameters::epsilon;

// Steps to 8 or 16 neighbors, which cost their lengths times the mean friction of both ends.
class Step_graph
{
public:
  using Node = std::uint32_t;

  Step_graph(const Grid_shape& shape, const std::vector<double>& friction, const int directions)
    : m_shape(shape), m_friction(friction)
  {
    for(int x = -2; x <= 2; ++x)
      for(int y = -2; y <= 2; ++y)
        if(x * x + y * y == 1 || x * x + y * y == 2 || (directions == 16 && x * x + y * y == 5))
          m_steps.push_back({x, y, std::sqrt(double(x * x + y * y))});
    const auto [least, most] = std::minmax_element(friction.begin(), friction.end());
    m_lengths = {*least, (*least + *most) / 2 * 1.5, *most * m_steps.front().length};
  }

  std::size_t number_of_nodes() const { return m_shape.number_of_cells(); }
  double unit() const { return 1; }
  AG::Arc_lengths arc_lengths() const { return m_lengths; }
  std::size_t maximum_degree() const { return m_steps.size(); }
  std::size_t memory() const { return m_friction.size() * sizeof(double); }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    for_each_step(node, labels, [&](const Node target, const double length) {
      f(target, length * (m_friction[node] + m_friction[target]) / 2);
    });
  }

protected:
  // Calls `f(target, length)`.
  template <typename Labels, typename F>
  void for_each_step(const Node node, const Labels&, F f) const
  {
    const AG::Grid_cell cell = m_shape.cell(node);
    for(const Step& step : m_steps)
    {
      // numbers below 0 wrap around
      const AG::Grid_cell next{cell.column + std::size_t(step.x), cell.row + std::size_t(step.y)};
      if(next.column >= m_shape.columns || next.row >= m_shape.rows)
        continue;
      const std::size_t target = m_shape.index(next);
      f(Node(target), step.length);
    }
  }

private:
  struct Step
  {
    int x, y;
    double length;
  };

  Grid_shape m_shape;
  const std::vector<double>& m_friction;
  std::vector<Step> m_steps;
  AG::Arc_lengths m_lengths;
};

static AG::Grid_cell middle_of(const Grid_shape& shape)
{
  return {shape.columns / 2, shape.rows / 2};
}

// ----- equal friction

static constexpr int NUMBER_OF_ANGLES = 9; // parts of 5 degrees up to 45; the rest is symmetric

template <typename Graph>
AG::Propagation<Graph> search_from_middle(const Graph& graph, const Grid_shape& shape)
{
  AG::Propagation<Graph> search(graph);
  search.run_from(static_cast<std::uint32_t>(shape.index(middle_of(shape))));
  return search;
}

// Returns the largest error in percent in each part of the angles, and the mean error.
template <typename Graph>
std::vector<double> errors_by_direction(const Graph& graph, const Grid_shape& shape)
{
  const AG::Grid_cell source = middle_of(shape);
  const AG::Propagation<Graph> search = search_from_middle(graph, shape);
  std::vector<double> result(NUMBER_OF_ANGLES);
  Errors errors;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
  {
    const AG::Grid_point p = shape.center(shape.cell(i)), q = shape.center(source);
    const double x = std::abs(p.x - q.x), y = std::abs(p.y - q.y), distance = std::hypot(x, y);
    if(distance == 0)
      continue;
    const double angle = std::atan2((std::min)(x, y), (std::max)(x, y)) * 180 / std::acos(-1.);
    const auto part = (std::min)(static_cast<int>(angle / 5), NUMBER_OF_ANGLES - 1);
    double& largest = result[static_cast<std::size_t>(part)];
    const double found = search.distance(static_cast<std::uint32_t>(i));
    largest = (std::max)(largest, 100 * (found / distance - 1));
    errors.add(found, distance);
  }
  result.push_back(*std::max_element(result.begin(), result.end()));
  result.push_back(100 * errors.mean());
  return result;
}

// Calls `f(name, graph)` for all graphs of cells of equal friction.
template <typename F>
void for_each_uniform_graph(const Grid_shape& shape, const F& f)
{
  const std::vector<double> friction(shape.number_of_cells(), 1);
  f("8 directions", Step_graph(shape, friction, 8));
  f("16 directions", Step_graph(shape, friction, 16));
  f("lines", Grid_graph(shape, friction));
  f("epsilon 0.1", Grid_graph(shape, friction, epsilon(0.1)));
}

static Table compare_directions(const std::size_t side)
{
  const Grid_shape shape{side, side, 1, 1, {}};
  Table table({"graph", "0-5", "5-10", "10-15", "15-20", "20-25", "25-30", "30-35", "35-40",
               "40-45", "largest %", "mean %"});
  for_each_uniform_graph(shape, [&](const std::string& name, const auto& graph) {
    auto row = table.add_row();
    row.add(name);
    for(const double error : errors_by_direction(graph, shape))
      row.add(error, 3);
  });
  return table;
}

// For the figure: the cells of a circle, as far as they differ by more than symmetry.
static Table errors_on_circle(const std::size_t side)
{
  const Grid_shape shape{side, side, 1, 1, {}};
  const AG::Grid_cell source = middle_of(shape);
  const double radius = double(side / 2 - 1), degree = std::acos(-1.) / 180;
  std::vector<std::array<double, 2>> vectors;
  for(double angle = 0; angle <= 45; angle += 0.5)
    vectors.push_back({std::round(radius * std::cos(angle * degree)),
                       std::round(radius * std::sin(angle * degree))});
  Table table({"graph", "degrees", "error %"});
  for_each_uniform_graph(shape, [&](const std::string& name, const auto& graph) {
    const auto search = search_from_middle(graph, shape);
    for(const auto& [x, y] : vectors)
    {
      const AG::Grid_cell cell{source.column + std::size_t(x), source.row + std::size_t(y)};
      const double found = search.distance(static_cast<std::uint32_t>(shape.index(cell)));
      table.add_row()
          .add(name)
          .add(std::atan2(y, x) / degree, 3)
          .add(100 * (found / std::hypot(x, y) - 1), 4);
    }
  });
  return table;
}

// ----- friction that varies

// Smooth bands, and noise from cell to cell: the largest friction is some 30 times the smallest.
static std::vector<double> varied_friction(const Grid_shape& shape)
{
  std::mt19937 random(1);
  std::vector<double> result;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
  {
    const double x = double(shape.cell(i).column) / double(shape.columns),
                 y = double(shape.cell(i).row) / double(shape.rows);
    result.push_back(std::exp(1.5 * std::sin(20 * x + 3 * std::sin(14 * y)) +
                              0.5 * double(random()) / 4294967296.));
  }
  return result;
}

static Table measure_searches(const std::size_t side, const std::size_t rounds)
{
  const Grid_shape shape{side, side, 1, 1, {}};
  const std::vector<double> friction = varied_friction(shape);
  const double n = double(shape.number_of_cells());
  Table table({"graph", "nodes/cell", "build ns/cell", "search us/cell", "bytes/cell"});
  const auto add = [&](const std::string& name, const auto make) {
    std::vector<double> build, seconds;
    for(std::size_t i = 0; i < rounds; ++i)
      build.push_back(seconds_of([&] { make(); }));
    const auto graph = make();
    AG::Propagation search(graph);
    const auto source = static_cast<std::uint32_t>(shape.index(middle_of(shape)));
    for(std::size_t i = 0; i < rounds; ++i)
      seconds.push_back(seconds_of([&] { search.run_from(source); }));
    table.add_row()
        .add(name)
        .add(double(graph.number_of_nodes()) / n, 1)
        .add(median(build) / n * 1e9, 1)
        .add(median(seconds) / n * 1e6, 2)
        .add(double(graph.memory() + search.memory()) / n, 0);
  };
  add("8 directions", [&] { return Step_graph(shape, friction, 8); });
  add("16 directions", [&] { return Step_graph(shape, friction, 16); });
  add("lines", [&] { return Grid_graph(shape, friction); });
  add("epsilon 0.5", [&] { return Grid_graph(shape, friction, epsilon(0.5)); });
  add("epsilon 0.1", [&] { return Grid_graph(shape, friction, epsilon(0.1)); });
  return table;
}

static std::vector<double> distances_of_cells(const Grid_graph& graph)
{
  AG::Propagation search(graph);
  search.run_from(graph.node(middle_of(graph.shape())));
  std::vector<double> result;
  for(std::uint32_t i = 0; i < graph.shape().number_of_cells(); ++i)
    result.push_back(search.distance(i));
  return result;
}

static Table compare_errors(const std::size_t side)
{
  const Grid_shape shape{side, side, 1, 1, {}};
  const std::vector<double> friction = varied_friction(shape);
  const std::vector<double> reference =
      distances_of_cells(Grid_graph(shape, friction, epsilon(0.01)));
  Table table({"graph", "mean %", "largest %"});
  const auto add = [&](const std::string& name, const Grid_graph& graph) {
    const std::vector<double> distances = distances_of_cells(graph);
    Errors errors;
    for(std::size_t i = 0; i < distances.size(); ++i)
      if(reference[i] > 0)
        errors.add(distances[i], reference[i]);
    table.add_row().add(name).add(100 * errors.mean(), 4).add(100 * errors.largest(), 3);
  };
  add("lines", Grid_graph(shape, friction));
  for(const double e : {1., 0.5, 0.1, 0.05})
    add("epsilon " + Table::text_of(e, 2), Grid_graph(shape, friction, epsilon(e)));
  return table;
}

// ----- heights

// Steps to 8 or 16 neighbors, which take the time of a hiker on the slope between both ends.
class Hiking_steps : public Step_graph
{
public:
  Hiking_steps(const Grid_shape& shape, const std::vector<double>& heights, const int directions)
    : Step_graph(shape, heights, directions), m_heights(heights), m_size(shape.cell_width)
  {
  }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    for_each_step(node, labels, [&](const Node target, const double length) {
      const double run = length * m_size;
      const double slope = (m_heights[target] - m_heights[node]) / run;
      f(target, run * std::sqrt(1 + slope * slope) * AG::Hiking_time()(slope));
    });
  }

  AG::Arc_lengths arc_lengths() const { return {0.5 * m_size, 2 * m_size, 50 * m_size}; }

private:
  const std::vector<double>& m_heights;
  double m_size;
};

static Grid_graph hiking_graph(const Grid_shape& shape, const std::vector<double>& heights)
{
  return Grid_graph(shape, 1,
                    CGAL::parameters::heights(std::cref(heights))
                        .face_weight_map(AG::directional_cost(AG::Hiking_time())));
}

template <typename Graph>
std::vector<double> times_of_hikers(const Graph& graph, const Grid_shape& shape, double& seconds)
{
  AG::Propagation<Graph> search(graph);
  const auto source = static_cast<std::uint32_t>(shape.index(middle_of(shape)));
  seconds = seconds_of([&] { search.run_from(source); });
  std::vector<double> result;
  for(std::uint32_t i = 0; i < shape.number_of_cells(); ++i)
    result.push_back(search.distance(i));
  result.push_back(double(graph.memory() + search.memory())); // the last number
  return result;
}

// Times on a grid that is so many times finer, whose heights are interpolated.
static std::vector<double> finer_times(const Grid_shape& shape,
                                       const std::vector<double>& heights,
                                       const std::size_t factor = 4)
{
  const Grid_shape finer{factor * (shape.columns - 1) + 1,
                         factor * (shape.rows - 1) + 1,
                         shape.cell_width / double(factor),
                         shape.cell_height / double(factor),
                         {}};
  const Grid_graph graph = hiking_graph(finer, Rough_terrain::interpolated(shape, heights, factor));
  AG::Propagation search(graph);
  const AG::Grid_cell source = middle_of(shape);
  search.run_from(graph.node({factor * source.column, factor * source.row}));
  std::vector<double> result;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
    result.push_back(
        search.distance(graph.node({factor * shape.cell(i).column, factor * shape.cell(i).row})));
  return result;
}

static double mean_slope(const Grid_shape& shape, const std::vector<double>& heights)
{
  double sum = 0;
  for(std::size_t i = 0; i + shape.columns + 1 < heights.size(); ++i)
    if(shape.cell(i).column + 1 < shape.columns)
      sum += std::hypot(heights[i + 1] - heights[i], heights[i + shape.columns] - heights[i]);
  return sum / shape.cell_width / double(heights.size());
}

struct Named_terrain
{
  std::string name;
  Rough_terrain terrain;
};

static std::vector<Named_terrain> terrains()
{
  return {{"hills", Rough_terrain(0.05, 8)},
          {"smooth hills", Rough_terrain(0.05, 16)},
          {"rough mountains", Rough_terrain(0.12, 8)}};
}

static Grid_shape shape_of_terrain(const std::size_t side) { return {side, side, 30, 30, {}}; }

static Table measure_hikers(const std::size_t side)
{
  const Grid_shape shape = shape_of_terrain(side);
  Table table({"terrain", "mean slope %", "graph", "us/cell", "bytes/cell", "mean %", "largest %"});
  for(const Named_terrain& named : terrains())
  {
    const std::vector<double> heights = named.terrain.heights(shape);
    const std::vector<double> reference = finer_times(shape, heights);
    const double slope = 100 * mean_slope(shape, heights);
    const auto add = [&](const std::string& graph_name, const auto& graph) {
      double seconds = 0;
      const std::vector<double> found = times_of_hikers(graph, shape, seconds);
      Errors errors;
      for(std::size_t i = 0; i < reference.size(); ++i)
        errors.add(found[i], reference[i]);
      const double n = double(shape.number_of_cells());
      table.add_row()
          .add(named.name)
          .add(slope, 0)
          .add(graph_name)
          .add(seconds / n * 1e6, 2)
          .add(found.back() / n, 0)
          .add(100 * errors.mean(), 2)
          .add(100 * errors.largest(), 1);
    };
    add("8 directions", Hiking_steps(shape, heights, 8));
    add("16 directions", Hiking_steps(shape, heights, 16));
    add("lines", hiking_graph(shape, heights));
  }
  return table;
}

// ----- what errors on heights are due to

// Cells between four heights become two triangles, or four around their mean.
static Mesh
mesh_of_heights(const Grid_shape& shape, const std::vector<double>& heights, const bool has_means)
{
  Mesh mesh;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
  {
    const AG::Grid_point p = shape.center(shape.cell(i));
    mesh.add_vertex({p.x, p.y, heights[i]});
  }
  for(std::size_t row = 0; row + 1 < shape.rows; ++row)
    for(std::size_t column = 0; column + 1 < shape.columns; ++column)
    {
      const auto at = [&](const std::size_t c, const std::size_t r) {
        return Vertex(static_cast<Mesh::size_type>(shape.index({column + c, row + r})));
      };
      const std::array<Vertex, 4> v{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
      if(has_means)
      {
        const Vertex middle = mesh.add_vertex(
            CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])));
        for(std::size_t i = 0; i < 4; ++i)
          mesh.add_face(v[i], v[(i + 1) % 4], middle);
      }
      else
      {
        mesh.add_face(v[0], v[1], v[2]);
        mesh.add_face(v[0], v[2], v[3]);
      }
    }
  return mesh;
}

static std::vector<double>
times_on_mesh(const Grid_shape& shape, const std::vector<double>& heights, const bool has_means)
{
  constexpr std::size_t points_per_edge = 15;
  const Mesh mesh = mesh_of_heights(shape, heights, has_means);
  const AG::Directional_graph<AG::Fixed_number_of_points> graph(
      AG::Intrinsic_triangulation(
          mesh, CGAL::parameters::face_weight_map(AG::directional_cost(AG::Hiking_time()))),
      AG::Fixed_number_of_points(points_per_edge));
  AG::Propagation search(graph);
  const auto node = [&](const std::size_t i) {
    return graph.triangulation().vertex(static_cast<std::uint32_t>(i));
  };
  search.run_from(node(shape.index(middle_of(shape))));
  std::vector<double> result;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
    result.push_back(search.distance(node(i)));
  return result;
}

// Lines of the grid and of finer ones, and another surface, next to the cheapest paths on a mesh.
static Table compare_surfaces(const std::size_t side)
{
  const Grid_shape shape = shape_of_terrain(side);
  Table table({"terrain", "times", "mean %", "largest %", "least %"});
  for(const Named_terrain& named : terrains())
  {
    const std::vector<double> heights = named.terrain.heights(shape);
    const std::vector<double> reference = times_on_mesh(shape, heights, true);
    const auto add = [&](const std::string& times, const std::vector<double>& found) {
      Errors errors;
      for(std::size_t i = 0; i < reference.size(); ++i)
        errors.add(found[i], reference[i]);
      table.add_row()
          .add(named.name)
          .add(times)
          .add(100 * errors.mean(), 2)
          .add(100 * errors.largest(), 1)
          .add(100 * errors.least(), 1);
    };
    for(const std::size_t factor : {1u, 2u, 4u})
      add("lines of a grid " + std::to_string(factor) + " times as fine",
          finer_times(shape, heights, factor));
    add("mesh of two triangles per cell", times_on_mesh(shape, heights, false));
  }
  return table;
}

// Writes the heights of the terrains, for programs of others to read: `double`s, row by row.
static void write_heights(const std::string& prefix, const std::size_t side)
{
  for(auto [name, terrain] : terrains())
  {
    std::replace(name.begin(), name.end(), ' ', '_');
    const std::vector<double> heights = terrain.heights(shape_of_terrain(side));
    std::ofstream out(prefix + name, std::ios::binary);
    out.write(reinterpret_cast<const char*>(heights.data()),
              static_cast<std::streamsize>(heights.size() * sizeof(double)));
    if(!out.flush())
      throw std::runtime_error("cannot write to " + prefix + name);
  }
}

int main(int argc, char* argv[])
{
  std::size_t side = 1000;
  std::string prefix;
  More_options more;
  more.add_options()("side,s", boost::program_options::value(&side),
                     "the number of rows and columns where friction varies, and of heights");
  more.add_options()("write-heights", boost::program_options::value(&prefix),
                     "only write heights, to files whose names start with this");
  const auto measure = [&](const Options& options, const Report& report) {
    if(!prefix.empty())
      return write_heights(prefix, side);
    const std::size_t part = options.is_quick ? 10 : 1;
    report.print("grid_directions",
                 "Errors in percent by direction in degrees, cells of equal friction",
                 compare_directions(400 / part));
    report.write("grid_circle", errors_on_circle(400 / part));
    report.print("grid_errors", "Friction that varies, errors against epsilon = 0.01",
                 compare_errors(150 / part));
    report.print("grid_heights",
                 "Heights, times of hikers, errors against a grid that is four times finer, " +
                     std::to_string(side / part) + " x " + std::to_string(side / part) + " cells",
                 measure_hikers(side / part));
    const std::size_t side_of_mesh = options.is_quick ? 10 : 64;
    report.print(
        "grid_surfaces",
        "Heights, times of hikers, errors against a mesh of four triangles per cell with 15 "
        "points per edge, " +
            std::to_string(side_of_mesh) + " x " + std::to_string(side_of_mesh) + " cells",
        compare_surfaces(side_of_mesh));
    report.print("grid_searches",
                 "Friction that varies, " + std::to_string(side / part) + " x " +
                     std::to_string(side / part) + " cells (times as medians of " +
                     std::to_string(options.number_of_rounds) + ")",
                 measure_searches(side / part, options.number_of_rounds));
  };
  return run_benchmark(argc, argv, "bench_grid", {{}, 3, ""}, measure, more);
}
