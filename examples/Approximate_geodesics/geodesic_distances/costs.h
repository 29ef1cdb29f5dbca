#ifndef GEODESIC_DISTANCES_COSTS_H
#define GEODESIC_DISTANCES_COSTS_H

#include "../command_line/lines_of_file.h"
#include "../command_line/read_mesh.h"
#include "../command_line/vertex_numbers.h"
#include "Options.h"

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// What paths cost, and what they may not cross.

inline const std::string prefix_of_property = "property:";

inline bool names_property(const std::string& weights)
{
  return weights.rfind(prefix_of_property, 0) == 0;
}

// Refuses what is not a weight; the library would too, when the mesh is read.
inline double to_weight(const std::string& text)
{
  char* end = nullptr;
  const double result = std::strtod(text.c_str(), &end);
  const bool is_too_large = std::isinf(result) && text.find_first_of("0123456789") != text.npos;
  if(*end != '\0' || !(result >= 0) || is_too_large)
    throw std::invalid_argument("\"" + text +
                                "\" is not a weight: a number that is not negative, or inf");
  return result;
}

inline std::vector<double> weights_of_file(const std::string& file)
{
  std::vector<double> result;
  for_each_line("--weights", file, [&](const std::vector<std::string>& words) {
    for(const std::string& word : words)
      result.push_back(to_weight(word));
  });
  return result;
}

template <typename Number>
std::optional<std::vector<double>> weights_of_property(Mesh& mesh, const std::string& name)
{
  // returns one that exists; what `property_map()` returns differs between CGAL 5 and 6
  const auto [property, is_new] = mesh.add_property_map<Mesh::Face_index, Number>(name);
  if(is_new)
    return std::nullopt;
  std::vector<double> result;
  for(const auto f : mesh.faces())
    result.push_back(static_cast<double>(property[f]));
  return result;
}

// Of a PLY file; it is read again, as a mesh in itself.
inline std::vector<double> weights_of_mesh_file(const std::string& file, const std::string& name)
{
  Mesh mesh;
  std::string comments;
  std::ifstream in = open_to_read(file, std::ios::binary);
  if(in.get() != 'p' || in.unget().fail() || !CGAL::IO::read_PLY(in, mesh, comments))
    throw std::invalid_argument("--weights property:" + name + ": " + file +
                                " is not a PLY file of a mesh that needs no repair");
  const std::string full_name = "f:" + name;
  for(const auto& result :
      {weights_of_property<double>(mesh, full_name), weights_of_property<float>(mesh, full_name),
       weights_of_property<std::uint8_t>(mesh, full_name),
       weights_of_property<std::int8_t>(mesh, full_name),
       weights_of_property<std::uint16_t>(mesh, full_name),
       weights_of_property<std::int16_t>(mesh, full_name),
       weights_of_property<std::uint32_t>(mesh, full_name),
       weights_of_property<std::int32_t>(mesh, full_name)})
    if(result)
      return *result;
  throw std::invalid_argument("--weights property:" + name + ": the faces of " + file +
                              " have no such property");
}

// by face; all are 1 if nothing else is said
inline std::vector<double> read_weights(const Options& options, const Mesh& mesh)
{
  if(options.weights.empty())
    return std::vector<double>(mesh.number_of_faces(), 1);
  std::vector<double> result =
      names_property(options.weights)
          ? weights_of_mesh_file(options.input, options.weights.substr(prefix_of_property.size()))
          : weights_of_file(options.weights);
  if(result.size() != mesh.number_of_faces())
    throw std::invalid_argument("--weights " + options.weights + ": there are " +
                                std::to_string(result.size()) + " weights, and the mesh has " +
                                std::to_string(mesh.number_of_faces()) + " faces");
  return result;
}

// by edge
inline std::vector<bool> read_barriers(const Options& options, const Mesh& mesh)
{
  std::vector<bool> result(mesh.number_of_edges(), false);
  if(options.barriers.empty())
    return result;
  for_each_line("--barriers", options.barriers, [&](const std::vector<std::string>& words) {
    if(words.size() != 2)
      throw std::invalid_argument("the indices of two vertices are needed");
    std::vector<Mesh::Vertex_index> ends;
    for(const std::string& word : words)
    {
      const std::size_t index = to_vertex_index(word);
      check_vertex_index(index, mesh.number_of_vertices());
      ends.emplace_back(static_cast<Mesh::size_type>(index));
    }
    const auto h = mesh.halfedge(ends[0], ends[1]);
    if(h == Mesh::null_halfedge())
      throw std::invalid_argument("there is no edge between the vertices " + words[0] + " and " +
                                  words[1]);
    result[mesh.edge(h)] = true;
  });
  return result;
}

#endif // GEODESIC_DISTANCES_COSTS_H
