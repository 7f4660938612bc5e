// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matchers.h"
#include "written_file.h"

#include "collection/read_classes.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"
#include "formats/Shown_surface.h"
#include "formats/gzip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_text_files {

using namespace Canonical_pose_tool;
using Canonical_pose_test::written_file;

// With other line ends than LF.
std::string with_line_ends(const std::string& text, const std::string& end)
{
  std::string result;
  for(const char c : text)
    result += c == '\n' ? end : std::string(1, c);
  return result;
}

// In UTF-16, of ASCII.
std::string in_utf_16(const std::string& text, const bool is_big_endian)
{
  std::string result = is_big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for(const char c : text)
    result += is_big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return result;
}

// A tetrahedron, as text of each format.
const std::map<std::string, std::string> TEXTS = {
  {"tetrahedron.off",
   "OFF # one\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"},
  {"tetrahedron.obj",
   "v 0 0 0\nv 1 0 0\n# three and four\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"},
  {"tetrahedron.ply",
   "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
   "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
   "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"},
  {"tetrahedron.stl",
   "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
   "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 1 0 0\nendloop\n"
   "endfacet\nendsolid one\n"},
  {"tetrahedron.mesh",
   "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
   "Tetrahedra\n1\n1 2 3 4 1\nEnd\n"}};

void expect_equal(const Mesh_file& mesh, const Mesh_file& expected)
{
  EXPECT_EQ(mesh.points, expected.points);
  EXPECT_EQ(mesh.faces, expected.faces);
  EXPECT_EQ(mesh.cells, expected.cells);
}

// A byte-order mark and the ends of lines do not change what a text says. With a mark, OBJ lost its
// first vertex without a word; with CR alone, all but the first.
TEST(Text_files, byte_order_marks_and_line_ends)
{
  for(const auto& [name, text] : TEXTS)
  {
    const Mesh_file expected = read_mesh_file(written_file(name, text));
    ASSERT_GE(expected.points.size(), 4u) << name;
    ASSERT_GE(expected.faces.size() + expected.cells.size(), 1u) << name;
    for(const std::string& mark : {"", "\xEF\xBB\xBF"})
      for(const std::string& end : {"\n", "\r\n", "\r"})
      {
        SCOPED_TRACE(name + (mark.empty() ? "" : " with a mark") + (end == "\r" ? ", CR" : ""));
        expect_equal(read_mesh_file(written_file(name, mark + with_line_ends(text, end))), expected);
      }
    for(const bool is_big_endian : {false, true})
      EXPECT_THROW_WITH(read_mesh_file(written_file(name, in_utf_16(text, is_big_endian))),
                        std::invalid_argument,
                        "the text is encoded in UTF-16; UTF-8 and ASCII are read");
  }
}

// What is not a face is not one without a word, nor is a texture coordinate or normal that does not exist.
TEST(Text_files, corners_of_obj)
{
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const Mesh_file expected = read_mesh_file(written_file("corners.obj", vertices + "f 1 2 3\n"));
  for(const std::string& face : {"fo 1 2 3", "f 1// 2/ 3", "vt 0 0\nvn 0 0 1\nf 1/-1/-1 2/1 3//1",
                                 "f 1/1/1 2/1 3//1\nvt 0 0\nvn 0 0 1"}) // fo: an old spelling
    expect_equal(read_mesh_file(written_file("corners.obj", vertices + face + "\n")), expected);
  const std::vector<std::pair<std::string, std::string>> cases
    = {{"f 1/abc/1 2 3", "face 1: 'abc' is not an integer"},
       {"f 1//$ 2 3", "face 1: '$' is not an integer"},
       {"f 1/1/1/1 2 3", "face 1: a corner has more than three indices"},
       {"f 1/0/1 2 3\nvn 0 0 1", "face 1 names texture coordinate 0 (counted from 1), but there are 0 (line 5)"},
       {"vt 0 0\nf 1/1 2/2 3/1", "face 1 names texture coordinate 2 (counted from 1), but there are 1 (line 6)"},
       {"f 1/1 2/3 3/1\nvt 0 0", "face 1 names texture coordinate 3 (counted from 1), but there are 1 (line 5)"},
       {"vn 0 0 1\nf 1//1 2//9223372036854775807 3//1", "face 1 names normal 9223372036854775807 (counted from 1), but there are 1"},
       {"vt 0 0\nf 1/-2 2 3\nvt 0 0", "face 1 names texture coordinate -2, but there are 1 before it (line 6)"},
       {"f 1//-1 2 3\nvn 0 0 1", "face 1 names normal -1, but there are 0 before it (line 5)"},
       {"f 1/-9223372036854775808 2 3", "face 1 names texture coordinate -9223372036854775808, but there are 0 before it"},
       {"f\xC2\xA0"
        "1\xC2\xA0"
        "2\xC2\xA0"
        "3",
        "is not ASCII"},
       {"\x01 1 2 3", "the keyword '?' has a control character"}};
  for(const auto& [face, defect] : cases)
    EXPECT_THROW_WITH(
      read_mesh_file(written_file("corners.obj", vertices + "f 1 2 3\n" + face + "\n")),
      std::invalid_argument, defect);
  EXPECT_THROW_WITH(
    read_mesh_file(written_file("counts.off", "OFF\n3 1 x\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")),
    std::invalid_argument, "the number of edges: 'x' is not an integer");
}

