// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_header.h"
#include "Shortest_numbers.h"
#include "Shown_surface.h"
#include "Vertex_rotations.h"
#include "readers.h"
#include "rewriters.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Rows of vertices are written with other numbers, and with more of them.
class Ply_rewriter
{
public:
  Ply_rewriter(std::ostream& out, const Mesh_file& mesh, const Points& points,
               const std::vector<Vertex_values>& values)
    : m_out(out), m_bytes(mesh.source->bytes), m_text(m_bytes), m_mesh(mesh), m_points(points),
      m_values(values), m_header(read_ply_header(m_text)), m_byte(m_text.position())
  {
    use_shortest_numbers(out);
    for(const Ply_element& element : m_header.elements)
      for(const Ply_property& property : element.properties)
        m_has_normals = m_has_normals || has_normals(element, property);
    if(m_has_normals)
      find_normals();
  }

  void run()
  {
    write_header();
    for(const Ply_element& element : m_header.elements)
      for(std::size_t i = 0; i < element.number; ++i)
        copy_element(element, i);
    m_out.write(m_byte, m_bytes.data() + m_bytes.size() - m_byte);
  }

  static bool has_normals(const Ply_element& element, const Ply_property& property)
  {
    return normal_coordinate_of(property) < 3
           && (element.is_vertex() ? element.has_all(normal_coordinate_of, 3) : element.is_face());
  }

  static bool has_positions(const Ply_element& element, const Ply_property& property)
  {
    return element.is_vertex() && coordinate_of(property) < 3;
  }

private:
  // Where the value of a property comes from, if it is new.
  const Vertex_values* values_of(const Ply_property& property) const
  {
    for(const Vertex_values& values : m_values)
      if(values.name == property.name && !property.is_list)
        return &values;
    return nullptr;
  }

  bool is_added(const Ply_element& vertex, const Vertex_values& values) const
  {
    return std::none_of(vertex.properties.begin(), vertex.properties.end(),
                        [&](const Ply_property& p) { return values_of(p) == &values; });
  }

  // Whether integers become other numbers, which a pose needs.
  bool is_widened(const Ply_element& element, const Ply_property& property) const
  {
    return property.value.is_integer
           && (has_normals(element, property) || has_positions(element, property)
               || (element.is_vertex() && values_of(property)));
  }

  // Some programs do not read doubles of the other byte order.
  Ply_number_type written_type(const Ply_element& element, const Ply_property& property) const
  {
    if(!is_widened(element, property))
      return property.value;
    return has_normals(element, property) || property.value.size < sizeof(float)
             ? ply_number_type_of_float()
             : ply_number_type_of_double();
  }

  void replace_type(Text_copy& copy, const std::string_view type, const Ply_element& element,
                    const Ply_property& property) const
  {
    if(is_widened(element, property))
      copy.replace(type,
                   written_type(element, property).size == sizeof(float) ? "float" : "double");
  }

  // With the properties that are added, after those of a vertex. A texture that is named after the file keeps its name.
  void write_header()
  {
    Text_cursor text(m_bytes);
    Text_copy copy(m_out, m_bytes);
    std::size_t element = 0, property = 0;
    for(std::string_view word = text.word(); word != "end_header"; word = text.word())
    {
      element += word == "element";
      property = word == "element" ? 0 : property;
      Text_cursor type = text;
      const char* const line = text.position();
      text.next_line();
      if(word == "property")
        replace_type(copy, type.word_on_line(), m_header.elements[element - 1],
                     m_header.elements[element - 1].properties[property++]);
      if(word == "comment" && !is_standard_stream(m_mesh.source->path))
      {
        const std::string_view comment(line, static_cast<std::size_t>(text.position() - line));
        const std::size_t place = comment.find(THIS_FILE), texture = comment.find("TextureFile");
        if(place != std::string_view::npos && texture < place)
          copy.replace(comment.substr(place, std::strlen(THIS_FILE)), stem_of(m_mesh.source->path));
      }
      if(element == 0 || !m_header.elements[element - 1].is_vertex())
        continue;
      Text_cursor next = text;
      const std::string_view next_word = next.word();
      if(next_word != "element" && next_word != "end_header")
        continue;
      for(const Vertex_values& values : m_values)
        if(is_added(m_header.elements[element - 1], values))
          copy.insert(text.position(), "property double " + values.name + line_end_of(m_bytes));
    }
    copy.insert(m_byte, "");
  }

