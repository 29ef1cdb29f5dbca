// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles/test_oracles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

// Relations between the distances on a mesh and on one that is derived from it.

namespace {

using namespace geodesics_test;

struct Named_soup
{
  std::string name;
  Soup soup;
};

std::vector<Named_soup> soups()
{
  Random random(test_seed());
  std::vector<Named_soup> result;
  result.push_back({"terrain", terrain(25, 20, random)});
  result.push_back({"sphere", sphere(16, 11)});
  result.push_back({"strip", growing_strip(200, 1e-6, 1e6)});
  result.push_back({"random soup", random_soup(80, 250, random)});
  result.push_back({"parts", scattered_parts(random)});
  return result;
}

std::vector<double> distances(const Soup& soup, const std::size_t source)
{
  const Mesh mesh = to_mesh(soup);
  return Mesh_search(mesh).distances({Vertex(static_cast<Mesh::size_type>(source))});
}

// The largest number of roundings in a distance.
double rounding_error(const double distance, const std::size_t vertices)
{
  return distance * static_cast<double>(vertices) * 0x1p-53;
}

TEST(Distances, do_not_change_when_a_coordinate_is_mirrored)
{
  for(const auto& [name, soup] : soups())
  {
    SCOPED_TRACE(name);
    const auto mirror = [](const Point& p) { return Point(-p.x(), p.y(), p.z()); };
    EXPECT_TRUE(have_same_bits(distances(soup.transformed(mirror), 3), distances(soup, 3)));
  }
}

TEST(Distances, do_not_change_when_an_integer_grid_moves_by_integers)
{
  const auto bend = [](const Point& p) { return Point(p.x(), 2 * p.y(), int(p.x()) % 3); };
  const auto move = [](const Point& p) { return Point(p.x() + 12345, p.y() - 777, p.z() + 31); };
  const Soup soup = flat_grid(20, 20).transformed(bend);
  EXPECT_TRUE(have_same_bits(distances(soup.transformed(move), 3), distances(soup, 3)));
}

TEST(Distances, do_not_change_when_faces_are_flipped_or_permuted)
{
  Random random(test_seed());
  for(const auto& [name, soup] : soups())
  {
    SCOPED_TRACE(name);
    const std::vector<double> expected = distances(soup, 3);
    Soup other = soup;
    random.shuffle(other.triangles);
    for(auto& t : other.triangles)
      std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.below(3)), t.end());
    EXPECT_TRUE(have_same_bits(distances(other, 3), expected));
    for(auto& t : other.triangles)
      std::swap(t[0], t[1]);
    EXPECT_TRUE(have_same_bits(distances(other, 3), expected));
  }
}

TEST(Distances, do_not_change_when_vertices_are_permuted)
{
  Random random(test_seed());
  for(const auto& [name, soup] : soups())
  {
    SCOPED_TRACE(name);
    const std::vector<std::size_t> position = random.permutation(soup.points.size());
    const std::vector<double> expected = distances(soup, 3);
    const std::vector<double> found = distances(soup.renumbered(position), position[3]);
    for(std::size_t i = 0; i < position.size(); ++i)
      EXPECT_EQ(found[position[i]], expected[i]);
  }
}

TEST(Distances, are_symmetric)
{
  for(const auto& [name, soup] : soups())
  {
    SCOPED_TRACE(name);
    const std::size_t n = soup.points.size();
    const std::vector<double> from = distances(soup, 3);
    for(std::size_t i = 0; i < n; i += 17)
    {
      const double back = distances(soup, i)[3];
      if(from[i] == infinity)
      {
        EXPECT_EQ(back, infinity);
        continue;
      }
      EXPECT_NEAR(back, from[i], 2 * rounding_error(from[i], n)); // other order of the same sums
    }
  }
}

TEST(Distances, fulfil_the_triangle_inequality_and_are_no_shorter_than_straight_lines)
{
  for(const auto& [name, soup] : soups())
  {
    SCOPED_TRACE(name);
    const std::size_t n = soup.points.size();
    const std::vector<double> from = distances(soup, 3);
    for(std::size_t i = 0; i < n; i += 31)
    {
      if(from[i] == infinity)
        continue;
      const std::vector<double> further = distances(soup, i);
      for(std::size_t j = 0; j < n; ++j)
        EXPECT_LE(from[j], from[i] + further[j] + 2 * rounding_error(from[j], n));
    }
    for(std::size_t i = 0; i < n; ++i)
    {
      const double line = std::sqrt(CGAL::squared_distance(soup.points[i], soup.points[3]));
      // a sum of roots that were rounded can be below it by their errors
      EXPECT_GE(from[i], line - rounding_error(line, n + 4));
    }
  }
}

TEST(Distances, do_not_shrink_when_a_face_is_removed)
{
  Random random(test_seed());
  for(const auto& [name, soup] : soups())
  {
    SCOPED_TRACE(name);
    Mesh mesh = to_mesh(soup);
    Mesh_search before(mesh);
    std::vector<double> last = before.distances({Vertex(3)});
    for(std::size_t i = 0; i < 20; ++i)
    {
      // `remove_face()` takes edges and vertices away with it
      std::vector<Face> faces(mesh.faces_begin(), mesh.faces_end());
      CGAL::Euler::remove_face(mesh.halfedge(faces[random.below(faces.size())]), mesh);
      if(mesh.is_removed(Vertex(3)))
        break;
      Mesh_search after(mesh);
      const Field field = after.run({Vertex(3)});
      EXPECT_TRUE(is_optimal(mesh, edge_lengths(mesh), field, {Vertex(3)}));
      for(const Vertex v : mesh.vertices())
        EXPECT_GE(field.distance[v.idx()], last[v.idx()]);
      last = field.distance;
    }
  }
}

// Midpoints halve edges exactly, so paths along them keep their lengths; new edges only help.
TEST(Distances, do_not_grow_when_faces_are_split_in_four)
{
  const std::size_t n = 9;
  const Soup coarse = flat_grid(n, n).transformed(
      [](const Point& p) { return Point(2 * p.x(), 2 * p.y(), 2 * (int(p.x() * p.y()) % 5)); });
  const Soup fine = grid(2 * n - 1, 2 * n - 1, [&](const double i, const double j) {
    const auto at = [&](const double x, const double y) {
      return coarse.points[static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * n];
    };
    return CGAL::midpoint(at(std::floor(i / 2), std::floor(j / 2)),
                          at(std::ceil(i / 2), std::ceil(j / 2)));
  });
  const std::vector<double> before = distances(coarse, 0), after = distances(fine, 0);
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double limit = before[i + j * n];
      // twice as many roundings
      EXPECT_LE(after[2 * i + 2 * j * (2 * n - 1)], limit + 2 * rounding_error(limit, n * n));
    }
}

// Along axes and the diagonals that the grid has; anywhere else, a staircase of both.
TEST(Distances, on_a_grid_have_a_closed_form)
{
  const std::size_t n = 40;
  const std::vector<double> found = distances(flat_grid(n, n), 0);
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double straight = static_cast<double>((std::max)(i, j) - (std::min)(i, j));
      const double expected = straight + static_cast<double>((std::min)(i, j)) * std::sqrt(2.);
      EXPECT_NEAR(found[i + j * n], expected, rounding_error(expected, 2 * n));
    }
  EXPECT_EQ(found[n - 1], static_cast<double>(n - 1));
}

} // namespace
