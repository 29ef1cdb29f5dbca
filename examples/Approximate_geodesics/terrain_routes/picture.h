#ifndef TERRAIN_ROUTES_PICTURE_H
#define TERRAIN_ROUTES_PICTURE_H

#include "../command_line/New_files.h"
#include "../command_line/quoted_for_shell.h"
#include "../command_line/read_options.h"
#include "Answer.h"
#include "write_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Pictures, which gnuplot draws from files that go afterwards.

// Refuses to draw without what is needed for it.
inline void check_drawing_programs()
{
  if(std::system("command -v gnuplot >/dev/null") != 0)
    reject_option("picture", "the program gnuplot is needed (Debian: gnuplot-nox)");
}

// The part of a raster that is drawn, as many cells as a picture has pixels. Columns and rows are
// those of cells, in the order of growing coordinates.
struct Background
{
  explicit Background(const Raster_frame& frame)
  {
    constexpr std::size_t most = 1200;
    const std::size_t step = (std::max(frame.columns, frame.rows) + most - 1) / most;
    for(std::size_t i = step / 2; i < frame.columns; i += step)
      columns.push_back(i);
    for(std::size_t i = step / 2; i < frame.rows; i += step)
      rows.push_back(i);
    if(frame.x_step < 0)
      std::reverse(columns.begin(), columns.end());
    if(frame.y_step < 0)
      std::reverse(rows.begin(), rows.end());
  }

  std::vector<std::size_t> columns, rows;
};

// Returns the logarithms of the costs of cells, row by row.
inline std::vector<double> tones(const Answer& answer, const Background& background)
{
  std::vector<double> result, values(answer.frame().columns);
  for(const std::size_t row : background.rows)
  {
    answer.costs().for_each_cost(
        row, [&](const std::size_t column, const double cost) { values[column] = std::log(cost); });
    for(const std::size_t column : background.columns)
      result.push_back(values[column]);
  }
  return result;
}

// Colors, in three bytes: from light for the cheapest to dark; cells that cannot be entered are
// brown.
inline void write_background(std::ostream& out, const Answer& answer)
{
  const std::vector<double> tones = ::tones(answer, Background(answer.frame()));
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for(const double tone : tones)
    if(std::isfinite(tone))
    {
      least = std::min(least, tone);
      most = std::max(most, tone);
    }
  for(const double tone : tones)
  {
    constexpr double lightest = 240, range = 150;
    const double share = most > least ? (std::max(tone, least) - least) / (most - least) : 0;
    const char gray = static_cast<char>(static_cast<int>(lightest - range * std::min(share, 1.)));
    const bool is_open = tone < std::numeric_limits<double>::infinity();
    out << (is_open ? gray : '\x5a') << (is_open ? gray : '\x46') << (is_open ? gray : '\x32');
  }
}

inline void write_isochrones_for_gnuplot(std::ostream& out, const Answer& answer)
{
  const Isochrones& isochrones = answer.isochrones();
  for(std::size_t i = 0; i < isochrones.values().size(); ++i)
    for(const Isochrones::Line& line : isochrones.lines(i))
    {
      for(const Grid_point& point : line)
      {
        const Grid_point p = on_map(point, answer.frame());
        out << p.x << ' ' << p.y << ' ' << isochrones.values()[i] << '\n';
      }
      out << '\n';
    }
}

inline void write_routes_for_gnuplot(std::ostream& out, const Answer& answer)
{
  out << "# x y\n";
  for(const Route& route : answer.routes())
  {
    for(const Grid_point& point : route.points)
    {
      const Grid_point p = on_map(point, answer.frame());
      out << p.x << ' ' << p.y << '\n';
    }
    out << '\n';
  }
}

// A text in a script of gnuplot.
inline std::string quoted_for_gnuplot(const std::string& text)
{
  std::string result = "'";
  for(const char c : text)
    result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

// What the script has to know of the map.
inline std::string variables_of_map(const Answer& answer)
{
  const Raster_frame& frame = answer.frame();
  const Grid_shape& shape = answer.costs().shape();
  const auto columns = static_cast<double>(frame.columns), rows = static_cast<double>(frame.rows);
  const Grid_point end = on_map({columns, rows}, frame);
  const Background background(frame);
  std::ostringstream out;
  out.precision(17);
  out << "largest=" << answer.largest_cost() << "; x_min=" << std::min(frame.x, end.x)
      << "; x_max=" << std::max(frame.x, end.x) << "; y_min=" << std::min(frame.y, end.y)
      << "; y_max=" << std::max(frame.y, end.y) << "; downward=" << (frame.y_step > 0)
      << "; columns=" << background.columns.size() << "; rows=" << background.rows.size()
      << "; ratio=" << rows * shape.cell_height / (columns * shape.cell_width) << "; ";
  return out.str();
}

inline void draw_picture(const std::string& name, const std::string& place, const Answer& answer)
{
  New_files parts(true); // never put in place
  std::string variables = variables_of_map(answer) + "picture=" + quoted_for_gnuplot(place) + "; ";
  const auto add = [&](const char* const variable, const auto write) {
    const std::string file =
        parts.write(name + '.' + variable, [&](std::ostream& out) { write(out, answer); });
    variables += std::string(variable) + '=' + quoted_for_gnuplot(file) + "; ";
  };
  add("background", write_background);
  add("isochrones", write_isochrones_for_gnuplot);
  add("routes", write_routes_for_gnuplot);
  const std::string command =
      "gnuplot -e " + quoted_for_shell(variables) + ' ' + quoted_for_shell(DRAW_ROUTES_SCRIPT);
  if(std::system(command.c_str()) != 0)
    throw std::runtime_error("no picture was drawn: what went wrong is told above");
}

#endif // TERRAIN_ROUTES_PICTURE_H
