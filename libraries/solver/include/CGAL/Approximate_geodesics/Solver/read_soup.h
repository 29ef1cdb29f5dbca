// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_READ_SOUP_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_READ_SOUP_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/internal/Ply_header.h>
#include <CGAL/Approximate_geodesics/Solver/internal/mesh_file_error.h>
#include <CGAL/Approximate_geodesics/Solver/internal/read_off_quickly.h>
#include <CGAL/Approximate_geodesics/Solver/internal/read_ply_quickly.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ios>
#include <istream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * A triangle of a polygon soup, in 12 bytes. A reader of \cgal that resizes it to a polygon of
 * another number of vertices gets an exception.
 */
struct Soup_triangle : std::array<std::uint32_t, 3>
{
  /// \throws std::invalid_argument if `number` is not `3`.
  static void resize(const std::size_t number)
  {
    if(number != 3)
      throw std::invalid_argument("has " + std::to_string(number) +
                                  " vertices; it must have three");
  }
};

namespace internal {

/*
 * Appends points with coordinates in double precision to points of another type. CGAL's reader of
 * PLY files would read points in single precision from files in single precision only.
 */
template <typename Point>
struct Appender_of_points
{
  using value_type = Simple_cartesian<double>::Point_3;
  using iterator = const value_type*;
  using const_iterator = iterator;

  void push_back(const value_type& p)
  {
    using FT = typename Kernel_traits<Point>::Kernel::FT;
    points.emplace_back(FT(p.x()), FT(p.y()), FT(p.z()));
  }

