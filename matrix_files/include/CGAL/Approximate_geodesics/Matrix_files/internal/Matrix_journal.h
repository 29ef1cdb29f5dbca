// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_JOURNAL_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_JOURNAL_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Matrix_identity.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Local_file.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// The position and the checksum of a block of rows on disk.
struct Block_record
{
  std::uint64_t block;
  std::uint64_t offset;
  std::uint64_t size; // in bytes
  std::uint64_t checksum;
};

/*
 * The append-only journal of a matrix file: the identity of the computation, and the completed
 * blocks. A kill can interrupt a write, so an incomplete record at the end is ignored. Any other
 * damage is an error.
 */
class Matrix_journal
{
  static constexpr std::uint64_t SIGNATURE = 0x0a1a0d4d44474741; // AGGDM, and line ends
  static constexpr std::uint32_t VERSION = 2;

public:
  static constexpr std::uint64_t LENGTH_OF_HEADER =
      16 + 8 * std::uint64_t(Matrix_identity::NUMBER_OF_PARTS);
  static constexpr std::uint64_t LENGTH_OF_RECORD = 36;

  struct Contents
  {
    std::optional<Matrix_identity> identity; // absent if the header was not written
    std::vector<Block_record> records;

    std::uint64_t length() const
    {
      return identity ? LENGTH_OF_HEADER + LENGTH_OF_RECORD * records.size() : 0;
    }
  };

  // The contents are empty if the file does not exist.
  static Contents read(const std::string& file)
  {
    Contents result;
    if(!std::filesystem::exists(file))
      return result;
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    if(!in)
      fail_to("read", file);
    if(bytes.size() < LENGTH_OF_HEADER)
      return result;
    result.identity = read_header(file, bytes);
    for(std::uint64_t at = LENGTH_OF_HEADER; at + LENGTH_OF_RECORD <= bytes.size();
        at += LENGTH_OF_RECORD)
      if(!read_record(bytes.data() + at, result.records))
      {
        if(is_zero(bytes, at)) // zero-filled tail: extended before a crash
          break;
        reject(file + " is damaged at byte " + std::to_string(at) + "; " + remedy());
      }
    return result;
  }

  // Replaces the records of a journal atomically.
  static void replace(const std::string& file,
                      const Matrix_identity& identity,
                      const std::vector<Block_record>& records)
  {
    const std::string name = replacement(file);
    std::filesystem::remove(name);
    Matrix_journal(name, identity, Contents()).append(records);
    std::filesystem::rename(name, file);
  }

  // The temporary name of a replacement journal.
  static std::string replacement(const std::string& file) { return file + ".new"; }

  // Continues a journal whose contents were read, or creates it.
  Matrix_journal(const std::string& file, const Matrix_identity& identity, const Contents& contents)
    : m_file(file), m_end(contents.length())
  {
    m_file.resize(m_end);
    if(m_end == 0)
      append_bytes(header(identity));
  }

  // Returns when the records are on disk.
  void append(const std::vector<Block_record>& records)
  {
    std::vector<char> bytes;
    for(const Block_record& r : records)
    {
      const std::size_t start = bytes.size();
      for(const std::uint64_t value : {r.block, r.offset, r.size, r.checksum})
        put(value, bytes);
      put(checksum(bytes.data() + start, bytes.data() + bytes.size()), bytes);
    }
    append_bytes(bytes);
  }

  static const char* remedy()
  {
    return "remove the .journal and .part files of this matrix to restart";
  }

private:
  template <typename T>
  static void put(const T value, std::vector<char>& bytes)
  {
    const auto added = to_bytes(value);
    bytes.insert(bytes.end(), added.begin(), added.end());
  }

  template <typename T>
  static T get(const char*& at)
  {
    std::array<char, sizeof(T)> bytes;
    std::copy_n(at, sizeof(T), bytes.begin());
    at += sizeof(T);
    return from_bytes<T>(bytes);
  }

  static std::uint32_t checksum(const char* const begin, const char* const end)
  {
    boost::crc_32_type result;
    result.process_block(begin, end);
    return result.checksum();
  }

  static std::vector<char> header(const Matrix_identity& identity)
  {
    std::vector<char> result;
    put(SIGNATURE, result);
    put(VERSION, result);
    for(const std::uint64_t part : identity.parts)
      put(part, result);
    put(checksum(result.data(), result.data() + result.size()), result);
    return result;
  }

  static Matrix_identity read_header(const std::string& file, const std::vector<char>& bytes)
  {
    const char* at = bytes.data();
    if(get<std::uint64_t>(at) != SIGNATURE)
      reject(file + " is not the journal of a distance matrix");
    const auto version = get<std::uint32_t>(at);
    if(version != VERSION)
      reject(file + " has version " + std::to_string(version) + "; this program reads version " +
             std::to_string(VERSION));
    Matrix_identity result;
    for(std::uint64_t& part : result.parts)
      part = get<std::uint64_t>(at);
    const std::uint32_t expected = checksum(bytes.data(), at);
    if(get<std::uint32_t>(at) != expected)
      reject(file + " is damaged at its beginning; " + remedy());
    return result;
  }

  // Returns whether the checksum of the record is correct.
  static bool read_record(const char* at, std::vector<Block_record>& records)
  {
    const std::uint32_t expected = checksum(at, at + LENGTH_OF_RECORD - sizeof(std::uint32_t));
    Block_record r;
    for(std::uint64_t* const value : {&r.block, &r.offset, &r.size, &r.checksum})
      *value = get<std::uint64_t>(at);
    if(get<std::uint32_t>(at) != expected)
      return false;
    records.push_back(r);
    return true;
  }

  static bool is_zero(const std::vector<char>& bytes, const std::uint64_t from)
  {
    return std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(),
                       [](const char c) { return c == 0; });
  }

  void append_bytes(const std::vector<char>& bytes)
  {
    m_file.write(m_end, bytes.data(), bytes.size());
    m_file.sync();
    m_end += bytes.size();
  }

  Local_file m_file;
  std::uint64_t m_end;
};

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_MATRIX_JOURNAL_H
