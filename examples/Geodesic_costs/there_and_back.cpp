// Costs that depend on the direction: a hiker goes up a mountain and comes down another way, and a
// boat crosses a river with a current. draw_there_and_back.py draws the result.
//
// Usage: there_and_back [SQUARES]
//   SQUARES  the number of squares along a side of the mountain, 120 unless it is given. The time
//            grows with the square of it.

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Distance_map = Mesh::Property_map<Vertex, double>;
using Polyline = std::vector<Point>;
using Graph = AG::Directional_graph<AG::Fixed_number_of_points>;
using Paths = AG::Surface_mesh_shortest_path<Mesh, Graph>;

constexpr double MINUTE = 60; // seconds

// ----- meshes, in meters

struct Grid
{
  int columns, rows; // of squares
  double side;

  Vertex vertex(const int i, const int j) const
  {
    return Vertex(static_cast<Mesh::size_type>(j * (columns + 1) + i));
  }

  template <typename Height>
  Mesh mesh(const Height& height) const
  {
    Mesh result;
    for(int j = 0; j <= rows; ++j)
      for(int i = 0; i <= columns; ++i)
        result.add_vertex(Point(side * i, side * j, height(side * i, side * j)));
    for(int j = 0; j < rows; ++j)
      for(int i = 0; i < columns; ++i)
      {
        result.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        result.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    return result;
  }
};

// A random number from -1 to 1 for every point with integer coordinates, the same everywhere.
double random_value(const int x, const int y)
{
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393u +
                    static_cast<std::uint32_t>(y) * 668265263u + 1274126177u;
  h = (h ^ (h >> 13)) * 1274126177u;
  h = (h ^ (h >> 16)) * 2246822519u;
  return static_cast<double>((h ^ (h >> 15)) & 0xffffffu) / 8388607.5 - 1;
}

// ... and a smooth function in between.
double noise(const double x, const double y)
{
  const double i = std::floor(x), j = std::floor(y);
  const auto smooth = [](const double t) { return t * t * t * (t * (6 * t - 15) + 10); };
  const double s = smooth(x - i), t = smooth(y - j);
  const auto value = [&](const int a, const int b) {
    return random_value(static_cast<int>(i) + a, static_cast<int>(j) + b);
  };
  return (1 - t) * ((1 - s) * value(0, 0) + s * value(1, 0)) +
         t * ((1 - s) * value(0, 1) + s * value(1, 1));
}

// A fractal whose zeros are valleys: they branch, as each octave adds smaller ones.
double ruggedness(double x, double y)
{
  double result = 0, amplitude = 1;
  for(int octave = 0; octave < 6; ++octave)
  {
    result += amplitude * std::abs(noise(x, y));
    amplitude *= 0.48;
    const double turned = 1.62 * x - 1.18 * y + 7.3; // lest valleys follow the grid
    y = 1.18 * x + 1.62 * y - 3.1;
    x = turned;
  }
  return result;
}

constexpr double EXTENT = 12000;

double height(const double x, const double y)
{
  const double u = x / EXTENT - 0.5, v = y / EXTENT - 0.52;
  const double massif = std::exp(-9 * (u * u + 1.2 * v * v));
  return 500 + 800 * massif + 700 * (0.3 + massif) * ruggedness(x / 3000, y / 3000);
}

// ----- output

// A line of text per polyline: the number of its points, and their coordinates.
void write_polylines(const std::string& name, const std::vector<Polyline>& polylines)
{
  std::ofstream out("there_and_back_" + name + ".polylines.txt");
  out.precision(17);
  for(const Polyline& polyline : polylines)
  {
    out << polyline.size();
    for(const Point& p : polyline)
      out << "  " << p;
    out << "\n";
  }
  if(!out.flush())
    throw std::runtime_error("cannot write the polylines " + name);
}

void write_mesh(const std::string& name, const Mesh& mesh)
{
  if(!CGAL::IO::write_PLY("there_and_back_" + name + ".ply", mesh))
    throw std::runtime_error("cannot write the mesh " + name);
}

// What is reached in so many minutes, and in twice as many, and so on.
void write_isochrones(const std::string& name,
                      const Mesh& mesh,
                      const Distance_map seconds,
                      const double minutes)
{
  double latest = 0;
  for(const Vertex v : mesh.vertices())
    latest = (std::max)(latest, seconds[v]);
  std::vector<double> times;
  for(double time = minutes * MINUTE; time < latest; time += minutes * MINUTE)
    times.push_back(time);
  std::vector<Polyline> lines;
  AG::isolines(mesh, seconds, times, std::back_inserter(lines));
  write_polylines(name, lines);
}

double length_of(const Polyline& path)
{
  double result = 0;
  for(std::size_t i = 1; i < path.size(); ++i)
    result += std::sqrt(CGAL::squared_distance(path[i - 1], path[i]));
  return result;
}

void report(const std::string& title,
            const Polyline& path,
            const double cost,
            const std::string& unit)
{
  std::cout << std::left << std::setw(34) << title << std::right << std::fixed
            << std::setprecision(0) << std::setw(6) << length_of(path) << " m"
            << std::setprecision(1) << std::setw(8) << cost << ' ' << unit << "\n";
}

// ----- a mountain

Vertex highest_vertex(const Mesh& mesh)
{
  return *std::max_element(
      mesh.vertices().begin(), mesh.vertices().end(),
      [&](const Vertex v, const Vertex w) { return mesh.point(v).z() < mesh.point(w).z(); });
}

// Paths that cost the least energy, up to the summit and down.
void find_paths(const Mesh& mesh, const Vertex village, const Vertex summit)
{
  const auto np = CGAL::parameters::face_weight_map(AG::directional_cost(AG::Walking_energy()))
                      .number_of_points_per_edge(4);
  Paths paths(mesh, np);
  Polyline up, down;
  const double there = paths.shortest_path_points(village, summit, std::back_inserter(up));
  const double back = paths.shortest_path_points(summit, village, std::back_inserter(down));
  report("from the village to the summit", up, there / 1000, "kJ/kg");
  report("and back", down, back / 1000, "kJ/kg");
  write_polylines("up", {up});
  write_polylines("down", {down});
}

// The times that ways take from the village and to it: one graph answers both questions.
void find_times(Mesh& mesh, const Vertex village, const Vertex summit)
{
  const auto np = CGAL::parameters::face_weight_map(AG::directional_cost(AG::Hiking_time()))
                      .number_of_points_per_edge(4);
  Paths from_village(mesh, np);
  Paths to_village(mesh, from_village.graph().reversed());
  const Distance_map there = mesh.add_property_map<Vertex, double>("v:there").first;
  const Distance_map back = mesh.add_property_map<Vertex, double>("v:back").first;
  from_village.add_source_point(village);
  from_village.shortest_distances_to_source_points(there);
  to_village.add_source_point(village);
  to_village.shortest_distances_to_source_points(back);
  std::cout << "The fastest ways take " << there[summit] / MINUTE << " minutes there and "
            << back[summit] / MINUTE << " minutes back.\n";
  write_isochrones("isochrones_there", mesh, there, 30);
  write_isochrones("isochrones_back", mesh, back, 30);
}

void climb_mountain(const int squares)
{
  const Grid grid{squares, squares, EXTENT / squares};
  Mesh mesh = grid.mesh(height);
  const Vertex village = grid.vertex(14 * squares / 120, 18 * squares / 120);
  const Vertex summit = highest_vertex(mesh);
  find_paths(mesh, village, summit);
  find_times(mesh, village, summit);
  write_mesh("mountain", mesh);
}

// ----- a river

constexpr double WIDTH_OF_RIVER = 200; // meters; it flows along the x axis

// It is fastest in the middle.
Vector current(const double y)
{
  const double part = 2 * y / WIDTH_OF_RIVER - 1;
  return Vector(1.3 * (1 - part * part), 0, 0);
}

void cross_river(const int squares)
{
  const int rows = squares / 3, half = rows / 2;
  const Grid grid{2 * rows, rows, WIDTH_OF_RIVER / rows};
  Mesh mesh = grid.mesh([](double, double) { return 0.; });
  const auto drift = boost::make_function_property_map<Face>([&mesh](const Face f) {
    double y = 0;
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      y += mesh.point(v).y() / 3;
    return current(y);
  });
  const double speed = 1.5; // meters per second
  const auto np =
      CGAL::parameters::face_weight_map(AG::directional_cost(AG::Drift_time(drift, speed)))
          .epsilon(0.1);
  AG::Surface_mesh_shortest_path<Mesh, AG::Directional_graph<>> paths(mesh, np);
  const Vertex pier = grid.vertex(rows, 0), opposite = grid.vertex(rows, rows),
               upstream = grid.vertex(half, rows), downstream = grid.vertex(rows + half, rows);
  const Distance_map seconds = mesh.add_property_map<Vertex, double>("v:seconds").first;
  paths.add_source_point(pier);
  paths.shortest_distances_to_source_points(seconds);

  std::vector<Polyline> ways;
  for(const Vertex v : {upstream, opposite, downstream})
  {
    ways.emplace_back();
    paths.shortest_path_points(pier, v, std::back_inserter(ways.back()));
  }
  report("across the river, upstream", ways[0], seconds[upstream] / MINUTE, "minutes");
  report("across the river", ways[1], seconds[opposite] / MINUTE, "minutes");
  report("across the river, downstream", ways[2], seconds[downstream] / MINUTE, "minutes");
  std::cout << "Times on the river are at most " << std::setprecision(0)
            << 100 * paths.graph().epsilon() << " % too long.\n";

  write_polylines("crossings", ways);
  write_isochrones("isochrones_on_river", mesh, seconds, 0.5);
  write_mesh("river", mesh);
}

int main(int argc, char* argv[])
{
  try
  {
    const int squares = argc > 1 ? std::atoi(argv[1]) : 120;
    if(squares < 12)
      throw std::runtime_error("the number of squares must be at least 12");
    climb_mountain(squares);
    cross_river(squares);
    return EXIT_SUCCESS;
  }
  catch(const std::runtime_error& e)
  {
    std::cerr << "Error: " << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
