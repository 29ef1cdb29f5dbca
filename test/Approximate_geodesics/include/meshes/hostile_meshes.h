// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_HOSTILE_MESHES_H
#define APPROXIMATE_GEODESICS_TEST_HOSTILE_MESHES_H

#include "meshes/surface_points.h"
#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

// Meshes as scanners, exporters and accidents make them.

namespace geodesics_test {

struct Hostile_mesh
{
  std::string name;
  Mesh mesh;
  std::vector<std::string> refusal = {}; // what the message says; the mesh is accepted if empty
  std::vector<std::string> refusal_across_faces = {}; // the same if paths are to run across faces
  std::vector<Point> layout = {}; // if given: distances are those of these points, of all vertices
};

// ----- shapes of faces

// Faces that are longer than wide by a factor of `aspect`.
inline Soup needles(const double aspect)
{
  return grid(7, 4, [=](const double i, const double j) { return Point(i / aspect, j, 0); });
}

// Faces whose longest side is nearly as long as the two others together.
inline Soup caps(const double aspect)
{
  return grid(7, 4,
              [=](const double i, const double j) { return Point(i - j / 2, j / aspect, 0); });
}

// Columns of faces that lie on each other.
inline Soup accordion(const double height)
{
  return grid(
      7, 4, [=](const double i, const double j) { return Point(std::fmod(i, 2), j, i * height); });
}

inline Soup scaled(const Soup& soup, const double factor)
{
  return soup.transformed(
      [=](const Point& p) { return Point(p.x() * factor, p.y() * factor, p.z() * factor); });
}

inline Soup moved(const Soup& soup, const double x)
{
  return soup.transformed([=](const Point& p) { return Point(p.x() + x, p.y() + x, p.z() + x); });
}

inline Soup in_one_place(const Soup& soup)
{
  return soup.transformed([](const Point&) { return Point(1, 2, 3); });
}

// ----- connectivity

inline Soup without_faces(Soup soup, const std::vector<std::size_t>& faces)
{
  for(auto f = faces.rbegin(); f != faces.rend(); ++f)
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(*f));
  return soup;
}

inline Soup many_triangles(const std::size_t number)
{
  Soup result;
  for(std::size_t i = 0; i < number; ++i)
  {
    const double x = 2 * static_cast<double>(i);
    result.append({{Point(x, 0, 0), Point(x + 1, 0, 0), Point(x, 1, 0)}, {{0, 1, 2}}});
  }
  return result;
}

// A grid whose first and last columns are the same, and so are its rows: a torus, or a Klein bottle
// if it is turned over on the way, which no orientation of its faces fits.
inline Soup
closed_grid(const std::size_t columns, const std::size_t rows, const bool is_turned_over)
{
  const double pi = 4 * std::atan(1.);
  const auto vertex = [=](const std::size_t i, const std::size_t j) {
    const std::size_t row = i == columns && is_turned_over ? rows - j % rows : j;
    return i % columns + row % rows * columns;
  };
  Soup result = grid(columns, rows, [=](const double i, const double j) {
    const double s = 2 * pi * i / static_cast<double>(columns),
                 t = 2 * pi * j / static_cast<double>(rows);
    const double radius = 3 + std::cos(t);
    return Point(radius * std::cos(s), radius * std::sin(s), std::sin(t));
  });
  result.triangles.clear();
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      result.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      result.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return result;
}

// Two surfaces, joined where the last face of each was.
inline Soup connected_sum(Soup first, const Soup& second)
{
  const std::size_t shift = first.points.size();
  const auto [a, b, c] = first.triangles.back();
  first.triangles.pop_back();
  first.append(second);
  const auto [p, q, r] = first.triangles.back();
  first.triangles.pop_back();
  for(auto& triangle : first.triangles)
    for(std::size_t& v : triangle)
      v = v < shift ? v : v == p ? a : v == q ? c : v == r ? b : v;
  return first; // p, q and r are isolated now
}

// Two disks that lie on each other, joined at their border.
inline Soup pillow(const std::size_t valence)
{
  Soup result = fan(valence);
  const std::size_t hub = result.points.size();
  result.points.push_back(Point(0, 0, 0));
  for(const auto& t : fan(valence).triangles)
    result.triangles.push_back({hub, t[2], t[1]});
  return result;
}

