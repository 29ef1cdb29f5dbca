// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILE_ERROR_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILE_ERROR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/internal/Ply_header.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/endian/conversion.hpp>

#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ios>
#include <istream>
#include <new>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Splits a text into lines of words. It skips blank lines, and comments that begin with #.
 */
class Text_lines
{
public:
  // The stream is referred to, not copied.
  explicit Text_lines(std::istream& in) : m_in(in) {}

  // Reads the next line. Returns whether there is one.
  bool next()
  {
    words.clear();
    for(std::string text; words.empty() && std::getline(m_in, text); ++m_number)
    {
      std::istringstream stream(text.substr(0, text.find('#')));
      for(std::string word; stream >> word;)
        words.push_back(word);
    }
    return !words.empty();
  }

  // The prefix of messages about the current line.
  std::string name() const { return "line " + std::to_string(m_number) + ": "; }

  std::vector<std::string> words;

private:
  std::istream& m_in;
  std::size_t m_number = 0; // counted from 1
};

inline bool is_finite_number(const std::string& word)
{
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return !word.empty() && *end == '\0' && std::isfinite(value);
}

inline std::optional<std::size_t> to_count(const std::string& word)
{
  if(word.empty() || word.size() > 18 || word.find_first_not_of("0123456789") != word.npos)
    return std::nullopt;
  return std::stoull(word);
}

// Whether three numbers begin at a word.
inline bool has_coordinates(const std::vector<std::string>& words, const std::size_t first)
{
  for(std::size_t i = first; i < first + 3; ++i)
    if(i >= words.size() || !is_finite_number(words[i]))
      return false;
  return true;
}

inline std::string text_of_wrong_corner(const std::size_t face,
                                        const std::string& vertex,
                                        const std::size_t number_of_vertices)
{
  return "face " + std::to_string(face) + " has vertex " + vertex +
         "; the vertices are numbered from 0, and there are " + std::to_string(number_of_vertices);
}

// Returns the error in a face line, or an empty string.
inline std::string error_in_off_face(const Text_lines& line,
                                     const std::size_t face,
                                     const std::size_t number_of_vertices)
{
  const std::string name = "face " + std::to_string(face);
  const std::optional<std::size_t> size = to_count(line.words.front());
  if(!size)
    return line.name() + name + " has \"" + line.words.front() +
           "\" instead of its number of vertices";
  for(std::size_t i = 1; i <= *size; ++i)
  {
    if(i >= line.words.size())
      return line.name() + name + " has " + std::to_string(i - 1) + " of its " +
             std::to_string(*size) + " vertices";
    const std::optional<std::size_t> vertex = to_count(line.words[i]);
    if(!vertex || *vertex >= number_of_vertices)
      return line.name() + text_of_wrong_corner(face, line.words[i], number_of_vertices);
  }
  return "";
}

/*
 * The start of an OFF file.
 */
struct Off_header
{
  Off_header(std::istream& in, Text_lines& line)
  {
    if(!line.next() || line.words.front().find("OFF") == std::string::npos)
    {
      error = "it does not begin with OFF";
      return;
    }
    line.words.erase(line.words.begin());
    is_binary = !line.words.empty() && line.words.front() == "BINARY";
    if(is_binary)
    {
      number_of_vertices = read_number(in);
      number_of_faces = read_number(in);
      return;
    }
    if(line.words.empty() && !line.next())
    {
      error = "it ends after OFF";
      return;
    }
    const std::optional<std::size_t> vertices = to_count(line.words.front());
    const std::optional<std::size_t> faces =
        line.words.size() < 2 ? std::nullopt : to_count(line.words[1]);
    if(!vertices || !faces)
      error = line.name() + "the numbers of vertices and faces are expected here";
    number_of_vertices = vertices.value_or(0);
    number_of_faces = faces.value_or(0);
  }

  std::string error;
  bool is_binary = false;
  std::size_t number_of_vertices = 0, number_of_faces = 0;

private:
  static std::size_t read_number(std::istream& in)
  {
    std::uint32_t result = 0;
    in.read(reinterpret_cast<char*>(&result), sizeof(result));
    return boost::endian::big_to_native(result);
  }
};

