// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_APPEARANCE_H
#define CGAL_CANONICAL_POSE_3_TOOL_APPEARANCE_H

#include "colors.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace Canonical_pose_tool {

// How an image is shown between and beside its pixels, by the numbers of glTF; -1: not stated.
struct Sampler
{
  int mag_filter = -1, min_filter = -1, wrap_s = -1, wrap_t = -1;

  auto values() const { return std::tie(mag_filter, min_filter, wrap_s, wrap_t); }
  bool operator<(const Sampler& other) const { return values() < other.values(); }
};

// Another image of a material of glTF, with the texture coordinates of that of the color.
struct Material_map
{
  std::string image; // the content of its file
  Sampler sampler;
};

struct Material
{
  std::string name;
  std::array<double, 4> color = {1, 1, 1, 1}; // linear, with opacity; a factor if there is an image
  std::string alpha_mode = "OPAQUE";          // this and the next: of glTF
  double alpha_cutoff = 0.5;
  bool is_double_sided = true; // surfaces may be open
  std::string image;           // the content of its file
  std::string image_path;      // if that is not within the file of the mesh
  Sampler sampler;
  // The following is of glTF; no other format has it.
  double metallic = 0, roughness = 0.8, strength_of_normals = 1, strength_of_occlusion = 1;
  std::array<double, 3> emission = {0, 0, 0};
  Material_map metallic_roughness_map, normal_map, occlusion_map, emission_map;
  std::array<double, 2> scale = {1, 1},
                        offset = {0, 0}; // of texture coordinates while they are read

  bool is_black() const { return color[0] == 0 && color[1] == 0 && color[2] == 0; }

  // Whether it has numbers that materials of no other format have, and that are neither those of other formats nor the
  // default of glTF.
  bool has_numbers_of_gltf() const
  {
    const auto numbers = [](const Material& m) {
      return std::tie(m.metallic, m.roughness, m.strength_of_normals, m.strength_of_occlusion,
                      m.emission);
    };
    const Material plain;
    Material default_of_gltf;
    default_of_gltf.metallic = default_of_gltf.roughness = 1;
    return (numbers(*this) != numbers(plain) && numbers(*this) != numbers(default_of_gltf))
           || alpha_mode == "MASK" || Sampler() < sampler;
  }
};

// Names of what is lost.
inline constexpr const char* OPACITY_OF_COLORS = "the opacity of colors";
inline constexpr const char* OTHER_MAPS = "maps of materials other than colors";
inline constexpr const char* OTHER_PROPERTIES = "other properties of materials";

// What a surface has beside its shape, as far as several formats have it. What is empty, it does not have.
struct Appearance
{
  std::vector<Color> vertex_colors;
  std::vector<unsigned char> vertex_opacities;           // if not all are opaque
  std::vector<std::array<float, 2>> texture_coordinates; // of the corners of all faces; (0, 0) is the upper left
  std::vector<std::array<float, 3>> normals;             // of the corners of all faces; 0: none
  std::vector<Material> materials;
  std::vector<std::size_t> material_of_face;
  std::set<std::string> missing; // what the file names, but what was not found, for messages

  bool has_materials() const { return !material_of_face.empty(); }
  // Of a face or more.
  template <class Holds>
  bool has_material(const Holds& holds) const
  {
    return std::any_of(material_of_face.begin(), material_of_face.end(),
                       [&](const std::size_t m) { return holds(materials[m]); });
  }
  bool has_images() const // that are shown
  {
    return !texture_coordinates.empty()
           && has_material([](const Material& m) { return !m.image.empty(); });
  }
  bool has_other_maps() const
  {
    return std::any_of(materials.begin(), materials.end(), [](const Material& m) {
      return !(m.metallic_roughness_map.image + m.normal_map.image + m.occlusion_map.image
               + m.emission_map.image)
                .empty();
    });
  }
};

class Text_cursor;

// What follows on this line, without a comment, blanks around it, and quotation marks.
std::string rest_of_line(Text_cursor& text);

// The path of a file that the one at `path` names, there or in the same folder, and its content; empty if there is none.
std::string path_beside(const std::string& path, std::string name);
std::string content_beside(const std::string& path, const std::string& name);
std::string content_of(const std::string& path);

// Gives a material the image of this name, found in the same way; if there is none, that is noted.
void load_image_beside(const std::string& path, const std::string& name, Appearance& appearance,
                       Material& material);

// Reads the materials of an MTL file beside the one at `path`. `indices`: of the materials by name. Returns whether there
// is such a file.
bool load_mtl(const std::string& path, const std::string& name, Appearance& appearance,
              std::map<std::string, std::size_t>& indices);

// The images that an MTL file names.
std::vector<std::string> images_of_mtl(const std::string& bytes);

// The type of an image by its content; empty if it is of no type that glTF holds.
std::string type_of_image(const std::string& bytes);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_APPEARANCE_H
