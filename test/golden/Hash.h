// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_HASH_H
#define APPROXIMATE_GEODESICS_TEST_HASH_H

#include "meshes/test_soup.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace geodesics_test {

// Tells sequences of numbers apart by their bits, and so 0 from -0, too: FNV-1a, with 64 bits.
class Hash
{
public:
  void add(const std::uint64_t value)
  {
    for(int shift = 0; shift < 64; shift += 8)
      m_value = (m_value ^ (value >> shift & 255)) * 1099511628211u;
  }

  void add(const double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    add(bits);
  }

  void add(const Point& p) { add_coordinates(p); }
  void add(const Kernel::Vector_3& v) { add_coordinates(v); }
  void add(const Vertex v) { add(std::uint64_t(v.idx())); }
  void add(const Halfedge h) { add(std::uint64_t(h.idx())); }
  void add(const Face f) { add(std::uint64_t(f.idx())); }

  void add(const std::string& bytes)
  {
    add(std::uint64_t(bytes.size()));
    for(const char c : bytes)
      add(std::uint64_t(static_cast<unsigned char>(c)));
  }

  // The size is part of it, so that a sequence of sequences is known by its numbers.
  template <typename T>
  void add(const std::vector<T>& values)
  {
    add(std::uint64_t(values.size()));
    for(const T& value : values)
      add(value);
  }

  std::string text() const
  {
    std::string result;
    for(int shift = 60; shift >= 0; shift -= 4)
      result += "0123456789abcdef"[m_value >> shift & 15];
    return result;
  }

private:
  template <typename Triple>
  void add_coordinates(const Triple& p)
  {
    for(int i = 0; i < 3; ++i)
      add(double(p[i]));
  }

  std::uint64_t m_value = 14695981039346656037u;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_HASH_H
