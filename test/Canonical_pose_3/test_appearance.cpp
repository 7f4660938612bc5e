// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Colors, texture coordinates and materials, from one format to another.

#include "written_file.h"

#include "formats/Companion_files.h"
#include "formats/Mesh_file.h"
#include "formats/Shown_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_appearance {

using namespace Canonical_pose_tool;
using Canonical_pose_test::written_file;

const std::string IMAGE = std::string("\x89PNG\r\n\x1a\n") + std::string(100, '\0') + "content";

std::string name_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// A pyramid over a square, with colors and a texture that has a seam at vertex 0; one face is red.
// All numbers are exact in single precision, and all colors in bytes.
Mesh_file pyramid()
{
  const std::string image = written_file("image.png", IMAGE);
  const std::string materials
    = written_file("a.mtl", "newmtl with blanks\nKd .2 .3 .4\nmap_Kd -s 1 1 1 C:\\elsewhere\\"
                              + name_of(image) + "\nnewmtl red\nKd 1 0 0\nd .5\nnewmtl unused\n");
  return read_shown_mesh_file(written_file(
    "a.obj",
    "mtllib " + name_of(materials)
      + "\nv 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 2 2 0 0 0 1\nv 0 2 0 .2 .4 .6\n"
      + "v 1 1 3 1 1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 .75\nvt .5 .125 0\nvn 0 0 -9\nvn .5 0 0\n"
      + "usemtl with blanks\nf 4/-2/1 3/3/1 2/2/1 1/1/1\nf 1/1 2/2 5/5\nf 2/2 3/3/-1 5/5\nf 3/3 "
        "4/4 5/5\n"
      + "usemtl red\nf 4/4 1/5/ 5/5\n"));
}

using Corner = std::tuple<std::array<double, 3>, std::array<float, 2>, Color, std::array<double, 4>,
                          std::string, std::array<float, 3>>;

// What the corners of all faces look like. Quadrangles may have become triangles.
std::set<Corner> corners_of(const Mesh_file& mesh, const bool with_materials,
                            const bool with_normals = false)
{
  const Appearance& appearance = mesh.appearance;
  std::set<Corner> result;
  std::size_t corner = 0;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Material material = with_materials
                                ? appearance.materials.at(appearance.material_of_face.at(f))
                                : Material();
    for(const std::size_t v : mesh.faces[f])
    {
      result.emplace(mesh.points[v], appearance.texture_coordinates.at(corner),
                     appearance.vertex_colors.empty() ? Color() : appearance.vertex_colors.at(v),
                     material.color, material.image,
                     with_normals ? appearance.normals.at(corner) : std::array<float, 3>());
      ++corner;
    }
  }
  return result;
}

// Writes a mesh with the files beside it. Returns their names.
std::set<std::string> write_with_files_beside(const Mesh_file& mesh, const std::string& path,
                                              const bool with_files = true)
{
  std::ostringstream out;
  Companion_files beside{path};
  write_mesh(out, format_of(path, Use::WRITE), mesh, with_files ? &beside : nullptr);
  std::ofstream(path, std::ios::binary) << out.str();
  std::set<std::string> result;
  for(const auto& [name, content] : beside.contents)
  {
    std::ofstream(std::filesystem::path(path).parent_path() / name, std::ios::binary) << content;
    result.insert(name);
  }
  return result;
}

Mesh_file written(const Mesh_file& mesh, const std::string& extension, const bool with_files = true)
{
  const std::string path = written_file("b" + extension, "");
  write_with_files_beside(mesh, path, with_files);
  return read_shown_mesh_file(path);
}

TEST(Appearance, of_a_file)
{
  const Appearance appearance = pyramid().appearance;
  EXPECT_EQ(appearance.vertex_colors[3], (Color{51, 102, 153}));
  EXPECT_EQ(appearance.texture_coordinates[0], (std::array<float, 2>{0, .25f}));
  ASSERT_EQ(appearance.materials.size(), 3u);
  EXPECT_EQ(appearance.materials[0].image, IMAGE);
  EXPECT_EQ(appearance.materials[0].color, (std::array<double, 4>{.2, .3, .4, 1}));
  EXPECT_EQ(appearance.materials[1].color, (std::array<double, 4>{1, 0, 0, .5}));
  EXPECT_EQ(appearance.materials[1].alpha_mode, "BLEND");
  EXPECT_EQ(appearance.materials[2].image, "");
  EXPECT_EQ(appearance.material_of_face, (std::vector<std::size_t>{0, 0, 0, 0, 1}));
  ASSERT_EQ(appearance.normals.size(), 16u);
  EXPECT_EQ(appearance.normals[3], (std::array<float, 3>{0, 0, -1}));
  EXPECT_EQ(appearance.normals[4], (std::array<float, 3>{}));
  EXPECT_EQ(appearance.normals[8], (std::array<float, 3>{1, 0, 0}));
}

