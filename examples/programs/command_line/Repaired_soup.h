#ifndef COMMAND_LINE_REPAIRED_SOUP_H
#define COMMAND_LINE_REPAIRED_SOUP_H

#include "Vertices_of_file.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Points and faces of a file, made fit for a mesh; and what had to be done for that, in the numbers
// of the file.
template <typename Point>
class Repaired_soup
{
public:
  using Polygon = std::vector<std::size_t>;
  using Polygons = std::vector<Polygon>;

  // `first_there` tells which points are in the same place, if any are.
  Repaired_soup(std::vector<Point> the_points,
                Polygons the_polygons,
                const std::vector<std::size_t>& first_there)
    : points(std::move(the_points)),
      vertices(first_there.empty() ? Vertices_of_file(points.size())
                                   : Vertices_of_file(first_there))
  {
    for(std::size_t i = 0; i < first_there.size(); ++i)
      if(first_there[i] != i)
        m_merged.push_back(i);
    for(std::size_t i = 0; i < the_polygons.size(); ++i)
    {
      const std::size_t number_before = polygons.size();
      add_polygon(std::move(the_polygons[i]), i);
      if(polygons.size() == number_before)
        m_removed.push_back(i);
    }
    remove_duplicates();
    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons,
                                                       CGAL::parameters::visitor(Visitor(*this)));
  }

  bool is_changed() const
  {
    return !m_merged.empty() || !m_removed.empty() || !m_turned.empty() || !m_duplicated.empty();
  }

  // Says what was done, in a line.
  void describe(std::ostream& out) const
  {
    out << "The file had to be repaired:";
    std::string separator = " ";
    const auto add = [&](const std::string& what, const auto& all, const auto& name) {
      if(!all.empty())
        out << std::exchange(separator, "; ") << what << ": " << all.size() << ", such as "
            << name(*all.begin());
    };
    const auto vertex = [](const std::size_t i) { return "vertex " + std::to_string(i); };
    add("points merged with others in the same place", m_merged,
        [&](const std::size_t i) { return vertex(i) + " with " + vertex(vertices.vertex(i)); });
    const auto face = [](const std::size_t i) { return "face " + std::to_string(i); };
    add("faces removed that were degenerate or duplicates", m_removed, face);
    add("faces turned around, so that neighbors look to the same side", m_turned, face);
    add("edges cut that had more than two faces", m_edges_of_many, [](const auto& edge) {
      return "that of vertices " + std::to_string(edge.first) + " and " +
             std::to_string(edge.second);
    });
    add("vertices duplicated where faces do not form a surface", m_duplicated, vertex);
    out << ". Vertices and faces keep the numbers that they have in the file, from 0.\n";
  }

  std::vector<Point> points;
  Polygons polygons;
  Vertices_of_file vertices;
  std::vector<std::size_t> faces_of_file; // of the polygons

private:
  // Tells the soup what the orientation does to it.
  struct Visitor : CGAL::Polygon_mesh_processing::Default_orientation_visitor
  {
    explicit Visitor(Repaired_soup& the_soup) : soup(&the_soup) {}

    void non_manifold_edge(const std::size_t a, const std::size_t b, std::size_t /* faces */)
    {
      soup->m_edges_of_many.insert(std::minmax(a, b));
    }

    void polygon_orientation_reversed(const std::size_t i)
    {
      soup->m_turned.push_back(soup->faces_of_file[i]);
    }

    void duplicated_vertex(const std::size_t vertex, std::size_t /* copy */)
    {
      soup->vertices.add_copy(vertex);
      soup->m_duplicated.push_back(vertex);
    }

    Repaired_soup* soup; // visitors are copied
  };

  // Adds the parts of a polygon between vertices that it has twice.
  void add_polygon(Polygon corners, const std::size_t face)
  {
    for(std::size_t& corner : corners)
      corner = vertices.vertex(corner);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    while(corners.size() > 1 && corners.front() == corners.back())
      corners.pop_back();
    for(auto end = corners.begin(); end != corners.end(); ++end)
    {
      const auto begin = std::find(corners.begin(), end, *end);
      if(begin == end)
        continue;
      Polygon rest(corners.begin(), begin);
      rest.insert(rest.end(), end, corners.end());
      add_polygon(Polygon(begin, end), face);
      return add_polygon(std::move(rest), face);
    }
    if(corners.size() < 3)
      return;
    polygons.push_back(std::move(corners));
    faces_of_file.push_back(face);
  }

  // Keeps the first of the polygons that have the same corners, in either direction.
  void remove_duplicates()
  {
    Polygons keys = polygons;
    for(Polygon& key : keys)
    {
      std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
      if(key[1] > key.back())
        std::reverse(std::next(key.begin()), key.end());
    }
    std::vector<std::size_t> order(keys.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](const std::size_t a, const std::size_t b) { return keys[a] < keys[b]; });
    for(std::size_t i = 1; i < order.size(); ++i)
      if(keys[order[i]] == keys[order[i - 1]])
      {
        polygons[order[i]].clear();
        m_removed.push_back(faces_of_file[order[i]]);
      }
    std::size_t size = 0;
    for(std::size_t i = 0; i < polygons.size(); ++i)
      if(!polygons[i].empty())
      {
        faces_of_file[size] = faces_of_file[i];
        std::swap(polygons[size++], polygons[i]);
      }
    polygons.resize(size);
    faces_of_file.resize(size);
  }

  std::vector<std::size_t> m_merged, m_removed, m_turned, m_duplicated;
  std::set<std::pair<std::size_t, std::size_t>> m_edges_of_many;
};

#endif // COMMAND_LINE_REPAIRED_SOUP_H