// What DOS writes at the end of a text stays there, and is no part of it; elsewhere, and in binary data, it is a byte.
TEST(Text_files, ends_of_dos)
{
  for(const auto& [name, text] : TEXTS)
    for(const std::string& end : {"\x1A", "\x1A\x1A"})
    {
      const std::string ended = text + end, path = written_file(name, ended);
      expect_equal(read_mesh_file(path), read_mesh_file(written_file(name, text)));
      const Mesh_file mesh = read_mesh_file(written_file(name, ended), Source::KEPT);
      std::ostringstream out;
      rewrite_mesh(out, mesh, mesh.points, {});
      EXPECT_EQ(out.str().substr(out.str().size() - end.size() - 1), '\n' + end) << name;
      EXPECT_THROW(read_mesh_file(written_file(name, ended + "1\n")), std::invalid_argument)
        << name;
    }
  EXPECT_EQ(read_lines(written_file("lines.txt", "one\r\n\x1A")), std::vector<std::string>{"one"});
  EXPECT_EQ(read_numbers(written_file("numbers.txt", "1 2\n\x1A")), (std::vector<double>{1, 2}));
  const std::string header
    = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nend_header\n";
  EXPECT_EQ(read_mesh_file(written_file("binary.ply", header + "\x1A\x1A\x1A")).points.at(0),
            (std::array<double, 3>{26, 26, 26}));
}

// Squares of others are infinite.
TEST(Text_files, coordinates_that_are_too_large)
{
  for(const Source source : {Source::DROPPED, Source::UNCHECKED})
    EXPECT_THROW_WITH(
      read_mesh_file(written_file("large.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 -1e308 0\n3 0 1 2\n"),
                     source),
      std::invalid_argument, "vertex 2 has a coordinate that is too large");
  EXPECT_EQ(read_mesh_file(written_file("large.obj", "v 1e90 0 0\n")).points.size(), 1u);
}

// Lines of messages are those that an editor shows.
TEST(Text_files, lines_of_messages)
{
  for(const std::string& end : {"\n", "\r\n", "\r"})
    EXPECT_THROW_WITH(
      read_mesh_file(written_file("wrong.obj", with_line_ends("v 0 0 0\n\nv 0 one 0\n", end))),
      std::invalid_argument, "vertex 1: 'one' is not a number (line 3)");
}

// Indices that no vertex has are listed, not only the first one, and a position that is not finite once.
TEST(Text_files, defects_of_numbers)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
                    ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                          "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  const std::vector<std::pair<std::string, std::string>> cases
    = {{"wrong.off", "OFF\n4 4 0\n" + points + "3 0 1 2\n3 0 1 -1\n3 0 1 4\n3 0 -2 99\n"},
       {"wrong.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 0\nf 1 2 5\nf -1 -5 2\n"},
       {"wrong.ply", ply + points + "3 0 1 2\n3 0 1 -1\n3 0 1 4\n3 0 -2 99\n"},
       {"wrong.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
                      "Tetrahedra\n4\n1 2 3 4 0\n0 2 3 4 0\n1 2 3 5 0\n1 2 -3 99 0\nEnd\n"}};
  for(const auto& [name, text] : cases)
  {
    const auto diagnosis = diagnosis_of(read_mesh_file(written_file(name, text), Source::UNCHECKED));
    ASSERT_EQ(diagnosis.defects.size(), 1u) << name;
    EXPECT_EQ(diagnosis.defects[0].kind, "wrong_indices");
    EXPECT_EQ(diagnosis.defects[0].count, 3u) << name;
    EXPECT_EQ(diagnosis.first_defect, diagnosis.defects[0].element + " 1 names a vertex that does not exist");
    EXPECT_THROW(read_mesh_file(written_file(name, text)), std::invalid_argument);
  }
  std::string stl = "solid\n";
  for(const char* const corner : {"nan 0 0", "nan 0 1", "inf 0 0"})
    for(int face = 0; face < 2; ++face)
      stl += std::string("facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 0 1 ") + std::to_string(face) + "\nvertex "
             + corner + "\nendloop\nendfacet\n";
  const auto diagnosis = diagnosis_of(read_mesh_file(written_file("wrong.stl", stl + "endsolid\n"), Source::UNCHECKED));
  EXPECT_EQ(diagnosis.vertices, 6u);
  ASSERT_EQ(diagnosis.defects.size(), 1u);
  EXPECT_EQ(diagnosis.defects[0].kind, "not_finite");
  EXPECT_EQ(diagnosis.defects[0].count, 3u);
}

