// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "written_file.h"

#include "formats/Mesh_file.h"
#include "formats/Shown_surface.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_rewritten_files {

// A file is written again with all positions turned by a quarter around the x axis, which is exact: what is neither a
// position nor a normal keeps its bytes, and normals turn likewise, up to rounding.

using namespace Canonical_pose_tool;

using Points = std::vector<std::array<double, 3>>;

Mesh_file read(const std::string& name, const std::string& bytes)
{
  return read_mesh_file(Canonical_pose_test::written_file(name, bytes), Source::KEPT);
}

std::array<double, 3> turned(const std::array<double, 3>& p) { return {p[0], -p[2], p[1]}; }

Points turned_points(const Mesh_file& mesh)
{
  Points result;
  for(const std::array<double, 3>& p : mesh.points)
    result.push_back(turned(p));
  return result;
}

std::string rewritten(const Mesh_file& mesh, const std::vector<Vertex_values>& values = {})
{
  EXPECT_TRUE(is_rewritable(mesh, mesh.source->format));
  std::ostringstream out;
  rewrite_mesh(out, mesh, turned_points(mesh), values);
  return out.str();
}

template <class T>
std::string bytes_of(const std::vector<T>& values, const bool is_big_endian = false)
{
  std::string result;
  for(const T& value : values)
  {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof(T));
    result += is_big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
  }
  return result;
}

// Numbers may differ by rounding.
void expect_same_text(const std::string& text, const std::string& expected)
{
  static const std::regex number("[-+]?[0-9]+([.][0-9]+)?(e[-+][0-9]+)?");
  EXPECT_EQ(std::regex_replace(text, number, "#"), std::regex_replace(expected, number, "#"));
  const std::sregex_iterator end;
  std::sregex_iterator a(text.begin(), text.end(), number),
    b(expected.begin(), expected.end(), number);
  for(; a != end && b != end; ++a, ++b)
    EXPECT_NEAR(std::stod(a->str()), std::stod(b->str()), 1e-15);
  EXPECT_TRUE(a == end && b == end) << text;
}

TEST(Rewritten_files, texts)
{
  struct Case
  {
    std::string name, text, expected;
  };
  const std::vector<Case> cases
    = {{"a.off", "COFF # colors\n4 2 0\n\n0 0 0 255 0 0\n1 0 0 9 9 9\n0 1 0 8 8 8\n0 0 1 7 7 7 # last\n3 0 1 2 1 0 0\n"
                 "3 0 3 1\n",
        "COFF # colors\n4 2 0\n\n0 -0 0 255 0 0\n1 -0 0 9 9 9\n0 -0 1 8 8 8\n0 -1 0 7 7 7 # last\n3 0 1 2 1 0 0\n"
        "3 0 3 1\n"},
       {"glued.off", "OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0\n1 2\n", "OFF3 1 0\n0 -0 0\n1 -0 0\n0 -0 1\n3 0\n1 2\n"},
       {"a.obj",
        "# C:\\made by hand\\\nmtllib a.mtl\no thing\nv 0 0 0 1 0 0\nv 1 0 0 .5 .5 0\nv 0 1 0\nvt 0 .25\nvn 0 0 2\n"
        "g one\nusemtl red\ns 1\nf 1/1/1 2/1/1 \\\n  3/1/-1\nv 0 0 1\nvn 1 0 0\nf 1//2 4//2 2//2\nl 1 2\n",
        "# C:\\made by hand\\\nmtllib a.mtl\no thing\nv 0 -0 0 1 0 0\nv 1 -0 0 .5 .5 0\nv 0 -0 1\nvt 0 .25\nvn 0 -2 0\n"
        "g one\nusemtl red\ns 1\nf 1/1/1 2/1/1 \\\n  3/1/-1\nv 0 -1 0\nvn 1 0 0\nf 1//2 4//2 2//2\nl 1 2\n"},
       {"a.mesh",
        "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 5\n1 0 0 6\n0 1 0 7\n0 0 1 8\nTriangles 1\n1 2 3 9\n"
        "Tetrahedra\n1\n1 2 3 4 1\nEnd\n",
        "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 -0 0 5\n1 -0 0 6\n0 -0 1 7\n0 -1 0 8\nTriangles 1\n1 2 3 9\n"
        "Tetrahedra\n1\n1 2 3 4 1\nEnd\n"},
       {"a.ply",
        "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\nproperty float nx\nproperty float ny\n"
        "property float nz\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\n"
        "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
        "element material 1\nproperty int shine\nend_header\n0 0 1 0 0 0 255\n0 0 1 1 0 0 254\n0 0 1 0 1 0 253\n"
        "3 0 1 2 2 .5 .5\n77\n",
        "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\nproperty float nx\nproperty float ny\n"
        "property float nz\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\n"
        "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
        "element material 1\nproperty int shine\nend_header\n0 -1 0 0 -0 0 255\n0 -1 0 1 -0 0 254\n0 -1 0 0 -0 1 253\n"
        "3 0 1 2 2 .5 .5\n77\n"}};
  for(const Case& c : cases)
  {
    SCOPED_TRACE(c.name);
    const Mesh_file mesh = read(c.name, c.text);
    expect_same_text(rewritten(mesh), c.expected);
    EXPECT_EQ(read(c.name, rewritten(mesh)).points, turned_points(mesh));
    const std::string mark = "\xEF\xBB\xBF";
    EXPECT_EQ(rewritten(read(c.name, mark + c.text)), mark + rewritten(mesh));
  }
}

