// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_TOOL_MESH_FILE_H
#define CGAL_CANONICAL_POSE_3_TOOL_MESH_FILE_H

#include <array>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// What a file holds: a surface or, if is_tetrahedral, a tetrahedral mesh. All numbers count from 0.
struct Mesh_file
{
  bool is_tetrahedral = false;
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> faces;              // of a surface, polygons
  std::vector<std::array<std::size_t, 4>> cells;            // of a tetrahedral mesh
  std::vector<long long> point_references, cell_references; // MEDIT's labels
};

enum class Format { OFF, OBJ, PLY, STL, MEDIT };

// Tells the format by the extension; throws std::invalid_argument if it is none of ours.
Format format_of(const std::string& path);

// Reads a file. Coordinates are finite and indices in range afterwards; nothing else is checked.
// Throws std::invalid_argument that names the defect and the element, which is why CGAL's readers
// are
// not used: they only say that they failed.
Mesh_file read_mesh_file(const std::string& path);

// Reads a text of numbers with blanks or ends of lines between them; '#' begins a comment. Throws
// std::invalid_argument that names the file, too.
std::vector<double> read_numbers(const std::string& path);

// Throws std::invalid_argument if files of the format cannot hold the mesh.
void check_format_holds(Format format, const Mesh_file& mesh);

// Writes a mesh with 17 significant digits.
void write_mesh(std::ostream& out, Format format, const Mesh_file& mesh);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_MESH_FILE_H