TEST(Appearance, is_carried_to_other_formats)
{
  const Mesh_file mesh = pyramid();
  using Names = std::vector<std::string>;
  EXPECT_EQ(corners_of(written(mesh, ".glb"), true), corners_of(mesh, true));
  EXPECT_EQ(corners_of(written(mesh, ".obj"), true, true), corners_of(mesh, true, true));
  EXPECT_EQ(corners_of(written(written(mesh, ".glb"), ".obj"), true), corners_of(mesh, true));
  EXPECT_EQ(losses(mesh, Format::GLB), Names{"polygons"});
  for(const auto& [extension, format] : {std::make_pair(".ply", Format::PLY), std::make_pair(".obj", Format::OBJ)})
  {
    EXPECT_EQ(corners_of(written(mesh, extension), false), corners_of(mesh, false)) << extension;
    EXPECT_EQ(losses(mesh, format), format == Format::OBJ ? Names()
                                                          : (Names{"normals", "colors of materials",
                                                                   "names of materials"}));
  }
  EXPECT_EQ(written(mesh, ".off").appearance.vertex_colors, mesh.appearance.vertex_colors);
  EXPECT_EQ(losses(mesh, Format::OFF), (Names{"normals", "texture coordinates", "materials"}));
  EXPECT_EQ(losses(mesh, Format::STL),
            (Names{"colors", "normals", "texture coordinates", "materials"}));
  // A texture that nobody sees.
  Mesh_file black = mesh;
  black.appearance.materials[0].color = {0, 0, 0, 1};
  EXPECT_EQ(written(written(black, ".glb"), ".obj").appearance.materials.at(0).color,
            black.appearance.materials[0].color);
  // From glTF and PLY back to the others.
  EXPECT_EQ(corners_of(written(written(mesh, ".glb"), ".ply"), false), corners_of(mesh, false));
  EXPECT_EQ(corners_of(written(written(mesh, ".ply"), ".glb"), false), corners_of(mesh, false));
}

std::vector<std::string> attributes_of(const Mesh_file& mesh)
{
  const Appearance& appearance = mesh.appearance;
  std::vector<std::string> result;
  for(const auto& [name, has] :
      {std::make_pair("colors", !appearance.vertex_colors.empty()),
       std::make_pair("normals", !appearance.normals.empty()),
       std::make_pair("texture coordinates", !appearance.texture_coordinates.empty()),
       std::make_pair("materials", appearance.has_materials())})
    if(has)
      result.push_back(name);
  return result;
}

// From each format to each: what is not there afterward is named, once, and nothing else is.
TEST(Appearance, losses_of_all_pairs_of_formats)
{
  const std::string image = name_of(written_file("image.png", IMAGE));
  const std::string materials
    = name_of(written_file("a.mtl", "newmtl shown\nmap_Kd " + image + '\n'));
  const Mesh_file obj = read_shown_mesh_file(written_file(
    "a.obj", "mtllib " + materials
               + "\nv 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 0 2 0 0 0 1\nv 0 0 2 1 1 1\nvt 0 0\nvt 1 0\n"
               + "vt 1 1\nvn -1 0 0\nvn 0 0 1\nvn 0 1 0\nusemtl shown\nf 1/1/1 3/3/1 2/2/2\nf "
                 "1/1/1 2/2/2 4/2/3\n"
               + "f 2/2/2 3/3/1 4/2/3\nf 3/3/1 1/1/1 4/2/3\n"));
  const std::vector<std::string> extensions = {".obj", ".ply", ".stl", ".off", ".glb"};
  for(const std::string& from : extensions)
    for(const bool with_files : {true, false})
    {
      const Mesh_file mesh = written(obj, from, with_files);
      for(const std::string& to : extensions)
      {
        SCOPED_TRACE("from " + from + " to " + to);
        const Mesh_file result = written(mesh, to, with_files);
        std::vector<std::string> lost;
        for(const std::string& name : attributes_of(mesh))
          if(const auto kept = attributes_of(result);
             std::find(kept.begin(), kept.end(), name) == kept.end())
            lost.push_back(name);
        if(to == ".ply" && result.appearance.has_materials()
           && mesh.appearance.materials.at(0).name == "shown")
          lost.push_back("names of materials");
        std::vector<std::string> named
          = losses(mesh, format_of("a" + to, Use::WRITE), false, with_files);
        std::sort(lost.begin(), lost.end());
        std::sort(named.begin(), named.end());
        EXPECT_EQ(named, lost);
        EXPECT_EQ(result.points.size(), 4u);
      }
    }
  EXPECT_EQ(attributes_of(obj).size(), 4u);
  EXPECT_EQ(attributes_of(written(obj, ".ply")), attributes_of(obj));
}

