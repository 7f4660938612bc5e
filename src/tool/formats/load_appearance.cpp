// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The appearance of surfaces in OFF, OBJ and PLY.

#include "Mesh_file.h"
#include "Ply_header.h"
#include "Vertex_rotations.h"
#include "readers.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// What vertices have, for the corners of faces.
template <class Value>
std::vector<Value> at_corners(const std::vector<Value>& values, const Face_list& faces)
{
  std::vector<Value> result;
  for(const Face_list::Face face : faces)
    for(const std::size_t v : face)
      result.push_back(values[v]);
  return result;
}

// Red, green, blue and opacity as they are read. What is not finite is no color.
using Read_color = std::array<double, 4>;

// Takes colors if each vertex has one. `largest`: of each channel.
void take_colors(const std::vector<Read_color>& colors, const Read_color& largest,
                 Appearance& appearance)
{
  if(std::any_of(colors.begin(), colors.end(), [](const Read_color& color) {
       return !std::all_of(color.begin(), color.end(),
                           [](const double x) { return std::isfinite(x); });
     }))
    return;
  for(const Read_color& color : colors)
  {
    std::array<unsigned char, 4> bytes;
    for(std::size_t k = 0; k < 4; ++k)
      bytes[k] = byte_of(color[k], largest[k]);
    appearance.vertex_colors.push_back({bytes[0], bytes[1], bytes[2]});
    appearance.vertex_opacities.push_back(bytes[3]);
  }
}

constexpr double OPAQUE = 255; // on all scales
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

// Of colors that are not integers: up to 1, or a little above, or up to 255.
double largest_of_numbers(const double most) { return most > 2 ? 255 : 1; }

// Colors are numbers up to 1 if any of them is written with a point, and up to 255 otherwise.
void load_off(const std::string& bytes, const Mesh_file& mesh, Appearance& appearance)
{
  Text_cursor text(bytes);
  const std::string_view letters = Off_header(text).letters;
  const auto has
    = [&](const char* const some) { return letters.find_first_of(some) != std::string_view::npos; };
  const bool has_colors = has("C"), has_normals = has("N"), has_coordinates = has("ST");
  if(!has_colors && !has_normals)
    return;
  std::vector<std::array<float, 3>> normals;
  std::vector<Read_color> colors;
  bool is_fraction = false;
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    text.word();
    text.word_on_line();
    text.word_on_line();
    if(has_normals)
      for(float& x : normals.emplace_back())
        x = static_cast<float>(text.number_or(text.word_on_line(), 0));
    Read_color& color = colors.emplace_back();
    color.fill(NOT_A_NUMBER);
    std::size_t channels = 0;
    for(std::string_view word;
        channels < (has_coordinates ? 3 : 4) && !(word = text.word_on_line()).empty();)
    {
      is_fraction = is_fraction || word.find('.') != std::string_view::npos;
      color[channels++] = text.number_or(word, NOT_A_NUMBER);
    }
    if(channels == 3)
      color[3] = OPAQUE;
    text.skip_line();
  }
  const double largest = is_fraction ? 1 : 255;
  if(has_colors)
    take_colors(colors, {largest, largest, largest, largest}, appearance);
  if(has_normals)
    appearance.normals = at_corners(normals, mesh.faces);
}

// The values of these indices, 0 for others; none if there is no index at all.
template <class Value>
void take_values(const std::vector<Value>& values, const std::vector<long long>& indices,
                 std::vector<Value>& result)
{
  const auto exists
    = [&](const long long i) { return i >= 0 && static_cast<std::size_t>(i) < values.size(); };
  if(std::none_of(indices.begin(), indices.end(), exists))
    return;
  for(const long long i : indices)
    result.push_back(exists(i) ? values[static_cast<std::size_t>(i)] : Value());
}

// Moves texture coordinates as materials have it.
void transform_coordinates(const Face_list& faces, Appearance& appearance)
{
  std::size_t corner = 0;
  for(std::size_t f = 0; f < faces.size() && !appearance.texture_coordinates.empty(); ++f)
  {
    const Material& material = appearance.materials[appearance.material_of_face[f]];
    for(std::size_t i = 0; i < faces[f].size(); ++i)
    {
      auto& [u, v]
        = appearance.texture_coordinates[corner++]; // v is downward here, and upward in OBJ
      u = static_cast<float>(material.offset[0] + material.scale[0] * static_cast<double>(u));
      v = static_cast<float>(1 - material.offset[1]
                             - material.scale[1] * (1 - static_cast<double>(v)));
    }
  }
}

