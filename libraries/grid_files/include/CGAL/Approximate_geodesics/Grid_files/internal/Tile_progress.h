// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_TILE_PROGRESS_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_TILE_PROGRESS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Tells a visitor how far the work on a tile is, in thousandths of tiles, as long as it lives. What
 * polls it can still be interrupted from outside.
 */
template <typename Visitor>
class Tile_progress final : public Interruption
{
public:
  Tile_progress(Visitor& visitor, const std::size_t number_done, const std::size_t number)
    : m_visitor(visitor), m_number_done(number_done), m_number(number)
  {
    m_visitor.on_progress(PARTS * m_number_done, PARTS * m_number);
    of_this_thread() = this;
  }

  ~Tile_progress() { of_this_thread() = m_outer; }
  Tile_progress(const Tile_progress&) = delete;
  Tile_progress& operator=(const Tile_progress&) = delete;

  void check() override
  {
    if(m_outer != nullptr)
      m_outer->check();
  }

  // Several functions can work on a tile, one after the other: what has been told does not shrink.
  void set_progress(const std::size_t done, const std::size_t all) override
  {
    const double part = (std::min)(1., static_cast<double>(done) / static_cast<double>(all));
    m_parts = (std::max)(m_parts, static_cast<std::size_t>(part * PARTS));
    m_visitor.on_progress(PARTS * m_number_done + m_parts, PARTS * m_number);
  }

private:
  static constexpr std::size_t PARTS = 1000;

  Visitor& m_visitor;
  Interruption* m_outer = of_this_thread();
  std::size_t m_number_done, m_number;
  std::size_t m_parts = 0; // of this tile
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_TILE_PROGRESS_H
