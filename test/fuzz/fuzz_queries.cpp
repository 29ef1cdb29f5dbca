// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Fuzzed_data.h"
#include "meshes/test_meshes.h"
#include "oracles/straight_lines.h"
#include "require.h"

#include <CGAL/Approximate_geodesics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// Sources, targets, limits and values of any kind: each is refused by the exception that is
// documented, which leaves the object as it was, or is answered as promised.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Index = Mesh::size_type;
using Surface_point = AG::Surface_point<Mesh>;
using Face_location = AG::Face_location<Mesh>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1 + 1e-6; // of arcs in single precision, and of paths over many faces

std::vector<Mesh> meshes()
{
  Random random(1);
  std::vector<Mesh> result;
  const auto coincide = [](const Point& p) { return Point(std::floor(p.x() / 2), p.y(), 0); };
  const auto flatten = [](const Point& p) { return Point(p.x(), 1e-9 * p.y(), p.z()); };
  for(const Soup& soup :
      {fan(5), flat_grid(4, 3), terrain(5, 4, random), scattered_parts(random), sphere(5, 3),
       flat_grid(5, 4).transformed(coincide), terrain(4, 4, random).transformed(flatten),
       growing_strip(6, 1, 1e12), Soup()})
    result.push_back(to_mesh(soup));
  result.push_back(necklace(1));
  return result;
}

// Mostly an element of the mesh.
template <typename Element>
Element fuzzed_element(Fuzzed_data& data, const std::size_t number)
{
  const std::uint8_t kind = data.byte();
  if(kind == 0)
    return Element();
  const std::size_t beyond = kind < 8 ? data.below(1000) : 0;
  return Element(static_cast<Index>(beyond + (number > 0 ? data.below(number) : 0)));
}

Vertex fuzzed_vertex(Fuzzed_data& data, const Mesh& mesh)
{
  return fuzzed_element<Vertex>(data, mesh.num_vertices());
}

std::array<double, 3> fuzzed_coordinates(Fuzzed_data& data)
{
  const double first = data.part(), second = data.part() * (1 - first);
  std::array<double, 3> result = {first, second, 1 - first - second};
  if(data.byte() < 24)
    result[data.below(3)] = data.number();
  return result;
}

Surface_point fuzzed_place(Fuzzed_data& data, const Mesh& mesh)
{
  switch(data.below(3))
  {
  case 0:
    return fuzzed_vertex(data, mesh);
  case 1:
  {
    const auto h = fuzzed_element<Halfedge>(data, mesh.num_halfedges());
    return std::make_pair(h, data.byte() < 24 ? data.number() : data.part());
  }
  default:
  {
    const auto f = fuzzed_element<Face>(data, mesh.num_faces());
    return Face_location(f, fuzzed_coordinates(data));
  }
  }
}

// An object that is used in all ways, and the sources that it should have by now.
template <typename Graph, typename NamedParameters>
class User
{
  using Shortest_paths = AG::Surface_mesh_shortest_path<Mesh, Graph>;

public:
  User(const Mesh& mesh, Fuzzed_data& data, const NamedParameters& np)
    : m_mesh(mesh), m_data(data), m_np(np), m_paths(mesh, np)
  {
  }

  void use()
  {
    for(int i = 0; i < 12 && !m_data.is_empty(); ++i)
    {
      try
      {
        take_step();
      }
      catch(const std::invalid_argument&)
      {
      }
    }
    compare_with_new_object();
  }

private:
  struct Source
  {
    Surface_point point;
    double initial_distance;
  };

  void take_step()
  {
    switch(m_data.below(8))
    {
    case 0:
    case 1:
      return add_source();
    case 2:
      return remove_source();
    case 3:
      return m_paths.build_sequence_tree(parameters::maximum_distance(m_data.number()));
    case 4:
    {
      const std::vector<Surface_point> targets(m_data.below(3), fuzzed_place(m_data, m_mesh));
      return m_paths.build_sequence_tree(parameters::targets(targets));
    }
    case 5:
      return check_path(fuzzed_place(m_data, m_mesh), m_data.coin());
    case 6:
      return check_pair();
    default:
      m_paths.build_sequence_tree(parameters::default_values());
      check_path(fuzzed_place(m_data, m_mesh), m_data.coin());
    }
  }

  void add_source()
  {
    const Source source = {fuzzed_place(m_data, m_mesh), m_data.coin() ? m_data.number() : 0};
    m_paths.add_source_point(source.point, source.initial_distance);
    m_sources.push_back(source);
  }