// Whether an OFF file announces no more elements than it has bytes. CGAL's reader allocates all of
// them at once.
inline bool is_long_enough_for_off(std::istream& in)
{
  Text_lines line(in);
  const Off_header header(in, line);
  in.clear();
  in.seekg(0, std::ios::end);
  return header.number_of_vertices + header.number_of_faces <= static_cast<std::size_t>(in.tellg());
}

// Returns why an OFF file cannot be read, or an empty string if the reason is unknown.
inline std::string error_in_off(std::istream& in)
{
  Text_lines line(in);
  const Off_header header(in, line);
  if(!header.error.empty())
    return header.error;
  if(header.is_binary)
    return "it ends before the last of " + std::to_string(header.number_of_vertices) +
           " vertices and " + std::to_string(header.number_of_faces) + " faces";
  const auto end = [](const std::size_t i, const std::size_t size, const std::string& of) {
    return "it ends after " + std::to_string(i) + " of " + std::to_string(size) + ' ' + of;
  };
  for(std::size_t i = 0; i < header.number_of_vertices; ++i)
    if(!line.next())
      return end(i, header.number_of_vertices, "vertices");
    else if(!has_coordinates(line.words, 0))
      return line.name() + "vertex " + std::to_string(i) +
             " does not have three finite coordinates";
  for(std::size_t i = 0; i < header.number_of_faces; ++i)
  {
    if(!line.next())
      return end(i, header.number_of_faces, "faces");
    const std::string error = error_in_off_face(line, i, header.number_of_vertices);
    if(!error.empty())
      return error;
  }
  return "";
}

