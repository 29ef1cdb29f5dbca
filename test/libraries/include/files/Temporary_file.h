// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_TEMPORARY_FILE_H
#define APPROXIMATE_GEODESICS_TEST_TEMPORARY_FILE_H

#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <random>
#include <string>
#include <system_error>

namespace geodesics_test {

// The name of a file of our own, which is gone at the end.
class Temporary_file
{
public:
  Temporary_file()
    : m_path(std::filesystem::temp_directory_path() /
             ("approximate_geodesics_" + std::to_string(std::random_device()()) +
              std::to_string(std::random_device()())))
  {
  }

  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  ~Temporary_file()
  {
    std::error_code ignored;
    std::filesystem::remove(m_path, ignored);
  }

  std::string name() const { return m_path.string(); }

  std::string bytes() const
  {
    std::ifstream in(m_path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

private:
  std::filesystem::path m_path;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_TEMPORARY_FILE_H
