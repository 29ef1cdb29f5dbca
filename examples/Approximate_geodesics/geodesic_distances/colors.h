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

// From blue (`part` is 0) over green to red (1).
inline Color color_of(const double part)
{
  constexpr std::array<Color, 5> scale{Color{0.16, 0.32, 0.95}, Color{0.10, 0.78, 0.92},
                                       Color{0.35, 0.88, 0.35}, Color{1.00, 0.86, 0.16},
                                       Color{0.93, 0.18, 0.14}};
  const double position = (std::clamp)(part, 0., 1.) * double(scale.size() - 1);
  const std::size_t i = (std::min)(static_cast<std::size_t>(position), scale.size() - 2);
  return blend(scale[i], scale[i + 1], position - double(i));
}

#endif // GEODESIC_DISTANCES_COLORS_H
