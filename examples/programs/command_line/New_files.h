#ifndef COMMAND_LINE_NEW_FILES_H
#define COMMAND_LINE_NEW_FILES_H

#include "Ignored_signal.h"
#include "Interruption.h"
#include "New_file.h"
#include "Old_file.h"

#include <cerrno>
#include <csignal>
#include <fstream>
#include <ios>
#include <string>
#include <vector>

// Files that are written together: all of them, or none. They take their names when all are
// complete, and those of an earlier run go then, which would pass for some of this one. If one
// cannot be written, or the user interrupts that, everything stays as it was.
class New_files
{
public:
  // `replaces` tells whether what has the names may be replaced.
  explicit New_files(const bool replaces) : m_replaces(replaces) {}

  // Adds an empty file. Returns the name that it has until it is complete.
  std::string add(const std::string& name)
  {
    Interruption::check();
    m_files.emplace_back(name);
    return m_files.back().place();
  }

  // Adds a file that `f(out)` writes. Returns the same.
  template <typename F>
  std::string write(const std::string& name, F f)
  {
    const std::string place = add(name);
    errno = 0;
    try
    {
      std::ofstream out;
      out.exceptions(std::ios::badbit | std::ios::failbit); // when the reason is still known
      out.open(place, std::ios::binary);
      out.precision(17);
      f(out);
      out.close(); // what was written may still be in memory
    }
    catch(const std::ios_base::failure&)
    {
      fail_to("write", name, errno);
    }
    return place;
  }

  // Adds a file that shall go, if it is there and no device.
  void remove(const std::string& name) { m_old_files.emplace_back(name); }

  void put_in_place()
  {
    Interruption::check();
    auto file = m_files.begin();
    auto old_file = m_old_files.begin();
    try
    {
      for(; old_file != m_old_files.end(); ++old_file)
        old_file->put_aside();
      for(; file != m_files.end(); ++file)
        file->put_in_place(m_replaces);
    }
    catch(...)
    {
      while(file != m_files.begin())
        (--file)->take_back();
      while(old_file != m_old_files.begin())
        (--old_file)->take_back();
      throw;
    }
    m_files.clear();
    m_old_files.clear();
  }

private:
  Interruption m_interruption;
  Ignored_signal m_broken_pipe{SIGPIPE};
  Ignored_signal m_file_too_large{SIGXFSZ};
  bool m_replaces;
  std::vector<Old_file> m_old_files;
  std::vector<New_file> m_files; // goes first
};

#endif // COMMAND_LINE_NEW_FILES_H