// An extension that lies is named.
TEST(Text_files, formats_by_content)
{
  const auto format_of_content = [](const std::string& name, const std::string& bytes) {
    return format_of(written_file(name, bytes));
  };
  const std::map<std::string, Format> formats = {{"off", Format::OFF},
                                                 {"obj", Format::OBJ},
                                                 {"ply", Format::PLY},
                                                 {"stl", Format::STL},
                                                 {"mesh", Format::MEDIT}};
  for(const auto& [name, text] : TEXTS)
    for(const std::string& other : {"content.txt", "content", "content.off.bak"})
      for(const std::string& before : {"", "\xEF\xBB\xBF", "\n\n"})
      {
        if(name == "tetrahedron.ply" && before == "\n\n")
          continue; // nothing may come first
        EXPECT_EQ(format_of_content(other, before + text), formats.at(name.substr(12))) << name;
        expect_equal(read_mesh_file(written_file(other, before + text)),
                     read_mesh_file(written_file(name, text)));
      }
  EXPECT_EQ(format_of_content("content", "# by hand\nSTCNOFF 3 1 0\n"), Format::OFF);
  EXPECT_EQ(format_of_content("content", "# by hand\nmtllib a.mtl\no b\nv 0 0 0\n"), Format::OBJ);
  EXPECT_EQ(format_of_content("content", std::string(80, '\0') + std::string({1, 0, 0, 0})
                                           + std::string(50, '\0')),
            Format::STL);
  for(const std::string& text : {"", "\r\n\x1A"})
    EXPECT_THROW_WITH(format_of_content("content", text), std::invalid_argument,
                      "the file is empty");
  EXPECT_THROW_WITH(format_of(testing::TempDir()), std::invalid_argument, "it is a directory");
  for(const std::string& text : {"hello\n", "OF", "GIF89a", "<html>", "TOFFEE"})
    EXPECT_THROW_WITH(format_of_content("content.txt", text), std::invalid_argument,
                      "is not one of .off, .obj, .ply, .stl, .mesh, .glb, .gltf");
  EXPECT_THROW_WITH(format_of("nowhere"), std::invalid_argument,
                    "the extension of 'nowhere' is not one of");
  EXPECT_THROW_WITH(format_of(written_file("content.txt", "OFF\n"), Use::WRITE),
                    std::invalid_argument, ".glb, .vtu");
}

// What is written in each format, without a file to keep, is read again. (Under the sanitizers, too.)
TEST(Text_files, written)
{
  const Mesh_file triangles = read_mesh_file(written_file("a.off", TEXTS.at("tetrahedron.off")));
  Mesh_file polygons = triangles;
  polygons.faces.push_back({0, 1, 3, 2});
  for(const std::string& extension : {"off", "obj", "ply", "stl"})
  {
    const Mesh_file& mesh = extension == "stl" ? triangles : polygons;
    std::ostringstream out;
    write_mesh(out, format_of("a." + extension, Use::WRITE), mesh);
    const Mesh_file again = read_mesh_file(written_file("again." + extension, out.str()));
    if(extension == "stl") // which has its vertices in another order
      EXPECT_EQ(again.faces.size(), mesh.faces.size());
    else
      expect_equal(again, mesh);
  }
}

