// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/Npy_file.h>

#include "files.h"
#include "formats.h"

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>

#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>

#include <filesystem>

namespace CGAL::Approximate_geodesics {
namespace {

namespace fs = std::filesystem;
namespace ip = boost::interprocess;

ip::mapped_region mapped(const std::string& file, const ip::mode_t mode)
{
  return ip::mapped_region(ip::file_mapping(file.c_str(), mode), mode);
}

} // namespace

template <typename T>
std::string Npy_file<T>::header(const std::size_t number_of_rows,
                                const std::size_t number_of_columns)
{
  return internal::npy_header(internal::npy_type<T>(), {number_of_rows, number_of_columns});
}

template <typename T>
void Npy_file<T>::start(const Distance_matrix_plan& plan)
{
  m_first = header(plan.number_of_rows(), plan.number_of_columns()).size();
  m_length_of_row = std::uint64_t(sizeof(T)) * plan.number_of_columns();
  Matrix_file::start(plan, sizeof(T) + (plan.is_symmetric() ? 16 : 0), m_length_of_row);
  if(is_anything_missing())
    m_data = team().open(result());
}

template <typename T>
void Npy_file<T>::collect(Block& block, std::size_t /* row */, const Distance_row& distances) const
{
  block.reserve(distances.size() * plan().rows_per_block());
  for(const double distance : distances)
    block.push_back(static_cast<T>(distance));
}

template <typename T>
void Npy_file<T>::add(const std::size_t number, Block& block)
{
  const char* bytes = reinterpret_cast<const char*>(block.data());
  internal::Fletcher_checksum checksum(number);
  checksum.add(bytes, block.size() * sizeof(T));
  for(const std::size_t row : plan().rows_of_block(number))
  {
    m_data->write(offset(row), bytes, m_length_of_row);
    bytes += m_length_of_row;
  }
  mark(number, checksum.bytes());
  block.clear();
}

template <typename T>
void Npy_file<T>::prepare_result(const std::string& name) const
{
  if(!fs::exists(name))
    internal::write_file(name, "");
  internal::resize_file(name, length());
}

template <typename T>
bool Npy_file<T>::is_intact(const std::size_t block) const
{
  const ip::mapped_region data = mapped(result(), ip::read_only);
  internal::Fletcher_checksum checksum(block);
  for(const std::size_t row : plan().rows_of_block(block))
    checksum.add(static_cast<const char*>(data.get_address()) + offset(row), m_length_of_row);
  return checksum.bytes() == internal::read_file(marker(block));
}

// The checksums become invalid when symmetrization begins, so only the length can be checked.
template <typename T>
bool Npy_file<T>::is_being_changed() const
{
  if(!fs::exists(in_part("symmetric")))
    return false;
  if(!fs::exists(result()) || fs::file_size(result()) != length())
    internal::reject(result() + " is missing or has the wrong length" + remedy());
  return true;
}

template <typename T>
void Npy_file<T>::close()
{
  if(m_data)
    m_data->sync();
  m_data.reset();
}

// Writes the header last, because no checksum covers it.
template <typename T>
void Npy_file<T>::complete()
{
  internal::sync_to_disk(result()); // blocks of earlier runs must be on disk, too
  if(plan().is_symmetric())
  {
    constexpr std::size_t distances_per_page = 4096 / sizeof(T);
    internal::write_file(in_part("symmetric"), "");
    const ip::mapped_region data = mapped(result(), ip::read_write);
    internal::make_symmetric(reinterpret_cast<T*>(static_cast<char*>(data.get_address()) + m_first),
                             plan().number_of_columns(), distances_per_page);
  }
  const std::string text = header(plan().number_of_rows(), plan().number_of_columns());
  internal::Local_file file(result());
  file.write(0, text.data(), text.size());
  file.sync();
}

template class Npy_file<double>;
template class Npy_file<float>;

} // namespace CGAL::Approximate_geodesics