// Gives a soup whose faces do not fit each other as many more vertices as make it a mesh.
inline Mesh oriented(Soup soup)
{
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.triangles);
  return to_mesh(soup);
}

inline Soup with_faces_twice(Soup soup)
{
  const auto triangles = soup.triangles;
  for(const auto& [a, b, c] : triangles)
    soup.triangles.push_back({a, c, b});
  return soup;
}

// Fans that have nothing but a vertex in common.
inline Mesh pinched_vertex()
{
  Mesh mesh;
  const Vertex center = mesh.add_vertex(Point(0, 0, 0));
  for(const double z : {0., 1., 2.})
  {
    const Vertex a = mesh.add_vertex(Point(2, 0, z)), b = mesh.add_vertex(Point(2, 1, z)),
                 c = mesh.add_vertex(Point(1, 2, z));
    mesh.add_face(center, a, b);
    mesh.add_face(center, b, c);
  }
  return mesh;
}

// Makes halfedges follow each other around a face, or around nothing.
inline void link(Mesh& mesh, const Face f, const std::vector<Halfedge>& cycle)
{
  for(std::size_t i = 0; i < cycle.size(); ++i)
  {
    mesh.set_face(cycle[i], f);
    mesh.set_next(cycle[i], cycle[(i + 1) % cycle.size()]);
  }
  if(f != Mesh::null_face())
    mesh.set_halfedge(f, cycle.front());
}

inline Mesh edge_without_faces()
{
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(3, 4, 0));
  const Halfedge h = mesh.add_edge(a, b), g = mesh.opposite(h);
  link(mesh, Mesh::null_face(), {h, g});
  mesh.set_halfedge(b, h);
  mesh.set_halfedge(a, g);
  return mesh;
}

// A face two of whose sides are the same edge, so that its third one is a loop.
inline Mesh loop()
{
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0));
  const Halfedge around = mesh.add_edge(b, a), up = mesh.add_edge(a, b);
  const Halfedge border = mesh.opposite(around), down = mesh.opposite(up);
  mesh.set_target(border, a); // an edge cannot be added as a loop
  link(mesh, mesh.add_face(), {around, up, down});
  link(mesh, Mesh::null_face(), {border});
  mesh.set_halfedge(a, border);
  mesh.set_halfedge(b, up);
  return mesh;
}

// Has indices that stand for nothing.
inline Mesh with_removed_elements()
{
  Mesh mesh = to_mesh(flat_grid(6, 5));
  for(const Mesh::size_type f : {0u, 7u, 8u, 21u})
    CGAL::Euler::remove_face(mesh.halfedge(Face(f)), mesh);
  mesh.remove_vertex(mesh.add_vertex(Point(9, 9, 9)));
  return mesh;
}

// ----- what is refused

inline Mesh with_point(Mesh mesh, const Mesh::size_type v, const Point& p)
{
  mesh.point(Vertex(v)) = p;
  return mesh;
}

inline Mesh with_quadrangle()
{
  Mesh mesh = to_mesh(flat_grid(3, 3));
  const Vertex a = mesh.add_vertex(Point(9, 9, 0)), b = mesh.add_vertex(Point(10, 9, 0)),
               c = mesh.add_vertex(Point(10, 10, 0)), d = mesh.add_vertex(Point(9, 10, 0));
  mesh.add_face(a, b, c, d);
  return mesh;
}

// A vertex with two separate fans of faces around it.
inline Mesh two_cycles()
{
  Mesh mesh = to_mesh(flat_grid(3, 3));
  const Vertex a = mesh.add_vertex(Point(9, 9, 0)), b = mesh.add_vertex(Point(10, 9, 0)),
               c = mesh.add_vertex(Point(10, 10, 0));
  mesh.add_face(a, b, c);
  for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(a)))
    mesh.set_target(h, Vertex(4));
  mesh.remove_vertex(a);
  return mesh;
}

// A face with two sides.
inline Mesh with_lune()
{
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0));
  const Halfedge there = mesh.add_edge(a, b), back = mesh.add_edge(b, a);
  link(mesh, mesh.add_face(), {there, back});
  link(mesh, Mesh::null_face(), {mesh.opposite(there), mesh.opposite(back)});
  mesh.set_halfedge(b, there);
  mesh.set_halfedge(a, back);
  return mesh;
}

