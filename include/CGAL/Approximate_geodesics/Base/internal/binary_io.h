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
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>

// Portable binary streams: numbers are little-endian, followed by a checksum.

namespace CGAL::Approximate_geodesics::internal {

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
    add(to_bytes(value));
  }

  template <std::size_t size>
  void add(const std::array<unsigned char, size>& bytes)
  {
    m_crc.process_bytes(bytes.data(), size);
  }

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
    const Bytes_of<T> bytes = to_bytes(value);
    m_checksum.add(bytes);
    m_out.write(reinterpret_cast<const char*>(bytes.data()), sizeof(T));
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
    Bytes_of<T> bytes;
    if(!m_in.read(reinterpret_cast<char*>(bytes.data()), sizeof(T)))
      reject("the file of " + m_contents + " is truncated");
    m_checksum.add(bytes);
    return boost::endian::endian_load<T, sizeof(T), boost::endian::order::little>(bytes.data());
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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_BINARY_IO_H
