#ifndef GEODESIC_MATRIX_MATRIX_H
#define GEODESIC_MATRIX_MATRIX_H

#include "Options.h"
#include "Processes.h"
#include "Vertex_choice.h"

#include <CGAL/Approximate_geodesics/Matrix_files/Csr_file.h>
#include <CGAL/Approximate_geodesics/Matrix_files/Npy_file.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <cstdint>
#include <functional>

// The vertices of rows and columns, by their numbers in the file or in the mesh.
struct Matrix_vertices
{
  Vertex_choice::Indices sources;
  Vertex_choice::Indices targets;
};

inline Matrix_vertices vertices_in_mesh(Matrix_vertices numbers, const Vertices_of_file& vertices)
{
  for(Vertex_choice::Indices* const indices : {&numbers.sources, &numbers.targets})
    for(std::uint64_t& index : *indices)
      index = vertices.vertex(index);
  return numbers;
}

template <typename Visitor>
auto matrix_parameters(const Options& options, const Matrix_vertices& vertices, Visitor& visitor)
{
  return CGAL::parameters::targets(vertices.targets)
      .maximum_distance(options.radius)
      .concurrency_tag(CGAL::Parallel_if_available_tag())
      .visitor(std::ref(visitor));
}

// Computes the file, or resumes it. Returns whether it is complete.
template <typename T, typename Graph, typename Visitor>
bool write_matrix(const Options& options,
                  const Graph& graph,
                  const Matrix_vertices& vertices,
                  Processes& processes,
                  Visitor& visitor)
{
  namespace AG = CGAL::Approximate_geodesics;
  const auto np = matrix_parameters(options, vertices, visitor);
  if(!options.is_sparse())
  {
    AG::Npy_file<T> file(options.output, processes.team());
    return CGAL::approximate_geodesic_distance_matrix(graph, file, vertices.sources,
                                                      np.symmetric(options.is_symmetric));
  }
  AG::Csr_file<T> file(options.output, processes.team());
  if(options.nearest > 0)
    file.keep_nearest(options.nearest);
  return CGAL::approximate_geodesic_distance_matrix(graph, file, vertices.sources, np);
}

#endif // GEODESIC_MATRIX_MATRIX_H
