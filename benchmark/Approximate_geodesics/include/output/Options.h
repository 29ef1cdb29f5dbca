// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_OPTIONS_H
#define BENCHMARK_OPTIONS_H

#include "output/Table.h"

#include <boost/program_options.hpp>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// The common options of all benchmark programs.
struct Options
{
  std::vector<std::string> meshes;
  std::size_t number_of_rounds;
  std::string csv; // prefix of the names of table files
  bool is_quick = false;
  std::vector<std::string> quick_meshes = {"elephant"};
};

// Options of a single program, each with the variable that it sets.
using More_options = boost::program_options::options_description;

// Prints tables as text and, optionally, each to its own file.
class Report
{
public:
  explicit Report(const Options& options) : m_csv(options.csv) {}

  void print(const std::string& name, const std::string& title, const Table& table) const
  {
    std::cout << title << ":\n\n";
    table.print_text(std::cout);
    std::cout << std::endl;
    write(name, table);
  }

  // Writes to the file only.
  void write(const std::string& name, const Table& table) const
  {
    if(m_csv.empty())
      return;
    std::ofstream out(m_csv + name + ".csv");
    table.print_csv(out);
    if(!out)
      throw std::runtime_error("cannot write to " + m_csv + name + ".csv");
  }

private:
  std::string m_csv;
};

// Returns nothing after printing help.
inline std::optional<Options> parse_options(const int argc,
                                            char* argv[],
                                            const std::string& program,
                                            const Options& defaults,
                                            const More_options& more)
{
  namespace po = boost::program_options;
  Options result = defaults;
  result.meshes.clear();
  po::options_description description("Usage: " + program + " [options] [MESH ...]\n\n" +
                                      "A mesh is a file or the name of one of CGAL's sample "
                                      "meshes; NAME+2 is subdivided twice.\n\nOptions");
  po::options_description_easy_init add = description.add_options();
  add("help,h", "print this text");
  add("quick,q", po::bool_switch(&result.is_quick), "only see whether it runs");
  add("rounds,r", po::value(&result.number_of_rounds)->default_value(defaults.number_of_rounds),
      "number of rounds; most programs take another random source for each");
  add("csv", po::value(&result.csv), "write the tables to files too, whose names start with this");
  add("mesh", po::value(&result.meshes), "meshes");
  for(const auto& option : more.options())
    description.add(option);
  po::positional_options_description positions;
  positions.add("mesh", -1);
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv).options(description).positional(positions).run(),
            values);
  po::notify(values);
  if(values.count("help") > 0)
  {
    std::cout << description;
    return {};
  }
  if(result.is_quick)
    result.number_of_rounds = 3;
  if(result.number_of_rounds == 0)
    throw std::invalid_argument("--rounds: at least one is needed");
  if(result.meshes.empty())
    result.meshes = result.is_quick ? defaults.quick_meshes : defaults.meshes;
  return result;
}

// The common main() of all benchmarks.
template <typename F>
int run_benchmark(const int argc,
                  char* argv[],
                  const std::string& program,
                  const Options& defaults,
                  F f,
                  const More_options& more = {})
{
  try
  {
    if(const auto options = parse_options(argc, argv, program, defaults, more))
      f(*options, Report(*options));
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << program << ": " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}

// Scans, and subdivided scans.
inline std::vector<std::string> usual_meshes()
{
  return {"bunny00", "armadillo", "refined_elephant"};
}

#endif // BENCHMARK_OPTIONS_H
