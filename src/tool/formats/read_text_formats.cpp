// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "readers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// "OFF", possibly after letters.
void check_keyword(const std::string_view keyword)
{
  if(keyword.size() < 3 || keyword.substr(keyword.size() - 3) != "OFF")
    throw std::invalid_argument("line 1: there is no keyword OFF");
  for(const char c : keyword.substr(0, keyword.size() - 3))
    if(std::string_view("STCN").find(c) == std::string_view::npos)
      throw std::invalid_argument("line 1: the variant " + Text_cursor::shown(keyword)
                                  + " is not supported");
}

// What corners of faces name beside vertices. It may follow them.
struct Named_values
{
  const char* name;
  std::size_t number = 0;           // of those so far
  unsigned long long last = 0;      // that is named, counted from 0
  std::string face = {}, line = {}; // which name it

  void add(const long long index, const Element& f, const Text_cursor& text)
  {
    const auto on = [&] { return " (line " + std::to_string(text.line()) + ')'; };
    if(index < -static_cast<long long>(number))
      throw std::invalid_argument(f.name() + " names " + name + ' ' + std::to_string(index)
                                  + ", but there are " + std::to_string(number) + " before it"
                                  + on());
    if(index < 0 || (index > 0 && static_cast<unsigned long long>(index) <= number))
      return;
    const auto from_0 = static_cast<unsigned long long>(index) - 1; // 0 becomes the largest
    if(face.empty() || from_0 > last)
    {
      last = from_0;
      face = f.name();
      line = on();
    }
  }
  void check() const
  {
    if(!face.empty() && last >= number)
      throw std::invalid_argument(face + " names " + name + ' ' + std::to_string(last + 1)
                                  + " (counted from 1), but there are " + std::to_string(number)
                                  + line);
  }
};

// Texture coordinates and normals of a corner of a face.
void read_rest_of_corner(const Text_cursor& text, std::string_view word, const Element& face,
                         std::array<Named_values, 2>& values)
{
  for(std::size_t number = 0; !word.empty(); ++number)
  {
    word.remove_prefix(1);
    if(number == values.size())
      throw std::invalid_argument(face.name() + ": a corner has more than three indices (line "
                                  + std::to_string(text.line()) + ")");
    const std::string_view index = word.substr(0, word.find('/'));
    if(!index.empty())
      values[number].add(text.integer(index, face), face, text);
    word.remove_prefix(index.size());
  }
}

// Other letters may be blanks of other kinds, and what follows them part of the line.
void check_keyword_of_obj(const Text_cursor& text, const std::string_view word)
{
  const auto odd
    = std::find_if(word.begin(), word.end(), [](const char c) { return c < ' ' || c > '~'; });
  if(odd != word.end())
    throw std::invalid_argument("the keyword " + Text_cursor::shown(word) + " has a "
                                + (std::iscntrl(static_cast<unsigned char>(*odd))
                                     ? "control character"
                                     : "letter that is not ASCII")
                                + " (line " + std::to_string(text.line()) + ")");
}

} // namespace

Off_header::Off_header(Text_cursor& text)
{
  std::string_view word = text.word();
  if(word.substr(0, 3) == "OFF" && word.size() > 3) // without a space, as in files of ModelNet
    word = word.substr(3);
  else
  {
    check_keyword(word);
    letters = word.substr(0, word.size() - 3);
    word = text.word();
  }
  if(word == "BINARY")
    throw std::invalid_argument("line 1: binary OFF is not supported");
  vertices = text.count(word, Element{"the number of vertices"});
  faces = text.count(text.word_on_line(), Element{"the number of faces"});
  if(const std::string_view edges = text.word_on_line(); !edges.empty())
    text.count(edges, Element{"the number of edges"});
  is_on_one_line = !Text_cursor(text).word_on_line().empty();
  if(is_on_one_line && !letters.empty())
    throw std::invalid_argument("line 1: the variant "
                                + Text_cursor::shown(std::string(letters) + "OFF")
                                + " is not read on one line");
  end_row(text);
}

void read_off(const std::string& bytes, Mesh_file& mesh)
{
  Text_cursor text(bytes);
  const Off_header header(text);
  const std::size_t vertices = header.vertices, faces = header.faces;
  mesh.points.reserve((std::min)(vertices, bytes.size() / 6)); // the numbers may be wrong
  mesh.faces.reserve((std::min)(faces, bytes.size() / 6));

  for(Element v{"vertex", 0}; v.index < vertices; ++v.index)
  {
    const double x = text.number(text.word(), v);
    const double y = text.number(text.word_on_line(), v);
    const double z = text.number(text.word_on_line(), v);
    mesh.points.push_back({x, y, z});
    check_is_finite(mesh, mesh.points.back(), v);
    header.end_row(text);
  }
  std::vector<std::size_t> face;
  for(Element f{"face", 0}; f.index < faces; ++f.index)
  {
    const long long corners = text.integer(text.word(), f);
    check_is_polygon(corners, f);
    face.clear();
    for(long long k = 0; k < corners; ++k)
      face.push_back(vertex_index(mesh, text.integer(text.word(), f), mesh.points.size(), f));
    mesh.faces.push_back(face);
    header.end_row(text);
  }
  text.check_is_at_end(faces > 0      ? Element{"face", faces - 1}
                       : vertices > 0 ? Element{"vertex", vertices - 1}
                                      : Element{"the number of faces"});
}

void read_obj(const std::string& bytes, Mesh_file& mesh)
{
  Text_cursor text(bytes, Text_cursor::Lines::CONTINUED);
  std::vector<long long> corners; // of all faces, which may precede their vertices
  std::vector<std::size_t> ends;  // of the faces, among the corners
  std::array<Named_values, 2> values = {{{"texture coordinate"}, {"normal"}}};
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
    if(word == "v")
    {
      const Element v{"vertex", mesh.points.size()};
      std::array<double, 3> point;
      for(double& x : point)
        x = text.number(text.word_on_line(), v);
      check_is_finite(mesh, point, v);
      mesh.points.push_back(point);
    }
    else if(is_face_of_obj(word))
    {
      const Element f{"face", ends.size()};
      for(word = text.word_on_line(); !word.empty(); word = text.word_on_line())
      {
        const std::string_view vertex = word.substr(0, word.find('/'));
        const long long index = text.integer(vertex, f);
        read_rest_of_corner(text, word.substr(vertex.size()), f, values);
        const long long n = static_cast<long long>(mesh.points.size());
        if(index < -n && mesh.is_checked)
          throw std::invalid_argument(f.name() + " names vertex " + std::to_string(index)
                                      + ", but there are " + std::to_string(n) + " before it");
        corners.push_back(index < 0 ? (std::max)(n + 1 + index, 0LL) : index);
      }
      check_is_polygon(static_cast<long long>(corners.size() - (ends.empty() ? 0 : ends.back())),
                       f);
      ends.push_back(corners.size());
    }
    else if(word == "vt" || word == "vn")
      ++values[word == "vt" ? 0 : 1].number;
    else
      check_keyword_of_obj(text, word);
  for(const Named_values& of_corners : values)
    of_corners.check();
  add_faces(corners, ends, 1, mesh);
}

} // namespace Canonical_pose_tool
