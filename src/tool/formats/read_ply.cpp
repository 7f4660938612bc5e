// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_header.h"
#include "readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

const double NUMBERS = 9007199254740992.; // all smaller integers are representable

bool is_integer(const double x) { return std::abs(x) < NUMBERS && x == std::floor(x); }

std::string text_of(const double x)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", x);
  return text;
}

// Binary numbers are assumed to have the byte order of this machine, unless the file is big-endian.
class Ply_reader
{
public:
  Ply_reader(const std::string& bytes, Mesh_file& mesh)
    : m_text(bytes), m_mesh(mesh), m_header(read_ply_header(m_text)), m_byte(m_text.position()),
      m_end(bytes.data() + bytes.size())
  {}

  void run()
  {
    Element last{"the header"};
    for(const Ply_element& element : m_header.elements)
      if(!element.properties.empty()) // otherwise there is nothing to read
        for(std::size_t i = 0; i < element.number; ++i)
        {
          last = element[i];
          read_element(element, last);
        }
    check_is_at_end(last);
    add_faces(m_corners, m_ends, 0, m_mesh);
  }

private:
  void read_element(const Ply_element& element, const Element& e)
  {
    std::array<double, 4> point = {}; // the last one is for other properties
    for(const Ply_property& property : element.properties)
      if(property.is_list)
      {
        const std::vector<double> values = read_list(property, e);
        if(element.is_face() && is_list_of_vertices(property))
          add_face(values, e);
        if(element.is_strips() && is_list_of_vertices(property))
          add_strips(values, e);
      }
      else
        point[coordinate_of(property)] = read_number(property.value, e);
    if(!element.is_vertex())
      return;
    m_mesh.points.push_back({point[0], point[1], point[2]});
    check_is_finite(m_mesh, m_mesh.points.back(), e);
  }

  void add_face(const std::vector<double>& corners, const Element& face)
  {
    check_is_polygon(static_cast<long long>(corners.size()), face);
    for(const double corner : corners)
    {
      if(!is_integer(corner))
        throw std::invalid_argument(face.name() + " names vertex " + text_of(corner)
                                    + ", which cannot be the index of a vertex");
      m_corners.push_back(static_cast<long long>(corner));
    }
    m_ends.push_back(m_corners.size());
  }

  // -1 ends a strip. Triangles with a vertex twice lead from one strip to another.
  void add_strips(const std::vector<double>& vertices, const Element& e)
  {
    std::size_t first = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(vertices[i] == -1)
        first = i + 1;
      else if(i >= first + 2)
      {
        const double a = vertices[i - 2], b = vertices[i - 1], c = vertices[i];
        const bool is_odd = (i - first) % 2 == 1;
        if(a != b && b != c && c != a)
          add_face({is_odd ? b : a, is_odd ? a : b, c}, e);
      }
  }

  std::vector<double> read_list(const Ply_property& property, const Element& e)
  {
    const double n = read_number(property.count, e);
    if(!is_integer(n) || n < 0)
      throw std::invalid_argument(e.name() + ": the number of its "
                                  + Text_cursor::shown(property.name) + " is " + text_of(n));
    std::vector<double> values;
    for(std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
      values.push_back(read_number(property.value, e));
    return values;
  }

  double read_number(const Ply_number_type type, const Element& e)
  {
    if(!m_header.is_binary)
      return m_text.number(m_text.word(), e);
    if(static_cast<std::size_t>(m_end - m_byte) < type.size)
      throw std::invalid_argument("the file is truncated: it ends in " + e.name());
    const double number = m_header.number_at(m_byte, type);
    m_byte += type.size;
    return number;
  }

  // Line ends may follow binary data.
  void check_is_at_end(const Element& last)
  {
    if(!m_header.is_binary)
      return m_text.check_is_at_end(last);
    const std::string_view rest(m_byte, static_cast<std::size_t>(m_end - m_byte));
    if(rest.find_first_not_of(" \t\r\n") != std::string_view::npos)
      throw std::invalid_argument("the file goes on for " + std::to_string(rest.size())
                                  + " bytes after " + last.name() + ", the last one announced");
  }

  Text_cursor m_text;
  Mesh_file& m_mesh;
  const Ply_header m_header;
  const char* m_byte; // next byte of the binary data
  const char* const m_end;
  std::vector<long long> m_corners; // of all faces; the vertices may follow later
  std::vector<std::size_t> m_ends;  // of the faces, among the corners
};

} // namespace

void read_ply(const std::string& bytes, Mesh_file& mesh) { Ply_reader(bytes, mesh).run(); }

} // namespace Canonical_pose_tool