// A cube with a normal per side, to glTF, which splits its vertices: all corners keep theirs. With smooth normals, which PLY
// and OFF hold, none is split. A quarter turn is exact.
TEST(Appearance, normals)
{
  const std::string corners
    = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
  const std::string sides
    = "f 4//1 3//1 2//1 1//1\nf 5//2 6//2 7//2 8//2\nf 1//3 2//3 6//3 5//3\nf 3//4 4//4 8//4 7//4\n"
      "f 4//5 1//5 5//5 8//5\nf 2//6 3//6 7//6 6//6\n";
  const std::string normals = "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn -1 0 0\nvn 1 0 0\n";
  const Mesh_file hard = read_shown_mesh_file(written_file("hard.obj", corners + normals + sides));
  const auto directions = [](const Mesh_file& mesh) {
    std::set<std::pair<std::array<double, 3>, std::array<float, 3>>> result;
    std::size_t corner = 0;
    for(const Face_list::Face face : mesh.faces)
      for(const std::size_t v : face)
        result.emplace(mesh.points[v], mesh.appearance.normals.at(corner++));
    return result;
  };
  EXPECT_EQ(directions(hard).size(), 24u);
  EXPECT_EQ(directions(written(hard, ".glb")), directions(hard));
  EXPECT_EQ(directions(written(hard, ".obj")), directions(hard));
  EXPECT_TRUE(written(hard, ".ply").appearance.normals.empty());
  Mesh_file turned = hard;
  for(std::array<double, 3>& p : turned.points)
    p = {p[0], -p[2], p[1]};
  turn_normals(turned, hard.points);
  const auto all = directions(turned);
  EXPECT_EQ(all.size(), 24u);
  for(const auto& [point, normal] : directions(hard))
    EXPECT_EQ(all.count({{point[0], -point[2], point[1]}, {normal[0], -normal[2], normal[1]}}), 1u);

  const Mesh_file smooth = read_shown_mesh_file(
    written_file("smooth.off", "NOFF\n4 4 0\n0 0 0 -1 0 0\n1 0 0 0 0 -1\n0 1 0 0 1 0\n0 0 1 0 0 "
                               "1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"));
  for(const char* const extension : {".off", ".ply", ".obj", ".glb"})
  {
    EXPECT_EQ(directions(written(smooth, extension)), directions(smooth)) << extension;
    EXPECT_EQ(written(smooth, extension).points, smooth.points);
  }
}

// Colors of results come first; those of the file stay, and its materials are a variant. Numbers of vertices let the
// copies at seams be merged again.
TEST(Appearance, beside_results)
{
  const Mesh_file mesh = pyramid();
  Shown_surface surface;
  surface.mesh = mesh;
  surface.part_of_face = {0, 0, 0, 1, 1};
  surface.origins = {0, 1, 2, 3, 4};
  std::ostringstream out;
  write_glb(out, surface);
  for(const char* const part : {"COLOR_1", "TEXCOORD_0", "KHR_materials_variants", "image/png"})
    EXPECT_NE(out.str().find(part), std::string::npos) << part;
  const Mesh_file shown = read_shown_mesh_file(written_file("parts.glb", out.str()));
  EXPECT_EQ(shown.points, mesh.points);
  EXPECT_EQ(shown.appearance.vertex_colors[1], color_of_part(0));
  EXPECT_EQ(shown.appearance.materials[shown.appearance.material_of_face[0]].image, "");
  EXPECT_EQ(corners_of(shown, false).size(), corners_of(mesh, false).size());
}