void load_obj(const std::string& bytes, const std::string& path, const Face_list& faces,
              Appearance& appearance)
{
  std::vector<std::array<float, 2>> coordinates;
  std::vector<std::array<float, 3>> normals;
  std::vector<long long> indices_of_corners, normals_of_corners; // from 0; -1: none
  std::map<std::string, std::size_t> materials;
  std::set<std::string> unknown; // materials
  std::optional<std::size_t> material;
  std::vector<Read_color> colors;
  double most = 0;
  bool has_colors = true;
  Text_cursor text(bytes, Text_cursor::Lines::CONTINUED);
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
    if(word == "v" && has_colors)
    {
      for(int k = 0; k < 3; ++k)
        text.word_on_line();
      Read_color& color = colors.emplace_back();
      for(std::size_t k = 0; k < 3; ++k)
      {
        word = text.word_on_line();
        has_colors = has_colors && !word.empty();
        color[k] = text.number_or(word, NOT_A_NUMBER);
        most = (std::max)(most, color[k]);
      }
      color[3] = OPAQUE;
    }
    else if(word == "vt")
    {
      const double u = text.number_or(text.word_on_line(), 0);
      const double v = text.number_or(text.word_on_line(), 0);
      coordinates.push_back({static_cast<float>(u), static_cast<float>(1 - v)});
    }
    else if(word == "vn")
      for(float& x : normals.emplace_back())
        x = static_cast<float>(text.number_or(text.word_on_line(), 0));
    else if(word == "mtllib")
    {
      const std::string name = rest_of_line(text);
      if(!load_mtl(path, name, appearance, materials)) // or several names, with blanks between them
        for(Text_cursor names(name); !(word = names.word()).empty();)
          load_mtl(path, std::string(word), appearance, materials);
    }
    else if(word == "usemtl")
    {
      const std::string name = rest_of_line(text);
      const auto found = materials.find(name);
      material = found == materials.end() ? std::nullopt : std::optional(found->second);
      if(found == materials.end() && !name.empty())
        unknown.insert("the material " + Text_cursor::shown(name));
    }
    else if(is_face_of_obj(word))
    {
      for(word = text.word_on_line(); !word.empty(); word = text.word_on_line())
      {
        // The next index after a slash, from 0.
        const auto next_index = [&](const std::size_t number) {
          word.remove_prefix((std::min)(word.find('/'), word.size()));
          word.remove_prefix((std::min)(std::size_t(1), word.size()));
          const double index = text.number_or(word.substr(0, word.find('/')), 0);
          return static_cast<long long>(index < 0 ? static_cast<double>(number) + index
                                                  : index - 1);
        };
        indices_of_corners.push_back(next_index(coordinates.size()));
        normals_of_corners.push_back(next_index(normals.size()));
      }
      appearance.material_of_face.push_back(material.value_or(std::size_t(-1)));
    }
  if(has_colors)
  {
    const double largest = largest_of_numbers(most);
    take_colors(colors, {largest, largest, largest, largest}, appearance);
  }
  take_values(coordinates, indices_of_corners, appearance.texture_coordinates);
  take_values(normals, normals_of_corners, appearance.normals);
  // Faces without a material have another one.
  if(appearance.materials.empty())
    appearance.material_of_face.clear();
  else
    appearance.missing.insert(unknown.begin(), unknown.end());
  if(std::count(appearance.material_of_face.begin(), appearance.material_of_face.end(),
                std::size_t(-1))
     > 0)
  {
    std::replace(appearance.material_of_face.begin(), appearance.material_of_face.end(),
                 std::size_t(-1), appearance.materials.size());
    appearance.materials.emplace_back();
  }
  if(appearance.has_materials())
    transform_coordinates(faces, appearance);
}

