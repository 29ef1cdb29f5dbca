#ifndef GEODESIC_MATRIX_VERTEX_CHOICE_H
#define GEODESIC_MATRIX_VERTEX_CHOICE_H

#include "../command_line/listed_vertices.h"
#include "../command_line/read_mesh.h"
#include "../command_line/vertex_numbers.h"

#include <CGAL/Approximate_geodesics/Queries/farthest_point_sampling.h>

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

// Which vertices the rows or the columns belong to. Each word names some: a vertex index, `all`,
// `random:K`, `farthest:K`, or `file:NAME`. The same words choose the same vertices.
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
  Indices
  choose(const Mesh& mesh, const std::uint64_t seed, const std::optional<double> epsilon) const
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
  using Part = std::function<Indices(const Mesh&, std::uint64_t, std::optional<double>)>;

  static Part read(const std::string& word)
  {
    if(word == "all")
      return [](const Mesh& mesh, auto...) { return all_vertices(mesh.number_of_vertices()); };
    if(const auto number = number_after("random", word))
      return [=](const Mesh& mesh, const std::uint64_t seed, auto) {
        std::mt19937_64 random(seed);
        return random_vertices(mesh.number_of_vertices(), *number, random);
      };
    if(const auto number = number_after("farthest", word))
      return [=](const Mesh& mesh, auto, const std::optional<double> epsilon) {
        check_number_of_vertices(*number, mesh.number_of_vertices());
        return farthest_vertices(mesh, *number, epsilon);
      };
    const auto file = text_after("file", word);
    const std::vector<Listed_vertex> listed =
        file ? listed_vertices(*file)
             : std::vector<Listed_vertex>{
                   {to_vertex_index(word, ", nor all, random:K, farthest:K or file:NAME"), ""}};
    return [=](const Mesh& mesh, auto...) {
      const std::vector<std::size_t> indices = checked_indices(listed, mesh.number_of_vertices());
      return Indices(indices.begin(), indices.end());
    };
  }

  static Indices all_vertices(const std::size_t size)
  {
    Indices result(size);
    std::iota(result.begin(), result.end(), std::uint64_t(0));
    return result;
  }

  static Indices
  farthest_vertices(const Mesh& mesh, const std::size_t number, const std::optional<double> epsilon)
  {
    namespace AG = CGAL::Approximate_geodesics;
    std::vector<Mesh::Vertex_index> points;
    if(epsilon)
      AG::farthest_point_sampling(mesh, std::back_inserter(points), number,
                                  CGAL::parameters::epsilon(*epsilon));
    else
      AG::farthest_point_sampling(mesh, std::back_inserter(points), number);
    return Indices(points.begin(), points.end());
  }

  std::string m_option;
  std::vector<std::string> m_words;
  std::vector<Part> m_parts; // by word
};

#endif // GEODESIC_MATRIX_VERTEX_CHOICE_H