// What a file says of colors and textures need not be right; positions and faces are.
TEST(Appearance, defects_are_left_out)
{
  const auto appearance = [](const std::string& name, const std::string& bytes) {
    return read_shown_mesh_file(written_file(name, bytes)).appearance;
  };
  const std::string triangle = "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\n";
  const Appearance obj = appearance("a.obj", "mtllib nothing.mtl\nusemtl none\n" + triangle
                                               + "vt nan .5\nf 1/1 2/ 3\nf 1 2 3\nusemtl\nf 1// 2 3\n");
  EXPECT_EQ(obj.texture_coordinates, (std::vector<std::array<float, 2>>{{0, .5f}, {}, {}, {}, {}, {}, {}, {}, {}}));
  EXPECT_TRUE(obj.vertex_colors.empty()); // not of all vertices
  EXPECT_FALSE(obj.has_materials());
  const Appearance off = appearance(
    "a.off", "COFF\n3 1 0\n0 0 0 .5 0 7.\n1 0 0 0 0 0\n0 1 0 999 -1 0\n3 0 1 2 9 9 9\n");
  EXPECT_EQ(off.vertex_colors, (std::vector<Color>{{128, 0, 255}, {0, 0, 0}, {255, 0, 0}}));
  const Appearance ply = appearance(
    "a.ply",
    "ply\nformat ascii 1.0\ncomment TextureFile a.ply\ncomment TextureFile\nelement vertex "
    "3\nproperty float x\n"
    "property float y\nproperty float z\nproperty float s\nproperty float t\nelement face 2\n"
    "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n0 0 0 "
    ".5 .5\n"
    "1 0 0 1 1\n0 1 0 0 0\n3 0 1 2 6 .25 .75 0 0 0 0\n3 0 1 2 0\n");
  EXPECT_EQ(ply.texture_coordinates, (std::vector<std::array<float, 2>>{{.25f, .25f}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}}));
  EXPECT_FALSE(ply.has_materials());
}

// Faces have one of several textures, as MeshLab writes them; one has none, and one a number of none.
TEST(Appearance, textures_of_ply)
{
  const std::string other = IMAGE + " of another";
  const auto read = [](const std::vector<std::string>& names) {
    std::string text = "ply\nformat ascii 1.0\n";
    for(const std::string& name : names)
      text += "comment TextureFile " + name + "\n";
    return read_shown_mesh_file(written_file(
      "a.ply",
      text
        + "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
          "property list uchar int vertex_indices\nproperty list uchar float texcoord\nproperty int texnumber\n"
          "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1 6 0 0 1 0 0 1 1\n3 0 1 3 6 0 0 1 0 0 1 0\n"
          "3 1 2 3 6 0 0 1 0 0 1 -1\n3 2 0 3 6 0 0 1 0 0 1 7\n"));
  };
  const std::string first = name_of(written_file("a.png", IMAGE)), second = name_of(written_file("b.png", other));
  const Mesh_file mesh = read({first, second});
  const auto image_of_face = [](const Mesh_file& m, const std::size_t f) {
    return m.appearance.materials.at(m.appearance.material_of_face.at(f)).image;
  };
  EXPECT_EQ(image_of_face(mesh, 0), other);
  EXPECT_EQ(image_of_face(mesh, 1), IMAGE);
  EXPECT_EQ(image_of_face(mesh, 2), "");
  EXPECT_EQ(image_of_face(mesh, 3), "");
  using Names = std::vector<std::string>;
  EXPECT_EQ(losses(mesh, Format::PLY), Names());
  EXPECT_EQ(losses(mesh, Format::GLB), Names());
  EXPECT_EQ(losses(mesh, Format::OBJ), Names());
  EXPECT_EQ(losses(mesh, Format::OBJ, false, false), Names{"materials"});
  for(const char* const extension : {".obj", ".ply"})
    for(std::size_t f = 0; f < 4; ++f)
      EXPECT_EQ(image_of_face(written(mesh, extension), f), image_of_face(mesh, f)) << f;
  const Mesh_file glb = written(mesh, ".glb");
  std::multiset<std::string> images; // of the faces, which are in the order of materials there
  for(std::size_t f = 0; f < 4; ++f)
    images.insert(image_of_face(glb, f));
  EXPECT_EQ(images, (std::multiset<std::string>{other, IMAGE, "", ""}));

  const Mesh_file half = read({first, "no such.png"});
  EXPECT_EQ(image_of_face(half, 0), "");
  EXPECT_EQ(image_of_face(half, 1), IMAGE);
  EXPECT_EQ(losses(half, Format::GLB), Names{"the texture 'no such.png'"});
}

