// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_NPY_READER_H
#define APPROXIMATE_GEODESICS_TEST_NPY_READER_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace geodesics_test {

// The little-endian number of some bytes, bit by bit.
inline std::uint64_t number_at(const std::string& bytes, const std::size_t at, const int size)
{
  std::uint64_t result = 0;
  for(int i = 0; i < size; ++i)
    result |= std::uint64_t(static_cast<unsigned char>(bytes.at(at + std::size_t(i)))) << (8 * i);
  return result;
}

// An array as its NPY file has it, the dictionary of whose header is not taken apart.
struct Npy_array
{
  std::string dictionary; // without the blanks behind it
  std::string bytes;

  explicit Npy_array(const std::string& file)
  {
    const std::size_t begin = 10 + number_at(file, 8, 2);
    if(file.compare(0, 8, std::string("\x93NUMPY\1\0", 8)) != 0 || begin % 64 != 0 ||
       file.at(begin - 1) != '\n')
      throw std::runtime_error("wrong in the header of an array");
    dictionary = file.substr(10, file.find_last_not_of(" \n", begin - 1) - 9);
    bytes = file.substr(begin);
  }

  template <typename T>
  std::vector<T> numbers() const
  {
    std::vector<T> result;
    for(std::size_t i = 0; i < bytes.size(); i += sizeof(T))
    {
      using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
      const Bits bits = static_cast<Bits>(number_at(bytes, i, sizeof(T)));
      T number;
      std::memcpy(&number, &bits, sizeof(T));
      result.push_back(number);
    }
    return result;
  }
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_NPY_READER_H
