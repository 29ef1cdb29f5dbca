#ifndef TERRAIN_ROUTES_PICTURE_H
#define TERRAIN_ROUTES_PICTURE_H

#include "../../command_line/New_files.h"
#include "../../command_line/quoted_for_shell.h"
#include "../../command_line/read_options.h"
#include "../../command_line/script_file.h"
#include "../Answer.h"
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
    step = (std::max(frame.columns, frame.rows) + most - 1) / most;
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
  std::size_t step; // from one of them to the next
};

// Returns values of cells, row by row. `row(i)` returns those of a row.
template <typename Row>
std::vector<double> sampled(const Background& background, const Row& row)
{
  std::vector<double> result;
  for(const std::size_t i : background.rows)
  {
    const std::vector<double> values = row(i);
    for(const std::size_t column : background.columns)
      result.push_back(values[column]);
  }
  return result;
}

inline std::vector<double> sampled_friction(const Answer& answer, const Background& background)
{
  return sampled(background,
                 [&](const std::size_t row) { return answer.costs().friction_row(row); });
}

// Colors, in three bytes: from dark for 0 to light for 1, and brown for NaN.
inline void write_grays(std::ostream& out, const std::vector<double>& tones)
{
  constexpr double darkest = 90, range = 150;
  for(const double tone : tones)
  {
    const bool is_open = !std::isnan(tone);
    const double clamped = is_open ? std::clamp(tone, 0., 1.) : 0;
    const char gray = static_cast<char>(static_cast<int>(darkest + range * clamped));
    out << (is_open ? gray : '\x5a') << (is_open ? gray : '\x46') << (is_open ? gray : '\x32');
  }
}

// Returns tones by the logarithms of friction, from light for the least one to dark.
inline std::vector<double> tones_of_friction(const Answer& answer, const Background& background)
{
  std::vector<double> result = sampled_friction(answer, background);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for(double& tone : result)
  {
    tone = std::log(tone);
    if(std::isfinite(tone))
    {
      least = std::min(least, tone);
      most = std::max(most, tone);
    }
  }
  for(double& tone : result)
    if(tone == std::numeric_limits<double>::infinity())
      tone = std::numeric_limits<double>::quiet_NaN();
    else
      tone = most > least ? (most - std::max(tone, least)) / (most - least) : 1;
  return result;
}

// Returns slopes toward the northwest, where the light comes from, and divides them by their
// quadratic mean; NaN for cells without a height, and 0 beside them.
inline std::vector<double> lit_slopes(const Answer& answer, const Background& background)
{
  const std::size_t columns = background.columns.size(), rows = background.rows.size();
  const std::vector<double> heights = sampled(background, [&](const std::size_t row) {
    return answer.costs().heights({0, row, answer.frame().columns, 1});
  });
  const auto& sides = answer.costs().metric().middle();
  const double up = answer.frame().y_step < 0 ? 1 : -1; // on paper
  std::vector<double> result(heights.size());
  double squares = 0;
  for(std::size_t row = 0; row < rows; ++row)
    for(std::size_t column = 0; column < columns; ++column)
    {
      const auto height = [&](const std::size_t c, const std::size_t r) {
        return heights[std::min(r, rows - 1) * columns + std::min(c, columns - 1)];
      };
      const std::size_t left = column - (column > 0 ? 1 : 0), below = row - (row > 0 ? 1 : 0);
      const double slope = (height(left, row) - height(column + 1, row)) / sides.width +
                           up * (height(column, row + 1) - height(column, below)) / sides.height;
      result[row * columns + column] = std::isnan(slope) ? 0 : -slope;
      squares += std::isnan(slope) ? 0 : slope * slope;
    }
  const double mean = std::sqrt(squares / static_cast<double>(result.size()));
  for(std::size_t i = 0; i < result.size(); ++i)
    result[i] = std::isnan(heights[i]) ? heights[i] : mean > 0 ? result[i] / mean : 0;
  return result;
}

// Returns tones of slopes in the light; NaN for cells that cannot be entered.
inline std::vector<double> hillshade(const Answer& answer, const Background& background)
{
  std::vector<double> result = lit_slopes(answer, background);
  for(double& tone : result)
    tone = 0.65 + 0.35 * tone / std::hypot(1, tone);
  if(!answer.costs().has_friction())
    return result;
  const std::vector<double> friction = sampled_friction(answer, background);
  for(std::size_t i = 0; i < result.size(); ++i)
    if(std::isinf(friction[i]))
      result[i] = std::numeric_limits<double>::quiet_NaN();
  return result;
}

inline void write_background(std::ostream& out, const Answer& answer)
{
  const Background background(answer.frame());
  write_grays(out, answer.costs().has_heights() ? hillshade(answer, background)
                                                : tones_of_friction(answer, background));
}

