#ifndef GEODESIC_MATRIX_TEXTS_H
#define GEODESIC_MATRIX_TEXTS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>

// With three digits at least, and no exponent.
inline std::string text_of_number(const double number)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(number < 10 ? 2 : number < 100 ? 1 : 0) << number;
  return text.str();
}

// In a unit that suits them.
inline std::string text_of_bytes(double bytes)
{
  constexpr std::array<const char*, 4> units{" kB", " MB", " GB", " TB"};
  std::size_t i = 0;
  for(bytes /= 1000; bytes >= 1000 && i + 1 < units.size(); ++i)
    bytes /= 1000;
  return text_of_number(bytes) + units[i];
}

inline std::string text_of_time(const double seconds)
{
  if(!std::isfinite(seconds))
    return "unknown time";
  if(seconds < 100)
    return text_of_number(seconds) + " s";
  return seconds < 6000 ? text_of_number(seconds / 60) + " min"
                        : text_of_number(seconds / 3600) + " h";
}

#endif // GEODESIC_MATRIX_TEXTS_H
