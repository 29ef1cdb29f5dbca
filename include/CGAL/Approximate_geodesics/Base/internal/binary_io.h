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

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ios>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>

// Portable binary files: numbers are little-endian, followed by a checksum.

namespace CGAL::Approximate_geodesics::internal {

// Writes bytes, or flushes the output if `size` is 0. Returns whether it succeeded. It is not a
// stream, as locales of streams would make up a tenth of a WebAssembly module.
using Put_bytes = std::function<bool(const char* bytes, std::size_t size)>;

// Reads that many bytes. Returns whether it succeeded.
using Get_bytes = std::function<bool(char* bytes, std::size_t size)>;

inline Put_bytes bytes_to(std::ostream& out)
{
  return [&out](const char* const bytes, const std::size_t size) {
    return bool(size > 0 ? out.write(bytes, static_cast<std::streamsize>(size)) : out.flush());
  };
}

inline Get_bytes bytes_from(std::istream& in)
{
  return [&in](char* const bytes, const std::size_t size) {
    return bool(size > 0 ? in.read(bytes, static_cast<std::streamsize>(size)) : in);
  };
}

template <typename T>
using Bytes_of = std::array<unsigned char, sizeof(T)>;

template <typename T>
Bytes_of<T> to_bytes(const T value)
{
  Bytes_of<T> result;
  boost::endian::endian_store<T, sizeof(T), boost::endian::order::little>(result.data(), value);
  return result;
}

// The CRC-32 of PNG images, over little-endian numbers.
class Checksum
{
public:
  template <typename T>
  void add(const T value)
  {
    const Bytes_of<T> bytes = to_bytes(value);
    m_crc.process_bytes(bytes.data(), bytes.size());
  }

  std::uint32_t value() const { return m_crc.checksum(); }

private:
  boost::crc_32_type m_crc;
};

// `contents` names the written data in messages, such as "the graph".
class Binary_writer
{
public:
  Binary_writer(const Put_bytes& put, const std::string& contents)
    : m_put(put), m_contents(contents)
  {
  }

  template <typename T>
  void write(const T value)
  {
    m_checksum.add(value);
    const Bytes_of<T> bytes = to_bytes(value);
    m_succeeds = m_succeeds && m_put(reinterpret_cast<const char*>(bytes.data()), sizeof(T));
  }

  // Writes the checksum of all preceding data. Throws if any write failed.
  void finish()
  {
    write(m_checksum.value());
    if(!m_succeeds || !m_put(nullptr, 0))
      throw std::runtime_error("Approximate_geodesics: " + m_contents + " could not be written");
  }

private:
  const Put_bytes& m_put;
  std::string m_contents;
  Checksum m_checksum;
  bool m_succeeds = true;
};

class Binary_reader
{
public:
  Binary_reader(const Get_bytes& get, const std::string& contents)
    : m_get(get), m_contents(contents)
  {
    if(!m_get(nullptr, 0))
      reject("the stream of " + m_contents + " cannot be read: its file may not exist");
  }

  template <typename T>
  T read()
  {
    Bytes_of<T> bytes;
    if(!m_get(reinterpret_cast<char*>(bytes.data()), sizeof(T)))
      reject("the file of " + m_contents + " is truncated");
    const T result =
        boost::endian::endian_load<T, sizeof(T), boost::endian::order::little>(bytes.data());
    m_checksum.add(result);
    return result;
  }

  // Reads the checksum, and compares it with that of all preceding data.
  void finish()
  {
    const std::uint32_t expected = m_checksum.value();
    if(read<std::uint32_t>() != expected)
      reject("the file of " + m_contents + " is damaged: its checksum does not match");
  }

private:
  const Get_bytes& m_get;
  std::string m_contents;
  Checksum m_checksum;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_BINARY_IO_H