// The walk around vertex 5 gets into a cycle that does not contain where it started.
inline Mesh with_walk_into_a_cycle()
{
  Mesh mesh = to_mesh(sphere(8, 4));
  const Halfedge h = mesh.opposite(mesh.halfedge(Vertex(5)));
  const Halfedge second = mesh.opposite(mesh.prev(h));
  const Halfedge third = mesh.opposite(mesh.prev(second));
  mesh.set_next(mesh.opposite(second), third); // sets what is before `third`
  mesh.set_next(mesh.opposite(third), third);
  return mesh;
}

inline Mesh with_face_without_halfedge(Mesh mesh)
{
  mesh.set_halfedge(Face(7), Mesh::null_halfedge());
  return mesh;
}

inline Mesh with_halfedge_without_target(Mesh mesh)
{
  mesh.set_target(mesh.halfedge(Face(7)), Mesh::null_vertex());
  return mesh;
}

// What is before the halfedge after that of a face is another one.
inline Mesh with_one_way_link(Mesh mesh)
{
  const Halfedge h = mesh.halfedge(Face(7)), g = mesh.opposite(h), next_of_g = mesh.next(g);
  mesh.set_next(g, mesh.next(h));
  mesh.set_next(g, next_of_g);
  return mesh;
}

inline Mesh with_nothing_before_a_halfedge()
{
  Mesh mesh;
  mesh.add_vertex(Point(0, 0, 0));
  const Halfedge h = mesh.add_edge(), g = mesh.opposite(h);
  mesh.set_target(h, Vertex(0));
  mesh.set_target(g, Vertex(0));
  mesh.set_halfedge(Vertex(0), g);
  mesh.set_next(h, g); // so that there is none before `h`
  mesh.set_next(g, g);
  return mesh;
}

// A halfedge of the border has a face that it does not go round.
inline Mesh with_border_in_a_face()
{
  Mesh mesh = to_mesh(flat_grid(2, 2));
  const Halfedge h = mesh.halfedge(Vertex(0), Vertex(1));
  mesh.set_face(mesh.is_border(h) ? h : mesh.opposite(h), Face(1));
  return mesh;
}

inline Mesh with_halfedge_of_another_face()
{
  Mesh mesh = to_mesh(flat_grid(2, 2));
  mesh.set_face(mesh.halfedge(Face(1)), Face(0));
  return mesh;
}

inline Mesh with_vertices_that_know_no_face()
{
  const Point origin(0, 0, 0);
  Mesh mesh = to_mesh({{origin, origin, origin}, {{0, 1, 2}}});
  for(const Vertex v : mesh.vertices())
    mesh.set_halfedge(v, Mesh::null_halfedge());
  return mesh;
}

// As many halfedges have a face as there are sides of faces, but they are others: the border claims
// the face of a detached triangle.
inline Mesh with_border_in_a_detached_face()
{
  const Soup triangle{{Point(7, 7, 0), Point(8, 7, 0), Point(7, 8, 0)}, {{0, 1, 2}}};
  Soup soup = flat_grid(3, 2);
  soup.append(triangle);
  soup.append(triangle);
  Mesh mesh = to_mesh(soup);
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h) && mesh.target(h) < Vertex(6))
      mesh.set_face(h, Face(4));
  for(Mesh::size_type i = 6; i < 12; ++i)
    mesh.set_halfedge(Vertex(i), Mesh::null_halfedge());
  return mesh;
}

// ----- the table

class Hostile_table
{
public:
  Hostile_table()
  {
    add_shapes();
    add_numbers();
    add_connectivity();
    refuse_numbers();
    refuse_connectivity();
  }

  std::vector<Hostile_mesh> rows;

private:
  void add(const std::string& name, const Soup& soup) { add(name, to_mesh(soup)); }
  void add(const std::string& name, Mesh mesh) { rows.push_back({name, std::move(mesh)}); }

  // a part of the plane that straight lines do not leave, bent or not
  void add_flat(const std::string& name, const Soup& soup, const Soup& layout)
  {
    rows.push_back({name, to_mesh(soup), {}, {}, layout.points});
  }
  void add_flat(const std::string& name, const Soup& soup) { add_flat(name, soup, soup); }

  void refuse(const std::string& name, Mesh mesh, const std::vector<std::string>& texts)
  {
    rows.push_back({name, std::move(mesh), texts});
  }

