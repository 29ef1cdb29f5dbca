// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The results and the times of a native `Solver`, which those of JavaScript are compared with.
//
// Usage: native_solver MESH EPSILON [RUNS]
//   MESH     two numbers of 32 bits, of vertices and faces; the coordinates, 64 bits each; and the
//            vertices of the faces, 32 bits each
//   EPSILON  a number; or "edges"; or "weights", for 0.1 and the weights 1, 2 and 3
//   RUNS     print only the times of so many constructions, and of searches from vertex 0

#include <CGAL/Approximate_geodesics/Solver/Solver.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

struct Mesh
{
  std::vector<double> vertices;
  std::vector<std::int32_t> faces;
};

template <typename T>
void read(std::istream& in, std::vector<T>& values)
{
  in.read(reinterpret_cast<char*>(values.data()),
          static_cast<std::streamsize>(values.size() * sizeof(T)));
}

Mesh read_mesh(const char* const file)
{
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint32_t> sizes(2);
  read(in, sizes);
  Mesh result{std::vector<double>(3 * sizes[0]), std::vector<std::int32_t>(3 * sizes[1])};
  read(in, result.vertices);
  read(in, result.faces);
  if(!in)
  {
    std::fprintf(stderr, "cannot read %s\n", file);
    std::exit(EXIT_FAILURE);
  }
  return result;
}

AG::Solver make_solver(const Mesh& mesh, const std::string& epsilon)
{
  AG::Solver_options options;
  if(epsilon != "edges")
    options.epsilon = epsilon == "weights" ? 0.1 : std::stod(epsilon);
  std::vector<double> weights;
  for(std::size_t f = 0; f < mesh.faces.size() / 3; ++f)
    weights.push_back(1 + f % 3);
  if(epsilon == "weights")
    options.face_weights = weights.data();
  return AG::Solver(mesh.vertices.data(), mesh.vertices.size() / 3, mesh.faces.data(),
                    mesh.faces.size() / 3, options);
}

template <typename T>
void print(const char* const name, const std::vector<T>& values)
{
  std::printf("%s", name);
  for(const T value : values)
    std::printf(" %.17g", static_cast<double>(value));
  std::printf("\n");
}

// What `results.js` computes, too.
void print_results(const AG::Solver& solver)
{
  const auto last = static_cast<std::int64_t>(solver.number_of_vertices()) - 1;
  const std::vector<AG::Solver_point> sources{AG::Solver_point::at_vertex(0),
                                              AG::Solver_point::in_face(last, {0.25, 0.25, 0.5})};
  std::vector<double> distances(solver.number_of_vertices()), path;
  std::vector<std::int64_t> nearest(distances.size()), predecessors(distances.size());
  solver.find_distances(sources, distances.data(), nearest.data(), predecessors.data());
  print("distances", distances);
  print("nearest", nearest);
  print("predecessors", predecessors);
  path.push_back(solver.find_path(sources[1], AG::Solver_point::on_edge(0, 1, 0.5), false, path));
  print("path", path);
  std::vector<std::int64_t> cells(solver.number_of_faces()), vertices;
  solver.find_voronoi_partition(sources, cells.data());
  print("voronoi", cells);
  const double radius = solver.find_farthest_vertices(10, {}, vertices);
  print("farthestPoints", vertices);
  print("radius", std::vector<double>{radius});
  std::vector<double> matrix(distances.size() * sources.size());
  solver.compute_matrix(matrix.data(), sources);
  print("matrix", matrix);
  std::vector<double> gradient(3 * cells.size());
  solver.find_gradient(distances.data(), gradient.data());
  print("gradient", gradient);
  const double largest = *std::max_element(distances.begin(), distances.end());
  for(const auto& line : solver.find_isolines(distances.data(), largest / 2))
    print("isoline", line);
}

// Processor time, which depends less on what else runs.
template <typename F>
double seconds(const F& f)
{
  const std::clock_t start = std::clock();
  f();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void print_times(const Mesh& mesh, const std::string& epsilon, const int runs)
{
  std::vector<double> constructions, searches, distances(mesh.vertices.size() / 3);
  for(int i = 0; i < runs; ++i)
    constructions.push_back(seconds([&] { make_solver(mesh, epsilon); }));
  const AG::Solver solver = make_solver(mesh, epsilon);
  for(int i = 0; i < runs; ++i)
    searches.push_back(seconds(
        [&] { solver.find_distances({AG::Solver_point::at_vertex(0)}, distances.data()); }));
  print("constructions", constructions);
  print("searches", searches);
}

int main(int argc, char* argv[])
{
  if(argc < 3)
    return EXIT_FAILURE;
  const Mesh mesh = read_mesh(argv[1]);
  if(argc > 3)
    print_times(mesh, argv[2], std::atoi(argv[3]));
  else
    print_results(make_solver(mesh, argv[2]));
}
