// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include "readers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

struct Number_type
{
  std::size_t size;
  double (*convert)(const char* bytes);
};

struct Property
{
  std::string name;
  bool is_list;
  Number_type count; // of a list
  Number_type value;
};

struct Ply_element
{
  std::string name;
  long long number;
  std::vector<Property> properties;
};

template <typename T>
Number_type number_type()
{
  return {sizeof(T), [](const char* bytes) {
            T value;
            std::memcpy(&value, bytes, sizeof(T));
            return static_cast<double>(value);
          }};
}

Number_type number_type(const std::string_view name, const std::size_t line)
{
  static const std::map<std::string_view, Number_type> types
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
    throw std::invalid_argument("line " + std::to_string(line)
                                + ": the type of the property is unknown");
  return found->second;
}

// Binary numbers are taken to be stored as this machine does, unless the file says big-endian.
class Ply_reader
{
public:
  Ply_reader(const std::string& bytes, Mesh_file& mesh) : m_text(bytes), m_mesh(mesh) {}

  void run()
  {
    read_header();
    m_byte = m_text.position();
    bool has_vertices = false;
    for(const Ply_element& element : m_elements)
    {
      has_vertices = has_vertices || element.name == "vertex";
      const char* const kind = element.name == "vertex" ? "vertex"
                               : element.name == "face" ? "face"
                                                        : "element";
      if(!element.properties.empty()) // else there is nothing to read
        for(Element e{kind, 0}; static_cast<long long>(e.index) < element.number; ++e.index)
          read_element(element, e);
    }
    if(!has_vertices)
      throw std::invalid_argument("the header announces no vertices");
    for(Element f{"face", 0}; f.index < m_faces.size(); ++f.index)
    {
      std::vector<std::size_t> face;
      for(const long long corner : m_faces[f.index])
        face.push_back(vertex_index(corner, m_mesh.points.size(), f));
      m_mesh.faces.push_back(std::move(face));
    }
  }

private:
  void read_header()
  {
    if(m_text.word() != "ply")
      throw std::invalid_argument("line 1: there is no keyword ply");
    for(std::string_view word = m_text.word(); word != "end_header"; word = m_text.word())
    {
      if(word.empty())
        throw std::invalid_argument("the file is truncated: it ends in the header");
      if(word == "format")
        read_format(m_text.word_on_line());
      else if(word == "element")
      {
        m_elements.push_back({std::string(m_text.word_on_line()), 0, {}});
        m_elements.back().number
          = m_text.integer(m_text.word_on_line(), Element{"the number of elements"});
      }
      else if(word == "property")
        read_property();
      m_text.skip_line();
    }
    m_text.next_line();
  }

  void read_format(const std::string_view name)
  {
    m_is_binary = name != "ascii";
    m_is_big_endian = name == "binary_big_endian";
    if(m_is_binary && !m_is_big_endian && name != "binary_little_endian")
      throw std::invalid_argument("line " + std::to_string(m_text.line())
                                  + ": the format is unknown");
  }

  void read_property()
  {
    if(m_elements.empty())
      throw std::invalid_argument("line " + std::to_string(m_text.line())
                                  + ": a property without an element");
    Property property;
    std::string_view word = m_text.word_on_line();
    property.is_list = word == "list";
    if(property.is_list)
    {
      property.count = number_type(m_text.word_on_line(), m_text.line());
      word = m_text.word_on_line();
    }
    property.value = number_type(word, m_text.line());
    property.name = m_text.word_on_line();
    m_elements.back().properties.push_back(property);
  }

  void read_element(const Ply_element& element, const Element& e)
  {
    std::array<double, 3> point;
    int coordinates = 0;
    bool has_corners = false;
    for(const Property& property : element.properties)
    {
      const bool is_coordinate
        = property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
      if(property.is_list)
      {
        const std::vector<double> values = read_list(property, e);
        if(element.name == "face"
           && (property.name == "vertex_indices" || property.name == "vertex_index"))
        {
          add_face(values, e);
          has_corners = true;
        }
      }
      else if(element.name == "vertex" && is_coordinate)
      {
        point[static_cast<std::size_t>(property.name[0] - 'x')] = read_number(property.value, e);
        ++coordinates;
      }
      else
        read_number(property.value, e);
    }
    if(element.name == "vertex")
    {
      if(coordinates != 3)
        throw std::invalid_argument("the header does not announce x, y and z of a vertex");
      check_is_finite(point, e);
      m_mesh.points.push_back(point);
    }
    if(element.name == "face" && !has_corners)
      throw std::invalid_argument("the header does not announce the list vertex_indices of a face");
  }

  void add_face(const std::vector<double>& corners, const Element& face)
  {
    check_is_polygon(static_cast<long long>(corners.size()), face);
    std::vector<long long> indices;
    for(const double corner : corners)
      indices.push_back(corner > -1e9 && corner < 1e18 ? static_cast<long long>(corner) : -1);
    m_faces.push_back(std::move(indices)); // the vertices may come later
  }

  std::vector<double> read_list(const Property& property, const Element& e)
  {
    std::vector<double> values;
    for(double i = read_number(property.count, e); i > 0; --i)
      values.push_back(read_number(property.value, e));
    return values;
  }

  double read_number(const Number_type type, const Element& e)
  {
    if(!m_is_binary)
      return m_text.number(m_text.word(), e);
    if(static_cast<std::size_t>(m_text.end() - m_byte) < type.size)
      throw std::invalid_argument("the file is truncated: it ends in " + e.name());
    std::array<char, 8> bytes = {};
    std::copy_n(m_byte, type.size, bytes.begin());
    if(m_is_big_endian)
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type.size));
    m_byte += type.size;
    return type.convert(bytes.data());
  }

  Text_cursor m_text;
  Mesh_file& m_mesh;
  const char* m_byte = nullptr; // where the binary data go on
  bool m_is_binary = false, m_is_big_endian = false;
  std::vector<Ply_element> m_elements;
  std::vector<std::vector<long long>> m_faces;
};

} // namespace

void read_ply(const std::string& bytes, Mesh_file& mesh) { Ply_reader(bytes, mesh).run(); }

} // namespace Canonical_pose_tool
