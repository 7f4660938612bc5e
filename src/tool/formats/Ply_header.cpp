// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_header.h"
#include "Appearance.h"
#include "Mesh_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace Canonical_pose_tool {

namespace {

std::invalid_argument on_line(const Text_cursor& text, const std::string& defect)
{
  return std::invalid_argument("line " + std::to_string(text.line()) + ": " + defect);
}

template <class T>
Ply_number_type number_type()
{
  return {sizeof(T), std::is_integral_v<T>,
          [](const char* bytes) {
            T value;
            std::memcpy(&value, bytes, sizeof(T));
            return static_cast<double>(value);
          },
          [](const double value, char* bytes) {
            const auto stored = static_cast<T>(value);
            std::memcpy(bytes, &stored, sizeof(T));
          },
          static_cast<double>((std::numeric_limits<T>::max)())};
}

Ply_number_type read_number_type(const Text_cursor& text, const std::string_view name)
{
  static const std::map<std::string_view, Ply_number_type> types
    = {{"char", number_type<std::int8_t>()},     {"int8", number_type<std::int8_t>()},
       {"uchar", number_type<std::uint8_t>()},   {"uint8", number_type<std::uint8_t>()},
       {"short", number_type<std::int16_t>()},   {"int16", number_type<std::int16_t>()},
       {"ushort", number_type<std::uint16_t>()}, {"uint16", number_type<std::uint16_t>()},
       {"int", number_type<std::int32_t>()},     {"int32", number_type<std::int32_t>()},
       {"uint", number_type<std::uint32_t>()},   {"uint32", number_type<std::uint32_t>()},
       {"float", number_type<float>()},          {"float32", number_type<float>()},
       {"double", number_type<double>()},        {"float64", number_type<double>()}};
  const auto found = types.find(name);
  if(found == types.end())
    throw on_line(text, "the type of the property is unknown");
  return found->second;
}

void read_format(Text_cursor& text, Ply_header& header)
{
  const std::string_view name = text.word_on_line();
  header.is_binary = name != "ascii";
  header.is_big_endian = name == "binary_big_endian";
  if(header.is_binary && !header.is_big_endian && name != "binary_little_endian")
    throw on_line(text, "the format is unknown");
}

void read_element(Text_cursor& text, Ply_header& header)
{
  Ply_element element{std::string(text.word_on_line()), 0, {}};
  const std::string name = Text_cursor::shown(element.name);
  element.number
    = text.count(text.word_on_line(), Element{("the number of elements " + name).c_str()});
  for(const Ply_element& other : header.elements)
    if(other.name == element.name)
      throw on_line(text, "there is a second element " + name);
  if(std::any_of(header.elements.begin(), header.elements.end(), [&](const Ply_element& other) {
       return (other.is_face() && element.is_strips()) || (other.is_strips() && element.is_face());
     }))
    throw on_line(text, "both faces and triangle strips");
  header.elements.push_back(element);
}

void read_property(Text_cursor& text, Ply_header& header)
{
  if(header.elements.empty())
    throw on_line(text, "a property without an element");
  Ply_property property;
  std::string_view word = text.word_on_line();
  property.is_list = word == "list";
  if(property.is_list)
  {
    property.count = read_number_type(text, text.word_on_line());
    word = text.word_on_line();
  }
  property.value = read_number_type(text, word);
  property.name = text.word_on_line();
  header.elements.back().properties.push_back(property);
}

void check_vertex(const Ply_element& vertex)
{
  for(std::size_t k = 0; k < 3; ++k)
  {
    const std::string name(1, "xyz"[k]);
    std::size_t number = 0;
    for(const Ply_property& property : vertex.properties)
      if(coordinate_of(property) == k)
      {
        ++number;
        if(property.is_list)
          throw std::invalid_argument("the header announces " + name + " of a vertex as a list");
      }
    if(number == 0)
      throw std::invalid_argument("the header does not announce " + name + " of a vertex");
    if(number > 1)
      throw std::invalid_argument("the header announces " + name + " of a vertex "
                                  + std::to_string(number) + " times");
  }
}

void check_face(const Ply_element& face)
{
  const auto lists
    = std::count_if(face.properties.begin(), face.properties.end(), is_list_of_vertices);
  if(lists == 0 && face.number > 0)
    throw std::invalid_argument("the header does not announce the list vertex_indices of a face");
  if(lists > 1)
    throw std::invalid_argument("the header announces " + std::to_string(lists)
                                + " lists of the vertices of a face");
}

void check(const Ply_header& header)
{
  bool has_vertices = false;
  for(const Ply_element& element : header.elements)
  {
    has_vertices = has_vertices || element.is_vertex();
    if(element.is_vertex())
      check_vertex(element);
    else if(element.is_face() || element.is_strips())
      check_face(element);
  }
  if(!has_vertices)
    throw std::invalid_argument("the header announces no vertices");
}

} // namespace

