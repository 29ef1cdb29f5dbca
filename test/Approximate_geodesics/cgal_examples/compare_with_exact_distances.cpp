// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/aabb_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// Reads the paths that one of CGAL's examples has found, and says whether each of them is as long
// as the exact one from its first point to any of their last points.

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Exact_paths =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
using Tree_traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;
using Path = std::vector<Point>;

// A path is a line, of the number of its points and the points; or it has a line for each of these.
std::vector<Path> read_paths(std::istream& input)
{
  const std::string label = "Position: ";
  std::vector<Path> result;
  Path by_lines;
  for(std::string line; std::getline(input, line);)
  {
    const std::size_t position = line.find(label);
    std::istringstream text(position == line.npos ? line : line.substr(position + label.size()));
    std::size_t number = 1;
    if(position == line.npos && !(text >> number))
      continue;
    Path path(number);
    for(Point& p : path)
      text >> p;
    if(position == line.npos)
      result.push_back(path);
    else
      by_lines.push_back(path.front());
  }
  if(!by_lines.empty())
    result.push_back(by_lines);
  return result;
}

double length(const Path& path)
{
  double result = 0;
  for(std::size_t i = 1; i < path.size(); ++i)
    result += std::sqrt(CGAL::squared_distance(path[i - 1], path[i]));
  return result;
}

// Coordinates have six digits.
double rounding(const Path& path) { return 2e-6 * static_cast<double>(path.size()); }

class Comparison
{
public:
  Comparison(const Mesh& mesh, const std::vector<Path>& paths) : m_exact(mesh)
  {
    m_exact.build_aabb_tree(m_tree);
    std::set<Point> sources;
    for(const Path& path : paths)
      if(sources.insert(path.back()).second)
        m_exact.add_source_point(m_exact.locate(path.back(), m_tree));
  }

  bool is_exact(const Path& path)
  {
    const auto [f, weights] = m_exact.locate(path.front(), m_tree);
    const double exact = m_exact.shortest_distance_to_source_points(f, weights).first;
    const double found = length(path);
    if(exact > 0)
    {
      m_sum += found / exact;
      m_largest = (std::max)(m_largest, found / exact);
    }
    return std::abs(found - exact) <= rounding(path);
  }

  double sum() const { return m_sum; }
  double largest() const { return m_largest; }

private:
  Exact_paths m_exact;
  CGAL::AABB_tree<Tree_traits> m_tree;
  double m_sum = 0, m_largest = 0; // of quotients
};

int main(int argc, char** argv)
{
  if(argc != 2)
    return EXIT_FAILURE;
  std::ifstream file(argv[1]);
  const std::vector<Path> paths = read_paths(file);
  Mesh mesh;
  if(paths.empty() ||
     std::any_of(paths.begin(), paths.end(), [](const Path& p) { return p.empty(); }) ||
     !CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/elephant.off"), mesh))
    return EXIT_FAILURE;

  Comparison comparison(mesh, paths);
  const auto number_of_bad_ones = std::count_if(
      paths.begin(), paths.end(), [&](const Path& path) { return !comparison.is_exact(path); });
  std::cout << paths.size() << " paths, times the exact length: "
            << comparison.sum() / static_cast<double>(paths.size()) << " in the mean, "
            << comparison.largest() << " at most; " << number_of_bad_ones << " are not exact\n";
  return number_of_bad_ones == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
