// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_PLY_HEADER_H
#define CGAL_CANONICAL_POSE_3_TOOL_PLY_HEADER_H

#include "Text_cursor.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// How a number is stored in a binary file.
struct Ply_number_type
{
  std::size_t size;
  bool is_integer;
  double (*convert)(const char* bytes);
  void (*store)(double value, char* bytes);
  double largest;
};

Ply_number_type ply_number_type_of_float();
Ply_number_type ply_number_type_of_double();

struct Ply_property
{
  std::string name;
  bool is_list = false;
  Ply_number_type count = {}; // of a list
  Ply_number_type value = {};
};

struct Ply_element
{
  std::string name;
  std::size_t number;
  std::vector<Ply_property> properties;

  bool is_vertex() const { return name == "vertex"; }
  bool is_face() const { return name == "face"; }
  bool is_strips() const { return name == "tristrips"; } // of triangles

  // Whether there is a property of each index before `n`.
  bool has_all(std::size_t (*const index_of)(const Ply_property&), const std::size_t n) const
  {
    for(std::size_t k = 0; k < n; ++k)
      if(std::none_of(properties.begin(), properties.end(),
                      [&](const Ply_property& p) { return index_of(p) == k; }))
        return false;
    return true;
  }

  // The element `index` of this type, for messages.
  Element operator[](const std::size_t index) const
  {
    return {is_vertex() ? "vertex" : is_face() ? "face" : "element", index};
  }
};

// Index of the coordinate given by a property of a vertex; 3 if it is not a coordinate.
std::size_t coordinate_of(const Ply_property& property);

// Whether a property of a face, or of strips, is the list of its vertices.
bool is_list_of_vertices(const Ply_property& property);

// Which of u and v a property of a vertex is, by the names of Blender, MeshLab, Open3D and others; 2 if it is none.
std::size_t texture_coordinate_of(const Ply_property& property);

// Which coordinate of a normal a property is; 3 if it is none.
std::size_t normal_coordinate_of(const Ply_property& property);

// Which of red, green, blue and opacity a property of a vertex is; 4 if it is none.
std::size_t channel_of(const Ply_property& property);

// Whether a property of a face is the list of the texture coordinates of its corners, as MeshLab writes it.
bool is_list_of_coordinates(const Ply_property& property);

// Whether a property of a face is the number of its texture, as MeshLab writes it.
bool is_number_of_texture(const Ply_element& element, const Ply_property& property);

// The images that the comments of a header name. In the names, THIS_FILE is that of the file at `path`, without its extension,
// as MeshLab has it.
inline constexpr const char* THIS_FILE = "<this>";
std::vector<std::string> names_of_textures(const std::string& bytes, const std::string& path);

struct Ply_header
{
  bool is_binary = false, is_big_endian = false;
  std::vector<Ply_element> elements;

  // Whether vertices have a property of each index before `n`.
  bool vertices_have_all(std::size_t (*const index_of)(const Ply_property&),
                         const std::size_t n) const
  {
    return std::any_of(elements.begin(), elements.end(), [&](const Ply_element& e) {
      return e.is_vertex() && e.has_all(index_of, n);
    });
  }

  // Whether faces have lists of the texture coordinates of their corners.
  bool has_coordinates_of_corners() const
  {
    return std::any_of(elements.begin(), elements.end(), [](const Ply_element& e) {
      return e.is_face()
             && std::any_of(e.properties.begin(), e.properties.end(), is_list_of_coordinates);
    });
  }

  // A number of binary data: from its bytes, and to them.
  double number_at(const char* bytes, Ply_number_type type) const;
  std::string bytes_of(double number, Ply_number_type type) const;
};

// Reads a header; afterward, `text` is at the first byte of the data. There is then one vertex
// element, with one property each for x, y and z, and at most one face element, with one list of
// vertices if there are faces. Throws std::invalid_argument that names what is missing or
// duplicated.
Ply_header read_ply_header(Text_cursor& text);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_PLY_HEADER_H