// The opacity of vertices, where colors have it.
TEST(Appearance, opacity_of_colors)
{
  const Mesh_file mesh = read_shown_mesh_file(written_file(
    "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
             "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face 1\n"
             "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0 255\n1 0 0 0 255 0 51\n0 1 0 0 0 255 0\n"
             "3 0 1 2\n"));
  const std::vector<unsigned char> opacities = {255, 51, 0};
  EXPECT_EQ(mesh.appearance.vertex_opacities, opacities);
  for(const char* const extension : {".ply", ".off", ".glb"})
    EXPECT_EQ(written(mesh, extension).appearance.vertex_opacities, opacities) << extension;
  EXPECT_EQ(losses(mesh, Format::GLB), std::vector<std::string>());
  EXPECT_EQ(losses(mesh, Format::OBJ), std::vector<std::string>{"the opacity of colors"});
  std::ostringstream glb;
  write_mesh(glb, Format::GLB, mesh);
  EXPECT_NE(glb.str().find("\"alphaMode\":\"BLEND\""), std::string::npos); // otherwise, it would not be seen
  const Mesh_file opaque
    = read_shown_mesh_file(written_file("a.off", "COFF\n3 1 0\n0 0 0 9 9 9 255\n1 0 0 8 8 8 255\n0 1 0 7 7 7 255\n3 0 1 2\n"));
  EXPECT_TRUE(opaque.appearance.vertex_opacities.empty());
}

// What other programs write.
TEST(Appearance, materials)
{
  const std::string image = name_of(written_file("an image.png", IMAGE));
  const auto appearance = [&](const std::string& materials, const std::string& more = {}) {
    const std::string name = name_of(written_file("a.mtl", materials));
    return read_shown_mesh_file(written_file("a.obj", "mtllib nothing.mtl " + name
                                                        + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt .5 .25\n"
                                                        + more
                                                        + "usemtl m # comment\nf 1/1 2/1 3/1\n"))
      .appearance;
  };
  using Color_of_material = std::array<double, 4>;
  const auto color = [&](const std::string& lines) {
    const Appearance read = appearance("\xEF\xBB\xBFnewmtl m\n" + lines);
    return read.materials.at(read.material_of_face.at(0)).color;
  };
  EXPECT_EQ(color("Kd .5\n"), (Color_of_material{.5, .5, .5, 1}));
  EXPECT_EQ(color("Kd nan 2 -1\n"), (Color_of_material{1, 1, 1, 1}));
  EXPECT_EQ(color("Kd xyz .1 .2 .3\n"), (Color_of_material{1, 1, 1, 1}));
  EXPECT_EQ(color("KD .1 .2 .3\nTr 1\nd 0\n"), (Color_of_material{.1, .2, .3, 1}));
  EXPECT_EQ(color("d .5\nTr 1\n")[3], .5);
  for(const std::string& options :
      {"", "-clamp on ", "-s 2 4 1 -o .25 .5 ", "-blendu off -mm 0 1 -s 2 4 -o .25 .5 0 "})
  {
    const Appearance read
      = appearance("newmtl m\nmap_Kd " + options + "elsewhere\\" + image + " # comment\n");
    EXPECT_EQ(read.materials.at(0).image, IMAGE) << options;
    const bool is_moved = options.find("-s") != std::string::npos;
    EXPECT_EQ(read.texture_coordinates[0],
              (is_moved ? std::array<float, 2>{1.25f, -.5f} : std::array<float, 2>{.5f, .75f}))
      << options;
  }
  EXPECT_EQ(appearance("newmtl m\nmap_Kd -s 1 1 1 no such.png\n").missing,
            std::set<std::string>{"the texture 'no such.png'"});
  // A factor of the texture, unless nothing could be seen.
  const std::string texture = "map_Kd " + image + '\n';
  for(const bool is_first : {false, true})
  {
    const auto with = [&](const std::string& factor) {
      return color(is_first ? factor + texture : texture + factor);
    };
    EXPECT_EQ(with("Kd .5 .25 0\n"), (Color_of_material{.5, .25, 0, 1}));
    EXPECT_EQ(with("Kd 0 0 0\n"), (Color_of_material{1, 1, 1, 1}));
    EXPECT_EQ(with("Kd 0\nd .5\n"), (Color_of_material{1, 1, 1, .5}));
  }
  EXPECT_EQ(color("Kd 0 0 0\nmap_Kd no such.png\n"), (Color_of_material{0, 0, 0, 1}));
  // Neither is carried.
  EXPECT_EQ(appearance("newmtl m\nKd 1 1 1\nd 1\n" + texture + "map_d " + image + '\n').missing,
            std::set<std::string>());
  EXPECT_EQ(appearance("newmtl m\nKs 1 1 1\n").missing, std::set<std::string>{OTHER_PROPERTIES});
  for(const char* const map : {"bump", "map_Bump", "map_d"})
    EXPECT_EQ(appearance("newmtl m\n" + texture + map + " other.png\n").missing,
              std::set<std::string>{OTHER_MAPS})
      << map;
}