  // Advances over a number.
  double next_number(const Ply_number_type type)
  {
    if(!m_header.is_binary)
    {
      m_word = m_text.word();
      return m_text.number_or(m_word, 0);
    }
    const double number = m_header.number_at(m_byte, type);
    m_byte += type.size;
    return number;
  }

  // Calls f(property, value, begin) after each: its value, or the length of its list, and where its bytes begin.
  template <class Function>
  void for_each_property(const Ply_element& element, const Function& f)
  {
    for(const Ply_property& property : element.properties)
    {
      const char* const begin = m_header.is_binary ? m_byte : nullptr;
      const double value = next_number(property.is_list ? property.count : property.value);
      if(property.is_list)
        for(auto n = static_cast<std::size_t>(value); n > 0; --n)
          next_number(property.value);
      f(property, value, begin);
    }
  }

  std::optional<double> new_value(const Ply_element& element, const Ply_property& property,
                                  const std::size_t v) const
  {
    if(has_normals(element, property))
      return (element.is_vertex()
                ? m_normals
                : m_face_normals)[v][static_cast<Eigen::Index>(normal_coordinate_of(property))];
    if(property.is_list || !element.is_vertex())
      return std::nullopt;
    if(const std::size_t k = coordinate_of(property); k < 3)
      return m_points[v][k];
    if(const Vertex_values* const values = values_of(property))
      return values->values[static_cast<Eigen::Index>(v)];
    return std::nullopt;
  }

  void copy_element(const Ply_element& element, const std::size_t i)
  {
    const bool is_vertex = element.is_vertex();
    if(m_header.is_binary)
    {
      for_each_property(element,
                        [&](const Ply_property& property, double, const char* const begin) {
                          if(const auto value = new_value(element, property, i))
                            m_out << m_header.bytes_of(*value, written_type(element, property));
                          else
                            m_out.write(begin, m_byte - begin);
                        });
      if(is_vertex)
        for(const Vertex_values& values : m_values)
          if(is_added(element, values))
            m_out << m_header.bytes_of(values.values[static_cast<Eigen::Index>(i)],
                                       ply_number_type_of_double());
      return;
    }
    if(!(is_vertex || (element.is_face() && m_has_normals)) || element.properties.empty())
    {
      for_each_property(element, [](const Ply_property&, double, const char*) {});
      m_out.write(m_byte, m_text.position() - m_byte);
      m_byte = m_text.position();
      return;
    }
    for_each_property(element, [&](const Ply_property& property, double, const char*) {
      if(const auto value = new_value(element, property, i))
      {
        m_out.write(m_byte, m_word.data() - m_byte);
        m_out << *value;
        m_byte = m_word.data() + m_word.size();
      }
    });
    m_out.write(m_byte, m_text.position() - m_byte);
    m_byte = m_text.position();
    for(const Vertex_values& values : m_values)
      if(is_vertex && is_added(element, values))
        m_out << ' ' << values.values[static_cast<Eigen::Index>(i)];
  }

