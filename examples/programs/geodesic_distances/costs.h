#ifndef GEODESIC_DISTANCES_COSTS_H
#define GEODESIC_DISTANCES_COSTS_H

#include "../command_line/lines_of_file.h"
#include "../command_line/read_mesh.h"
#include "../command_line/vertex_numbers.h"
#include "Options.h"

#include <CGAL/Approximate_geodesics/Solver/read_soup.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
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

inline std::vector<double> weights_of_option(const Options& options)
{
  if(!names_property(options.weights))
    return weights_of_file(options.weights);
  return name_in_errors("--weights " + options.weights, [&] {
    return CGAL::Approximate_geodesics::read_face_property(
        options.input, options.weights.substr(prefix_of_property.size()));
  });
}

// by face of the mesh; all are 1 if nothing else is said
inline std::vector<double> read_weights(const Options& options, const Mesh_of_file& mesh)
{
  std::vector<double> result(mesh.mesh.number_of_faces(), 1);
  if(options.weights.empty())
    return result;
  const std::vector<double> weights = weights_of_option(options);
  if(weights.size() != mesh.number_of_faces)
    throw std::invalid_argument("--weights " + options.weights + ": there are " +
                                std::to_string(weights.size()) + " weights, and the mesh has " +
                                std::to_string(mesh.number_of_faces) + " faces");
  for(const auto f : mesh.mesh.faces())
    result[f] = weights[mesh.face_of_file(f)];
  return result;
}

// Marks the edges between two vertices of the file: there are two where the surface was cut.
// Returns whether there are any.
inline bool mark_edges(const Mesh_of_file& mesh,
                       const std::array<std::size_t, 2>& ends,
                       std::vector<bool>& marks)
{
  bool result = false;
  const auto vertex = [](const std::size_t v) { return Mesh::Vertex_index(Mesh::size_type(v)); };
  for(const std::size_t a : mesh.vertices.vertices(ends[0]))
    for(const std::size_t b : mesh.vertices.vertices(ends[1]))
    {
      const auto h = mesh.mesh.halfedge(vertex(a), vertex(b));
      if(h != Mesh::null_halfedge())
        result = marks[mesh.mesh.edge(h)] = true;
    }
  return result;
}

// by edge
inline std::vector<bool> read_barriers(const Options& options, const Mesh_of_file& mesh)
{
  std::vector<bool> result(mesh.mesh.number_of_edges(), false);
  if(options.barriers.empty())
    return result;
  for_each_line("--barriers", options.barriers, [&](const std::vector<std::string>& words) {
    std::array<std::size_t, 2> ends{};
    if(words.size() != ends.size())
      throw std::invalid_argument("the indices of two vertices are needed");
    for(std::size_t i = 0; i < ends.size(); ++i)
    {
      ends[i] = to_vertex_index(words[i]);
      check_vertex_index(ends[i], mesh.vertices.number());
    }
    if(!mark_edges(mesh, ends, result))
      throw std::invalid_argument("there is no edge between the vertices " + words[0] + " and " +
                                  words[1]);
  });
  return result;
}

#endif // GEODESIC_DISTANCES_COSTS_H