// OBJ has its materials beside it. Images that are files are not copied; others are, and replace none.
TEST(Appearance, files_beside_obj)
{
  namespace fs = std::filesystem;
  const auto content = [](const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto beside = [](const std::string& path, const std::string& name) {
    return (fs::path(path).parent_path() / name).string();
  };
  using Names = std::set<std::string>;
  const Mesh_file mesh = pyramid();
  const std::string path = written_file("c.obj", ""), stem = fs::path(path).stem().string();
  EXPECT_EQ(write_with_files_beside(mesh, path), Names{stem + ".mtl"});
  const std::string image = name_of(mesh.appearance.materials[0].image_path);
  EXPECT_EQ(content(beside(path, stem + ".mtl")), "newmtl with_blanks\nKd 0.2 0.3 0.4\nd 1\nmap_Kd "
                                                    + image + "\nnewmtl red\nKd 1 0 0\nd 0.5\n");
  EXPECT_NE(content(path).find("\nusemtl red\n"), std::string::npos);

  const std::string folder = testing::TempDir() + "files_beside_obj";
  fs::remove_all(folder);
  fs::create_directories(folder);
  EXPECT_EQ(write_with_files_beside(mesh, folder + "/d.obj"), Names{"d.mtl"});
  EXPECT_NE(content(folder + "/d.mtl").find("map_Kd ../" + image + '\n'), std::string::npos);
  EXPECT_EQ(corners_of(read_shown_mesh_file(folder + "/d.obj"), true, true),
            corners_of(mesh, true, true));

  Mesh_file embedded = written(mesh, ".glb");
  embedded.appearance.materials[0].name = " # a\tb\\\"";
  EXPECT_EQ(write_with_files_beside(embedded, folder + "/- a #1.obj"), (Names{"_ a _1.mtl", "_ a _1_0.png"}));
  EXPECT_EQ(corners_of(read_shown_mesh_file(folder + "/- a #1.obj"), true), corners_of(embedded, true));

  const std::string other = written_file("e.obj", ""), name = fs::path(other).stem().string();
  std::ofstream(beside(other, name + "_0.png")) << "of another shape";
  fs::remove(beside(other, name + "_1.png"));
  EXPECT_EQ(write_with_files_beside(embedded, other), (Names{name + ".mtl", name + "_1.png"}));
  EXPECT_EQ(content(beside(other, name + "_0.png")), "of another shape");
  EXPECT_EQ(content(beside(other, name + "_1.png")), IMAGE);
  EXPECT_EQ(write_with_files_beside(embedded, other), Names{name + ".mtl"}); // it is there
  for(Material& material : embedded.appearance.materials)
  {
    material.name = "same";
    material.alpha_mode = "BLEND";
  }
  write_with_files_beside(embedded, other);
  const Mesh_file again = read_shown_mesh_file(other);
  EXPECT_EQ(corners_of(again, true), corners_of(embedded, true));
  EXPECT_EQ(again.appearance.materials[0].alpha_mode, "BLEND");

  // Neither are materials that inputs name replaced.
  const std::string materials = files_beside(mesh)[0].path;
  const std::string name_of_other = fs::path(materials).stem().string();
  std::ostringstream out;
  Companion_files files{beside(path, name_of_other + ".obj"), {materials}};
  write_mesh(out, Format::OBJ, mesh, &files);
  ASSERT_EQ(files.contents.size(), 1u);
  EXPECT_EQ(files.contents.begin()->first, name_of_other + "_0.mtl");
}

// A pose in another folder has the files beside it that its file names, unless others are there.
TEST(Appearance, files_beside_poses)
{
  namespace fs = std::filesystem;
  const Mesh_file mesh = pyramid();
  const std::string folder = testing::TempDir() + "files_beside_poses";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const auto rewritten = [&](const std::string& path, const Mesh_file& of_file) {
    std::ostringstream out;
    Companion_files beside{path};
    rewrite_mesh(out, of_file, of_file.points, {}, &beside);
    std::ofstream(path, std::ios::binary) << out.str();
    for(const auto& [name, content] : beside.contents)
      std::ofstream(fs::path(path).parent_path() / name, std::ios::binary) << content;
    return beside.contents;
  };
  const std::string materials = fs::path(files_beside(mesh)[0].path).filename().string();
  EXPECT_TRUE(rewritten(testing::TempDir() + "same_folder.obj", mesh).empty());
  const fs::path current = fs::current_path();
  fs::current_path(testing::TempDir()); // what is there does not count, though it is the same
  EXPECT_EQ(rewritten(folder + "/pose.obj", mesh).size(), 2u);
  fs::current_path(current);
  const Mesh_file pose = read_shown_mesh_file(folder + "/pose.obj");
  EXPECT_EQ(corners_of(pose, true), corners_of(mesh, true));
  EXPECT_TRUE(rewritten(folder + "/pose.obj", mesh).empty());
  std::ofstream(folder + '/' + materials) << "of another shape";
  EXPECT_TRUE(rewritten(folder + "/pose.obj", mesh).empty());
  std::vector<std::string> not_copied;
  for(const File_beside& file : files_beside(mesh))
    if(!is_copied(mesh, file, folder + "/pose.obj"))
      not_copied.push_back(file.name);
  EXPECT_EQ(not_copied, std::vector<std::string>{materials});

  // As MeshLab writes it.
  const std::string path = written_file(
    "a.ply",
    "ply\nformat ascii 1.0\ncomment TextureFile <this>_A.png\nelement vertex 3\nproperty float x\n"
    "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
    "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 0 1\n");
  const std::string stem = fs::path(path).stem().string();
  written_file("a_A.png", IMAGE);
  const Mesh_file ply = read_shown_mesh_file(path);
  ASSERT_TRUE(ply.appearance.has_materials());
  EXPECT_EQ(ply.appearance.materials[0].image, IMAGE);
  EXPECT_EQ(rewritten(folder + "/pose.ply", ply).count(stem + "_A.png"), 1u);
  EXPECT_EQ(corners_of(read_shown_mesh_file(folder + "/pose.ply"), true), corners_of(ply, true));
}

TEST(Appearance, ranges_of_colors)
{
  const auto first_color = [](const std::string& name, const std::string& bytes) {
    return read_shown_mesh_file(written_file(name, bytes)).appearance.vertex_colors.at(0);
  };
  EXPECT_EQ(first_color("a.obj", "v 0 0 0 51 0 255\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n"),
            (Color{51, 0, 255}));
  EXPECT_EQ(first_color("b.obj", "v 0 0 0 .2 0 1\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n"),
            (Color{51, 0, 255}));
  // Fractions of which some are whole, and texture coordinates after bytes.
  EXPECT_EQ(first_color("a.off", "COFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 .2 0 1\n0 1 0 0 0 0\n3 0 1 2\n"),
            (Color{0, 0, 255}));
  EXPECT_EQ(
    first_color("a.off",
                "STCOFF\n3 1 0\n0 0 0 51 0 255 .5 .5\n1 0 0 0 0 0 0 0\n0 1 0 0 0 0 0 0\n3 0 1 2\n"),
    (Color{51, 0, 255}));
  for(const auto& [type, numbers] :
      {std::make_pair("uchar", "51 0 255"), std::make_pair("ushort", "13107 0 65535"),
       std::make_pair("short", "51 0 255"), std::make_pair("ushort", "51 0 255"),
       std::make_pair("float", "51 0 255"), std::make_pair("float", ".2 0 1")})
    EXPECT_EQ(
      first_color(
        "a.ply",
        std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                    "property float z\nproperty ")
          + type + " red\nproperty " + type + " green\nproperty " + type
          + " blue\nelement face 1\nproperty list uchar int vertex_indices\n" + "end_header\n0 0 0 "
          + numbers + "\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n"),
      (Color{51, 0, 255}))
      << type;
}

