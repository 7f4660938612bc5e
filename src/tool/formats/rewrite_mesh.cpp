// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_header.h"
#include "Shortest_numbers.h"
#include "Shown_surface.h"
#include "Vertex_rotations.h"
#include "readers.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Copies a text, with other words at some places.
class Text_copy
{
public:
  Text_copy(std::ostream& out, const std::string& bytes)
    : m_out(out), m_position(bytes.data()), m_end(bytes.data() + bytes.size())
  {
    use_shortest_numbers(out);
  }

  template <class Number>
  void replace(const std::string_view word, const Number number)
  {
    copy_to(word.data());
    if constexpr(std::is_floating_point_v<Number>)
      write_shortest(m_out, number);
    else
      m_out << number;
    m_position = word.data() + word.size();
  }

  // After what was inserted.
  void append(const double number) { m_out << ' ' << number; }

  void insert(const char* const position, const std::string& text)
  {
    copy_to(position);
    m_out << text;
  }

  void finish() { copy_to(m_end); }

private:
  void copy_to(const char* const position)
  {
    m_out.write(m_position, position - m_position);
    m_position = position;
  }

  std::ostream& m_out;
  const char* m_position;
  const char* m_end;
};

// The first end of a line, for others.
std::string line_end_of(const std::string& bytes)
{
  const std::size_t end = bytes.find_first_of("\r\n");
  return end == std::string::npos             ? "\n"
         : bytes.compare(end, 2, "\r\n") == 0 ? "\r\n"
                                              : bytes.substr(end, 1);
}

// Advances to the vertices of an OFF file. Returns whether they have normals.
bool skip_header_of_off(Text_cursor& text)
{
  const std::string_view keyword = text.word();
  if(keyword.back() == 'F') // otherwise with the first number
    text.word();
  text.skip_line();
  return keyword.substr(0, keyword.find("OFF")).find('N') != std::string_view::npos;
}

std::vector<Eigen::Vector3d> normals_of_off(Text_cursor text, const std::size_t number)
{
  std::vector<Eigen::Vector3d> result(number);
  for(Eigen::Vector3d& normal : result)
  {
    text.word();
    text.word_on_line();
    text.word_on_line();
    for(double& x : normal)
      x = text.number_or(text.word_on_line(), 0);
    text.skip_line();
  }
  return result;
}

void rewrite_off(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
                 const Points& points)
{
  Text_cursor text(bytes);
  Text_copy copy(out, bytes);
  std::vector<Eigen::Vector3d> normals;
  if(skip_header_of_off(text))
  {
    normals = normals_of_off(text, points.size());
    const Vertex_rotations rotations(mesh, points, normals);
    for(std::size_t v = 0; v < normals.size(); ++v)
      normals[v] = rotations(v, normals[v]);
  }
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    copy.replace(text.word(), points[v][0]);
    copy.replace(text.word_on_line(), points[v][1]);
    copy.replace(text.word_on_line(), points[v][2]);
    if(!normals.empty())
      for(const double x : normals[v])
        if(const std::string_view word = text.word_on_line(); !word.empty())
          copy.replace(word, x);
    text.skip_line();
  }
  copy.finish();
}

// The normals of an OBJ file, turned at each position with the faces that use them there. One with several directions
// becomes several normals.
class Turned_normals_of_obj
{
public:
  Turned_normals_of_obj(const std::string& bytes, const Mesh_file& mesh, const Points& points)
  {
    read(bytes);
    if(m_normals.empty())
      return;
    m_turned.resize(m_normals.size());
    Corner_rotations rotations(mesh, mesh.points, points);
    for(const Use& use : m_uses)
      rotations.add(use.face, use.corner, m_normals[use.normal]);
    std::vector<std::map<Rounded_direction, std::size_t>> known(m_normals.size());
    for(Use& use : m_uses)
    {
      const Eigen::Vector3d normal = rotations(use.face, use.corner, m_normals[use.normal]);
      std::vector<Eigen::Vector3d>& turned = m_turned[use.normal];
      const auto [variant, is_new] = known[use.normal].try_emplace(rounded(normal), turned.size());
      if(is_new)
        turned.push_back(normal);
      use.variant = variant->second;
    }
    std::size_t number = 0;
    for(std::size_t i = 0; i < m_normals.size(); ++i)
    {
      if(m_turned[i].empty())
        m_turned[i].push_back(m_normals[i]);
      m_first.push_back(number);
      number += m_turned[i].size();
    }
    m_first.push_back(number);
  }

