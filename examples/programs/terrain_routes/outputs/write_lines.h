#ifndef TERRAIN_ROUTES_WRITE_LINES_H
#define TERRAIN_ROUTES_WRITE_LINES_H

#include "../Answer.h"
#include "../rasters/Raster.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// Lines as GeoJSON, or as text, in the coordinates of the map.

using Line = std::vector<Grid_point>;

// Returns the parts of a line that are on the raster: one, unless the raster goes round. Then lines
// are cut where they leave it, and go on at the other end.
inline std::vector<Line> parts_on_raster(const Line& line, const Grid_shape& shape)
{
  if(!shape.is_periodic || line.empty())
    return {line};
  const auto columns = static_cast<double>(shape.columns);
  double first = columns * std::floor(line.front().x / columns); // of the present turn
  std::vector<Line> result(1);
  const auto add = [&](const double x, const double y) { result.back().push_back({x - first, y}); };
  Grid_point last = line.front();
  for(const Grid_point& p : line)
  {
    while(p.x < first || p.x > first + columns)
    {
      const double sign = p.x < first ? -1 : 1, border = sign < 0 ? first : first + columns;
      const double y = last.y + (p.y - last.y) * (border - last.x) / (p.x - last.x);
      add(border, y);
      result.emplace_back();
      first += sign * columns;
      add(border, y);
    }
    add(p.x, p.y);
    last = p;
  }
  return result;
}

inline Grid_point on_map(const Grid_point& p, const Raster_frame& frame)
{
  return {frame.x + p.x * frame.x_step, frame.y + p.y * frame.y_step};
}

inline void write_line(std::ostream& out, const Line& line, const Raster_frame& frame)
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

inline void
write_lines(std::ostream& out, const std::vector<Line>& lines, const Raster_frame& frame)
{
  const char* separator = "[";
  for(const Line& line : lines)
  {
    out << separator;
    write_line(out, line, frame);
    separator = ",";
  }
  out << (lines.empty() ? "[]" : "]");
}

// Writes `number` features: `write(i)` writes the properties and the geometry of each. The box is
// that of the raster.
template <typename Write>
void write_features(std::ostream& out,
                    const Answer& answer,
                    const std::size_t number,
                    const Write& write)
{
  const Raster_frame& frame = answer.frame();
  const Grid_point end =
      on_map({static_cast<double>(frame.columns), static_cast<double>(frame.rows)}, frame);
  out << "{\"type\":\"FeatureCollection\",";
  if(!frame.system.crs.empty())
    out << "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"" << frame.system.crs << "\"}},";
  out << "\n\"bbox\":[" << std::min(frame.x, end.x) << ',' << std::min(frame.y, end.y) << ','
      << std::max(frame.x, end.x) << ',' << std::max(frame.y, end.y) << "],\"units\":{\"cost\":\""
      << answer.costs().unit_of_costs() << "\",\"length\":\"" << answer.costs().unit_of_lengths()
      << "\"},\n\"features\":[";
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
  write_features(out, answer, answer.routes().size(), [&](const std::size_t i) {
    const Route& route = answer.routes()[i];
    out << "\"target\":" << i << ",\"column\":" << route.target.column
        << ",\"row\":" << route.target.row;
    if(route.points.empty())
    {
      out << ",\"cost\":null},\"geometry\":null";
      return;
    }
    Line points = route.points;
    if(points.size() == 1) // lines have two points at least
      points.push_back(points.front());
    const std::vector<Line> parts = parts_on_raster(points, answer.costs().shape());
    out << ",\"cost\":" << route.cost << ",\"length\":" << route.length()
        << "},\"geometry\":{\"type\":\"" << (parts.size() > 1 ? "MultiLineString" : "LineString")
        << "\",\"coordinates\":";
    if(parts.size() > 1)
      write_lines(out, parts, answer.frame());
    else
      write_line(out, parts.front(), answer.frame());
    out << '}';
  });
}

inline void write_isochrones(std::ostream& out, const Answer& answer)
{
  const Isochrones& isochrones = answer.isochrones();
  write_features(out, answer, isochrones.values().size(), [&](const std::size_t i) {
    out << "\"cost\":" << isochrones.values()[i]
        << "},\"geometry\":{\"type\":\"MultiLineString\",\"coordinates\":";
    std::vector<Line> parts;
    for(const Line& line : isochrones.lines(i))
      for(Line& part : parts_on_raster(line, answer.costs().shape()))
        parts.push_back(std::move(part));
    write_lines(out, parts, answer.frame());
    out << '}';
  });
}

inline void write_route_table(std::ostream& out, const Answer& answer)
{
  const bool has_heights = answer.costs().has_heights();
  const auto columns = static_cast<double>(answer.frame().columns);
  const std::string unit = in_parentheses(answer.costs().unit_of_lengths());
  out << "target,x,y,length" << unit << (has_heights ? ",height" + unit : "") << '\n';
  for(std::size_t i = 0; i < answer.routes().size(); ++i)
  {
    const Route& route = answer.routes()[i];
    for(std::size_t k = 0; k < route.points.size(); ++k)
    {
      Grid_point on_raster = route.points[k];
      if(answer.costs().shape().is_periodic) // the next point may be at the other end
        on_raster.x -= columns * std::floor(on_raster.x / columns);
      const Grid_point p = on_map(on_raster, answer.frame());
      out << i << ',' << p.x << ',' << p.y << ',' << route.lengths[k];
      if(has_heights)
        out << ',' << route.heights[k];
      out << '\n';
    }
  }
}

#endif // TERRAIN_ROUTES_WRITE_LINES_H
