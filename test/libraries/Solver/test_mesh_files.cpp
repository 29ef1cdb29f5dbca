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

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
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

// The same with some of the text replaced.
std::string square_with(const std::string& text, const std::string& other)
{
  std::string result = ply_with("float", "3 0 2 3");
  return result.replace(result.find(text), text.size(), other);
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
      {".off", "OFF BINARY\n" + std::string("\77\0\0\0\0\0\0\1\0\0\0\0", 12) + "123456789012",
       "it ends before the last of 1056964608 vertices and 1 faces"}, // 25 GB
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
      {".ply", square_with("ascii", "binary_big_en"),
       "its format is \"binary_big_en\"; it must be"},
      {".ply", square_with("ply", "comment\nply"), "it does not begin with ply"},
      {".ply", square_with("element", "property float q\nelement"),
       "property q comes before the first element"},
      {".ply", square_with("face 2", "face -1"), "element face has the number -1"},
      {".ply", square_with("float z", "float x"), "its vertices have 2 properties x; they must"},
      {".ply", square_with("float z", "float w"), "its vertices have 0 properties z; they must"},
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

TEST(Mesh_file, may_name_its_elements_in_the_plural)
{
  const Temporary_folder folder;
  const std::string file = folder.file("mesh.ply");
  for(const auto& [name, plural] :
      {std::pair("element vertex", "element vertices"), {"element face", "element faces"}})
  {
    folder.fill({{"mesh.ply", square_with(name, plural)}});
    expect_square<Soup_point, Soup_faces>(file);
    expect_square<Float_point, Soup_triangles>(file);
  }
  folder.fill({{"mesh.ply", "ply\nformat ascii 1.0\nelement vertices 0\nproperty float x\n"
                            "property float y\nproperty float z\nelement faces 2\n"
                            "property uchar red\nend_header\n5\n6\n"}});
  EXPECT_EQ(AG::read_face_property(file, "red"), std::vector<double>({5, 6}));
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

// Files in which CGAL's own reader takes several times as long, and others that only look like
// them.
TEST(Mesh_file, in_a_usual_form_has_the_numbers_that_CGAL_reads)
{
  const Temporary_folder folder;
  const std::string rest = "0.1 -2e-3 1e300\n1.7976931348623157e308 0 0\n4.9e-324 0 0\n-0 1 2\n";
  const std::string faces = "3 0 1 2\n4 3 2 1 0\n";
  for(const std::string& contents :
      {"OFF\n4 2 0\n" + rest + faces, "OFF 4 2 0\n" + rest + faces,
       "# a comment\n\nOFF # another\n 4\t2 0\r\n\n" + rest + "\n#\n" + faces,
       "OFF\n4 2 0\n" + rest + "3 0 1 2 255 0 0\n4 3 2 1 0 0.5 0.5 0.5\n", // colors
       "OFF\n4 2 0\n" + rest + "3 0 1 2\n4 3 2 1 0"})                      // no end of a line
  {
    SCOPED_TRACE(contents);
    std::istringstream in(contents);
    std::vector<Soup_point> quick_points;
    Soup_faces quick_faces;
    const bool has_colors = contents.find("255") != std::string::npos;
    EXPECT_EQ(AG::internal::read_off_quickly(in, contents.size(), quick_points, quick_faces),
              !has_colors);
    folder.fill({{"mesh.off", contents}});
    std::vector<Soup_point> points, points_of_cgal;
    Soup_faces soup, soup_of_cgal;
    AG::read_soup(folder.file("mesh.off"), points, soup);
    ASSERT_TRUE(CGAL::IO::read_polygon_soup(folder.file("mesh.off"), points_of_cgal, soup_of_cgal));
    EXPECT_EQ(points, points_of_cgal);
    EXPECT_EQ(soup, soup_of_cgal);
    EXPECT_EQ(soup, Soup_faces({{0, 1, 2}, {3, 2, 1, 0}}));
  }
}

TEST(Mesh_file, may_have_its_numbers_glued_to_OFF)
{
  const Temporary_folder folder;
  folder.fill({{"mesh.off", "OFF4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"}});
  expect_square<Soup_point, Soup_faces>(folder.file("mesh.off"));
}

// Lines in a buffer that is filled again and again.
TEST(Mesh_file, of_many_lines_is_read)
{
  const Temporary_folder folder;
  constexpr std::size_t number = 30000;
  std::string vertices, faces;
  for(std::size_t i = 0; i < number; ++i)
  {
    vertices += std::to_string(i) + " 0.5 " + std::string(i % 50, ' ') + "1\n";
    faces += "3 0 " + std::to_string(i) + " 7\n";
  }
  const std::string size = std::to_string(number);
  folder.fill({{"mesh.off", "OFF\n" + size + ' ' + size + " 0\n" + vertices + faces},
               {"mesh.ply", "ply\nformat ascii 1.0\nelement vertex " + size +
                                "\nproperty float x\nproperty float y\nproperty float z\n"
                                "element face " +
                                size + "\nproperty list uchar int vertex_index\nend_header\n" +
                                vertices + faces}});
  for(const char* const name : {"mesh.off", "mesh.ply"})
  {
    std::vector<Soup_point> points;
    Soup_faces soup;
    AG::read_soup(folder.file(name), points, soup);
    ASSERT_EQ(points.size(), number);
    ASSERT_EQ(soup.size(), number);
    for(std::size_t i = 0; i < number; ++i)
    {
      EXPECT_EQ(points[i], Soup_point(double(i), 0.5, 1));
      EXPECT_EQ(soup[i], (std::vector<std::size_t>{0, i, 7}));
    }
  }
}

// The square with numbers of these types, among others, in one of the three formats.
std::string ply_of_types(const std::string& format, const std::string& index)
{
  const bool is_big = format == "binary_big_endian", is_text = format == "ascii";
  std::string result = "ply\nformat " + format +
                       " 1.0\nelement note 1\nproperty list uchar short a\nelement vertex 4\n"
                       "property list uchar uchar b\nproperty float x\nproperty uchar c\n"
                       "property double y\nproperty float z\nelement face 2\nproperty " +
                       index + " d\nproperty list ushort " + index +
                       " vertex_indices\nproperty uchar red\nend_header\n";
  const auto add = [&](const auto number) {
    std::string bytes(sizeof(number), ' ');
    std::memcpy(&bytes[0], &number, sizeof(number));
    if(is_big)
      std::reverse(bytes.begin(), bytes.end());
    result += is_text ? std::to_string(number) + ' ' : bytes;
  };
  using Byte = std::uint8_t;
  const auto add_index = [&](const int i) {
    if(index == "ushort")
      add(std::uint16_t(i));
    else
      add(std::int32_t(i));
  };
  add(Byte(2)), add(std::int16_t(-1)), add(std::int16_t(300));
  for(const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
    add(Byte(1)), add(Byte(9)), add(float(x)), add(Byte(200)), add(double(y)), add(0.f);
  for(const int i : {1, 2})
  {
    add_index(7), add(std::uint16_t(3));
    add_index(0), add_index(i), add_index(i + 1), add(Byte(10 * i));
  }
  return result;
}

TEST(Mesh_file, with_any_types_of_numbers_and_other_lists_is_read)
{
  const Temporary_folder folder;
  const std::string file = folder.file("mesh.ply");
  for(const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"})
    for(const std::string index : {"ushort", "int"})
    {
      SCOPED_TRACE(format + ' ' + index);
      folder.fill({{"mesh.ply", ply_of_types(format, index)}});
      expect_square<Soup_point, Soup_faces>(file);
      expect_square<Float_point, Soup_triangles>(file);
      EXPECT_EQ(AG::read_face_property(file, "red"), std::vector<double>({10, 20}));
      EXPECT_EQ(AG::read_face_property(file, "d"), std::vector<double>({7, 7}));
      for(const std::string name : {"x", "vertex_indices", "Red", ""})
        expect_texts<std::invalid_argument>([&] { AG::read_face_property(file, name); },
                                            {"the faces of " + file + " have no property " + name});
    }
  const std::string bytes = ply_of_types("binary_little_endian", "int");
  folder.fill({{"mesh.ply", bytes.substr(0, bytes.size() - 1)}, {"mesh.off", vertices_of_off}});
  expect_texts<std::invalid_argument>([&] { AG::read_face_property(file, "red"); },
                                      {file, "behind property red of face 1"});
  for(const char* const name : {"mesh.off", "missing.ply"})
    expect_texts<std::invalid_argument>([&] { AG::read_face_property(folder.file(name), "red"); },
                                        {folder.file(name) + " is not a PLY file"});
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
