// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_file.h>

#include "files.h"

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <algorithm>
#include <exception>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {
namespace {

namespace fs = std::filesystem;

std::string text_of(const Matrix_identity& identity)
{
  std::string result = "Unfinished distance matrix of Approximate_geodesics, version 3\n";
  for(const std::uint64_t part : identity.parts)
    result += std::to_string(part) + '\n';
  return result;
}

// The numbers that a text lacks are zero.
Matrix_identity identity_of(const std::string& text)
{
  Matrix_identity result;
  std::istringstream in(text.substr((std::min)(text.size(), text.find('\n'))));
  for(std::uint64_t& part : result.parts)
    in >> part;
  return result;
}

// Follows symbolic links to a file that does not exist yet: FILE.part has to be in its folder.
fs::path target_of(fs::path file)
{
  constexpr int most_links = 40;
  std::error_code ignored;
  for(int i = 0; fs::is_symlink(file, ignored) && !fs::exists(file, ignored); ++i)
  {
    if(i == most_links)
      reject(file.string() + " is one of a cycle of symbolic links");
    file = file.parent_path() / fs::read_symlink(file);
  }
  return file;
}

// The names in a folder. It is listed anew, while a network file system may remember that a file
// did not exist.
std::set<std::string> names_in(const fs::path& folder)
{
  std::set<std::string> result;
  for(const fs::directory_entry& entry : fs::directory_iterator(folder))
    result.insert(entry.path().filename().string());
  return result;
}

} // namespace

Matrix_file::Matrix_file(Path file, Process_team* const team)
  : m_file(target_of(file.has_filename() ? std::move(file) : file.parent_path())),
    m_part(with_suffix(".part")),
    m_own_team(team == nullptr ? std::make_unique<Single_process>() : nullptr),
    m_team(team == nullptr ? m_own_team.get() : team)
{
}

Matrix_file::Path Matrix_file::with_suffix(const char* const suffix) const
{
  Path result = m_file;
  return result += suffix;
}

void Matrix_file::start(const Distance_matrix_plan& plan,
                        const std::uint64_t kind,
                        const std::uint64_t bytes_per_row)
{
  m_plan = &plan;
  m_identity = Matrix_identity(plan.facts());
  m_identity.parts[Matrix_identity::KIND] = kind;
  // markers have the numbers of blocks, whose size depends on the version, too
  m_identity.parts[Matrix_identity::DISTANCES] |= std::uint64_t(plan.rows_per_block()) << 32;
  std::vector<std::uint64_t> missing;
  on_first([&] { missing = find_missing(bytes_per_row); });
  m_team->share(missing);
  check_team();
  m_missing = std::move(missing);
  m_rows_before = plan.number_of_rows() - number_of_rows(m_missing);
  m_rows_done = m_rows_before;
  m_team->restart_tickets();
}

std::optional<std::size_t> Matrix_file::next_block()
{
  const std::uint64_t ticket = m_team->next_ticket();
  // Blocks with lower tickets are complete, or in progress elsewhere.
  if(m_team->size() > 1)
    m_rows_done = (std::min)(m_plan->number_of_rows(),
                             m_rows_before + std::size_t(ticket) * m_plan->rows_per_block());
  if(ticket >= m_missing.size())
    return std::nullopt;
  return static_cast<std::size_t>(m_missing[ticket]);
}

void Matrix_file::mark(const std::size_t block, const std::string& contents_of_marker)
{
  write_file(marker(block), contents_of_marker);
  if(m_team->size() == 1)
    m_rows_done += m_plan->rows_of_block(block).size();
}

bool Matrix_file::finish()
{
  close();
  m_team->wait();
  std::vector<std::uint64_t> is_complete{0};
  on_first([&] {
    if(!m_was_complete && !is_being_changed() && !are_all_blocks_marked())
      return;
    if(!m_was_complete)
    {
      check_is_not_there(); // it may have been created meanwhile
      complete();
      sync_to_disk(result()); // if it is a folder, its files are on disk, but maybe not their names
      check_is_not_there();   // completing takes a while, too
      fs::rename(result(), m_file);
      sync_to_disk(folder().string()); // before the markers are removed
    }
    remove_part();
    is_complete[0] = 1;
  });
  m_lock.reset();
  m_team->share(is_complete);
  return is_complete[0] != 0;
}

// Calls `f()` in process 0. If it throws there, all processes throw.
template <typename F>
void Matrix_file::on_first(const F& f)
{
  std::exception_ptr error;
  std::string message;
  if(m_team->rank() == 0)
    try
    {
      f();
    }
    catch(const std::exception& e)
    {
      error = std::current_exception();
      message = e.what();
      m_lock.reset(); // the computation has failed
    }
  m_team->share(message);
  if(error)
    std::rethrow_exception(error);
  if(!message.empty())
    throw std::runtime_error(message);
}

