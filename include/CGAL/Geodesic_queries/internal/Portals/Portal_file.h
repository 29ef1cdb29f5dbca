// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_FILE_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_FILE_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_queries/internal/Portals/Portal_part.h>
#include <CGAL/Geodesic_queries/internal/Portals/Portal_tables.h>
#include <CGAL/Geodesic_queries/internal/Portals/Two_way_arcs.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The file of labels at portals: a signature, the graph that they belong to, epsilon, the parts
 * with the distances between different portals or vertices, once each, and the labels of each
 * vertex.
 */
class Portal_file
{
  using Node = Portal_tables::Node;

  // "AGPTL", followed by CR, SUB and LF, which copies in text mode change
  static constexpr std::uint64_t SIGNATURE = 0x0a1a0d4c54504741;
  static constexpr std::uint32_t VERSION = 1;
  static constexpr const char* CONTENTS = "the labels"; // in messages

public:
  static void save(const Put_bytes& put, const Two_way_arcs& arcs, const Portal_tables& tables)
  {
    Binary_writer writer(put, CONTENTS);
    writer.write(SIGNATURE);
    writer.write(VERSION);
    writer.write(static_cast<std::uint32_t>(tables.number_of_vertices()));
    writer.write(fingerprint(arcs));
    writer.write(tables.m_epsilon);
    writer.write(static_cast<std::uint32_t>(tables.m_parts.size()));
    for(const auto& part : tables.m_parts)
    {
      writer.write(part.parent);
      writer.write(static_cast<std::uint8_t>(part.is_last));
      writer.write(static_cast<std::uint32_t>(part.size));
      const float* row = tables.m_table.data() + part.first_in_table;
      for(std::size_t i = 0; i < part.size; row += part.is_last ? i : part.size, ++i)
        for(std::size_t j = 0; j < i; ++j)
          writer.write(row[j]);
    }
    for(Node v = 0; v < tables.number_of_vertices(); ++v)
      write_vertex(writer, tables, v);
    writer.finish();
  }

  // Reads what was written for a graph with the same arcs and as many vertices.
  static Portal_tables
  load(const Get_bytes& get, const Two_way_arcs& arcs, const std::size_t number_of_vertices)
  {
    Binary_reader reader(get, CONTENTS);
    check_header(reader, arcs, number_of_vertices);
    Portal_tables result;
    result.m_scale = Portal_scale(arcs.arc_lengths().longest);
    result.m_epsilon = checked_positive(reader.read<double>(), "epsilon in the file of the labels");
    for(auto left = reader.read<std::uint32_t>(); left > 0; --left)
      read_part(reader, result);
    result.m_first_level.push_back(0);
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      read_vertex(reader, result);
    check_places(result);
    result.m_first_label.push_back(result.m_distance.size());
    reader.finish();
    return result;
  }

private:
  // Distinguishes graphs of the same size.
  static std::uint32_t fingerprint(const Two_way_arcs& arcs)
  {
    Checksum result;
    result.add(arcs.unit());
    for(Node node = 0; node < arcs.number_of_nodes(); ++node)
    {
      result.add(node);
      arcs.for_each_arc(node, arcs, [&](const Node target, const double length) {
        result.add(target);
        result.add(length);
      });
    }
    return result.value();
  }

  static void write_vertex(Binary_writer& writer, const Portal_tables& tables, const Node v)
  {
    writer.write(tables.m_part[v]);
    writer.write(tables.m_place[v]);
    for(std::size_t i = tables.m_first_level[v]; i < tables.m_first_level[v + 1]; ++i)
    {
      const std::size_t first = tables.m_first_label[i], beyond = tables.m_first_label[i + 1];
      writer.write(static_cast<std::uint32_t>(beyond - first));
      for(std::size_t label = first; label < beyond; ++label)
      {
        writer.write(tables.m_portal[label]);
        writer.write(tables.m_distance[label]);
      }
    }
  }

  static void check_header(Binary_reader& reader,
                           const Two_way_arcs& arcs,
                           const std::size_t number_of_vertices)
  {
    if(reader.read<std::uint64_t>() != SIGNATURE)
      reject("the file is not that of labels at portals");
    if(const auto version = reader.read<std::uint32_t>(); version != VERSION)
      reject("the file of the labels has version " + std::to_string(version) +
             "; this program reads version " + std::to_string(VERSION));
    if(const auto number = reader.read<std::uint32_t>(); number != number_of_vertices)
      reject("the file of the labels belongs to another graph: that has " + std::to_string(number) +
             " vertices, this one has " + std::to_string(number_of_vertices));
    if(reader.read<std::uint32_t>() != fingerprint(arcs))
      reject("the file of the labels belongs to another graph: its arcs are not those of this one");
  }