// Compressed files of all formats, in one piece or several, are what they contain.
TEST(Text_files, compressed)
{
  if(!is_gzip_available())
    GTEST_SKIP() << "zlib was not found";
  for(const auto& [name, text] : TEXTS)
  {
    const Mesh_file expected = read_mesh_file(written_file(name, text));
    const std::string half = text.substr(0, text.size() / 2), rest = text.substr(half.size());
    for(const std::string& bytes : {compressed(text), compressed(half) + compressed(rest)})
    {
      expect_equal(read_mesh_file(written_file(name + ".GZ", bytes)), expected);
      expect_equal(read_mesh_file(written_file(name, bytes)), expected);
      expect_equal(read_mesh_file(written_file("content.gz", bytes)), expected);
      EXPECT_THROW_WITH(read_mesh_file(written_file(name, bytes.substr(0, bytes.size() - 1))),
                        std::invalid_argument, "the compressed file is truncated");
      expect_equal(read_mesh_file(written_file(name, bytes + std::string(3, '\0'))), expected);
      EXPECT_THROW_WITH(read_mesh_file(written_file(name, bytes + "x")), std::invalid_argument,
                        "the compressed file is");
    }
  }
  std::string damaged = compressed(TEXTS.at("tetrahedron.off"));
  damaged[damaged.size() / 2] ^= 1;
  EXPECT_THROW_WITH(read_mesh_file(written_file("damaged.off.gz", damaged)), std::invalid_argument,
                    "the compressed file is damaged");
  // More than zlib is given at a time.
  std::string large;
  for(int i = 0; large.size() < 3000000; ++i)
    large += std::to_string(i * 7919LL % 1000003);
  EXPECT_EQ(decompressed(compressed(large)), large);
  EXPECT_EQ(decompressed(compressed("")), "");
  EXPECT_EQ(stem_of("a/b.c.off.gz"), "b.c");
  EXPECT_EQ(extension_of("a/b.c.OFF.gz"), ".off");
  EXPECT_EQ(extension_of("a/b.gz"), "");
}

// Stems or classes may have blanks, the latter after a tabulator.
TEST(Text_files, classes_with_blanks)
{
  EXPECT_EQ(read_classes(written_file("classes.txt", " my cat  animals\n\nb\ttwo words \n\t\n")),
            (std::map<std::string, std::string>{{"my cat", "animals"}, {"b", "two words"}}));
}

TEST(Text_files, content_of_another_format)
{
  EXPECT_THROW_WITH(read_mesh_file(written_file("lie.off", TEXTS.at("tetrahedron.ply"))),
                    std::invalid_argument, "there is no keyword OFF; its content looks like PLY");
  EXPECT_THROW_WITH(read_mesh_file(written_file("lie.ply", TEXTS.at("tetrahedron.stl"))),
                    std::invalid_argument, "there is no keyword ply; its content looks like STL");
  EXPECT_THROW_WITH(read_mesh_file(written_file("lie.obj", TEXTS.at("tetrahedron.off"))),
                    std::invalid_argument, "there is no vertex; its content looks like OFF");
}

// The header of a binary file is any text, and may begin like a mark or a text; anything but a face may follow the last one.
TEST(Text_files, binary_stl)
{
  for(const std::string& beginning : {"\xEF\xBB\xBF", "\xFF\xFE", "solid", "solid a cube", "solid\nfacets\n", "", "\n"})
    for(const char filling : {' ', '\0'})
      for(const std::size_t more : {0, 1, 16, 49, 50, 512})
      {
        std::string bytes = beginning + std::string(80 - beginning.size(), filling);
        bytes += std::string("\x01\x00\x00\x00", 4);
        const std::array<float, 12> facet = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
        bytes.append(reinterpret_cast<const char*>(facet.data()), sizeof(facet));
        bytes += std::string(2 + more, more == 16 ? 'f' : '\0');
        const std::string path = written_file("binary.stl", bytes);
        SCOPED_TRACE(beginning + ", " + std::to_string(more));
        EXPECT_EQ(read_mesh_file(path).points.size(), 3u);
        if(more < 50)
          EXPECT_EQ(format_of(written_file("content", bytes)), Format::STL);
        const std::vector<std::string> lost
          = losses(read_mesh_file(path, Source::KEPT), Format::OFF);
        EXPECT_EQ(std::count(lost.begin(), lost.end(), "what follows the last face"),
                  more < 50 ? 0 : 1);
        bytes.resize(134);
        bytes.append(reinterpret_cast<const char*>(facet.data()), sizeof(facet))
          .append(more, '\0')
          .append(2, '\0');
        EXPECT_THROW_WITH(read_mesh_file(written_file("faces.stl", bytes)), std::invalid_argument,
                          "the file goes on for " + std::to_string(50 + more)
                            + " bytes after the 1 faces announced, with more faces");
        bytes[80] = '\0';
        if(beginning.empty() || beginning[0] == 's') // otherwise, it is text
          EXPECT_THROW_WITH(read_mesh_file(written_file("none.stl", bytes)), std::invalid_argument,
                            "after the 0 faces announced");
      }
}

