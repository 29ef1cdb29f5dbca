// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Fuzzed_data.h"
#include "meshes/test_meshes.h"
#include "require.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <boost/crc.hpp>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Files of graphs, damaged or forged: each is refused by the exception that is documented, or gives
// a graph that can be searched, saved again and asked for paths.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Discrete_geodesic_graph;
using Triangulation = AG::Intrinsic_triangulation;

struct Subject
{
  Triangulation triangulation;
  std::string file;
};

std::string saved(const Discrete_geodesic_graph& graph)
{
  std::ostringstream out(std::ios::binary);
  graph.save(out);
  return out.str();
}

std::vector<Subject> subjects()
{
  Random random(1);
  std::vector<Subject> result;
  for(const Soup& soup :
      {Soup(), fan(3), flat_grid(2, 2), terrain(4, 4, random), scattered_parts(random)})
  {
    const Triangulation triangulation(to_mesh(soup));
    const Discrete_geodesic_graph graph(triangulation, CGAL::parameters::epsilon(0.1));
    result.push_back({triangulation, saved(graph)});
  }
  return result;
}

constexpr std::size_t size_of_checksum = 4;

// Overwrites, cuts and inserts as the data say.
void tamper(std::string& file, Fuzzed_data& data)
{
  while(!data.is_empty() && file.size() > size_of_checksum)
  {
    const std::size_t at = data.below(file.size() - size_of_checksum);
    switch(data.below(4))
    {
    case 0:
      file.erase(at, 1 + data.below(16));
      break;
    case 1:
      file.insert(at, 1 + data.below(16), static_cast<char>(data.byte()));
      break;
    case 2:
      file[at] = static_cast<char>(file[at] ^ (1 << data.below(8)));
      break;
    default:
      file[at] = static_cast<char>(data.byte());
    }
  }
}

// Makes the checksum right, so that what is wrong has to be found by looking at it.
void forge_checksum(std::string& file)
{
  if(file.size() < size_of_checksum)
    return;
  boost::crc_32_type crc;
  crc.process_bytes(file.data(), file.size() - size_of_checksum);
  for(std::size_t i = 0; i < size_of_checksum; ++i)
    file[file.size() - size_of_checksum + i] = static_cast<char>(crc.checksum() >> (8 * i));
}

void use(const Discrete_geodesic_graph& graph, const std::string& file)
{
  const std::string again = saved(graph);
  require(again == file.substr(0, again.size()), "a graph was not read as written");
  if(graph.number_of_nodes() == 0)
    return;
  AG::Propagation<Discrete_geodesic_graph> search(graph);
  search.run_from(0);
  for(Triangulation::Index v = 0; v < graph.number_of_nodes(); ++v)
    require(search.distance(v) >= 0, "a distance is negative or not a number");
  try
  {
    for(Triangulation::Index v = 0; v < graph.number_of_nodes(); v += 3)
      AG::internal::tree_path(search, v);
  }
  catch(const std::invalid_argument&) // as nothing on the mesh is as long as a forged arc
  {
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, const std::size_t size)
{
  static const std::vector<Subject> all = subjects();
  Fuzzed_data data(bytes, size);
  const Subject& subject = all[data.below(all.size())];
  std::string file = subject.file;
  switch(data.below(3))
  {
  case 0:
    file = data.rest();
    break;
  case 1:
    tamper(file, data);
    break;
  default:
    tamper(file, data);
    forge_checksum(file);
  }
  try
  {
    std::istringstream in(file, std::ios::binary);
    use(Discrete_geodesic_graph::load(in, subject.triangulation), file);
  }
  catch(const std::invalid_argument&)
  {
  }
  return 0;
}