  void remove_source()
  {
    if(m_sources.empty())
      return m_paths.remove_all_source_points();
    const auto i = static_cast<std::ptrdiff_t>(m_data.below(m_sources.size()));
    m_paths.remove_source_point(std::next(m_paths.source_points_begin(), i));
    m_sources.erase(m_sources.begin() + i);
  }

  void check_path(const Surface_point& start, const bool is_straight)
  {
    std::vector<Point> points;
    const double distance = m_paths.shortest_distance_to_source_points(start).first;
    const auto [length, source] =
        is_straight ? m_paths.shortest_path_points_to_source_points(
                          face_location(start).first, face_location(start).second,
                          std::back_inserter(points), parameters::straighten(true))
                    : m_paths.shortest_path_points_to_source_points(face_location(start).first,
                                                                    face_location(start).second,
                                                                    std::back_inserter(points));
    require(distance >= 0 || distance == -1, "a distance is not one", distance);
    require((distance == -1) == points.empty(), "a path is missing", distance, points.size());
    if(points.empty())
      return;
    const auto i = std::distance(m_paths.source_points_begin(), source);
    const double sum = length_of(points) + m_sources[std::size_t(i)].initial_distance;
    check_sum(sum, length);
    require(is_at_most(length, distance), "a path is longer than its distance", length, distance);
  }

  void check_pair()
  {
    const Surface_point source = fuzzed_place(m_data, m_mesh),
                        target = fuzzed_place(m_data, m_mesh);
    const double distance = m_paths.shortest_distance(source, target);
    require(distance >= 0 || distance == -1, "a distance is not one", distance);
    std::vector<Point> points;
    const double length =
        m_data.coin() ? m_paths.shortest_path_points(source, target, std::back_inserter(points),
                                                     parameters::straighten(true))
                      : m_paths.shortest_path_points(source, target, std::back_inserter(points));
    require(is_at_most(length, distance), "a path is longer than its distance", length, distance);
    if(!points.empty())
      check_sum(length_of(points), length);
    const double limit = m_data.number();
    const double limited =
        m_paths.shortest_distance(source, target, parameters::maximum_distance(limit));
    require(limited == -1 || is_at_most(limited, distance), "a limit makes a distance longer");
  }

  void check_sum(const double sum, const double length) const
  {
    require(std::abs(sum - length) <= 1e-7 * sum + tolerance(), "a path has another length", sum,
            length);
  }

  void compare_with_new_object()
  {
    m_paths.build_sequence_tree(parameters::default_values());
    Shortest_paths other(m_mesh, m_np);
    for(const Source& source : m_sources)
      other.add_source_point(source.point, source.initial_distance);
    for(const Vertex v : m_mesh.vertices())
      require(m_paths.shortest_distance_to_source_points(v).first ==
                  other.shortest_distance_to_source_points(v).first,
              "an object does not forget");
  }

  Face_location face_location(const Surface_point& point) const
  {
    return m_paths.face_location(point);
  }

  // Where there is no path, both are -1.
  bool is_at_most(const double length, const double distance) const
  {
    return length <= (std::max)(distance, distance * rounding) + tolerance();
  }

  // In caps and needles, half of the digits of a height follow from lengths.
  double tolerance() const
  {
    const auto& lengths = m_paths.graph().triangulation().lengths();
    const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
    return 1e-7 * longest * m_paths.graph().unit();
  }

  const Mesh& m_mesh;
  Fuzzed_data& m_data;
  const NamedParameters m_np;
  Shortest_paths m_paths;
  std::vector<Source> m_sources;
};

template <typename Graph, typename NamedParameters>
void use(const Mesh& mesh, Fuzzed_data& data, const NamedParameters& np)
{
  User<Graph, NamedParameters>(mesh, data, np).use();
}

// A parameter that graphs get the larger for the smaller it is; and one that is refused stays so.
double at_least(const double smallest, const double parameter)
{
  return parameter >= 0 && parameter < smallest ? smallest : parameter;
}

double fuzzed_epsilon(Fuzzed_data& data) { return at_least(0.02, data.number()); }

std::vector<double> fuzzed_numbers(Fuzzed_data& data, const std::size_t size)
{
  std::vector<double> result;
  for(std::size_t i = 0; i < size; ++i)
    result.push_back(data.number());
  return result;
}

