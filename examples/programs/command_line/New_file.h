#ifndef COMMAND_LINE_NEW_FILE_H
#define COMMAND_LINE_NEW_FILE_H

#include "files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

// A file that is written beside its name, in the same folder, and takes that name when it is
// complete. Until then, what has the name stays as it is. If the file is not completed, it goes.
//
// A link is followed, and what it points to is replaced. A device or a pipe cannot be replaced, and
// is written to at once.
class New_file
{
  using Path = std::filesystem::path;

public:
  // Makes an empty file, which may be written to under the name `place()`.
  explicit New_file(const std::string& name)
    : m_name(name), m_target(is_special(name) ? Path(name) : behind_links(name))
  {
    if(is_special(name))
      m_place = m_target;
    else
      make();
  }

  New_file(New_file&& other) noexcept
    : m_name(std::move(other.m_name)),
      m_target(std::move(other.m_target)),
      m_place(std::exchange(other.m_place, Path())),
      m_backup(std::exchange(other.m_backup, Path())),
      m_has_replaced(other.m_has_replaced)
  {
  }

  New_file& operator=(New_file&&) = delete;

  ~New_file()
  {
    std::error_code ignored;
    if(!m_place.empty() && m_place != m_target)
      std::filesystem::remove(m_place, ignored);
    if(!m_backup.empty())
      std::filesystem::remove(m_backup, ignored);
  }

  const std::string& name() const { return m_name; }
  std::string place() const { return m_place.string(); }

  // Refuses what could not be written, without changing what is there.
  static void check(const std::string& name)
  {
    if(std::filesystem::is_directory(name))
      fail_to("write", name, EISDIR);
    if(std::filesystem::exists(name) && ::access(name.c_str(), W_OK) != 0)
      fail_to("write", name, errno);
    const New_file trial(name);
  }

  // Gives the file its name, and replaces what has it, if it may.
  void put_in_place(const bool replaces)
  {
    if(m_place == m_target)
      return;
    m_has_replaced = replaces && std::filesystem::exists(m_target);
    if(m_has_replaced)
      keep_backup();
    else if(::link(m_place.c_str(), m_target.c_str()) == 0) // which replaces nothing
    {
      std::remove(m_place.c_str());
      m_place.clear();
      return;
    }
    else if(std::filesystem::exists(m_target)) // or else the file system has no links
      throw std::runtime_error("cannot write " + m_name + ": it has come to exist meanwhile");
    if(std::rename(m_place.c_str(), m_target.c_str()) != 0)
    {
      const int error = errno;
      restore();
      fail_to("write", m_name, error);
    }
    m_place.clear();
  }

  // Undoes that.
  void take_back() noexcept
  {
    if(!m_place.empty())
      return;
    if(!m_has_replaced)
      std::remove(m_target.c_str());
    else
      restore();
  }

private:
  static bool is_special(const std::string& name)
  {
    return std::filesystem::exists(name) && !std::filesystem::is_regular_file(name);
  }

  static Path behind_links(Path name)
  {
    for(int i = 0; i < 40 && std::filesystem::is_symlink(name); ++i) // a circle is found later
      name = name.parent_path() / std::filesystem::read_symlink(name);
    return name;
  }

  // Calls `f(name)` with names beside that of the file until it is not told that one is taken.
  template <typename F>
  Path find_name(const std::string& ending, F f) const
  {
    for(int i = 0;; ++i)
    {
      Path result = m_target;
      result += ending + std::to_string(i);
      if(f(result.c_str()))
        return result;
      if(errno != EEXIST)
        return Path();
    }
  }

  void make()
  {
    m_place = find_name(".new", [](const char* const name) {
      std::FILE* const file = std::fopen(name, "wx");
      return file != nullptr && std::fclose(file) == 0;
    });
    if(m_place.empty())
      fail_to("write", m_name, errno);
    std::error_code ignored; // who may read what was there may read what replaces it
    if(std::filesystem::exists(m_target))
      std::filesystem::permissions(m_place, std::filesystem::status(m_target).permissions(),
                                   ignored);
  }

  // Makes another link to what is replaced; or renames it, if the file system has no links.
  void keep_backup()
  {
    m_backup = find_name(
        ".old", [&](const char* const name) { return ::link(m_target.c_str(), name) == 0; });
    if(m_backup.empty() && std::filesystem::is_regular_file(m_target))
      m_backup = find_name(".old", [&](const char* const name) {
        const bool is_taken = std::filesystem::exists(name);
        const bool is_renamed = !is_taken && std::rename(m_target.c_str(), name) == 0;
        errno = is_taken ? EEXIST : errno;
        return is_renamed;
      });
  }

  void restore() noexcept
  {
    if(!m_backup.empty() && std::rename(m_backup.c_str(), m_target.c_str()) == 0)
      std::remove(m_backup.c_str()); // another link to the same file is not renamed
    m_backup.clear();                // or else it stays, under its other name
  }

  std::string m_name;
  Path m_target;
  Path m_place;  // none when it is in place
  Path m_backup; // of what was replaced
  bool m_has_replaced = false;
};

#endif // COMMAND_LINE_NEW_FILE_H