// Materials with the images that comments name, and a plain one for other numbers.
void load_textures_of_ply(const std::string& bytes, const std::string& path,
                          const std::vector<double>& texture_of_face, Appearance& appearance)
{
  const std::vector<std::string> names = names_of_textures(bytes, path);
  for(const std::string& name : names)
    load_image_beside(path, name, appearance, appearance.materials.emplace_back());
  appearance.materials.emplace_back();
  for(const double number : texture_of_face)
    appearance.material_of_face.push_back(number >= 0 && number < static_cast<double>(names.size())
                                            ? static_cast<std::size_t>(number)
                                            : names.size());
  const auto has_image = [](const Material& material) { return !material.image.empty(); };
  if(std::none_of(appearance.materials.begin(), appearance.materials.end(), has_image))
  {
    appearance.materials.clear();
    appearance.material_of_face.clear();
  }
}

// `most`: of the colors of this type. Some programs write bytes as larger numbers.
double largest_color(const Ply_number_type type, const double most)
{
  return !type.is_integer                  ? largest_of_numbers(most)
         : type.size == 2 && most > OPAQUE ? type.largest
                                           : 255;
}

// The largest values of the channels. Each has the scale of others of its type, but opacities up to 1 may be beside
// colors up to 255.
Read_color largest_colors(const std::vector<Read_color>& colors,
                          const std::array<Ply_number_type, 5>& types)
{
  Read_color most = {}, result;
  for(const Read_color& color : colors)
    for(std::size_t k = 0; k < 4; ++k)
      most[k] = (std::max)(most[k], color[k]);
  for(std::size_t k = 0; k < 4; ++k)
  {
    double most_of_type = most[k];
    for(std::size_t other = 0; other < 3; ++other)
      if(types[other].convert == types[k].convert && (k < 3 || types[k].is_integer))
        most_of_type = (std::max)(most_of_type, most[other]);
    result[k] = largest_color(types[k], most_of_type);
  }
  return result;
}

void load_ply(const std::string& bytes, const std::string& path, const Face_list& faces,
              Appearance& appearance)
{
  Text_cursor text(bytes);
  const Ply_header header = read_ply_header(text);
  const bool has_colors = header.vertices_have_all(channel_of, 3);
  const bool is_of_vertices = header.vertices_have_all(texture_coordinate_of, 2);
  const bool is_of_corners = header.has_coordinates_of_corners();
  const bool has_normals = header.vertices_have_all(normal_coordinate_of, 3);
  if(!has_colors && !is_of_vertices && !is_of_corners && !has_normals)
    return;
  const char* byte = text.position();
  const auto next = [&](const Ply_number_type type) {
    if(!header.is_binary)
      return text.number_or(text.word(), 0);
    const double number = header.number_at(byte, type);
    byte += type.size;
    return number;
  };
  std::vector<std::array<float, 2>> of_vertices;
  std::vector<std::array<float, 3>> normals;
  std::vector<double> texture_of_face;
  std::vector<Read_color> colors;
  std::array<Ply_number_type, 5> types = {}; // of the channels
  bool are_corners_complete = true;
  std::size_t f = 0;
  for(const Ply_element& element : header.elements)
    for(std::size_t i = 0; i < element.number && !element.properties.empty(); ++i)
    {
      std::array<double, 3> coordinates = {};
      std::array<double, 5> color = {0, 0, 0, OPAQUE, 0};
      std::array<double, 4> normal = {};
      std::vector<double> of_corners;
      double texture = 0;
      for(const Ply_property& property : element.properties)
        if(property.is_list)
          for(auto n = static_cast<std::size_t>(next(property.count)); n > 0; --n)
          {
            const double value = next(property.value);
            if(element.is_face() && is_list_of_coordinates(property))
              of_corners.push_back(value);
          }
        else
        {
          const double value = next(property.value);
          coordinates[texture_coordinate_of(property)] = value;
          normal[normal_coordinate_of(property)] = value;
          color[channel_of(property)] = value;
          if(element.is_vertex())
            types[channel_of(property)] = property.value;
          if(is_number_of_texture(element, property))
            texture = value;
        }
      if(element.is_face())
        texture_of_face.push_back(texture);
      if(element.is_vertex() && has_colors)
        colors.push_back({color[0], color[1], color[2], color[3]});
      if(element.is_vertex() && has_normals)
        normals.push_back({static_cast<float>(normal[0]), static_cast<float>(normal[1]),
                           static_cast<float>(normal[2])});
      if(element.is_vertex() && is_of_vertices)
        of_vertices.push_back(
          {static_cast<float>(coordinates[0]), static_cast<float>(1 - coordinates[1])});
      if(element.is_face() && is_of_corners)
      {
        are_corners_complete = are_corners_complete
                               && (of_corners.empty() || of_corners.size() == 2 * faces[f].size());
        of_corners.resize(2 * faces[f].size());
        for(std::size_t k = 0; k < faces[f].size(); ++k)
          appearance.texture_coordinates.push_back({static_cast<float>(of_corners[2 * k]),
                                                    static_cast<float>(1 - of_corners[2 * k + 1])});
        ++f;
      }
    }
  if(has_colors)
    take_colors(colors, largest_colors(colors, types), appearance);
  if(!are_corners_complete)
    appearance.texture_coordinates.clear();
  if(!is_of_corners && is_of_vertices)
    appearance.texture_coordinates = at_corners(of_vertices, faces);
  if(has_normals)
    appearance.normals = at_corners(normals, faces);
  texture_of_face.resize(faces.size()); // strips have the first texture
  if(!appearance.texture_coordinates.empty())
    load_textures_of_ply(bytes, path, texture_of_face, appearance);
}

} // namespace

