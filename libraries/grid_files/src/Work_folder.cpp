// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Grid_files/internal/Work_folder.h>

#include "fail_to.h"

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <boost/interprocess/exceptions.hpp>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace CGAL::Approximate_geodesics::internal {
namespace {

namespace fs = std::filesystem;

std::string contents(const std::string& name)
{
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::string& name, const std::string& text)
{
  errno = 0;
  std::ofstream out(name, std::ios::binary);
  out << text;
  out.close();
  if(!out)
    fail_to("written", name);
}

// What identifies the boot of the machine; empty where nothing does.
std::string boot() { return contents("/proc/sys/kernel/random/boot_id"); }

} // namespace

Work_folder::Work_folder(const std::string& name) : m_name(name)
{
  if(name.empty())
    return;
  std::error_code error;
  fs::create_directories(name, error);
  errno = error.value();
  if(error)
    fail_to("created", name);
  if(!fs::exists(file("lock")))
    write(file("lock"), "");
  try
  {
    boost::interprocess::file_lock(file("lock").c_str()).swap(m_lock);
    if(!m_lock.try_lock())
      reject("another process works in " + name);
  }
  catch(const boost::interprocess::interprocess_exception& e)
  {
    errno = e.get_native_error();
    fail_to("locked", file("lock"));
  }
}

std::string Work_folder::file(const std::string& name) const
{
  return m_name.empty() ? "" : (fs::path(m_name) / name).string();
}

bool Work_folder::has_begun(const std::string& task) const
{
  if(m_name.empty() || !fs::exists(file("task")))
    return false;
  const std::string found = contents(file("task"));
  if(found != task)
    reject(m_name + " has files of another task; delete it, or choose another folder\nthere:\n" +
           found + "here:\n" + task);
  return true;
}

bool Work_folder::is_intact() const { return !boot().empty() && contents(file("boot")) == boot(); }

void Work_folder::begin(const std::string& task) const
{
  if(m_name.empty())
    return;
  write(file("boot"), boot());
  write(file("task.new"), task);
  fs::rename(file("task.new"), file("task"));
}

void Work_folder::clear() const
{
  if(m_name.empty())
    return;
  std::error_code ignored; // what is left does no harm
  for(const char* const name : {"task", "task.new", "boot", "labels", "predecessors", "lock"})
    fs::remove(file(name), ignored);
  fs::remove(m_name, ignored); // succeeds if it is empty
}

} // namespace CGAL::Approximate_geodesics::internal
