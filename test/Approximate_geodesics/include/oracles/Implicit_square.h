// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_IMPLICIT_SQUARE_H
#define APPROXIMATE_GEODESICS_TEST_IMPLICIT_SQUARE_H

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>

#include <cstddef>
#include <cstdint>

namespace geodesics_test {

// A square of points, each joined to its four neighbors by arcs that are nowhere stored, and not to
// the one that its path comes from. Lengths are different in x and y.
class Implicit_square
{
public:
  using Node = std::uint32_t;

  explicit Implicit_square(const Node side) : m_side(side) {}

  std::size_t number_of_nodes() const { return std::size_t(m_side) * m_side; }
  double unit() const { return 1; }
  CGAL::Approximate_geodesics::Arc_lengths arc_lengths() const { return {dx, (dx + dy) / 2, dy}; }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    const Node x = node % m_side, y = node / m_side;
    const auto go = [&](const Node target, const double length) {
      if(labels.predecessor(node) != target)
        f(target, length);
    };
    if(x > 0)
      go(node - 1, dx);
    if(y > 0)
      go(node - m_side, dy);
    if(x + 1 < m_side)
      go(node + 1, dx);
    if(y + 1 < m_side)
      go(node + m_side, dy);
  }

  static constexpr double dx = 0.75, dy = 2.5; // sums are exact

private:
  Node m_side;
};

// The same distances, but also arcs that are longer than the two that they replace: if nodes come
// in the order of the numbers of arcs, some are expanded twice.
class Square_with_detours : public Implicit_square
{
public:
  explicit Square_with_detours(const Node side) : Implicit_square(side), m_side(side) {}

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    if(node % m_side + 2 < m_side)
      f(node + 2, 3 * dx);
    Implicit_square::for_each_arc(node, labels, f);
  }

private:
  Node m_side;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_IMPLICIT_SQUARE_H
