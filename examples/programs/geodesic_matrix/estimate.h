#ifndef GEODESIC_MATRIX_ESTIMATE_H
#define GEODESIC_MATRIX_ESTIMATE_H

#include "../command_line/Table.h"
#include "Row_sample.h"
#include "matrix.h"
#include "peak_memory.h"
#include "texts.h"

#include <CGAL/Approximate_geodesics/Matrix_files/Npy_file.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>

// The bytes that a search takes, beside those of the graph.
template <typename Graph>
std::size_t memory_of_search(const Graph& graph, const std::size_t source, const double radius)
{
  namespace AG = CGAL::Approximate_geodesics;
  AG::Surface_search<Graph> search(graph);
  const auto vertex = graph.triangulation().vertex(source);
  search.run({{AG::Intrinsic_point::at_vertex(vertex)}}, {radius});
  return search.search().memory();
}

// The bytes that a thread takes for the row that it computes, and for those that it keeps before it
// writes them.
template <typename T>
double memory_of_rows(const Row_sample<T>& sample, const bool is_sparse)
{
  const double entry = is_sparse ? sizeof(T) + sizeof(std::uint32_t) : sizeof(T);
  return sizeof(double) * double(sample.number_of_columns()) +
         entry * sample.entries_per_row() * double(sample.rows_per_block());
}

// The bytes of the file. Those of a sparse one follow from the sample.
template <typename T>
double length_of_file(const Row_sample<T>& sample, const bool is_sparse)
{
  if(!is_sparse)
    return double(CGAL::Approximate_geodesics::Npy_file<T>::length(sample.number_of_rows(),
                                                                   sample.number_of_columns()));
  return double(sample.number_of_rows()) *
         (sizeof(std::uint64_t) +
          sample.entries_per_row() * double(sizeof(std::uint32_t) + sizeof(T)));
}

// Tells what the file would cost, and writes nothing.
template <typename T, typename Graph>
void print_estimate(const Options& options,
                    const Graph& graph,
                    const Matrix_vertices& vertices,
                    const std::size_t number_of_threads,
                    const std::size_t number_of_processes)
{
  Row_sample<T> sample(options.is_sparse(), options.nearest);
  CGAL::Approximate_geodesics::Distance_matrix_visitor_base visitor;
  CGAL::approximate_geodesic_distance_matrix(graph, sample, vertices.sources,
                                             matrix_parameters(options, vertices, visitor));
  const double peak = peak_memory(); // the sample has used what all rows will use

  const double search = double(memory_of_search(graph, vertices.sources.front(), options.radius));
  const double rows = memory_of_rows(sample, options.is_sparse());
  const double length = length_of_file(sample, options.is_sparse());
  const double on_disk = options.is_sparse() ? 2 * length : length; // blocks, then the arrays
  const std::filesystem::path folder = std::filesystem::path(options.output).parent_path();
  const double room = double(std::filesystem::space(folder.empty() ? "." : folder).available);

  Table table;
  table.add("rows", sample.number_of_rows());
  table.add("columns", sample.number_of_columns());
  if(options.is_sparse())
    table.add("entries per row, about", text_of_number(sample.entries_per_row()));
  table.add(options.is_sparse() ? "length of the file, about" : "length of the file",
            text_of_bytes(length));
  table.add("room needed on the disk", text_of_bytes(on_disk));
  table.add("room there", text_of_bytes(room));
  table.add("memory of the graph", text_of_bytes(double(graph.memory())));
  table.add("memory of a thread's search", text_of_bytes(search));
  table.add("memory of a thread's rows", text_of_bytes(rows));
  table.add("peak memory of a process", text_of_bytes(peak));
  table.add("threads of a process", number_of_threads);
  table.add("processes", number_of_processes);
  table.add("time to compute, about",
            text_of_time(sample.seconds_per_row() * double(sample.number_of_rows()) /
                         double(number_of_processes)));
  table.print(std::cout);
  if(on_disk > room)
    std::cout << "The disk does not have enough room.\n";
}

#endif // GEODESIC_MATRIX_ESTIMATE_H
