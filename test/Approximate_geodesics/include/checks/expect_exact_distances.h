// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXPECT_EXACT_DISTANCES_H
#define APPROXIMATE_GEODESICS_TEST_EXPECT_EXACT_DISTANCES_H

#include "meshes/Developed_surface.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace geodesics_test {

using CGAL::Approximate_geodesics::Saddle_vertex_graph;
using Exact_search = CGAL::Approximate_geodesics::Surface_search<Saddle_vertex_graph>;

// What rounding may change: distances, and the places of points.
constexpr double tolerance_of_exact_distances = 1e-12;

// The length that a `double` can be wrong by where lengths are of the size of the longest edge.
inline double rounding_of_places(const Triangulation& t)
{
  const auto& lengths = t.lengths();
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  return 16 * std::numeric_limits<double>::epsilon() * longest * t.unit();
}

// Finds distances and paths on a surface of which a closed form is known.
class Exactness
{
public:
  explicit Exactness(Developed_surface surface)
    : m_mesh(std::move(surface)),
      m_graph(m_mesh.triangulation),
      m_search(m_graph),
      m_rounding(rounding_of_places(m_mesh.triangulation))
  {
  }

  // from some points to others
  void expect_distances(const std::vector<Face_location>& sources,
                        const std::vector<Face_location>& targets)
  {
    for(const Face_location& source : sources)
    {
      m_search.run({{m_mesh.intrinsic(source)}});
      for(const Face_location& target : targets)
        expect_distance(source, target);
    }
  }

  // likewise; with their paths
  void expect_paths(const std::vector<Face_location>& sources,
                    const std::vector<Face_location>& targets)
  {
    for(const Face_location& source : sources)
    {
      m_search.run({{m_mesh.intrinsic(source)}});
      for(const Face_location& target : targets)
      {
        expect_distance(source, target);
        expect_path(source, target);
      }
    }
  }

  // from and to points of all kinds, chosen at random; to all vertices
  void expect_all(Random& random, const std::size_t number_of_sources)
  {
    std::vector<Face_location> corners = m_mesh.corners(), targets = corners, others;
    random.shuffle(corners);
    corners.resize((std::min)(corners.size(), number_of_sources));
    for(std::size_t i = 0; i < number_of_sources; ++i)
      corners.push_back(m_mesh.random_location(random));
    for(std::size_t i = 0; i < 20; ++i)
      others.push_back(m_mesh.random_location(random));
    expect_distances(corners, targets);
    random.shuffle(targets);
    targets.resize((std::min)(targets.size(), others.size()));
    expect_paths(corners, targets);
    expect_paths(corners, others);
  }

  const Developed_mesh& mesh() const { return m_mesh; }

private:
  void expect_distance(const Face_location& source, const Face_location& target)
  {
    const Long expected = m_mesh.distance(source, target);
    const double found = m_search.distance(m_mesh.intrinsic(target));
    EXPECT_NEAR(found, static_cast<double>(expected), tolerance(expected)) << text(source, target);
    if(expected > m_rounding)
      record(static_cast<double>(std::abs(found - expected) / expected));
  }

  void expect_path(const Face_location& source, const Face_location& target) const
  {
    const auto path = m_search.find_path(m_mesh.intrinsic(target));
    ASSERT_FALSE(path.points.empty());
    EXPECT_TRUE(is_same(path.points.front(), m_mesh.intrinsic(target))) << text(source, target);
    EXPECT_TRUE(is_same(path.points.back(), m_mesh.intrinsic(source))) << text(source, target);
    std::vector<Surface_point> points;
    for(const auto& p : path.points)
      points.push_back(m_mesh.point_of_mesh(p));
    Long sum = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
      sum += m_mesh.distance_in_face(points[i - 1], points[i]);
    const Long expected = m_mesh.distance(source, target);
    EXPECT_NEAR(static_cast<double>(sum), static_cast<double>(expected), tolerance(expected))
        << text(source, target);
    EXPECT_NEAR(path.length, static_cast<double>(expected), tolerance(expected));
    for(std::size_t i = 1; i + 1 < points.size(); ++i)
      if(const auto* v = std::get_if<Vertex>(&points[i]))
        expect_bend(*v);
  }

  // Parts of the way along an edge from one end and from the other may not add up to 1.
  bool is_same(const CGAL::Approximate_geodesics::Intrinsic_point& p,
               const CGAL::Approximate_geodesics::Intrinsic_point& q) const
  {
    return p.is_same(q, m_mesh.triangulation) || q.is_same(p, m_mesh.triangulation);
  }

  void expect_bend(const Vertex v) const
  {
    constexpr Long rounding = 1e-9;
    if(!m_mesh.mesh.is_border(v))
    {
      EXPECT_GE(m_mesh.angle_around(v), 8 * std::atan(Long(1)) - rounding) << v;
    }
  }

  double tolerance(const Long expected) const
  {
    return tolerance_of_exact_distances * static_cast<double>(expected) + m_rounding;
  }

  std::string text(const Face_location& s, const Face_location& t) const
  {
    std::ostringstream out;
    out.precision(17);
    for(const Face_location& p : {s, t})
      out << " face " << p.first.idx() << " weights " << p.second[0] << ' ' << p.second[1] << ' '
          << p.second[2];
    return out.str();
  }

  void record(const double error)
  {
    if(!(error > m_largest_error))
      return;
    m_largest_error = error;
    if(std::getenv("APPROXIMATE_GEODESICS_TEST_ERRORS") != nullptr)
      std::cout << "relative error " << error << std::endl;
  }

  const Developed_mesh m_mesh;
  const Saddle_vertex_graph m_graph;
  Exact_search m_search;
  double m_rounding, m_largest_error = 0;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_EXPECT_EXACT_DISTANCES_H