// What is no color, or one of some vertices only, is dropped and named.
TEST(Appearance, incomplete_attributes)
{
  using Names = std::vector<std::string>;
  const auto read = [](const std::string& name, const std::string& bytes) {
    return read_shown_mesh_file(written_file(name, bytes));
  };
  const auto ply = [](const std::string& properties, const std::string& row,
                      const std::string& of_face = "", const std::string& face = "") {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
           "float z\n"
           + properties + "element face 1\nproperty list uchar int vertex_indices\n" + of_face
           + "end_header\n0 0 0 " + row + "\n1 0 0 " + row + "\n0 1 0 " + row + "\n3 0 1 2 " + face
           + "\n";
  };
  const std::string triangle = "1 0 0 .5 .5 .5\n0 1 0 .5 .5 .5\n3 0 1 2\n";
  const std::string list = "property list uchar float texcoord\n";
  const std::vector<std::pair<std::string, std::string>> files = {
    {"some.off", "COFF\n3 1 0\n0 0 0\n" + triangle},
    {"words.off", "COFF\n3 1 0\n0 0 0 red green blue\n" + triangle},
    {"nan.off", "COFF\n3 1 0\n0 0 0 nan .5 .5\n" + triangle},
    {"words.obj", "v 0 0 0 red green blue\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n"},
    {"nan.obj", "v 0 0 0 nan 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n"},
    {"nan.ply", ply("property float red\nproperty float green\nproperty float blue\n", "nan 1 1")},
    {"two.ply", ply("property uchar red\nproperty uchar green\n", "1 2")}};
  for(const auto& [name, bytes] : files)
    EXPECT_EQ(losses(read(name, bytes), Format::GLB), Names{"colors"}) << name;
  EXPECT_EQ(
    losses(read("a.ply", ply("property float nx\nproperty float ny\n", ".6 .8")), Format::GLB),
    (Names{"the property nx", "the property ny"}));
  EXPECT_EQ(losses(read("a.ply", ply("", "", list, "4 0 0 1 0")), Format::GLB),
            Names{"texture coordinates"});
  EXPECT_EQ(
    losses(read("a.ply", ply("property float s\nproperty float t\n", "0 0", list, "6 0 0 1 0 0 1")),
           Format::GLB),
    Names{"texture coordinates of vertices"});
  EXPECT_EQ(losses(read("a.ply", ply("property float s\nproperty float t\n", "0 0")), Format::GLB),
            Names());
}

