// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "readers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Lexicographic; what is not a number comes last.
struct Order_of_points
{
  bool operator()(const std::array<double, 3>& p, const std::array<double, 3>& q) const
  {
    return std::lexicographical_compare(
      p.begin(), p.end(), q.begin(), q.end(),
      [](const double x, const double y) { return x < y || (std::isnan(y) && !std::isnan(x)); });
  }
};

// Collects faces by the coordinates of their corners; equal corners become one vertex. Vertices are
// in the order of appearance.
class Welder
{
public:
  explicit Welder(Mesh_file& mesh) : m_mesh(mesh) {}

  Element next_face() const { return Element{"face", m_mesh.faces.size()}; }

  void add_corner(const std::array<double, 3>& point)
  {
    check_is_finite(m_mesh, point, next_face());
    const auto [vertex, is_new] = m_vertices.emplace(point, m_mesh.points.size());
    if(is_new)
      m_mesh.points.push_back(point);
    m_face.push_back(vertex->second);
  }

  void check_is_between_faces() const
  {
    if(!m_face.empty())
      throw std::invalid_argument(next_face().name() + " is not closed by the keyword endfacet");
  }

  void add_face()
  {
    if(m_face.size() != 3)
      throw std::invalid_argument(next_face().name() + " is not a triangle: it has "
                                  + std::to_string(m_face.size()) + " corners");
    m_mesh.faces.push_back(m_face);
    m_face.clear();
  }

private:
  Mesh_file& m_mesh;
  std::map<std::array<double, 3>, std::size_t, Order_of_points> m_vertices;
  std::vector<std::size_t> m_face;
};

std::uint32_t number_of_binary_faces(const std::string& bytes)
{
  std::uint32_t result = 0;
  if(bytes.size() >= STL_HEADER_SIZE)
    std::memcpy(&result, bytes.data() + 80, sizeof(result));
  return result;
}

// Whether this is a face rather than zeros, text or the like: a normal, or none, and corners that differ.
bool begins_with_face(const std::string_view bytes)
{
  if(bytes.size() < STL_FACE_SIZE)
    return false;
  std::array<std::array<float, 3>, 4> rows; // the normal comes first
  std::memcpy(rows.data(), bytes.data(), sizeof(rows));
  for(const std::array<float, 3>& row : rows)
    if(!std::all_of(row.begin(), row.end(), [](const float x) { return std::isfinite(x); }))
      return false;
  const double length = std::hypot(rows[0][0], rows[0][1], rows[0][2]);
  const double tolerance = 0.01;
  return (length == 0 || std::abs(length - 1) < tolerance) && rows[1] != rows[2]
         && rows[2] != rows[3] && rows[3] != rows[1];
}

void read_binary(const std::string& bytes, Mesh_file& mesh)
{
  const std::uint32_t faces = number_of_binary_faces(bytes);
  if(bytes.size() < STL_HEADER_SIZE + STL_FACE_SIZE * faces || bytes.size() < STL_HEADER_SIZE)
    throw std::invalid_argument(
      "the file is truncated: " + std::to_string(bytes.size()) + " bytes, but "
      + (bytes.size() < STL_HEADER_SIZE ? "a header" : std::to_string(faces) + " faces")
      + " of binary STL need " + std::to_string(STL_HEADER_SIZE + STL_FACE_SIZE * faces));
  const std::string_view rest
    = std::string_view(bytes).substr(STL_HEADER_SIZE + STL_FACE_SIZE * faces);
  if(faces == 0 ? rest.size() >= STL_FACE_SIZE : begins_with_face(rest)) // otherwise, it is ignored
    throw std::invalid_argument("the file goes on for " + std::to_string(rest.size())
                                + " bytes after the " + std::to_string(faces) + " faces announced"
                                + (faces == 0 ? "" : ", with more faces"));
  Welder welder(mesh);
  const char* position = bytes.data() + STL_HEADER_SIZE;
  for(std::uint32_t f = 0; f < faces; ++f, position += STL_FACE_SIZE)
  {
    float numbers[12]; // the normal comes first
    std::memcpy(numbers, position, sizeof(numbers));
    for(int k = 3; k < 12; k += 3)
      welder.add_corner({numbers[k], numbers[k + 1], numbers[k + 2]});
    welder.add_face();
  }
}

std::array<double, 3> read_point(Text_cursor& text, const Element& face)
{
  std::array<double, 3> point;
  for(double& x : point)
    x = text.number(text.word(), face);
  return point;
}

std::string in_lower_case(const std::string_view word)
{
  std::string result(word);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

// In any case, and "end loop" for "endloop".
std::string keyword(Text_cursor& text)
{
  std::string word = in_lower_case(text.word());
  return word == "end" ? word + in_lower_case(text.word_on_line()) : word;
}

void read_ascii(const std::string& bytes, Mesh_file& mesh)
{
  Welder welder(mesh);
  Text_cursor text(bytes);
  bool is_in_solid = true;
  for(std::string word = keyword(text); !word.empty(); word = keyword(text))
    if(word == "solid" || word == "endsolid")
    {
      welder.check_is_between_faces();
      is_in_solid = word == "solid";
      text.skip_line();
    }
    else if(word == "vertex")
      welder.add_corner(read_point(text, welder.next_face()));
    else if(word == "normal")
      for(int k = 0; k < 3; ++k)
        text.word();
    else if(word == "endfacet")
      welder.add_face();
    else if(word != "facet" && word != "outer" && word != "loop" && word != "endloop")
      throw std::invalid_argument(welder.next_face().name() + ": the keyword "
                                  + Text_cursor::shown(word) + " is unknown (line "
                                  + std::to_string(text.line()) + ")");
  if(is_in_solid)
    throw std::invalid_argument("the file is truncated: it ends in " + welder.next_face().name());
}

// The header of a binary file may begin with "solid", too.
bool is_ascii(const std::string& bytes)
{
  Text_cursor text(bytes);
  if(in_lower_case(text.word()) != "solid")
    return false;
  text.skip_line();
  const std::string next = in_lower_case(text.word());
  return next == "facet" || next == "endsolid" || next == "end" || next == "solid"
         || bytes.find('\0') == std::string::npos;
}

} // namespace

bool is_binary_stl(const std::string& beginning, const std::uintmax_t size)
{
  const std::uintmax_t announced
    = STL_HEADER_SIZE + STL_FACE_SIZE * std::uintmax_t(number_of_binary_faces(beginning));
  return beginning.size() >= STL_HEADER_SIZE && size >= announced
         && size - announced < STL_FACE_SIZE;
}

bool is_binary_stl(const std::string& bytes)
{
  const std::size_t faces = number_of_binary_faces(bytes); // in text, a very large number
  return is_binary_stl(bytes, bytes.size())
         || (faces > 0 && bytes.size() >= STL_HEADER_SIZE + STL_FACE_SIZE * faces);
}

bool has_rest_of_stl(const std::string& bytes)
{
  return is_binary_stl(bytes)
         && bytes.size() - STL_HEADER_SIZE - STL_FACE_SIZE * number_of_binary_faces(bytes)
              >= STL_FACE_SIZE;
}

bool is_binary_stl_content(const std::string& bytes)
{
  return is_binary_stl(bytes) || !is_ascii(bytes);
}

void read_stl(const std::string& bytes, Mesh_file& mesh)
{
  if(is_binary_stl_content(bytes))
    read_binary(bytes, mesh);
  else
    read_ascii(bytes, mesh);
}

} // namespace Canonical_pose_tool