  // One or more for each normal.
  const std::vector<Eigen::Vector3d>& operator[](const std::size_t normal) const
  {
    return m_turned[normal];
  }

  bool are_more() const { return !m_first.empty() && m_first.back() > m_normals.size(); }

  // The index, from 0, of the normal of a use among those that are written.
  std::size_t index_of_use(const std::size_t use) const
  {
    return m_first[m_uses[use].normal] + m_uses[use].variant;
  }
  // The number of normals that are written for the first ones of the file.
  std::size_t number_written(const std::size_t number) const { return m_first[number]; }

  // Calls f(corner, word, is_relative, normal) for each index of a normal in a line of corners, in the
  // order of the uses. `number`: of the normals before it.
  template <class Function>
  void for_each_index(Text_cursor& text, const std::size_t number, const Function& f) const
  {
    std::size_t corner = 0;
    for(std::string_view word = text.word_on_line(); !word.empty();
        word = text.word_on_line(), ++corner)
    {
      const std::size_t last = word.rfind('/');
      if(last == std::string_view::npos || word.find('/') == last || last + 1 == word.size())
        continue;
      const std::string_view index = word.substr(last + 1);
      const double value = text.number_or(index, 0);
      const double i = value < 0 ? static_cast<double>(number) + value : value - 1;
      if(i >= 0 && i < static_cast<double>(m_normals.size()))
        f(corner, index, value < 0, static_cast<std::size_t>(i));
    }
  }

private:
  struct Use
  {
    std::size_t face, corner, normal;
    std::size_t variant = 0;
  };
  void read(const std::string& bytes)
  {
    Text_cursor text(bytes, Text_cursor::Lines::CONTINUED);
    for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
      if(word == "vn")
      {
        Eigen::Vector3d normal;
        for(double& x : normal)
          x = text.number_or(text.word_on_line(), 0);
        m_normals.push_back(normal);
      }
    Text_cursor faces(bytes, Text_cursor::Lines::CONTINUED);
    std::size_t face = 0, number = 0;
    for(std::string_view word = faces.word(); !word.empty(); faces.skip_line(), word = faces.word())
      if(word == "vn")
        ++number;
      else if(is_face_of_obj(word))
      {
        for_each_index(
          faces, number,
          [&](const std::size_t corner, std::string_view, bool, const std::size_t normal) {
            m_uses.push_back({face, corner, normal});
          });
        ++face;
      }
  }

  std::vector<Eigen::Vector3d> m_normals; // of the file
  std::vector<Use> m_uses;
  std::vector<std::vector<Eigen::Vector3d>> m_turned; // for each normal
  std::vector<std::size_t> m_first; // for each normal, the index of the first that is written
};