// What of MTL files is not carried is named.
TEST(Appearance, what_is_not_read_of_materials)
{
  using Names = std::vector<std::string>;
  const auto read = [](const std::string& materials, const std::string& used = "m") {
    return read_shown_mesh_file(written_file(
      "a.obj", "mtllib " + name_of(written_file("a.mtl", materials))
                 + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl " + used + "\nf 1/1 2/1 3/1\n"));
  };
  const auto color = [&](const std::string& line) {
    return read("newmtl m\n" + line + '\n').appearance.materials.at(0).color;
  };
  EXPECT_EQ(color("Kd 255 51 0"), (std::array<double, 4>{1, .2, 0, 1}));
  EXPECT_EQ(color("d -halo 0.25")[3], .25);
  EXPECT_EQ(losses(read("newmtl m\nKd 255 128 0\nd -halo .5\n"), Format::GLB), Names());
  const std::string image = name_of(written_file("image.png", IMAGE));
  for(const std::string& line :
      {std::string("Kd 1.5 0 0"), std::string("Kd 300 0 0"), std::string("Kd xyz .2 .3 .4"),
       std::string("Kd spectral a.rfl"), std::string("Kd -1 0 0"), "map_Kd -clamp on " + image,
       "map_Kd -mm 0 .5 " + image})
    EXPECT_EQ(losses(read("newmtl m\n" + line + '\n'), Format::GLB), Names{OTHER_PROPERTIES})
      << line;
  EXPECT_EQ(losses(read("newmtl Skin\nKd 1 0 0\n", "skin"), Format::GLB),
            Names{"the material 'skin'"});

  // Only the materials are lost.
  const Mesh_file wide = read(std::string("\xFF\xFEn\0", 4));
  EXPECT_EQ(wide.appearance.texture_coordinates.size(), 3u);
  const Names lost = losses(wide, Format::GLB);
  ASSERT_EQ(lost.size(), 2u);
  EXPECT_EQ(lost[0], "materials");
  EXPECT_EQ(lost[1].find("the materials in '"), 0u);
}

} // namespace test_appearance
