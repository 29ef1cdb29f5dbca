// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_PLY_HEADER_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_PLY_HEADER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <ios>
#include <istream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The header of a PLY file.
 */
struct Ply_header
{
  struct Property
  {
    std::string type, name;
    std::size_t bytes;         // of a number
    std::size_t bytes_of_size; // of the size of a list, or 0 for a single number
    std::string type_of_number, type_of_size;
  };

  struct Element
  {
    std::string name;
    std::size_t number;
    std::vector<Property> properties;
  };

  explicit Ply_header(std::istream& in)
  {
    bool is_first = true;
    std::string text;
    for(std::string first; first != "end_header" && std::getline(in, text); is_first = false)
    {
      std::istringstream words(text);
      std::string second, type, name;
      words >> first >> second;
      if(first == "format")
        format = second;
      if(first == "element" && words >> type)
        add_element(second, type);
      if(first == "property" && second == "list" && words >> second >> type >> name)
        add_property({"list", name, bytes_of(type), bytes_of(second), type, second});
      else if(first == "property" && words >> name)
        add_property({second, name, bytes_of(second), 0, second, ""});
      lists_corners = lists_corners || name == "vertex_indices" || name == "vertex_index";
      begins = begins || (is_first && first == "ply");
      ends = first == "end_header";
    }
  }

  // Returns what CGAL's reader would take for something else, or crash at; or an empty string.
  std::string error() const
  {
    if(!m_error.empty())
      return m_error;
    if(format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      return "its format is \"" + format +
             "\"; it must be ascii, binary_little_endian or binary_big_endian";
    for(const Element& element : elements)
      if(element.name == "vertex" && !error_in_coordinates(element).empty())
        return error_in_coordinates(element);
    return "";
  }

  // Lists whose sizes have fewer bytes are short.
  bool may_have_long_lists() const
  {
    for(const Element& element : elements)
      for(const Property& property : element.properties)
        if(property.bytes_of_size > 2)
          return true;
    return false;
  }

  // Reads the size of a list. The stream fails if there is none.
  std::size_t read_size(std::istream& in, const std::size_t bytes) const
  {
    std::size_t result = 0;
    if(format == "ascii")
      in >> result;
    else
      for(std::size_t i = 0; i < bytes; ++i)
      {
        const std::size_t byte = static_cast<unsigned char>(in.get());
        result = format == "binary_big_endian" ? result << 8 | byte : result | byte << 8 * i;
      }
    return result;
  }

  void skip(std::istream& in, const std::size_t size, const std::size_t bytes) const
  {
    std::string word;
    if(format == "ascii")
      for(std::size_t i = 0; i < size && in; ++i)
        in >> word;
    else
      in.ignore(static_cast<std::streamsize>(size * bytes));
  }

  bool begins = false;
  bool ends = false;
  bool lists_corners = false;
  std::string format;
  std::vector<Element> elements;
  std::map<std::string, std::size_t> number_of; // by element

private:
  // Elements may have their name in the plural.
  void add_element(const std::string& name, const std::string& number)
  {
    const std::string singular = name == "vertices" ? "vertex" : name == "faces" ? "face" : name;
    if(number.size() > 18 || number.find_first_not_of("0123456789") != number.npos)
      m_error = "element " + name + " has the number " + number;
    else
      number_of[singular] = std::stoull(number);
    elements.push_back({singular, number_of[singular], {}});
  }

  static std::string error_in_coordinates(const Element& vertex)
  {
    const std::set<std::string> types{"float", "float32", "double", "float64"};
    for(const char* const coordinate : {"x", "y", "z"})
    {
      std::size_t number = 0;
      for(const Property& property : vertex.properties)
        if(property.name == coordinate && types.count(property.type) == 0)
          return "its vertices have coordinates of type " + property.type +
                 "; they must be float or double";
        else if(property.name == coordinate)
          ++number;
      if(number != 1)
        return "its vertices have " + std::to_string(number) + " properties " + coordinate +
               "; they must have one";
    }
    return "";
  }

  static std::size_t bytes_of(const std::string& type)
  {
    for(const char* const name : {"char", "uchar", "int8", "uint8"})
      if(type == name)
        return 1;
    for(const char* const name : {"short", "ushort", "int16", "uint16"})
      if(type == name)
        return 2;
    return type == "double" || type == "float64" ? 8 : 4;
  }

  void add_property(const Property& property)
  {
    if(elements.empty())
      m_error = "property " + property.name + " comes before the first element";
    else
      elements.back().properties.push_back(property);
  }

  std::string m_error; // in a line
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_PLY_HEADER_H