Ply_number_type ply_number_type_of_float() { return number_type<float>(); }
Ply_number_type ply_number_type_of_double() { return number_type<double>(); }

std::size_t coordinate_of(const Ply_property& property)
{
  const std::string& name = property.name;
  return name.size() == 1 ? (std::min)(std::string_view("xyz").find(name[0]), std::size_t(3)) : 3;
}

bool is_list_of_vertices(const Ply_property& property)
{
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

double Ply_header::number_at(const char* const bytes, const Ply_number_type type) const
{
  std::array<char, 8> ordered = {};
  std::copy_n(bytes, type.size, ordered.begin());
  if(is_big_endian)
    std::reverse(ordered.begin(), ordered.begin() + static_cast<std::ptrdiff_t>(type.size));
  return type.convert(ordered.data());
}

std::string Ply_header::bytes_of(const double number, const Ply_number_type type) const
{
  std::string result(type.size, '\0');
  type.store(number, result.data());
  if(is_big_endian)
    std::reverse(result.begin(), result.end());
  return result;
}

Ply_header read_ply_header(Text_cursor& text)
{
  Ply_header header;
  bool has_format = false;
  if(text.word() != "ply")
    throw std::invalid_argument("line 1: there is no keyword ply");
  for(std::string_view word = text.word(); word != "end_header"; word = text.word())
  {
    if(word.empty())
      throw std::invalid_argument("the file is truncated: it ends in the header");
    if(word == "format" && has_format)
      throw on_line(text, "there is a second format");
    if(word == "format")
      read_format(text, header);
    else if(word == "element")
      read_element(text, header);
    else if(word == "property")
      read_property(text, header);
    else if(word != "comment" && word != "obj_info" && word != "Created") // of Blender 2.4
      throw on_line(text, "the keyword " + Text_cursor::shown(word) + " is unknown");
    has_format = has_format || word == "format";
    text.skip_line();
  }
  if(!has_format)
    throw std::invalid_argument("the header announces no format");
  check(header);
  text.next_line();
  return header;
}

std::size_t texture_coordinate_of(const Ply_property& property)
{
  const std::array<std::array<const char*, 4>, 2> names
    = {{{"s", "u", "texture_u", "tex_u"}, {"t", "v", "texture_v", "tex_v"}}};
  for(std::size_t k = 0; !property.is_list && k < names.size(); ++k)
    if(std::find(names[k].begin(), names[k].end(), property.name) != names[k].end())
      return k;
  return names.size();
}

std::size_t normal_coordinate_of(const Ply_property& property)
{
  const std::string& name = property.name;
  return !property.is_list && name.size() == 2 && name[0] == 'n'
           ? (std::min)(std::string_view("xyz").find(name[1]), std::size_t(3))
           : 3;
}

std::size_t channel_of(const Ply_property& property)
{
  const std::array<const char*, 4> names = {"red", "green", "blue", "alpha"};
  const auto found
    = property.is_list ? names.end() : std::find(names.begin(), names.end(), property.name);
  return static_cast<std::size_t>(found - names.begin());
}

bool is_list_of_coordinates(const Ply_property& property)
{
  return property.is_list && property.name == "texcoord";
}

bool is_number_of_texture(const Ply_element& element, const Ply_property& property)
{
  return element.is_face() && !property.is_list && property.name == "texnumber";
}

std::vector<std::string> names_of_textures(const std::string& bytes, const std::string& path)
{
  std::vector<std::string> names;
  Text_cursor text(bytes);
  for(std::string_view word = text.word(); !word.empty() && word != "end_header";
      text.skip_line(), word = text.word())
    if(word == "comment" && text.word_on_line() == "TextureFile")
    {
      std::string& name = names.emplace_back(rest_of_line(text));
      if(const std::size_t place = name.find(THIS_FILE); place != std::string::npos)
        name.replace(place, std::strlen(THIS_FILE), stem_of(path));
    }
  return names;
}

} // namespace Canonical_pose_tool
