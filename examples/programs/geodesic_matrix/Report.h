#ifndef GEODESIC_MATRIX_REPORT_H
#define GEODESIC_MATRIX_REPORT_H

#include "../command_line/Table.h"
#include "Options.h"
#include "Processes.h"
#include "matrix.h"
#include "peak_memory.h"
#include "texts.h"
#include "vertex_files.h"

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <string>

// The bytes of a file, or of all files in a folder.
inline double length_on_disk(const std::filesystem::path& name)
{
  if(!std::filesystem::is_directory(name))
    return double(std::filesystem::file_size(name));
  double result = 0;
  for(const auto& entry : std::filesystem::directory_iterator(name))
    result += double(entry.file_size());
  return result;
}

// What has been measured, and is printed at the end.
struct Report
{
  double seconds_to_read = 0;
  double seconds_to_choose = 0;
  double seconds_to_build = 0;
  double seconds_to_compute = 0;
  double rows_computed = 0; // by this run, all processes together
  std::size_t threads = 1;

  void print(const Options& options, const Matrix_vertices& vertices, const Processes& processes)
  {
    const double distances = rows_computed * double(vertices.targets.size());
    const double memory = processes.maximum(peak_memory());
    Table table;
    table.add("rows", vertices.sources.size());
    table.add("  of them computed by this run", rows_computed);
    table.add("columns", vertices.targets.size());
    table.add("seconds to read the mesh", seconds_to_read);
    table.add("seconds to choose vertices", seconds_to_choose);
    table.add("seconds to build the graph", seconds_to_build);
    table.add("seconds to compute and write", seconds_to_compute);
    if(options.is_sparse())
      table.add("microseconds a row", 1e6 * seconds_to_compute / rows_computed);
    else
      table.add("microseconds a distance", 1e6 * seconds_to_compute / distances);
    table.add("threads of a process", threads);
    table.add("processes", processes.size());
    table.add("peak memory of a process", text_of_bytes(memory));
    table.add("file", options.output);
    table.add("vertices of its rows", file_of_rows(options));
    table.add("vertices of its columns", vertices.sources == vertices.targets
                                             ? file_of_rows(options)
                                             : file_of_columns(options));
    table.add("length of the file", text_of_bytes(length_on_disk(options.output)));
    table.print(std::cout);
  }
};

#endif // GEODESIC_MATRIX_REPORT_H
