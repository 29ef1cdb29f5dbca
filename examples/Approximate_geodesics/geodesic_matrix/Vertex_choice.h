#ifndef GEODESIC_MATRIX_VERTEX_CHOICE_H
#define GEODESIC_MATRIX_VERTEX_CHOICE_H

#include "../command_line/read_mesh.h"
#include "../command_line/vertex_numbers.h"

#include <CGAL/Approximate_geodesics/Queries/farthest_point_sampling.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Which vertices the rows or the columns belong to: `all`, `random:K`, `farthest:K`, or those that
// a file lists. The same text chooses the same vertices.
class Vertex_choice
{
public:
  using Indices = std::vector<std::uint64_t>;

  // `option` is named in errors.
  Vertex_choice(std::string option, std::string text)
    : m_option(std::move(option)), m_text(std::move(text))
  {
    name_in_errors(m_option + ' ' + m_text, [&] {
      m_random = number_after("random", m_text);
      m_farthest = number_after("farthest", m_text);
      if(!is_all() && !m_random && !m_farthest)
        read_file();
    });
  }

  bool is_all() const { return m_text == "all"; }

  // Farthest points are those along edges if no bound is given.
  Indices
  choose(const Mesh& mesh, const std::uint64_t seed, const std::optional<double> epsilon) const
  {
    const std::size_t size = mesh.number_of_vertices();
    return name_in_errors(m_option + ' ' + m_text, [&] {
      check_number_of_vertices(m_farthest.value_or(0), size);
      if(m_random)
      {
        std::mt19937_64 random(seed);
        return random_vertices(size, *m_random, random);
      }
      if(m_farthest)
        return farthest_vertices(mesh, *m_farthest, epsilon);
      return is_all() ? all_vertices(size) : checked_vertices(size);
    });
  }

private:
  // An index per line; the rest of a line after # is a comment.
  void read_file()
  {
    std::ifstream in(m_text);
    if(!in)
      throw std::invalid_argument(
          "it is neither all, random:K nor farthest:K, nor a file that can be read");
    std::size_t number = 1;
    for(std::string text; std::getline(in, text); ++number)
    {
      std::istringstream words(text.substr(0, text.find('#')));
      for(std::string word; words >> word;)
      {
        m_listed.push_back(name_in_errors(name_of_line(number), [&] { return to_number(word); }));
        m_lines.push_back(number);
      }
    }
    if(m_listed.empty())
      throw std::invalid_argument("the file lists no vertex");
  }

  static Indices all_vertices(const std::size_t size)
  {
    Indices result(size);
    std::iota(result.begin(), result.end(), std::uint64_t(0));
    return result;
  }

  Indices checked_vertices(const std::size_t size) const
  {
    for(std::size_t i = 0; i < m_listed.size(); ++i)
      name_in_errors(name_of_line(m_lines[i]), [&] { check_vertex_index(m_listed[i], size); });
    return m_listed;
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
  std::string m_text;
  std::optional<std::size_t> m_random;
  std::optional<std::size_t> m_farthest;
  Indices m_listed;                 // in the file
  std::vector<std::size_t> m_lines; // where
};

#endif // GEODESIC_MATRIX_VERTEX_CHOICE_H
