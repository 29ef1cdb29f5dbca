#ifndef COMMAND_LINE_VERTICES_OF_FILE_H
#define COMMAND_LINE_VERTICES_OF_FILE_H

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// The numbers that vertices have in a file, whatever was done to make a mesh of it.
//
// The mesh has all vertices of the file first, under the same numbers. Those in the same place are
// one: faces use the first of them, and the others are isolated. Behind them are copies of vertices
// at which the surface was cut.
class Vertices_of_file
{
public:
  // A file whose vertices are those of the mesh.
  explicit Vertices_of_file(const std::size_t number = 0) : m_number(number) {}

  // `first_there` tells for each vertex which is the first one in the same place.
  explicit Vertices_of_file(std::vector<std::size_t> first_there)
    : m_number(first_there.size()), m_first_there(std::move(first_there))
  {
  }

  // Notes that the mesh has another copy of a vertex, behind all others.
  void add_copy(const std::size_t vertex)
  {
    m_copies[vertex].push_back(m_number + m_originals.size());
    m_originals.push_back(vertex);
  }

  // The number of vertices in the file, and in the mesh.
  std::size_t number() const { return m_number; }
  std::size_t number_in_mesh() const { return m_number + m_originals.size(); }

  // The vertex of the mesh that has the faces of a vertex of the file, or some of them.
  std::size_t vertex(const std::size_t number) const
  {
    return m_first_there.empty() ? number : m_first_there[number];
  }

  // All of these.
  std::vector<std::size_t> vertices(const std::size_t number) const
  {
    std::vector<std::size_t> result{vertex(number)};
    const auto copies = m_copies.find(result.front());
    if(copies != m_copies.end())
      result.insert(result.end(), copies->second.begin(), copies->second.end());
    return result;
  }

  // The number in the file of a vertex of the mesh.
  std::size_t number_of(const std::size_t vertex) const
  {
    return vertex < m_number ? vertex : m_originals[vertex - m_number];
  }

  bool are_those_of_mesh() const { return m_first_there.empty() && m_originals.empty(); }

  // Whether the surface was cut at a vertex.
  bool is_cut(const std::size_t number) const { return m_copies.count(vertex(number)) > 0; }

private:
  std::size_t m_number;
  std::vector<std::size_t> m_first_there; // none if places differ
  std::vector<std::size_t> m_originals;   // of the copies
  std::map<std::size_t, std::vector<std::size_t>> m_copies;
};

#endif // COMMAND_LINE_VERTICES_OF_FILE_H
