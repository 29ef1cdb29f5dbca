// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/read_soup.h>

#include "checks/expect_message.h"
#include "files/Temporary_folder.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cerrno>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

// Files that hold no mesh: the message says why, with the line, the vertex or the face.

namespace {

using namespace geodesics_test;

namespace AG = CGAL::Approximate_geodesics;
using Soup_point = CGAL::Simple_cartesian<double>::Point_3;
using Float_point = CGAL::Simple_cartesian<float>::Point_3;
using Soup_faces = std::vector<std::vector<std::size_t>>;
using Soup_triangles = std::vector<AG::Soup_triangle>;

const std::string vertices_of_off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string vertices_of_obj = "# a comment\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string header_of_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
    "property double z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
const std::string vertices_of_ply = header_of_ply + "0 0 0\n1 0 0\n0 1 0\n";
// whose sizes of lists have 32 bits
const std::string header_of_long_lists =
    "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 2\nproperty uchar red\nproperty list uint int vertex_indices\nend_header\n";
const std::string header_of_ascii_lists = "ply\nformat ascii 1.0\n" + header_of_long_lists;
const std::string header_of_little_endian_lists =
    "ply\nformat binary_little_endian 1.0\n" + header_of_long_lists + std::string(72, '\1');
const std::string header_of_big_endian_lists =
    "ply\nformat binary_big_endian 1.0\n" + header_of_long_lists + std::string(72, '\1');
const std::string face_of_stl = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                "vertex 0 1 0\nendloop\nendfacet\n";

struct Wrong_file
{
  std::string ending;
  std::string contents;
  std::string reason;
};

// A mesh of two triangles, whose coordinates have this type.
std::string ply_with(const std::string& type, const std::string& last_face)
{
  std::string result = "ply\nformat ascii 1.0\nelement vertex 4\n";
  for(const std::string coordinate : {"x", "y", "z"})
    result += "property " + type + ' ' + coordinate + '\n';
  return result + "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
         "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n" + last_face + '\n';
}

const std::vector<Wrong_file>& wrong_files()
{
  static const std::vector<Wrong_file> result{
      {".off", "", "it is empty"},
      {".stl", "", "it is empty"},
      {"", "OFF", "its file name extension must be"},
      {".xyz", "0 0 0", "its file name extension must be"},
      {".off", "This is no mesh.\n", "it does not begin with OFF"},
      {".off", "OFF\n", "it ends after OFF"},
      {".off", "OFF\n# a comment\n4 faces\n", "line 3: the numbers of vertices and faces"},
      {".off", "OFF\n4 2 0\n0 0 0\n\n1 0\n",
       "line 5: vertex 1 does not have three finite coordinates"},
      {".off", "OFF 4 2 0\n0 0 0\n1 0 nan\n",
       "line 3: vertex 1 does not have three finite coordinates"},
      {".off", "OFF\n4 2 0\n0 0 0\n1 0 0\n", "it ends after 2 of 4 vertices"},
      {".off", "OFF\n99999999999 1 0\n0 0 0\n", "it ends after 1 of 99999999999 vertices"},
      {".off", "OFF\n1 3000000000 0\n0 0 0\n", "it ends after 0 of 3000000000 faces"}, // 72 GB
      {".off", vertices_of_off + "3 0 1 2\n", "it ends after 1 of 2 faces"},
      {".off", vertices_of_off + "3 0 1 2\n3 0 2", "line 8: face 1 has 2 of its 3 vertices"},
      {".off", vertices_of_off + "3 0 1 4\n", "line 7: face 0 has vertex 4; the vertices are"},
      {".off", vertices_of_off + "3 0 1 -1\n", "line 7: face 0 has vertex -1; the vertices are"},
      {".off", vertices_of_off + "three\n", "line 7: face 0 has \"three\" instead of its number"},
      {".obj", vertices_of_obj, "it has no faces"},
      {".obj", vertices_of_obj + "v 1 1\n",
       "line 5: vertex 3 does not have three finite coordinates"},
      {".obj", vertices_of_obj + "f 1 2 9\n", "line 5: face 0 has vertex 9; the vertices are"},
      {".obj", vertices_of_obj + "f 1 2 -4\n", "line 5: face 0 has vertex -4; the vertices are"},
      {".obj", vertices_of_obj + "f 1 2 4\n", "face 0 has vertex 3; the vertices are"},
      {".obj", vertices_of_obj + "f 1 2 3\nmesh 1\n", "line 6: \"mesh\" is an unknown keyword"},
      {".ply", "plain text", "it does not begin with ply"},
      {".ply", ply_with("int", "3 0 2 3"), "its vertices have coordinates of type int; they must"},
      {".ply", ply_with("uint8", "3 0 2 3"), "its vertices have coordinates of type uint8; they"},
      {".ply", ply_with("list uchar float", "3 0 2 3"), "coordinates of type list; they must"},
      {".ply", header_of_ply.substr(0, 80), "its header does not end"},
      {".ply", "ply\nformat ascii 1.0\nelement face 1\nproperty int a\nend_header\n1\n", "no list"},
      {".ply",
       "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty double x\n"
       "property double y\nproperty double z\nelement face 4000000000\n"
       "property list uchar int vertex_indices\nend_header\n0 0 0\n",
       "it ends in vertex 1 of 4000000000"},
      {".ply", header_of_ply + "0 0 0\n1 0", "it ends in vertex 1 of 3"},
      {".ply", header_of_ply + "0 0 0\n1 x 0\n", "invalid number in vertex 1 of 3"},
      {".ply", vertices_of_ply + "3 0 1 2\n3 0 1", "it ends in face 1 of 2"},
      {".ply", vertices_of_ply + "3 0 1 2\n3 0 1 3\n", "face 1 has vertex 3; the vertices are"},
      {".ply", vertices_of_ply + "3 0 1 2\n3 0 1 -1\n", "face 1 has vertex -1; the vertices are"},
      {".ply", header_of_ascii_lists + "0 0 0\n1 0 0\n0 1 0\n7 3 0 1 2\n7 700000000 0 1 2\n",
       "face 1 has a list of 700000000 numbers, more than the file has bytes"},
      {".ply", header_of_ascii_lists + "0 0 0\n1 0 0\n0 1 0\n7 3 0 1 2\n7 -1 0 1 2\n",
       "face 1 has"},
      {".ply", header_of_little_endian_lists + std::string("\7\0\1\0\50", 5),
       "face 0 has a list of 671088896 numbers, more than the file has bytes"},
      {".ply", header_of_big_endian_lists + std::string("\7\50\0\1\0", 5),
       "face 0 has a list of 671088896 numbers, more than the file has bytes"},
      {".stl", "solid x\n" + face_of_stl + face_of_stl.substr(0, 70), "face 1 or its end is mis"},
      {".stl", std::string(80, ' ') + std::string("\2\0\0\0", 4) + std::string(60, '\1'),
       "it ends after 1 of 2 faces"},
      {".stl", std::string(80, ' ') + "\377\377\377\377" + std::string(60, '\1'),
       "it ends after 1 of 4294967295 faces"},
      {".ts", "GOCAD\n", "CGAL cannot read it, for an unknown reason"}};
  return result;
}

template <typename Faces, typename Point>
void read_mesh_file_into(const std::string& file)
{
  std::vector<Point> points;
  Faces faces;
  AG::read_soup(file, points, faces);
}

void read_mesh_file(const std::string& file) { read_mesh_file_into<Soup_faces, Soup_point>(file); }

void read_triangles_of_file(const std::string& file)
{
  read_mesh_file_into<Soup_triangles, Float_point>(file);
}

TEST(Mesh_file, that_is_none_is_refused_with_the_reason)
{
  const Temporary_folder folder;
  for(const Wrong_file& wrong : wrong_files())
  {
    const std::string name = "mesh" + wrong.ending;
    folder.fill({{name, wrong.contents}});
    SCOPED_TRACE(wrong.contents);
    expect_texts<std::invalid_argument>([&] { read_mesh_file(folder.file(name)); },
                                        {folder.file(name) + ": ", wrong.reason});
    if(wrong.ending == ".ply")
      expect_texts<std::invalid_argument>([&] { read_triangles_of_file(folder.file(name)); },
                                          {folder.file(name) + ": ", wrong.reason});
  }
}

template <typename Point, typename Faces>
void expect_square(const std::string& file)
{
  std::vector<Point> points;
  Faces faces;
  AG::read_soup(file, points, faces);
  EXPECT_EQ(points, std::vector<Point>({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  ASSERT_EQ(faces.size(), 2u);
  for(std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(faces[0][i], i);
    EXPECT_EQ(faces[1][i], i == 0 ? 0 : i + 1);
  }
}

TEST(Mesh_file, with_coordinates_of_one_precision_is_read_into_the_other)
{
  const Temporary_folder folder;
  for(const std::string type : {"float", "float32", "double", "float64"})
  {
    SCOPED_TRACE(type);
    folder.fill({{"mesh.ply", ply_with(type, "3 0 2 3")}});
    const std::string file = folder.file("mesh.ply");
    expect_square<Soup_point, Soup_faces>(file);
    expect_square<Float_point, Soup_faces>(file);
    expect_square<Soup_point, Soup_triangles>(file);
    expect_square<Float_point, Soup_triangles>(file);
  }
}

TEST(Mesh_file, with_other_faces_is_not_read_into_triangles)
{
  const Temporary_folder folder;
  const std::string file = folder.file("mesh.ply");
  folder.fill({{"mesh.ply", ply_with("float", "4 0 1 2 3")}, {"mesh.off", vertices_of_off}});
  EXPECT_NO_THROW(read_mesh_file(file));
  expect_texts<std::invalid_argument>(
      [&] { read_triangles_of_file(file); },
      {"cannot read a mesh from " + file + ": face 1 has 4 vertices; it must have three"});
  expect_texts<std::invalid_argument>([&] { read_triangles_of_file(folder.file("mesh.off")); },
                                      {"mesh.off: triangles of 12 bytes are read from PLY files"});
}

TEST(Mesh_file, with_sizes_of_32_bits_is_read)
{
  const Temporary_folder folder;
  const std::string file = folder.file("mesh.ply");
  const std::string zeros(3, '\0');
  const auto number = [&](const char c, const bool is_big) {
    return is_big ? zeros + c : c + zeros;
  };
  const auto face = [&](const bool is_big) {
    std::string result = "\7";
    for(const char c : {'\3', '\0', '\1', '\2'})
      result += number(c, is_big);
    return result;
  };
  for(const std::string& contents :
      {header_of_ascii_lists + "0 0 0\n1 0 0\n0 1 0\n7 3 0 1 2\n7 3 0 1 2\n",
       header_of_little_endian_lists + face(false) + face(false),
       header_of_big_endian_lists + face(true) + face(true)})
  {
    folder.fill({{"mesh.ply", contents}});
    std::vector<Soup_point> points;
    Soup_faces faces;
    AG::read_soup(file, points, faces);
    EXPECT_EQ(faces, Soup_faces({{0, 1, 2}, {0, 1, 2}}));
  }
}

TEST(Mesh_file, that_cannot_be_opened_is_not_called_empty)
{
  const Temporary_folder folder;
  folder.fill({{"folder.off/", ""}});
  const auto reason = [](const int number) { return std::generic_category().message(number); };
  expect_texts<std::invalid_argument>([&] { read_mesh_file(folder.file("missing.off")); },
                                      {folder.file("missing.off") + ": " + reason(ENOENT)});
#ifdef __linux__ // where a folder can be opened, but not read
  expect_texts<std::invalid_argument>([&] { read_mesh_file(folder.file("folder.off")); },
                                      {folder.file("folder.off") + ": " + reason(EISDIR)});
#endif
}

// Wherever a file ends, it is read or refused with a reason, but for what cannot be told.
TEST(Mesh_file, that_ends_too_early_is_refused_with_the_reason)
{
  const std::vector<Soup_point> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Soup_faces faces{{0, 1, 2}, {0, 2, 3}};
  const Temporary_folder folder;
  using Case = std::pair<std::string, void (*)(const std::string&)>;
  for(const auto& [ending, read] :
      {Case("off", read_mesh_file), Case("obj", read_mesh_file), Case("ply", read_mesh_file),
       Case("stl", read_mesh_file), Case("ply", read_triangles_of_file)})
    for(const bool is_binary : {false, true})
    {
      const std::string file = folder.file("mesh." + ending);
      const auto np = CGAL::parameters::use_binary_mode(is_binary).stream_precision(17);
      ASSERT_TRUE(CGAL::IO::write_polygon_soup(file, points, faces, np));
      EXPECT_NO_THROW(read(file));
      const std::string bytes = folder.bytes("mesh." + ending);
      std::size_t number_of_errors = 0;
      for(std::size_t length = 0; length < bytes.size(); ++length)
        try
        {
          folder.fill({{"mesh." + ending, bytes.substr(0, length)}});
          read(file);
        }
        catch(const std::invalid_argument& e)
        {
          ++number_of_errors;
          EXPECT_EQ(std::string(e.what()).find("CGAL cannot read it"), std::string::npos)
              << ending << " of " << length << " bytes: " << e.what();
        }
      EXPECT_GT(number_of_errors, bytes.size() / 3) << ending;
    }
}

} // namespace
