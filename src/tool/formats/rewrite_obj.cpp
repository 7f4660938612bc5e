// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Vertex_rotations.h"
#include "readers.h"
#include "rewriters.h"

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

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

// What follows the coordinates of vertices, or of textures.
struct Further_numbers
{
  bool are_colors = false, are_others = false;

  // Of a row with so many coordinates; zeros, and the weight of a vertex if it is 1, tell nothing.
  void add(Text_cursor& text, const std::size_t coordinates, const std::size_t colors,
           const double plain)
  {
    std::size_t number = 0;
    bool is_told = false;
    for(std::string_view word = text.word_on_line(); !word.empty(); word = text.word_on_line())
      is_told = (number++ >= coordinates && text.number_or(word, plain) != plain) || is_told;
    const bool has_colors = colors > 0 && number >= coordinates + colors;
    are_colors = are_colors || has_colors;
    are_others = are_others || (has_colors ? number > coordinates + colors : is_told);
  }
};

} // namespace

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

std::vector<std::string> attributes_of_obj(const std::string& bytes)
{
  static const std::vector<std::pair<std::string, std::set<std::string_view>>> names
    = {{"", {"f", "fo", "mtllib"}},
       {"normals", {"vn"}},
       {"texture coordinates", {"vt"}},
       {"materials", {"usemtl"}},
       {"groups", {"g"}},
       {"objects", {"o"}},
       {"lines", {"l"}},
       {"points", {"p"}},
       {"curves and surfaces",
        {"vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole",
         "scrv", "sp", "end", "con", "ctech", "stech"}}};
  std::set<std::string_view> words;
  Further_numbers of_vertices, of_textures;
  bool has_smoothing = false;
  Text_cursor text(bytes, Text_cursor::Lines::CONTINUED);
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
    if(word == "v")
      of_vertices.add(text, 3, 3, 1);
    else if(word == "s")
    {
      const std::string_view group = text.word_on_line();
      has_smoothing = has_smoothing || (group != "off" && group != "0");
    }
    else
    {
      words.insert(word);
      if(word == "vt")
        of_textures.add(text, 2, 0, 0);
      while(!text.word_on_line().empty()) // also on lines on which it goes on
        ;
    }
  std::vector<std::string> result;
  if(of_vertices.are_colors)
    result.push_back("colors");
  for(const auto& [name, of_name] : names)
  {
    const std::size_t before = words.size();
    for(const std::string_view word : of_name)
      words.erase(word);
    if(words.size() < before && !name.empty())
      result.push_back(name);
  }
  if(of_vertices.are_others)
    result.push_back("further numbers of vertices");
  if(of_textures.are_others)
    result.push_back("third texture coordinates");
  if(has_smoothing)
    result.push_back("smoothing groups");
  if(!words.empty())
    result.push_back("other statements");
  if(has_comments(bytes))
    result.push_back(COMMENTS);
  return result;
}

} // namespace Canonical_pose_tool
