// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Golden_results.h"
#include "checks/test_random.h"
#include "golden_meshes.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <vector>

/*
 * Pins results to the last bit, so that a change that is to change none can be checked.
 *
 * Usage: golden_results             prints all results
 *        golden_results FILE        compares them with those in a file
 *
 * They are the same for all levels of optimization, as long as numbers are doubles throughout and
 * products and sums are not contracted. They are made of what other libraries give, too: functions
 * of the C library, whose last bit depends on the processor, CGAL's sample meshes, and meshes made
 * by CGAL. These have lines of their own, that start with "input"; if one of them differs,
 * nothing can be said, and the program returns 77, which means that a test was skipped.
 */

namespace geodesics_test::golden {

const std::string input = "input";
constexpr int same = 0, different = 1, not_comparable = 77;

Hash hash_of_c_library()
{
  Random random(7);
  Hash result;
  for(int i = 0; i < 2000; ++i)
  {
    const double x = random.between(0, 4), y = random.between(0, 4);
    for(const double value :
        {std::sin(x), std::cos(x), std::atan(x), std::atan2(x, y), std::pow(x, y), std::log(x),
         std::log2(x), std::log1p(x), std::exp(x), std::expm1(x), std::hypot(x, y)})
      result.add(value);
  }
  return result;
}

std::vector<std::string> all_lines()
{
  Golden_results results;
  results.start(input);
  results.add("C library", hash_of_c_library());
  const std::vector<Named_mesh> meshes = golden_meshes();
  for(const Named_mesh& named : meshes)
    results.add(named.name, hash(named.mesh));
  for(const Named_mesh& named : meshes)
  {
    results.start(named.name);
    add_propagations(named.mesh, results);
    add_queries(named.mesh, results);
    add_functions(named.mesh, results);
  }
  return results.lines();
}

std::vector<std::string> lines_of(const std::string& file)
{
  std::ifstream stream(file);
  std::vector<std::string> result;
  for(std::string line; std::getline(stream, line);)
    result.push_back(line);
  return result;
}

// Prints those lines that are not among the others, and returns them.
std::vector<std::string> print_missing(const char* const sign,
                                       const std::vector<std::string>& lines,
                                       const std::vector<std::string>& others)
{
  const std::set<std::string> known(others.begin(), others.end());
  std::vector<std::string> result;
  for(const std::string& line : lines)
    if(known.count(line) == 0)
    {
      std::cout << sign << line << '\n';
      result.push_back(line);
    }
  return result;
}

int compare(const std::vector<std::string>& lines, const std::vector<std::string>& expected)
{
  std::vector<std::string> differing = print_missing("- ", expected, lines);
  const std::vector<std::string> added = print_missing("+ ", lines, expected);
  differing.insert(differing.end(), added.begin(), added.end());
  if(differing.empty())
    return same;
  const bool is_comparable =
      std::none_of(differing.begin(), differing.end(), [](const std::string& line) {
        return line.compare(0, input.size(), input) == 0;
      });
  if(!is_comparable)
    std::cout << "Other input: nothing can be said about the results.\n";
  return is_comparable ? different : not_comparable;
}

} // namespace geodesics_test::golden

int main(const int argc, const char* const* const argv)
{
  try
  {
    using namespace geodesics_test::golden;
    const std::vector<std::string> lines = all_lines();
    if(argc > 1)
      return compare(lines, lines_of(argv[1]));
    for(const std::string& line : lines)
      std::cout << line << '\n';
    return same;
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return geodesics_test::golden::different;
  }
}
