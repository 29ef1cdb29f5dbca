#ifndef TERRAIN_ROUTES_RASTERS_UNITS_H
#define TERRAIN_ROUTES_RASTERS_UNITS_H

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>

// A unit of length.
struct Length_unit
{
  std::string name;
  double meters;
};

// Returns the unit that files and users call so; none if it is not known.
inline std::optional<Length_unit> length_unit(const std::string& text)
{
  static constexpr double foot = 0.3048, us_foot = 1200. / 3937;
  struct Name
  {
    const char* text;
    const char* name;
    double meters;
  };
  static constexpr std::array<Name, 27> names{{
      {"m", "m", 1},
      {"meter", "m", 1},
      {"meters", "m", 1},
      {"metre", "m", 1},
      {"metres", "m", 1},
      {"km", "km", 1000},
      {"kilometer", "km", 1000},
      {"kilometers", "km", 1000},
      {"kilometre", "km", 1000},
      {"kilometres", "km", 1000},
      {"dm", "dm", 0.1},
      {"decimeter", "dm", 0.1},
      {"decimetre", "dm", 0.1},
      {"cm", "cm", 0.01},
      {"centimeter", "cm", 0.01},
      {"centimetre", "cm", 0.01},
      {"mm", "mm", 0.001},
      {"millimeter", "mm", 0.001},
      {"millimetre", "mm", 0.001},
      {"ft", "ft", foot},
      {"foot", "ft", foot},
      {"feet", "ft", foot},
      {"us-ft", "us-ft", us_foot},
      {"ftus", "us-ft", us_foot},
      {"us survey foot", "us-ft", us_foot},
      {"us survey feet", "us-ft", us_foot},
      {"foot_us", "us-ft", us_foot},
  }};
  std::string wanted = text;
  std::transform(wanted.begin(), wanted.end(), wanted.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for(const Name& name : names)
    if(wanted == name.text)
      return Length_unit{name.name, name.meters};
  return {};
}

// A unit after a number; none if it is not known.
inline std::string with_blank(const std::string& unit) { return unit.empty() ? "" : ' ' + unit; }

// A unit after the name of a quantity.
inline std::string in_parentheses(const std::string& unit)
{
  return unit.empty() ? "" : " (" + unit + ')';
}

#endif // TERRAIN_ROUTES_RASTERS_UNITS_H
