// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Vertex_rotations.h"
#include "readers.h"
#include "rewriters.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cctype>
#include <cstddef>
#include <cstring>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

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

void rewrite_binary_stl(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
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

// Of a text with solids.
std::vector<std::string> attributes_of_stl_text(const std::string& bytes)
{
  Text_cursor text(bytes);
  std::size_t solids = 0;
  bool has_names = false;
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
    if(word.size() == 5 && std::tolower(static_cast<unsigned char>(word[0])) == 's')
    {
      ++solids;
      has_names = !text.word_on_line().empty() || has_names;
    }
  std::vector<std::string> result;
  if(solids > 1)
    result.push_back("solids");
  if(has_names)
    result.push_back("names of solids");
  if(has_comments(bytes))
    result.push_back(COMMENTS);
  return result;
}

} // namespace

void rewrite_stl(std::ostream& out, const std::string& bytes, const Mesh_file& mesh,
                 const Points& points)
{
  is_binary_stl_content(bytes) ? rewrite_binary_stl(out, bytes, mesh, points)
                               : rewrite_stl_text(out, bytes, mesh, points);
}

std::vector<std::string> attributes_of_stl(const Mesh_file& mesh)
{
  const std::string& bytes = mesh.source->bytes;
  if(!is_binary_stl_content(bytes))
    return attributes_of_stl_text(bytes);
  std::vector<std::string> result;
  const std::string_view header = std::string_view(bytes).substr(0, STL_HEADER_SIZE - 4);
  if(header.find("COLOR=") != std::string_view::npos
     || header.find("MATERIAL=") != std::string_view::npos)
    result.push_back("colors");
  else if(header.find_first_not_of(std::string_view(" \t\r\n\0", 5)) != std::string_view::npos)
    result.push_back("the header");
  const std::size_t last_bytes = STL_HEADER_SIZE + STL_FACE_SIZE - 2; // of a face
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    if(bytes.compare(last_bytes + STL_FACE_SIZE * f, 2, std::string(2, '\0')) != 0)
    {
      result.push_back("attributes of faces");
      break;
    }
  if(has_rest_of_stl(bytes))
    result.push_back("what follows the last face");
  return result;
}

} // namespace Canonical_pose_tool