  static float read_distance(Binary_reader& reader)
  {
    const auto result = reader.read<float>();
    check(result >= 0 && std::isfinite(result), "a distance is not a finite number from 0 on");
    return result;
  }

  // Does not reserve memory: a damaged size must not exhaust it.
  static void read_part(Binary_reader& reader, Portal_tables& tables)
  {
    Portal_tables::Part part{};
    part.parent = reader.read<std::uint32_t>();
    part.is_last = reader.read<std::uint8_t>() != 0;
    part.size = reader.read<std::uint32_t>();
    part.first_in_table = tables.m_table.size();
    if(part.parent != Portal_part::no_parent)
    {
      check(part.parent < tables.m_parts.size() && !tables.m_parts[part.parent].is_last,
            "a part is before the one that it is in");
      part.depth = tables.m_parts[part.parent].depth + 1;
    }
    std::vector<float> table;
    for(std::size_t i = 0; i < part.size; ++i)
      for(std::size_t j = 0; j < i; ++j)
        table.push_back(read_distance(reader));
    if(!part.is_last)
      table = in_full(table, part.size);
    tables.m_table.insert(tables.m_table.end(), table.begin(), table.end());
    tables.m_parts.push_back(part);
  }

  // Adds the diagonal, and what is above it.
  static std::vector<float> in_full(const std::vector<float>& half, const std::size_t size)
  {
    std::vector<float> result(size * size);
    std::size_t next = 0;
    for(std::size_t i = 0; i < size; ++i)
      for(std::size_t j = 0; j < i; ++j)
        result[i * size + j] = result[j * size + i] = half[next++];
    return result;
  }

  static void read_vertex(Binary_reader& reader, Portal_tables& tables)
  {
    const auto number_of_part = reader.read<std::uint32_t>(), place = reader.read<std::uint32_t>();
    check(number_of_part < tables.m_parts.size(), "a vertex is in no part");
    const auto& part = tables.m_parts[number_of_part];
    check(!part.is_last || place < part.size, "a vertex is at no place of its part");
    tables.m_part.push_back(number_of_part);
    tables.m_place.push_back(place);
    std::vector<std::size_t> sizes; // of the separators around it, the largest part last
    for(std::uint32_t i = part.is_last ? part.parent : number_of_part; i != Portal_part::no_parent;
        i = tables.m_parts[i].parent)
      sizes.push_back(tables.m_parts[i].size);
    for(std::size_t level = sizes.size(); level-- > 0;)
      read_labels(reader, sizes[level], tables);
    tables.m_first_level.push_back(tables.m_first_label.size());
  }

  // Distances of two vertices at the same place of a last part are not in its table.
  static void check_places(const Portal_tables& tables)
  {
    std::vector<std::vector<bool>> is_taken(tables.m_parts.size());
    for(std::size_t v = 0; v < tables.number_of_vertices(); ++v)
    {
      const auto& part = tables.m_parts[tables.m_part[v]];
      if(!part.is_last)
        continue;
      std::vector<bool>& places = is_taken[tables.m_part[v]];
      places.resize(part.size);
      check(!places[tables.m_place[v]], "two vertices are at the same place of their part");
      places[tables.m_place[v]] = true;
    }
  }

  static void read_labels(Binary_reader& reader, const std::size_t size, Portal_tables& tables)
  {
    const std::size_t first = tables.m_distance.size();
    tables.m_first_label.push_back(first);
    const auto number = reader.read<std::uint32_t>();
    check(number > 0, "a vertex has no labels at a separator");
    for(std::uint32_t i = 0; i < number; ++i)
    {
      tables.m_portal.push_back(reader.read<std::uint16_t>());
      tables.m_distance.push_back(read_distance(reader));
      check(tables.m_portal.back() < size, "a portal does not exist");
      check(i == 0 || tables.m_distance[first + i - 1] <= tables.m_distance.back(),
            "labels are not sorted");
    }
  }

  static void check(const bool holds, const char* const message)
  {
    if(!holds)
      reject(std::string("the file of the labels is damaged: ") + message);
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_PORTAL_FILE_H