// Whether CGAL's reader accepts a keyword.
inline bool can_be_in_obj(const std::string& word)
{
  std::istringstream in("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + word + "\n");
  std::vector<Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  return IO::read_OBJ(in, points, faces);
}

// Returns the error in a face line, or an empty string. Vertex numbers start from 1; negative ones
// count from the end.
inline std::string error_in_obj_face(const Text_lines& line,
                                     const std::size_t face,
                                     const std::size_t number_of_vertices)
{
  const std::string name = "face " + std::to_string(face);
  for(std::size_t i = 1; i < line.words.size(); ++i)
  {
    const std::string vertex = line.words[i].substr(0, line.words[i].find('/'));
    const std::optional<std::size_t> index = to_count(vertex.substr(vertex[0] == '-' ? 1 : 0));
    if(!index || *index == 0 || *index > number_of_vertices)
      return line.name() + name + " has vertex " + vertex +
             "; the vertices are numbered from 1, and there are " +
             std::to_string(number_of_vertices);
  }
  return line.words.size() < 4 ? line.name() + name + " has fewer than three vertices" : "";
}

// Returns why an OBJ file cannot be read, or an empty string if the reason is unknown.
inline std::string error_in_obj(std::istream& in)
{
  std::size_t number_of_vertices = 0, number_of_faces = 0;
  std::set<std::string> known{"v", "f"};
  for(Text_lines line(in); line.next();)
  {
    const std::string& first = line.words.front();
    if(first == "v" && !has_coordinates(line.words, 1))
      return line.name() + "vertex " + std::to_string(number_of_vertices) +
             " does not have three finite coordinates";
    if(known.insert(first).second && !can_be_in_obj(first))
      return line.name() + '"' + first + "\" is an unknown keyword";
    number_of_vertices += first == "v" ? 1 : 0;
  }
  in.clear();
  in.seekg(0);
  for(Text_lines line(in); line.next();)
    if(line.words.front() == "f")
    {
      const std::string error = error_in_obj_face(line, number_of_faces++, number_of_vertices);
      if(!error.empty())
        return error;
    }
  return number_of_faces == 0 ? "it has no faces" : "";
}

// Returns the error in a list that is longer than the file, or an empty string. CGAL's reader
// allocates lists before it reads them.
inline std::string error_in_ply_lists(const Ply_header& header, std::istream& in)
{
  if(!header.may_have_long_lists())
    return "";
  const auto start = in.tellg();
  in.seekg(0, std::ios::end);
  const std::size_t bytes_of_file = static_cast<std::size_t>(in.tellg());
  in.seekg(start);
  for(const Ply_header::Element& element : header.elements)
    for(std::size_t i = 0; i < element.number && in && !element.properties.empty(); ++i)
      for(const Ply_header::Property& property : element.properties)
      {
        std::size_t size = 1;
        if(property.bytes_of_size > 0)
          size = header.read_size(in, property.bytes_of_size);
        if(in && size > bytes_of_file)
          return element.name + ' ' + std::to_string(i) + " has a list of " + std::to_string(size) +
                 " numbers, more than the file has bytes";
        header.skip(in, size, property.bytes);
      }
  return "";
}

// Returns what CGAL's reader takes for something else, or crashes at; or an empty string.
inline std::string fatal_error_in_ply(std::istream& in)
{
  const Ply_header header(in);
  const std::string result = header.error();
  return result.empty() ? error_in_ply_lists(header, in) : result;
}

// Returns why a PLY file cannot be read, or an empty string if the reason is unknown. After a
// failure, CGAL's reader keeps the elements before the error, which locates it.
inline std::string error_in_ply(std::istream& in)
{
  Ply_header header(in);
  if(!header.begins)
    return "it does not begin with ply";
  if(!header.ends)
    return "its header does not end";
  if(!header.lists_corners)
    return "its faces have no list vertex_indices";
  in.clear();
  in.seekg(0);
  const std::string error = fatal_error_in_ply(in);
  if(!error.empty())
    return error;
  in.clear();
  in.seekg(0);
  std::vector<Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  IO::read_PLY(in, points, faces, parameters::verbose(false));
  in.clear();
  const std::string reason =
      in.peek() == std::istream::traits_type::eof() ? "it ends in " : "invalid number in ";
  if(points.size() < header.number_of["vertex"])
    return reason + "vertex " + std::to_string(points.size()) + " of " +
           std::to_string(header.number_of["vertex"]);
  if(faces.size() < header.number_of["face"])
    return reason + "face " + std::to_string(faces.size()) + " of " +
           std::to_string(header.number_of["face"]);
  return "";
}

// Returns why an STL file cannot be read.
inline std::string error_in_stl(std::istream& in)
{
  std::string word;
  if(in >> word && word == "solid")
  {
    std::size_t number_of_faces = 0;
    while(in >> word)
      number_of_faces += word == "endfacet" ? 1 : 0;
    return "face " + std::to_string(number_of_faces) + " or its end is missing or malformed";
  }
  constexpr std::streamoff header = 80, size_of_face = 50;
  std::uint32_t announced = 0;
  in.clear();
  in.seekg(header);
  in.read(reinterpret_cast<char*>(&announced), sizeof(announced));
  const std::streamoff begin = in.tellg();
  in.seekg(0, std::ios::end);
  return "it ends after " + std::to_string((in.tellg() - begin) / size_of_face) + " of " +
         std::to_string(boost::endian::little_to_native(announced)) + " faces";
}

// Calls `f()`. Returns whether the numbers in a damaged file let it come to its end.
template <typename F>
bool fits_memory(F f)
{
  try
  {
    f();
    return true;
  }
  catch(const std::bad_alloc&)
  {
  }
  catch(const std::length_error&)
  {
  }
  return false;
}

inline std::string ending_of(const std::string& file)
{
  const std::size_t dot = file.find_last_of("./");
  std::string result = dot == std::string::npos || file[dot] == '/' ? "" : file.substr(dot + 1);
  for(char& c : result)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Whether CGAL's reader, which checks less, neither crashes nor allocates more elements than a file
// can have.
inline bool is_safe_to_read(std::istream& in, const std::string& ending)
{
  if(ending == "off")
    return is_long_enough_for_off(in);
  return ending != "ply" || fatal_error_in_ply(in).empty();
}

// Returns why CGAL could not read a file. CGAL itself reports no reason.
inline std::string error_in_mesh_file(std::istream& in, const std::string& ending)
{
  std::string result;
  if(ending == "off")
    result = error_in_off(in);
  else if(ending == "obj")
    result = error_in_obj(in);
  else if(ending == "ply")
    result = error_in_ply(in);
  else if(ending == "stl")
    result = error_in_stl(in);
  else if(ending != "ts")
    return "its file name extension must be .off, .obj, .ply, .stl or .ts";
  return result.empty() ? "CGAL cannot read it, for an unknown reason" : result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILE_ERROR_H
