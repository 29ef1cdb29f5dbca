#ifndef GEODESIC_MATRIX_VERTEX_FILES_H
#define GEODESIC_MATRIX_VERTEX_FILES_H

#include "../command_line/New_files.h"
#include "Options.h"
#include "matrix.h"

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>

// Which vertices the rows and columns are: one-dimensional arrays for NumPy, beside a dense matrix,
// and in the folder of a sparse one.

inline std::string file_beside(const Options& options, const std::string& name)
{
  const std::filesystem::path output = options.output;
  if(options.is_sparse())
    return (output / (name + ".npy")).string();
  return std::filesystem::path(output).replace_extension('.' + name + ".npy").string();
}

inline std::string file_of_rows(const Options& options) { return file_beside(options, "vertices"); }

// The columns have no file if they are the rows.
inline std::string file_of_columns(const Options& options)
{
  return file_beside(options, "columns");
}

inline void write_npy(std::ostream& out, const Vertex_choice::Indices& numbers)
{
  constexpr std::size_t size_of_start = 10, alignment = 64;
  std::string header = "{'descr': '<i8', 'fortran_order': False, 'shape': (" +
                       std::to_string(numbers.size()) + ",), }";
  header.append(alignment - (size_of_start + header.size() + 1) % alignment, ' ');
  header += '\n';
  out << std::string("\x93NUMPY\x01\x00", 8) << static_cast<char>(header.size()) << '\0' << header;
  for(const std::uint64_t number : numbers)
  {
    const std::uint64_t bytes = boost::endian::native_to_little(number);
    out.write(reinterpret_cast<const char*>(&bytes), sizeof(bytes));
  }
}

// Writes them when the matrix is complete: before, they could be those of another run.
inline void write_vertex_files(const Options& options, const Matrix_vertices& vertices)
{
  New_files files(false);
  const auto write = [&](const std::string& name, const Vertex_choice::Indices& numbers) {
    files.write(name, [&](std::ostream& out) { write_npy(out, numbers); });
  };
  write(file_of_rows(options), vertices.sources);
  if(vertices.sources != vertices.targets)
    write(file_of_columns(options), vertices.targets);
  files.put_in_place();
}

#endif // GEODESIC_MATRIX_VERTEX_FILES_H