std::vector<std::array<float, 3>> normals_of_vertices(const Mesh_file& mesh)
{
  const std::vector<std::array<float, 3>>& of_corners = mesh.appearance.normals;
  if(of_corners.empty())
    return {};
  std::vector<std::array<float, 3>> result(mesh.points.size());
  std::vector<bool> is_known(result.size(), false);
  std::size_t corner = 0;
  for(const Face_list::Face face : mesh.faces)
    for(const std::size_t v : face)
    {
      const std::array<float, 3>& normal = of_corners[corner++];
      if(is_known[v] && normal != result[v])
        return {};
      is_known[v] = true;
      result[v] = normal;
    }
  return result;
}

void turn_normals(Mesh_file& mesh, const Points& before)
{
  std::vector<std::array<float, 3>>& normals = mesh.appearance.normals;
  if(normals.empty())
    return;
  const auto vector
    = [](const std::array<float, 3>& n) { return Eigen::Vector3d(n[0], n[1], n[2]); };
  Corner_rotations rotations(mesh, before, mesh.points);
  std::size_t i = 0;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    for(std::size_t k = 0; k < mesh.faces[f].size(); ++k)
      rotations.add(f, k, vector(normals[i++]));
  i = 0;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    for(std::size_t k = 0; k < mesh.faces[f].size(); ++k, ++i)
    {
      const Eigen::Vector3f turned = rotations(f, k, vector(normals[i])).cast<float>();
      normals[i] = {turned[0], turned[1], turned[2]};
    }
}

void load_appearance(Mesh_file& mesh)
try
{
  mesh.appearance = Appearance();
  if(!mesh.source)
    return;
  const std::string &bytes = mesh.source->bytes, &path = mesh.source->path;
  switch(mesh.source->format)
  {
  case Format::OFF:
    load_off(bytes, mesh, mesh.appearance);
    break;
  case Format::OBJ:
    load_obj(bytes, path, mesh.faces, mesh.appearance);
    break;
  case Format::PLY:
    load_ply(bytes, path, mesh.faces, mesh.appearance);
    break;
  case Format::GLB:
    load_appearance_of_gltf(mesh);
    break;
  default:;
  }
  // Opaque, or all invisible, which nobody means.
  std::vector<unsigned char>& opacities = mesh.appearance.vertex_opacities;
  if(const auto [least, most] = std::minmax_element(opacities.begin(), opacities.end());
     least != opacities.end() && (*least == 255 || *most <= 1))
    opacities.clear();
  for(std::array<float, 2>& coordinates : mesh.appearance.texture_coordinates)
    for(float& x : coordinates)
      x = std::isfinite(x) ? x : 0;
  for(std::array<float, 3>& normal : mesh.appearance.normals)
  {
    const Eigen::Vector3d direction
      = Eigen::Vector3d(normal[0], normal[1], normal[2]).stableNormalized();
    for(std::size_t k = 0; k < 3; ++k)
      normal[k]
        = direction.allFinite() ? static_cast<float>(direction[static_cast<Eigen::Index>(k)]) : 0;
  }
}
catch(const std::invalid_argument&) // of glTF that cannot be in one file
{
  mesh.appearance = Appearance();
}

} // namespace Canonical_pose_tool
