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

// A block of rows that is on the disk: where, and with which checksum.
struct Block_record
{
  std::uint64_t block;
  std::uint64_t offset;
  std::uint64_t size; // in bytes
  std::uint64_t checksum;
};

/*
 * The journal of a file of distances, which only grows: what the file is, and the blocks that are
 * there. A computation can be killed while it writes; so an end that is not complete counts as not
 * written. Anything else that is not as written is an error.
 */
class Matrix_journal
{
  static constexpr std::uint64_t SIGNATURE = 0x0a1a0d4d44474741; // AGGDM, and what text modes spoil
  static constexpr std::uint32_t VERSION = 2;

public:
  static constexpr std::uint64_t LENGTH_OF_HEADER =
      16 + 8 * std::uint64_t(Matrix_identity::NUMBER_OF_PARTS);
  static constexpr std::uint64_t LENGTH_OF_RECORD = 36;

  struct Contents
  {
    std::optional<Matrix_identity> identity; // or nothing was written
    std::vector<Block_record> records;

    std::uint64_t length() const
    {
      return identity ? LENGTH_OF_HEADER + LENGTH_OF_RECORD * records.size() : 0;
    }
  };

  // Nothing was written if there is no file.
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
        if(is_zero(bytes, at)) // the system has made room, and then stopped
          break;
        reject(file + " is damaged at byte " + std::to_string(at) + "; " + remedy());
      }
    return result;
  }

  // Puts a journal with other records in the place of one. It is never incomplete.
  static void replace(const std::string& file,
                      const Matrix_identity& identity,
                      const std::vector<Block_record>& records)
  {
    const std::string name = replacement(file);
    std::filesystem::remove(name);
    Matrix_journal(name, identity, Contents()).append(records);
    std::filesystem::rename(name, file);
  }

  // The name of a new journal, before it takes the place of the old one.
  static std::string replacement(const std::string& file) { return file + ".new"; }

  // Goes on with a journal whose contents were read, or begins it.
  Matrix_journal(const std::string& file, const Matrix_identity& identity, const Contents& contents)
    : m_file(file), m_end(contents.length())
  {
    m_file.resize(m_end);
    if(m_end == 0)
      append_bytes(header(identity));
  }

  // Returns when they are on the disk.
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

  static const char* remedy() { return "remove it, and what is beside it, to begin anew"; }

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
      reject(file + " is not the journal of a file of distances");
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

  // Returns whether the record is sound.
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
