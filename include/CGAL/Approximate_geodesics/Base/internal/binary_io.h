// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_BINARY_IO_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_BINARY_IO_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>
#include <boost/integer.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>

// Portable binary streams: numbers are little-endian, followed by a checksum.

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

template <typename T>
using Bits_of = typename boost::uint_t<8 * sizeof(T)>::exact;

template <typename T>
std::array<char, sizeof(T)> to_bytes(const T value)
{
  Bits_of<T> bits;
  std::memcpy(&bits, &value, sizeof(T));
  boost::endian::native_to_little_inplace(bits);
  std::array<char, sizeof(T)> result;
  std::memcpy(result.data(), &bits, sizeof(T));
  return result;
}

template <typename T>
T from_bytes(const std::array<char, sizeof(T)>& bytes)
{
  Bits_of<T> bits;
  std::memcpy(&bits, bytes.data(), sizeof(T));
  boost::endian::little_to_native_inplace(bits);
  T result;
  std::memcpy(&result, &bits, sizeof(T));
  return result;
}

// Returns `value` with its bytes in little-endian order.
template <typename T>
T little_endian(const T value)
{
  T result = value;
  if constexpr(boost::endian::order::native != boost::endian::order::little)
    std::memcpy(&result, to_bytes(value).data(), sizeof(T));
  return result;
}

// Returns the concatenated little-endian bytes of the numbers.
template <typename... Numbers>
std::string packed(const Numbers... numbers)
{
  std::string result;
  const auto append = [&](const auto& bytes) { result.append(bytes.data(), bytes.size()); };
  (append(to_bytes(numbers)), ...);
  return result;
}

// The CRC-32 of ZIP archives and PNG images.
class Checksum
{
public:
  template <typename T>
  void add(const T value)
  {
    add(to_bytes(value));
  }

  template <std::size_t size>
  void add(const std::array<char, size>& bytes)
  {
    add(bytes.data(), size);
  }

  void add(const char* bytes, const std::size_t number) { m_crc.process_bytes(bytes, number); }

  std::uint32_t value() const { return m_crc.checksum(); }

private:
  boost::crc_32_type m_crc;
};

// `contents` names the written data in messages, such as "the graph".
class Binary_writer
{
public:
  Binary_writer(std::ostream& out, const std::string& contents) : m_out(out), m_contents(contents)
  {
  }

  template <typename T>
  void write(const T value)
  {
    const auto bytes = to_bytes(value);
    m_checksum.add(bytes);
    m_out.write(bytes.data(), sizeof(T));
  }

  // Writes the checksum of all preceding data. Throws if any write failed.
  void finish()
  {
    write(m_checksum.value());
    m_out.flush();
    if(!m_out)
      throw std::runtime_error("Approximate_geodesics: " + m_contents + " could not be written");
  }

private:
  std::ostream& m_out;
  std::string m_contents;
  Checksum m_checksum;
};

class Binary_reader
{
public:
  Binary_reader(std::istream& in, const std::string& contents) : m_in(in), m_contents(contents)
  {
    if(!m_in)
      reject("the stream of " + m_contents + " cannot be read: its file may not exist");
  }

  template <typename T>
  T read()
  {
    std::array<char, sizeof(T)> bytes;
    if(!m_in.read(bytes.data(), sizeof(T)))
      reject("the file of " + m_contents + " is truncated");
    m_checksum.add(bytes);
    return from_bytes<T>(bytes);
  }

  // Reads the checksum, and compares it with that of all preceding data.
  void finish()
  {
    const std::uint32_t expected = m_checksum.value();
    if(read<std::uint32_t>() != expected)
      reject("the file of " + m_contents + " is damaged: its checksum does not match");
  }

private:
  std::istream& m_in;
  std::string m_contents;
  Checksum m_checksum;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_BINARY_IO_H
