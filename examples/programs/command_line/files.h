#ifndef COMMAND_LINE_FILES_H
#define COMMAND_LINE_FILES_H

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <stdexcept>
#include <string>

// Files that cannot be opened are refused with the reason that the system has.

[[noreturn]] inline void fail_to(const std::string& verb, const std::string& file, const int error)
{
  throw std::runtime_error("cannot " + verb + ' ' + file +
                           (error != 0 ? std::string(": ") + std::strerror(error) : ""));
}

inline std::ifstream open_to_read(const std::string& file,
                                  const std::ios::openmode mode = std::ios::in)
{
  errno = 0;
  std::ifstream in(file, mode);
  if(std::filesystem::is_directory(file))
    throw std::invalid_argument("cannot read " + file + ": it is a folder");
  if(!in)
    throw std::invalid_argument("cannot read " + file + ": " + std::strerror(errno));
  return in;
}

inline void check_readable(const std::string& file) { open_to_read(file); }

#endif // COMMAND_LINE_FILES_H