  // Reads the normals, and turns them.
  void find_normals()
  {
    const Text_cursor text = m_text;
    const char* const byte = m_byte;
    m_normals.assign(m_points.size(), Eigen::Vector3d::Zero());
    m_face_normals.assign(m_mesh.faces.size(), Eigen::Vector3d::Zero());
    for(const Ply_element& element : m_header.elements)
      for(std::size_t i = 0; i < element.number; ++i)
        for_each_property(
          element, [&](const Ply_property& property, const double value, const char*) {
            if(has_normals(element, property))
              (element.is_vertex()
                 ? m_normals
                 : m_face_normals)[i][static_cast<Eigen::Index>(normal_coordinate_of(property))]
                = value;
          });
    m_text = text;
    m_byte = byte;
    const Vertex_rotations rotations(m_mesh, m_points, m_normals);
    for(std::size_t v = 0; v < m_normals.size(); ++v)
      m_normals[v] = rotations(v, m_normals[v]);
    for(std::size_t f = 0; f < m_face_normals.size(); ++f)
      m_face_normals[f] = turned_normal(rotation_of_face(m_mesh.faces[f], m_mesh.points, m_points)
                                          * m_face_normals[f],
                                        m_face_normals[f]);
  }

  std::ostream& m_out;
  const std::string& m_bytes;
  Text_cursor m_text;
  const Mesh_file& m_mesh;
  const Points& m_points;
  const std::vector<Vertex_values>& m_values;
  const Ply_header m_header;
  const char* m_byte; // the next one that is not yet copied
  std::string_view m_word;
  bool m_has_normals = false;
  std::vector<Eigen::Vector3d> m_normals, m_face_normals; // turned
};

std::string name_of_attribute(const Ply_element& element, const Ply_property& property)
{
  if(element.is_vertex() && channel_of(property) < 4)
    return "colors";
  if(element.is_vertex() ? texture_coordinate_of(property) < 2 : is_list_of_coordinates(property))
    return "texture coordinates";
  if(Ply_rewriter::has_normals(element, property) && element.is_vertex())
    return "normals";
  if(element.is_face() && channel_of(property) < 4)
    return "colors of faces";
  if(is_number_of_texture(element, property))
    return "materials";
  return "the property " + property.name;
}

// Other than those that name textures.
bool has_comments_of_ply(const std::string& bytes)
{
  Text_cursor text(bytes);
  for(std::string_view word = text.word(); word != "end_header";
      text.skip_line(), word = text.word())
    if(word == "obj_info" || (word == "comment" && text.word_on_line() != "TextureFile"))
      return true;
  return false;
}

} // namespace

void rewrite_ply(std::ostream& out, const Mesh_file& mesh, const Points& points,
                 const std::vector<Vertex_values>& values)
{
  Ply_rewriter(out, mesh, points, values).run();
}

std::vector<std::string> integers_of_ply(const std::string& bytes)
{
  Text_cursor text(bytes);
  std::vector<std::string> result;
  for(const Ply_element& element : read_ply_header(text).elements)
    for(const Ply_property& property : element.properties)
      if(property.value.is_integer)
      {
        if(Ply_rewriter::has_positions(element, property))
          result.push_back("integer positions");
        if(Ply_rewriter::has_normals(element, property))
          result.push_back("integer normals");
      }
  return result;
}

std::vector<std::string> attributes_of_ply(const std::string& bytes)
{
  Text_cursor text(bytes);
  const Ply_header header = read_ply_header(text);
  std::vector<std::string> result;
  for(const Ply_element& element : header.elements)
    if(!element.is_vertex() && !element.is_face() && !element.is_strips())
      result.push_back("the element " + element.name);
    else
      for(const Ply_property& property : element.properties)
        if(element.is_vertex() ? coordinate_of(property) == 3 : !is_list_of_vertices(property))
          result.push_back(name_of_attribute(element, property));
  if(header.vertices_have_all(texture_coordinate_of, 2) && header.has_coordinates_of_corners())
    result.push_back("texture coordinates of vertices");
  if(!names_of_textures(bytes, std::string()).empty())
    result.push_back("materials");
  if(has_comments_of_ply(bytes))
    result.push_back(COMMENTS);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace Canonical_pose_tool
