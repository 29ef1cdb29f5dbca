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

inline std::ofstream open_to_write(const std::string& file,
                                   const std::ios::openmode mode = std::ios::out)
{
  errno = 0;
  std::ofstream out(file, mode);
  if(!out)
    throw std::runtime_error("cannot write " + file + ": " + std::strerror(errno));
  out.precision(17);
  return out;
}

// What was written may still be in memory.
inline void finish(std::ofstream& out, const std::string& file)
{
  errno = 0;
  if(!out.flush())
    throw std::runtime_error("cannot write " + file +
                             (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
}

// Tries to write a file, without changing what is there.
inline void check_writable(const std::string& file)
{
  const bool is_new = !std::filesystem::exists(file);
  open_to_write(file, std::ios::app);
  if(is_new)
    std::filesystem::remove(file);
}

#endif // COMMAND_LINE_FILES_H
