// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_CGAL_TYPES_H
#define CGAL_CANONICAL_POSE_3_TOOL_CGAL_TYPES_H

#include "Mesh_file.h"

#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_complex_traits_3.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/extract_boundary.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

// Conversions between file contents and CGAL's types; vertices, faces and cells keep their order.

namespace Canonical_pose_tool {

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point_3>;
using Tetrahedra = CGAL::Canonical_pose_3::Indexed_tetrahedra_3<Point_3>;
using Point_matrix = CGAL::Canonical_pose_3::Point_matrix;

inline std::vector<Point_3> points_of(const Mesh_file& file)
{
  std::vector<Point_3> points;
  points.reserve(file.points.size());
  for(const std::array<double, 3>& p : file.points)
    points.emplace_back(p[0], p[1], p[2]);
  return points;
}

inline Point_matrix matrix_of(const std::vector<Point_3>& points)
{
  Point_matrix matrix(static_cast<Eigen::Index>(points.size()), 3);
  for(std::size_t i = 0; i < points.size(); ++i)
    matrix.row(static_cast<Eigen::Index>(i)) << points[i].x(), points[i].y(), points[i].z();
  return matrix;
}

inline Mesh_file with_points(Mesh_file file, const Point_matrix& points)
{
  std::vector<std::array<double, 3>> before;
  if(!file.appearance.normals.empty())
    before = file.points;
  for(std::size_t v = 0; v < file.points.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k)
      file.points[v][k] = points(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k));
  turn_normals(file, before);
  return file;
}

inline Tetrahedra tetrahedra_of(const Mesh_file& file) { return {points_of(file), file.cells}; }

// The boundary of a tetrahedral mesh as a surface, and the index of each of its vertices in the mesh.
inline Mesh_file boundary_of(const Mesh_file& file, std::vector<std::size_t>& origins_of_vertices)
{
  Surface surface;
  auto origins = surface.add_property_map<Surface::Vertex_index, std::size_t>("v:origin").first;
  CGAL::Canonical_pose_3::extract_boundary(tetrahedra_of(file), surface, origins);
  Mesh_file boundary;
  origins_of_vertices.clear();
  for(const Surface::Vertex_index v : surface.vertices())
  {
    boundary.points.push_back(file.points[origins[v]]);
    origins_of_vertices.push_back(origins[v]);
  }
  for(const Surface::Face_index f : surface.faces())
  {
    const auto corners = CGAL::vertices_around_face(surface.halfedge(f), surface);
    boundary.faces.push_back(corners);
  }
  return boundary;
}

inline Mesh_file boundary_of(const Mesh_file& file)
{
  std::vector<std::size_t> origins;
  return boundary_of(file, origins);
}

inline CGAL::Canonical_pose_3::Diagnosis_3 diagnosis_of(const Mesh_file& file)
{
  const Point_matrix points = matrix_of(points_of(file));
  return file.is_tetrahedral ? CGAL::Canonical_pose_3::diagnose(points, file.cells)
                             : CGAL::Canonical_pose_3::diagnose(points, file.faces);
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_CGAL_TYPES_H
