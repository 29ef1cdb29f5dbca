#ifndef COMMAND_LINE_OLD_FILE_H
#define COMMAND_LINE_OLD_FILE_H

#include "files.h"

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

// A file that shall go. It is put aside, under another name in the same folder, and goes with the
// object unless it is taken back. A device or a pipe stays.
class Old_file
{
  using Path = std::filesystem::path;

public:
  explicit Old_file(std::string name) : m_name(std::move(name)) {}

  Old_file(Old_file&& other) noexcept
    : m_name(std::move(other.m_name)), m_aside(std::exchange(other.m_aside, Path()))
  {
  }

  Old_file& operator=(Old_file&&) = delete;

  ~Old_file()
  {
    std::error_code ignored;
    if(!m_aside.empty())
      std::filesystem::remove(m_aside, ignored);
  }

  void put_aside()
  {
    if(!std::filesystem::is_regular_file(m_name))
      return;
    Path aside;
    for(int i = 0; aside.empty() || std::filesystem::exists(aside); ++i)
      aside = m_name + ".old" + std::to_string(i);
    std::error_code error;
    std::filesystem::rename(m_name, aside, error);
    if(error)
      fail_to("remove", m_name, error.value());
    m_aside = std::move(aside);
  }

  // Undoes that.
  void take_back() noexcept
  {
    std::error_code ignored;
    if(!m_aside.empty())
      std::filesystem::rename(m_aside, m_name, ignored);
    m_aside.clear();
  }

private:
  std::string m_name;
  Path m_aside; // none unless it is there
};

#endif // COMMAND_LINE_OLD_FILE_H
