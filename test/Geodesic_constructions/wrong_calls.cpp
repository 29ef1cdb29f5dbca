// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that must not compile, each below the message that the compiler has to print for it.

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/offset_curves.h>
#include <CGAL/Geodesic_constructions/voronoi_borders.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

void call_wrongly(const Mesh& mesh,
                  const Mesh::Property_map<Vertex, double> distances,
                  const Mesh::Property_map<Face, int> cells,
                  const Mesh::Property_map<Face, Vector> gradients)
{
  const std::vector<double> isovalues;
  const std::vector<Vertex> vertices;
  std::vector<std::vector<Point>> lines;
  std::vector<Vertex> samples;

  // isolines() reads vertex_point_map and geom_traits only
  AG::isolines(mesh, distances, isovalues, std::back_inserter(lines), parameters::epsilon(0.1));

  // gradient() reads vertex_point_map and geom_traits only
  AG::gradient(mesh, distances, gradients, parameters::maximum_distance(3));

  // farthest_point_sampling() reads epsilon
  AG::farthest_point_sampling(mesh, std::back_inserter(samples), 3, parameters::targets(vertices));

  // farthest_point_sampling() takes a vertex or a range of vertices as sources
  AG::farthest_point_sampling(mesh, std::back_inserter(samples), 3, AG::Face_location<Mesh>());

  // approximate_geodesic_distances() does not read one of these named parameters
  AG::voronoi_partition(mesh, cells, vertices, parameters::straighten(true));

  // voronoi_borders() and cut_locus() are exact, and read edge_length_map
  AG::voronoi_borders(mesh, vertices, parameters::epsilon(0.1));

  // offset_curves() is exact
  std::vector<AG::Offset_curve<Point>> curves;
  AG::offset_curves(mesh, Vertex(0), 0.1, std::back_inserter(curves), parameters::epsilon(0.1));
}
