// Cheapest paths through hills: what a kilometer costs depends on the ground, nobody crosses cliffs
// and the lake, and the fence has to be passed at its gate. draw_terrain.py draws the result.

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_path.h>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <numeric>
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
using Edge = Mesh::Edge_index;
using Ground_map = Mesh::Property_map<Face, unsigned int>;
using Barrier_map = Mesh::Property_map<Edge, bool>;
using Polyline = std::vector<Point>;

// ----- the ground

enum Ground
{
  ROAD,
  LEVEL,
  SLOPE,
  STEEP,
  CLIFF,
  LAKE,
  NUMBER_OF_GROUNDS
};

struct Kind
{
  std::string name;
  double weight; // what a kilometer costs
  CGAL::IO::Color color;
};

constexpr double FORBIDDEN = std::numeric_limits<double>::infinity();

const std::array<Kind, NUMBER_OF_GROUNDS> KINDS = {{{"road", 0.3, {246, 232, 190}},
                                                    {"level", 1, {150, 198, 104}},
                                                    {"slope", 2, {102, 160, 76}},
                                                    {"steep", 5, {62, 112, 60}},
                                                    {"cliff", FORBIDDEN, {150, 144, 138}},
                                                    {"lake", FORBIDDEN, {82, 146, 214}}}};

// ----- the terrain: 5 km by 5 km, x to the east, y to the north

constexpr int N = 125; // squares in a row, of two faces each
constexpr double SIDE = 5. / N;
constexpr double WATER_LEVEL = 0.05;
constexpr double HALF_WIDTH_OF_ROAD = 0.05;
// The fence follows a column of edges, and has a gap.
constexpr int FENCE = 37, END_OF_FENCE = 42, GATE = 20, BEYOND_GATE = 23;

double hill(const double x, const double y, const double radius_x, const double radius_y)
{
  return std::exp(-(x * x / (radius_x * radius_x) + y * y / (radius_y * radius_y)));
}

double height(const double x, const double y)
{
  const double result =
      0.12 + 0.025 * std::sin(2.6 * x + 0.4) * std::cos(2.1 * y) +
      0.80 * hill(x - 3.00, y - 2.45, 0.62, 0.66) + 0.42 * hill(x - 2.75, y - 3.60, 0.55, 0.80) +
      0.60 * hill(x - 3.50, y - 4.50, 0.75, 0.50) + 0.50 * hill(x - 1.15, y - 4.40, 0.60, 0.50) +
      0.34 * hill(x - 2.70, y - 0.84, 0.58, 0.46) - 0.30 * hill(x - 1.50, y - 1.98, 0.50, 0.52);
  return (std::max)(result, WATER_LEVEL);
}

// how far north the road is
double road(const double x)
{
  return 2.35 + 1.30 * std::exp(-std::pow((x - 2.4) / 1.1, 2)) + 0.08 * std::sin(4 * x);
}

double distance_from_road(const double x, const double y)
{
  const double slope = (road(x + 0.01) - road(x - 0.01)) / 0.02;
  return std::abs(y - road(x)) / std::hypot(1, slope);
}

Vertex vertex(const int i, const int j)
{
  return Vertex(static_cast<Mesh::size_type>(j * (N + 1) + i));
}

