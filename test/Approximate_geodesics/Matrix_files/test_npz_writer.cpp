// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Csr_writer.h>
#include <CGAL/Approximate_geodesics/Matrix_files/internal/Npz_writer.h>

#include "checks/expect_message.h"
#include "files/Temporary_file.h"
#include "files/npz_reader.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

// Archives of arrays, read back by readers that share no code with the writers.

namespace {

using namespace geodesics_test;
using CGAL::Approximate_geodesics::internal::Csr_writer;
using CGAL::Approximate_geodesics::internal::npy_header;
using CGAL::Approximate_geodesics::internal::npy_type;
using CGAL::Approximate_geodesics::internal::Npz_writer;
using CGAL::Approximate_geodesics::internal::Zip_writer;
using Arrays = std::map<std::string, Npy_array>;

std::string dictionary(const std::string& type, const std::string& shape)
{
  return "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
}

// numbers with all kinds of bytes
template <typename T>
std::vector<T> numbers(const std::size_t size)
{
  using Limits = std::numeric_limits<T>;
  std::vector<T> result(size);
  for(std::size_t i = 0; i < size; ++i)
    result[i] = (i % 2 == 0 ? Limits::max() : Limits::lowest()) / static_cast<T>(i + 1);
  return result;
}

Arrays arrays_in(const Temporary_file& file)
{
  const std::string bytes = file.bytes();
  return arrays_of(Zip_reader(bytes));
}

TEST(Npy_type, is_that_of_numpy)
{
  EXPECT_EQ(npy_type<float>(), "<f4");
  EXPECT_EQ(npy_type<double>(), "<f8");
  EXPECT_EQ(npy_type<std::int32_t>(), "<i4");
  EXPECT_EQ(npy_type<std::int64_t>(), "<i8");
  EXPECT_EQ(npy_type<std::uint32_t>(), "<u4");
}

TEST(Npy_header, says_what_follows)
{
  const std::string f8 = "<f8";
  EXPECT_EQ(Npy_array(npy_header(f8, {})).dictionary, dictionary(f8, "()"));
  EXPECT_EQ(Npy_array(npy_header(f8, {7})).dictionary, dictionary(f8, "(7,)"));
  EXPECT_EQ(Npy_array(npy_header(f8, {0, 5})).dictionary, dictionary(f8, "(0, 5)"));
  const std::uint64_t largest = ~std::uint64_t(0);
  EXPECT_EQ(Npy_array(npy_header(f8, {1, largest, 3})).dictionary,
            dictionary(f8, "(1, 18446744073709551615, 3)"));
}

TEST(Npy_header, is_aligned_whatever_its_length)
{
  for(std::size_t length = 1; length <= 70; ++length)
  {
    const std::string type = "|S" + std::string(length, '1');
    const Npy_array array(npy_header(type, {2})); // sees the alignment
    EXPECT_EQ(array.dictionary, dictionary(type, "(2,)"));
    EXPECT_EQ(array.bytes, "");
  }
}

template <typename T>
class Npz_writer_of : public testing::Test
{
};

using Types = testing::Types<float, double, std::int32_t, std::int64_t, std::uint32_t>;
TYPED_TEST_SUITE(Npz_writer_of, Types, );

TYPED_TEST(Npz_writer_of, writes_what_is_read_back)
{
  const std::vector<std::size_t> sizes = {0, 1, 2, 1023, 1024, 1025, 5000};
  for(const std::uint64_t limit : {Zip_writer::LIMIT, std::uint64_t(4000), std::uint64_t(0)})
  {
    const Temporary_file file;
    Npz_writer writer(file.name(), limit);
    for(const std::size_t size : sizes)
      writer.write("array" + std::to_string(size), numbers<TypeParam>(size));
    writer.finish();
    const Arrays arrays = arrays_in(file);
    EXPECT_EQ(arrays.size(), sizes.size());
    for(const std::size_t size : sizes)
    {
      const Npy_array& array = arrays.at("array" + std::to_string(size));
      EXPECT_EQ(array.numbers<TypeParam>(), numbers<TypeParam>(size));
      EXPECT_EQ(array.dictionary,
                dictionary(npy_type<TypeParam>(), "(" + std::to_string(size) + ",)"));
    }
  }
}

TYPED_TEST(Npz_writer_of, takes_pieces)
{
  const Temporary_file file;
  Npz_writer writer(file.name());
  const std::vector<TypeParam> all = numbers<TypeParam>(6000);
  writer.begin<TypeParam>("array", {2, 3000});
  for(const auto& [begin, end] : {std::pair(0u, 0u), {0, 1}, {1, 1500}, {1500, 6000}, {6000, 6000}})
    writer.append(all.data() + begin, end - begin);
  writer.end();
  writer.finish();
  const Npy_array array = arrays_in(file).at("array");
  EXPECT_EQ(array.numbers<TypeParam>(), all);
  EXPECT_EQ(array.dictionary, dictionary(npy_type<TypeParam>(), "(2, 3000)"));
}

TEST(Npz_writer, converts)
{
  const Temporary_file file;
  Npz_writer writer(file.name());
  const std::vector<std::uint32_t> columns = numbers<std::uint32_t>(1500);
  writer.begin<std::int64_t>("array", {columns.size()});
  writer.append_as<std::int64_t>(columns.data(), columns.size());
  writer.end();
  writer.finish();
  EXPECT_EQ(arrays_in(file).at("array").numbers<std::int64_t>(),
            std::vector<std::int64_t>(columns.begin(), columns.end()));
}

TEST(Npz_writer, writes_an_archive_without_members)
{
  const Temporary_file file;
  Npz_writer(file.name()).finish();
  EXPECT_EQ(arrays_in(file).size(), 0u);
}

TEST(Npz_writer, writes_the_same_file_again)
{
  const Temporary_file first, second;
  for(const Temporary_file* file : {&first, &second, &second}) // the last over another one
  {
    Npz_writer writer(file->name());
    writer.write("numbers", numbers<double>(100));
    writer.write_text("text", "of some bytes");
    writer.finish();
  }
  EXPECT_EQ(first.bytes(), second.bytes());
}

// Each field is one of 64 bits exactly if the number in it is not below the limit.
TEST(Npz_writer, uses_64_bits_only_where_needed)
{
  std::size_t number_of_long_ends = 0, number_of_long_members = 0;
  for(std::uint64_t limit = 0; limit < 2000; ++limit)
  {
    const Temporary_file file;
    Npz_writer writer(file.name(), limit);
    writer.write("small", numbers<float>(3));
    writer.write("large", numbers<float>(200));
    writer.write_text("text", "abc");
    writer.finish();
    const std::string bytes = file.bytes();
    const Zip_reader archive(bytes);
    for(const Zip_member& member : archive.members())
    {
      EXPECT_EQ(member.is_long, member.bytes.size() >= limit) << member.name << ", " << limit;
      number_of_long_members += member.is_long;
    }
    EXPECT_EQ(archive.members().size(), 3u);
    EXPECT_EQ(archive.has_long_end(), archive.begin_of_directory() >= limit) << limit;
    number_of_long_ends += archive.has_long_end();
  }
  EXPECT_GT(number_of_long_members, 0u);
  EXPECT_GT(number_of_long_ends, 0u);
}

TEST(Npz_writer, counts_more_members_than_16_bits_do)
{
  for(const std::size_t number : {65534u, 65535u, 65536u})
  {
    const Temporary_file file;
    Npz_writer writer(file.name());
    for(std::size_t i = 0; i < number; ++i)
      writer.write_text(std::to_string(i), "x");
    writer.finish();
    const std::string bytes = file.bytes();
    const Zip_reader archive(bytes);
    EXPECT_EQ(archive.members().size(), number);
    EXPECT_EQ(archive.has_long_end(), number >= 65535);
  }
}

TEST(Npz_writer, tells_what_it_cannot_open)
{
  const Temporary_file file;
  const std::string name = (std::filesystem::path(file.name()) / "array.npz").string();
  const std::string reason = std::generic_category().message(ENOENT);
  expect_message<std::runtime_error>([&] { Npz_writer writer(name); },
                                     name + ": cannot be written: " + reason);
}

#ifdef __linux__
TEST(Npz_writer, tells_that_the_disk_is_full)
{
  const std::string message =
      "/dev/full: cannot be written: " + std::generic_category().message(ENOSPC);
  expect_message<std::runtime_error>([&] { Npz_writer("/dev/full").finish(); }, message);
  expect_message<std::runtime_error>(
      [&] { Npz_writer("/dev/full").write("small", numbers<double>(1)); }, message);
  expect_message<std::runtime_error>(
      [&] {
        Npz_writer writer("/dev/full");
        writer.begin<double>("large", {100000});
        writer.append(numbers<double>(10000).data(), 10000);
      },
      message);
}
#endif

// rows of 2, 0 and 3 entries
struct Sparse_matrix
{
  std::uint64_t columns;
  std::vector<std::uint32_t> lengths = {2, 0, 3};
  std::vector<std::uint32_t> indices = {1, 4, 0, 2, 5};
  std::vector<float> values = {0.5f, 1.5f, 2.5f, 3.5f, 4.5f};
  std::vector<std::int64_t> ends = {0, 2, 2, 5};

