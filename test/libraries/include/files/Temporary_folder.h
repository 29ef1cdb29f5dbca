// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_TEMPORARY_FOLDER_H
#define APPROXIMATE_GEODESICS_TEST_TEMPORARY_FOLDER_H

#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <system_error>

namespace geodesics_test {

inline std::string bytes_of(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// A folder of our own, with blanks in its name, which is gone at the end.
class Temporary_folder
{
public:
  // the bytes of files by their names, which end with a slash for folders without files
  using Contents = std::map<std::string, std::string>;

  explicit Temporary_folder(const std::filesystem::path& parent = in_memory())
    : m_path(parent / ("approximate geodesics " + std::to_string(std::random_device()()) +
                       std::to_string(std::random_device()())))
  {
    std::filesystem::create_directory(m_path);
  }

  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  std::string name() const { return m_path.string(); }
  std::string file(const std::string& name) const { return (m_path / name).string(); }
  std::string bytes(const std::string& name) const { return bytes_of(m_path / name); }
  bool has(const std::string& name) const { return std::filesystem::exists(m_path / name); }

  Contents contents() const
  {
    Contents result;
    for(const auto& entry : std::filesystem::recursive_directory_iterator(m_path))
    {
      const std::string name = std::filesystem::relative(entry.path(), m_path).string();
      if(!entry.is_directory())
        result[name] = bytes_of(entry.path());
      else if(std::filesystem::is_empty(entry.path()))
        result[name + '/'];
    }
    return result;
  }

  // Replaces all files.
  void fill(const Contents& contents) const
  {
    for(const auto& entry : std::filesystem::directory_iterator(m_path))
      std::filesystem::remove_all(entry.path());
    for(const auto& [name, bytes] : contents)
    {
      std::filesystem::create_directories((m_path / name).parent_path());
      if(name.back() != '/')
        std::ofstream(m_path / name, std::ios::binary) << bytes;
    }
  }

private:
  // where nobody waits for a disk, if there is such a place
  static std::filesystem::path in_memory()
  {
    const std::filesystem::path shared_memory = "/dev/shm";
    std::error_code error;
    const auto space = std::filesystem::space(shared_memory, error);
    return !error && space.available > (50u << 20) ? shared_memory
                                                   : std::filesystem::temp_directory_path();
  }

  std::filesystem::path m_path;
};

// Changes the current folder meanwhile.
class Current_folder
{
public:
  explicit Current_folder(const std::string& name) { std::filesystem::current_path(name); }
  ~Current_folder() { std::filesystem::current_path(m_before); }

private:
  std::filesystem::path m_before = std::filesystem::current_path();
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_TEMPORARY_FOLDER_H
