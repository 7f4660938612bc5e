// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_EXTRACT_BOUNDARY_H
#define CGAL_CANONICAL_POSE_3_EXTRACT_BOUNDARY_H

#include <CGAL/Canonical_pose_3/internal/body/Indexed_complex.h>
#include <CGAL/Canonical_pose_3/internal/body/boundary_triangles.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief extracts the boundary of a tetrahedral complex as a surface, and maps its vertices to those
of the complex.

The boundary consists of the faces of exactly one cell, oriented outward. Where it is not a
2-manifold (because cells share only a vertex or an edge), vertices are duplicated, so several
vertices of the surface may correspond to the same vertex of the complex.

\tparam Complex a type for which `Tetrahedral_complex_traits_3` is specialized
\tparam TriangleMesh a model of `MutableFaceGraph` whose points are of the kernel of the complex
\tparam OriginMap a model of `WritablePropertyMap` with the vertex descriptor of `TriangleMesh` as
       key type and that of the complex as value type

\param complex the complex.
\param tmesh receives the boundary.
\param origin_map receives the vertex of the complex of each vertex of `tmesh`.

\pre `tmesh` is empty.

\throws std::invalid_argument if a face belongs to more than two cells, or a cell has a vertex that
       is not in the complex or a repeated vertex; the message states the index of the cell.

<em>Complexity:</em> \f$ O(m \log m) \f$ for \f$ m \f$ cells.
*/
template <class Complex, class TriangleMesh, class OriginMap>
void extract_boundary(const Complex& complex, TriangleMesh& tmesh, OriginMap origin_map)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Kernel = typename Kernel_traits<internal::Complex_point<Complex>>::Kernel;

  CGAL_precondition(is_empty(tmesh));
  const auto indexed = internal::indexed_complex(complex, Kernel());
  std::vector<internal::Index_triangle> triangles
    = internal::boundary_triangles(indexed.points, indexed.cells);
  std::vector<std::size_t> origins;
  internal::make_boundary_manifold(triangles, origins);

  std::vector<vertex_descriptor> vertex_of_row;
  auto point_map = get(vertex_point, tmesh);
  for(const std::size_t origin : origins)
  {
    const vertex_descriptor v = add_vertex(tmesh);
    put(point_map, v,
        Tetrahedral_complex_traits_3<Complex>::point(complex, indexed.vertices[origin]));
    put(origin_map, v, indexed.vertices[origin]);
    vertex_of_row.push_back(v);
  }
  for(const internal::Index_triangle& t : triangles)
    Euler::add_face(std::array<vertex_descriptor, 3>{vertex_of_row[t[0]], vertex_of_row[t[1]],
                                                     vertex_of_row[t[2]]},
                    tmesh);
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_EXTRACT_BOUNDARY_H
