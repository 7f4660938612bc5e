// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_SHOWN_SURFACE_H
#define CGAL_CANONICAL_POSE_3_TOOL_SHOWN_SURFACE_H

#include "Mesh_file.h"
#include "colors.h"

#include <CGAL/Canonical_pose_3/Skeleton_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// A finite value per vertex, for instance "distance".
struct Vertex_values
{
  std::string name;
  Eigen::VectorXd values;
};

// Another position of the vertices.
struct Other_shape
{
  std::string name;
  CGAL::Canonical_pose_3::Point_matrix points;
};

// What the vertex colors show.
struct Legend
{
  std::string name;
  double minimum, maximum;
};

// A number that is shown beside a surface.
struct Figure
{
  std::string name;
  double value;
};

// A surface with all that a file can show of it. What is empty is not shown.
struct Shown_surface
{
  Mesh_file mesh;
  std::vector<std::size_t> origins; // the vertices of INPUT, if the file should state them
  std::vector<Vertex_values> values;
  std::vector<Color> vertex_colors;
  std::optional<Legend> legend;
  std::vector<std::size_t> part_of_face;
  std::vector<Figure> figures;
  std::string stance;                    // of the last one of the other shapes
  std::vector<Other_shape> other_shapes; // the last one is that to which an animation leads
  std::optional<CGAL::Canonical_pose_3::Skeleton_3>
    skeleton; // of that shape; weights are those of `origins`
};

// Writes the file of a mesh with other positions. Normals turn with their faces; colors, texture coordinates, materials,
// groups, comments, encoding, and what else there is, stay. Values of vertices are properties of PLY: they replace those
// of the same name. Files that it names are copied, if it can have files beside it.
void rewrite_mesh(std::ostream& out, const Mesh_file& mesh,
                  const std::vector<std::array<double, 3>>& points,
                  const std::vector<Vertex_values>& values, Companion_files* beside = nullptr);

// Writes a surface as PLY, with its values, colors and parts as properties. Its textures are files beside it, if it can
// have such, and nothing else is shown.
void write_ply(std::ostream& out, const Shown_surface& surface, Companion_files* beside = nullptr);

// Writes a surface as glTF 2.0 (binary). Throws std::invalid_argument if it cannot be represented.
void write_glb(std::ostream& out, const Shown_surface& surface);

// Writes a tetrahedral mesh with values of its vertices for ParaView (VTK, UnstructuredGrid, XML).
void write_vtu(std::ostream& out, const Mesh_file& mesh, const std::vector<Vertex_values>& values);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_SHOWN_SURFACE_H