template <typename NamedParameters>
void call_functions(const Mesh& mesh, Fuzzed_data& data, const NamedParameters& np)
{
  std::vector<double> distances(mesh.num_vertices(), -1);
  std::vector<Surface_point> sources(1 + data.below(3), fuzzed_place(data, mesh));
  sources.push_back(fuzzed_place(data, mesh));
  const std::vector<double> initial = fuzzed_numbers(data, data.below(5));
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  CGAL::approximate_geodesic_distances(mesh, map, sources, np);
  for(const double distance : distances)
    require(distance >= 0, "a distance is negative or not a number", distance);
  std::vector<Point> points;
  const double length = CGAL::approximate_geodesic_path(mesh, std::back_inserter(points),
                                                        sources.front(), sources.back(), np);
  require(points.empty() == (length < 0 || length == infinity), "a path is missing", length);
  CGAL::approximate_geodesic_distances(mesh, map, sources, parameters::initial_distances(initial));
  for(const double distance : distances)
    require(distance >= 0, "a distance is negative or not a number", distance);
}

// Fields that are no distances at all.
void call_functions_of_fields(const Mesh& mesh, Fuzzed_data& data)
{
  std::vector<double> field = fuzzed_numbers(data, mesh.num_vertices());
  const auto map = boost::make_iterator_property_map(field.begin(), get(boost::vertex_index, mesh));
  std::vector<Kernel::Vector_3> gradient(mesh.num_faces());
  AG::gradient(mesh, map,
               boost::make_iterator_property_map(gradient.begin(), get(boost::face_index, mesh)));
  for(const Kernel::Vector_3& g : gradient)
    for(int i = 0; i < 3; ++i)
      require(std::isfinite(g[i]), "a gradient is not finite");
  std::vector<std::vector<Point>> lines;
  AG::isolines(mesh, map, fuzzed_numbers(data, data.below(4)), std::back_inserter(lines));
  for(const std::vector<Point>& line : lines)
    for(const Point& p : line)
      require(std::isfinite(p.x() + p.y() + p.z()), "an isoline leaves the mesh");
}

void call_functions_of_vertices(const Mesh& mesh, Fuzzed_data& data)
{
  std::vector<Vertex> sources;
  for(std::size_t i = data.below(4); i > 0; --i)
    sources.push_back(fuzzed_vertex(data, mesh));
  std::vector<std::size_t> cells(mesh.num_faces());
  const auto number = static_cast<std::ptrdiff_t>(data.below(40)) - 2;
  std::vector<Vertex> samples;
  AG::farthest_point_sampling(mesh, std::back_inserter(samples), number, sources);
  require(samples.size() <= mesh.num_vertices(), "more samples than vertices");
  AG::voronoi_partition(
      mesh, boost::make_iterator_property_map(cells.begin(), get(boost::face_index, mesh)),
      sources);
  const double tolerance = data.number();
  std::vector<Point> points;
  AG::refined_path(mesh, std::back_inserter(points), fuzzed_vertex(data, mesh),
                   fuzzed_vertex(data, mesh),
                   parameters::relative_tolerance(at_least(1e-3, tolerance)));
}

void check(const Mesh& mesh, Fuzzed_data& data)
{
  using Steiner_graph = AG::Steiner_graph<AG::Fixed_number_of_points>;
  using parameters::epsilon;
  switch(data.below(10))
  {
  case 0:
    return use<AG::Edge_graph>(mesh, data, parameters::default_values());
  case 1:
    return use<AG::Discrete_geodesic_graph>(mesh, data, epsilon(0.1));
  case 2:
    return use<AG::Lazy_discrete_geodesic_graph>(mesh, data, epsilon(0.1));
  case 3:
    return use<Steiner_graph>(mesh, data, parameters::number_of_points_per_edge(2));
  case 4: // as needles get very many points, or are refused
    return use<AG::Steiner_graph<>>(
        mesh, data, epsilon(0.3).accept_weaker_bound(true).maximum_number_of_points_per_edge(60));
  case 5:
    return use<AG::Saddle_vertex_graph>(mesh, data, epsilon(0));
  case 6:
    return call_functions(mesh, data, parameters::maximum_distance(data.number()));
  case 7:
    return call_functions(mesh, data, parameters::epsilon(fuzzed_epsilon(data)));
  case 8:
    return call_functions_of_fields(mesh, data);
  default:
    call_functions_of_vertices(mesh, data);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, const std::size_t size)
{
  static const std::vector<Mesh> all = meshes();
  Fuzzed_data data(bytes, size);
  try
  {
    check(all[data.below(all.size())], data);
  }
  catch(const std::invalid_argument&)
  {
  }
  catch(const std::length_error&) // too many points
  {
  }
  return 0;
}
