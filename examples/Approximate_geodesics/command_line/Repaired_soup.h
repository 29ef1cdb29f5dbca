#ifndef COMMAND_LINE_REPAIRED_SOUP_H
#define COMMAND_LINE_REPAIRED_SOUP_H

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// Points and faces of a file, made fit for a mesh; and what had to be done for that.
template <typename Point>
class Repaired_soup
{
public:
  using Polygons = std::vector<std::vector<std::size_t>>;

  Repaired_soup(std::vector<Point> the_points, Polygons the_polygons)
    : points(std::move(the_points)), polygons(std::move(the_polygons))
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    const std::size_t number_of_polygons = polygons.size();
    m_merged = PMP::merge_duplicate_points_in_polygon_soup(points, polygons);
    m_isolated = PMP::remove_isolated_points_in_polygon_soup(points, polygons);
    PMP::repair_polygon_soup(points, polygons);
    m_removed = number_of_polygons - (std::min)(number_of_polygons, polygons.size());
    m_edges_of_many = number_of_edges_of_many();
    const std::size_t number_of_points = points.size();
    PMP::orient_polygon_soup(points, polygons);
    m_duplicated = points.size() - number_of_points;
  }

  bool is_changed() const { return m_merged + m_isolated + m_removed + m_duplicated > 0; }

  // Says what was done, in a line.
  void describe(std::ostream& out) const
  {
    out << "The file had to be repaired:";
    std::string separator = " ";
    const auto add = [&](const std::string& what, const std::size_t number) {
      if(number > 0)
        out << std::exchange(separator, "; ") << what << ": " << number;
    };
    add("points merged with others in the same place", m_merged);
    add("points removed that had no faces", m_isolated);
    add("faces removed that were degenerate or duplicates", m_removed);
    add("edges cut that had more than two faces", m_edges_of_many);
    add("vertices duplicated where faces do not form a surface", m_duplicated);
    if(m_merged + m_isolated > 0)
      out << ". Indices of vertices are not those of the file";
    out << ".\n";
  }

  std::vector<Point> points;
  Polygons polygons;

private:
  std::size_t number_of_edges_of_many() const
  {
    std::map<std::pair<std::size_t, std::size_t>, int> number_of_faces;
    for(const auto& polygon : polygons)
      for(std::size_t i = 0; i < polygon.size(); ++i)
        ++number_of_faces[std::minmax(polygon[i], polygon[(i + 1) % polygon.size()])];
    return static_cast<std::size_t>(
        std::count_if(number_of_faces.begin(), number_of_faces.end(),
                      [](const auto& edge) { return edge.second > 2; }));
  }

  std::size_t m_merged = 0;
  std::size_t m_isolated = 0;
  std::size_t m_removed = 0;
  std::size_t m_edges_of_many = 0;
  std::size_t m_duplicated = 0;
};

#endif // COMMAND_LINE_REPAIRED_SOUP_H
