// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_DISTANCE_MATRICES_H
#define APPROXIMATE_GEODESICS_TEST_DISTANCE_MATRICES_H

#include "checks/graphs_of_all_kinds.h"
#include "meshes/surface_points.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// What row sinks hold, and what they should.

namespace geodesics_test {

using CGAL::Approximate_geodesics::Dense_rows;
using CGAL::Approximate_geodesics::Distance_row;
using CGAL::Approximate_geodesics::Intrinsic_point;
using CGAL::Approximate_geodesics::Nearest_rows;
using CGAL::Approximate_geodesics::Radius_rows;
using CGAL::Approximate_geodesics::Sparse_rows;

// All distances, by row and column. They are compared to the last bit: none is negative, or not a
// number.
using Matrix = std::vector<std::vector<double>>;

// A distance and its column: entries that are equally far are ordered by column.
using Entry = std::pair<double, std::size_t>;
using Entries = std::vector<std::vector<Entry>>; // by row

template <typename T>
Matrix matrix_of(const Dense_rows<T>& rows)
{
  Matrix result;
  for(std::size_t i = 0; i < rows.number_of_rows(); ++i)
    result.emplace_back(rows.row(i).begin(), rows.row(i).end());
  return result;
}

template <typename T>
Entries entries_of(const Sparse_rows<T>& rows)
{
  Entries result(rows.number_of_rows());
  std::size_t number = 0;
  for(std::size_t i = 0; i < result.size(); ++i)
  {
    const auto columns = rows.columns(i);
    const auto distances = rows.distances(i);
    EXPECT_EQ(columns.size(), distances.size());
    for(std::size_t j = 0; j < columns.size(); ++j)
      result[i].emplace_back(double(distances.begin()[j]), columns.begin()[j]);
    number += result[i].size();
  }
  EXPECT_EQ(number, rows.number_of_entries());
  return result;
}

// ----- what is computed

// On a mesh or a graph.
template <typename Domain, typename Sources, typename... NamedParameters>
Matrix dense_matrix(const Domain& domain, const Sources& sources, const NamedParameters&... np)
{
  Dense_rows<> rows;
  EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(domain, rows, sources, np...));
  return matrix_of(rows);
}

template <typename Domain, typename Sources, typename... NamedParameters>
Entries radius_entries(const Domain& domain, const Sources& sources, const NamedParameters&... np)
{
  Radius_rows<> rows;
  EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(domain, rows, sources, np...));
  return entries_of(rows);
}

template <typename Domain, typename Sources, typename... NamedParameters>
Entries nearest_entries(const std::size_t number,
                        const Domain& domain,
                        const Sources& sources,
                        const NamedParameters&... np)
{
  Nearest_rows<> rows(number);
  EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(domain, rows, sources, np...));
  return entries_of(rows);
}

// ----- what is expected

// A search for each row.
template <typename GeodesicGraph>
Matrix matrix_by_searches(const GeodesicGraph& graph,
                          const std::vector<Intrinsic_point>& sources,
                          const std::vector<Intrinsic_point>& targets)
{
  CGAL::Approximate_geodesics::Surface_search<GeodesicGraph> search(graph);
  Matrix result;
  for(const Intrinsic_point& source : sources)
  {
    search.run({{source}});
    result.emplace_back();
    for(const Intrinsic_point& target : targets)
      result.back().push_back(search.distance(target));
  }
  return result;
}

// The entries up to `radius`, by column.
inline Entries within(const double radius, const Matrix& matrix)
{
  Entries result;
  for(const auto& row : matrix)
  {
    result.emplace_back();
    for(std::size_t j = 0; j < row.size(); ++j)
      if(row[j] <= radius && row[j] < infinity)
        result.back().emplace_back(row[j], j);
  }
  return result;
}

// The smallest ones of each row, and so many of them.
inline Entries nearest_of(const std::size_t number, Entries entries)
{
  for(auto& row : entries)
  {
    std::sort(row.begin(), row.end());
    row.resize((std::min)(row.size(), number));
  }
  return entries;
}

inline Matrix smaller_of_both_directions(Matrix matrix)
{
  for(std::size_t i = 0; i < matrix.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      matrix[i][j] = matrix[j][i] = (std::min)(matrix[i][j], matrix[j][i]);
  return matrix;
}

// Tells the first row that differs, as matrices are long.
template <typename Rows>
testing::AssertionResult are_the_same(const Rows& found, const Rows& expected)
{
  if(found.size() != expected.size())
    return testing::AssertionFailure() << found.size() << " rows, not " << expected.size();
  for(std::size_t i = 0; i < found.size(); ++i)
    if(found[i] != expected[i])
      return testing::AssertionFailure()
             << "row " << i << " is " << testing::PrintToString(found[i]) << ", not "
             << testing::PrintToString(expected[i]);
  return testing::AssertionSuccess();
}

// The same, but for relative deviations, and for what rounding does to lengths of the size of
// `unit`.
inline testing::AssertionResult are_about_the_same(const Matrix& found,
                                                   const Matrix& expected,
                                                   const double deviation,
                                                   const double unit)
{
  if(found.size() != expected.size())
    return testing::AssertionFailure() << found.size() << " rows, not " << expected.size();
  for(std::size_t i = 0; i < found.size(); ++i)
    for(std::size_t j = 0; j < found[i].size(); ++j)
    {
      const double a = found[i][j], b = expected[i].at(j);
      if(a != b && !(std::abs(a - b) <= deviation * (std::min)(a, b) + 1e-12 * unit))
        return testing::AssertionFailure()
               << "row " << i << ", column " << j << " is " << a << ", not " << b;
    }
  return testing::AssertionSuccess();
}

// ----- points

inline std::vector<Vertex> vertices_of(const Mesh& mesh)
{
  return {mesh.vertices().begin(), mesh.vertices().end()};
}

inline std::vector<Intrinsic_point> intrinsic_points(const Mesh& mesh,
                                                     const Triangulation& triangulation,
                                                     const std::vector<Surface_point>& points)
{
  const CGAL::Approximate_geodesics::Mesh_translation translation(
      mesh, get(boost::vertex_index, mesh), triangulation);
  std::vector<Intrinsic_point> result;
  for(const Surface_point& p : points)
    result.push_back(translation.intrinsic_point(p));
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_DISTANCE_MATRICES_H