  std::vector<Point>& points;
};

inline std::size_t bytes_of_file(std::istream& in)
{
  in.clear();
  in.seekg(0, std::ios::end);
  const std::size_t result = static_cast<std::size_t>(in.tellg());
  in.seekg(0);
  return result;
}

// Reserves memory first, so that no array is copied to a larger one.
template <typename Point, typename Face>
bool read_ply_file(const std::string& file,
                   std::istream& in,
                   std::vector<Point>& points,
                   std::vector<Face>& faces)
{
  const std::size_t size = bytes_of_file(in);
  Ply_header header(in);
  points.reserve(points.size() + (std::min)(header.number_of["vertex"], size));
  faces.reserve(faces.size() + (std::min)(header.number_of["face"], size));
  Appender_of_points<Point> appender{points};
  try
  {
    return IO::read_PLY(file, appender, faces, parameters::verbose(false));
  }
  catch(const std::invalid_argument& e) // of the last face
  {
    throw std::invalid_argument("face " + std::to_string(faces.size() - 1) + ' ' + e.what());
  }
}

template <typename Point, typename Face>
bool read_soup_file(const std::string& file,
                    std::istream& in,
                    std::vector<Point>& points,
                    std::vector<Face>& faces)
{
  if(ending_of(file) == "ply")
    return read_ply_file(file, in, points, faces);
  if constexpr(std::is_same_v<Face, Soup_triangle>)
    return false;
  else
    return IO::read_polygon_soup(file, points, faces, parameters::verbose(false));
}

// Returns an empty string if all vertices of faces exist.
template <typename Face>
std::string error_in_corners(const std::vector<Face>& faces, const std::size_t number_of_vertices)
{
  using Signed = std::make_signed_t<typename Face::value_type>; // files may have negative numbers
  for(std::size_t f = 0; f < faces.size(); ++f)
    for(const auto v : faces[f])
      if(v >= number_of_vertices)
        return text_of_wrong_corner(f, std::to_string(static_cast<Signed>(v)), number_of_vertices);
  return "";
}

inline std::string reason_of_failure(std::istream& in, const std::string& ending)
{
  std::string result = "a number in it exceeds the memory";
  in.clear();
  in.seekg(0);
  fits_memory([&] { result = error_in_mesh_file(in, ending); });
  return result;
}

// Reads a file in a usual form, which takes CGAL several times as long. Returns false, and leaves
// nothing, if it is in another one, or damaged: CGAL's reader, or the search for the reason,
// decides about these.
template <typename Point, typename Face>
bool read_soup_quickly(std::istream& in,
                       const std::string& ending,
                       std::vector<Point>& points,
                       std::vector<Face>& faces)
{
  if(!points.empty() || !faces.empty())
    return false;
  const std::size_t size = bytes_of_file(in);
  if(ending == "off" && read_off_quickly(in, size, points, faces) &&
     error_in_corners(faces, points.size()).empty())
    return true;
  if(ending == "ply" && read_ply_quickly(in, size, points, faces))
    return true;
  points.clear();
  faces.clear();
  in.clear();
  in.seekg(0);
  return false;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * reads a polygon soup in the format of the file name extension: OFF, OBJ, PLY, STL or GOCAD (ts).
 * It wraps `CGAL::IO::read_polygon_soup()`, and adds the reason of a failure. OFF files without
 * colors, and PLY files, are read in a fraction of its time.
 *
 * \tparam Point a `%Point_3`; coordinates in a PLY file are `float` or `double`, and are rounded to
 *         those of points
 * \tparam Face `std::vector<std::size_t>`; or `Soup_triangle`, for PLY files with many triangles,
 *         which then take no more memory than the arrays
 *
 * \throws std::invalid_argument if reading fails, or a face has a vertex that does not exist, or
 *         does not fit `Face`. The message names the line, the vertex or the face, if it is known,
 *         or says why the file cannot be opened.
 */
template <typename Point, typename Face>
void read_soup(const std::string& file, std::vector<Point>& points, std::vector<Face>& faces)
{
  const auto fail = [&](const std::string& reason) {
    throw std::invalid_argument("cannot read a mesh from " + file + ": " + reason);
  };
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  const bool is_at_end = in.peek() == std::ifstream::traits_type::eof();
  if(in.fail())
    fail(errno != 0 ? std::generic_category().message(errno) : "it cannot be opened");
  if(is_at_end)
    fail("it is empty");
  bool is_read = false;
  const std::string ending = internal::ending_of(file);
  if(std::is_same_v<Face, Soup_triangle> && ending != "ply")
    fail("triangles of 12 bytes are read from PLY files only");
  try
  {
    internal::fits_memory([&] {
      is_read = internal::read_soup_quickly(in, ending, points, faces) ||
                (internal::is_safe_to_read(in, ending) &&
                 internal::read_soup_file(file, in, points, faces));
    });
  }
  catch(const std::invalid_argument& e)
  {
    fail(e.what());
  }
  if(!is_read)
    fail(internal::reason_of_failure(in, ending));
  const std::string error = internal::error_in_corners(faces, points.size());
  if(!error.empty())
    fail(error);
}

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * reads a property of the faces of a PLY file, which may have any name, `red` among them, and any
 * type of number.
 *
 * \return the numbers, in the order of the faces
 *
 * \throws std::invalid_argument if the file is no PLY file, ends too early, or its faces have no
 * such property that is a single number.
 */
inline std::vector<double> read_face_property(const std::string& file, const std::string& name)
{
  std::ifstream in(file, std::ios::binary);
  const internal::Ply_header header(in);
  std::vector<double> result;
  bool has_property = false;
  for(const internal::Ply_header::Element& element : header.elements)
    for(const internal::Ply_header::Property& property : element.properties)
      has_property = has_property || (element.name == "face" && property.name == name &&
                                      property.bytes_of_size == 0);
  if(!header.begins || !header.ends)
    throw std::invalid_argument(file + " is not a PLY file");
  if(!has_property)
    throw std::invalid_argument("the faces of " + file + " have no property " + name +
                                " that is a number");
  const bool is_read = internal::read_ply_properties(
      in, header,
      [&](const auto& element, const auto& property, const std::vector<double>& numbers) {
        if(element.name == "face" && property.name == name && property.bytes_of_size == 0)
          result.push_back(numbers.front());
        return true;
      });
  if(!is_read)
    throw std::invalid_argument(file + " ends, or has no number, behind property " + name +
                                " of face " + std::to_string(result.size()));
  return result;
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_READ_SOUP_H