void rewrite_obj(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
                 const Points& points)
{
  const Turned_normals_of_obj normals(bytes, mesh, points);
  Text_cursor text(bytes, Text_cursor::Lines::CONTINUED);
  Text_copy copy(out, bytes);
  std::size_t vertex = 0, normal = 0, use = 0;
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
    if(word == "v")
    {
      for(const double x : points[vertex])
        copy.replace(text.word_on_line(), x);
      ++vertex;
    }
    else if(word == "vn")
    {
      const std::vector<Eigen::Vector3d>& turned = normals[normal];
      for(const double x : turned[0])
        if(const std::string_view number = text.word_on_line(); !number.empty())
          copy.replace(number, x);
      text.skip_line();
      for(std::size_t i = 1; i < turned.size(); ++i)
      {
        copy.insert(text.position(), line_end_of(bytes) + "vn");
        for(const double x : turned[i])
          copy.append(x);
      }
      ++normal;
    }
    else if(is_face_of_obj(word) && normals.are_more())
      normals.for_each_index(
        text, normal,
        [&](std::size_t, const std::string_view index, const bool is_relative, std::size_t) {
          const auto written = static_cast<long long>(normals.index_of_use(use++));
          copy.replace(index, is_relative
                                ? written - static_cast<long long>(normals.number_written(normal))
                                : written + 1);
        });
  copy.finish();
}

void rewrite_medit(std::ostream& out, const std::string& bytes, const Points& points)
{
  Text_cursor text(bytes);
  Text_copy copy(out, bytes);
  while(text.word() != "Vertices")
    ;
  text.word(); // their number
  for(const std::array<double, 3>& point : points)
  {
    for(const double x : point)
      copy.replace(text.word(), x);
    text.word(); // the reference
  }
  copy.finish();
}

