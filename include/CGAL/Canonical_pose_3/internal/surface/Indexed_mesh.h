// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_INDEXED_MESH_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_INDEXED_MESH_H

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The mesh type for all internal computations, independent of the user's: vertex i is row i.
using Indexed_mesh_kernel = Exact_predicates_inexact_constructions_kernel;
using Indexed_mesh = Surface_mesh<Indexed_mesh_kernel::Point_3>;

// Throws std::invalid_argument if the triangles are not an oriented 2-manifold.
inline Indexed_mesh indexed_mesh(const Point_matrix& points,
                                 const std::vector<Index_triangle>& triangles)
{
  using Vertex = Indexed_mesh::Vertex_index;
  Indexed_mesh mesh;
  mesh.reserve(Indexed_mesh::size_type(points.rows()),
               Indexed_mesh::size_type(3 * triangles.size() / 2 + 1),
               Indexed_mesh::size_type(triangles.size()));
  for(Eigen::Index i = 0; i < points.rows(); ++i)
    mesh.add_vertex(Indexed_mesh::Point(points(i, 0), points(i, 1), points(i, 2)));
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    const Index_triangle& t = triangles[f];
    if(mesh.add_face(Vertex(Indexed_mesh::size_type(t[0])), Vertex(Indexed_mesh::size_type(t[1])),
                     Vertex(Indexed_mesh::size_type(t[2])))
       == Indexed_mesh::null_face())
      throw std::invalid_argument(
        "face " + std::to_string(f)
        + " does not fit the others: the surface is not an oriented 2-manifold there");
  }
  return mesh;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_INDEXED_MESH_H
