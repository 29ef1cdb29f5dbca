// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_GOLDEN_RESULTS_H
#define APPROXIMATE_GEODESICS_TEST_GOLDEN_RESULTS_H

#include "Hash.h"
#include "meshes/test_meshes.h"

#include <string>
#include <vector>

namespace geodesics_test {

// Lines of text: a mesh, a subject, and what hash values it has.
class Golden_results
{
public:
  // What follows is about this mesh.
  void start(const std::string& mesh) { m_mesh = mesh; }

  template <typename... Hashes>
  void add(const std::string& subject, const Hashes&... hashes)
  {
    std::string line = m_mesh + " | " + subject + " |";
    ((line += ' ' + hashes.text()), ...);
    m_lines.push_back(line);
  }

  const std::vector<std::string>& lines() const { return m_lines; }

private:
  std::string m_mesh;
  std::vector<std::string> m_lines;
};

// One file each, as they take long to compile.
void add_propagations(const Mesh& mesh, Golden_results& results);
void add_queries(const Mesh& mesh, Golden_results& results);
void add_functions(const Mesh& mesh, Golden_results& results);

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_GOLDEN_RESULTS_H
