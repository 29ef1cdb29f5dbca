#ifndef GEODESIC_MATRIX_VERTEX_CHOICE_H
#define GEODESIC_MATRIX_VERTEX_CHOICE_H

#include "../command_line/listed_vertices.h"
#include "../command_line/read_mesh.h"
#include "../command_line/vertex_numbers.h"

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Which vertices the rows or the columns belong to, by their numbers in the file. Each word names
// some: a vertex index, `all`, `random:K`, `farthest:K`, or `file:NAME`. The same words choose the
// same vertices.
class Vertex_choice
{
public:
  using Indices = std::vector<std::uint64_t>;

  // `option` is named in errors.
  Vertex_choice(std::string option, std::vector<std::string> words)
    : m_option(std::move(option)), m_words(std::move(words))
  {
    for(const std::string& word : m_words)
      m_parts.push_back(name_in_errors(m_option + ' ' + word, [&] { return read(word); }));
  }

  // Farthest points are those along edges if no bound is given.
  Indices choose(const Mesh_of_file& mesh,
                 const std::uint64_t seed,
                 const std::optional<double> epsilon) const
  {
    Indices result;
    for(std::size_t i = 0; i < m_words.size(); ++i)
    {
      const Indices part = name_in_errors(m_option + ' ' + m_words[i],
                                          [&] { return m_parts[i](mesh, seed, epsilon); });
      result.insert(result.end(), part.begin(), part.end());
    }
    return result;
  }

private:
  // Finds vertices of a mesh.
  using Part = std::function<Indices(const Mesh_of_file&, std::uint64_t, std::optional<double>)>;

  static Part read(const std::string& word)
  {
    if(word == "all")
      return [](const Mesh_of_file& mesh, auto...) { return all_vertices(mesh.vertices.number()); };
    if(const auto number = number_after("random", word))
      return [=](const Mesh_of_file& mesh, const std::uint64_t seed, auto) {
        std::mt19937_64 random(seed);
        return random_vertices(vertices_with_faces(mesh), *number, random);
      };
    if(const auto number = number_after("farthest", word))
      return [=](const Mesh_of_file& mesh, auto, const std::optional<double> epsilon) {
        return farthest_vertices(mesh, *number, epsilon);
      };
    const auto file = text_after("file", word);
    const std::vector<Listed_vertex> listed =
        file ? listed_vertices(*file)
             : std::vector<Listed_vertex>{
                   {to_vertex_index(word, ", nor all, random:K, farthest:K or file:NAME"), ""}};
    return [=](const Mesh_of_file& mesh, auto...) {
      const std::vector<std::size_t> indices = checked_indices(listed, mesh.vertices.number());
      return Indices(indices.begin(), indices.end());
    };
  }

  static Indices all_vertices(const std::size_t size)
  {
    Indices result(size);
    std::iota(result.begin(), result.end(), std::uint64_t(0));
    return result;
  }

  // Vertices without faces are infinitely far from all others, and chosen, too; so are copies of
  // vertices. They are left out here, as what is chosen of the others does not depend on them.
  static Indices farthest_vertices(const Mesh_of_file& mesh,
                                   const std::size_t number,
                                   const std::optional<double> epsilon)
  {
    namespace AG = CGAL::Approximate_geodesics;
    const std::size_t number_with_faces = vertices_with_faces(mesh).size();
    check_number_of_vertices(number, number_with_faces);
    const std::size_t number_of_others = mesh.mesh.number_of_vertices() - number_with_faces;
    std::vector<Mesh::Vertex_index> points;
    if(epsilon)
      AG::farthest_point_sampling(mesh.mesh, std::back_inserter(points), number + number_of_others,
                                  CGAL::parameters::epsilon(*epsilon));
    else
      AG::farthest_point_sampling(mesh.mesh, std::back_inserter(points), number + number_of_others);
    Indices result;
    std::vector<bool> is_chosen(mesh.vertices.number(), false);
    for(const Mesh::Vertex_index v : points)
    {
      const std::size_t vertex = mesh.vertices.number_of(v);
      if(result.size() < number && !mesh.mesh.is_isolated(v) && !is_chosen[vertex])
      {
        result.push_back(vertex);
        is_chosen[vertex] = true;
      }
    }
    return result;
  }

  std::string m_option;
  std::vector<std::string> m_words;
  std::vector<Part> m_parts; // by word
};

#endif // GEODESIC_MATRIX_VERTEX_CHOICE_H
