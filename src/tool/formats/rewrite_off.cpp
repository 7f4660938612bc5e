// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Vertex_rotations.h"
#include "readers.h"
#include "rewriters.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

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

std::size_t number_of_words(Text_cursor& text)
{
  std::size_t result = 0;
  while(!text.word_on_line().empty())
    ++result;
  return result;
}

} // namespace

void rewrite_off(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
                 const Points& points)
{
  Text_cursor text(bytes);
  Text_copy copy(out, bytes);
  std::vector<Eigen::Vector3d> normals;
  const Off_header header(text);
  if(header.letters.find('N') != std::string_view::npos)
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
    header.end_row(text);
  }
  copy.finish();
}

std::vector<std::string> attributes_of_off(const std::string& bytes)
{
  Text_cursor text(bytes);
  const Off_header header(text);
  std::vector<std::string> result;
  std::size_t most = 2; // numbers after the first one of a vertex
  for(const char c : header.letters)
  {
    result.push_back(c == 'N' ? "normals" : c == 'C' ? "colors" : "texture coordinates");
    most += c == 'N' ? 3 : c == 'C' ? 4 : 1;
  }
  bool has_more = false, has_colors = false;
  for(std::size_t v = 0; v < header.vertices && !header.is_on_one_line; ++v)
  {
    text.word();
    has_more = number_of_words(text) > most || has_more;
  }
  for(std::size_t f = 0; f < header.faces && !header.is_on_one_line; ++f)
  {
    for(double corners = text.number_or(text.word(), 0); corners > 0; --corners)
      text.word();
    has_colors = number_of_words(text) > 0 || has_colors;
  }
  if(has_more)
    result.push_back("further numbers of vertices");
  if(has_colors)
    result.push_back("colors of faces");
  if(has_comments(bytes))
    result.push_back(COMMENTS);
  return result;
}

} // namespace Canonical_pose_tool