std::vector<std::uint64_t> Matrix_file::find_missing(const std::uint64_t bytes_per_row)
{
  if(m_file.empty())
    reject("the name of a matrix file is empty");
  if(!fs::is_directory(folder()))
    reject("there is no folder " + folder().string());
  m_lock.reset(); // left by a failed computation
  m_lock = lock_file(with_suffix(".lock").string(), m_file.string());
  const bool is_begun = has_part();
  if(is_begun)
    check_identity();
  m_was_complete = is_begun && fs::exists(m_file) && !fs::exists(result());
  if(m_was_complete)
    return {};
  check_is_not_there();
  if(!is_begun)
  {
    check_space(m_plan->number_of_rows() * bytes_per_row);
    create_part();
  }
  if(is_being_changed())
    return {};
  prepare_result(result());
  std::vector<std::uint64_t> missing = missing_blocks();
  check_space(number_of_rows(missing) * bytes_per_row);
  return missing;
}

// Removes markers that do not match, as `finish()` trusts them.
std::vector<std::uint64_t> Matrix_file::missing_blocks() const
{
  const std::set<std::string> names = names_in(m_part);
  std::vector<std::uint64_t> result;
  for(std::size_t block = 0; block < m_plan->number_of_blocks(); ++block)
  {
    const bool is_marked = names.count(std::to_string(block)) > 0;
    if(is_marked && is_intact(block))
      continue;
    if(is_marked)
      fs::remove(marker(block));
    result.push_back(block);
  }
  return result;
}

// On a network file system, the list of names may be outdated, and lack files that other machines
// have written since. So a file that it lacks is looked up by its name.
bool Matrix_file::are_all_blocks_marked() const
{
  const std::set<std::string> names = names_in(m_part);
  std::size_t block = 0;
  while(block < m_plan->number_of_blocks() &&
        (names.count(std::to_string(block)) > 0 || fs::exists(marker(block))))
    ++block;
  return block == m_plan->number_of_blocks();
}

// Returns whether there is a part folder with an identity. A program that was killed when it
// created or removed the folder leaves an empty one, or one with a new identity.
bool Matrix_file::has_part() const
{
  if(fs::exists(in_part("identity")))
    return true;
  const bool can_be_removed = fs::is_directory(m_part)
                                  ? fs::is_empty(m_part) || fs::exists(in_part("identity.new"))
                                  : !fs::exists(m_part);
  if(!can_be_removed)
    reject(m_part.string() + " exists, but is not an unfinished distance matrix; delete it, or " +
           "choose another name");
  fs::remove_all(m_part);
  return false;
}

void Matrix_file::create_part() const
{
  create_folder(m_part.string());
  write_file(in_part("identity.new"), text_of(m_identity));
  prepare_result(result());
  sync_to_disk(in_part("identity.new"));
  fs::rename(in_part("identity.new"), in_part("identity"));
}

void Matrix_file::check_identity() const
{
  const std::string name = in_part("identity"), text = read_file(name),
                    expected = text_of(m_identity);
  if(text == expected)
    return;
  const std::size_t end = expected.find('\n');
  if(text.compare(0, end + 1, expected, 0, end + 1) != 0)
    reject(name + " was not written by this version of the program" + remedy());
  const Matrix_identity other = identity_of(text);
  for(std::size_t part = 0; part < other.parts.size(); ++part)
    if(m_identity.parts[part] != other.parts[part])
      reject(m_part.string() + " belongs to a computation with " +
             other.difference(part, m_identity) + remedy());
  reject(name + " is damaged" + remedy());
}

std::string Matrix_file::remedy() const { return "; delete " + m_part.string() + " to restart"; }

void Matrix_file::check_is_not_there() const
{
  if(fs::exists(m_file))
    reject(m_file.string() + " already exists; remove it, or choose another name");
}

void Matrix_file::check_space(const std::uint64_t bytes) const
{
  const std::uint64_t available = fs::space(folder()).available;
  if(bytes > available)
    throw std::runtime_error("Approximate_geodesics: " + m_file.string() + " needs " +
                             std::to_string(bytes >> 20) + " MB more, but its disk has only " +
                             std::to_string(available >> 20) + " MB left");
}

// Checks that all processes have identical input; otherwise the result depends on scheduling.
void Matrix_file::check_team()
{
  std::vector<std::uint64_t> first(m_identity.parts.begin(), m_identity.parts.end());
  m_team->share(first);
  for(std::size_t part = 0; part < first.size(); ++part)
    if(m_identity.parts[part] != first[part])
      reject("process 0 of the team has " + std::string(Matrix_identity::name(part)) +
             " than process " + std::to_string(m_team->rank()));
}

// Removes the identity last.
void Matrix_file::remove_part() const
{
  for(const fs::directory_entry& entry : fs::directory_iterator(m_part))
    if(entry.path().filename() != "identity")
      fs::remove_all(entry.path());
  fs::remove_all(m_part);
}

std::size_t Matrix_file::number_of_rows(const std::vector<std::uint64_t>& blocks) const
{
  std::size_t result = 0;
  for(const std::uint64_t block : blocks)
    result += m_plan->rows_of_block(static_cast<std::size_t>(block)).size();
  return result;
}

Matrix_file::Path Matrix_file::folder() const
{
  return m_file.has_parent_path() ? m_file.parent_path() : ".";
}

} // namespace CGAL::Approximate_geodesics::internal