Eigen::Vector3d normal_of(const std::array<Eigen::Vector3d, 3>& corners)
{
  const Eigen::Vector3d normal
    = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
  return normal.allFinite() ? normal : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

std::array<Eigen::Vector3d, 3> corners_of(const Points& points, const Face_list::Face face)
{
  return {vector_of(points[face[0]]), vector_of(points[face[1]]), vector_of(points[face[2]])};
}

// With its solids, and their names.
void rewrite_stl_text(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
                      const Points& points)
{
  Text_cursor text(bytes);
  Text_copy copy(out, bytes);
  std::size_t corner = 0;
  for(std::string_view word = text.word(); !word.empty(); word = text.word())
    switch(std::tolower(static_cast<unsigned char>(word[0])))
    {
    case 's': // solid, and its name
      text.skip_line();
      break;
    case 'e': // only the end of a solid has a name
      if(word.size() == 8 || word.size() == 3)
        text.skip_line();
      break;
    case 'n': {
      const bool has_face = corner / 3 < mesh.faces.size(); // otherwise, a facet without corners
      const Eigen::Vector3d normal
        = has_face ? normal_of(corners_of(points, mesh.faces[corner / 3])) : Eigen::Vector3d();
      for(const double x : normal)
        if(const std::string_view number = text.word(); has_face && !number.empty())
          copy.replace(number, x);
      break;
    }
    case 'v':
      for(const double x : points[mesh.faces[corner / 3][corner % 3]])
        copy.replace(text.word(), x);
      ++corner;
      break;
    }
  copy.finish();
}

void rewrite_stl(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
                 const Points& points)
{
  std::string result = bytes;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const std::array<Eigen::Vector3d, 3> corners = corners_of(points, mesh.faces[f]);
    const Eigen::Vector3d normal = normal_of(corners);
    std::array<float, 12> numbers;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const auto i = static_cast<Eigen::Index>(k);
      numbers[k] = static_cast<float>(normal[i]);
      for(std::size_t c = 0; c < 3; ++c)
        numbers[3 * (c + 1) + k] = static_cast<float>(corners[c][i]);
    }
    std::memcpy(result.data() + STL_HEADER_SIZE + STL_FACE_SIZE * f, numbers.data(),
                sizeof(numbers));
  }
  out << result;
}

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
    m_out.write(m_byte, m_text.end() - m_byte);
  }

  static bool has_normals(const Ply_element& element, const Ply_property& property)
  {
    return (element.is_vertex() || element.is_face()) && normal_coordinate_of(property) < 3;
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

  // With the properties that are added, after those of a vertex.
  void write_header()
  {
    Text_cursor text(m_bytes);
    Text_copy copy(m_out, m_bytes);
    std::size_t element = 0;
    for(std::string_view word = text.word(); word != "end_header"; word = text.word())
    {
      element += word == "element";
      text.next_line();
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
                            m_out << m_header.bytes_of(*value, property.value);
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

// Integers cannot hold any position.
bool holds_positions(const std::string& bytes)
{
  Text_cursor text(bytes);
  for(const Ply_element& element : read_ply_header(text).elements)
    for(const Ply_property& property : element.properties)
      if(((element.is_vertex() && coordinate_of(property) < 3)
          || Ply_rewriter::has_normals(element, property))
         && property.value.is_integer)
        return false;
  return true;
}

bool has_color_of_obj(Text_cursor text)
{
  std::size_t numbers = 0;
  while(!text.word_on_line().empty())
    ++numbers;
  return numbers >= 6;
}

std::vector<std::string> attributes_of_obj(const std::string& bytes)
{
  std::set<std::string_view> words;
  bool has_colors = false; // of the first vertex
  Text_cursor text(bytes);
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
    if(words.insert(word).second && word == "v")
      has_colors = has_color_of_obj(text);
  std::vector<std::string> result;
  if(has_colors)
    result.push_back("colors");
  const std::array<std::pair<const char*, const char*>, 5> texts = {{{"vn", "normals"},
                                                                     {"vt", "texture coordinates"},
                                                                     {"usemtl", "materials"},
                                                                     {"g", "groups"},
                                                                     {"o", "objects"}}};
  for(const auto& [word, name] : texts)
    if(words.count(word) > 0)
      result.push_back(name);
  return result;
}

std::string name_of_attribute(const Ply_element& element, const Ply_property& property)
{
  if(element.is_vertex() && channel_of(property) < 3)
    return "colors";
  if(element.is_vertex() ? texture_coordinate_of(property) < 2 : is_list_of_coordinates(property))
    return "texture coordinates";
  if(Ply_rewriter::has_normals(element, property) && element.is_vertex())
    return "normals";
  if(element.is_face() && channel_of(property) < 3)
    return "colors of faces";
  return "the property " + property.name;
}

std::vector<std::string> attributes_of_ply(const std::string& bytes)
{
  Text_cursor text(bytes);
  std::vector<std::string> result;
  for(const Ply_element& element : read_ply_header(text).elements)
    if(!element.is_vertex() && !element.is_face())
      result.push_back("the element " + element.name);
    else
      for(const Ply_property& property : element.properties)
        if(element.is_vertex() ? coordinate_of(property) == 3 : !is_list_of_vertices(property))
          result.push_back(name_of_attribute(element, property));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Whether the first face has a color. `text` is after the keyword.
bool has_face_colors(Text_cursor text)
{
  const auto vertices = static_cast<std::size_t>(text.number_or(text.word(), 0));
  text.skip_line();
  for(std::size_t v = 0; v < vertices && !text.word().empty(); ++v)
    text.skip_line();
  for(double corners = text.number_or(text.word(), 0); corners > 0; --corners)
    text.word();
  return !text.word_on_line().empty();
}

std::vector<std::string> attributes_of_off(const std::string& bytes)
{
  Text_cursor text(bytes);
  const std::string_view keyword = text.word();
  std::vector<std::string> result;
  for(const char c : keyword.substr(0, keyword.find("OFF")))
    result.push_back(c == 'N' ? "normals" : c == 'C' ? "colors" : "texture coordinates");
  if(has_face_colors(text))
    result.push_back("colors of faces");
  return result;
}

} // namespace

std::vector<std::string> attributes_of_file(const Mesh_file& mesh)
{
  if(!mesh.source)
    return {};
  switch(mesh.source->format)
  {
  case Format::OFF:
    return attributes_of_off(mesh.source->bytes);
  case Format::OBJ:
    return attributes_of_obj(mesh.source->bytes);
  case Format::PLY:
    return attributes_of_ply(mesh.source->bytes);
  case Format::MEDIT: // the rest of the file is kept
    return mesh.source->bytes.find("Normals") == std::string::npos
             ? std::vector<std::string>()
             : std::vector<std::string>{"turned normals"};
  case Format::GLB:
  case Format::GLTF:
    return attributes_of_gltf(mesh);
  default:
    return {};
  }
}

std::vector<std::string> files_beside(const Mesh_file& mesh)
{
  std::vector<std::string> result;
  const bool is_obj = mesh.source && mesh.source->format == Format::OBJ;
  if(!is_obj && !(mesh.source && mesh.source->format == Format::PLY))
    return result;
  Text_cursor text(mesh.source->bytes);
  for(std::string_view word = text.word(); !word.empty() && word != "end_header";
      text.skip_line(), word = text.word())
    if(is_obj ? word == "mtllib" : word == "comment" && text.word_on_line() == "TextureFile")
      result.push_back(rest_of_line(text));
  return result;
}

bool is_rewritable(const Mesh_file& mesh, const Format format)
{
  if(!mesh.source || mesh.source->format != format)
    return false;
  switch(format)
  {
  case Format::OFF:
  case Format::OBJ:
  case Format::STL:
  case Format::MEDIT:
    return true;
  case Format::PLY:
    return holds_positions(mesh.source->bytes);
  case Format::GLB:
    return is_rewritable_glb(mesh);
  default:
    return false;
  }
}

std::vector<std::string> losses(const Mesh_file& mesh, const Format format, const bool is_rewritten)
{
  std::vector<std::string> names = attributes_of_file(mesh);
  const std::set<std::string> always
    = {"animations", "images that are not beside it", "morph targets", "skins", "turned normals"};
  const auto is_kept = [&](const std::string& name) {
    if(is_rewritten)
      return always.count(name) == 0;
    const Appearance& appearance = mesh.appearance;
    const bool has_textures
      = format == Format::GLB || format == Format::PLY || format == Format::OBJ;
    const bool has_colors = has_textures || format == Format::OFF;
    if(name == "normals")
      return format == Format::GLB || format == Format::OBJ
               ? !appearance.normals.empty()
               : has_colors && !normals_of_vertices(mesh).empty();
    if(name == "colors")
      return has_colors && !appearance.vertex_colors.empty();
    if(name == "texture coordinates")
      return has_textures && !appearance.texture_coordinates.empty();
    return name == "materials" && format == Format::GLB && appearance.has_materials();
  };
  names.erase(std::remove_if(names.begin(), names.end(), is_kept), names.end());
  if(!is_rewritten && format == Format::GLB)
    names.insert(names.end(), mesh.appearance.missing.begin(), mesh.appearance.missing.end());
  std::vector<std::string> result; // each name once
  for(std::string& name : names)
    if(std::find(result.begin(), result.end(), name) == result.end())
      result.push_back(std::move(name));
  return result;
}

void rewrite_mesh(std::ostream& out, const Mesh_file& mesh, const Points& points,
                  const std::vector<Vertex_values>& values)
{
  const std::string& bytes = mesh.source->bytes;
  if(mesh.source->has_byte_order_mark && mesh.source->format != Format::GLB)
    out << BYTE_ORDER_MARK;
  switch(mesh.source->format)
  {
  case Format::OFF:
    return rewrite_off(out, bytes, mesh, points);
  case Format::OBJ:
    return rewrite_obj(out, bytes, mesh, points);
  case Format::MEDIT:
    return rewrite_medit(out, bytes, points);
  case Format::PLY:
    return Ply_rewriter(out, mesh, points, values).run();
  case Format::GLB:
    return rewrite_glb(out, mesh, points);
  default:
    return is_binary_stl_content(bytes) ? rewrite_stl(out, bytes, mesh, points)
                                        : rewrite_stl_text(out, bytes, mesh, points);
  }
}

} // namespace Canonical_pose_tool
