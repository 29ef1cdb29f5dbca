// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_TABLE_H
#define BENCHMARK_TABLE_H

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// A table that is printed as aligned text or as CSV.
class Table
{
public:
  explicit Table(std::vector<std::string> header) : m_rows{std::move(header)} {}

  class Row
  {
  public:
    explicit Row(std::vector<std::string>& cells) : m_cells(cells) {}

    Row& add(const std::string& text)
    {
      m_cells.push_back(text);
      return *this;
    }

    Row& add(const double number, const int digits_after_point)
    {
      return add(text_of(number, digits_after_point));
    }

    // A number that may be missing.
    Row& add_if(const bool is_known, const double number, const int digits_after_point)
    {
      return is_known ? add(number, digits_after_point) : add("-");
    }

  private:
    std::vector<std::string>& m_cells;
  };

  static std::string text_of(const double number, const int digits_after_point)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits_after_point) << number;
    return text.str();
  }

  // For numbers of unknown magnitude.
  static std::string scientific(const double number)
  {
    std::ostringstream text;
    text << std::scientific << std::setprecision(1) << number;
    return text.str();
  }

  Row add_row()
  {
    m_rows.emplace_back();
    return Row(m_rows.back());
  }

  bool is_empty() const { return m_rows.size() == 1; }

  void print_text(std::ostream& out) const
  {
    std::vector<std::size_t> width(m_rows.front().size());
    for(const auto& row : m_rows)
      for(std::size_t i = 0; i < row.size(); ++i)
        width[i] = (std::max)(width[i], row[i].size());
    for(const auto& row : m_rows)
    {
      out << std::left << std::setw(static_cast<int>(width[0])) << row[0] << std::right;
      for(std::size_t i = 1; i < row.size(); ++i)
        out << "  " << std::setw(static_cast<int>(width[i])) << row[i];
      out << '\n';
    }
  }

  void print_csv(std::ostream& out) const
  {
    for(const auto& row : m_rows)
      for(std::size_t i = 0; i < row.size(); ++i)
        out << row[i] << (i + 1 < row.size() ? ',' : '\n');
  }

private:
  std::vector<std::vector<std::string>> m_rows; // starting with the header
};

#endif // BENCHMARK_TABLE_H
