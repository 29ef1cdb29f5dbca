// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_ARC_FILE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_ARC_FILE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/stored_arcs.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The file of a discrete geodesic graph: a signature, the mesh that it belongs to, epsilon, the
 * triangulation whose vertices are the nodes, and the arcs of each node.
 */
class Arc_file
{
  // "AGDGG", followed by CR, SUB and LF, which copies in text mode change
  static constexpr std::uint64_t SIGNATURE = 0x0a1a0d4747444741;
  static constexpr std::uint32_t VERSION = 4;
  static constexpr double SHARES[] = {Cone_rules::SHARE_OF_ENDS, Cone_rules::SHARE_OF_DETOURS,
                                      Cone_rules::SHARE_OF_BENDS};
  static constexpr const char* CONTENTS = "the graph"; // in messages

public:
  // The nodes are the vertices of `nodes`, which is `triangulation` or a retriangulation of it.
  static void save(const Put_bytes& put,
                   const Intrinsic_triangulation& triangulation,
                   const Intrinsic_triangulation& nodes,
                   const double epsilon,
                   const Compressed_arcs& rows)
  {
    Binary_writer writer(put, CONTENTS);
    writer.write(SIGNATURE);
    writer.write(VERSION);
    writer.write(triangulation.number_of_vertices());
    writer.write(triangulation.number_of_edges());
    writer.write(triangulation.number_of_faces());
    const std::uint32_t mark = fingerprint(triangulation);
    writer.write(mark);
    writer.write(epsilon);
    for(const double share : SHARES)
      writer.write(share);
    writer.write(nodes.number_of_vertices());
    writer.write(&nodes == &triangulation ? mark : fingerprint(nodes));
    for(Index v = 0; v < rows.number_of_rows(); ++v)
    {
      writer.write(static_cast<std::uint32_t>(rows.degree(v)));
      rows.for_each_stored_arc(v, [&](const Index target, const float length) {
        writer.write(target);
        writer.write(length);
      });
    }
    writer.finish();
  }

  // Reads what was written for the same triangulations.
  static void load(const Get_bytes& get,
                   const Intrinsic_triangulation& triangulation,
                   const Intrinsic_triangulation& nodes,
                   double& epsilon,
                   Compressed_arcs& rows)
  {
    Binary_reader reader(get, CONTENTS);
    const std::uint32_t mark = fingerprint(triangulation);
    check_header(reader, triangulation, mark);
    epsilon = reader.read<double>();
    for(const double share : SHARES) // paths are found by computing arcs again, by the same rules
      if(reader.read<double>() != share)
        reject("the graph of the file was built by other rules than those of this version");
    const Index number_of_nodes = nodes.number_of_vertices();
    // nodes inside long thin faces have to be where they were when the graph was built
    if(const auto number = reader.read<std::uint32_t>(); number != number_of_nodes)
      reject("the graph of the file has " + std::to_string(number) +
             " nodes, vertices and points in long thin faces; this version makes " +
             std::to_string(number_of_nodes) + " for the mesh");
    if(reader.read<std::uint32_t>() != (&nodes == &triangulation ? mark : fingerprint(nodes)))
      reject("the graph of the file has nodes at other points of long thin faces than this version "
             "makes for the mesh");
    rows = Compressed_arcs(unit_of_arcs(triangulation));
    std::vector<Stored_arc> arcs;
    for(Index v = 0; v < number_of_nodes; ++v)
    {
      read_arcs(reader, number_of_nodes, v, arcs);
      rows.append_row(arcs);
    }
    reader.finish();
    checked_positive(epsilon, "epsilon in the file of the graph");
  }

private:
  // Distinguishes meshes of the same size.
  static std::uint32_t fingerprint(const Intrinsic_triangulation& triangulation)
  {
    Checksum result;
    for(const Index target : triangulation.targets())
      result.add(target);
    for(const double length : triangulation.lengths())
      result.add(length);
    result.add(triangulation.unit());
    if(!triangulation.thin_faces().is_empty()) // without coordinates, arcs across them differ
      result.add(static_cast<std::uint32_t>(triangulation.thin_faces().number_of_faces()));
    return result.value();
  }

  static void check_header(Binary_reader& reader,
                           const Intrinsic_triangulation& triangulation,
                           const std::uint32_t mark)
  {
    if(reader.read<std::uint64_t>() != SIGNATURE)
      reject("the file is not that of a discrete geodesic graph");
    const auto version = reader.read<std::uint32_t>();
    if(version != VERSION)
      reject("the file of the graph has version " + std::to_string(version) +
             "; this program reads version " + std::to_string(VERSION));
    check_size(reader, triangulation.number_of_vertices(), "vertices");
    check_size(reader, triangulation.number_of_edges(), "edges");
    check_size(reader, triangulation.number_of_faces(), "faces");
    if(reader.read<std::uint32_t>() != mark)
      reject("the file of the graph belongs to another mesh of the same size, or to the same one "
             "with other lengths or indices, or with lengths in place of coordinates");
  }

  static void check_size(Binary_reader& reader, const Index expected, const char* kind)
  {
    const auto size = reader.read<std::uint32_t>();
    if(size != expected)
      reject("the file of the graph belongs to another mesh: that has " + std::to_string(size) +
             " " + kind + ", this one has " + std::to_string(expected));
  }

  static void read_arcs(Binary_reader& reader,
                        const Index number_of_nodes,
                        const Index node,
                        std::vector<Stored_arc>& arcs)
  {
    const auto degree = reader.read<std::uint32_t>();
    arcs.clear(); // and not reserved: a damaged number must not exhaust memory
    for(std::uint32_t i = 0; i < degree; ++i)
    {
      const auto target = reader.read<std::uint32_t>();
      const auto length = reader.read<float>();
      const bool is_sorted = arcs.empty() || arcs.back().target < target;
      if(target >= number_of_nodes || target == node || !is_sorted || !(length >= 0) ||
         std::isinf(length))
        reject("the file of the graph is damaged: arc " + std::to_string(i) + " of node " +
               std::to_string(node) + " is invalid");
      arcs.push_back({target, length});
    }
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_ARC_FILE_H
