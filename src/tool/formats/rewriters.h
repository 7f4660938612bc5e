// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_REWRITERS_H
#define CGAL_CANONICAL_POSE_3_TOOL_REWRITERS_H

#include "Mesh_file.h"
#include "Shortest_numbers.h"
#include "Shown_surface.h"

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace Canonical_pose_tool {

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
inline std::string line_end_of(const std::string& bytes)
{
  const std::size_t end = bytes.find_first_of("\r\n");
  return end == std::string::npos             ? "\n"
         : bytes.compare(end, 2, "\r\n") == 0 ? "\r\n"
                                              : bytes.substr(end, 1);
}

// The parts of rewrite_mesh() for each format; of glTF, see readers.h.
void rewrite_off(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
                 const std::vector<std::array<double, 3>>& points);
void rewrite_obj(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
                 const std::vector<std::array<double, 3>>& points);
void rewrite_stl(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
                 const std::vector<std::array<double, 3>>& points);
void rewrite_ply(std::ostream& out, const Mesh_file& mesh,
                 const std::vector<std::array<double, 3>>& points,
                 const std::vector<Vertex_values>& values);

// What files have beside positions and faces.
std::vector<std::string> attributes_of_off(const std::string& bytes);
std::vector<std::string> attributes_of_obj(const std::string& bytes);
std::vector<std::string> attributes_of_ply(const std::string& bytes);

std::vector<std::string> attributes_of_stl(const Mesh_file& mesh);

// Whether a text has comments after a '#'.
bool has_comments(const std::string& bytes);

// What the same file with other positions has not.
std::vector<std::string> integers_of_ply(const std::string& bytes);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_REWRITERS_H
