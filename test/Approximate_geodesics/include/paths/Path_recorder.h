// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_PATH_RECORDER_H
#define APPROXIMATE_GEODESICS_TEST_PATH_RECORDER_H

#include "meshes/test_soup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace geodesics_test {

// Remembers, for each point of a path, where it is and which faces touch it.
struct Path_recorder
{
  void operator()(const Vertex v)
  {
    points.push_back(mesh.point(v));
    std::set<Face> touched;
    if(!mesh.is_isolated(v))
      for(const Face f : mesh.faces_around_target(mesh.halfedge(v)))
        touched.insert(f);
    faces.push_back(touched);
  }

  template <typename Coordinates>
  void operator()(const Face, const Coordinates&)
  {
    ADD_FAILURE() << "the path ends in a face";
  }

  void operator()(const Halfedge h, const double t)
  {
    EXPECT_GE(t, 0);
    EXPECT_LE(t, 1);
    points.push_back(CGAL::barycenter(mesh.point(mesh.target(h)), t, mesh.point(mesh.source(h))));
    faces.push_back({mesh.face(h), mesh.face(mesh.opposite(h))});
  }

  // whether the path can go straight from each point to the next
  bool stays_on_surface() const
  {
    for(std::size_t i = 1; i < faces.size(); ++i)
      if(std::none_of(faces[i].begin(), faces[i].end(), [&](const Face f) {
           return f != Mesh::null_face() && faces[i - 1].count(f) > 0;
         }))
        return false;
    return true;
  }

  const Mesh& mesh;
  std::vector<Point> points = {};
  std::vector<std::set<Face>> faces = {};
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_PATH_RECORDER_H