  void write_columns(Csr_writer& writer) const
  {
    writer.begin_columns();
    for(const std::uint32_t& index : indices)
      writer.append_columns(&index, 1);
  }

  void write_rows(Csr_writer& writer) const
  {
    writer.begin_rows();
    writer.append_rows(lengths.data(), 1);
    writer.append_rows(lengths.data() + 1, lengths.size() - 1);
  }

  void write_values(Csr_writer& writer) const
  {
    writer.begin_values<float>();
    writer.append_values(values.data(), 2);
    writer.append_values(values.data() + 2, values.size() - 2);
  }

  template <typename Index>
  void expect_in(const Arrays& arrays) const
  {
    const std::string type = npy_type<Index>();
    EXPECT_EQ(arrays.at("indptr").dictionary, dictionary(type, "(4,)"));
    EXPECT_EQ(arrays.at("indptr").numbers<Index>(), std::vector<Index>(ends.begin(), ends.end()));
    EXPECT_EQ(arrays.at("indices").dictionary, dictionary(type, "(5,)"));
    EXPECT_EQ(arrays.at("indices").numbers<Index>(),
              std::vector<Index>(indices.begin(), indices.end()));
    EXPECT_EQ(arrays.at("data").dictionary, dictionary("<f4", "(5,)"));
    EXPECT_EQ(arrays.at("data").numbers<float>(), values);
    EXPECT_EQ(arrays.at("shape").dictionary, dictionary("<i8", "(2,)"));
    EXPECT_EQ(arrays.at("shape").numbers<std::int64_t>(),
              (std::vector<std::int64_t>{3, std::int64_t(columns)}));
    EXPECT_EQ(arrays.at("format").dictionary, dictionary("|S3", "()"));
    EXPECT_EQ(arrays.at("format").bytes, "csr");
    EXPECT_EQ(arrays.size(), 5u);
  }
};

TEST(Csr_writer, writes_rows_first_or_last)
{
  const Sparse_matrix matrix{6};
  for(const bool are_rows_first : {true, false})
  {
    const Temporary_file file;
    Csr_writer writer(file.name(), {3, matrix.columns, 5});
    if(are_rows_first)
      matrix.write_rows(writer);
    matrix.write_columns(writer);
    matrix.write_values(writer);
    if(!are_rows_first)
      matrix.write_rows(writer);
    writer.finish();
    matrix.expect_in<std::int32_t>(arrays_in(file));
  }
}

TEST(Csr_writer, has_indices_of_64_bits_for_many_columns)
{
  constexpr std::uint64_t largest = 0x7FFFFFFF;
  for(const std::uint64_t columns : {largest, largest + 1})
  {
    const Sparse_matrix matrix{columns};
    const Temporary_file file;
    Csr_writer writer(file.name(), {3, columns, 5});
    matrix.write_rows(writer);
    matrix.write_columns(writer);
    matrix.write_values(writer);
    writer.finish();
    if(columns == largest)
      matrix.expect_in<std::int32_t>(arrays_in(file));
    else
      matrix.expect_in<std::int64_t>(arrays_in(file));
  }
}

TEST(Csr_writer, writes_a_matrix_without_rows)
{
  const Temporary_file file;
  Csr_writer writer(file.name(), {0, 0, 0});
  writer.begin_rows();
  writer.begin_columns();
  writer.begin_values<double>();
  writer.finish();
  const Arrays arrays = arrays_in(file);
  EXPECT_EQ(arrays.at("indptr").numbers<std::int32_t>(), std::vector<std::int32_t>{0});
  EXPECT_EQ(arrays.at("indices").bytes, "");
  EXPECT_EQ(arrays.at("data").dictionary, dictionary("<f8", "(0,)"));
  EXPECT_EQ(arrays.at("shape").numbers<std::int64_t>(), (std::vector<std::int64_t>{0, 0}));
}

} // namespace
