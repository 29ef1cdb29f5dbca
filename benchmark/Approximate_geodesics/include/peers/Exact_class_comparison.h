// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_EXACT_CLASS_COMPARISON_H
#define BENCHMARK_EXACT_CLASS_COMPARISON_H

#include "measuring/Path_measure.h"
#include "measuring/child_process.h"
#include "meshes/Mesh.h"
#include "peers/Exact_case.h"
#include "peers/Exact_search.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

// Limits for the exact class.
struct Limits
{
  unsigned seconds = 60; // CPU time per mesh
  std::size_t faces = 100000;
};

/*
 * Compares the exact distances of the package, "ours", with those of CGAL's exact class, "theirs".
 * Both are subject to rounding, and could miss a path because of it. If distances differ by more
 * than rounding, the path with the smaller distance is measured on the mesh: its length proves an
 * error of the other class.
 */
class Exact_class_comparison
{
public:
  struct Difference
  {
    Vertex source, vertex;
    double ours = 0, theirs = 0;
    double relative = 0; // absolute value
  };

  // Throws `std::runtime_error` if the class does not terminate in time.
  Exact_class_comparison(const Exact_case& ours, const Limits& limits) : m_ours(ours)
  {
    if(ours.mesh().number_of_faces() > limits.faces)
      throw std::runtime_error("more than " + std::to_string(limits.faces) + " faces");
    run(numbers_from_child(2 * number_of_distances(), limits.seconds,
                           [&](double* const result) { find_theirs(result); }));
  }

  std::size_t number_of_distances() const
  {
    return m_ours.sources().size() * m_ours.mesh().number_of_vertices();
  }

  const Difference& largest() const { return m_largest; }

  // Differences that exceed rounding, and the number of those that prove an error.
  std::size_t number_of_differences() const { return m_number_of_differences; }
  std::size_t number_of_theirs_too_long() const { return m_number_of_theirs_too_long; }
  std::size_t number_of_ours_too_long() const { return m_number_of_ours_too_long; }

private:
  using Our_paths = CGAL::Approximate_geodesics::
      Surface_mesh_shortest_path<Mesh, CGAL::Approximate_geodesics::Saddle_vertex_graph>;

  static bool is_shorter(const double a, const double b)
  {
    return a < b * (1 - Exact_case::ROUNDING);
  }

  // Writes all distances, then the lengths of the paths that are shorter than ours.
  void find_theirs(double* distance) const
  {
    double* length = distance + number_of_distances();
    Exact_search search(m_ours.mesh());
    Path_measure measure(m_ours.mesh());
    for(std::size_t i = 0; i < m_ours.sources().size(); ++i)
    {
      search.run(m_ours.sources()[i]);
      for(const Vertex v : m_ours.mesh().vertices())
      {
        *distance = search.distance(v);
        if(is_shorter(*distance, m_ours.distance(i, v)))
          *length = measure.length(search.path(v));
        ++distance;
        ++length;
      }
    }
  }

  void run(const std::vector<double>& theirs)
  {
    Path_measure measure(m_ours.mesh());
    Our_paths paths(m_ours.mesh());
    auto distance = theirs.begin();
    auto length = distance + std::ptrdiff_t(number_of_distances());
    for(std::size_t i = 0; i < m_ours.sources().size(); ++i)
    {
      paths.remove_all_source_points();
      paths.add_source_point(m_ours.sources()[i]);
      for(const Vertex v : m_ours.mesh().vertices())
      {
        const Difference difference = this->difference(i, v, *distance++);
        const double length_of_theirs = *length++;
        if(difference.relative > m_largest.relative)
          m_largest = difference;
        if(is_shorter(difference.theirs, difference.ours))
          m_number_of_ours_too_long += length_of_theirs < difference.ours;
        else if(is_shorter(difference.ours, difference.theirs))
          m_number_of_theirs_too_long += our_length(paths, v, measure) < difference.theirs;
        else
          continue;
        ++m_number_of_differences;
      }
    }
  }

  Difference difference(const std::size_t i, const Vertex v, const double theirs) const
  {
    const double ours = m_ours.distance(i, v);
    const double relative = ours == theirs ? 0 : std::abs(theirs - ours) / (std::min)(ours, theirs);
    return {m_ours.sources()[i], v, ours, theirs, relative};
  }

  static double our_length(Our_paths& paths, const Vertex v, Path_measure& measure)
  {
    std::vector<Path_measure::Point> points;
    paths.shortest_path_points_to_source_points(v, std::back_inserter(points));
    return measure.length(points);
  }

  const Exact_case& m_ours;
  Difference m_largest;
  std::size_t m_number_of_differences = 0;
  std::size_t m_number_of_theirs_too_long = 0;
  std::size_t m_number_of_ours_too_long = 0;
};

#endif // BENCHMARK_EXACT_CLASS_COMPARISON_H