// Of the two faces of a square, the one in the south-east comes first.
Mesh make_mesh()
{
  Mesh mesh;
  for(int j = 0; j <= N; ++j)
    for(int i = 0; i <= N; ++i)
      mesh.add_vertex(Point(SIDE * i, SIDE * j, height(SIDE * i, SIDE * j)));
  for(int j = 0; j < N; ++j)
    for(int i = 0; i < N; ++i)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

Ground ground_of_face(const Mesh& mesh, const Face f, const bool road_is_open)
{
  std::array<Point, 3> p;
  std::size_t i = 0;
  for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
    p[i++] = mesh.point(v);
  if((std::max)({p[0].z(), p[1].z(), p[2].z()}) <= WATER_LEVEL)
    return LAKE;
  const Point center = CGAL::centroid(p[0], p[1], p[2]);
  if(road_is_open && distance_from_road(center.x(), center.y()) < HALF_WIDTH_OF_ROAD)
    return ROAD;
  const Vector normal = CGAL::normal(p[0], p[1], p[2]);
  const double gradient = std::hypot(normal.x(), normal.y()) / normal.z();
  return gradient < 0.16 ? LEVEL : gradient < 0.32 ? SLOPE : gradient < 0.7 ? STEEP : CLIFF;
}

Ground_map classify_faces(Mesh& mesh, const std::string& name, const bool road_is_open)
{
  const Ground_map result = mesh.add_property_map<Face, unsigned int>(name).first;
  for(const Face f : mesh.faces())
    result[f] = ground_of_face(mesh, f, road_is_open);
  return result;
}

Barrier_map build_fence(Mesh& mesh)
{
  const Barrier_map result = mesh.add_property_map<Edge, bool>("e:fence", false).first;
  for(int j = 0; j < END_OF_FENCE; ++j)
    result[mesh.edge(mesh.halfedge(vertex(FENCE, j), vertex(FENCE, j + 1)))] =
        j < GATE || j >= BEYOND_GATE;
  return result;
}

// ----- what a path consists of

unsigned int ground_at(const Ground_map ground, const double x, const double y)
{
  const int i = int(x / SIDE), j = int(y / SIDE);
  const bool is_second = y / SIDE - j > x / SIDE - i;
  return ground[Face(static_cast<Mesh::size_type>(2 * (j * N + i) + is_second))];
}

// The ground of a segment within a face: along an edge, that of the cheaper side.
unsigned int ground_of_segment(const Ground_map ground, const Point& p, const Point& q)
{
  const double dx = 1e-6 * (q.x() - p.x()), dy = 1e-6 * (q.y() - p.y());
  const Point middle = CGAL::midpoint(p, q);
  const unsigned int left = ground_at(ground, middle.x() - dy, middle.y() + dx);
  const unsigned int right = ground_at(ground, middle.x() + dy, middle.y() - dx);
  return KINDS[left].weight < KINDS[right].weight ? left : right;
}

using Lengths = std::array<double, NUMBER_OF_GROUNDS>;

Lengths lengths_by_ground(const Ground_map ground, const Polyline& path)
{
  Lengths result = {};
  for(std::size_t i = 1; i < path.size(); ++i)
    result[ground_of_segment(ground, path[i - 1], path[i])] +=
        std::sqrt(CGAL::squared_distance(path[i - 1], path[i]));
  return result;
}

double cost_of(const Lengths& lengths)
{
  double result = 0;
  for(std::size_t i = 0; i < lengths.size(); ++i)
    if(lengths[i] > 0) // infinity is not to be multiplied by zero
      result += lengths[i] * KINDS[i].weight;
  return result;
}

// ----- output

void print_title()
{
  std::cout << "kilometers on:           ";
  for(const Kind& kind : KINDS)
    std::cout << std::setw(7) << kind.name;
  std::cout << std::setw(7) << "all" << std::setw(12) << "cost\n";
}

void print_row(const std::string& title, const Lengths& lengths, const double cost)
{
  std::cout << std::left << std::setw(25) << title << std::right << std::fixed
            << std::setprecision(2);
  for(const double length : lengths)
    std::cout << std::setw(7) << length;
  std::cout << std::setw(7) << std::accumulate(lengths.begin(), lengths.end(), 0.) << std::setw(11);
  if(cost < FORBIDDEN)
    std::cout << cost;
  else
    std::cout << "forbidden";
  std::cout << "\n";
}

// A line of text per polyline: the number of its points, and their coordinates.
void write_polylines(const std::string& name, const std::vector<Polyline>& polylines)
{
  std::ofstream out("weighted_terrain_" + name + ".polylines.txt");
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

// The pieces of the fence to the south and to the north of the gate.
void write_fence(const Mesh& mesh)
{
  std::vector<Polyline> pieces(2);
  for(int j = 0; j <= END_OF_FENCE; ++j)
    if(j <= GATE || j >= BEYOND_GATE)
      pieces[j > GATE].push_back(mesh.point(vertex(FENCE, j)));
  write_polylines("fence", pieces);
}

void write_terrain(Mesh& mesh, const Ground_map ground)
{
  const auto colors = mesh.add_property_map<Face, CGAL::IO::Color>("f:color").first;
  for(const Face f : mesh.faces())
    colors[f] = KINDS[ground[f]].color;
  if(!CGAL::IO::write_PLY("weighted_terrain.ply", mesh))
    throw std::runtime_error("cannot write weighted_terrain.ply");
}

// ----- three paths

// The weights of the faces, looked up when they are asked for.
auto weights(const Ground_map ground)
{
  return boost::make_function_property_map<Face>(
      [ground](const Face f) { return KINDS[ground[f]].weight; });
}

void report(const std::string& name,
            const std::string& title,
            const Ground_map ground,
            const Polyline& path)
{
  const Lengths lengths = lengths_by_ground(ground, path);
  print_row(title, lengths, cost_of(lengths));
  write_polylines(name, {path});
}

// `cost` is what the library says of the path.
void check(const Ground_map ground, const Polyline& path, const double cost)
{
  if(!(std::abs(cost - cost_of(lengths_by_ground(ground, path))) < 1e-6 * cost))
    throw std::runtime_error("the cost of a path is not that of its segments");
}

void find_paths()
{
  Mesh mesh = make_mesh();
  const Ground_map ground = classify_faces(mesh, "f:ground", true);
  const Ground_map ground_without_road = classify_faces(mesh, "f:ground_without_road", false);
  const Barrier_map fence = build_fence(mesh);
  const Vertex start = vertex(7, 54), target = vertex(118, 50);

  Polyline shortest, cheapest, without_road;
  CGAL::approximate_geodesic_path(mesh, std::back_inserter(shortest), start, target,
                                  CGAL::parameters::epsilon(0.1));
  const auto np = CGAL::parameters::epsilon(0.1)
                      .face_weight_map(weights(ground))
                      .edge_is_constrained_map(fence);
  double cost =
      CGAL::approximate_geodesic_path(mesh, std::back_inserter(cheapest), start, target, np);
  check(ground, cheapest, cost);

  // A graph that is kept can get other weights. Its points stay where those that it was built with
  // asked for them, so that the bound may get worse; the path that is found here does not.
  AG::Surface_mesh_shortest_path<Mesh, AG::Steiner_graph<>> paths(mesh, np);
  const double bound = paths.graph().epsilon();
  paths.set_face_weights(weights(ground_without_road));
  paths.add_source_point(target);
  cost = paths.shortest_path_points_to_source_points(start, std::back_inserter(without_road)).first;
  check(ground_without_road, without_road, cost);

  print_title();
  report("shortest", "shortest, costs ignored", ground, shortest);
  report("cheapest", "cheapest", ground, cheapest);
  report("road_closed", "cheapest, road closed", ground_without_road, without_road);
  std::cout << "Costs are at most " << std::setprecision(0) << 100 * bound
            << " % too high with the road open, for which the graph was built,\nand at most "
            << 100 * paths.graph().epsilon() << " % with the road closed.\n";
  write_fence(mesh);
  write_terrain(mesh, ground);
}

int main()
{
  try
  {
    find_paths();
    return EXIT_SUCCESS;
  }
  catch(const std::runtime_error& e)
  {
    std::cerr << "Error: " << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