// What a pose in another format lacks is named.
TEST(Rewritten_files, attributes)
{
  using Names = std::vector<std::string>;
  EXPECT_EQ(attributes_of_file(read("a.off", "CNOFF\n3 1 0\n0 0 0 0 0 1 9 9 9\n1 0 0 0 0 1 9 9 9\n0 1 0 0 0 1 9 9 9\n3 0 1 2\n")),
            (Names{"colors", "normals"}));
  EXPECT_EQ(attributes_of_file(read("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")), Names());
  EXPECT_EQ(attributes_of_file(read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n")),
            (Names{"texture coordinates", "materials"}));
  EXPECT_EQ(
    attributes_of_file(
      read("a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                     "0 0 1 0\nNormals\n1\n0 0 1\nTetrahedra\n1\n1 2 3 4 1\nEnd\n")),
    (Names{"labels", "the section Normals"}));
  EXPECT_EQ(attributes_of_file(read("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                             "property float z\nproperty uchar red\nelement face 1\n"
                                             "property list uchar int vertex_indices\nelement edge 0\nproperty int v\n"
                                             "end_header\n0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n")),
            (Names{"colors", "the element edge"}));
  EXPECT_EQ(
    losses(read("normals.mesh",
                "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                "0 0 1 0\nNormals\n1\n0 0 1\nTetrahedra\n1\n1 2 3 4 1\nEnd\n"),
           Format::MEDIT),
    Names{"turned normals"});
  const Mesh_file colored
    = read("a.off", "COFF\n3 1 0\n0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n3 0 1 2\n");
  EXPECT_EQ(losses(colored, Format::OFF), Names());
  EXPECT_EQ(losses(colored, Format::PLY), Names{"colors"});
}

// What no other format has is named, too, wherever it is in the file, and what has no meaning is not.
TEST(Rewritten_files, what_other_formats_lack)
{
  using Names = std::vector<std::string>;
  struct Case
  {
    std::string name, text;
    Names lost;
    Format other = Format::OFF;
  };
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 "
                            "1 0\nendloop\nendfacet\n";
  const auto stl = [](const std::string& header, const std::string& attribute) {
    return header + std::string(80 - header.size(), '\0') + bytes_of<unsigned>({1})
           + bytes_of<float>({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) + attribute;
  };
  const std::string zero(2, '\0');
  const std::string medit
    = "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
      "Tetrahedra\n1\n1 2 3 4 ";
  const std::vector<Case> cases = {
    {"plain.obj", vertices + "s off\nf 1 2 3\ns 0\n", {}},
    {"all.obj",
     "# by hand\n" + vertices
       + "s 1\nf 1 2 3\nl 1 \\\n 2\np 1\nvp 1 2\ncstype bspline\ncurv 0 1 1 2\nend\n",
     {"lines", "points", "curves and surfaces", "smoothing groups", "comments"}},
    {"others.obj", vertices + "f 1 2 3\nusemap none\n", {"other statements"}},
    {"numbers.obj",
     "v 0 0 0 1\nv 1 0 0 1.0\nv 0 1 0\nvt 0 0 0.0\nf 1 2 3\n",
     {"texture coordinates"}},
    {"further.obj",
     "v 0 0 0 2\nv 1 0 0\nv 0 1 0\nvt 0 0 .5\nf 1 2 3\n",
     {"texture coordinates", "further numbers of vertices", "third texture coordinates"}},
    {"last.obj", vertices + "v 0 0 1 1 0 0\nf 1 2 3\n", {"colors"}},
    {"plain.off", "OFF\n3 1 0\n" + points + "3 0 1 2\n", {}},
    {"colored.off",
     "OFF\n3 2 0\n0 0 0\n1 0 0 9 9 9\n0 1 0\n3 0 1 2\n3 0 2 1 9 9 9 # blue\n",
     {"further numbers of vertices", "colors of faces", "comments"},
     Format::OBJ},
    {"map.off",
     "COFF\n3 1 0\n0 0 0 1 2 3\n1 0 0 7\n0 1 0 1 2 3\n3 0 1 2\n",
     {"colors"},
     Format::OBJ},
    {"plain.stl", "solid\n" + facet + "endsolid\n", {}},
    {"named.stl",
     "solid one\n" + facet + "endsolid one\nsolid\n" + facet + "endsolid\n",
     {"solids", "names of solids"}},
    {"plain.bin.stl", stl("", zero), {}},
    {"blank.bin.stl", stl("   ", zero), {}},
    {"header.bin.stl", stl("exported", zero), {"the header"}},
    {"magics.bin.stl",
     stl("COLOR=abcd,MATERIAL=abcdefgh", "\x12\x34"),
     {"colors", "attributes of faces"}},
    {"plain.mesh", medit + "0\nTriangles 0\nEnd\n", {}, Format::VTU},
    {"labels.mesh", medit + "7\nEnd\n", {}, Format::VTU},
    {"labels.mesh", medit + "7\nEnd\n", {"labels"}},
    {"all.mesh",
     medit + "0\nTriangles 1\n1 2 3 4\nCorners\n1\n2\nEnd # of all\n",
     {"the section Triangles", "the section Corners", "comments"},
     Format::VTU},
    {"plain.ply",
     "ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 3\nproperty int x\nproperty "
     "int y\n"
     "property int z\nend_header\n"
       + points,
     {"materials"}},
    {"all.ply",
     "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty float x\nproperty "
     "float y\n"
     "property float z\nproperty float quality\nelement camera 0\nproperty int view\nend_header\n"
     "0 0 0 1\n1 0 0 2\n0 1 0 3\n",
     {"comments", "the element camera", "the property quality"}}};
  for(const Case& c : cases)
  {
    SCOPED_TRACE(c.name);
    Mesh_file mesh = read(c.name, c.text);
    load_appearance(mesh);
    EXPECT_EQ(losses(mesh, c.other), c.lost);
    EXPECT_EQ(losses(mesh, mesh.source->format),
              mesh.source->format == Format::PLY && c.name == "plain.ply"
                ? Names{"integer positions"}
                : Names());
  }
  EXPECT_EQ(losses(read("isolated.obj", vertices + "v 9 9 9\nf 1 2 3\n"), Format::STL),
            Names{"isolated vertices"});
  EXPECT_EQ(losses(read("square.obj", vertices + "v 1 1 0\nf 1 2 4 3\n"), Format::GLB),
            Names{"polygons"});
}

// Two triangles with a right angle between them, which are unfolded: at the hard edge, each side has copies of the
// vertices, with its normal, which turns with its triangle and not with the mean.
TEST(Rewritten_files, normals_at_hard_edges)
{
  const std::string corners = "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 0 1 0 0\n0 1 0 1 0 0\n0 0 1 1 0 0\n";
  const std::string faces = "3 0 1 2\n3 3 4 5\n";
  const std::string unfolded = "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 0 0 0 1\n0 1 0 0 0 1\n-1 0 0 0 0 1\n";
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                          "property float nx\nproperty float ny\nproperty float nz\nelement face 2\n"
                          "property list uchar int vertex_indices\nend_header\n";
  for(const auto& [name, header] : {std::make_pair("hard.off", std::string("NOFF\n6 2 0\n")), std::make_pair("hard.ply", ply)})
  {
    const Mesh_file mesh = read(name, header + corners + faces);
    Points points = mesh.points;
    points[5] = {-1, 0, 0};
    std::ostringstream out;
    rewrite_mesh(out, mesh, points, {});
    expect_same_text(std::regex_replace(out.str(), std::regex("-0\\b"), "0"), header + unfolded + faces);
  }
}

// Corners without a normal stay so.
TEST(Rewritten_files, corners_without_normals)
{
  for(const std::string& corner : {"2//", "2/1/", "2/1", "2"})
  {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 0 1\nvt 0 0\nvn 0 1 0\nf 1//1 " + corner + " 3//1\n";
    EXPECT_NE(rewritten(read("some.obj", text)).find(" " + corner + " 3//1"), std::string::npos);
  }
}

// Normals of vertices in OFF turn, whatever follows them.
TEST(Rewritten_files, normals_of_off)
{
  expect_same_text(
    rewritten(read("normals.off",
                   "STCNOFF\n3 1 0\n0 0 0 0 0 2 9 9 9 1 .5 .5\n1 0 0 0 0 1 8 8 8 1 .5 .25\n"
                   "0 1 0 0 0 1 7 7 7 1 0 0 # last\n3 0 1 2\n")),
    "STCNOFF\n3 1 0\n0 -0 0 0 -2 0 9 9 9 1 .5 .5\n1 -0 0 0 -1 0 8 8 8 1 .5 .25\n"
    "0 -0 1 0 -1 0 7 7 7 1 0 0 # last\n3 0 1 2\n");
}

// So do normals of faces in PLY, each with its face.
TEST(Rewritten_files, normals_of_faces_in_ply)
{
  const std::string header
    = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty float nx\n"
      "property float ny\nproperty float nz\nproperty int label\nend_header\n";
  expect_same_text(rewritten(read("faces.ply", header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0 0 1 77\n")),
                   header + "0 -0 0\n1 -0 0\n0 -0 1\n3 0 1 2 0 -1 0 77\n");
}

// The upper of two triangles with one normal is folded up by a right angle: the normal becomes two, and the indices of
// it and of later ones follow, whether they are absolute or relative.
TEST(Rewritten_files, shared_normals_of_obj)
{
  const std::string text
    = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nvn 0 0 2\nvn 1 0 0\n"
      "vt 0 0\nf 1//1 2//1 3//1\nf 4//1 5//-2 6/1/1\nf 1//2 3//-1 2\n";
  const Mesh_file mesh = read("shared.obj", text);
  Points points = mesh.points;
  points[5] = {5, 0, 1};
  std::ostringstream out;
  rewrite_mesh(out, mesh, points, {});
  expect_same_text(
    out.str(),
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 0 1\nvn 0 0 2\nvn 0 -2 0\nvn 1 0 0\n"
    "vt 0 0\nf 1//1 2//1 3//1\nf 4//2 5//-2 6/1/2\nf 1//3 3//-1 2\n");
  std::ostringstream again;
  rewrite_mesh(again, mesh, mesh.points, {});
  expect_same_text(again.str(), text);
}

// Values of vertices are added, or replace those of the same name.
TEST(Rewritten_files, values_in_ply)
{
  Eigen::VectorXd values(3);
  values << .5, .25, .125;
  const std::string text = "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
                           "property float z\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n"
                           "0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n",
                    expected = "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
                               "property float z\r\nproperty double strain\r\nelement face 1\r\n"
                               "property list uchar int vertex_indices\r\nend_header\r\n"
                               "0 -0 0 .5\r\n1 -0 0 .25\r\n0 -0 1 .125\r\n3 0 1 2\r\n";
  const std::string once = rewritten(read("values.ply", text), {{"strain", values}});
  expect_same_text(once, std::regex_replace(expected, std::regex(" \\."), " 0."));
  const std::string twice = rewritten(read("values.ply", once), {{"strain", 2 * values}});
  EXPECT_NE(twice.find(" 0.5\r\n"), std::string::npos) << twice;
  EXPECT_EQ(twice.find("strain"), twice.rfind("strain"));
}

// Binary PLY keeps its encoding and the types of its numbers.
TEST(Rewritten_files, binary_ply)
{
  for(const bool is_big_endian : {false, true})
  {
    const auto text = [&](const Points& points, const bool has_strain) {
      std::string result = std::string("ply\nformat binary_") + (is_big_endian ? "big" : "little")
                           + "_endian 1.0\nelement vertex 3\nproperty uchar red\nproperty float x\n"
                             "property float y\nproperty float z\n"
                           + (has_strain ? "property double strain\n" : "")
                           + "element face 1\nproperty list uchar int vertex_indices\nproperty ushort label\n"
                             "end_header\n";
      for(std::size_t v = 0; v < 3; ++v)
      {
        result += static_cast<char>(200 + v);
        for(const double x : points[v])
          result += bytes_of<float>({static_cast<float>(x)}, is_big_endian);
        if(has_strain)
          result += bytes_of<double>({.5}, is_big_endian);
      }
      return result + '\3' + bytes_of<int>({0, 1, 2}, is_big_endian)
             + bytes_of<unsigned short>({777}, is_big_endian) + "\n";
    };
    const Mesh_file mesh = read("binary.ply", text({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, .5}}}, false));
    EXPECT_EQ(rewritten(mesh), text(turned_points(mesh), false));
    EXPECT_EQ(rewritten(mesh, {{"strain", Eigen::VectorXd::Constant(3, .5)}}),
              text(turned_points(mesh), true));
  }
}

// An ASCII file as a binary one.
std::string binary_of_ply(const std::string& text, const bool is_big_endian)
{
  struct Property
  {
    std::string count, type; // the count of a list
  };
  std::vector<std::pair<std::size_t, std::vector<Property>>> elements;
  std::istringstream in(text);
  std::string result, line;
  while(result.find("end_header") == std::string::npos && std::getline(in, line))
  {
    std::istringstream words(line);
    std::string keyword, type, name;
    words >> keyword >> type;
    if(keyword == "element" && words >> name)
      elements.push_back({std::stoul(name), {}});
    Property property{"", type};
    if(type == "list")
      words >> property.count >> property.type;
    if(keyword == "property")
      elements.back().second.push_back(property);
    result += keyword == "format"
                ? std::string("format binary_") + (is_big_endian ? "big" : "little") + "_endian 1.0"
                : line;
    result += '\n';
  }
  const auto convert = [&](const std::string& type) {
    std::string word;
    in >> word;
    const double x = std::stod(word);
    result += type == "char"    ? bytes_of<signed char>({static_cast<signed char>(x)})
              : type == "uchar" ? bytes_of<unsigned char>({static_cast<unsigned char>(x)})
              : type == "short" ? bytes_of<short>({static_cast<short>(x)}, is_big_endian)
              : type == "int"   ? bytes_of<int>({static_cast<int>(x)}, is_big_endian)
              : type == "uint"  ? bytes_of<unsigned>({static_cast<unsigned>(x)}, is_big_endian)
              : type == "float" ? bytes_of<float>({static_cast<float>(x)}, is_big_endian)
                                : bytes_of<double>({x}, is_big_endian);
    return x;
  };
  for(const auto& [number, properties] : elements)
    for(std::size_t i = 0; i < number; ++i)
      for(const Property& property : properties)
        for(double n = property.count.empty() ? 1 : convert(property.count); n > 0; --n)
          convert(property.type);
  return result;
}

// Integers cannot hold a pose: they become numbers that can, and nothing else changes.
TEST(Rewritten_files, integers_of_ply)
{
  const auto header = [](const std::string& normal, const std::string& y, const std::string& x,
                         const std::string& strain, const std::string& of_face) {
    return "ply\nformat ascii 1.0\ncomment scanned by hand\nobj_info 7\nelement vertex 3\n"
           "property list uchar short neighbors\nproperty "
           + normal + " nz\nproperty " + normal + " ny\nproperty " + normal
           + " nx\nproperty uchar red\nproperty " + y + " y\nproperty " + x
           + " x\nproperty float z\nproperty " + strain
           + " strain\nelement face 1\nproperty list uchar int vertex_indices\nproperty " + of_face
           + " nz\nproperty int label\nend_header\n";
  };
  Eigen::VectorXd strains(3);
  strains << .5, .25, .125;
  const std::string text = header("char", "short", "uint", "uchar", "short")
                           + "2 7 8 127 0 0 9 0 0 0 1\n0 127 0 0 8 0 4000000001 0 2\n"
                             "0 127 0 0 7 300 0 0 3\n3 0 1 2 5 77\n",
                    expected = header("float", "float", "double", "float", "float")
                               + "2 7 8 0 -127 0 9 -0 0 0 0.5\n0 0 -127 0 8 -0 4000000001 0 0.25\n"
                                 "0 0 -127 0 7 -0 0 300 0.125\n3 0 1 2 0 77\n";
  const Mesh_file mesh = read("integers.ply", text);
  const std::vector<Vertex_values> values = {{"strain", strains}};
  expect_same_text(rewritten(mesh, values), expected);
  EXPECT_EQ(losses(mesh, Format::PLY),
            (std::vector<std::string>{"integer normals", "integer positions"}));
  for(const bool is_big_endian : {false, true})
    EXPECT_EQ(rewritten(read("integers.ply", binary_of_ply(text, is_big_endian)), values),
              binary_of_ply(expected, is_big_endian));
}

// Header and attributes stay, and the normal is that of the triangle.
TEST(Rewritten_files, binary_stl)
{
  const auto bytes = [](const std::vector<float>& numbers) {
    return "solid, nevertheless binary" + std::string(54, '\0') + bytes_of<unsigned>({1})
           + bytes_of(numbers) + "\x12\x34" + "rest";
  };
  const Mesh_file mesh = read("a.stl", bytes({9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0}).substr(0, 134));
  EXPECT_EQ(rewritten(mesh), bytes({0, -1, 0, 0, -0.f, 0, 1, -0.f, 0, 0, -0.f, 1}).substr(0, 134));
}

// What other programs write.
TEST(Rewritten_files, stl_in_other_words)
{
  const std::string text = "SOLID one\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nEND LOOP\n"
                           "END FACET\nENDSOLID\n";
  const Mesh_file mesh = read("capitals.stl", text);
  EXPECT_EQ(mesh.points.size(), 3u);
  EXPECT_EQ(mesh.faces.size(), 1u);
  expect_same_text(rewritten(mesh), "SOLID one\nFACET NORMAL 0 -1 0\nOUTER LOOP\nVERTEX 0 -0 0\nVERTEX 1 -0 0\nVERTEX 0 -0 1\n"
                                    "END LOOP\nEND FACET\nENDSOLID\n");
  const std::string without_faces = "solid a\nfacet normal 0 0 1\nendsolid a\n";
  EXPECT_EQ(rewritten(read("without_faces.stl", without_faces)), without_faces);
  std::string binary = "solid, nevertheless binary" + std::string(54, '\0') + bytes_of<unsigned>({1})
                       + bytes_of<float>({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) + std::string(2, '\0');
  EXPECT_EQ(read("followed.stl", binary + "three more words").faces.size(), 1u);
}

} // namespace test_rewritten_files