  void add_shapes()
  {
    for(const char* const aspect : {"1e3", "1e6", "1e9", "1e12", "1e200"})
    {
      add_flat(std::string("needles of ") + aspect, needles(std::strtod(aspect, nullptr)));
      add_flat(std::string("caps of ") + aspect, caps(std::strtod(aspect, nullptr)));
    }
    Random random(1);
    const Soup quiet = flat_grid(5, 4);
    add_flat("faces without area", with_caps(quiet, [] { return 0.5; }));
    add("faces with hardly any area",
        with_caps(terrain(5, 4, random), [&] { return random.between(0.1, 0.9); }));
    add_flat("edges of length zero", flat_grid(9, 7).transformed([](const Point& p) {
      return Point(std::floor(p.x() / 3), std::floor(p.y() / 2), 0);
    }));
    add("all points in one place", in_one_place(sphere(5, 3)));
    add_flat("faces lying on each other", accordion(0), flat_grid(7, 4));
    add("faces nearly lying on each other", accordion(1e-9));
    add_flat("a fan", fan(60));
    add("a spike",
        sphere(6, 4).transformed([](const Point& p) { return Point(p.x(), p.y(), 1e4 * p.z()); }));
    add("edges from 1 to 1e12", growing_strip(24, 1, 1e12));
  }

  void add_numbers()
  {
    Random random(2);
    const Soup hills = terrain(5, 4, random);
    for(const char* const size : {"1e160", "1e300", "1e-160", "1e-310", "1e-322"})
      add(std::string("coordinates of ") + size, scaled(hills, std::strtod(size, nullptr)));
    add("coordinates near the largest", scaled(hills, 5e305));
    add("far from the origin, by 1e8", moved(hills, 1e8));
    add("far from the origin, by 1e15", moved(hills, 1e15));
    add_flat("a grid far from the origin, by 1e15", moved(flat_grid(5, 4), 1e15));
    for(const char* const size : {"1e-30", "1e-60", "1e-120", "1e-300"})
    {
      Soup parts = hills;
      parts.append(scaled(hills, std::strtod(size, nullptr)));
      add(std::string("a part of size ") + size, parts);
      add(std::string("edges from ") + size + " to 1",
          growing_strip(30, std::strtod(size, nullptr), 1));
      if(std::string(size) == "1e-300")
        for(Hostile_mesh* row : {&rows.back(), &rows[rows.size() - 2]})
          row->refusal_across_faces = {"too small relative to the mesh", "in the face"};
    }
  }

  void add_connectivity()
  {
    Random random(3);
    const Soup triangle{{Point(0, 0, 0), Point(3, 0, 0), Point(0, 4, 0)}, {{0, 1, 2}}};
    add("no vertex", Mesh());
    add("isolated vertices only", Soup{std::vector<Point>(7, Point(1, 1, 1)), {}});
    add("an edge without faces", edge_without_faces());
    add_flat("one face", triangle);
    add("isolated vertices among faces", scattered_parts(random));
    add("thousands of components", many_triangles(3000));
    Soup sheets = terrain(5, 4, random);
    sheets.append(Soup(sheets));
    add("coincident components", sheets);
    add("holes", without_faces(flat_grid(7, 6), {14, 15, 30, 31, 46}));
    add("a torus", closed_grid(6, 5, false));
    add("two handles", connected_sum(closed_grid(5, 3, false), closed_grid(5, 3, false)));
    add("a Klein bottle, cut", oriented(closed_grid(6, 5, true)));
    add("a soup", random_soup(14, 40, random));
    add("two triangles glued along all edges", necklace(1));
    add("parallel edges", necklace(5));
    add("a loop", loop());
    add("sheets back to back", pillow(8));
    add("faces twice", oriented(with_faces_twice(flat_grid(4, 3))));
    add("a pinched vertex", pinched_vertex());
    add("removed elements", with_removed_elements());
  }

