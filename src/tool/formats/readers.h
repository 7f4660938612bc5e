// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_READERS_H
#define CGAL_CANONICAL_POSE_3_TOOL_READERS_H

#include "Mesh_file.h"
#include "Text_cursor.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

// The first words of an OFF file.
struct Off_header
{
  // Advances to the first vertex. Throws std::invalid_argument.
  explicit Off_header(Text_cursor& text);

  // Goes to the end of a row.
  void end_row(Text_cursor& text) const
  {
    if(!is_on_one_line)
      text.skip_line();
  }

  std::string_view letters; // which state what follows the coordinates of a vertex
  std::size_t vertices, faces;
  bool
    is_on_one_line; // vertices begin on the line of the numbers: rows do not end with their lines
};

// Each reads one format from the bytes of a file into an empty mesh.
void read_off(const std::string& bytes, Mesh_file& mesh);
void read_obj(const std::string& bytes, Mesh_file& mesh);
void read_ply(const std::string& bytes, Mesh_file& mesh);
void read_stl(const std::string& bytes, Mesh_file& mesh);
// Bytes of a binary file.
constexpr std::size_t STL_HEADER_SIZE = 84, STL_FACE_SIZE = 50;
// Whether a file has the size that its header announces, or less than a face more; whether a whole file has as many faces
// as its header announces, whatever follows, or even a rest of the size of a face; and whether it is read as binary.
bool is_binary_stl(const std::string& beginning, std::uintmax_t size);
bool is_binary_stl(const std::string& bytes);
bool has_rest_of_stl(const std::string& bytes);
bool is_binary_stl_content(const std::string& bytes);
void read_medit(const std::string& bytes, Mesh_file& mesh);
// `path` is that of the file.
void read_gltf(const std::string& bytes, const std::string& path, Mesh_file& mesh);

// The same file, binary, with external buffers and the images beside it in one buffer; none if it is such a file already.
// Throws std::invalid_argument.
std::optional<std::string> self_contained_glb(const std::string& bytes, const std::string& path);

// A URI with the characters for which "%20" and the like stand.
inline std::string decoded_uri(const std::string& uri)
{
  std::string result;
  for(std::size_t i = 0; i < uri.size(); ++i)
  {
    unsigned int code = 0;
    const char* const digits = uri.c_str() + i + 1;
    if(uri[i] == '%' && i + 2 < uri.size()
       && std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2)
    {
      result += static_cast<char>(code);
      i += 2;
    }
    else
      result += uri[i];
  }
  return result;
}

// The part of rewrite_mesh() for binary glTF with one buffer, in the file. A mesh that several nodes show becomes several.
// Morph targets, skins and animations, which belong to other positions, are left out.
bool is_rewritable_glb(const Mesh_file& mesh);
void rewrite_glb(std::ostream& out, const Mesh_file& mesh,
                 const std::vector<std::array<double, 3>>& points);

// The names of the files that glTF names.
std::vector<std::string> files_of_gltf(const std::string& bytes);

// What binary or text glTF holds beside positions and faces.
std::vector<std::string> attributes_of_gltf(const Mesh_file& mesh);

// The part of load_appearance() for glTF.
void load_appearance_of_gltf(Mesh_file& mesh);

// Whether this program was built with glTF.
bool is_gltf_available();

// What names no vertex in any mesh.
inline constexpr std::size_t NO_VERTEX = (std::numeric_limits<Face_list::Index>::max)();

// Converts `index`, one of `n` vertices counted from `base`, to a count from 0. If there is no such vertex, throws, or
// returns it, or NO_VERTEX, if `mesh` is not checked.
std::size_t vertex_index(const Mesh_file& mesh, long long index, std::size_t n,
                         const Element& element, int base = 0);

// Appends faces with these corners, vertices counted from `base`. `ends`: of the faces, among the corners. Throws as
// vertex_index().
void add_faces(const std::vector<long long>& corners, const std::vector<std::size_t>& ends,
               int base, Mesh_file& mesh);

// Throws if a coordinate is not finite, and `mesh` is checked.
void check_is_finite(const Mesh_file& mesh, const std::array<double, 3>& point,
                     const Element& element);

// Throws if a face has fewer than three corners.
void check_is_polygon(long long number_of_corners, const Element& face);

// Whether a word of an OBJ file begins a face; `fo` is the old spelling.
inline bool is_face_of_obj(const std::string_view word) { return word == "f" || word == "fo"; }

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_READERS_H
