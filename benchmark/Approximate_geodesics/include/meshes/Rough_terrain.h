// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_ROUGH_TERRAIN_H
#define BENCHMARK_ROUGH_TERRAIN_H

#include <CGAL/Geodesic_grids/Grid_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// Heights of a grid: the sum of gradient noise of wavelengths from 256 cells down to the finest
// one, each half of the last. Amplitudes fall by the power 0.9 of the wavelength, so that the
// finest ones still make a good part of the slopes.
class Rough_terrain
{
  using Shape = CGAL::Approximate_geodesics::Grid_shape;

public:
  // `relief` is the amplitude of the longest waves, relative to their length.
  Rough_terrain(const double relief, const double finest) : m_relief(relief), m_finest(finest) {}

  std::vector<double> heights(const Shape& shape) const
  {
    std::vector<double> result;
    for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
      result.push_back(shape.cell_width *
                       height(double(shape.cell(i).column), double(shape.cell(i).row)));
    return result;
  }

  // Interpolates heights where cells are so many times smaller; corners stay where they are.
  static std::vector<double>
  interpolated(const Shape& shape, const std::vector<double>& heights, const std::size_t factor)
  {
    std::vector<double> result;
    for(std::size_t row = 0; row <= factor * (shape.rows - 1); ++row)
      for(std::size_t column = 0; column <= factor * (shape.columns - 1); ++column)
      {
        const double u = double(column % factor) / double(factor),
                     v = double(row % factor) / double(factor);
        const auto at = [&](const std::size_t c, const std::size_t r) {
          return heights[shape.index({(std::min)(column / factor + c, shape.columns - 1),
                                      (std::min)(row / factor + r, shape.rows - 1)})];
        };
        result.push_back((1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) +
                         v * ((1 - u) * at(0, 1) + u * at(1, 1)));
      }
    return result;
  }

private:
  static constexpr double LONGEST = 256, EXPONENT = 0.9;

  double height(const double x, const double y) const
  {
    double result = 0;
    std::uint32_t octave = 0;
    for(double wave = LONGEST; wave >= m_finest; wave /= 2, ++octave)
      result += m_relief * LONGEST * std::pow(wave / LONGEST, EXPONENT) *
                noise(x / wave + 0.37 * octave, y / wave + 0.71 * octave, octave);
    return result;
  }

  // Perlin's gradient noise.
  static double noise(const double x, const double y, const std::uint32_t octave)
  {
    const double column = std::floor(x), row = std::floor(y), u = x - column, v = y - row;
    const auto ramp = [&](const int i, const int j) {
      const double angle = random_angle(std::uint32_t(column) + std::uint32_t(i),
                                        std::uint32_t(row) + std::uint32_t(j), octave);
      return std::cos(angle) * (u - i) + std::sin(angle) * (v - j);
    };
    const auto smooth = [](const double t) { return t * t * t * (t * (6 * t - 15) + 10); };
    const auto mix = [&](const double a, const double b, const double t) {
      return a + smooth(t) * (b - a);
    };
    return mix(mix(ramp(0, 0), ramp(1, 0), u), mix(ramp(0, 1), ramp(1, 1), u), v);
  }

  static double
  random_angle(const std::uint32_t x, const std::uint32_t y, const std::uint32_t octave)
  {
    std::uint32_t hash = x * 374761393u + y * 668265263u + octave * 2246822519u;
    hash = (hash ^ (hash >> 13)) * 1274126177u;
    hash ^= hash >> 16;
    return 2 * std::acos(-1.) * double(hash) / 4294967296.;
  }

  double m_relief, m_finest;
};

#endif // BENCHMARK_ROUGH_TERRAIN_H
