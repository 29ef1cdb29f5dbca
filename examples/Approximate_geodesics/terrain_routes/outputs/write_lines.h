#ifndef TERRAIN_ROUTES_WRITE_LINES_H
#define TERRAIN_ROUTES_WRITE_LINES_H

#include "Answer.h"
#include "rasters/Raster.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

// Lines as GeoJSON, or as text, in the coordinates of the map.

inline Grid_point on_map(const Grid_point& p, const Raster_frame& frame)
{
  return {frame.x + p.x * frame.x_step, frame.y + p.y * frame.y_step};
}

inline void
write_line(std::ostream& out, const std::vector<Grid_point>& line, const Raster_frame& frame)
{
  const char* separator = "[";
  for(const Grid_point& point : line)
  {
    const Grid_point p = on_map(point, frame);
    out << separator << '[' << p.x << ',' << p.y << ']';
    separator = ",";
  }
  out << ']';
}

// Writes `number` features: `write(i)` writes the properties and the geometry of each.
template <typename Write>
void write_features(std::ostream& out,
                    const Raster_frame& frame,
                    const std::size_t number,
                    const Write& write)
{
  out << "{\"type\":\"FeatureCollection\",";
  if(!frame.crs.empty())
    out << "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"" << frame.crs << "\"}},";
  out << "\n\"features\":[";
  for(std::size_t i = 0; i < number; ++i)
  {
    out << (i > 0 ? "," : "") << "\n{\"type\":\"Feature\",\"properties\":{";
    write(i);
    out << '}';
  }
  out << "\n]}\n";
}

inline void write_routes(std::ostream& out, const Answer& answer)
{
  write_features(out, answer.frame(), answer.routes().size(), [&](const std::size_t i) {
    const Route& route = answer.routes()[i];
    out << "\"target\":" << i << ",\"column\":" << route.target.column
        << ",\"row\":" << route.target.row;
    if(route.points.empty())
    {
      out << ",\"cost\":null},\"geometry\":null";
      return;
    }
    out << ",\"cost\":" << route.cost << ",\"length\":" << route.length()
        << "},\"geometry\":{\"type\":\"LineString\",\"coordinates\":";
    std::vector<Grid_point> points = route.points;
    if(points.size() == 1) // lines have two points at least
      points.push_back(points.front());
    write_line(out, points, answer.frame());
    out << '}';
  });
}

inline void write_isochrones(std::ostream& out, const Answer& answer)
{
  const Isochrones& isochrones = answer.isochrones();
  write_features(out, answer.frame(), isochrones.values().size(), [&](const std::size_t i) {
    out << "\"cost\":" << isochrones.values()[i]
        << "},\"geometry\":{\"type\":\"MultiLineString\",\"coordinates\":[";
    const char* separator = "";
    for(const Isochrones::Line& line : isochrones.lines(i))
    {
      out << separator;
      write_line(out, line, answer.frame());
      separator = ",";
    }
    out << "]}";
  });
}

inline void write_route_table(std::ostream& out, const Answer& answer)
{
  const bool has_heights = answer.costs().has_heights();
  out << "target,x,y,length" << (has_heights ? ",height\n" : "\n");
  for(std::size_t i = 0; i < answer.routes().size(); ++i)
  {
    const Route& route = answer.routes()[i];
    for(std::size_t k = 0; k < route.points.size(); ++k)
    {
      const Grid_point p = on_map(route.points[k], answer.frame());
      out << i << ',' << p.x << ',' << p.y << ',' << route.lengths[k];
      if(has_heights)
        out << ',' << route.heights[k];
      out << '\n';
    }
  }
}

#endif // TERRAIN_ROUTES_WRITE_LINES_H