  void refuse_numbers()
  {
    const Mesh quiet = quiet_mesh();
    for(const double bad : {not_a_number, infinity, -infinity})
      for(const int axis : {0, 1, 2})
      {
        const Point p(axis == 0 ? bad : 1, axis == 1 ? bad : 1, axis == 2 ? bad : 1);
        refuse(std::to_string(bad) + " on axis " + std::to_string(axis), with_point(quiet, 13, p),
               {"vertex 13", "infinite or not a number"});
      }
    refuse("not a number, isolated",
           with_point(to_mesh(Soup{std::vector<Point>(3), {}}), 1, Point(0, 0, not_a_number)),
           {"vertex 1", "infinite or not a number"});
    Mesh far_apart = to_mesh(scaled(in_one_place(flat_grid(5, 4)), -5e307));
    far_apart.point(Vertex(7)) = Point(1.5e308, 0, 0);
    refuse("a length beyond the largest number", far_apart, {"vertex 7", "does not fit a double"});
    refuse("lengths beyond it together", to_mesh(scaled(flat_grid(30, 30), 5e306)),
           {"all edge lengths", "half of the largest double", "vertex"});
  }

  void refuse_connectivity()
  {
    const Mesh quiet = quiet_mesh();
    const std::string no_cycle = "do not form one cycle";
    refuse("a quadrangle among triangles", with_quadrangle(),
           {"face 8", "not a triangle: it has 4 sides", "vertex 9"});
    refuse("a face with two sides", with_lune(), {"face 0", "not a triangle: it has 2 sides"});
    refuse("a vertex with two fans", two_cycles(), {"vertex 4", no_cycle});
    refuse("a walk into a cycle", with_walk_into_a_cycle(),
           {"face 16", "not linked to its halfedges in both directions"});
    refuse("a face without a halfedge", with_face_without_halfedge(quiet),
           {"face 7", "has no halfedge"});
    refuse("a halfedge without a target", with_halfedge_without_target(quiet), {"no vertex"});
    refuse("a one-way link", with_one_way_link(quiet),
           {"face 7", "not linked to its halfedges in both directions"});
    refuse("nothing before a halfedge", with_nothing_before_a_halfedge(), {"vertex 0", no_cycle});
    refuse("a border in a face", with_border_in_a_face(),
           {"the halfedge from vertex 1 to vertex 0", "on the cycle of that face"});
    refuse("a halfedge of another face", with_halfedge_of_another_face(),
           {"face 1", "not linked to its halfedges in both directions"});
    refuse("vertices that know no face", with_vertices_that_know_no_face(),
           {"face 0", "is not found around vertex 0"});
    refuse("a border in a detached face", with_border_in_a_detached_face(),
           {"face 4", "is not found around vertex"});
  }
};

inline std::vector<Hostile_mesh> hostile_meshes(const bool are_accepted)
{
  Hostile_table table;
  std::vector<Hostile_mesh> result;
  for(Hostile_mesh& row : table.rows)
    if(row.refusal.empty() == are_accepted)
      result.push_back(std::move(row));
  return result;
}

inline const std::vector<Hostile_mesh>& accepted_meshes()
{
  static const std::vector<Hostile_mesh> result = hostile_meshes(true);
  return result;
}

inline const std::vector<Hostile_mesh>& refused_meshes()
{
  static const std::vector<Hostile_mesh> result = hostile_meshes(false);
  return result;
}

// ----- what to ask for

inline std::vector<Surface_point> all_vertices(const Mesh& mesh)
{
  return {mesh.vertices().begin(), mesh.vertices().end()};
}

// The first and the last one, one between them, and the first isolated one.
inline std::vector<Surface_point> some_vertices(const Mesh& mesh)
{
  const std::vector<Vertex> all(mesh.vertices().begin(), mesh.vertices().end());
  if(all.empty())
    return {};
  std::vector<Surface_point> result{all.front(), all[all.size() / 2], all.back()};
  const auto isolated =
      std::find_if(all.begin(), all.end(), [&](const Vertex v) { return mesh.is_isolated(v); });
  if(isolated != all.end())
    result.push_back(*isolated);
  return result;
}

// In faces and on edges, some of them close to other edges and to vertices.
inline std::vector<Surface_point> some_points(const Mesh& mesh)
{
  const std::vector<Face> all(mesh.faces().begin(), mesh.faces().end());
  if(all.empty())
    return {};
  const Halfedge first = mesh.halfedge(all.front()), last = mesh.halfedge(all.back());
  return {Face_location(all.front(), {0.25, 0.5, 0.25}),
          Face_location(all.back(), {1e-12, 0.75, 0.25 - 1e-12}),
          Face_location(all[all.size() / 2], {0.1, 0.2, 0.7}), Edge_location(first, 0.3),
          Edge_location(mesh.opposite(last), 0.999)};
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_HOSTILE_MESHES_H