inline void write_isochrones_for_gnuplot(std::ostream& out, const Answer& answer)
{
  const Isochrones& isochrones = answer.isochrones();
  for(std::size_t i = 0; i < isochrones.values().size(); ++i)
    for(const Line& line : isochrones.lines(i))
      for(const Line& part : parts_on_raster(line, answer.costs().shape()))
      {
        for(const Grid_point& point : part)
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
    for(const Line& part : parts_on_raster(route.points, answer.costs().shape()))
    {
      for(const Grid_point& point : part)
      {
        const Grid_point p = on_map(point, answer.frame());
        out << p.x << ' ' << p.y << '\n';
      }
      out << '\n';
    }
}

inline void write_centers_for_gnuplot(std::ostream& out,
                                      const std::vector<Grid_cell>& cells,
                                      const Raster_frame& frame)
{
  out << "# x y\n";
  for(const Grid_cell& cell : cells)
  {
    const Grid_point p = on_map(
        {static_cast<double>(cell.column) + 0.5, static_cast<double>(cell.row) + 0.5}, frame);
    out << p.x << ' ' << p.y << '\n';
  }
}

inline void write_sources_for_gnuplot(std::ostream& out, const Answer& answer)
{
  write_centers_for_gnuplot(out, answer.sources(), answer.frame());
}

inline void write_targets_for_gnuplot(std::ostream& out, const Answer& answer)
{
  std::vector<Grid_cell> targets;
  for(const Route& route : answer.routes())
    targets.push_back(route.target);
  write_centers_for_gnuplot(out, targets, answer.frame());
}

// A text in a script of gnuplot.
inline std::string quoted_for_gnuplot(const std::string& text)
{
  std::string result = "'";
  for(const char c : text)
    result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

// Returns what the axes show, with units.
inline std::string variables_of_labels(const Answer& answer)
{
  const Map_system& system = answer.frame().system;
  const std::string unit = in_parentheses(!system.is_geographic ? system.unit.name
                                          : system.degrees == 1 ? "degrees"
                                                                : "");
  const auto label = [&](const char* const angle, const char* const length) {
    return quoted_for_gnuplot((system.is_geographic ? angle : length) + unit);
  };
  const std::string cost =
      (answer.goes_to_sources() ? "cost to the nearest source" : "cost from the nearest source") +
      in_parentheses(answer.costs().unit_of_costs());
  return "x_label=" + label("longitude", "x") + "; y_label=" + label("latitude", "y") +
         "; cost_label=" + quoted_for_gnuplot(cost) + "; ";
}

inline bool has_isochrones(const Answer& answer)
{
  for(std::size_t i = 0; i < answer.isochrones().values().size(); ++i)
    if(!answer.isochrones().lines(i).empty())
      return true;
  return false;
}

inline bool has_routes(const Answer& answer)
{
  return std::any_of(answer.routes().begin(), answer.routes().end(),
                     [](const Route& route) { return !route.points.empty(); });
}

// What the script has to know of the map.
inline std::string variables_of_map(const Answer& answer)
{
  const Raster_frame& frame = answer.frame();
  const auto& sides = answer.costs().metric().middle();
  const auto columns = static_cast<double>(frame.columns), rows = static_cast<double>(frame.rows);
  const Grid_point end = on_map({columns, rows}, frame);
  const Background background(frame);
  std::ostringstream out;
  out.precision(17);
  out << "largest=" << answer.largest_cost() << "; x_min=" << std::min(frame.x, end.x)
      << "; x_max=" << std::max(frame.x, end.x) << "; y_min=" << std::min(frame.y, end.y)
      << "; y_max=" << std::max(frame.y, end.y) << "; downward=" << (frame.y_step > 0)
      << "; columns=" << background.columns.size() << "; rows=" << background.rows.size()
      << "; has_isochrones=" << has_isochrones(answer) << "; has_routes=" << has_routes(answer)
      << "; has_targets=" << !answer.routes().empty()
      << "; ratio=" << rows * sides.height / (columns * sides.width) << "; ";
  return out.str();
}

inline void draw_picture(const std::string& name,
                         const std::string& place,
                         const std::string& colors,
                         const Answer& answer)
{
  New_files parts(true); // never put in place
  std::string variables = variables_of_map(answer) + variables_of_labels(answer) +
                          "colors=" + quoted_for_gnuplot(colors) +
                          "; picture=" + quoted_for_gnuplot(place) + "; ";
  const auto add = [&](const char* const variable, const auto write) {
    const std::string file =
        parts.write(name + '.' + variable, [&](std::ostream& out) { write(out, answer); });
    variables += std::string(variable) + '=' + quoted_for_gnuplot(file) + "; ";
  };
  add("background", write_background);
  add("isochrones", write_isochrones_for_gnuplot);
  add("routes", write_routes_for_gnuplot);
  add("sources", write_sources_for_gnuplot);
  add("targets", write_targets_for_gnuplot);
  const std::string command = "gnuplot -e " + quoted_for_shell(variables) + ' ' +
                              quoted_for_shell(script_file(DRAW_ROUTES_SCRIPT));
  if(std::system(command.c_str()) != 0)
    throw std::runtime_error("no picture was drawn: what went wrong is told above");
}

#endif // TERRAIN_ROUTES_PICTURE_H
