#ifndef GEODESIC_DISTANCES_COLORS_H
#define GEODESIC_DISTANCES_COLORS_H

#include <algorithm>
#include <array>
#include <cstddef>

using Color = std::array<double, 3>;

inline Color blend(const Color& a, const Color& b, const double t)
{
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

// From blue over green to red.
inline constexpr std::array<Color, 5> rainbow{Color{0.16, 0.32, 0.95}, Color{0.10, 0.78, 0.92},
                                              Color{0.35, 0.88, 0.35}, Color{1.00, 0.86, 0.16},
                                              Color{0.93, 0.18, 0.14}};

// From dark violet to light yellow, which look equally far apart: by equal steps in the color space
// Oklab, in which lightness grows evenly, and hues turn.
inline constexpr std::array<Color, 9> uniform_colors{
    Color{0.23, 0.09, 0.27}, Color{0.25, 0.20, 0.41}, Color{0.23, 0.32, 0.52},
    Color{0.18, 0.44, 0.59}, Color{0.18, 0.56, 0.62}, Color{0.31, 0.67, 0.62},
    Color{0.51, 0.76, 0.60}, Color{0.73, 0.84, 0.59}, Color{0.95, 0.90, 0.63}};

// The color of a number from 0 to 1.
template <std::size_t SIZE>
Color color_of(const double part, const std::array<Color, SIZE>& scale)
{
  const double position = (std::clamp)(part, 0., 1.) * double(scale.size() - 1);
  const std::size_t i = (std::min)(static_cast<std::size_t>(position), scale.size() - 2);
  return blend(scale[i], scale[i + 1], position - double(i));
}

#endif // GEODESIC_DISTANCES_COLORS_H
