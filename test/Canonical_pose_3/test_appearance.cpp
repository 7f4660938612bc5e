// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Colors, texture coordinates and materials, from one format to another.

#include "written_file.h"

#include "formats/Mesh_file.h"
#include "formats/Shown_surface.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <fstream>
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
    = written_file("a.mtl", "newmtl with blanks\nKd .2 .3 .4\nmap_Kd -s 1 1 1 C:\\elsewhere\\" + name_of(image)
                              + "\nnewmtl red\nKd 1 0 0\nd .5\nnewmtl lost\nmap_Kd nothing.png\n");
  return read_shown_mesh_file(written_file(
    "a.obj", "mtllib " + name_of(materials) + "\nv 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 2 2 0 0 0 1\nv 0 2 0 .2 .4 .6\n"
               + "v 1 1 3 1 1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 .75\nvt .5 .125 0\nusemtl with blanks\nf 4/-2 3/3 2/2 1/1\n"
               + "f 1/1 2/2 5/5\nf 2/2 3/3 5/5\nf 3/3 4/4 5/5\nusemtl red\nf 4/4 1/5/ 5/5\n"));
}

using Corner = std::tuple<std::array<double, 3>, std::array<float, 2>, Color, std::array<double, 4>, std::string>;

// What the corners of all faces look like. Quadrangles may have become triangles.
std::set<Corner> corners_of(const Mesh_file& mesh, const bool with_materials)
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
      result.emplace(mesh.points[v], appearance.texture_coordinates.at(corner++),
                     appearance.vertex_colors.at(v), material.color, material.image);
  }
  return result;
}

Mesh_file written(const Mesh_file& mesh, const std::string& extension)
{
  std::ostringstream out;
  const std::string path = written_file("b" + extension, "");
  write_mesh(out, format_of(path, Use::WRITE), mesh);
  std::ofstream(path, std::ios::binary) << out.str();
  return read_shown_mesh_file(path);
}

TEST(Appearance, of_a_file)
{
  const Appearance appearance = pyramid().appearance;
  EXPECT_EQ(appearance.vertex_colors[3], (Color{51, 102, 153}));
  EXPECT_EQ(appearance.texture_coordinates[0], (std::array<float, 2>{0, .25f}));
  ASSERT_EQ(appearance.materials.size(), 3u);
  EXPECT_EQ(appearance.materials[0].image, IMAGE);
  EXPECT_EQ(appearance.materials[0].color, (std::array<double, 4>{1, 1, 1, 1}));
  EXPECT_EQ(appearance.materials[1].color, (std::array<double, 4>{1, 0, 0, .5}));
  EXPECT_EQ(appearance.materials[1].alpha_mode, "BLEND");
  EXPECT_EQ(appearance.materials[2].image, "");
  EXPECT_EQ(appearance.material_of_face, (std::vector<std::size_t>{0, 0, 0, 0, 1}));
}

TEST(Appearance, is_carried_to_other_formats)
{
  const Mesh_file mesh = pyramid();
  using Names = std::vector<std::string>;
  EXPECT_EQ(corners_of(written(mesh, ".glb"), true), corners_of(mesh, true));
  EXPECT_EQ(losses(mesh, Format::GLB), Names());
  for(const auto& [extension, format] : {std::make_pair(".ply", Format::PLY), std::make_pair(".obj", Format::OBJ)})
  {
    EXPECT_EQ(corners_of(written(mesh, extension), false), corners_of(mesh, false)) << extension;
    EXPECT_EQ(losses(mesh, format), format == Format::OBJ ? Names() : Names{"materials"});
  }
  EXPECT_EQ(written(mesh, ".off").appearance.vertex_colors, mesh.appearance.vertex_colors);
  EXPECT_EQ(losses(mesh, Format::OFF), (Names{"texture coordinates", "materials"}));
  EXPECT_EQ(losses(mesh, Format::STL), (Names{"colors", "texture coordinates", "materials"}));
  // From glTF and PLY back to the others.
  EXPECT_EQ(corners_of(written(written(mesh, ".glb"), ".ply"), false), corners_of(mesh, false));
  EXPECT_EQ(corners_of(written(written(mesh, ".ply"), ".glb"), false), corners_of(mesh, false));
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
                                               + "vt nan .5\nf 1/1 2/7 3/-9\nf 1 2 3\nusemtl\nf 1//4 2 3\n");
  EXPECT_EQ(obj.texture_coordinates, (std::vector<std::array<float, 2>>{{0, .5f}, {}, {}, {}, {}, {}, {}, {}, {}}));
  EXPECT_TRUE(obj.vertex_colors.empty()); // not of all vertices
  EXPECT_FALSE(obj.has_materials());
  const Appearance off
    = appearance("a.off", "COFF\n3 1 0\n0 0 0 .5 0 7.\n1 0 0\n0 1 0 999 -1 x\n3 0 1 2 9 9 9\n");
  EXPECT_EQ(off.vertex_colors, (std::vector<Color>{{128, 0, 255}, {0, 0, 0}, {255, 0, 0}}));
  const Appearance ply = appearance(
    "a.ply", "ply\nformat ascii 1.0\ncomment TextureFile a.ply\ncomment TextureFile\nelement vertex 3\nproperty float x\n"
             "property float y\nproperty float z\nproperty float s\nproperty float t\nelement face 2\n"
             "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n0 0 0 .5 .5\n"
             "1 0 0 1 1\n0 1 0 0 0\n3 0 1 2 2 .25 .75\n3 0 1 2 0\n");
  EXPECT_EQ(ply.texture_coordinates, (std::vector<std::array<float, 2>>{{.25f, .25f}, {0, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}}));
  EXPECT_FALSE(ply.has_materials());
}

} // namespace test_appearance
