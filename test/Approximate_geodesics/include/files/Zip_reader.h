// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_ZIP_READER_H
#define APPROXIMATE_GEODESICS_TEST_ZIP_READER_H

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
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

// CRC-32 as its definition goes: a division of polynomials, bit by bit.
inline std::uint32_t crc_of(const std::string& bytes)
{
  std::uint32_t rest = 0xFFFFFFFF;
  for(const char byte : bytes)
  {
    rest ^= static_cast<unsigned char>(byte);
    for(int bit = 0; bit < 8; ++bit)
      rest = (rest >> 1) ^ ((rest & 1) != 0 ? 0xEDB88320 : 0);
  }
  return ~rest;
}

struct Zip_member
{
  std::string name;
  std::uint64_t offset;
  bool is_long; // whether the header has sizes of 64 bits
  std::string bytes;
};

/*
 * Reads an archive of members that are not compressed. It is strict: members follow one another,
 * all that is said twice has to agree, and what is wrong throws.
 */
class Zip_reader
{
  static constexpr std::uint64_t MAXIMUM_16 = 0xFFFF, MAXIMUM_32 = 0xFFFFFFFF;

public:
  explicit Zip_reader(const std::string& bytes) : m_bytes(bytes)
  {
    const std::size_t end = bytes.size() - 22;
    expect(get(end, 4) == 0x06054b50 && get(end + 4, 4) == 0 && get(end + 20, 2) == 0, "end");
    m_number = get(end + 10, 2);
    m_size = get(end + 12, 4);
    m_begin = get(end + 16, 4);
    expect(get(end + 8, 2) == m_number, "numbers of members");
    m_has_long_end = m_number == MAXIMUM_16 || m_size == MAXIMUM_32 || m_begin == MAXIMUM_32;
    if(m_has_long_end)
      read_long_end(end - 20);
    expect(m_begin + m_size == end - (m_has_long_end ? 76 : 0), "what is before the end");
    read_directory();
  }

  const std::vector<Zip_member>& members() const { return m_members; }
  bool has_long_end() const { return m_has_long_end; }
  std::uint64_t begin_of_directory() const { return m_begin; }

private:
  void read_long_end(const std::size_t locator)
  {
    expect(get(locator, 4) == 0x07064b50 && get(locator + 4, 4) == 0, "locator");
    expect(get(locator + 16, 4) == 1, "number of disks");
    const std::uint64_t end = get(locator + 8, 8);
    expect(end == locator - 56 && get(end, 4) == 0x06064b50, "long end");
    expect(get(end + 4, 8) == 44 && get(end + 14, 2) == 45 && get(end + 16, 8) == 0, "long end");
    expect(m_number == MAXIMUM_16 || m_number == get(end + 32, 8), "long number");
    m_number = get(end + 32, 8);
    expect(m_number == get(end + 24, 8), "long numbers of members");
    m_size = get(end + 40, 8);
    m_begin = get(end + 48, 8);
  }

  void read_directory()
  {
    std::size_t at = m_begin;
    std::uint64_t end_of_last = 0;
    for(std::uint64_t i = 0; i < m_number; ++i)
    {
      expect(get(at, 4) == 0x02014b50 && get(at + 32, 8) == 0, "entry");
      std::uint64_t size = get(at + 24, 4), offset = get(at + 42, 4);
      expect(get(at + 20, 4) == size, "size of what is not compressed");
      const std::size_t length = get(at + 28, 2), length_of_extra = get(at + 30, 2);
      std::size_t extra = at + 46 + length;
      expect((get(at + 6, 2) == 45) == (length_of_extra > 0), "version");
      at = extra + length_of_extra;
      if(length_of_extra > 0)
      {
        expect(get(extra, 2) == 1 && get(extra + 2, 2) == length_of_extra - 4, "extra field");
        extra += 4;
        if(size == MAXIMUM_32)
        {
          size = take(extra);
          expect(take(extra) == size, "long size of what is not compressed");
        }
        if(offset == MAXIMUM_32)
          offset = take(extra);
        expect(extra == at, "end of the extra field");
      }
      expect(offset == end_of_last, "gap between members");
      end_of_last = read_member(at - length_of_extra - length - 46, offset, size);
    }
    expect(end_of_last == m_begin && at == m_begin + m_size, "ends of members and directory");
  }

  // Reads the member that an entry tells of, and returns where it ends.
  std::uint64_t
  read_member(const std::size_t entry, const std::uint64_t offset, const std::uint64_t size)
  {
    const std::size_t length = get(offset + 26, 2), length_of_extra = get(offset + 28, 2);
    const std::size_t begin = offset + 30 + length + length_of_extra;
    const Zip_member member{m_bytes.substr(offset + 30, length), offset, length_of_extra > 0,
                            m_bytes.substr(begin, size)};
    expect(get(offset, 4) == 0x04034b50, "local header");
    expect(member.name == m_bytes.substr(entry + 46, get(entry + 28, 2)), "names");
    expect(get(offset + 6, 8) == get(entry + 8, 8), "flags, methods or times");
    expect(get(offset + 8, 2) == 0, "method");
    expect((get(offset + 4, 2) == 45) == member.is_long, "version of the header");
    expect(get(offset + 14, 4) == get(entry + 16, 4), "checksums");
    expect(get(offset + 14, 4) == crc_of(member.bytes), "checksum of the contents");
    expect(get(offset + 18, 8) == get(entry + 20, 8), "sizes");
    if(member.is_long)
    {
      const std::size_t extra = begin - length_of_extra;
      expect(get(offset + 18, 8) == ~std::uint64_t(0), "short sizes that say that others are long");
      expect(length_of_extra == 20 && get(extra, 4) == 0x00100001, "extra field of the header");
      expect(get(extra + 4, 8) == size && get(extra + 12, 8) == size, "long sizes");
    }
    m_members.push_back(member);
    return begin + size;
  }

  std::uint64_t get(const std::size_t at, const int size) const
  {
    return number_at(m_bytes, at, size);
  }

  std::uint64_t take(std::size_t& at) const
  {
    at += 8;
    return get(at - 8, 8);
  }

  static void expect(const bool holds, const std::string& subject)
  {
    if(!holds)
      throw std::runtime_error("wrong in the archive: " + subject);
  }

  const std::string& m_bytes;
  std::uint64_t m_number;
  std::uint64_t m_size;
  std::uint64_t m_begin;
  bool m_has_long_end;
  std::vector<Zip_member> m_members;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_ZIP_READER_H
