// Agents walk to the exit of a building with walls, furniture, and a pool, which takes more time to
// cross. Its floor is a navigation mesh: a triangulation with holes. A door opens and closes; each
// time, only those distances are found anew that this changes. Writes a picture to
// agents_and_doors.svg.

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
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

using Plan_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plan_point = Plan_kernel::Point_2;
using Polygon = std::vector<Plan_point>;
using Plan = CGAL::Constrained_Delaunay_triangulation_2<
    Plan_kernel,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<Vertex, Plan_kernel>,
        CGAL::Constrained_triangulation_face_base_2<Plan_kernel>>>;

// ----- the plan of the building, in meters

constexpr int WIDTH = 30, HEIGHT = 18;

Polygon rectangle(const double left, const double bottom, const double right, const double top)
{
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Polygon octagon(const double x, const double y, const double a, const double b)
{
  constexpr double pi = 3.14159265358979323846;
  Polygon result;
  for(int i = 0; i < 8; ++i)
    result.emplace_back(x + a * std::cos(pi * (i + 0.5) / 4), y + b * std::sin(pi * (i + 0.5) / 4));
  return result;
}

const Polygon building = rectangle(0, 0, WIDTH, HEIGHT);
const Polygon pool = octagon(15, 4.5, 3.2, 3.6);
const std::vector<Polygon> obstacles = { // three walls, and furniture
    rectangle(9.8, 0, 10.2, 3), rectangle(9.8, 5, 10.2, 15), rectangle(19.8, 4, 20.2, 15),
    octagon(4, 5.5, 0.9, 0.7),  octagon(5.5, 11, 1.2, 0.8),  octagon(2.5, 15, 0.7, 0.7),
    octagon(13, 13, 0.8, 1.1),  octagon(16, 10, 1, 0.7),     octagon(24.5, 8, 1.3, 0.8),
    octagon(26.5, 13, 0.8, 1),  octagon(23.5, 4, 0.7, 0.7)};
const Plan_point ends_of_door[] = {{10.2, 3}, {10.2, 5}};
const Plan_point exit_of_building(29, 2);
const Polygon agents = {{2, 3}, {4, 8}, {7, 13}, {13.2, 5}, {14, 11}, {23, 14}};

// ----- its floor: a triangulation with holes, whose vertices are corners, agents and the exit

bool is_inside(const Polygon& polygon, const Plan_point& p)
{
  return CGAL::bounded_side_2(polygon.begin(), polygon.end(), p) == CGAL::ON_BOUNDED_SIDE;
}

class Floor
{
public:
  Floor()
  {
    for(const Polygon& polygon : {building, pool})
      m_plan.insert_constraint(polygon.begin(), polygon.end(), true);
    for(const Polygon& polygon : obstacles)
      m_plan.insert_constraint(polygon.begin(), polygon.end(), true);
    m_plan.insert_constraint(ends_of_door[0], ends_of_door[1]);
    m_plan.insert(exit_of_building);
    m_plan.insert(agents.begin(), agents.end());
    for(const auto v : m_plan.finite_vertex_handles())
      v->info() = m_mesh.add_vertex({v->point().x(), v->point().y(), 0});
    for(const auto f : m_plan.finite_face_handles())
      if(const Plan_point center = CGAL::centroid(m_plan.triangle(f));
         std::none_of(obstacles.begin(), obstacles.end(),
                      [&](const Polygon& obstacle) { return is_inside(obstacle, center); }))
      {
        const Face face =
            m_mesh.add_face(f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info());
        m_weights[face] = is_inside(pool, center) ? 3 : 1;
      }
    m_is_closed[door()] = true;
  }

  const Mesh& mesh() const { return m_mesh; }
  const auto& weights() const { return m_weights; }
  const auto& barriers() const { return m_is_closed; }

  Vertex vertex(const Plan_point& p)
  {
    return m_plan.insert(p)->info(); // there is one already
  }

  Edge door()
  {
    return m_mesh.edge(m_mesh.halfedge(vertex(ends_of_door[0]), vertex(ends_of_door[1])));
  }

private:
  Plan m_plan;
  Mesh m_mesh;
  Mesh::Property_map<Face, double> m_weights =
      m_mesh.add_property_map<Face, double>("f:weight", 1).first;
  Mesh::Property_map<Edge, bool> m_is_closed =
      m_mesh.add_property_map<Edge, bool>("e:is_closed", false).first;
};

// The paths of all agents to the exit, and how long they take.
Polylines find_paths(Paths& paths, const std::vector<Vertex>& starts)
{
  Polylines result;
  for(const Vertex start : starts)
  {
    result.emplace_back();
    const auto found =
        paths.shortest_path_points_to_source_points(start, std::back_inserter(result.back()));
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

template <typename Range>
std::string places(const Range& points)
{
  std::string result;
  for(const auto& p : points)
    result += place(p.x(), p.y());
  return result;
}

void draw_polygon(std::ostream& out, const Polygon& polygon, const char* style)
{
  out << "<polygon points='" << places(polygon) << "' " << style << "/>\n";
}

void draw_line(std::ostream& out, const std::string& points, const char* style)
{
  out << "<polyline fill='none' points='" << points << "' " << style << "/>\n";
}

void draw(std::ostream& out, const Mesh& mesh, const Polylines& lines, const bool is_open)
{
  draw_polygon(out, building, "fill='#f4f1e8' stroke='#444' stroke-width='3'");
  draw_polygon(out, pool, "fill='#a9d3ea'");
  for(const Edge e : mesh.edges())
    draw_line(
        out,
        places(std::vector<Point>{mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))}),
        "stroke='#c9c4b4' stroke-width='1'");
  for(const Polygon& obstacle : obstacles)
    draw_polygon(out, obstacle, "fill='#777'");
  if(!is_open)
    draw_line(out, places(ends_of_door), "stroke='#c0392b' stroke-width='6'");
  for(const std::vector<Point>& line : lines)
  {
    draw_line(out, places(line), "stroke='#2471a3' stroke-width='3'");
    out << "<circle cx='" << 20 * line.front().x() << "' cy='" << 20 * (HEIGHT - line.front().y())
        << "' r='6' fill='#2471a3'/>\n";
  }
}

int main()
{
  Floor floor;
  const Mesh& mesh = floor.mesh();
  const std::vector<std::pair<Edge, bool>> open = {{floor.door(), false}},
                                           closed = {{floor.door(), true}};
  const AG::Geometric_points points(0.1, true); // the bound also holds after changes
  Paths paths(mesh, AG::Steiner_graph<>(AG::Intrinsic_triangulation(
                                            mesh, CGAL::parameters::face_weight_map(floor.weights())
                                                      .edge_is_constrained_map(floor.barriers())),
                                        points));
  paths.collect_statistics(true);
  const Vertex exit = floor.vertex(exit_of_building);
  paths.add_source_point(exit);
  std::vector<Vertex> starts;
  for(const Plan_point& agent : agents)
    starts.push_back(floor.vertex(agent));

  std::ofstream out("agents_and_doors.svg");
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-10 -10 1250 380'>\n";
  std::cout << mesh.number_of_faces() << " faces\nthe door is closed:";
  draw(out, mesh, find_paths(paths, starts), false);
  paths.set_barriers(open);
  std::cout << "it is open:        ";
  out << "<g transform='translate(630 0)'>\n";
  draw(out, mesh, find_paths(paths, starts), true);
  out << "</g>\n</svg>\n";

  Paths anew(mesh, paths.graph());
  anew.collect_statistics(true);
  anew.add_source_point(exit);
  std::cout << "a search anew finds";
  find_paths(anew, starts);
  std::cout << "the former looked at "
            << 100 * paths.search().statistics().relaxations /
                   anew.search().statistics().relaxations
            << " % of the arcs that the latter looked at\n";

  paths.set_barriers(closed);
  std::cout << "it is closed again:";
  find_paths(paths, starts);
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