// Blender 2.4 wrote the second line without the keyword comment.
TEST(Text_files, header_of_ply)
{
  const auto text = [](const std::string& line) {
    return "ply\nformat ascii 1.0\n" + line
           + " by Blender3D 247 - www.blender.org, source file: \nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nelement face 1\nproperty list uchar uint vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  };
  EXPECT_EQ(read_mesh_file(written_file("a.ply", text("Created"))).faces.size(), 1u);
  EXPECT_THROW_WITH(read_mesh_file(written_file("b.ply", text("Made"))), std::invalid_argument,
                    "line 3: the keyword 'Made' is unknown");
}

// Two strips, with a vertex twice within the second one. Their pose has them, too.
TEST(Text_files, triangle_strips_of_ply)
{
  const auto text = [](const std::string& element) {
    return "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n" + element
           + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n2 1 0\n"
             "11 0 1 2 3 -1 1 3 3 4 -1 0\n";
  };
  const Mesh_file mesh = read_mesh_file(written_file("strips.ply", text("")), Source::KEPT);
  const std::vector<std::vector<std::size_t>> expected = {{0, 1, 2}, {2, 1, 3}};
  ASSERT_EQ(mesh.faces.size(), expected.size());
  for(std::size_t f = 0; f < expected.size(); ++f)
    EXPECT_EQ(std::vector<std::size_t>(mesh.faces[f].begin(), mesh.faces[f].end()), expected[f]);
  EXPECT_TRUE(losses(mesh, Format::OFF).empty());
  std::ostringstream out;
  rewrite_mesh(out, mesh, mesh.points, {});
  EXPECT_EQ(out.str(), text(""));
  EXPECT_THROW_WITH(read_mesh_file(written_file("both.ply", text("element face 0\n"))), std::invalid_argument,
                    "line 8: both faces and triangle strips");
  std::string wrong = text("");
  wrong.replace(wrong.find("1 2 3 -1"), 1, "9");
  EXPECT_THROW_WITH(read_mesh_file(written_file("wrong.ply", wrong)), std::invalid_argument,
                    "face 0 names vertex 9, but there are 5");
}

// All on one line, or with the first vertex on that of the numbers.
TEST(Text_files, off_on_one_line)
{
  const Mesh_file expected = read_mesh_file(written_file("lines.off", TEXTS.at("tetrahedron.off")));
  const std::string numbers = "4 4 6 0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3";
  for(const std::string& text : {"OFF " + numbers, "OFF" + numbers, "OFF\n" + numbers + "\n"})
    expect_equal(read_mesh_file(written_file("line.off", text)), expected);
  const std::string text = "OFF 3 1 0 0 0 0 1 0 0\n0 1 0 3 0 1 2 # one\n";
  const Mesh_file mesh = read_mesh_file(written_file("two.off", text), Source::KEPT);
  EXPECT_EQ(attributes_of_file(mesh), std::vector<std::string>{"comments"});
  std::ostringstream out;
  rewrite_mesh(out, mesh, {{0, 0, 1}, {2, 0, 0}, {0, 3, 0}}, {});
  EXPECT_EQ(out.str(), "OFF 3 1 0 0 0 1 2 0 0\n0 3 0 3 0 1 2 # one\n");
  EXPECT_THROW_WITH(read_mesh_file(written_file("line.off", "COFF 3 1 0 0 0 0 9 9 9 1 0 0 9 9 9 0 1 0 9 9 9 3 0 1 2")),
                    std::invalid_argument, "line 1: the variant 'COFF' is not read on one line");
}

TEST(Text_files, numbers_lines_and_classes)
{
  const std::string mark = "\xEF\xBB\xBF";
  for(const std::string& end : {"\n", "\r\n", "\r"})
  {
    EXPECT_EQ(read_numbers(written_file("numbers.txt", mark + with_line_ends("1\n2 # two\n3\n", end))),
              (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(read_lines(written_file("lines.txt", mark + with_line_ends("a\nb c\n\nd", end))),
              (std::vector<std::string>{"a", "b c", "", "d"}));
    EXPECT_EQ(read_classes(written_file("classes.txt", mark + with_line_ends("a x\nb y\n", end))),
              (std::map<std::string, std::string>{{"a", "x"}, {"b", "y"}}));
  }
}

} // namespace test_text_files
