// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_READ_PLY_QUICKLY_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_READ_PLY_QUICKLY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/internal/Buffered_input.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Ply_header.h>
#include <CGAL/Kernel_traits.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Reads the numbers of a PLY file behind its header, one after another.
 */
class Ply_numbers
{
public:
  // Reads a number of one type. Returns whether there is one.
  using Read = bool (*)(Ply_numbers&, double&);

  Ply_numbers(std::istream& in, const std::string& format)
    : m_input(in),
      m_is_text(format == "ascii"),
      m_is_reversed((format == "binary_big_endian") !=
                    (boost::endian::order::native == boost::endian::order::big))
  {
  }

  // Returns null for a type that does not exist.
  static Read reader_of(const std::string& type)
  {
    using Name = std::pair<const char*, Read>;
    for(const auto& [name, read] :
        {Name("char", read<std::int8_t>), Name("int8", read<std::int8_t>),
         Name("uchar", read<std::uint8_t>), Name("uint8", read<std::uint8_t>),
         Name("short", read<std::int16_t>), Name("int16", read<std::int16_t>),
         Name("ushort", read<std::uint16_t>), Name("uint16", read<std::uint16_t>),
         Name("int", read<std::int32_t>), Name("int32", read<std::int32_t>),
         Name("uint", read<std::uint32_t>), Name("uint32", read<std::uint32_t>),
         Name("float", read<float>), Name("float32", read<float>), Name("double", read<double>),
         Name("float64", read<double>)})
      if(type == name)
        return read;
    return nullptr;
  }

private:
  template <typename T>
  static bool read(Ply_numbers& numbers, double& result)
  {
    T number{};
    const bool is_there =
        numbers.m_is_text ? numbers.read_word(number) : numbers.read_bytes(number);
    result = static_cast<double>(number);
    return is_there;
  }

  template <typename T>
  bool read_word(T& number)
  {
    using Number = std::conditional_t<sizeof(T) == 1, int, T>; // characters are none
    Number result{};
    std::string_view word;
    if(!m_input.next_word(word) || !to_number(word, result))
      return false;
    number = static_cast<T>(result);
    return static_cast<Number>(number) == result;
  }

  template <typename T>
  bool read_bytes(T& number)
  {
    const char* const bytes = m_input.next_bytes(sizeof(T));
    if(bytes == nullptr)
      return false;
    std::array<char, sizeof(T)> ordered;
    std::memcpy(ordered.data(), bytes, sizeof(T));
    if(m_is_reversed)
      std::reverse(ordered.begin(), ordered.end());
    std::memcpy(&number, ordered.data(), sizeof(T));
    return true;
  }

  Buffered_input m_input;
  bool m_is_text;
  bool m_is_reversed;
};

// Whether it is no type that the size of a list can have.
inline bool is_of_fractions(const std::string& type)
{
  return type.rfind("float", 0) == 0 || type.rfind("double", 0) == 0;
}

// Calls `take(element, property, numbers)` for each property of each element, in the order of the
// file: lists have any number of numbers, other properties have one. Stops when that returns false,
// or a number is not there. Returns whether all was read.
template <typename F>
bool read_ply_properties(std::istream& in, const Ply_header& header, F take)
{
  if(!header.begins || !header.ends || !header.error().empty())
    return false;
  Ply_numbers input(in, header.format);
  std::vector<double> numbers;
  for(const Ply_header::Element& element : header.elements)
  {
    std::vector<std::tuple<const Ply_header::Property*, Ply_numbers::Read, Ply_numbers::Read>> all;
    for(const Ply_header::Property& property : element.properties)
    {
      all.emplace_back(&property, Ply_numbers::reader_of(property.type_of_number),
                       Ply_numbers::reader_of(property.type_of_size));
      if(!std::get<1>(all.back()) || (property.bytes_of_size > 0 && !std::get<2>(all.back())) ||
         is_of_fractions(property.type_of_size))
        return false;
    }
    for(std::size_t i = 0; i < element.number && !all.empty(); ++i)
      for(const auto& [property, read, read_size] : all)
      {
        double size = 1;
        if(read_size != nullptr && !read_size(input, size))
          return false;
        numbers.clear();
        for(double number = 0; double(numbers.size()) < size; numbers.push_back(number))
          if(!read(input, number))
            return false;
        if(!take(element, *property, numbers))
          return false;
      }
  }
  return true;
}

/*
 * Makes points and faces of properties. What is no number of a vertex becomes too large a one.
 */
template <typename Point, typename Face>
struct Soup_of_ply
{
  std::vector<Point>& points;
  std::vector<Face>& faces;
  std::array<double, 3> point{};
  std::size_t number_of_coordinates = 0, number_of_lists = 0; // of the present element

  bool take_coordinate(const std::string& name, const double value)
  {
    using FT = typename Kernel_traits<Point>::Kernel::FT;
    if(!std::isfinite(value))
      return false;
    point[static_cast<std::size_t>(name[0] - 'x')] = value;
    if(++number_of_coordinates == 3)
    {
      points.emplace_back(FT(point[0]), FT(point[1]), FT(point[2]));
      number_of_coordinates = 0;
    }
    return true;
  }

  bool take_corners(const std::vector<double>& corners)
  {
    using Vertex_number = typename Face::value_type;
    Face face;
    if constexpr(!std::is_same_v<Face, std::vector<Vertex_number>>) // of a fixed size
      if(corners.size() != face.size())
        return false;
    face.resize(corners.size());
    for(std::size_t i = 0; i < corners.size(); ++i)
    {
      if(!(corners[i] >= 0 && corners[i] < double(points.size()) &&
           corners[i] == std::floor(corners[i])))
        return false;
      face[i] = static_cast<Vertex_number>(corners[i]);
    }
    faces.push_back(std::move(face));
    return corners.size() >= 3;
  }
};

/*
 * Reads a PLY file in a fraction of the time of CGAL's reader, with any types of numbers, and any
 * other properties and elements. Returns false if something in it is not as it should be.
 */
template <typename Point, typename Face>
bool read_ply_quickly(std::istream& in,
                      const std::size_t bytes_of_file,
                      std::vector<Point>& points,
                      std::vector<Face>& faces)
{
  Ply_header header(in);
  const std::size_t number_of_vertices = header.number_of["vertex"];
  const std::size_t number_of_faces = header.number_of["face"];
  // no element takes fewer bytes
  if(!header.error().empty() || number_of_vertices > bytes_of_file / 6 ||
     number_of_faces > bytes_of_file / 6)
    return false;
  points.reserve(number_of_vertices);
  faces.reserve(number_of_faces);
  Soup_of_ply<Point, Face> soup{points, faces};
  const bool is_read = read_ply_properties(
      in, header,
      [&](const auto& element, const auto& property, const std::vector<double>& numbers) {
        const std::string& name = property.name;
        const bool is_list = property.bytes_of_size > 0;
        if(element.name == "vertex" && !is_list && (name == "x" || name == "y" || name == "z"))
          return soup.take_coordinate(name, numbers.front());
        if(element.name == "face" && is_list &&
           (name == "vertex_indices" || name == "vertex_index"))
          return soup.take_corners(numbers);
        return true;
      });
  return is_read && points.size() == number_of_vertices && faces.size() == number_of_faces;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_READ_PLY_QUICKLY_H
