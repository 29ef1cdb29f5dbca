#ifndef GEODESIC_DISTANCES_PICTURE_H
#define GEODESIC_DISTANCES_PICTURE_H

#include "results.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Writes mesh, distances, paths and sources into one file in VTK's legacy format.
template <typename Mesh, typename Vertices>
class Scene_writer
{
public:
  Scene_writer(const Mesh& mesh, const Vertices& sources, const Results<Mesh>& results)
    : m_mesh(mesh), m_sources(sources), m_results(results), m_index(mesh.num_vertices())
  {
    for(const auto v : vertices(mesh)) // vertices that were removed have no point in the file
      m_index[v] = m_number_of_points++;
    for(const auto& path : results.paths)
      m_number_of_path_points += path.size();
  }

  void write(const std::string& file) const
  {
    std::ofstream out = open_file(file);
    out << "# vtk DataFile Version 3.0\ngeodesic distances\nASCII\nDATASET POLYDATA\n";
    write_points(out);
    write_cells(out);
    write_distances(out);
    if(!out.flush())
      throw std::runtime_error("cannot write to " + file);
  }

private:
  void write_points(std::ostream& out) const
  {
    out << "POINTS " << m_number_of_points + m_number_of_path_points << " double\n";
    for(const auto v : vertices(m_mesh))
      out << m_mesh.point(v) << '\n';
    for(const auto& path : m_results.paths)
      for(const auto& point : path)
        out << point << '\n';
  }

  void write_cells(std::ostream& out) const
  {
    out << "VERTICES " << m_sources.size() << ' ' << 2 * m_sources.size() << '\n';
    for(const auto source : m_sources)
      out << "1 " << m_index[source] << '\n';

    const std::size_t number_of_paths = m_results.paths.size();
    out << "LINES " << number_of_paths << ' ' << number_of_paths + m_number_of_path_points << '\n';
    std::size_t i = m_number_of_points;
    for(const auto& path : m_results.paths)
    {
      out << path.size();
      for(const std::size_t end = i + path.size(); i < end; ++i)
        out << ' ' << i;
      out << '\n';
    }

    out << "POLYGONS " << m_mesh.number_of_faces() << ' ' << 4 * m_mesh.number_of_faces() << '\n';
    for(const auto f : faces(m_mesh))
    {
      out << 3;
      for(const auto v : vertices_around_face(halfedge(f, m_mesh), m_mesh))
        out << ' ' << m_index[v];
      out << '\n';
    }
  }

  void write_distances(std::ostream& out) const
  {
    out << "POINT_DATA " << m_number_of_points + m_number_of_path_points
        << "\nSCALARS distance double 1\nLOOKUP_TABLE default\n";
    for(const auto v : vertices(m_mesh))
      out << (std::isfinite(m_results.distances[v]) ? m_results.distances[v] : -1) << '\n';
    for(std::size_t i = 0; i < m_number_of_path_points; ++i)
      out << "0\n";
  }

  const Mesh& m_mesh;
  const Vertices& m_sources;
  const Results<Mesh>& m_results;
  std::vector<std::size_t> m_index; // of a vertex's point in the file
  std::size_t m_number_of_points = 0;
  std::size_t m_number_of_path_points = 0;
};

inline std::string quoted_for_shell(const std::string& text)
{
  std::string result = "'";
  for(const char c : text)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

// Draws NAME.vtk into NAME.png with VTK, without a display. The view is the script's arguments.
inline void draw_picture(const std::string& name, const std::string& view)
{
  std::string command = "xvfb-run --auto-servernum /usr/bin/python3 " +
                        quoted_for_shell(DRAW_PICTURE_SCRIPT) + ' ' + quoted_for_shell(name);
  std::istringstream words(view);
  for(std::string word; words >> word;)
    command += ' ' + quoted_for_shell(word);
  if(std::system(command.c_str()) != 0)
    throw std::runtime_error("no picture was drawn: xvfb-run and VTK for Python are needed for it");
}

#endif // GEODESIC_DISTANCES_PICTURE_H
