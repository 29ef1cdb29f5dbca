// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_ZIP_WRITER_H
#define CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_ZIP_WRITER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ios>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Writes a ZIP archive with uncompressed members, as specified by PKWARE's APPNOTE.TXT. Memory is
 * linear in the number of members, not in their sizes. The archive is reproducible: members have no
 * timestamps.
 *
 * Sizes and offsets of at least `limit` use the 64-bit fields of ZIP64. The archive is complete
 * once finish() has returned. Write errors throw `std::runtime_error` and leave the archive
 * unusable.
 */
class Zip_writer
{
  using U16 = std::uint16_t;
  using U32 = std::uint32_t;
  using U64 = std::uint64_t;

  static constexpr U16 VERSION = 20, VERSION_OF_ZIP64 = 45; // required of readers
  static constexpr U16 NO_FLAGS = 0, STORED = 0;
  static constexpr U32 NO_TIME = 0x00210000; // the DOS epoch, 1980-01-01
  static constexpr U16 FIRST_DISK = 0;
  static constexpr U16 MAXIMUM_16 = 0xFFFF; // refers to the 64-bit field
  static constexpr U32 MAXIMUM_32 = 0xFFFFFFFF;

  struct Member
  {
    std::string name;
    U64 size;
    U64 offset;
    U32 checksum;
  };

public:
  static constexpr U64 LIMIT = MAXIMUM_32;

  // Tests use lower limits.
  explicit Zip_writer(const std::string& file, const U64 limit = LIMIT)
    : m_file(file), m_limit(limit)
  {
    attempt([&] { m_out.open(file, std::ios::binary); });
  }

  // Begins a member of `size` bytes.
  void begin(const std::string& name, const U64 size)
  {
    m_members.push_back({name, size, m_position, 0});
    m_checksum = Checksum();
    write(local_header(m_members.back()));
    m_end = m_position + size;
  }

  void append(const char* bytes, const std::size_t number)
  {
    m_checksum.add(bytes, number);
    write(bytes, number);
  }

  void append(const std::string& bytes) { append(bytes.data(), bytes.size()); }

  // Ends a member, and writes its checksum to its header.
  void end()
  {
    CGAL_assertion_msg(m_position == m_end, "the size of a member matches its header");
    Member& member = m_members.back();
    member.checksum = m_checksum.value();
    go_to(member.offset);
    write(local_header(member));
    go_to(m_end);
  }

  // Writes the central directory, and closes the file.
  void finish()
  {
    const U64 begin = m_position;
    for(const Member& member : m_members)
      write(directory_entry(member));
    write(end_of_directory(begin, m_position - begin));
    attempt([&] { m_out.close(); });
  }

private:
  bool is_large(const U64 number) const { return number >= m_limit; }

  U32 short_field(const U64 number) const
  {
    return is_large(number) ? MAXIMUM_32 : static_cast<U32>(number);
  }

  // The ZIP64 extra field.
  template <typename... Numbers>
  static std::string long_fields(const Numbers... numbers)
  {
    constexpr U16 kind = 1, size = sizeof...(numbers) * sizeof(U64);
    return packed(kind, size, numbers...);
  }

  std::string long_fields(const Member& member) const
  {
    const bool is_far = is_large(member.offset);
    if(is_large(member.size))
      return is_far ? long_fields(member.size, member.size, member.offset)
                    : long_fields(member.size, member.size);
    return is_far ? long_fields(member.offset) : "";
  }

  // The common fields of a local header and a directory entry.
  std::string description(const Member& member, const std::string& extra) const
  {
    const U32 size = short_field(member.size);
    return packed(extra.empty() ? VERSION : VERSION_OF_ZIP64, NO_FLAGS, STORED, NO_TIME,
                  member.checksum, size, size, static_cast<U16>(member.name.size()),
                  static_cast<U16>(extra.size()));
  }

  std::string local_header(const Member& member) const
  {
    constexpr U32 signature = 0x04034b50;
    const std::string extra =
        is_large(member.size) ? long_fields(member.size, member.size) : std::string();
    return packed(signature) + description(member, extra) + member.name + extra;
  }

  std::string directory_entry(const Member& member) const
  {
    constexpr U32 signature = 0x02014b50, external_attributes = 0;
    constexpr U16 size_of_comment = 0, internal_attributes = 0;
    const std::string extra = long_fields(member);
    return packed(signature, VERSION_OF_ZIP64) + description(member, extra) +
           packed(size_of_comment, FIRST_DISK, internal_attributes, external_attributes,
                  short_field(member.offset)) +
           member.name + extra;
  }

  std::string end_of_directory(const U64 begin, const U64 size) const
  {
    constexpr U32 signature = 0x06054b50;
    constexpr U16 size_of_comment = 0;
    const U64 number = m_members.size();
    const U16 short_number = static_cast<U16>(std::min<U64>(number, MAXIMUM_16));
    const bool needs_64_bits = is_large(begin) || is_large(size) || short_number == MAXIMUM_16;
    return (needs_64_bits ? long_end_of_directory(begin, size, number) : "") +
           packed(signature, FIRST_DISK, FIRST_DISK, short_number, short_number, short_field(size),
                  short_field(begin), size_of_comment);
  }

  // The ZIP64 end of central directory record, and its locator.
  static std::string long_end_of_directory(const U64 begin, const U64 size, const U64 number)
  {
    constexpr U32 signature = 0x06064b50, signature_of_locator = 0x07064b50;
    constexpr U64 size_of_rest = 44;
    constexpr U32 first_disk = FIRST_DISK, number_of_disks = 1;
    return packed(signature, size_of_rest, VERSION_OF_ZIP64, VERSION_OF_ZIP64, first_disk,
                  first_disk, number, number, size, begin) +
           packed(signature_of_locator, first_disk, begin + size, number_of_disks);
  }

  void write(const std::string& bytes) { write(bytes.data(), bytes.size()); }

  void write(const char* bytes, const std::size_t number)
  {
    attempt([&] { m_out.write(bytes, static_cast<std::streamsize>(number)); });
    m_position += number;
  }

  void go_to(const U64 position)
  {
    attempt([&] { m_out.seekp(static_cast<std::streamoff>(position)); });
    m_position = position;
  }

  // Streams do not report the reason of a failure; `errno` may.
  template <typename Step>
  void attempt(const Step& step)
  {
    errno = 0;
    step();
    if(m_out)
      return;
    const std::string reason = errno == 0 ? "" : ": " + std::generic_category().message(errno);
    throw std::runtime_error("Approximate_geodesics: " + m_file + ": cannot be written" + reason);
  }

  std::string m_file;
  U64 m_limit;
  std::ofstream m_out;
  std::vector<Member> m_members;
  Checksum m_checksum; // of the last member
  U64 m_position = 0;
  U64 m_end = 0; // of the last member
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRIX_FILES_INTERNAL_ZIP_WRITER_H
