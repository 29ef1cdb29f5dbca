// Agents walk to the exit of a building with two walls and a pool, which takes more time to cross.
// A door opens and closes; each time, only those distances are found anew that this changes. Writes
// a picture to agents_and_doors.svg.

#include <CGAL/Approximate_geodesics/Graphs/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Steiner_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Edge = Mesh::Edge_index;
using Paths = AG::Surface_mesh_shortest_path<Mesh, AG::Steiner_graph<>>;
using Polylines = std::vector<std::vector<Point>>;

constexpr int WIDTH = 30, HEIGHT = 18; // meters, and squares of the floor
constexpr double LEFT_WALL = 10, RIGHT_WALL = 20;

Vertex vertex(const int x, const int y)
{
  return Vertex(static_cast<Mesh::size_type>(y * (WIDTH + 1) + x));
}

Mesh floor_of_building()
{
  Mesh result;
  for(int y = 0; y <= HEIGHT; ++y)
    for(int x = 0; x <= WIDTH; ++x)
      result.add_vertex(Point(x, y, 0));
  for(int y = 0; y < HEIGHT; ++y)
    for(int x = 0; x < WIDTH; ++x)
    {
      result.add_face(vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1));
      result.add_face(vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1));
    }
  return result;
}

// Both walls end before the upper side of the building; the left one has a door.
bool is_wall(const Mesh& mesh, const Edge e)
{
  const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
  return p.x() == q.x() && (p.x() == LEFT_WALL || (p.x() == RIGHT_WALL && p.y() + q.y() > 8)) &&
         p.y() + q.y() < 2 * (HEIGHT - 3);
}

bool is_door(const Mesh& mesh, const Edge e)
{
  const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
  return is_wall(mesh, e) && p.x() == LEFT_WALL && p.y() + q.y() > 6 && p.y() + q.y() < 10;
}

bool is_pool(const Mesh& mesh, const Face f)
{
  double x = 0, y = 0;
  for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
  {
    x += mesh.point(v).x() / 3;
    y += mesh.point(v).y() / 3;
  }
  return x > 12 && x < 18 && y > 1 && y < 8;
}

// The paths of all agents to the exit, and how long they take.
Polylines find_paths(Paths& paths, const std::vector<Vertex>& agents)
{
  Polylines result;
  for(const Vertex agent : agents)
  {
    result.emplace_back();
    const auto found =
        paths.shortest_path_points_to_source_points(agent, std::back_inserter(result.back()));
    std::cout << "  " << found.first;
  }
  std::cout << "\n";
  return result;
}

// ----- the picture: one half for each state of the door

std::string place(const double x, const double y)
{
  return std::to_string(std::lround(20 * x)) + ',' +
         std::to_string(std::lround(20 * (HEIGHT - y))) + ' ';
}

void draw_line(std::ostream& out, const std::string& points, const char* style)
{
  out << "<polyline fill='none' points='" << points << "' " << style << "/>\n";
}

void draw(std::ostream& out, const Mesh& mesh, const Polylines& lines, const bool is_open)
{
  out << "<rect width='600' height='360' fill='#f4f1e8' stroke='#444' stroke-width='3'/>\n"
      << "<rect x='240' y='200' width='120' height='140' fill='#a9d3ea'/>\n";
  for(const Edge e : mesh.edges())
    if(is_wall(mesh, e) && !(is_open && is_door(mesh, e)))
    {
      const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
      draw_line(out, place(p.x(), p.y()) + place(q.x(), q.y()),
                is_door(mesh, e) ? "stroke='#c0392b' stroke-width='6'"
                                 : "stroke='#444' stroke-width='6' stroke-linecap='round'");
    }
  for(const std::vector<Point>& line : lines)
  {
    std::string points;
    for(const Point& p : line)
      points += place(p.x(), p.y());
    draw_line(out, points, "stroke='#2471a3' stroke-width='3'");
    out << "<circle cx='" << 20 * line.front().x() << "' cy='" << 20 * (HEIGHT - line.front().y())
        << "' r='6' fill='#2471a3'/>\n";
  }
}

int main()
{
  const Mesh mesh = floor_of_building();
  Mesh with_maps = mesh;
  const auto weights = with_maps.add_property_map<Face, double>("f:weight", 1).first;
  const auto walls = with_maps.add_property_map<Edge, bool>("e:wall", false).first;
  std::vector<std::pair<Edge, bool>> open, closed;
  for(const Face f : mesh.faces())
    weights[f] = is_pool(mesh, f) ? 3 : 1;
  for(const Edge e : mesh.edges())
  {
    walls[e] = is_wall(mesh, e);
    if(is_door(mesh, e))
    {
      open.emplace_back(e, false);
      closed.emplace_back(e, true);
    }
  }

  // The bound also holds after changes.
  const AG::Geometric_points points(0.1, true);
  Paths paths(
      mesh,
      AG::Steiner_graph<>(
          AG::Intrinsic_triangulation(
              mesh, CGAL::parameters::face_weight_map(weights).edge_is_constrained_map(walls)),
          points));
  paths.collect_statistics(true);
  const Vertex exit = vertex(29, 2);
  paths.add_source_point(exit);
  const std::vector<Vertex> agents = {vertex(2, 3),  vertex(4, 8),   vertex(7, 13),
                                      vertex(13, 5), vertex(14, 11), vertex(23, 14)};

  std::ofstream out("agents_and_doors.svg");
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-10 -10 1250 380'>\n";
  std::cout << "the door is closed:";
  draw(out, mesh, find_paths(paths, agents), false);
  paths.set_barriers(open);
  std::cout << "it is open:        ";
  out << "<g transform='translate(630 0)'>\n";
  draw(out, mesh, find_paths(paths, agents), true);
  out << "</g>\n</svg>\n";

  Paths anew(mesh, paths.graph());
  anew.collect_statistics(true);
  anew.add_source_point(exit);
  std::cout << "a search anew finds";
  find_paths(anew, agents);
  std::cout << "the former looked at "
            << 100 * paths.search().statistics().relaxations /
                   anew.search().statistics().relaxations
            << " % of the arcs that the latter looked at\n";

  paths.set_barriers(closed);
  std::cout << "it is closed again:";
  find_paths(paths, agents);
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
